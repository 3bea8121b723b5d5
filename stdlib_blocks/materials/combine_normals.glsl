// SPDX-License-Identifier: Apache-2.0
/// Adds a relief to another: the normal of two heights' sum, of length 1.
/// The slopes are added, which is exact for heights. Slopes steeper than 100 count as 100.
/// @param base normal of the first relief
/// @param detail normal of the second
/// @param strength how many times as steep the second is made; 0 leaves the first @default 1
vec3 combine_normals(vec3 base, vec3 detail, float strength) {
  vec3 n = vec3(base.xy / max(base.z, 0.01) + strength * detail.xy / max(detail.z, 0.01), 1.0);
  return n * inversesqrt(dot(n, n));
}
