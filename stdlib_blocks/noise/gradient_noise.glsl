// SPDX-License-Identifier: Apache-2.0
// How many cells for each unit nobody else fades.
genType unfaded(genType scale, uint faded_cells) {
  genType cells = abs(scale);
  return faded_cells == 0u ? cells : cells * (1.0 - step(cells, genType(faded_cells)));
}

// The slope of 6t^5 - 15t^4 + 10t^3.
genType fade_slope(genType t) { return 30.0 * t * t * (t - 1.0) * (t - 1.0); }

float across(vec4 corners, vec2 fade) {
  vec2 ends = mix(corners.xz, corners.yw, fade.x);
  return mix(ends.x, ends.y, fade.y);
}

// How much `across` changes with the two fades.
vec2 rise(vec4 corners, vec2 fade) {
  return vec2(mix(corners.y - corners.x, corners.w - corners.z, fade.y),
              mix(corners.z - corners.x, corners.w - corners.y, fade.x));
}

/// Perlin's noise: smooth hills and valleys of one size, as if painted with one brush. Each corner
/// of a grid has a random slope and the value 0.5; in between the slopes are blended.
/// From 0 to 1, with the mean 0.5. Where a cell is no larger than a pixel, the result has faded to
/// its mean; the fading begins where a cell is two pixels large. The standard deviation is 0.141 in
/// one dimension, then 0.165, 0.120 and 0.095. The slopes are those of `directions2` to
/// `directions4`, in one dimension any between -1 and 1.
/// @source Perlin, Improving Noise, SIGGRAPH 2002, with its curve 6t^5 - 15t^4 + 10t^3; the fading:
///   Apodaca and Gritz, Advanced RenderMan, chapter 11
/// @param uv coordinate @default uv
/// @param scale cells for each unit of the coordinate @default vec2(8)
/// @param seed another seed gives another pattern @default 0
/// @param period after how many cells the pattern repeats in each direction; 0 never
///   @default ivec2(0) @range 0 16777216
/// @param filtered whether it fades to its mean @default true
/// @param faded_cells how many cells for each unit of the coordinate need not fade, because a
///   fractal that asks fades them itself @default 0u @asked_at uv
/// @param gradient how much the result changes for each unit of the coordinate, in each direction
/// @return from 0 to 1, with the mean 0.5
float gradient_noise(vec2 uv, vec2 scale, int seed, const ivec2 period, const bool filtered,
                     uint faded_cells, out vec2 gradient) {
  // Half of one over the greatest sum that any slopes give: 0.5353, at (0.5, 0.35). In one
  // dimension it is 0.5, in three 0.5629, and 1.5366 in four.
  const float AMPLITUDE = 0.9340967;
  vec2 p = uv * scale;
  vec2 base = floor(p);
  vec2 t = p - base;
  vec2 fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  uvec2 cell = uvec2(ivec2(base));
  uvec2 columns = lattice_cells(cell.x, period.x);
  uvec2 rows = hash(lattice_cells(cell.y, period.y) + hash(uint(seed)));
  vec4 x;
  vec4 y;
  directions2(hash(columns.xyxy + rows.xxyy), x, y);
  vec2 u = t - 1.0;
  vec4 corners = x * vec2(t.x, u.x).xyxy + y * vec2(t.y, u.y).xxyy;
  vec2 width = footprint(uv) * unfaded(scale, faded_cells);
  float blur = filtered ? clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0) : 0.0;
  float amplitude = AMPLITUDE * (1.0 - blur);
  vec2 slope = vec2(across(x, fade), across(y, fade)) + rise(corners, fade) * fade_slope(t);
  gradient = slope * scale * amplitude;
  return across(corners, fade) * amplitude + 0.5;
}

/// @param uv coordinate
/// @param scale cells for each unit of the coordinate @default 8
/// @param seed another seed gives another pattern @default 0
/// @param period after how many cells the pattern repeats; 0 never @default 0 @range 0 16777216
/// @param filtered whether it fades to its mean @default true
/// @param faded_cells how many cells for each unit of the coordinate need not fade, because a
///   fractal that asks fades them itself @default 0u @asked_at uv
/// @param gradient how much the result changes for each unit of the coordinate
/// @return from 0 to 1, with the mean 0.5
float gradient_noise(float uv, float scale, int seed, const int period, const bool filtered,
                     uint faded_cells, out float gradient) {
  float p = uv * scale;
  float base = floor(p);
  float t = p - base;
  float fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  uvec2 cells = lattice_cells(uint(int(base)), period);
  vec2 slopes = vec2(ivec2(hash(cells + hash(uint(seed))))) * 4.656612873077393e-10;
  vec2 ends = slopes * vec2(t, t - 1.0);
  float width = footprint(uv) * unfaded(scale, faded_cells);
  float blur = filtered ? clamp(2.0 * width - 1.0, 0.0, 1.0) : 0.0;
  float amplitude = 1.0 - blur;
  float slope = mix(slopes.x, slopes.y, fade) + (ends.y - ends.x) * fade_slope(t);
  gradient = slope * scale * amplitude;
  return mix(ends.x, ends.y, fade) * amplitude + 0.5;
}

/// @param uv coordinate @default position
/// @param scale cells for each unit of the coordinate @default vec3(8)
/// @param seed another seed gives another pattern @default 0
/// @param period after how many cells the pattern repeats in each direction; 0 never
///   @default ivec3(0) @range 0 16777216
/// @param filtered whether it fades to its mean @default true
/// @param faded_cells how many cells for each unit of the coordinate need not fade, because a
///   fractal that asks fades them itself @default 0u @asked_at uv
/// @param gradient how much the result changes for each unit of the coordinate, in each direction
/// @return from 0 to 1, with the mean 0.5
float gradient_noise(vec3 uv, vec3 scale, int seed, const ivec3 period, const bool filtered,
                     uint faded_cells, out vec3 gradient) {
  const float AMPLITUDE = 0.8882547;
  vec3 p = uv * scale;
  vec3 base = floor(p);
  vec3 t = p - base;
  vec3 fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  uvec3 cell = uvec3(ivec3(base));
  uvec4 columns = lattice_cells(cell.x, period.x).xyxy;
  uvec2 slices = hash(lattice_cells(cell.z, period.z) + hash(uint(seed)));
  uvec4 rows = hash(lattice_cells(cell.y, period.y).xyxy + slices.xxyy);
  vec4 x0;
  vec4 y0;
  vec4 z0;
  directions3(hash(columns + rows.xxyy), x0, y0, z0);
  vec4 x1;
  vec4 y1;
  vec4 z1;
  directions3(hash(columns + rows.zzww), x1, y1, z1);
  vec3 u = t - 1.0;
  vec4 tx = vec2(t.x, u.x).xyxy;
  vec4 ty = vec2(t.y, u.y).xxyy;
  vec4 front = x0 * tx + y0 * ty + z0 * t.z;
  vec4 back = x1 * tx + y1 * ty + z1 * u.z;
  vec4 face = mix(front, back, fade.z);
  vec3 width = footprint(uv) * unfaded(scale, faded_cells);
  float blur = filtered ? clamp(2.0 * max(max(width.x, width.y), width.z) - 1.0, 0.0, 1.0) : 0.0;
  float amplitude = AMPLITUDE * (1.0 - blur);
  vec3 slope = vec3(across(mix(x0, x1, fade.z), fade.xy), across(mix(y0, y1, fade.z), fade.xy),
                    across(mix(z0, z1, fade.z), fade.xy));
  slope += vec3(rise(face, fade.xy), across(back - front, fade.xy)) * fade_slope(t);
  gradient = slope * scale * amplitude;
  return across(face, fade.xy) * amplitude + 0.5;
}

// The slices of a hypercube that two of its coordinates are fixed in: of their four corners each,
// the sum of slope times way, and the slopes.
vec4 square(uvec4 bits, vec4 tx, vec4 ty, float tz, float tw, out vec4 x, out vec4 y, out vec4 z,
            out vec4 w) {
  directions4(bits, x, y, z, w);
  return x * tx + y * ty + z * tz + w * tw;
}

/// @param uv coordinate
/// @param scale cells for each unit of the coordinate @default vec4(8)
/// @param seed another seed gives another pattern @default 0
/// @param period after how many cells the pattern repeats in each direction; 0 never
///   @default ivec4(0) @range 0 16777216
/// @param filtered whether it fades to its mean @default true
/// @param faded_cells how many cells for each unit of the coordinate need not fade, because a
///   fractal that asks fades them itself @default 0u @asked_at uv
/// @param gradient how much the result changes for each unit of the coordinate, in each direction
/// @return from 0 to 1, with the mean 0.5
float gradient_noise(vec4 uv, vec4 scale, int seed, const ivec4 period, const bool filtered,
                     uint faded_cells, out vec4 gradient) {
  const float AMPLITUDE = 0.3253974;
  vec4 p = uv * scale;
  vec4 base = floor(p);
  vec4 t = p - base;
  vec4 fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  uvec4 cell = uvec4(ivec4(base));
  uvec4 columns = lattice_cells(cell.x, period.x).xyxy;
  uvec4 rows = lattice_cells(cell.y, period.y).xyxy;
  uvec2 last = hash(lattice_cells(cell.w, period.w) + hash(uint(seed)));
  uvec4 slices = hash(lattice_cells(cell.z, period.z).xyxy + last.xxyy);
  uvec4 near = hash(rows + slices.xxyy);
  uvec4 far = hash(rows + slices.zzww);
  vec4 u = t - 1.0;
  vec4 tx = vec2(t.x, u.x).xyxy;
  vec4 ty = vec2(t.y, u.y).xxyy;
  vec4 x0;
  vec4 y0;
  vec4 z0;
  vec4 w0;
  vec4 a = square(hash(columns + near.xxyy), tx, ty, t.z, t.w, x0, y0, z0, w0);
  vec4 x1;
  vec4 y1;
  vec4 z1;
  vec4 w1;
  vec4 b = square(hash(columns + near.zzww), tx, ty, u.z, t.w, x1, y1, z1, w1);
  vec4 x2;
  vec4 y2;
  vec4 z2;
  vec4 w2;
  vec4 c = square(hash(columns + far.xxyy), tx, ty, t.z, u.w, x2, y2, z2, w2);
  vec4 x3;
  vec4 y3;
  vec4 z3;
  vec4 w3;
  vec4 d = square(hash(columns + far.zzww), tx, ty, u.z, u.w, x3, y3, z3, w3);
  vec4 front = mix(a, c, fade.w);
  vec4 back = mix(b, d, fade.w);
  vec4 face = mix(front, back, fade.z);
  vec4 width = footprint(uv) * unfaded(scale, faded_cells);
  float widest = max(max(width.x, width.y), max(width.z, width.w));
  float blur = filtered ? clamp(2.0 * widest - 1.0, 0.0, 1.0) : 0.0;
  float amplitude = AMPLITUDE * (1.0 - blur);
  vec4 slope = vec4(across(mix(mix(x0, x2, fade.w), mix(x1, x3, fade.w), fade.z), fade.xy),
                    across(mix(mix(y0, y2, fade.w), mix(y1, y3, fade.w), fade.z), fade.xy),
                    across(mix(mix(z0, z2, fade.w), mix(z1, z3, fade.w), fade.z), fade.xy),
                    across(mix(mix(w0, w2, fade.w), mix(w1, w3, fade.w), fade.z), fade.xy));
  slope += vec4(rise(face, fade.xy), across(back - front, fade.xy),
                across(mix(c - a, d - b, fade.z), fade.xy)) *
           fade_slope(t);
  gradient = slope * scale * amplitude;
  return across(face, fade.xy) * amplitude + 0.5;
}
