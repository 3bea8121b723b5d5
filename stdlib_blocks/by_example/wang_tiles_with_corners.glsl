// SPDX-License-Identifier: Apache-2.0
/// The tiles of `wang_tiles`, filtered better around corners: where the pack of tiles has other
/// neighbours than the tiling, it passes into a second pack that has all corners. That takes as
/// much memory again and a second look-up. `corner_tiles` are right at corners with one pack and
/// one look-up.
/// @source Wei, Tile-Based Texture Mapping on Graphics Hardware, 2004, appendix B, with an integer
///   hash in place of its permutations, which repeat
/// @param tiles the pack of tiles
/// @param corners its corners: a texture with the key `corners`
/// @param colors how many colours edges have: those that lie, and those that stand; of a texture
///   with the key `tiles` they are known @colors_of tiles @range 1 4
/// @param uv coordinate @default uv
/// @param tiling how many tiles for each unit of the coordinate @default vec2(8)
/// @param period after how many tiles the plane repeats, across and up; 0 never @default ivec2(0)
///   @range 0 65536
/// @param seed another seed gives another plane @default 0
/// @param reach how far from a corner tiles show something that depends on both edges that meet
///   there, in tiles: the pack of corners counts in full at least so far. Of tiles that are cut from
///   a picture 0 is right @default 0 @range 0 0.25
/// @param color the texture, straight alpha
/// @param tile the tile, for whatever else shall vary with it
/// @param index which tile of the set it is: its column and row in the pack, as column + row *
///   columns
void wang_tiles_with_corners(sampler2D tiles, sampler2D corners, vec2 uv, vec2 tiling,
                             const ivec2 colors, const ivec2 period, int seed, float reach,
                             out vec4 color, out Tile tile, out int index) {
  vec4 edges;
  wang_tiles(tiles, uv, tiling, colors, period, seed, edges, tile, index);
  vec4 around;
  float weight;
  wang_corners(corners, uv, tiling, colors, period, seed, reach, around, weight);
  float alpha = mix(edges.a, around.a, weight);
  vec3 light = mix(edges.rgb * edges.a, around.rgb * around.a, weight);
  color = vec4(light / max(alpha, 1e-20), alpha);
}
