// SPDX-License-Identifier: Apache-2.0
/// Two random numbers, at least 0 and below 1, for a seed.
/// The lower and the upper 16 bits of one `hash`, in steps of 1/65536.
/// @param seed random bits, those of a tile for example
/// @param stream which of the pairs that belong to the seed; below 0 are those that blocks draw for
///   themselves @default 0
vec2 random2(uint seed, int stream) {
  uint bits = hash(seed + uint(stream));
  return vec2(bits & 65535u, bits >> 16u) * 0.0000152587890625;
}
