// SPDX-License-Identifier: Apache-2.0
/// Strengthens or weakens a colour's saturation, and keeps its luminance.
/// The colour moves away from the grey of its luminance, or towards it. It is linear, so what is
/// filtered stays so. `hsv_adjust` keeps the greatest component instead.
/// @source MaterialX 1.39, Standard Nodes, saturate; Recommendation ITU-R BT.709-6, item 3.2
/// @param color linear light
/// @param amount 0 is grey, 1 changes nothing; above, components may turn negative @default 1
vec3 saturate(vec3 color, float amount) { return mix(vec3(luminance(color)), color, amount); }

/// @param color linear light; alpha, straight, stays
/// @param amount 0 is grey, 1 changes nothing; above, components may turn negative @default 1
vec4 saturate(vec4 color, float amount) {
  return vec4(mix(vec3(luminance(color)), color.rgb, amount), color.a);
}
