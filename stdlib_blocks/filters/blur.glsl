// SPDX-License-Identifier: Apache-2.0
float weighed(float value) { return value; }
vec2 weighed(vec2 value) { return value; }
vec3 weighed(vec3 value) { return value; }
vec4 weighed(vec4 color) { return vec4(color.rgb * color.a, color.a); }

float straight(float value) { return value; }
vec2 straight(vec2 value) { return value; }
vec3 straight(vec3 value) { return value; }
vec4 straight(vec4 color) { return vec4(color.rgb / max(color.a, 1e-20), color.a); }

/// Blurs whatever is connected, as a Gaussian does.
/// It looks at a square of places, each with a pixel as large as its part of the square. So few
/// places do: nothing falls between them. Their weights are binomial, and with their pixels they
/// make a curve that has the Gaussian's standard deviation exactly, and comes to its shape with
/// more places. Colours are weighed by their alpha.
/// @source binomial weights have the variance (n - 1) / 4, a box 1 / 12
/// @param image what is blurred
/// @param uv where to look @default uv
/// @param radius the Gaussian's standard deviation, across and up, in the units of uv; at 0 nothing
///   is blurred @default vec2(0.02)
/// @param taps how many places, across and up: 1 is a box; of 3 an edge differs from the
///   Gaussian's by 3 %, of 5 by 2 %. The image is computed for each of them @default 3 @range 1 9
genType image(vec2 uv);

genType blur(vec2 uv, vec2 radius, const int taps) {
  vec2 apart = abs(radius) * sqrt(12.0 / float(3 * taps - 2));
  vec2 pixel = footprint(uv);
  vec2 width = sqrt(apart * apart + pixel * pixel);
  vec2 corner = uv - 0.5 * float(taps - 1) * apart;
  genType sum = genType(0.0);
  float share = 1.0;
  for (int i = 1; i < taps; i++) {
    share *= 0.25;
  }
  float row = share;
  for (int y = 0; y < taps; y++) {
    float weight = row;
    for (int x = 0; x < taps; x++) {
      sum += weight * weighed(image(widen(corner + apart * vec2(x, y), width, uv)));
      weight *= float(taps - 1 - x) / float(x + 1);
    }
    row *= float(taps - 1 - y) / float(y + 1);
  }
  return straight(sum);
}
