// SPDX-License-Identifier: Apache-2.0
// A camera that looks at the middle of a box from a place on a sphere around it. Yaw 0 and pitch 0
// is in front, on the +Z axis; yaw turns it to the right (+X at 90 degrees), pitch lifts it.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "runtime/mesh.h"

namespace texgraph::runtime {

struct Camera {
  double yaw = 0;                  // degrees
  double pitch = 0;                // degrees, from -90 to 90
  std::optional<double> distance;  // to the middle of the box; nothing: FramingDistance
  double field_of_view = 30;       // degrees, of the height of the picture
};

// The unit vector towards a yaw and a pitch.
glm::dvec3 Direction(double yaw, double pitch);

// The least distance at which all of the mesh is in the picture, with a twentieth of it free at
// each side. Everything of it is in front of the camera then. `box` is the mesh's.
double FramingDistance(const Mesh& mesh, const Box& box, const Camera& camera, uint32_t width,
                       uint32_t height);

struct View {
  glm::dvec3 eye;
  glm::dmat4 clip_from_object;  // as OpenGL clips: x to the right, y up, near at -1
};
// Of a camera with a distance. The planes of the depth enclose the box, the near one in front of
// the eye.
View ViewOf(const Box& box, const Camera& camera, uint32_t width, uint32_t height);

// For a square of `side` pixels of the picture, whose left bottom corner is (x, y).
glm::dmat4 TileOf(const glm::dmat4& clip_from_object, uint32_t width, uint32_t height, uint32_t x,
                  uint32_t y, uint32_t side);

}  // namespace texgraph::runtime
