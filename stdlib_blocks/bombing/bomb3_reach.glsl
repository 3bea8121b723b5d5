// SPDX-License-Identifier: Apache-2.0
const int SHAPE_CUBE = 0;
const int SHAPE_BALL = 1;

// The greatest a + b cos + c sin of all angles between two in degrees.
float greatest(float a, float b, float c, vec2 rotation) {
  vec2 angle = radians(rotation);
  vec2 turns = (angle - atan(c, b)) * 0.15915494309189535;
  vec2 ends = a + b * cos(angle) + c * sin(angle);
  bool meets_peak = floor(turns.y) >= ceil(turns.x);
  return meets_peak ? a + length(vec2(b, c)) : max(ends.x, ends.y);
}

// How far the unit cube, turned about an axis, reaches along one of the three directions: the
// greatest sum of the |.| of a row of the matrix, which is that of the row with any signs. `own`
// and `other` are the axis' part along that direction, and along the other two.
float row_of(float own, vec2 other, vec2 rotation) {
  vec2 mixed = own * other;
  float most = 0.0;
  for (int signs = 0; signs < 4; ++signs) {
    vec2 s = vec2((signs & 1) == 0 ? 1.0 : -1.0, (signs & 2) == 0 ? 1.0 : -1.0);
    float still = own * own + dot(s, mixed);
    float by_cos = 1.0 - still;
    float by_sin = s.y * other.x - s.x * other.y;
    most = max(most, max(greatest(still, by_cos, by_sin, rotation),
                         greatest(-still, -by_cos, -by_sin, rotation)));
  }
  return most;
}

/// How far a copy of `bomb3` reaches from its centre along each axis, in cells, whatever is drawn
/// at random.
/// A turned cube reaches as far along an axis as the sum of the |.| of the matrix' row, and each of
/// the signs that are possible is a wave of the angle, whose peak is between the least and the
/// greatest angle or is not.
/// @param size as of `bomb3` @default vec2(1)
/// @param rotation as of `bomb3` @default vec2(0) @unit degrees
/// @param axis as of `bomb3` @default vec3(0, 0, 1)
/// @param tumble as of `bomb3` @default false
/// @param shape as of `bomb3` @default SHAPE_CUBE
vec3 bomb3_reach(vec2 size, vec2 rotation, vec3 axis, const bool tumble, const int shape) {
  if (shape == SHAPE_BALL) {
    return vec3(0.5 * size.y);
  }
  if (tumble) {
    return vec3(0.8660254037844386 * size.y);
  }
  if (rotation.x == 0.0 && rotation.y == 0.0) {
    return vec3(0.5 * size.y);
  }
  vec3 a = normalized(axis);
  vec3 rows = vec3(row_of(a.x, a.yz, rotation), row_of(a.y, a.zx, rotation),
                   row_of(a.z, a.xy, rotation));
  return 0.5 * size.y * rows;
}
