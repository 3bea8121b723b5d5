// SPDX-License-Identifier: Apache-2.0
// The colour varied by three random numbers. Where a pixel holds many tiles the numbers go to their
// means; hues that lie apart mix to a colour of less saturation there: a full circle of hues to the
// grey half way between the colour's greatest and least component.
vec3 varied(uint seed, float near, vec3 color, vec2 hue, vec2 saturation, vec2 value, int stream) {
  vec3 luck = mix(vec3(0.5), random3(seed, stream), near);
  vec3 one = hsv_adjust(color, mix(hue.x, hue.y, luck.x), mix(saturation.x, saturation.y, luck.y),
                        mix(value.x, value.y, luck.z));
  if (hue.x == hue.y) {
    return one;
  }
  float reach = min(radians(0.5 * (hue.y - hue.x)), 3.1415926);
  float left = sin(reach) / max(reach, 1e-6);
  float grey = 0.5 * (max(max(one.r, one.g), one.b) + min(min(one.r, one.g), one.b));
  return mix(mix(vec3(grey), one, left), one, near);
}

/// Varies a colour from tile to tile: its hue is turned, and its saturation and value are
/// multiplied, by numbers evenly spread between limits.
/// Connected to the colour of a layer's picture, it gives each element a tint of its own. As
/// `hsv_adjust` it works on linear light: values from 0.5 to 2 run from half the light to twice
/// that. Where a pixel holds many tiles it is their mean; see `tile_near`.
/// @source the brick shader generator, section 3.1: parameters with a minimum and a maximum
/// @param tile the tile
/// @param color what is varied, linear light, not negative; alpha, straight, stays
/// @param hue least and greatest turn of the hue @default vec2(0) @unit degrees @ordered
/// @param saturation least and greatest factor of the saturation @default vec2(1) @range 0 1000
///   @ordered
/// @param value least and greatest factor of the value @default vec2(1) @range 0 1000 @ordered
/// @param stream blocks with different streams vary independently of each other @default 0
vec3 tile_random_hsv(Tile tile, vec3 color, vec2 hue, vec2 saturation, vec2 value, int stream) {
  return varied(tile.seed, tile_near(tile), color, hue, saturation, value, stream);
}

/// @param tile the tile
/// @param color what is varied, linear light, not negative; alpha, straight, stays
/// @param hue least and greatest turn of the hue @default vec2(0) @unit degrees @ordered
/// @param saturation least and greatest factor of the saturation @default vec2(1) @range 0 1000
///   @ordered
/// @param value least and greatest factor of the value @default vec2(1) @range 0 1000 @ordered
/// @param stream blocks with different streams vary independently of each other @default 0
vec4 tile_random_hsv(Tile tile, vec4 color, vec2 hue, vec2 saturation, vec2 value, int stream) {
  float near = tile_near(tile);
  return vec4(varied(tile.seed, near, color.rgb, hue, saturation, value, stream), color.a);
}

/// @param tile the cell in space
/// @param color what is varied, linear light, not negative; alpha, straight, stays
/// @param hue least and greatest turn of the hue @default vec2(0) @unit degrees @ordered
/// @param saturation least and greatest factor of the saturation @default vec2(1) @range 0 1000
///   @ordered
/// @param value least and greatest factor of the value @default vec2(1) @range 0 1000 @ordered
/// @param stream blocks with different streams vary independently of each other @default 0
vec3 tile_random_hsv(Tile3 tile, vec3 color, vec2 hue, vec2 saturation, vec2 value, int stream) {
  return varied(tile.seed, tile_near(tile), color, hue, saturation, value, stream);
}

/// @param tile the cell in space
/// @param color what is varied, linear light, not negative; alpha, straight, stays
/// @param hue least and greatest turn of the hue @default vec2(0) @unit degrees @ordered
/// @param saturation least and greatest factor of the saturation @default vec2(1) @range 0 1000
///   @ordered
/// @param value least and greatest factor of the value @default vec2(1) @range 0 1000 @ordered
/// @param stream blocks with different streams vary independently of each other @default 0
vec4 tile_random_hsv(Tile3 tile, vec4 color, vec2 hue, vec2 saturation, vec2 value, int stream) {
  float near = tile_near(tile);
  return vec4(varied(tile.seed, near, color.rgb, hue, saturation, value, stream), color.a);
}
