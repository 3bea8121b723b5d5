// SPDX-License-Identifier: Apache-2.0
// Binary glTF 2.0 through tinygltf. What tinygltf cannot bear (deep JSON, other files) is kept from
// it, and what it does not check is checked here and in gltf_accessor.cc.
#include <fmt/format.h>
#include <string.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <new>

#include "compiler/base/files.h"
#include "runtime/gltf_accessor.h"
#include "runtime/mesh.h"

namespace texgraph::runtime {
namespace {

constexpr uint32_t kMaxJsonBytes = 16u << 20;
constexpr int kMaxNesting = 64;
constexpr size_t kMaxVertices = 3 * kMaxTriangles;
constexpr size_t kMaxParts = size_t{1} << 18;  // primitives, each as often as a node shows it
constexpr size_t kHeaderBytes = 20;            // of the file and its first chunk
constexpr uint32_t kMagic = 0x46546c67;
constexpr uint32_t kJsonChunk = 0x4e4f534a;

// How deep brackets nest; strings are skipped.
int NestingOf(std::string_view json) {
  int depth = 0;
  int deepest = 0;
  bool in_string = false;
  for (size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '{' || c == '[') {
      deepest = std::max(deepest, ++depth);
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
  return deepest;
}

bool IsKnownExtension(const std::string& name) {
  // Materials and their pictures are not looked at; quantised numbers are read like all others.
  for (std::string_view prefix :
       {"KHR_materials_", "KHR_texture_", "EXT_texture_", "KHR_lights_"}) {
    if (name.starts_with(prefix)) return true;
  }
  return name == "KHR_mesh_quantization";
}

bool TakeNoImage(tinygltf::Image*, const int, std::string*, std::string*, int, int,
                 const unsigned char*, int, void*) {
  return true;
}

// Callbacks that open nothing, and remember that they were asked.
tinygltf::FsCallbacks NoFiles(bool* asked) {
  tinygltf::FsCallbacks callbacks{};
  callbacks.FileExists = [](const std::string&, void* user) {
    *static_cast<bool*>(user) = true;
    return false;
  };
  callbacks.ExpandFilePath = [](const std::string&, void*) { return std::string(); };
  callbacks.ReadWholeFile = [](std::vector<unsigned char>*, std::string*, const std::string&,
                               void*) { return false; };
  callbacks.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&,
                                void*) { return false; };
  callbacks.user_data = asked;
  return callbacks;
}

class GltfReader {
 public:
  GltfReader(const std::string& name, Diagnostics& diagnostics)
      : name_(name), diagnostics_(diagnostics) {}

  std::optional<Mesh> Read(std::string_view bytes) {
    mesh_.name = name_;
    if (!CheckHeader(bytes) || !Parse(bytes) || !CheckExtensions() || !PlaceNodes())
      return std::nullopt;
    if (mesh_.indices.empty()) {
      Bad("has no triangles");
      return std::nullopt;
    }
    return std::move(mesh_);
  }

 private:
  bool Bad(const std::string& text, DiagnosticKind kind = DiagnosticKind::kBadMesh) {
    diagnostics_.Error(kind, {}, fmt::format("'{}' {}", Printable(name_), text));
    return false;
  }
  bool TooLarge(const std::string& text) { return Bad(text, DiagnosticKind::kSizeLimit); }

  bool CheckHeader(std::string_view bytes);
  bool Parse(std::string_view bytes);
  bool CheckExtensions();
  bool RootNodes(std::vector<int>& roots);
  bool PlaceNodes();
  bool AddMesh(int index, const glm::dmat4& place);
  bool AddPrimitive(const tinygltf::Primitive& primitive, const glm::dmat4& place);
  bool ReadAttribute(const tinygltf::Primitive& primitive, const char* name, uint32_t components,
                     std::vector<float>& floats);
  bool ReadVertices(const tinygltf::Primitive& primitive, Mesh& part);
  bool ReadTriangles(const tinygltf::Primitive& primitive, Mesh& part);
  bool Append(Mesh part, const glm::dmat4& place);

  const std::string& name_;
  Diagnostics& diagnostics_;
  tinygltf::Model model_;
  Mesh mesh_;
  // So far, used or not: the work is limited, too.
  size_t placed_vertices_ = 0;
  size_t placed_parts_ = 0;
};

bool GltfReader::CheckHeader(std::string_view bytes) {
  uint32_t words[5] = {};
  if (bytes.size() >= kHeaderBytes) memcpy(words, bytes.data(), kHeaderBytes);
  if (words[0] != kMagic) return Bad("is no binary glTF file (.glb)");
  if (words[1] != 2) return Bad(fmt::format("is glTF of version {}; 2 can be read", words[1]));
  if (words[2] != bytes.size()) {
    return Bad(fmt::format("has {} bytes and says that it has {}", bytes.size(), words[2]));
  }
  if (words[4] != kJsonChunk || words[3] > bytes.size() - kHeaderBytes)
    return Bad("has no JSON where it should begin");
  if (words[3] > kMaxJsonBytes) {
    return TooLarge(fmt::format("has {} bytes of JSON; the limit is {}", words[3], kMaxJsonBytes));
  }
  const int nesting = NestingOf(bytes.substr(kHeaderBytes, words[3]));
  if (nesting <= kMaxNesting) return true;
  return Bad(fmt::format("nests {} deep; the limit is {}", nesting, kMaxNesting),
             DiagnosticKind::kNestingLimit);
}

bool GltfReader::Parse(std::string_view bytes) {
  bool other_files = false;
  std::string error;
  std::string warning;
  bool ok = false;
  try {
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader(TakeNoImage, nullptr);
    loader.SetFsCallbacks(NoFiles(&other_files));
    ok = loader.LoadBinaryFromMemory(&model_, &error, &warning,
                                     reinterpret_cast<const unsigned char*>(bytes.data()),
                                     static_cast<unsigned int>(bytes.size()));
  } catch (const std::bad_alloc&) {
    return Bad("needs more memory than there is", DiagnosticKind::kOutOfMemory);
  } catch (const std::exception& exception) {
    return Bad(fmt::format("cannot be read ({})", Printable(exception.what())));
  }
  if (ok) return true;
  if (other_files) return Bad("refers to other files; a mesh is one file");
  error = error.substr(0, error.find('\n'));
  return Bad(fmt::format("cannot be read ({})", Printable(error)));
}

bool GltfReader::CheckExtensions() {
  for (const std::string& extension : model_.extensionsRequired) {
    if (!IsKnownExtension(extension)) {
      return Bad(fmt::format("needs the extension '{}', which is not supported",
                             Printable(extension, 60)));
    }
  }
  return true;
}

// The scene's nodes, or without a scene all that are nobody's children.
bool GltfReader::RootNodes(std::vector<int>& roots) {
  if (!model_.scenes.empty()) {
    const int scene = std::max(model_.defaultScene, 0);
    if (static_cast<size_t>(scene) >= model_.scenes.size())
      return Bad(fmt::format("has no scene {}", scene));
    roots = model_.scenes[static_cast<size_t>(scene)].nodes;
    return true;
  }
  std::vector<bool> is_child(model_.nodes.size(), false);
  for (const tinygltf::Node& node : model_.nodes) {
    for (int child : node.children) {
      if (child >= 0 && static_cast<size_t>(child) < is_child.size())
        is_child[static_cast<size_t>(child)] = true;
    }
  }
  for (size_t i = 0; i < is_child.size(); ++i) {
    if (!is_child[i]) roots.push_back(static_cast<int>(i));
  }
  return true;
}

glm::dmat4 PlaceOf(const tinygltf::Node& node) {
  glm::dmat4 place(1);
  if (node.matrix.size() == 16) {
    for (int i = 0; i < 16; ++i) place[i / 4][i % 4] = node.matrix[static_cast<size_t>(i)];
    return place;
  }
  if (node.translation.size() == 3) {
    place = glm::translate(
        place, glm::dvec3(node.translation[0], node.translation[1], node.translation[2]));
  }
  if (node.rotation.size() == 4) {
    const glm::dquat turn(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
    place *= glm::mat4_cast(glm::normalize(turn));
  }
  if (node.scale.size() == 3)
    place = glm::scale(place, glm::dvec3(node.scale[0], node.scale[1], node.scale[2]));
  return place;
}

// A tree may be deep, so it is walked without recursion; a node that is met twice has two parents
// or is its own ancestor, which glTF forbids.
bool GltfReader::PlaceNodes() {
  struct Step {
    int node;
    glm::dmat4 parent;
  };
  std::vector<int> roots;
  if (!RootNodes(roots)) return false;
  std::vector<Step> steps;
  for (auto root = roots.rbegin(); root != roots.rend(); ++root)
    steps.push_back({*root, glm::dmat4(1)});
  std::vector<bool> met(model_.nodes.size(), false);
  while (!steps.empty()) {
    const Step step = steps.back();
    steps.pop_back();
    const auto index = static_cast<size_t>(step.node);
    if (step.node < 0 || index >= model_.nodes.size())
      return Bad(fmt::format("has no node {}", step.node));
    if (met[index]) return Bad(fmt::format("has node {} at two places of its tree", step.node));
    met[index] = true;
    const tinygltf::Node& node = model_.nodes[index];
    const glm::dmat4 place = step.parent * PlaceOf(node);
    if (node.mesh >= 0 && !AddMesh(node.mesh, place)) return false;
    for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
      steps.push_back({*child, place});
  }
  return true;
}

bool GltfReader::AddMesh(int index, const glm::dmat4& place) {
  if (static_cast<size_t>(index) >= model_.meshes.size())
    return Bad(fmt::format("has no mesh {}", index));
  const tinygltf::Mesh& mesh = model_.meshes[static_cast<size_t>(index)];
  placed_parts_ += mesh.primitives.size();
  if (placed_parts_ > kMaxParts)
    return TooLarge(fmt::format("has more than {} primitives", kMaxParts));
  for (const tinygltf::Primitive& primitive : mesh.primitives) {
    if (!AddPrimitive(primitive, place)) return false;
  }
  return true;
}

bool GltfReader::ReadAttribute(const tinygltf::Primitive& primitive, const char* name,
                               uint32_t components, std::vector<float>& floats) {
  const auto found = primitive.attributes.find(name);
  if (found == primitive.attributes.end()) return true;
  std::string why_not;
  if (ReadFloats(model_, found->second, components, kMaxVertices, floats, why_not)) return true;
  return Bad(fmt::format("has a wrong {}: {}", name, why_not));
}

bool GltfReader::ReadVertices(const tinygltf::Primitive& primitive, Mesh& part) {
  std::vector<float> positions, normals, tangents, uvs;
  if (!ReadAttribute(primitive, "POSITION", 3, positions) ||
      !ReadAttribute(primitive, "NORMAL", 3, normals) ||
      !ReadAttribute(primitive, "TANGENT", 4, tangents) ||
      !ReadAttribute(primitive, "TEXCOORD_0", 2, uvs))
    return false;
  const size_t count = positions.size() / 3;
  if (uvs.empty()) return Bad("has triangles without texture coordinates (TEXCOORD_0)");
  if (uvs.size() != 2 * count || (!normals.empty() && normals.size() != 3 * count) ||
      (!tangents.empty() && tangents.size() != 4 * count))
    return Bad("has attributes of different counts in one primitive");
  part.vertices.resize(count);
  for (size_t i = 0; i < count; ++i) {
    Vertex& vertex = part.vertices[i];
    vertex.position = {positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]};
    // In glTF, v goes down a picture.
    vertex.uv = {uvs[2 * i], 1 - uvs[2 * i + 1]};
    vertex.normal = normals.empty()
                        ? glm::vec3(0)
                        : glm::vec3(normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]);
    vertex.tangent = tangents.empty() ? glm::vec4(0)
                                      : glm::vec4(tangents[4 * i], tangents[4 * i + 1],
                                                  tangents[4 * i + 2], tangents[4 * i + 3]);
  }
  return true;
}

bool GltfReader::ReadTriangles(const tinygltf::Primitive& primitive, Mesh& part) {
  const size_t count = part.vertices.size();
  std::vector<uint32_t> corners;
  if (primitive.indices >= 0) {
    std::string why_not;
    if (!ReadIndices(model_, primitive.indices, kMaxVertices, corners, why_not))
      return Bad(fmt::format("has wrong indices: {}", why_not));
    for (uint32_t corner : corners) {
      if (corner >= count)
        return Bad(fmt::format("has the index {} into {} vertices", corner, count));
    }
  } else {
    for (size_t i = 0; i < count; ++i) corners.push_back(static_cast<uint32_t>(i));
  }
  if (primitive.mode == TINYGLTF_MODE_TRIANGLES || primitive.mode < 0) {
    corners.resize(corners.size() / 3 * 3);
    part.indices = std::move(corners);
    return true;
  }
  const bool is_fan = primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN;
  for (size_t i = 0; i + 2 < corners.size(); ++i) {
    const size_t odd = is_fan ? 0 : i % 2;  // every other triangle of a strip is turned round
    const uint32_t first = is_fan ? corners[0] : corners[i];
    part.indices.insert(part.indices.end(), {first, corners[i + 1 + odd], corners[i + 2 - odd]});
  }
  return true;
}

bool IsUsable(const glm::vec3& v) { return glm::length(v) > 1e-6f; }

bool GltfReader::AddPrimitive(const tinygltf::Primitive& primitive, const glm::dmat4& place) {
  const bool is_surface = primitive.mode < 0 || primitive.mode == TINYGLTF_MODE_TRIANGLES ||
                          primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
                          primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN;
  if (!is_surface || !primitive.attributes.contains("POSITION")) return true;
  Mesh part;
  if (!ReadVertices(primitive, part)) return false;
  placed_vertices_ += part.vertices.size();
  if (placed_vertices_ > kMaxVertices)
    return TooLarge(fmt::format("has more than {} vertices", kMaxVertices));
  if (!ReadTriangles(primitive, part)) return false;
  if (part.indices.size() / 3 > kMaxTriangles - mesh_.indices.size() / 3)
    return TooLarge(fmt::format("has more than {} triangles", kMaxTriangles));
  const auto all = [&part](auto test) {
    return std::all_of(part.vertices.begin(), part.vertices.end(), test);
  };
  if (!all([](const Vertex& vertex) { return IsUsable(vertex.normal); })) ComputeFlatNormals(part);
  // Tangents of a file are of use together with its normals only.
  const bool has_tangents = all([](const Vertex& vertex) {
    const glm::vec3 along(vertex.tangent);
    return IsUsable(along) &&
           std::abs(glm::dot(glm::normalize(along), glm::normalize(vertex.normal))) < 0.99f;
  });
  if (!has_tangents) ComputeTangents(part);
  return Append(std::move(part), place);
}

// Puts the part where its node is. A mirroring node turns triangles round and textures into their
// mirror image.
bool GltfReader::Append(Mesh part, const glm::dmat4& place) {
  const glm::dmat3 turn(place);
  const double mirror = glm::determinant(turn) < 0 ? -1 : 1;
  // Normals go with the cofactors, which exist for flat scales, too.
  glm::dmat3 cofactors;
  for (int i = 0; i < 3; ++i) {
    cofactors[i] = glm::cross(turn[(i + 1) % 3], turn[(i + 2) % 3]) * mirror;
  }
  const auto unit = [](const glm::dvec3& v, const glm::dvec3& otherwise) {
    const double size = glm::length(v);
    return glm::vec3(size > 0 && std::isfinite(size) ? v / size : otherwise);
  };
  const auto first = static_cast<uint32_t>(mesh_.vertices.size());
  for (Vertex& vertex : part.vertices) {
    const glm::dvec3 position(place * glm::dvec4(glm::dvec3(vertex.position), 1));
    vertex.position = glm::vec3(position);
    for (int c = 0; c < 3; ++c) {
      if (!(std::abs(vertex.position[c]) <= 1e12f)) return Bad("has a vertex beyond 1e12");
    }
    const glm::dvec3 normal = unit(cofactors * glm::dvec3(vertex.normal), {0, 1, 0});
    const glm::dvec3 along = turn * glm::dvec3(vertex.tangent);
    const glm::vec3 tangent = unit(along - normal * glm::dot(along, normal), {1, 0, 0});
    const double sign = (vertex.tangent.w < 0 ? -1 : 1) * mirror;
    vertex.normal = glm::vec3(normal);
    vertex.tangent = glm::vec4(tangent, static_cast<float>(sign));
    mesh_.vertices.push_back(vertex);
  }
  for (size_t i = 0; i + 2 < part.indices.size(); i += 3) {
    const size_t turned = mirror < 0 ? 1 : 0;
    for (size_t corner : {i, i + 1 + turned, i + 2 - turned})
      mesh_.indices.push_back(first + part.indices[corner]);
  }
  return true;
}

}  // namespace

std::optional<Mesh> ParseGltf(std::string_view bytes, const std::string& name,
                              Diagnostics& diagnostics) {
  return GltfReader(name, diagnostics).Read(bytes);
}

std::optional<Mesh> ReadGltf(const std::string& path, Diagnostics& diagnostics) {
  const auto bytes = ReadFile(path, kMaxMeshBytes, {}, diagnostics);
  return bytes ? ParseGltf(*bytes, path, diagnostics) : std::nullopt;
}

}  // namespace texgraph::runtime
