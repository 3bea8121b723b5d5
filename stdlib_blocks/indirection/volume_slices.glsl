// SPDX-License-Identifier: Apache-2.0
/// Looks through a volume that stands on the surface, as the paper's stack of quads does: slices
/// from the top down, each over those below, moved as the direction of view asks.
/// Opacities are those of whole slices: take as many slices as the volume was made of; with fewer
/// it is thinner.
/// @source Meyer and Neyret, Interactive Volumetric Textures, EGWR 1998, section 2; Lefebvre and
///   Neyret, Pattern Based Procedural Textures, 2003, section 4, figure 14 d
/// @param volume colour and opacity at a place: u and v, and the height from 0, the ground, to 1
/// @param uv the place on the ground @default uv
/// @param height how high the volume is, in units of uv @default 0.1
/// @param view how far one looks to the right and up for each unit downwards; (0, 0) is from right
///   above @default vec2(0)
/// @param slices how many there are @default 64 @range 1 512
/// @return straight alpha
vec4 volume(vec3 position);

vec4 volume_slices(vec2 uv, float height, vec2 view, const int slices) {
  vec4 sum = vec4(0.0);
  for (int i = slices - 1; i >= 0; --i) {
    if (sum.a < 0.999) {
      float level = (float(i) + 0.5) / float(slices);
      vec4 slice = volume(vec3(uv - view * (height * level), level));
      float below = slice.a * (1.0 - sum.a);
      sum += vec4(slice.rgb * below, below);
    }
  }
  return vec4(sum.rgb / max(sum.a, 1e-20), sum.a);
}
