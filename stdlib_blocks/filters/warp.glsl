// SPDX-License-Identifier: Apache-2.0
/// Draws whatever is connected as if it flowed up or down the slopes of a height.
/// The image is looked at in uv + amount * slope, and filtered for how much it is stretched there.
/// The slope is the mean over the pixel, or over the smallest step if that is larger.
/// @source Substance 3D Designer and Material Maker, "Warp"
/// @param image what is drawn
/// @param height the height whose slopes move it
/// @param uv where to look @default uv
/// @param amount how far a slope of 1 moves the place that is looked at, in the units of uv
///   @default 0.05
/// @param smallest_step the least distance over which a slope is taken, in the units of uv
///   @default 0.0005 @range 1e-7 1
genType image(vec2 uv);
float height(vec2 uv);

genType warp(vec2 uv, float amount, float smallest_step) {
  vec2 apart = max(footprint(uv), max(smallest_step, 1e-7));
  vec2 across = vec2(0.5 * apart.x, 0.0);
  vec2 along = vec2(0.0, 0.5 * apart.y);
  vec2 rise = vec2(height(uv + across) - height(uv - across),
                   height(uv + along) - height(uv - along));
  return image(uv + amount * rise / apart);
}
