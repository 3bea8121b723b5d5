// SPDX-License-Identifier: Apache-2.0
/// A flow in space without sources and sinks, from three noises: smoke, fire, swarms.
/// The curl of `potential` by central differences, which are as wide as a pixel; see `curl`.
/// @source Bridson, Hourihan and Nordenstam, Curl-Noise for Procedural Fluid Flow, SIGGRAPH 2007
/// @param potential three numbers that have nothing in common: noises of three seeds, for example
/// @param uv coordinate @default position
/// @param least how far from the place the potential is looked up, at least; much smaller than the
///   details, much larger than what a float's rounding makes @default 0.001 @range 1e-6 1
/// @return how fast it flows, in each direction
vec3 potential(vec3 uv);

vec3 curl3(vec3 uv, float least) {
  vec3 way = max(0.5 * footprint(uv), least);
  vec3 x = vec3(way.x, 0.0, 0.0);
  vec3 y = vec3(0.0, way.y, 0.0);
  vec3 z = vec3(0.0, 0.0, way.z);
  vec3 along_x = (potential(uv + x) - potential(uv - x)) * 0.5 / way.x;
  vec3 along_y = (potential(uv + y) - potential(uv - y)) * 0.5 / way.y;
  vec3 along_z = (potential(uv + z) - potential(uv - z)) * 0.5 / way.z;
  return vec3(along_y.z - along_z.y, along_z.x - along_x.z, along_x.y - along_y.x);
}
