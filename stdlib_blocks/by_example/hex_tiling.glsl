// SPDX-License-Identifier: Apache-2.0
// The light of a colour, and back; of what has no alpha both are the value itself.
float light(float value) { return value; }
vec2 light(vec2 value) { return value; }
vec3 light(vec3 value) { return value; }
vec4 light(vec4 value) { return vec4(value.rgb * value.a, value.a); }
float straight(float value) { return value; }
vec2 straight(vec2 value) { return value; }
vec3 straight(vec3 value) { return value; }
vec4 straight(vec4 value) { return vec4(value.rgb / max(value.a, 1e-20), value.a); }
float lightness(float value) { return value; }
float lightness(vec2 value) { return 0.5 * (value.x + value.y); }
float lightness(vec3 value) { return luminance(value); }
float lightness(vec4 value) { return luminance(value); }

/// Covers the surface with a picture so that it is not seen to repeat: every hexagon of a grid
/// shows another part of it, turned at random, and passes softly into its neighbours.
/// For pictures of what has no order, as grass, gravel or bark, in any size; nothing is prepared. A
/// point takes at most three samples, of the hexagons around it, and 1.57 in the mean with the
/// default exponent: hexagons of which next to nothing would be seen are not asked. A mean of
/// several samples has less contrast than one; so transitions are short (`exponent`), and bright
/// hexagons count more than dark ones (`contrast`). The same in all places gives the same.
/// @source Mikkelsen, Practical Real-Time Hex-Tiling, JCGT 11(2), 2022; in place of its hash by
///   sines an integer hash, and hexagons without weight are left out
/// @param image the picture, repeated: `image` with a texture that repeats, or a function of the
///   graph. That may take `tile` as well, the hexagon, to vary something else with it. Straight
///   alpha
/// @param weight another factor of a sample's weight at a place of the picture: its height, say, so
///   that where two hexagons meet stones stay whole. Given to `hex_tiling_normal` as well, with
///   `contrast` 0 in both, it makes both show the same stones @default 1
/// @param uv coordinate @default uv
/// @param tiling how often the picture stands side by side in each unit of the coordinate, across
///   and up; hexagons are as much smaller @default vec2(1)
/// @param scale columns of hexagons in the width of a picture, and rows in its height. They are
///   regular where there are 2 / sqrt(3) = 1.1547 times as many rows as columns, else stretched.
///   Fewer keep larger things whole, and show more of a picture at a time @default vec2(3.5, 4)
/// @param rotation least and greatest angle, counter-clockwise. Where the picture has shadows, or
///   lies along something, a small range is right @default vec2(-180, 180) @unit degrees @ordered
/// @param offset how far the picture is moved at random, across and up, in pictures: 1, anywhere;
///   0, not at all @default vec2(1)
/// @param contrast how much the weight of a sample depends on its lightness: 0, not at all, and the
///   mean colour is kept exactly; 1, black weighs next to nothing @default 0.6 @range 0 1
/// @param exponent how short transitions are: the power of the barycentric coordinates. With 4 a
///   point takes 1.97 samples in the mean, with 7 1.57, with 16 1.25 @default 7 @range 1 64
/// @param period after how many hexagons all repeats, columns and rows; 0 never. An odd number of
///   rows becomes the next even one. With tiling times scale as period, the unit square repeats
///   @default ivec2(0) @range 0 65536
/// @param seed another seed gives another plane @default 0
genType image(vec2 uv, Tile tile);
float weight(vec2 uv, Tile tile);

genType hex_tiling(vec2 uv, vec2 tiling, vec2 scale, vec2 rotation, vec2 offset, float contrast,
                   float exponent, const ivec2 period, int seed) {
  vec2 cells = tiling * scale;
  vec3 shares;
  ivec2 first;
  ivec2 second;
  ivec2 third;
  hex_shares(uv * cells, exponent, shares, first, second, third);
  genType sum = genType(0.0);
  float total = 0.0;
  for (int i = 0; i < 3; ++i) {
    if (shares[i] > 0.0) {
      Tile tile;
      vec2 place;
      hex_frame(uv, cells, i == 0 ? first : i == 1 ? second : third, rotation, period, seed, tile,
                place);
      place = place * tiling + offset * random2(tile.seed, -1);
      genType seen = light(image(place, tile));
      float own = weight(place, tile) * mix(1.0, lightness(seen), contrast);
      float share = shares[i] * max(own, 0.001);
      sum += share * seen;
      total += share;
    }
  }
  return straight(sum / total);
}
