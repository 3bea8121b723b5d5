// SPDX-License-Identifier: Apache-2.0
/// The normal of a surface with the heights that are connected, of length 1.
/// The slope is that between the two borders of the pixel, which is its mean over the pixel: no
/// detail is lost nearby, and far away the relief becomes flat as its height does. Where a pixel is
/// smaller than the smallest step, the slope is taken over that.
/// @source MaterialX 1.39, Standard Nodes, heighttonormal; Blinn, Simulation of Wrinkled Surfaces,
///   SIGGRAPH 1978
/// @param height the height, in the units of uv if `strength` is 1
/// @param uv where to look @default uv
/// @param strength how many times as high, and so as steep @default 1
/// @param smallest_step the least distance over which a slope is taken, in the units of uv; below
///   1e-5 rounding shows @default 0.0005 @range 1e-7 1
/// @return x to where u grows, y to where v grows, z out of the surface
float height(vec2 uv);

vec3 height_to_normal(vec2 uv, float strength, float smallest_step) {
  vec2 apart = max(footprint(uv), max(smallest_step, 1e-7));
  vec2 across = vec2(0.5 * apart.x, 0.0);
  vec2 along = vec2(0.0, 0.5 * apart.y);
  vec2 rise = vec2(height(uv + across) - height(uv - across),
                   height(uv + along) - height(uv - along));
  vec3 normal = vec3(-strength * rise / apart, 1.0);
  return normal * inversesqrt(dot(normal, normal));
}
