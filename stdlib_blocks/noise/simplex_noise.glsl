// SPDX-License-Identifier: Apache-2.0
// How many cells for each unit nobody else fades.
genType unfaded(genType scale, uint faded_cells) {
  genType cells = abs(scale);
  return faded_cells == 0u ? cells : cells * (1.0 - step(cells, genType(faded_cells)));
}

/// Perlin's noise on triangles and their kin instead of squares: smooth hills and valleys of one
/// size that lie along no axis, from fewer corners in three dimensions and more.
/// From 0 to 1, with the mean 0.5. Where a cell is no larger than a pixel, the result has faded to
/// that; the fading begins where a cell is two pixels large. The standard deviation is 0.162 in one
/// dimension, then 0.227, 0.138 and 0.127. A corner reaches as far as the first side that it is not
/// a corner of, so that there is no jump anywhere. It has no period: the grid is slanted, and
/// repeats in no whole numbers of cells along the axes. Take `gradient_noise` for tiles.
/// @source Perlin, Noise Hardware, SIGGRAPH 2001 course, chapter 2; the order of the coordinates:
///   McEwan et al., Efficient Computational Noise in GLSL, Journal of Graphics Tools 16(2), 2012
/// @param uv coordinate @default uv
/// @param scale cells for each unit of the coordinate @default vec2(8)
/// @param seed another seed gives another pattern @default 0
/// @param filtered whether it fades to its mean @default true
/// @param faded_cells how many cells for each unit of the coordinate need not fade, because a
///   fractal that asks fades them itself @default 0u @asked_at uv
/// @param gradient how much the result changes for each unit of the coordinate, in each direction
/// @return from 0 to 1, with the mean 0.5
float simplex_noise(vec2 uv, vec2 scale, int seed, const bool filtered, uint faded_cells,
                    out vec2 gradient) {
  // (sqrt(3) - 1) / 2 and (3 - sqrt(3)) / 6 skew the grid and back.
  const float SKEW = 0.36602540378443865;
  const float BACK = 0.21132486540518713;
  // Half of one over the greatest sum that any slopes give. The others likewise.
  const float AMPLITUDE = 51.16832;
  vec2 p = uv * scale;
  vec2 base = floor(p + (p.x + p.y) * SKEW);
  vec2 a = p - base + (base.x + base.y) * BACK;
  bool lower = a.x > a.y;
  vec2 b = a - (lower ? vec2(1.0, 0.0) : vec2(0.0, 1.0)) + BACK;
  vec2 c = a - 1.0 + 2.0 * BACK;
  uvec2 cell = uvec2(ivec2(base));
  uvec2 columns = uvec2(cell.x, cell.x + 1u);
  uvec2 rows = hash(uvec2(cell.y, cell.y + 1u) + hash(uint(seed)));
  uint middle = lower ? columns.y + rows.x : columns.x + rows.y;
  uvec2 ends = columns + rows;
  // There is no fourth corner: it is the third once more.
  vec4 x;
  vec4 y;
  directions2(hash(uvec4(ends.x, middle, ends.yy)), x, y);
  vec3 dx = vec3(a.x, b.x, c.x);
  vec3 dy = vec3(a.y, b.y, c.y);
  vec3 r = max(0.5 - dx * dx - dy * dy, 0.0);
  vec3 r2 = r * r;
  vec3 reach = r2 * r2;
  vec3 along = x.xyz * dx + y.xyz * dy;
  vec3 fall = -8.0 * r2 * r * along;
  vec2 width = footprint(uv) * unfaded(scale, faded_cells);
  float blur = filtered ? clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0) : 0.0;
  float amplitude = AMPLITUDE * (1.0 - blur);
  vec2 slope = vec2(dot(reach, x.xyz) + dot(fall, dx), dot(reach, y.xyz) + dot(fall, dy));
  gradient = slope * scale * amplitude;
  return dot(reach, along) * amplitude + 0.5;
}

/// @param uv coordinate
/// @param scale cells for each unit of the coordinate @default 8
/// @param seed another seed gives another pattern @default 0
/// @param filtered whether it fades to its mean @default true
/// @param faded_cells how many cells for each unit of the coordinate need not fade, because a
///   fractal that asks fades them itself @default 0u @asked_at uv
/// @param gradient how much the result changes for each unit of the coordinate
/// @return from 0 to 1, with the mean 0.5
float simplex_noise(float uv, float scale, int seed, const bool filtered, uint faded_cells,
                    out float gradient) {
  const float AMPLITUDE = 1.580246;
  float p = uv * scale;
  float base = floor(p);
  uint cell = uint(int(base));
  uvec2 bits = hash(uvec2(cell, cell + 1u) + hash(uint(seed)));
  vec2 x = vec2(ivec2(bits)) * 4.656612873077393e-10;
  vec2 d = p - base - vec2(0.0, 1.0);
  vec2 r = 1.0 - d * d;
  vec2 r2 = r * r;
  float width = footprint(uv) * unfaded(scale, faded_cells);
  float blur = filtered ? clamp(2.0 * width - 1.0, 0.0, 1.0) : 0.0;
  float amplitude = AMPLITUDE * (1.0 - blur);
  gradient = dot(r2 * x, r2 - 8.0 * r * d * d) * scale * amplitude;
  return dot(r2 * r2, x * d) * amplitude + 0.5;
}

/// @param uv coordinate @default position
/// @param scale cells for each unit of the coordinate @default vec3(8)
/// @param seed another seed gives another pattern @default 0
/// @param filtered whether it fades to its mean @default true
/// @param faded_cells how many cells for each unit of the coordinate need not fade, because a
///   fractal that asks fades them itself @default 0u @asked_at uv
/// @param gradient how much the result changes for each unit of the coordinate, in each direction
/// @return from 0 to 1, with the mean 0.5
float simplex_noise(vec3 uv, vec3 scale, int seed, const bool filtered, uint faded_cells,
                    out vec3 gradient) {
  const float AMPLITUDE = 54.11245;
  vec3 p = uv * scale;
  vec3 base = floor(p + (p.x + p.y + p.z) / 3.0);
  vec3 a = p - base + (base.x + base.y + base.z) / 6.0;
  // One step along the greatest coordinate, then one along the second; of equals the first in the
  // order x, y, z.
  vec3 above = vec3(step(a.yz, a.xy), 1.0 - step(a.z, a.x));
  vec3 below = 1.0 - above.zxy;
  vec3 one = min(above, below);
  vec3 two = max(above, below);
  vec3 b = a - one + 1.0 / 6.0;
  vec3 c = a - two + 1.0 / 3.0;
  vec3 d = a - 0.5;
  uvec3 cell = uvec3(ivec3(base));
  uvec3 first = uvec3(one);
  uvec3 second = uvec3(two);
  uvec4 bits = hash(cell.z + uvec4(0u, first.z, second.z, 1u) + hash(uint(seed)));
  bits = hash(cell.y + uvec4(0u, first.y, second.y, 1u) + bits);
  bits = hash(cell.x + uvec4(0u, first.x, second.x, 1u) + bits);
  vec4 x;
  vec4 y;
  vec4 z;
  directions3(bits, x, y, z);
  vec4 dx = vec4(a.x, b.x, c.x, d.x);
  vec4 dy = vec4(a.y, b.y, c.y, d.y);
  vec4 dz = vec4(a.z, b.z, c.z, d.z);
  vec4 r = max(0.5 - dx * dx - dy * dy - dz * dz, 0.0);
  vec4 r2 = r * r;
  vec4 reach = r2 * r2;
  vec4 along = x * dx + y * dy + z * dz;
  vec4 fall = -8.0 * r2 * r * along;
  vec3 width = footprint(uv) * unfaded(scale, faded_cells);
  float blur = filtered ? clamp(2.0 * max(max(width.x, width.y), width.z) - 1.0, 0.0, 1.0) : 0.0;
  float amplitude = AMPLITUDE * (1.0 - blur);
  vec3 slope = vec3(dot(reach, x) + dot(fall, dx), dot(reach, y) + dot(fall, dy),
                    dot(reach, z) + dot(fall, dz));
  gradient = slope * scale * amplitude;
  return dot(reach, along) * amplitude + 0.5;
}

/// @param uv coordinate
/// @param scale cells for each unit of the coordinate @default vec4(8)
/// @param seed another seed gives another pattern @default 0
/// @param filtered whether it fades to its mean @default true
/// @param faded_cells how many cells for each unit of the coordinate need not fade, because a
///   fractal that asks fades them itself @default 0u @asked_at uv
/// @param gradient how much the result changes for each unit of the coordinate, in each direction
/// @return from 0 to 1, with the mean 0.5
float simplex_noise(vec4 uv, vec4 scale, int seed, const bool filtered, uint faded_cells,
                    out vec4 gradient) {
  // (sqrt(5) - 1) / 4 and (5 - sqrt(5)) / 20.
  const float SKEW = 0.30901699437494745;
  const float BACK = 0.13819660112501053;
  const float AMPLITUDE = 31.38885;
  vec4 p = uv * scale;
  vec4 base = floor(p + dot(p, vec4(SKEW)));
  vec4 a = p - base + dot(base, vec4(BACK));
  // How many of the other coordinates each is not below: 3 for the greatest.
  vec3 x_above = step(a.yzw, a.xxx);
  vec3 others = step(a.zww, a.yyz);
  vec4 rank = vec4(x_above.x + x_above.y + x_above.z, 1.0 - x_above) +
              vec4(0.0, others.x + others.y, 1.0 - others.x + others.z,
                   2.0 - others.y - others.z);
  vec4 one = clamp(rank - 2.0, 0.0, 1.0);
  vec4 two = clamp(rank - 1.0, 0.0, 1.0);
  vec4 three = clamp(rank, 0.0, 1.0);
  vec4 b = a - one + BACK;
  vec4 c = a - two + 2.0 * BACK;
  vec4 d = a - three + 3.0 * BACK;
  vec4 e = a - 1.0 + 4.0 * BACK;
  uvec4 cell = uvec4(ivec4(base));
  uvec4 i = uvec4(one);
  uvec4 j = uvec4(two);
  uvec4 k = uvec4(three);
  uint start = hash(uint(seed));
  uvec4 bits = hash(cell.w + uvec4(0u, i.w, j.w, k.w) + start);
  bits = hash(cell.z + uvec4(0u, i.z, j.z, k.z) + bits);
  bits = hash(cell.y + uvec4(0u, i.y, j.y, k.y) + bits);
  bits = hash(cell.x + uvec4(0u, i.x, j.x, k.x) + bits);
  uvec4 next = cell + 1u;
  uint fifth = hash(next.x + hash(next.y + hash(next.z + hash(next.w + start))));
  vec4 x;
  vec4 y;
  vec4 z;
  vec4 w;
  directions4(bits, x, y, z, w);
  vec4 x5;
  vec4 y5;
  vec4 z5;
  vec4 w5;
  directions4(uvec4(fifth), x5, y5, z5, w5);
  vec4 last = vec4(x5.x, y5.x, z5.x, w5.x);
  vec4 dx = vec4(a.x, b.x, c.x, d.x);
  vec4 dy = vec4(a.y, b.y, c.y, d.y);
  vec4 dz = vec4(a.z, b.z, c.z, d.z);
  vec4 dw = vec4(a.w, b.w, c.w, d.w);
  vec4 r = max(0.5 - dx * dx - dy * dy - dz * dz - dw * dw, 0.0);
  float r5 = max(0.5 - dot(e, e), 0.0);
  vec4 r2 = r * r;
  vec4 reach = r2 * r2;
  float reach5 = r5 * r5 * r5 * r5;
  vec4 along = x * dx + y * dy + z * dz + w * dw;
  float along5 = dot(last, e);
  vec4 fall = -8.0 * r2 * r * along;
  vec4 width = footprint(uv) * unfaded(scale, faded_cells);
  float widest = max(max(width.x, width.y), max(width.z, width.w));
  float blur = filtered ? clamp(2.0 * widest - 1.0, 0.0, 1.0) : 0.0;
  float amplitude = AMPLITUDE * (1.0 - blur);
  vec4 slope = vec4(dot(reach, x) + dot(fall, dx), dot(reach, y) + dot(fall, dy),
                    dot(reach, z) + dot(fall, dz), dot(reach, w) + dot(fall, dw));
  slope += reach5 * last - 8.0 * r5 * r5 * r5 * along5 * e;
  gradient = slope * scale * amplitude;
  return (dot(reach, along) + reach5 * along5) * amplitude + 0.5;
}
