// SPDX-License-Identifier: Apache-2.0
// The level of a mip map whose texels are as large as a pixel, for changes of the place in texels.
float level_of(float right, float up) { return max(0.5 * log2(max(max(right, up), 1e-12)), 0.0); }

/// One of several patterns, in a tile: the colour that the pattern has where the point is in the
/// tile.
/// Patterns are the layers of an array, so that neither the filter nor a mip level mixes two of
/// them. Far away a pattern is the mean of its own; with the keys `weights` and `edges` of the
/// texture the coarse levels go on to the mean of all, and no border shows.
/// @source Lefebvre and Neyret, Pattern Based Procedural Textures, 2003, section 3.2, Reference
///   Texture, and section 5, which leaves the filtering open
/// @param patterns the patterns, a layer each; the texture should repeat ("wrap")
/// @param tile where it is drawn
/// @param pattern which pattern, from 0; below 0 there is none, transparent black. Beyond the last
///   it is the last @below patterns
vec4 reference_texture(sampler2DArray patterns, Tile tile, int pattern) {
  vec4 color = texture(patterns, vec3(tile.local, pattern));
  return pattern < 0 ? vec4(0.0) : color;
}

/// Patterns of a line are the rows v = 0.5 of the layers.
/// @param patterns the patterns, a layer each; the texture should repeat ("wrap")
/// @param tile where it is drawn
/// @param pattern which pattern, from 0; below 0 there is none, transparent black. Beyond the last
///   it is the last @below patterns
vec4 reference_texture(sampler2DArray patterns, Tile1 tile, int pattern) {
  vec4 color = texture(patterns, vec3(tile.local, 0.5, pattern));
  return pattern < 0 ? vec4(0.0) : color;
}

/// In an atlas, one picture with the patterns side by side, the place is kept so far from the
/// pattern's border that no texel of another pattern has a weight, in whatever level. That leaves
/// a border of half a texel where two patterns meet, as the array has not.
/// @param patterns the patterns in columns and rows, from the left upper corner, row by row. Its
///   coarsest level has at least one texel a pattern, and none mixes patterns
/// @param tile where it is drawn
/// @param pattern which pattern, from 0; below 0 there is none, transparent black. Beyond the last
///   it is the last @below grid
/// @param grid columns and rows of patterns; of a texture with the key `pack` they are known
///   @grid_of patterns @range 1 4096
vec4 reference_texture(sampler2D patterns, Tile tile, int pattern, const ivec2 grid) {
  ivec2 texels = textureSize(patterns, 0) / grid;
  // Halving a pattern goes on while its sides are even.
  ivec2 even = texels & -texels;
  vec2 right = footprint_x(tile.local) * vec2(texels);
  vec2 up = footprint_y(tile.local) * vec2(texels);
  float level = min(level_of(dot(right, right), dot(up, up)), log2(float(min(even.x, even.y))));
  vec2 border = min(0.5 * exp2(ceil(level)) / vec2(texels), 0.5);
  int which = clamp(pattern, 0, grid.x * grid.y - 1);
  vec2 corner = vec2(which % grid.x, grid.y - 1 - which / grid.x);
  vec2 place = (corner + clamp(tile.local, border, 1.0 - border)) / vec2(grid);
  vec4 color = textureLod(patterns, place, level);
  return pattern < 0 ? vec4(0.0) : color;
}

/// Patterns that fill space are blocks of equally many slices of a volume, from w = 0 up.
/// @param patterns the patterns, one upon the other; the texture should repeat ("wrap")
/// @param tile where it is drawn
/// @param pattern which pattern, from 0; below 0 there is none, transparent black. Beyond the last
///   it is the last @below patterns_count
/// @param patterns_count how many patterns there are @default 1 @range 1 2048
vec4 reference_texture(sampler3D patterns, Tile3 tile, int pattern, const int patterns_count) {
  if (patterns_count == 1) {
    vec4 whole = texture(patterns, tile.local);
    return pattern < 0 ? vec4(0.0) : whole;
  }
  ivec3 texels = textureSize(patterns, 0) / ivec3(1, 1, patterns_count);
  vec3 right = footprint_x(tile.local) * vec3(texels);
  vec3 up = footprint_y(tile.local) * vec3(texels);
  float level = min(level_of(dot(right, right), dot(up, up)), log2(float(texels.z & -texels.z)));
  float border = min(0.5 * exp2(ceil(level)) / float(texels.z), 0.5);
  int which = clamp(pattern, 0, patterns_count - 1);
  float depth = float(which) + clamp(tile.local.z, border, 1.0 - border);
  vec3 place = vec3(tile.local.xy, depth / float(patterns_count));
  vec4 color = textureLod(patterns, place, level);
  return pattern < 0 ? vec4(0.0) : color;
}
