// SPDX-License-Identifier: Apache-2.0
/// A flow in the plane without sources and sinks, around the hills of a height: smoke, water, hair.
/// (dh/dy, -dh/dx), by central differences: a port knows values, and what the compiler knows of
/// them is their change along the screen, from which that along u and v does not follow where a
/// surface is seen from its edge. They are as wide as a pixel, so what is finer than that fades.
/// @source Bridson, Hourihan and Nordenstam, Curl-Noise for Procedural Fluid Flow, SIGGRAPH 2007
/// @param potential the height: the stream flows along its contour lines, with higher ground on its
///   right
/// @param uv coordinate @default uv
/// @param least how far from the place the height is looked up, at least; much smaller than the
///   details, much larger than what a float's rounding makes @default 0.001 @range 1e-6 1
/// @return how fast it flows, in each direction: the steepest slope is the fastest
float potential(vec2 uv);

vec2 curl(vec2 uv, float least) {
  vec2 way = max(0.5 * footprint(uv), least);
  float rise_x = potential(uv + vec2(way.x, 0.0)) - potential(uv - vec2(way.x, 0.0));
  float rise_y = potential(uv + vec2(0.0, way.y)) - potential(uv - vec2(0.0, way.y));
  return vec2(rise_y, -rise_x) * 0.5 / way.yx;
}
