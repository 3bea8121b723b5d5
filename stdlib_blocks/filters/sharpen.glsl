// SPDX-License-Identifier: Apache-2.0
float added(float here, float blurred, float amount) { return here + amount * (here - blurred); }
vec2 added(vec2 here, vec2 blurred, float amount) { return here + amount * (here - blurred); }
vec3 added(vec3 here, vec3 blurred, float amount) { return here + amount * (here - blurred); }
vec4 added(vec4 here, vec4 blurred, float amount) {
  vec4 light = vec4(here.rgb * here.a, here.a);
  light += amount * (light - vec4(blurred.rgb * blurred.a, blurred.a));
  float alpha = clamp(light.a, 0.0, 1.0);
  return vec4(light.rgb / max(light.a, 1e-20) * step(1e-6, alpha), alpha);
}

/// Makes whatever is connected crisper: adds how much it differs from itself, blurred.
/// image + amount (image - blur), an unsharp mask. Results may leave the range of the image; the
/// alpha of colours stays between 0 and 1.
/// @source Substance 3D Designer and Material Maker, "Sharpen"; Gonzalez and Woods, Digital Image
///   Processing, section 3.6, unsharp masking
/// @param image what is sharpened
/// @param uv where to look @default uv
/// @param amount how much of the difference is added; below 0 it blurs @default 1
/// @param radius how far the blur reaches, its standard deviation, across and up, in the units of
///   uv @default vec2(0.01)
genType image(vec2 uv);

genType sharpen(vec2 uv, float amount, vec2 radius) {
  return added(image(uv), blur(uv, radius, 3), amount);
}
