// SPDX-License-Identifier: Apache-2.0
/// Lays a relief on a surface that is not flat: turns the detail's normal as the base is turned out
/// of the plane.
/// The turn is the shortest that takes (0, 0, 1) to the base, so a detail keeps its strength on
/// steep bases, where the sum of slopes of `combine_normals` would flatten it. For two layers of
/// one height field that sum is exact instead.
/// @source Barre-Brisebois and Hill, Blending in Detail, 2012, reoriented normal mapping
/// @param base normal of the surface, of length 1
/// @param detail normal of the relief on it, of length 1
/// @return of length 1
vec3 reorient_normal(vec3 base, vec3 detail) {
  // Looking straight back there is no shortest turn.
  vec3 t = vec3(base.xy, max(base.z + 1.0, 1e-4));
  vec3 u = detail * vec3(-1.0, -1.0, 1.0);
  vec3 n = t * (dot(t, u) / t.z) - u;
  return n * inversesqrt(max(dot(n, n), 1e-20));
}
