// SPDX-License-Identifier: Apache-2.0
// A surface of triangles to show a texture on. Up is +Y and the front looks along +Z, as in glTF.
// In texture space u goes to the right of a picture and v up it, as everywhere in texgraph; the
// tangent points to where u grows, and cross(normal, tangent) * handedness to where v does.
// Triangles are counter-clockwise seen from outside.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/base/diagnostics.h"

namespace texgraph::runtime {

inline constexpr size_t kMaxMeshBytes = size_t{256} << 20;  // of a file
inline constexpr size_t kMaxTriangles = size_t{1} << 22;    // after all nodes have placed theirs

struct Vertex {
  glm::vec3 position{0};
  glm::vec3 normal{0, 0, 1};      // unit length
  glm::vec4 tangent{1, 0, 0, 1};  // unit length, at right angles to the normal; w is 1, or -1 where
                                  // the texture is mirrored
  glm::vec2 uv{0};
};
static_assert(sizeof(Vertex) == 12 * sizeof(float));

struct Mesh {
  std::string name;
  std::vector<Vertex> vertices;
  std::vector<uint32_t> indices;  // three for each triangle, all below vertices.size()
};

// What all vertices lie between.
struct Box {
  glm::dvec3 low{0};
  glm::dvec3 high{0};
};
Box BoundsOf(const Mesh& mesh);

// The shapes that need no file: plane, wall, sphere, cube and cylinder. docs/rendering.md says
// where a texture lies on them.
const std::vector<std::string_view>& ShapeNames();
std::optional<Mesh> MakeShape(std::string_view name);

// The mesh of a binary glTF file: all triangles of its scene, at the places that its nodes give
// them. Reported: kCannotRead, kSizeLimit, kBadMesh.
std::optional<Mesh> ReadGltf(const std::string& path, Diagnostics& diagnostics);
// The same of a file's bytes; `name` stands in messages.
std::optional<Mesh> ParseGltf(std::string_view bytes, const std::string& name,
                              Diagnostics& diagnostics);

// Makes normals: each triangle gets vertices of its own, with the triangle's direction.
void ComputeFlatNormals(Mesh& mesh);
// Makes tangents from the directions in which u and v grow, averaged over the triangles around a
// vertex by their angles there. A vertex between triangles with the texture and mirrored ones is
// doubled. Where uv does not vary, the tangent is any direction along the surface.
void ComputeTangents(Mesh& mesh);

}  // namespace texgraph::runtime
