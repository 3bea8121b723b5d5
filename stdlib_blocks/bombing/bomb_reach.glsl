// SPDX-License-Identifier: Apache-2.0
/// How far a copy of `bomb` reaches from its centre along either axis, in cells, whatever is drawn
/// at random.
/// @param size as of `bomb` @default vec2(1)
/// @param rotation as of `bomb` @default vec2(0) @unit degrees
/// @param shape as of `bomb` @default SHAPE_SQUARE
float bomb_reach(vec2 size, vec2 rotation, const int shape) {
  if (shape == SHAPE_DISC) {
    return 0.5 * size.y;
  }
  // |cos| + |sin| is greatest at 45 degrees, and again at every quarter turn from there.
  vec2 turns = rotation / 90.0 - 0.5;
  vec2 ends = abs(cos(radians(rotation))) + abs(sin(radians(rotation)));
  float widest = floor(turns.y) >= ceil(turns.x) ? 1.41421356 : max(ends.x, ends.y);
  return 0.5 * size.y * widest;
}
