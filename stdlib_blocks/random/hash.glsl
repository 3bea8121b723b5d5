// SPDX-License-Identifier: Apache-2.0
/// Random bits from an integer: equal for equal inputs, unrelated for different ones, the same on
/// every machine.
/// The permutation is PCG RXS-M-XS of 32 bits. A cell of a grid gets h(column + h(row + h(seed))).
/// @source O'Neill, PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms for
///   Random Number Generation, 2014, section 6.3.4; nesting: Jarzynski and Olano, Hash Functions
///   for GPU Rendering, JCGT 9(3), 2020, section 4.3
/// @param value an integer
/// @return 32 random bits
uint hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

/// @param value two integers
/// @return 32 random bits for each
uvec2 hash(uvec2 value) {
  uvec2 state = value * 747796405u + 2891336453u;
  uvec2 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

/// @param value four integers
/// @return 32 random bits for each
uvec4 hash(uvec4 value) {
  uvec4 state = value * 747796405u + 2891336453u;
  uvec4 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

/// @param cell column and row
/// @param seed another seed gives other bits for all cells @default 0
uint hash(ivec2 cell, uint seed) { return hash(uint(cell.x) + hash(uint(cell.y) + hash(seed))); }
