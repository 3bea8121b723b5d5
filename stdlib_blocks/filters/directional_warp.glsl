// SPDX-License-Identifier: Apache-2.0
/// Draws whatever is connected with every place moved in one direction, by a number.
/// The image is looked at in uv + amount * (intensity - center) in that direction, and filtered for
/// how much it is stretched there.
/// @source Substance 3D Designer, "Directional warp"
/// @param image what is drawn
/// @param uv where to look @default uv
/// @param intensity how far: a noise, say
/// @param amount how far an intensity of 1 moves the place that is looked at, in the units of uv
///   @default 0.05
/// @param angle where to, counter-clockwise: 0 is to the right @default 0 @unit degrees
/// @param center the intensity that moves nothing: 0.5 for numbers from 0 to 1 @default 0
genType image(vec2 uv);

genType directional_warp(vec2 uv, float intensity, float amount, float angle, float center) {
  vec2 direction = vec2(cos(radians(angle)), sin(radians(angle)));
  return image(uv + amount * (intensity - center) * direction);
}
