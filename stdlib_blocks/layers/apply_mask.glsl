// SPDX-License-Identifier: Apache-2.0
/// Shows a colour only where a mask says so: its alpha is multiplied by the mask.
/// A mask is a share of area, a plain number: it must not come from a picture that is declared
/// sRGB. Red, green and blue are linear light, and stay as they are while alpha is straight.
/// @source Porter and Duff, Compositing Digital Images, SIGGRAPH 1984, "in"
/// @param color the colour
/// @param mask where it is shown, 1, and where not, 0 @range 0 1
/// @param invert shows it where the mask is 0 instead @default false
/// @param alpha of the colour and of the result: straight, or premultiplied, where the mask
///   multiplies red, green and blue as well @default ALPHA_STRAIGHT
vec4 apply_mask(vec4 color, float mask, const bool invert, const int alpha) {
  float shown = invert ? 1.0 - mask : mask;
  return alpha == ALPHA_PREMULTIPLIED ? color * shown : vec4(color.rgb, color.a * shown);
}
