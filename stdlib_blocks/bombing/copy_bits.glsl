// SPDX-License-Identifier: Apache-2.0
/// Random bits for each of the copies in a cell: four numbers of 32 bits, of which the upper 16 are
/// the best.
/// They are four sums of the two words of pcg2d, before its last step: the last number is y of
/// pcg2d, and of copy 0 it is `cell_hash` of the cell. The copy's number goes in as a third
/// coordinate. What is added for the seed costs nothing where it is known.
/// @source Jarzynski and Olano, Hash Functions for GPU Rendering, JCGT 9(3), 2020, section 4.3
/// @param cell column and row
/// @param copy which of the cell's copies @default 0
/// @param seed another seed gives other bits for all cells @default 0
uvec4 copy_bits(ivec2 cell, int copy, int seed) {
  const uint A = 1664525u;
  uint first = hash(uint(seed));
  uvec2 c = uvec2(cell);
  uvec2 v = c.x * uvec2(A, A * A) + c.y * uvec2(A * A, A + A * A * A) + uvec2(first, hash(first)) +
            uint(copy) * uvec2(2654435769u, 1540483477u);
  v ^= v >> 16u;
  return v.x * uvec4(3266489917u, 668265263u, 374761393u, A) +
         v.y * uvec4(2246822519u, 3432918353u, 461845907u, 1u + A * A);
}
