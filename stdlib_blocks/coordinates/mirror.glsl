// SPDX-License-Identifier: Apache-2.0
/// Shows what is drawn on one side of a line on the other as well, mirrored.
/// @source Substance 3D Designer, "Mirror"
/// @param uv coordinate @default uv
/// @param center a place on the mirror @default vec2(0.5)
/// @param flip how it is mirrored: none; x, left and right; y, up and down; both @default FLIP_X
/// @param from_above whether the right and upper side is shown on both, else the left and lower one
///   @default false
vec2 mirror(vec2 uv, vec2 center, const int flip, const bool from_above) {
  vec2 p = uv - center;
  // Not with abs(p), whose derivative is 0 on the mirror.
  vec2 away = p * vec2(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0);
  vec2 folded = center + (from_above ? away : -away);
  return vec2(flip == FLIP_X || flip == FLIP_BOTH ? folded.x : uv.x,
              flip == FLIP_Y || flip == FLIP_BOTH ? folded.y : uv.y);
}
