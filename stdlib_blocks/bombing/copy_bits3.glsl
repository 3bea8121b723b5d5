// SPDX-License-Identifier: Apache-2.0
/// Random bits for each of the copies in a cell of space: five numbers of 32 bits, of which the
/// upper 16 are the best.
/// They are the three words of pcg3d, without its last shift, and two sums of these; of copy 0 the
/// bits are `cell_hash` of the cell. The copy's number goes in as a fourth coordinate. What is
/// added for the seed costs nothing where it is known.
/// @source Jarzynski and Olano, Hash Functions for GPU Rendering, JCGT 9(3), 2020, section 4.3
/// @param cell column, row and slice
/// @param copy which of the cell's copies @default 0
/// @param seed another seed gives other bits for all cells @default 0
/// @param place three numbers for a place
/// @param luck a number that the others do not tell
/// @param bits the copy's own bits
void copy_bits3(ivec3 cell, int copy, int seed, out uvec3 place, out uint luck, out uint bits) {
  uint first = hash(uint(seed));
  uint second = hash(first);
  uvec3 v = uvec3(cell) * 1664525u + uvec3(first, second, hash(second)) +
            uint(copy) * uvec3(2654435769u, 1540483477u, 2246822519u);
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  place = uvec3(v.xy, v.x * 3266489917u + v.y * 668265263u + v.z * 374761393u);
  luck = v.x * 1597334677u + v.y * 3432918353u + v.z * 461845907u;
  bits = v.z;
}
