// SPDX-License-Identifier: Apache-2.0
/// Scatters grains of one colour over another: each grain is wholly the foreground or wholly the
/// background, the foreground as often as its opacity says.
/// The borders of grains are antialiased, and where a grain is smaller than a pixel all of them
/// together are the mean, which is what `over` gives.
/// @source Photoshop and Material Maker, blend mode Dissolve
/// @param foreground what is scattered; its alpha counts as opacity, too
/// @param background what lies below
/// @param opacity how many grains are of the foreground @default 0.5 @range 0 1
/// @param uv coordinate @default uv
/// @param scale grains for each unit of the coordinate, across and up; above 0 @default vec2(256)
/// @param seed another seed gives other grains @default 0
vec4 dissolve(vec4 foreground, vec4 background, float opacity, vec2 uv, vec2 scale, int seed) {
  float chance = opacity * foreground.a;
  vec2 p = uv * scale;
  vec2 pixel = footprint(uv) * scale;
  vec2 seen = clamp(pixel, 1e-6, 1.0);
  vec2 low = floor(p - 0.5 * seen);
  vec2 next = clamp((p + 0.5 * seen - low - 1.0) / seen, 0.0, 1.0);
  float share = 0.0;
  for (int y = 0; y < 2; y++) {
    for (int x = 0; x < 2; x++) {
      vec2 part = vec2(x == 0 ? 1.0 - next.x : next.x, y == 0 ? 1.0 - next.y : next.y);
      ivec2 cell = ivec2(low) + ivec2(x, y);
      share += part.x * part.y * threshold(chance, random(cell_hash(cell, seed), -1));
    }
  }
  float blur = clamp(2.0 * max(pixel.x, pixel.y) - 1.0, 0.0, 1.0);
  share = mix(share, chance, blur);
  return over(vec4(foreground.rgb, share), background);
}
