// SPDX-License-Identifier: Apache-2.0
const int RELIEF_REPLACE = 0;
const int RELIEF_ADD = 1;

/// Lays one material over another, all channels by the same share: that of the foreground's alpha.
/// Colours are composited as `over` does; roughness, metallic and height are mixed by the part that
/// the foreground has in what is seen, and so are the normals, which are then of length 1 again.
/// @source Porter and Duff, Compositing Digital Images, SIGGRAPH 1984, "over"
/// @param foreground what is laid on top
/// @param background what lies below
/// @param opacity of the foreground @default 1 @range 0 1
/// @param mask where the foreground is shown: another factor of its opacity @default 1 @range 0 1
/// @param relief what becomes of the background's height and normal: replace, the foreground has
///   its own, as a thing that lies there; add, the foreground's height and slopes are added to
///   them, as paint, a dent or a crack that follows the ground @default RELIEF_REPLACE
Material material_over(Material foreground, Material background, float opacity, float mask,
                       const int relief) {
  float front = foreground.color.a * opacity * mask;
  float alpha = mix(background.color.a, 1.0, front);
  float share = front / max(alpha, 1e-20);
  Material seen;
  seen.color = vec4(mix(background.color.rgb, foreground.color.rgb, share), alpha);
  if (relief == RELIEF_ADD) {
    seen.normal = combine_normals(background.normal, foreground.normal, share);
    seen.height = background.height + share * foreground.height;
  } else {
    vec3 n = mix(background.normal, foreground.normal, share);
    seen.normal = n * inversesqrt(max(dot(n, n), 1e-20));
    seen.height = mix(background.height, foreground.height, share);
  }
  seen.roughness = mix(background.roughness, foreground.roughness, share);
  seen.metallic = mix(background.metallic, foreground.metallic, share);
  return seen;
}
