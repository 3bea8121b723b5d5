// SPDX-License-Identifier: Apache-2.0
/// Patterns that lie anywhere and on each other, by a map of sprites: decals without geometry.
/// Each layer of the map can show one sprite in a cell; higher layers lie on lower ones. Two
/// look-ups a layer, and none for the layers below where the ones above hide them.
/// @source Lefebvre and Neyret, Pattern Based Procedural Textures, 2003, section 3.2, Explicit
///   Positioning; texture sprites
/// @param sprites the map, as of `explicit_positioning` @below patterns
/// @param patterns the patterns, a layer each
/// @param tile the tile, a cell of the map
/// @param layers how many layers of the map are drawn, the first ones @default 1 @range 1 255
/// @return straight alpha; transparent where no sprite is
vec4 texture_sprites(sampler2DArray sprites, sampler2DArray patterns, Tile tile,
                     const int layers) {
  vec4 sum = vec4(0.0);
  for (int layer = layers - 1; layer >= 0; --layer) {
    if (sum.a < 0.999) {
      int pattern;
      Tile inner;
      float coverage;
      explicit_positioning(sprites, tile, layer, pattern, inner, coverage);
      vec4 color = reference_texture(patterns, inner, pattern);
      float below = color.a * coverage * (1.0 - sum.a);
      sum += vec4(color.rgb * below, below);
    }
  }
  return vec4(sum.rgb / max(sum.a, 1e-20), sum.a);
}
