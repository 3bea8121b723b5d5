// SPDX-License-Identifier: Apache-2.0
/// Varies a colour from tile to tile: its hue is turned, and its saturation and value are
/// multiplied, by numbers evenly spread between limits.
/// Connected to the colour of a layer's picture, it gives each element a tint of its own. As
/// `hsv_adjust` it works on linear light: values from 0.5 to 2 run from half the light to twice
/// that.
/// @source the brick shader generator, section 3.1: parameters with a minimum and a maximum
/// @param tile the tile
/// @param color what is varied, linear light, not negative; alpha, straight, stays
/// @param hue least and greatest turn of the hue @default vec2(0) @unit degrees @ordered
/// @param saturation least and greatest factor of the saturation @default vec2(1) @range 0 1000
///   @ordered
/// @param value least and greatest factor of the value @default vec2(1) @range 0 1000 @ordered
/// @param stream blocks with different streams vary independently of each other @default 0
vec3 tile_random_hsv(Tile tile, vec3 color, vec2 hue, vec2 saturation, vec2 value, int stream) {
  vec3 luck = random3(tile.seed, stream);
  return hsv_adjust(color, mix(hue.x, hue.y, luck.x), mix(saturation.x, saturation.y, luck.y),
                    mix(value.x, value.y, luck.z));
}

/// @param tile the tile
/// @param color what is varied, linear light, not negative; alpha, straight, stays
/// @param hue least and greatest turn of the hue @default vec2(0) @unit degrees @ordered
/// @param saturation least and greatest factor of the saturation @default vec2(1) @range 0 1000
///   @ordered
/// @param value least and greatest factor of the value @default vec2(1) @range 0 1000 @ordered
/// @param stream blocks with different streams vary independently of each other @default 0
vec4 tile_random_hsv(Tile tile, vec4 color, vec2 hue, vec2 saturation, vec2 value, int stream) {
  vec3 luck = random3(tile.seed, stream);
  return hsv_adjust(color, mix(hue.x, hue.y, luck.x), mix(saturation.x, saturation.y, luck.y),
                    mix(value.x, value.y, luck.z));
}
