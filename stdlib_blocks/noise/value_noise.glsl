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

// From 24 of each corner's bits: all floats from 0 to 1 in equal steps.
vec4 unit(uvec4 bits) { return vec4(bits >> 8u) * 5.9604644775390625e-8; }

/// Smooth random hills: a random number from 0 to 1 at each corner of a square grid, and between
/// them a curve without kinks.
/// The curve is 6t^5 - 15t^4 + 10t^3. Where a cell is no larger than a pixel, the result has faded
/// to its mean, 0.5; the fading begins where a cell is two pixels large. All values from 0 to 1
/// occur. The variance is (181/231)^n / 12 in n dimensions: the standard deviation is 0.256, 0.226,
/// 0.200 and 0.177.
/// @source Ebert et al., Texturing and Modeling, 3rd edition, chapter 2, "Lattice noises"; the
///   curve: Perlin, Improving Noise, SIGGRAPH 2002; the fading: Apodaca and Gritz, Advanced
///   RenderMan, chapter 11
/// @param uv coordinate @default uv
/// @param scale cells for each unit of the coordinate @default vec2(8)
/// @param seed another seed gives another pattern @default 0
/// @param period after how many cells the pattern repeats in each direction; 0 never
///   @default ivec2(0) @range 0 16777216
/// @param filtered whether it fades to its mean @default true
/// @param faded_cells how many cells for each unit of the coordinate need not fade, because a
///   fractal that asks fades them itself @default 0u @asked_at uv
/// @param gradient how much the result changes for each unit of the coordinate, in each direction
/// @return from 0 to 1
float value_noise(vec2 uv, vec2 scale, int seed, const ivec2 period, const bool filtered,
                  uint faded_cells, out vec2 gradient) {
  vec2 p = uv * scale;
  vec2 base = floor(p);
  vec2 t = p - base;
  vec2 fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  uvec2 cell = uvec2(ivec2(base));
  uvec2 columns = lattice_cells(cell.x, period.x);
  uvec2 rows = hash(lattice_cells(cell.y, period.y) + hash(uint(seed)));
  vec4 corners = vec4(hash(columns.xyxy + rows.xxyy) >> 8u) * 5.9604644775390625e-8;
  float low = mix(corners.x, corners.y, fade.x);
  float high = mix(corners.z, corners.w, fade.x);
  vec2 width = footprint(uv) * unfaded(scale, faded_cells);
  float blur = filtered ? clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0) : 0.0;
  vec2 rise = vec2(mix(corners.y - corners.x, corners.w - corners.z, fade.y), high - low);
  gradient = rise * fade_slope(t) * scale * (1.0 - blur);
  return mix(mix(low, high, fade.y), 0.5, blur);
}

/// @param uv coordinate
/// @param scale cells for each unit of the coordinate @default 8
/// @param seed another seed gives another pattern @default 0
/// @param period after how many cells the pattern repeats; 0 never @default 0 @range 0 16777216
/// @param filtered whether it fades to its mean @default true
/// @param faded_cells how many cells for each unit of the coordinate need not fade, because a
///   fractal that asks fades them itself @default 0u @asked_at uv
/// @param gradient how much the result changes for each unit of the coordinate
/// @return from 0 to 1
float value_noise(float uv, float scale, int seed, const int period, const bool filtered,
                  uint faded_cells, out float gradient) {
  float p = uv * scale;
  float base = floor(p);
  float t = p - base;
  float fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  uvec2 columns = lattice_cells(uint(int(base)), period);
  vec2 ends = vec2(hash(columns + hash(uint(seed))) >> 8u) * 5.9604644775390625e-8;
  float width = footprint(uv) * unfaded(scale, faded_cells);
  float blur = filtered ? clamp(2.0 * width - 1.0, 0.0, 1.0) : 0.0;
  gradient = (ends.y - ends.x) * fade_slope(t) * scale * (1.0 - blur);
  return mix(mix(ends.x, ends.y, fade), 0.5, blur);
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
/// @return from 0 to 1
float value_noise(vec3 uv, vec3 scale, int seed, const ivec3 period, const bool filtered,
                  uint faded_cells, out vec3 gradient) {
  vec3 p = uv * scale;
  vec3 base = floor(p);
  vec3 t = p - base;
  vec3 fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  uvec3 cell = uvec3(ivec3(base));
  uvec4 columns = lattice_cells(cell.x, period.x).xyxy;
  uvec2 slices = hash(lattice_cells(cell.z, period.z) + hash(uint(seed)));
  uvec4 rows = hash(lattice_cells(cell.y, period.y).xyxy + slices.xxyy);
  vec4 front = unit(hash(columns + rows.xxyy));
  vec4 back = unit(hash(columns + rows.zzww));
  vec3 width = footprint(uv) * unfaded(scale, faded_cells);
  float blur = filtered ? clamp(2.0 * max(max(width.x, width.y), width.z) - 1.0, 0.0, 1.0) : 0.0;
  vec4 face = mix(front, back, fade.z);
  vec3 rise = vec3(mix(face.y - face.x, face.w - face.z, fade.y),
                   mix(face.z - face.x, face.w - face.y, fade.x), across(back - front, fade.xy));
  gradient = rise * fade_slope(t) * scale * (1.0 - blur);
  return mix(across(face, fade.xy), 0.5, blur);
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
/// @return from 0 to 1
float value_noise(vec4 uv, vec4 scale, int seed, const ivec4 period, const bool filtered,
                  uint faded_cells, out vec4 gradient) {
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
  vec4 near_front = unit(hash(columns + near.xxyy));
  vec4 near_back = unit(hash(columns + near.zzww));
  vec4 far_front = unit(hash(columns + far.xxyy));
  vec4 far_back = unit(hash(columns + far.zzww));
  vec4 width = footprint(uv) * unfaded(scale, faded_cells);
  float widest = max(max(width.x, width.y), max(width.z, width.w));
  float blur = filtered ? clamp(2.0 * widest - 1.0, 0.0, 1.0) : 0.0;
  vec4 front = mix(near_front, far_front, fade.w);
  vec4 back = mix(near_back, far_back, fade.w);
  vec4 face = mix(front, back, fade.z);
  vec4 along = mix(far_front - near_front, far_back - near_back, fade.z);
  vec4 rise = vec4(mix(face.y - face.x, face.w - face.z, fade.y),
                   mix(face.z - face.x, face.w - face.y, fade.x), across(back - front, fade.xy),
                   across(along, fade.xy));
  gradient = rise * fade_slope(t) * scale * (1.0 - blur);
  return mix(across(face, fade.xy), 0.5, blur);
}
