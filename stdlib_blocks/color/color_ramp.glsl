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

// What a pixel shows of the part of the ramp between two stops, times its alpha; `middle` and
// `reach` are the middle and half the length of what it sees of the part, whose length is 1. The
// curve is a polynomial: with its slope s, half its second derivative b, and -2, a sixth of its
// third, its mean is what it is in the middle and b reach^2 / 3, and its variance is that of
// s x + b x^2 - 2 x^3 for x from -reach to reach. A colour times its alpha is the product of two
// mixes, whose mean is the product of their means, and the variance times both differences.
vec4 part_mean(vec4 from, vec4 to, float middle, float reach, const int curve) {
  if (curve == CURVE_STEPS) {
    return vec4(from.rgb * from.a, from.a);
  }
  float square = reach * reach;
  float mean = middle;
  float variance = square / 3.0;
  if (curve == CURVE_SMOOTH) {
    float s = 6.0 * middle * (1.0 - middle);
    float b = 3.0 - 6.0 * middle;
    mean = middle * middle * (3.0 - 2.0 * middle) + b * square / 3.0;
    variance = square * (s * s / 3.0 +
                         square * (b * b * (4.0 / 45.0) - 0.8 * s + square * (4.0 / 7.0)));
  }
  vec4 color = mix(from, to, mean);
  return vec4(color.rgb * color.a + (to.rgb - from.rgb) * ((to.a - from.a) * variance), color.a);
}

/// Turns a number into a colour: a gradient through any number of colours at given positions.
/// Positions rise; before the first and after the last the colour is constant. Colours are mixed in
/// linear light. Ramps with a list of colours are the exact mean over the position's footprint,
/// weighed by alpha: stops that are closer than a pixel, or at one place, do not alias.
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

/// @param position where in the gradient, a noise for example
/// @param colors the colours at the stops
/// @param stops their positions, one for each colour, which rise; two may be the same
///   @as_long_as colors
/// @param curve how the colours pass into each other; of steps, each goes on up to the next stop
///   @default CURVE_LINEAR
/// @param filtered whether the ramp is filtered; else it needs no derivatives of the position
///   @default true
vec4 color_ramp(float position, const vec4 colors[], const float stops[], const int curve,
                const bool filtered) {
  int last = colors.length() - 1;
  if (!filtered) {
    vec4 color = colors[0];
    for (int i = 0; i < last; i++) {
      float t = clamp((position - stops[i]) / max(stops[i + 1] - stops[i], 1e-7), 0.0, 1.0);
      if (curve == CURVE_STEPS) {
        t = step(stops[i + 1], position);
      } else if (curve == CURVE_SMOOTH) {
        t = t * t * (3.0 - 2.0 * t);
      }
      color = mix(color, colors[i + 1], t);
    }
    return color;
  }
  float width = max(footprint(position), 1e-7);
  // The share of the pixel that is below a stop.
  float below = clamp((stops[0] - position) / width + 0.5, 0.0, 1.0);
  vec4 sum = vec4(colors[0].rgb * colors[0].a, colors[0].a) * below;
  for (int i = 0; i < last; i++) {
    float next = clamp((stops[i + 1] - position) / width + 0.5, 0.0, 1.0);
    float part = 1.0 / max(stops[i + 1] - stops[i], 1e-7);
    float middle = position + width * (0.5 * (below + next) - 0.5) - stops[i];
    sum += (next - below) * part_mean(colors[i], colors[i + 1], clamp(middle * part, 0.0, 1.0),
                                      min(0.5 * (next - below) * width * part, 0.5), curve);
    below = next;
  }
  vec4 end = colors[last];
  sum += (1.0 - below) * vec4(end.rgb * end.a, end.a);
  return vec4(sum.a > 0.0 ? sum.rgb / max(sum.a, 1e-20) : end.rgb, sum.a);
}
