// SPDX-License-Identifier: Apache-2.0
/// Shows one wedge of what is drawn all around a middle, mirrored each time, so that all fits.
/// The coordinate is turned and mirrored, never stretched: its footprint stays as it is.
/// @source Material Maker, "Kaleidoscope"
/// @param uv coordinate @default uv
/// @param center the middle @default vec2(0.5)
/// @param segments how often the picture comes again in a turn; each time it is half a wedge and
///   its mirror image @default 6 @range 1 1024
/// @param angle where the wedge that is shown begins; from there it goes counter-clockwise
///   @default 0 @unit degrees
vec2 kaleidoscope(vec2 uv, vec2 center, int segments, float angle) {
  vec2 p = uv - center;
  float wedge = 6.28318530718 / float(segments);
  float start = radians(angle);
  float turned = atan(p.y, p.x == 0.0 ? 1e-20 : p.x) - start;  // atan(0, 0) is undefined
  // How far the place is turned back: constant but for jumps.
  float back = wedge * floor(turned / wedge + 0.5);
  vec2 toward = vec2(cos(back), sin(back));
  vec2 q = vec2(dot(p, toward), p.y * toward.x - p.x * toward.y);
  // Mirrored at the beginning of the wedge.
  vec2 across = vec2(-sin(start), cos(start));
  return center + q - 2.0 * min(dot(q, across), 0.0) * across;
}
