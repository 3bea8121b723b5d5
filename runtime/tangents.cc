// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "runtime/mesh.h"

namespace texgraph::runtime {
namespace {

constexpr uint32_t kNone = 0xffffffffu;

glm::dvec3 UnitOr(const glm::dvec3& v, const glm::dvec3& otherwise) {
  const double size = glm::length(v);
  return size > 1e-30 && std::isfinite(size) ? v / size : otherwise;
}

glm::dvec3 AnyAcross(const glm::dvec3& normal) {
  const glm::dvec3 axis = std::abs(normal.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return UnitOr(axis - normal * glm::dot(axis, normal), {1, 0, 0});
}

// How a texture lies on a triangle.
struct Lie {
  glm::dvec3 tangent{0};  // unit length, to where u grows; zero where uv does not vary
  int sign = 0;           // 1, -1 where it is mirrored, 0 where uv does not vary
};

Lie LieOf(const std::array<Vertex, 3>& corners) {
  const glm::dvec3 e1 = glm::dvec3(corners[1].position) - glm::dvec3(corners[0].position);
  const glm::dvec3 e2 = glm::dvec3(corners[2].position) - glm::dvec3(corners[0].position);
  const glm::dvec2 d1 = glm::dvec2(corners[1].uv) - glm::dvec2(corners[0].uv);
  const glm::dvec2 d2 = glm::dvec2(corners[2].uv) - glm::dvec2(corners[0].uv);
  const double area = d1.x * d2.y - d1.y * d2.x;
  if (area == 0 || !std::isfinite(area)) return {};
  // e = du * T + dv * B for both edges, solved for T.
  const double sign = area > 0 ? 1 : -1;
  const glm::dvec3 tangent = UnitOr((e1 * d2.y - e2 * d1.y) * sign, glm::dvec3(0));
  return {tangent, static_cast<int>(sign)};
}

double AngleAt(const std::array<Vertex, 3>& corners, size_t corner) {
  const glm::dvec3 at(corners[corner].position);
  const glm::dvec3 a = UnitOr(glm::dvec3(corners[(corner + 1) % 3].position) - at, glm::dvec3(0));
  const glm::dvec3 b = UnitOr(glm::dvec3(corners[(corner + 2) % 3].position) - at, glm::dvec3(0));
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

}  // namespace

void ComputeFlatNormals(Mesh& mesh) {
  std::vector<Vertex> vertices;
  vertices.reserve(mesh.indices.size());
  for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    std::array<Vertex, 3> corners;
    for (size_t c = 0; c < 3; ++c) corners[c] = mesh.vertices[mesh.indices[i + c]];
    const glm::dvec3 e1 = glm::dvec3(corners[1].position) - glm::dvec3(corners[0].position);
    const glm::dvec3 e2 = glm::dvec3(corners[2].position) - glm::dvec3(corners[0].position);
    const glm::dvec3 normal = UnitOr(glm::cross(e1, e2), {0, 0, 1});
    for (Vertex& corner : corners) {
      corner.normal = glm::vec3(normal);
      vertices.push_back(corner);
    }
  }
  mesh.vertices = std::move(vertices);
  for (size_t i = 0; i < mesh.indices.size(); ++i) mesh.indices[i] = static_cast<uint32_t>(i);
}

void ComputeTangents(Mesh& mesh) {
  const size_t count = mesh.vertices.size();
  std::vector<int> signs(count, 0);           // of the triangles that use a vertex; 0: none yet
  std::vector<uint32_t> twins(count, kNone);  // the double of a vertex, for the other sign
  std::vector<glm::dvec3> sums(count, glm::dvec3(0));
  for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    std::array<Vertex, 3> corners;
    for (size_t c = 0; c < 3; ++c) corners[c] = mesh.vertices[mesh.indices[i + c]];
    const Lie lie = LieOf(corners);
    if (lie.sign == 0) continue;
    for (size_t c = 0; c < 3; ++c) {
      uint32_t& index = mesh.indices[i + c];
      if (signs[index] == 0) signs[index] = lie.sign;
      if (signs[index] != lie.sign) {
        if (twins[index] == kNone) {
          twins[index] = static_cast<uint32_t>(mesh.vertices.size());
          mesh.vertices.push_back(corners[c]);
          signs.push_back(lie.sign);
          twins.push_back(kNone);
          sums.push_back(glm::dvec3(0));
        }
        index = twins[index];
      }
      sums[index] += lie.tangent * AngleAt(corners, c);
    }
  }
  for (size_t i = 0; i < mesh.vertices.size(); ++i) {
    const glm::dvec3 normal(mesh.vertices[i].normal);
    const glm::dvec3 along = sums[i] - normal * glm::dot(sums[i], normal);
    const glm::dvec3 tangent = glm::length(along) > 1e-6 * glm::length(sums[i])
                                   ? UnitOr(along, AnyAcross(normal))
                                   : AnyAcross(normal);
    mesh.vertices[i].tangent = glm::vec4(glm::vec3(tangent), signs[i] < 0 ? -1.0f : 1.0f);
  }
}

}  // namespace texgraph::runtime
