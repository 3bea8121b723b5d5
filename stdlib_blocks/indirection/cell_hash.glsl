// SPDX-License-Identifier: Apache-2.0
/// Random bits for a cell of a line: those of `hash`, nested.
/// @source Jarzynski and Olano, Hash Functions for GPU Rendering, JCGT 9(3), 2020, sections 4.1 to
///   4.3; in place of the permutation tables of Lefebvre and Neyret, Pattern Based Procedural
///   Textures, 2003, section 3.2
/// @param cell which cell
/// @param seed another seed gives other bits for all cells @default 0
uint cell_hash(int cell, int seed) { return hash(uint(cell) + hash(uint(seed))); }

/// Of a cell of a grid they are y of pcg2d, without the last shift, which mends only the lower
/// bits: take the upper 16, or `hash` them once more. What is added in x and y follows from the
/// seed; where that is known it costs nothing.
/// @param cell column and row
/// @param seed another seed gives other bits for all cells @default 0
/// @return 32 random bits; the upper 16 are good
uint cell_hash(ivec2 cell, int seed) {
  const uint A = 1664525u;
  uint first = hash(uint(seed));
  uvec2 c = uvec2(cell);
  // v = A c + seed, x += A y, y += A x: each a linear step, and here all of them at once.
  uvec2 v = c.x * uvec2(A, A * A) + c.y * uvec2(A * A, A + A * A * A) + uvec2(first, hash(first));
  v ^= v >> 16u;
  // x += A y, y += A x; and of that y.
  v *= uvec2(A, 1u + A * A);
  return v.x + v.y;
}

/// Of a cell in space they are z of pcg3d, without the last shift.
/// @param cell column, row and slice
/// @param seed another seed gives other bits for all cells @default 0
uint cell_hash(ivec3 cell, int seed) {
  uint first = hash(uint(seed));
  uint second = hash(first);
  uvec3 v = uvec3(cell) * 1664525u + uvec3(first, second, hash(second));
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  return v.z;
}
