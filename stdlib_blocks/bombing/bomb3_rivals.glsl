// SPDX-License-Identifier: Apache-2.0
/// How many cells across, up and away have copies whose centres can be nearer than `spacing` to one
/// place; none without spacing. It is `bomb_rivals` of space: `bomb3` computes it when the shader
/// is made.
/// @param jitter as of `bomb3` @default vec3(1)
/// @param spacing as of `bomb3` @default 0
ivec3 bomb3_rivals(vec3 jitter, const float spacing) {
  // What is just so far, but for rounding, is not nearer.
  return spacing > 0.0 ? max(ivec3(ceil(jitter + 2.0 * spacing - 1e-6)), 1) : ivec3(0);
}
