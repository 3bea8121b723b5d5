// SPDX-License-Identifier: Apache-2.0
int dimensions(float v) { return 1; }
int dimensions(vec2 v) { return 2; }
int dimensions(vec3 v) { return 3; }
int dimensions(vec4 v) { return 4; }

// As many of the numbers as `v` has.
float first(float v, vec4 numbers) { return numbers.x; }
vec2 first(vec2 v, vec4 numbers) { return numbers.xy; }
vec3 first(vec3 v, vec4 numbers) { return numbers.xyz; }
vec4 first(vec4 v, vec4 numbers) { return numbers; }

/// Moves a coordinate by a noise, so that what is drawn there flows and folds, as in marble and
/// agate: give the result to the `uv` of any block.
/// The derivative of the warped coordinate is known, so textures and noises that are read there are
/// filtered for it.
/// @source Quilez, Domain Warping, 2002; Musgrave, in Ebert et al., Texturing and Modeling, 3rd
///   edition, chapter 15, "Domain distortion"
/// @param noise how far, from 0 to 1 with the mean 0.5; it is asked once for each direction, at
///   places far from each other. A function of the graph may take `axis` as well: which direction
/// @param uv the coordinate @default uv
/// @param amount how far it is moved at most, in each direction @default 0.1
/// @param steps how many times: each step looks up the noise at the place of the one before
///   @default 1 @range 1 8
/// @return the coordinate to draw with
float noise(genType uv, int axis);

genType domain_warp(genType uv, genType amount, const int steps) {
  genType place = uv;
  for (int i = 0; i < steps; ++i) {
    vec4 way = vec4(noise(place, 0));
    if (dimensions(uv) > 1) {
      way.y = noise(place + 37.7, 1);
    }
    if (dimensions(uv) > 2) {
      way.z = noise(place + 75.4, 2);
    }
    if (dimensions(uv) > 3) {
      way.w = noise(place + 113.1, 3);
    }
    place = uv + amount * (2.0 * first(uv, way) - 1.0);
  }
  return place;
}
