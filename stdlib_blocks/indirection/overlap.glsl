// SPDX-License-Identifier: Apache-2.0
/// Draws what reaches out of its tile whole: the four tiles around the corner that is nearest to
/// the point, one upon the other.
/// The colour is that of `tile_transform` with the place `anywhere` and what is drawn there, with
/// the coverage in its alpha. A pattern may reach over the border of its tile by half a tile: its
/// middle is in the tile, and it is at most as large as the tile. Tiles lie on each other in the
/// order of their rows from below, and in a row from left to right, each over those before it.
/// The paper draws the grid four times.
/// @source Lefebvre and Neyret, Pattern Based Procedural Textures, 2003, section 3.2, Tile
///   Transform, and figure 5
/// @param color what a tile shows at this point, straight alpha
/// @param tile the tile that the point is in
/// @return straight alpha
vec4 color(ivec2 neighbour);

vec4 overlap(Tile tile) {
  ivec2 first = ivec2(floor(tile.local - 0.5));
  // Where a pixel holds whole tiles their patterns lie beside each other, not on each other.
  vec2 tiles = footprint(tile.local);
  float on = clamp(2.0 - 2.0 * max(tiles.x, tiles.y), 0.0, 1.0);
  vec4 sum = vec4(0.0);
  for (int y = 1; y >= 0; --y) {
    for (int x = 1; x >= 0; --x) {
      vec4 other = color(first + ivec2(x, y));
      float below = other.a * (1.0 - sum.a * on);
      sum += vec4(other.rgb * below, below);
    }
  }
  return vec4(sum.rgb / max(sum.a, 1e-20), min(sum.a, 1.0));
}
