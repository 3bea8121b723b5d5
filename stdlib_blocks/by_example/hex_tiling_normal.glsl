// SPDX-License-Identifier: Apache-2.0
/// The relief that belongs to a picture under `hex_tiling`: covers the surface with a normal map,
/// every hexagon with another part of it, turned at random.
/// With the same `tiling`, `scale`, `rotation`, `offset`, `period` and `seed` the hexagons are those
/// of `hex_tiling`. The normals are turned as the hexagons are, so that the light falls on all of
/// them from one side, and their slopes are mixed: those of the surface, not the colours that mean
/// them. Steep samples count more than flat ones. Slopes steeper than 100 count as 100.
/// @source Mikkelsen, Practical Real-Time Hex-Tiling, JCGT 11(2), 2022; in place of its hash by
///   sines an integer hash, and hexagons without weight are left out
/// @param normal the normal of length 1 in the picture's own frame: `normal_map` of a texture that
///   repeats, or a function of the graph. That may take `tile` as well, the hexagon
/// @param weight as of `hex_tiling` @default 1
/// @param uv coordinate @default uv
/// @param tiling as of `hex_tiling` @default vec2(1)
/// @param scale as of `hex_tiling` @default vec2(3.5, 4)
/// @param rotation as of `hex_tiling` @default vec2(-180, 180) @unit degrees @ordered
/// @param offset as of `hex_tiling` @default vec2(1)
/// @param contrast how much the weight of a sample depends on the sine of its slope: 0, not at all,
///   and the mean slope is kept exactly; 1, flat places weigh next to nothing @default 0.6
///   @range 0 1
/// @param exponent as of `hex_tiling` @default 7 @range 1 64
/// @param period as of `hex_tiling` @default ivec2(0) @range 0 65536
/// @param seed as of `hex_tiling` @default 0
/// @return of length 1, in the frame of the coordinate
vec3 normal(vec2 uv, Tile tile);
float weight(vec2 uv, Tile tile);

vec3 hex_tiling_normal(vec2 uv, vec2 tiling, vec2 scale, vec2 rotation, vec2 offset,
                       float contrast, float exponent, const ivec2 period, int seed) {
  vec2 cells = tiling * scale;
  vec3 shares;
  ivec2 first;
  ivec2 second;
  ivec2 third;
  hex_shares(uv * cells, exponent, shares, first, second, third);
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 3; ++i) {
    if (shares[i] > 0.0) {
      Tile tile;
      vec2 place;
      hex_frame(uv, cells, i == 0 ? first : i == 1 ? second : third, rotation, period, seed, tile,
                place);
      place = place * tiling + offset * random2(tile.seed, -1);
      vec3 n = normal(place, tile);
      vec2 slope = n.xy / max(n.z, 0.01);
      float square = dot(slope, slope);
      float own = weight(place, tile) * mix(1.0, sqrt(square / (1.0 + square)), contrast);
      sum += shares[i] * max(own, 0.001) * turn_normal(vec3(slope, 1.0), tile);
    }
  }
  return sum * inversesqrt(dot(sum, sum));
}
