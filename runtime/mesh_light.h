// SPDX-License-Identifier: Apache-2.0
// The GLSL of the light on a mesh. `$` stands for the prefix of ComposeMeshShader.
//
// The surface is that of glTF 2.0 (appendix B): GGX (Walter et al. 2007) with the height-correlated
// masking of Smith (Heitz 2014) and Fresnel's term by Schlick (1994), over Lambert. What the
// environment's reflection sums up to is Lazarov's fit as Karis gives it ("Physically based shading
// on mobile", 2014). The convolution of spherical Gaussians is that of Wang et al. 2009:
// sharpnesses add up like resistors in parallel, and the peak falls as the volume stays. Where a
// bump turns away from the surface that bears it, the key light fades as in Chiang, Li and Burley's
// "Taming the shadow terminator" (2019).
#pragma once

#include <string_view>

namespace texgraph::runtime {

inline constexpr std::string_view kMeshLight = R"(
const float $pi = 3.14159265;

uniform vec3 $eye;
uniform vec3 $key_direction;
uniform vec3 $key;
uniform vec3 $sky;
uniform vec3 $ground;
uniform vec4 $lamp_axis[3];  // and sharpness
uniform vec3 $lamp_radiance[3];

// The radiance that comes about `direction`, averaged over a lobe of this sharpness. `spread` is
// how much of the difference between sky and ground is left by that average.
vec3 $environment(vec3 direction, float sharpness, float spread) {
  vec3 light = mix($ground, $sky, 0.5 + 0.5 * spread * direction.y);
  for (int i = 0; i < 3; ++i) {
    float own = $lamp_axis[i].w;
    float both = own * sharpness / (own + sharpness);
    float aside = dot(direction, $lamp_axis[i].xyz) - 1.0;
    light += $lamp_radiance[i] * (both / own) * exp(both * aside);
  }
  return light;
}

// Microfacets: distribution times masking over 4 (n.l)(n.v).
float $facets(float alpha, float nh, float nl, float nv) {
  float a2 = alpha * alpha;
  float d = (nh * a2 - nh) * nh + 1.0;
  float masking = nl * sqrt(nv * nv * (1.0 - a2) + a2) + nv * sqrt(nl * nl * (1.0 - a2) + a2);
  return a2 / ($pi * d * d) * 0.5 / max(masking, 1e-6);
}

// How much of the light that a bump faces passes the smooth surface: all, if their normals are the
// same. Cosines of the light to either normal, and between them.
float $terminator(float nl, float smooth_nl, float both) {
  float g = clamp(smooth_nl / max(nl * both, 1e-6), 0.0, 1.0);
  return ((1.0 - g) * g + 1.0) * g;
}

vec3 $shade(vec3 base, float metallic, float roughness, vec3 n, vec3 smooth_n, vec3 position) {
  vec3 v = normalize($eye - position);
  vec3 l = $key_direction;
  vec3 h = normalize(l + v);
  float nv = max(abs(dot(n, v)), 1e-4);
  float nl = clamp(dot(n, l), 0.0, 1.0);
  float nh = clamp(dot(n, h), 0.0, 1.0);
  float vh = clamp(dot(v, h), 0.0, 1.0);
  float alpha = roughness * roughness;
  vec3 f0 = mix(vec3(0.04), base, metallic);
  vec3 diffuse = base * (1.0 - metallic);

  vec3 fresnel = f0 + (1.0 - f0) * pow(1.0 - vh, 5.0);
  // The key light's irradiance is pi times $key.
  float passed = nl * $terminator(nl, dot(smooth_n, l), clamp(dot(n, smooth_n), 0.0, 1.0));
  vec3 light = $key * passed *
               ((1.0 - fresnel) * diffuse + fresnel * ($pi * $facets(alpha, nh, nl, nv)));

  vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
  float a = min(r.x * r.x, exp2(-9.28 * nv)) * r.x + r.y;
  vec2 scale = vec2(-1.04, 1.04) * a + r.zw;
  vec3 reflected = f0 * scale.x + scale.y;
  // The cosine as a lobe has the sharpness 2.13; of what varies with height it leaves 2/3.
  light += diffuse * (1.0 - reflected) * $environment(n, 2.13, 2.0 / 3.0);
  float lobe = 2.0 / (alpha * alpha);
  light += reflected * $environment(reflect(-v, n), lobe / (4.0 * nv), 1.0 - alpha / 3.0);
  return light;
}

// The normal in object space of one in the texture's: x along u, y along v, z out of the surface.
vec3 $from_texture(vec3 across, vec3 normal, vec4 tangent) {
  vec3 along = normalize(tangent.xyz - normal * dot(tangent.xyz, normal));
  vec3 up = cross(normal, along) * tangent.w;
  vec3 n = across.x * along + across.y * up + across.z * normal;
  float size = length(n);
  return size > 1e-6 ? n / size : normal;
}

// A height's own normal, in the texture's space, by its differences to the neighbouring samples.
vec3 $from_height(float height, vec2 uv) {
  vec2 dx = dFdx(uv), dy = dFdy(uv);
  float hx = dFdx(height), hy = dFdy(height);
  float area = dx.x * dy.y - dx.y * dy.x;
  if (abs(area) < 1e-20) return vec3(0.0, 0.0, 1.0);
  return normalize(vec3(vec2(hy * dx.y - hx * dy.y, hx * dy.x - hy * dx.x) / area, 1.0));
}

// Opacity as covered samples: the higher it is the more of a pixel's are drawn. Back sides take
// them in the order of the reversed bits, so that any first n and any first m samples of the two
// orders share n m / 16, to the nearest: what is inside shows through as it should, without noise.
const int $order[16] = int[16](0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5);
bool $is_covered(float opacity, int side) {
  if (side == 1) return opacity >= 0.5;
  ivec2 p = ivec2(gl_FragCoord.xy) % side;
  int step = $order[(p.y % 4) * 4 + p.x % 4];
  if (!gl_FrontFacing)
    step = ((step & 1) << 3) | ((step & 2) << 1) | ((step & 4) >> 1) | ((step & 8) >> 3);
  return opacity * 16.0 > float(step) + 0.5;
}
)";

}  // namespace texgraph::runtime
