// SPDX-License-Identifier: Apache-2.0
/// Rises from 0 to 1 while the value goes from `low` to `high`, without a kink at either end (3t^2
/// - 2t^3).
/// Where `high` is not above `low` it is a jump at `low`.
/// @param value the value
/// @param low where the rise begins @default 0
/// @param high where it ends @default 1
float smooth_step(float value, float low, float high) {
  float t = clamp((value - low) / max(high - low, 1e-7), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}
