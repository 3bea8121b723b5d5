// SPDX-License-Identifier: Apache-2.0
// A graph's outputs shown on a mesh: where the camera and the lights are. All light is linear;
// docs/rendering.md says what the numbers mean.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>

#include "runtime/camera.h"
#include "runtime/mesh.h"

namespace texgraph::runtime {

// What is drawn beside the graph's own outputs: the mesh in its light.
inline constexpr std::string_view kLitOutput = "lit";

// A soft light far away: a spherical Gaussian of radiance about a direction.
struct Lamp {
  glm::dvec3 radiance{0};
  double yaw = 0;  // degrees from the camera's own yaw
  double pitch = 0;
  double sharpness = 1;  // exp(sharpness (cos angle - 1)) of the radiance is left
};

inline constexpr size_t kLampCount = 3;

// The light turns with the camera's yaw, as in a studio where the thing is turned.
struct Lighting {
  // The key light is directional. A white surface that faces it sends this radiance back.
  glm::dvec3 key{1.0, 0.96, 0.9};
  double yaw = -45;  // degrees from the camera's own yaw; negative is from the left
  double pitch = 45;
  // Light from all around: from above, from below, and a straight line between them over the
  // height of the direction.
  glm::dvec3 sky{0.20, 0.22, 0.26};
  glm::dvec3 ground{0.035, 0.03, 0.027};
  std::array<Lamp, kLampCount> lamps = {
      Lamp{{1.8, 1.8, 1.8}, -50, 50, 12},   // around the key light
      Lamp{{0.45, 0.5, 0.58}, 80, 10, 7},   // fills from the right
      Lamp{{1.6, 1.6, 1.6}, 160, 35, 14}};  // from behind, for the edges
};

struct Scene {
  std::shared_ptr<const Mesh> mesh;
  Camera camera;
  Lighting lighting;
  std::array<double, 2> tiles = {1, 1};  // how often the texture repeats where uv grows by 1
  // How high a `height` of 1 is, if there is no `normal`: in sides of the texture.
  double relief = 0.02;
  uint32_t samples = 4;                          // along each side of a pixel: 1 to kMaxSampleSide
  glm::dvec4 background{0.045, 0.047, 0.05, 1};  // linear light, straight alpha
};

inline constexpr uint32_t kMaxSampleSide = 8;

}  // namespace texgraph::runtime
