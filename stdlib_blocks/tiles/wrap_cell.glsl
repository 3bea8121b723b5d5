// SPDX-License-Identifier: Apache-2.0
/// The cell that stands in place of another when a grid repeats after `count` cells: what a
/// division leaves over, from 0 up
/// to but not including `count`, also below zero. All in integers, since mod() of floats is wrong
/// at some exact multiples on a GPU, and % of a negative number is undefined.
/// @param cell column and row, or one of them
/// @param count after how many cells the grid repeats, at least 1
int wrap_cell(int cell, int count) {
  int flip = cell >> 31;
  return (((cell ^ flip) % count) ^ flip) + (flip & count);
}
ivec2 wrap_cell(ivec2 cell, ivec2 count) {
  ivec2 flip = cell >> 31;
  return (((cell ^ flip) % count) ^ flip) + (flip & count);
}
ivec3 wrap_cell(ivec3 cell, ivec3 count) {
  ivec3 flip = cell >> 31;
  return (((cell ^ flip) % count) ^ flip) + (flip & count);
}
