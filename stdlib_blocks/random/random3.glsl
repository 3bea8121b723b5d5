// SPDX-License-Identifier: Apache-2.0
/// Three random numbers, at least 0 and below 1, for a seed.
/// Two hashes: 16 bits each of the first, 24 bits of the second, which is nested in it.
/// @param seed random bits, those of a tile for example
/// @param stream which of the triples that belong to the seed; below 0 are those that blocks draw
///   for themselves @default 0
vec3 random3(uint seed, int stream) {
  uint bits = hash(seed + uint(stream));
  return vec3(vec2(bits & 65535u, bits >> 16u) * 0.0000152587890625, random(bits, 0));
}
