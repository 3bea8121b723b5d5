// SPDX-License-Identifier: Apache-2.0
const int SHAPE_CUBE = 0;
const int SHAPE_BALL = 1;

/// How many cells across, up and away have copies that can reach one point, whatever is drawn at
/// random. It is `bomb_cells` of space: `bomb3` computes it when the shader is made.
/// @param jitter as of `bomb3` @default vec3(1)
/// @param size as of `bomb3` @default vec2(1)
/// @param rotation as of `bomb3` @default vec2(0) @unit degrees
/// @param axis as of `bomb3` @default vec3(0, 0, 1)
/// @param tumble as of `bomb3` @default false
/// @param shape as of `bomb3` @default SHAPE_CUBE
ivec3 bomb3_cells(vec3 jitter, vec2 size, vec2 rotation, vec3 axis, const bool tumble,
                  const int shape) {
  vec3 width = jitter + 2.0 * bomb3_reach(size, rotation, axis, tumble, shape);
  // What only touches a point, but for rounding, does not reach it.
  return max(ivec3(ceil(width - 0.000002)), 1);
}
