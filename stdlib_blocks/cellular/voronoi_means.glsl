// SPDX-License-Identifier: Apache-2.0
// The means for 0, 1/2 and 1 as the inverse of the exponent: the greatest component, the straight
// line, the sum. Those of jitter 0 are integrals over the cell, the others were sampled.
vec3 polynomial(vec3 still, vec3 square, vec3 cube, vec3 fourth, float jitter) {
  return still + jitter * jitter * (square + jitter * (cube + jitter * fourth));
}

/// The mean distance from any place to the nearest point and to the second nearest, with one point
/// in each cell of a grid, at random within it: what `voronoi` goes to far away.
/// Fitted to samples of twelve metrics and jitters each in the plane and in space: off by at most
/// 0.001 for the euclidean metric, manhattan and chebyshev.
/// @param dimensions 2 for the plane, 3 for space
/// @param metric how distances are measured @default METRIC_EUCLIDEAN
/// @param exponent of the metric minkowski @default 3 @range 1 16
/// @param jitter how far points lie from the middle of their cell @default 1 @range 0 1
/// @return of the nearest, and of the second nearest, in cells
vec2 voronoi_means(const int dimensions, const int metric, const float exponent, float jitter) {
  vec3 first = polynomial(vec3(0.3333, 0.3826, 0.5), vec3(0.0862, 0.0516, -0.0132),
                          vec3(-0.0447, 0.0112, 0.1031), vec3(0.007, -0.0156, -0.0488), jitter);
  vec3 second = polynomial(vec3(0.6667, 0.6995, 0.8333), vec3(-0.142, 0.0323, 0.1821),
                           vec3(0.111, -0.0631, -0.1938), vec3(-0.0142, 0.0304, 0.0551), jitter);
  if (dimensions == 3) {
    first = polynomial(vec3(0.375, 0.4803, 0.75), vec3(0.1243, 0.0386, -0.1477),
                       vec3(-0.1062, 0.0339, 0.2922), vec3(0.0272, -0.0328, -0.1303), jitter);
    second = polynomial(vec3(0.625, 0.7027, 1.0), vec3(-0.207, 0.0841, 0.2614),
                        vec3(0.2255, -0.1247, -0.3355), vec3(-0.0648, 0.0545, 0.1248), jitter);
  }
  float at = metric == METRIC_EUCLIDEAN ? 0.5 : metric == METRIC_MANHATTAN ? 1.0 : 0.0;
  if (metric == METRIC_MINKOWSKI) {
    at = 1.0 / exponent;
  }
  // The parabola through the three.
  vec3 share = vec3((at - 0.5) * (at - 1.0) * 2.0, at * (1.0 - at) * 4.0, at * (at - 0.5) * 2.0);
  return vec2(dot(first, share), dot(second, share));
}
