// SPDX-License-Identifier: Apache-2.0
/// How much a surface with the heights that are connected bulges: where edges are worn, where dirt
/// collects.
/// The mean curvature times a radius: 1 on a ball of that radius, -1 in a bowl, 0 where it is flat
/// or a saddle, 0.5 on a cylinder. It is taken between nine heights that are a step apart, each
/// with a pixel as large as the step. Slopes steeper than 1e4 count as 1e4.
/// @source do Carmo, Differential Geometry of Curves and Surfaces, section 3-3, mean curvature of a
///   graph
/// @param height the height, in the units of uv if `strength` is 1
/// @param uv where to look @default uv
/// @param radius the radius of the ball for which the result is 1, in the units of uv @default 0.05
/// @param strength how many times as high the surface is @default 1
/// @param smallest_step the least distance between the heights, in the units of uv; bulges that are
///   smaller are not seen; with less, rounding would show @default 0.005 @range 0.001 1
/// @return above 0 outward, edges; below 0 inward, grooves
float height(vec2 uv);

float curvature(vec2 uv, float radius, float strength, float smallest_step) {
  vec2 apart = max(footprint(uv), max(smallest_step, 1e-5));
  vec2 x = vec2(apart.x, 0.0);
  vec2 y = vec2(0.0, apart.y);
  float middle = height(widen(uv, apart, uv));
  float east = height(widen(uv + x, apart, uv)) - middle;
  float west = height(widen(uv - x, apart, uv)) - middle;
  float north = height(widen(uv + y, apart, uv)) - middle;
  float south = height(widen(uv - y, apart, uv)) - middle;
  float twist = height(widen(uv + x + y, apart, uv)) - height(widen(uv + x - y, apart, uv)) -
                height(widen(uv - x + y, apart, uv)) + height(widen(uv - x - y, apart, uv));
  // First and second derivatives.
  vec2 slope = 0.5 * strength * vec2(east - west, north - south) / apart;
  slope = clamp(slope, -1e4, 1e4);
  vec2 bend = strength * vec2(east + west, north + south) / (apart * apart);
  float shear = 0.25 * strength * twist / (apart.x * apart.y);
  float root = 1.0 + dot(slope, slope);
  vec2 part = (1.0 + slope * slope) / root;
  float sum = part.y * bend.x + part.x * bend.y - 2.0 * (slope.x * slope.y / root) * shear;
  return -0.5 * radius * sum * inversesqrt(root);
}
