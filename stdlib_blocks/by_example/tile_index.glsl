// SPDX-License-Identifier: Apache-2.0
/// Where a pair of colours is in a tour that has each ordered pair once and in which each pair
/// begins with the colour that the one before ends with: 00, 01, 11, 10, 02, 21, 12, 22, 20, 03 and
/// so on. Packs of tiles are laid out by it.
/// @source Wei, Tile-Based Texture Mapping on Graphics Hardware, 2004, equation 6
/// @param first the first colour, from 0 @range 0 1023
/// @param second the second one @range 0 1023
/// @return the place, from 0
int tile_index(int first, int second) {
  int low = second > 0 ? first * first + 2 * second - 1 : first * (first + 2);
  return second > first ? 2 * first + second * second : low;
}
