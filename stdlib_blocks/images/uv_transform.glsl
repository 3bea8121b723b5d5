// SPDX-License-Identifier: Apache-2.0
/// Moves, turns and scales whatever is drawn at its result.
/// What is drawn is scaled and then turned about the pivot, and then moved; so the coordinate is
/// taken the opposite way, R(-rotation) * (uv - pivot - translate) / scale + pivot.
/// @param uv coordinate @default uv
/// @param translate how far to move to the right and up @default vec2(0)
/// @param rotation how far to turn counter-clockwise @default 0 @unit degrees
/// @param scale how many times as large, across and up; not 0 @default vec2(1)
/// @param pivot the point that stays where it is while turning and scaling @default vec2(0.5)
vec2 uv_transform(vec2 uv, vec2 translate, float rotation, vec2 scale, vec2 pivot) {
  float c = cos(radians(rotation));
  float s = sin(radians(rotation));
  vec2 shrink = 1.0 / scale;
  mat2 turn = mat2(c * shrink.x, -s * shrink.y, s * shrink.x, c * shrink.y);
  return turn * (uv - (pivot + translate)) + pivot;
}
