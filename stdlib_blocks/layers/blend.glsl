// SPDX-License-Identifier: Apache-2.0
const int MODE_MIX = 0;
const int MODE_ADD = 1;
const int MODE_SUBTRACT = 2;
const int MODE_MULTIPLY = 3;
const int MODE_SCREEN = 4;
const int MODE_OVERLAY = 5;
const int MODE_DARKEN = 6;
const int MODE_LIGHTEN = 7;
const int MODE_DIFFERENCE = 8;

vec3 mode_color(vec3 front, vec3 back, const int mode) {
  if (mode == MODE_ADD) {
    return back + front;
  }
  if (mode == MODE_SUBTRACT) {
    return max(back - front, 0.0);
  }
  if (mode == MODE_MULTIPLY) {
    return back * front;
  }
  if (mode == MODE_SCREEN) {
    return back + front - back * front;
  }
  if (mode == MODE_OVERLAY) {
    return mix(2.0 * back * front, 1.0 - 2.0 * (1.0 - back) * (1.0 - front), step(0.5, back));
  }
  if (mode == MODE_DARKEN) {
    return min(back, front);
  }
  if (mode == MODE_LIGHTEN) {
    return max(back, front);
  }
  if (mode == MODE_DIFFERENCE) {
    return abs(back - front);
  }
  return front;
}

/// Lays one colour over another.
/// Where there is a background the foreground's colour is what the mode makes of both, and the two
/// are composited with "source over". All colours have straight alpha, the result as well.
/// @source W3C, Compositing and Blending Level 1, sections 5.8, 5.9 and 9.1; Porter and Duff,
///   Compositing Digital Images, SIGGRAPH 1984
/// @param foreground what is laid on top
/// @param background what lies below
/// @param mode how colours meet: mix shows the foreground; add and subtract don't stop at 1 but at
///   0; multiply darkens, screen lightens; overlay does both, as the background says; darken and
///   lighten keep the smaller and the larger value; difference is the distance between them
///   @default MODE_MIX
/// @param opacity of the foreground @default 1 @range 0 1
/// @param mask where the foreground is shown: another factor of its opacity @default 1 @range 0 1
vec4 blend(vec4 foreground, vec4 background, const int mode, float opacity, float mask) {
  float front = foreground.a * opacity * mask;
  float alpha = 1.0 - (1.0 - front) * (1.0 - background.a);
  vec3 blended = mode_color(foreground.rgb, background.rgb, mode);
  vec3 color = mode == MODE_MIX ? foreground.rgb : mix(foreground.rgb, blended, background.a);
  return vec4(mix(background.rgb, color, front / max(alpha, 1e-20)), alpha);
}
