// SPDX-License-Identifier: Apache-2.0
/// The distance from a crescent, a disc without what is in another one; below 0 inside.
/// It is exact inside and outside, where `sdf_difference` of two circles is so only inside.
/// @source Substance 3D Designer, "Shape", crescent
/// @param uv coordinate @default uv
/// @param center middle of the disc @default vec2(0.5)
/// @param radius radius of the disc @default 0.4
/// @param cut where the middle of the disc that is taken away is, from the middle; not (0, 0)
///   @default vec2(0.2, 0)
/// @param cut_radius its radius @default 0.35
float sdf_moon(vec2 uv, vec2 center, float radius, vec2 cut, float cut_radius) {
  vec2 p = uv - center;
  vec2 q = p - cut;
  float from_middle = length(p);
  float from_cut = length(q);
  float outer = from_middle - radius;
  float inner = cut_radius - from_cut;
  float side = max(outer, inner) < 0.0 ? -1.0 : 1.0;

  // The tips, where the circles meet; the nearer one is on the side of p.
  float apart = max(length(cut), 1e-20);
  vec2 along = cut / apart;
  float foot = 0.5 * (apart + (radius * radius - cut_radius * cut_radius) / apart);
  float half_chord = radius * radius - foot * foot;
  float beside = p.y * along.x - p.x * along.y;
  vec2 tip = vec2(foot, sqrt(max(half_chord, 0.0)) * (beside < 0.0 ? -1.0 : 1.0));
  float nearest = half_chord < 0.0 ? 1e20 : distance(vec2(dot(p, along), beside), tip);

  // The arcs, where the nearest point of the circle is on the arc.
  float to_outer = outer * (outer < 0.0 ? -1.0 : 1.0);
  float to_inner = inner * (inner < 0.0 ? -1.0 : 1.0);
  vec2 on_outer = p * (radius / max(from_middle, 1e-20));
  vec2 on_inner = cut + q * (cut_radius / max(from_cut, 1e-20));
  if (to_outer < nearest && distance(on_outer, cut) > cut_radius) {
    nearest = to_outer;
  }
  if (to_inner < nearest && length(on_inner) < radius) {
    nearest = to_inner;
  }
  return side * nearest;
}
