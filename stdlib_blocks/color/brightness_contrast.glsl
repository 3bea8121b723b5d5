// SPDX-License-Identifier: Apache-2.0
/// Stretches values away from a pivot, or draws them towards it, and raises all of them.
/// (value - pivot) * contrast + pivot + brightness. It is linear, so what is filtered stays so.
/// @source MaterialX 1.39, Standard Nodes, contrast; Material Maker, "Brightness and contrast"
/// @param value the value
/// @param contrast the factor of the distance from the pivot; 0 leaves the pivot @default 1
/// @param brightness what is added @default 0
/// @param pivot the value that contrast leaves as it is; 0.214 is the light of the middle of sRGB
///   @default 0.5
float brightness_contrast(float value, float contrast, float brightness, float pivot) {
  return (value - pivot) * contrast + (pivot + brightness);
}

/// @param color linear light
/// @param contrast the factor of the distance from the pivot; 0 leaves the pivot @default 1
/// @param brightness what is added @default 0
/// @param pivot the value that contrast leaves as it is @default 0.5
vec3 brightness_contrast(vec3 color, float contrast, float brightness, float pivot) {
  return (color - pivot) * contrast + (pivot + brightness);
}

/// @param color linear light; alpha, straight, stays
/// @param contrast the factor of the distance from the pivot; 0 leaves the pivot @default 1
/// @param brightness what is added @default 0
/// @param pivot the value that contrast leaves as it is @default 0.5
vec4 brightness_contrast(vec4 color, float contrast, float brightness, float pivot) {
  return vec4((color.rgb - pivot) * contrast + (pivot + brightness), color.a);
}
