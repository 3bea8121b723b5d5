// SPDX-License-Identifier: Apache-2.0
const int CURVE_LINEAR = 0;
const int CURVE_SMOOTH = 1;
const int CURVE_STEPS = 2;

// How far the position has come from one stop to the next: 0 up to the first, 1 from the second on.
float progress(float position, float first, float second, const int curve) {
  if (curve == CURVE_STEPS) {
    return threshold(position, second);
  }
  float t = clamp((position - first) / max(second - first, 1e-7), 0.0, 1.0);
  return curve == CURVE_SMOOTH ? t * t * (3.0 - 2.0 * t) : t;
}

/// Turns a number into a colour: a gradient through two, three or four colours at given positions.
/// Positions rise; before the first and after the last the colour is constant. Colours are mixed in
/// linear light.
/// @param position where in the gradient, a noise for example
/// @param color_1 colour at the first stop @default vec4(0, 0, 0, 1)
/// @param color_2 colour at the second stop @default vec4(1)
/// @param stop_1 position of the first colour @default 0
/// @param stop_2 position of the second colour @default 1
/// @param curve how the colours pass into each other: linear, smooth (without kinks) or in steps at
///   each later stop @default CURVE_LINEAR
vec4 color_ramp(float position, vec4 color_1, vec4 color_2, float stop_1, float stop_2,
                const int curve) {
  return mix(color_1, color_2, progress(position, stop_1, stop_2, curve));
}

/// @param position where in the gradient, a noise for example
/// @param color_1 colour at the first stop @default vec4(0, 0, 0, 1)
/// @param color_2 colour at the second stop @default vec4(0.5, 0.5, 0.5, 1)
/// @param color_3 colour at the third stop
/// @param stop_1 position of the first colour @default 0
/// @param stop_2 position of the second colour @default 0.5
/// @param stop_3 position of the third colour @default 1
/// @param curve how the colours pass into each other @default CURVE_LINEAR
vec4 color_ramp(float position, vec4 color_1, vec4 color_2, vec4 color_3, float stop_1,
                float stop_2, float stop_3, const int curve) {
  vec4 color = mix(color_1, color_2, progress(position, stop_1, stop_2, curve));
  return mix(color, color_3, progress(position, stop_2, stop_3, curve));
}

/// @param position where in the gradient, a noise for example
/// @param color_1 colour at the first stop @default vec4(0, 0, 0, 1)
/// @param color_2 colour at the second stop @default vec4(0.33, 0.33, 0.33, 1)
/// @param color_3 colour at the third stop @default vec4(0.67, 0.67, 0.67, 1)
/// @param color_4 colour at the fourth stop
/// @param stop_1 position of the first colour @default 0
/// @param stop_2 position of the second colour @default 0.33
/// @param stop_3 position of the third colour @default 0.67
/// @param stop_4 position of the fourth colour @default 1
/// @param curve how the colours pass into each other @default CURVE_LINEAR
vec4 color_ramp(float position, vec4 color_1, vec4 color_2, vec4 color_3, vec4 color_4,
                float stop_1, float stop_2, float stop_3, float stop_4, const int curve) {
  vec4 color = mix(color_1, color_2, progress(position, stop_1, stop_2, curve));
  color = mix(color, color_3, progress(position, stop_2, stop_3, curve));
  return mix(color, color_4, progress(position, stop_3, stop_4, curve));
}
