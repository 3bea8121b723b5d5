// SPDX-License-Identifier: Apache-2.0
/// Slants whatever is drawn at its result.
/// What is drawn is moved to the right by amount.x times its height over the pivot, and then
/// up by amount.y times what is then its distance to the right of it. Areas stay as they are, for
/// any amount.
/// @source Material Maker, "Shear"
/// @param uv coordinate @default uv
/// @param amount how far to the right for each unit up, and how far up for each unit to the right:
///   the tangents of the angles @default vec2(0.5, 0)
/// @param pivot the point that stays where it is @default vec2(0.5)
vec2 shear(vec2 uv, vec2 amount, vec2 pivot) {
  vec2 p = uv - pivot;
  p.y -= amount.y * p.x;
  p.x -= amount.x * p.y;
  return p + pivot;
}
