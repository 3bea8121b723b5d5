// SPDX-License-Identifier: Apache-2.0
/// A material from its channels, so that one wire carries all of them.
/// What no output of the graph needs leaves no trace in the shader.
/// @param color linear light, straight alpha @default vec4(0.5, 0.5, 0.5, 1.0)
/// @param normal of length 1, as `normal_map` gives it; of an element that a layer draws it is the
///   normal in the element's own frame @default vec3(0.0, 0.0, 1.0)
/// @param height over the surface's own level @default 0
/// @param roughness 0 is a mirror, 1 is matt @default 0.6 @range 0 1
/// @param metallic 1 for metal, 0 for what is none @default 0 @range 0 1
/// @param opacity what the alpha of `color` is multiplied by @default 1 @range 0 1
Material material(vec4 color, vec3 normal, float height, float roughness, float metallic,
                  float opacity) {
  return Material(vec4(color.rgb, color.a * opacity), normal, height, roughness, metallic);
}
