// SPDX-License-Identifier: Apache-2.0
float weighed(float value) { return value; }
vec2 weighed(vec2 value) { return value; }
vec3 weighed(vec3 value) { return value; }
vec4 weighed(vec4 color) { return vec4(color.rgb * color.a, color.a); }

float straight(float value) { return value; }
vec2 straight(vec2 value) { return value; }
vec3 straight(vec3 value) { return value; }
vec4 straight(vec4 color) { return vec4(color.rgb / max(color.a, 1e-20), color.a); }

/// Shows whatever is connected in coarse squares, each with its mean.
/// A square asks for the image in its middle, with a pixel as large as itself. The borders of the
/// squares are antialiased: a pixel that sees up to four of them shows the share of each, and from
/// far away it is the image itself. Colours are weighed by their alpha.
/// @source Blender, compositor, Pixelate
/// @param image what is shown
/// @param uv where to look @default uv
/// @param scale squares for each unit of the coordinate, across and up; above 0 @default vec2(16)
genType image(vec2 uv);

genType pixelate(vec2 uv, vec2 scale) {
  vec2 p = uv * scale;
  vec2 pixel = footprint(uv) * scale;
  vec2 seen = clamp(pixel, 1e-6, 1.0);
  vec2 low = floor(p - 0.5 * seen);
  vec2 next = clamp((p + 0.5 * seen - low - 1.0) / seen, 0.0, 1.0);
  vec2 width = max(pixel, 1.0) / scale;
  genType sum = genType(0.0);
  for (int y = 0; y < 2; y++) {
    for (int x = 0; x < 2; x++) {
      vec2 share = vec2(x == 0 ? 1.0 - next.x : next.x, y == 0 ? 1.0 - next.y : next.y);
      vec2 place = (low + vec2(x, y) + 0.5) / scale;
      sum += share.x * share.y * weighed(image(widen(place, width, uv)));
    }
  }
  return straight(sum);
}
