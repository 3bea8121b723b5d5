// SPDX-License-Identifier: Apache-2.0
const int DIRECTION_ACROSS = 0;
const int DIRECTION_UP = 1;

/// A straight gradient from one value to another while the coordinate goes from 0 to 1; constant
/// beyond.
/// @param uv coordinate @default uv
/// @param a value at 0 @default 0
/// @param b value at 1 @default 1
/// @param direction along which axis of the coordinate @default DIRECTION_ACROSS
genType ramp(vec2 uv, genType a, genType b, const int direction) {
  return mix(a, b, clamp(direction == DIRECTION_ACROSS ? uv.x : uv.y, 0.0, 1.0));
}
