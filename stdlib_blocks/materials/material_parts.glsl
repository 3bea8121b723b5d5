// SPDX-License-Identifier: Apache-2.0
/// What a material consists of, for the outputs of a graph.
/// @param surface the material
/// @param color linear light, straight alpha
/// @param normal of length 1, in texture space
/// @param height over the surface's own level
/// @param roughness from 0 to 1
/// @param metallic from 0 to 1
/// @param opacity the alpha of `color`
void material_parts(Material surface, out vec4 color, out vec3 normal, out float height,
                    out float roughness, out float metallic, out float opacity) {
  color = surface.color;
  normal = surface.normal;
  height = surface.height;
  roughness = surface.roughness;
  metallic = surface.metallic;
  opacity = surface.color.a;
}
