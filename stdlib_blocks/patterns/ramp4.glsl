// SPDX-License-Identifier: Apache-2.0
/// A gradient between four values at the corners of the unit square; constant beyond.
/// Colours are mixed in linear light.
/// @source MaterialX 1.39, Standard Nodes, ramp4
/// @param uv coordinate @default uv
/// @param lower_left value at (0, 0) @default 0
/// @param lower_right value at (1, 0) @default 1
/// @param upper_left value at (0, 1) @default 0
/// @param upper_right value at (1, 1) @default 1
genType ramp4(vec2 uv, genType lower_left, genType lower_right, genType upper_left,
              genType upper_right) {
  vec2 t = clamp(uv, 0.0, 1.0);
  return mix(mix(lower_left, lower_right, t.x), mix(upper_left, upper_right, t.x), t.y);
}
