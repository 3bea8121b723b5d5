// SPDX-License-Identifier: Apache-2.0
/// The normal that a texel of a normal map means, of length 1: 2 texel - 1, normalised.
/// The texture must be declared `data`. Mip levels hold the mean of normals: from far away the
/// relief goes to its mean slope.
/// @source glTF 2.0, section 3.9.3, normal textures
/// @param texel red, green and blue of the map
/// @param strength how many times as steep the slopes are; 0 is flat @default 1
/// @param y_down whether green grows where the surface looks down, as in maps made for Direct3D
///   @default false
vec3 normal_map(vec3 texel, float strength, const bool y_down) {
  vec3 n = texel * 2.0 - 1.0;
  vec2 slope = strength * (y_down ? vec2(n.x, -n.y) : n.xy);
  vec3 steep = vec3(slope, n.z);
  return steep * inversesqrt(max(dot(steep, steep), 1e-20));
}

vec3 normal_map(vec4 texel, float strength, const bool y_down) {
  return normal_map(texel.rgb, strength, y_down);
}
