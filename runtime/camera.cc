// SPDX-License-Identifier: Apache-2.0
#include "runtime/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace texgraph::runtime {
namespace {

constexpr double kFree = 0.9;  // of a side of the picture that the box may take
// Of a mesh that is a single point, so that there is something to look at.
constexpr double kLeastRadius = 1e-6;

glm::dvec3 Middle(const Box& box) { return 0.5 * (box.low + box.high); }

double Radius(const Box& box) {
  return std::max(0.5 * glm::length(box.high - box.low), kLeastRadius);
}

// Axes of the camera: to the right, up, and from the box to the eye. They are well defined when it
// looks straight down, too.
struct Axes {
  glm::dvec3 right, up, back;
};
Axes AxesOf(const Camera& camera) {
  const double yaw = glm::radians(camera.yaw);
  Axes axes;
  axes.right = {std::cos(yaw), 0, -std::sin(yaw)};
  axes.back = Direction(camera.yaw, camera.pitch);
  axes.up = glm::cross(axes.back, axes.right);
  return axes;
}

}  // namespace

glm::dvec3 Direction(double yaw, double pitch) {
  const double a = glm::radians(yaw);
  const double b = glm::radians(pitch);
  return {std::sin(a) * std::cos(b), std::sin(b), std::cos(a) * std::cos(b)};
}

double FramingDistance(const Mesh& mesh, const Box& box, const Camera& camera, uint32_t width,
                       uint32_t height) {
  const Axes axes = AxesOf(camera);
  const double slope_y = std::tan(glm::radians(camera.field_of_view) / 2) * kFree;
  const double slope_x = slope_y * width / height;
  const glm::dvec3 middle = Middle(box);
  const double margin = Radius(box) * 1e-3;
  double distance = 0;
  for (const Vertex& vertex : mesh.vertices) {
    const glm::dvec3 offset = glm::dvec3(vertex.position) - middle;
    const double towards = glm::dot(offset, axes.back);
    distance = std::max({distance, towards + std::abs(glm::dot(offset, axes.right)) / slope_x,
                         towards + std::abs(glm::dot(offset, axes.up)) / slope_y});
  }
  return distance + margin;
}

View ViewOf(const Box& box, const Camera& camera, uint32_t width, uint32_t height) {
  const Axes axes = AxesOf(camera);
  const double distance = camera.distance.value_or(0);
  const double radius = Radius(box);
  View view;
  view.eye = Middle(box) + axes.back * distance;
  const double near = std::max(distance - 1.01 * radius, 1e-3 * std::min(distance, radius));
  const double far = std::max(distance + 1.01 * radius, 2 * near);
  const glm::dmat4 clip = glm::perspectiveRH_NO(glm::radians(camera.field_of_view),
                                                static_cast<double>(width) / height, near, far);
  glm::dmat4 turn(1);  // its rows are the axes
  for (int i = 0; i < 3; ++i) {
    turn[i][0] = axes.right[i];
    turn[i][1] = axes.up[i];
    turn[i][2] = axes.back[i];
  }
  view.clip_from_object = clip * turn * glm::translate(glm::dmat4(1), -view.eye);
  return view;
}

glm::dmat4 TileOf(const glm::dmat4& clip_from_object, uint32_t width, uint32_t height, uint32_t x,
                  uint32_t y, uint32_t side) {
  const double s = side;
  glm::dmat4 tile(1);
  tile[0][0] = width / s;
  tile[1][1] = height / s;
  tile[3][0] = (width - 2.0 * x) / s - 1;
  tile[3][1] = (height - 2.0 * y) / s - 1;
  return tile * clip_from_object;
}

}  // namespace texgraph::runtime
