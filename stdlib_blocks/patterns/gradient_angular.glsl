// SPDX-License-Identifier: Apache-2.0
/// A gradient around a middle: from 0 to 1 in a turn, counter-clockwise.
/// Where it begins anew the edge is antialiased, and in the middle, where all angles meet, it goes
/// to 0.5.
/// @param uv coordinate @default uv
/// @param center the middle @default vec2(0.5)
/// @param angle where it begins: 0 is to the right @default 0 @unit degrees
/// @param count how often it goes from 0 to 1 in a turn @default 1 @range 1 1024
/// @param reflected whether it goes back to 0 each time, so that it nowhere jumps @default false
float gradient_angular(vec2 uv, vec2 center, float angle, int count, const bool reflected) {
  vec2 p = uv - center;
  float turns = atan(p.y, p.x == 0.0 ? 1e-20 : p.x) * 0.15915494309;  // atan(0, 0) is undefined
  float phase = (turns - angle / 360.0) * float(count);
  return reflected ? triangle_wave(phase) : sawtooth_wave(phase);
}
