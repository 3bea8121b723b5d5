// SPDX-License-Identifier: Apache-2.0
/// Rises from 0 to 1 while the value goes from `low` to `high`, without a kink at either end (3t^2
/// - 2t^3).
/// With `high` below `low` it falls: 1 up to `high`, 0 from `low` on. Where both are equal it is a
/// jump.
/// @param value the value
/// @param low where the result is 0 @default 0
/// @param high where it is 1 @default 1
float smooth_step(float value, float low, float high) {
  float span = high - low;
  float t = clamp((value - low) / (abs(span) < 1e-7 ? 1e-7 : span), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}
