// SPDX-License-Identifier: Apache-2.0
/// A random number, at least 0 and below 1, for a seed.
/// The upper 24 bits of `hash`, so that every value is a float exactly.
/// @param seed random bits, those of a tile for example
/// @param stream which of the numbers that belong to the seed; below 0 are those that blocks draw
///   for themselves @default 0
float random(uint seed, int stream) {
  return float(hash(seed + uint(stream)) >> 8u) * 5.9604644775390625e-8;
}
