// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "runtime/mesh.h"

namespace texgraph::runtime {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

Vertex MakeVertex(const glm::dvec3& position, const glm::dvec3& normal, const glm::dvec3& tangent,
                  const glm::dvec2& uv) {
  return {glm::vec3(position), glm::vec3(normal), glm::vec4(glm::vec3(tangent), 1.0f),
          glm::vec2(uv)};
}

// A square of side 2 with the centre `center`; `right` and `up` are where u and v grow.
void AddSquare(const glm::dvec3& center, const glm::dvec3& right, const glm::dvec3& up,
               Mesh& mesh) {
  const auto first = static_cast<uint32_t>(mesh.vertices.size());
  const glm::dvec3 normal = glm::cross(right, up);
  for (int corner = 0; corner < 4; ++corner) {
    const double u = corner % 2;
    const double v = corner / 2;
    mesh.vertices.push_back(
        MakeVertex(center + right * (2 * u - 1) + up * (2 * v - 1), normal, right, {u, v}));
  }
  for (uint32_t index : {0, 1, 3, 0, 3, 2}) mesh.indices.push_back(first + index);
}

// The triangles of a grid of columns x rows cells whose vertices stand row by row from `first` on.
void AddGrid(uint32_t first, uint32_t columns, uint32_t rows, Mesh& mesh) {
  for (uint32_t row = 0; row < rows; ++row) {
    for (uint32_t column = 0; column < columns; ++column) {
      const uint32_t a = first + row * (columns + 1) + column;
      const uint32_t c = a + columns + 1;
      for (uint32_t index : {a, a + 1, c + 1, a, c + 1, c}) mesh.indices.push_back(index);
    }
  }
}

Mesh MakeSquare(const glm::dvec3& up) {
  Mesh mesh;
  AddSquare({0, 0, 0}, {1, 0, 0}, up, mesh);
  return mesh;
}

Mesh MakeCube() {
  Mesh mesh;
  const glm::dvec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  AddSquare(z, x, y, mesh);
  AddSquare(-z, -x, y, mesh);
  AddSquare(x, -z, y, mesh);
  AddSquare(-x, z, y, mesh);
  AddSquare(y, x, -z, mesh);
  AddSquare(-y, x, z, mesh);
  return mesh;
}

// The texture goes round twice, so that it keeps its shape at the equator. The middle of a copy
// is in front, the seam at the back.
Mesh MakeSphere() {
  constexpr uint32_t kColumns = 192;
  constexpr uint32_t kRows = 96;
  Mesh mesh;
  for (uint32_t row = 0; row <= kRows; ++row) {
    const double v = static_cast<double>(row) / kRows;
    const double latitude = (v - 0.5) * kTurn / 2;
    for (uint32_t column = 0; column <= kColumns; ++column) {
      const double around = static_cast<double>(column) / kColumns;
      const double longitude = (around - 0.5) * kTurn;  // 0 in front, from left to right
      const glm::dvec3 normal(std::sin(longitude) * std::cos(latitude), std::sin(latitude),
                              std::cos(longitude) * std::cos(latitude));
      const glm::dvec3 tangent(std::cos(longitude), 0, -std::sin(longitude));
      mesh.vertices.push_back(MakeVertex(normal, normal, tangent, {2 * around - 0.5, v}));
    }
  }
  AddGrid(0, kColumns, kRows, mesh);
  return mesh;
}

void AddDisc(double y, uint32_t columns, Mesh& mesh) {
  const auto center = static_cast<uint32_t>(mesh.vertices.size());
  const double side = y > 0 ? 1 : -1;
  const glm::dvec3 normal(0, side, 0), right(1, 0, 0), up(0, 0, -side);
  mesh.vertices.push_back(MakeVertex({0, y, 0}, normal, right, {0.5, 0.5}));
  for (uint32_t column = 0; column <= columns; ++column) {
    const double angle = kTurn * column / columns;
    const double a = std::cos(angle);
    const double b = std::sin(angle);
    mesh.vertices.push_back(MakeVertex(right * a + up * b + glm::dvec3(0, y, 0), normal, right,
                                       {0.5 + 0.5 * a, 0.5 + 0.5 * b}));
  }
  for (uint32_t column = 0; column < columns; ++column) {
    for (uint32_t index : {0u, column + 1, column + 2}) mesh.indices.push_back(center + index);
  }
}

// Radius 1, height 2. Three copies of the texture go round; a disc on top and one below show one
// each.
Mesh MakeCylinder() {
  constexpr uint32_t kColumns = 192;
  Mesh mesh;
  for (uint32_t row = 0; row <= 1; ++row) {
    for (uint32_t column = 0; column <= kColumns; ++column) {
      const double around = static_cast<double>(column) / kColumns;
      const double longitude = (around - 0.5) * kTurn;
      const glm::dvec3 normal(std::sin(longitude), 0, std::cos(longitude));
      const glm::dvec3 tangent(std::cos(longitude), 0, -std::sin(longitude));
      mesh.vertices.push_back(MakeVertex(normal + glm::dvec3(0, 2.0 * row - 1, 0), normal, tangent,
                                         {3 * around - 1, row}));
    }
  }
  AddGrid(0, kColumns, 1, mesh);
  AddDisc(1, kColumns, mesh);
  AddDisc(-1, kColumns, mesh);
  return mesh;
}

}  // namespace

const std::vector<std::string_view>& ShapeNames() {
  static const std::vector<std::string_view> names = {"plane", "wall", "sphere", "cube",
                                                      "cylinder"};
  return names;
}

std::optional<Mesh> MakeShape(std::string_view name) {
  std::optional<Mesh> mesh;
  if (name == "plane") mesh = MakeSquare({0, 0, -1});
  if (name == "wall") mesh = MakeSquare({0, 1, 0});
  if (name == "sphere") mesh = MakeSphere();
  if (name == "cube") mesh = MakeCube();
  if (name == "cylinder") mesh = MakeCylinder();
  if (mesh) mesh->name = name;
  return mesh;
}

Box BoundsOf(const Mesh& mesh) {
  if (mesh.vertices.empty()) return {};
  Box box{glm::dvec3(mesh.vertices[0].position), glm::dvec3(mesh.vertices[0].position)};
  for (const Vertex& vertex : mesh.vertices) {
    box.low = glm::min(box.low, glm::dvec3(vertex.position));
    box.high = glm::max(box.high, glm::dvec3(vertex.position));
  }
  return box;
}

}  // namespace texgraph::runtime
