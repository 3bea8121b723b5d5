// SPDX-License-Identifier: Apache-2.0
/// Draws whatever is connected with every place moved by a vector.
/// The image is looked at in uv + amount * (displacement - center), and filtered for how much it is
/// stretched there.
/// @source Substance 3D Designer, "Vector warp"
/// @param image what is drawn
/// @param uv where to look @default uv
/// @param displacement how far and where to: two noises, or red and green of a picture
/// @param amount how far a displacement of 1 moves the place that is looked at, in the units of uv
///   @default 0.05
/// @param center the displacement that moves nothing: 0.5 for numbers from 0 to 1 @default vec2(0)
genType image(vec2 uv);

genType vector_warp(vec2 uv, vec2 displacement, float amount, vec2 center) {
  return image(uv + amount * (displacement - center));
}
