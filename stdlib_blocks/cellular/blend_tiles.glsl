// SPDX-License-Identifier: Apache-2.0
float both(float a, float b, float share) { return mix(a, b, share); }
vec2 both(vec2 a, vec2 b, float share) { return mix(a, b, share); }
vec3 both(vec3 a, vec3 b, float share) { return mix(a, b, share); }
vec4 both(vec4 a, vec4 b, float share) {
  vec4 light = mix(vec4(a.rgb * a.a, a.a), vec4(b.rgb * b.a, b.a), share);
  return vec4(light.rgb / max(light.a, 1e-20), light.a);
}

/// Draws something else in every tile, without jagged borders: where a pixel sees two tiles, it
/// shows the share of each.
/// For cells of one colour above all: what a graph makes of the tile is computed for the tile
/// itself and, in the pixels at a border alone, for its neighbour. Where three cells meet, the
/// third is left out. Colours are weighed by their alpha.
/// @source box filter over the pixel
/// @param image what a tile shows: a function that takes the tile
/// @param tile the tile, as `voronoi` gives it
/// @param neighbor the tile on the other side of the nearest border
/// @param share how much of the pixel the neighbour has @range 0 1
genType image(Tile tile);

genType blend_tiles(Tile tile, Tile neighbor, float share) {
  genType here = image(tile);
  if (share > 0.0) {
    here = both(here, image(neighbor), share);
  }
  return here;
}
