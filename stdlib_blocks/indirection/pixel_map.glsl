// SPDX-License-Identifier: Apache-2.0
/// Which of two families of materials a point is of, by a mask of any shape: areas with borders as
/// fine as the mask, across tiles.
/// The border is a pixel wide however near it is looked at, and where a pixel holds many texels of
/// the mask the share is their mean; the paper leaves the filtering open. Mix the two families'
/// colours by the share, or take one by the family.
/// @source Lefebvre and Neyret, Pattern Based Procedural Textures, 2003, section 3.3, Pixel Map
/// @param mask 0 where the first family is, 1 where the second one is, in the first channel
/// @param uv coordinate @default uv
/// @param family 0 or 1
/// @param share how much of the pixel is of the second family
void pixel_map(sampler2D mask, vec2 uv, out int family, out float share) {
  vec2 texels = footprint(uv) * vec2(textureSize(mask, 0));
  // Near by the filter makes the border a texel wide; steeper, it is a pixel.
  float steeper = 1.0 / clamp(max(texels.x, texels.y), 1e-5, 1.0);
  share = clamp((texture(mask, uv).r - 0.5) * steeper + 0.5, 0.0, 1.0);
  family = share < 0.5 ? 0 : 1;
}
