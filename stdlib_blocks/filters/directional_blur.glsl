// SPDX-License-Identifier: Apache-2.0
float weighed(float value) { return value; }
vec2 weighed(vec2 value) { return value; }
vec3 weighed(vec3 value) { return value; }
vec4 weighed(vec4 color) { return vec4(color.rgb * color.a, color.a); }

float straight(float value) { return value; }
vec2 straight(vec2 value) { return value; }
vec3 straight(vec3 value) { return value; }
vec4 straight(vec4 color) { return vec4(color.rgb / max(color.a, 1e-20), color.a); }

/// Blurs whatever is connected along one direction, as a Gaussian does: brushed metal, rain.
/// As `blur`, but on a line: the places on it have pixels that are as long as their part of the
/// line, and as wide as the pixel. Colours are weighed by their alpha.
/// @source Substance 3D Designer and Material Maker, "Directional Blur"; the weights as in `blur`
/// @param image what is blurred
/// @param uv where to look @default uv
/// @param radius the Gaussian's standard deviation, in the units of uv; at 0 nothing is blurred
///   @default 0.05
/// @param angle of the line, counter-clockwise: 0 is across @default 0 @unit degrees
/// @param taps how many places: 1 is a box; of 3 an edge differs from the Gaussian's by 3 %, of 5
///   by 2 %. The image is computed for each of them @default 5 @range 1 33
genType image(vec2 uv);

genType directional_blur(vec2 uv, float radius, float angle, const int taps) {
  float apart = abs(radius) * sqrt(12.0 / float(3 * taps - 2));
  float c = cos(radians(angle));
  float s = sin(radians(angle));
  // In a frame whose x runs along the line.
  mat2 from_line = mat2(c, s, -s, c);
  vec2 p = vec2(c * uv.x + s * uv.y, c * uv.y - s * uv.x);
  vec2 pixel = footprint(p);
  vec2 width = vec2(sqrt(apart * apart + pixel.x * pixel.x), pixel.y);
  float first = p.x - 0.5 * float(taps - 1) * apart;
  float weight = 1.0;
  for (int i = 1; i < taps; i++) {
    weight *= 0.5;
  }
  genType sum = genType(0.0);
  for (int i = 0; i < taps; i++) {
    vec2 place = vec2(first + apart * float(i), p.y);
    sum += weight * weighed(image(from_line * widen(place, width, uv)));
    weight *= float(taps - 1 - i) / float(i + 1);
  }
  return straight(sum);
}
