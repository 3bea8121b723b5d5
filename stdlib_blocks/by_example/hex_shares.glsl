// SPDX-License-Identifier: Apache-2.0
/// The three hexagons of `hex_tiling` that are around a point, and the share of each in what is
/// seen there.
/// The middles of hexagons are the corners of triangles; a point is in one of them. The shares are
/// its barycentric coordinates b there to a power: (b / max b)^exponent - 0.01, where that is above
/// 0, divided by their sum. So hexagons of which next to nothing would be seen have a share of
/// exactly 0, and nothing jumps.
/// @source Heitz and Neyret, High-Performance By-Example Noise using a Histogram-Preserving
///   Blending Operator, HPG 2018, section 4 (the triangles); Mikkelsen, Practical Real-Time
///   Hex-Tiling, JCGT 11(2), 2022 (the power)
/// @param place the point, in columns and rows of hexagons
/// @param exponent as of `hex_tiling` @default 7 @range 1 64
/// @param shares their sum is 1
/// @param first column and row of the first; odd rows are moved to the right by half a hexagon
/// @param second column and row of the second
/// @param third column and row of the third
void hex_shares(vec2 place, float exponent, out vec3 shares, out ivec2 first, out ivec2 second,
                out ivec2 third) {
  // Along slanted lines that rise to the right, the first of these is constant.
  vec2 skewed = vec2(place.x - 0.5 * place.y, place.y);
  vec2 corner = floor(skewed);
  vec2 b = skewed - corner;
  float rest = 1.0 - b.x - b.y;
  // Of each rhomb of four corners there is an upper triangle and a lower one.
  int upper = rest > 0.0 ? 0 : 1;
  vec3 near = upper == 1 ? vec3(-rest, 1.0 - b.y, 1.0 - b.x) : vec3(rest, b.y, b.x);
  ivec2 base = ivec2(corner);
  first = base + upper;
  second = base + ivec2(upper, 1 - upper);
  third = base + ivec2(1 - upper, upper);
  // Halves are rounded down below zero, too.
  first.x += first.y >> 1;
  second.x += second.y >> 1;
  third.x += third.y >> 1;
  float most = max(near.x, max(near.y, near.z));
  shares = max(pow(near / most, vec3(exponent)) - 0.01, 0.0);
  shares /= shares.x + shares.y + shares.z;
}
