// SPDX-License-Identifier: Apache-2.0
/// Makes a colour transparent where it is like a key colour, such as a picture's black background.
/// Alpha is multiplied by 0 within the tolerance, by 1 beyond tolerance and softness, and rises
/// evenly between. Red, green and blue stay as they are.
/// This keys a colour that is already sampled, and that makes fringes: at the rim of what is shown
/// the filter has mixed in the background, so the rim has some of the key's colour, and far away,
/// where a texel holds both, it is keyed whole or not at all. Where the colour comes straight from
/// a picture, give its texture a "key" in the graph: that keys the picture itself, before its mip
/// levels are made. There, distances are those of the picture's own numbers.
/// Distances are those of linear light, where dark colours lie close together: in one component,
/// the sRGB values 0 and 25 of 255 are 0.01 apart, 230 and 255 are 0.2 apart.
/// @param color straight alpha
/// @param key the colour that disappears @default vec3(0)
/// @param tolerance the distance from the key, as the root of the squared differences of red, green
///   and blue, up to which it is transparent @default 0.01 @range 0 2
/// @param softness the distance over which it becomes opaque; at 0 it does so at once
///   @default 0.02 @range 0 2
vec4 color_key(vec4 color, vec3 key, float tolerance, float softness) {
  float distance_beyond = distance(color.rgb, key) - tolerance;
  return vec4(color.rgb, color.a * clamp(distance_beyond / max(softness, 1e-7), 0.0, 1.0));
}
