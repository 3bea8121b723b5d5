// SPDX-License-Identifier: Apache-2.0
// The mean of t^power from low to high, both from 0 to 1.
float power_mean(float low, float high, float power) {
  float width = high - low;
  // For close values the integral would be a difference of nearly equal numbers.
  if (width < 1e-3) {
    return pow(max(0.5 * (low + high), 1e-20), power);
  }
  float integral = pow(max(high, 1e-20), power + 1.0) - pow(max(low, 1e-20), power + 1.0);
  return integral / ((power + 1.0) * width);
}

// From 0 at in_low to 1 at in_high, to the power: the mean over the value's footprint.
float level(float value, float in_low, float in_high, float gamma) {
  float range = in_high - in_low;
  float scale = 1.0 / (range < 0.0 ? min(range, -1e-7) : max(range, 1e-7));
  float t = (value - in_low) * scale;
  float width = max(footprint(value) * abs(scale), 1e-7);
  float low = clamp(t - 0.5 * width, 0.0, 1.0);
  float high = clamp(t + 0.5 * width, 0.0, 1.0);
  float below = clamp(0.5 - t / width, 0.0, 1.0);
  float above = clamp(0.5 - (1.0 - t) / width, 0.0, 1.0);
  float inside = gamma == 1.0 ? 0.5 * (low + high) : power_mean(low, high, 1.0 / gamma);
  return above + (1.0 - below - above) * inside;
}

vec3 level(vec3 color, float in_low, float in_high, float gamma) {
  return vec3(level(color.r, in_low, in_high, gamma), level(color.g, in_low, in_high, gamma),
              level(color.b, in_low, in_high, gamma));
}

/// Stretches the values from black to white over the whole range, bends them, and fits them into
/// another range. What is beyond black and white is cut off.
/// The result is out_low + (out_high - out_low) t^(1 / gamma), with t from 0 at in_low to 1 at
/// in_high. It is the mean over the value's footprint, so levels that are close together, a
/// threshold, are antialiased.
/// @source MaterialX 1.39, Standard Nodes, range; Substance 3D Designer, "Levels"
/// @param value the value
/// @param in_low what becomes black @default 0
/// @param in_high what becomes white; below `in_low` it inverts @default 1
/// @param gamma above 1 the middle gets brighter, below 1 darker @default 1 @range 0.01 100
/// @param out_low what black becomes @default 0
/// @param out_high what white becomes @default 1
float levels(float value, float in_low, float in_high, float gamma, float out_low,
             float out_high) {
  return mix(out_low, out_high, level(value, in_low, in_high, gamma));
}

/// @param color linear light
/// @param in_low what becomes black @default 0
/// @param in_high what becomes white; below `in_low` it inverts @default 1
/// @param gamma above 1 the middle gets brighter, below 1 darker @default 1 @range 0.01 100
/// @param out_low what black becomes @default 0
/// @param out_high what white becomes @default 1
vec3 levels(vec3 color, float in_low, float in_high, float gamma, float out_low, float out_high) {
  return mix(vec3(out_low), vec3(out_high), level(color, in_low, in_high, gamma));
}

/// @param color linear light; alpha, straight, stays
/// @param in_low what becomes black @default 0
/// @param in_high what becomes white; below `in_low` it inverts @default 1
/// @param gamma above 1 the middle gets brighter, below 1 darker @default 1 @range 0.01 100
/// @param out_low what black becomes @default 0
/// @param out_high what white becomes @default 1
vec4 levels(vec4 color, float in_low, float in_high, float gamma, float out_low, float out_high) {
  vec3 t = level(color.rgb, in_low, in_high, gamma);
  return vec4(mix(vec3(out_low), vec3(out_high), t), color.a);
}
