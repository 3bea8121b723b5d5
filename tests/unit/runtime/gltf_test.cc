// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "runtime/mesh.h"
#include "tests/unit/base/scratch_folder.h"
#include "tests/unit/runtime/glb_file.h"

namespace texgraph::runtime {
namespace {

using testing::HasSubstr;

struct Parsed {
  std::optional<Mesh> mesh;
  Diagnostics diagnostics;
  std::string message() const {
    return diagnostics.all().empty() ? "" : diagnostics.all().front().message;
  }
};

Parsed Parse(const std::string& bytes) {
  Parsed parsed;
  parsed.mesh = ParseGltf(bytes, "a.glb", parsed.diagnostics);
  return parsed;
}

std::string Replaced(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

// The triangle with one part of its JSON replaced.
std::string Changed(const std::string& from, const std::string& to) {
  return GlbFile(Replaced(TriangleJson(), from, to), TriangleBinary());
}

void ExpectNear(const glm::vec3& a, const glm::vec3& b) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], 1e-6) << c;
}

TEST(GltfTest, ReadsATriangle) {
  const Parsed parsed = Parse(GlbFile(TriangleJson(), TriangleBinary()));
  ASSERT_TRUE(parsed.mesh) << parsed.message();
  const Mesh& mesh = *parsed.mesh;
  ASSERT_EQ(mesh.vertices.size(), 3u);
  EXPECT_THAT(mesh.indices, testing::ElementsAre(0, 1, 2));
  ExpectNear(mesh.vertices[2].position, {0, 1, 0});
  // The texture stands upright: u to the right, v up, so the frame is right-handed.
  EXPECT_EQ(mesh.vertices[0].uv, glm::vec2(0, 0));
  EXPECT_EQ(mesh.vertices[2].uv, glm::vec2(0, 1));
  for (const Vertex& vertex : mesh.vertices) {
    ExpectNear(vertex.normal, {0, 0, 1});  // flat: the file has none
    ExpectNear(glm::vec3(vertex.tangent), {1, 0, 0});
    EXPECT_EQ(vertex.tangent.w, 1);
  }
}

// Turned by 90 degrees about y, twice as large along x before that, then moved, by two nodes.
TEST(GltfTest, AppliesTheNodesTransforms) {
  const Parsed parsed = Parse(Changed("\"nodes\": [{\"mesh\": 0}]",
                                      R"("nodes": [{"children": [1], "translation": [10, 0, 0]},
                       {"mesh": 0, "rotation": [0, 0.70710678, 0, 0.70710678], "scale": [2, 1, 1]}])"));
  ASSERT_TRUE(parsed.mesh) << parsed.message();
  ExpectNear(parsed.mesh->vertices[1].position, {10, 0, -2});
  ExpectNear(parsed.mesh->vertices[2].position, {10, 1, 0});
  ExpectNear(parsed.mesh->vertices[0].normal, {1, 0, 0});
  ExpectNear(glm::vec3(parsed.mesh->vertices[0].tangent), {0, 0, -1});
}

// The mirror image along x of a triangle that faces +z still faces +z, and its corners go round
// counter-clockwise; its texture is mirrored.
TEST(GltfTest, AMirroringNodeKeepsTheOutside) {
  const Parsed parsed = Parse(Changed("{\"mesh\": 0}", "{\"mesh\": 0, \"scale\": [-1, 1, 1]}"));
  ASSERT_TRUE(parsed.mesh) << parsed.message();
  const Mesh& mesh = *parsed.mesh;
  const auto at = [&](size_t i) { return mesh.vertices[mesh.indices[i]].position; };
  EXPECT_GT(glm::cross(at(1) - at(0), at(2) - at(0)).z, 0);
  ExpectNear(mesh.vertices[0].normal, {0, 0, 1});
  ExpectNear(glm::vec3(mesh.vertices[0].tangent), {-1, 0, 0});
  EXPECT_EQ(mesh.vertices[0].tangent.w, -1);
}

TEST(GltfTest, ReadsNormalsAndMatrices) {
  const Parsed parsed = Parse(GlbFile(
      Replaced(Replaced(TriangleJson(), "\"POSITION\": 0,", "\"POSITION\": 0, \"NORMAL\": 3,"),
               "{\"mesh\": 0}",
               R"({"mesh": 0, "matrix": [1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 5, 6, 7, 1]})"),
      TriangleBinary()));
  ASSERT_TRUE(parsed.mesh) << parsed.message();
  ExpectNear(parsed.mesh->vertices[2].position, {5, 7, 8});
  // A shear of z by y: the normal goes with the inverse transposed, (0, -1, 1).
  ExpectNear(parsed.mesh->vertices[0].normal, {0, -std::sqrt(0.5f), std::sqrt(0.5f)});
}

TEST(GltfTest, ReadsStripsAndFans) {
  std::string binary = TriangleBinary();
  std::string json = TriangleJson();
  json = Replaced(json, "\"indices\": 2", "\"mode\": 5, \"indices\": 2");
  json = Replaced(json, "\"componentType\": 5123, \"count\": 3",
                  "\"componentType\": 5123, \"count\": 4");
  json = Replaced(json, "\"byteOffset\": 60, \"byteLength\": 6",
                  "\"byteOffset\": 60, \"byteLength\": 8");
  Parsed parsed = Parse(GlbFile(json, binary));
  ASSERT_TRUE(parsed.mesh) << parsed.message();
  // Flat normals give each triangle vertices of its own; 0, 1, 2, 0 as a strip is (0 1 2) and,
  // turned round, (1 0 2).
  ASSERT_EQ(parsed.mesh->indices.size(), 6u);
  ExpectNear(parsed.mesh->vertices[parsed.mesh->indices[3]].position, {1, 0, 0});
  ExpectNear(parsed.mesh->vertices[parsed.mesh->indices[4]].position, {0, 0, 0});
  parsed = Parse(GlbFile(Replaced(json, "\"mode\": 5", "\"mode\": 6"), binary));
  ASSERT_TRUE(parsed.mesh) << parsed.message();
  ASSERT_EQ(parsed.mesh->indices.size(), 6u);
  ExpectNear(parsed.mesh->vertices[parsed.mesh->indices[4]].position, {0, 1, 0});  // 0 2 0
}

TEST(GltfTest, ReadsSparseAndNormalizedAccessors) {
  // Corner 1 is put to (0,0,1) x the normal's bytes by a sparse accessor on top of the positions.
  Parsed parsed = Parse(Changed(
      "\"min\": [0, 0, 0], \"max\": [1, 1, 0]}",
      R"("sparse": {"count": 1, "indices": {"bufferView": 2, "byteOffset": 2, "componentType": 5123},
                    "values": {"bufferView": 3}}})"));
  ASSERT_TRUE(parsed.mesh) << parsed.message();
  ExpectNear(parsed.mesh->vertices[1].position, {0, 0, 1});
  ExpectNear(parsed.mesh->vertices[2].position, {0, 1, 0});

  std::string binary = TriangleBinary().substr(0, 36);
  AppendBytes<uint8_t>(binary, {0, 255, 0, 0, 255, 255, 0, 0, 0, 0, 0, 0});  // stride 4
  binary.resize(104);
  std::string json = Replaced(TriangleJson(), "\"bufferView\": 1, \"componentType\": 5126",
                              "\"bufferView\": 1, \"normalized\": true, \"componentType\": 5121");
  json = Replaced(json, "\"byteOffset\": 36, \"byteLength\": 24",
                  "\"byteOffset\": 36, \"byteLength\": 12, \"byteStride\": 4");
  json = Replaced(json, ", \"indices\": 2", "");
  parsed = Parse(GlbFile(json, binary));
  ASSERT_TRUE(parsed.mesh) << parsed.message();
  EXPECT_EQ(parsed.mesh->vertices[0].uv, glm::vec2(0, 0));
  EXPECT_EQ(parsed.mesh->vertices[1].uv, glm::vec2(1, 0));
  EXPECT_EQ(parsed.mesh->vertices[2].uv, glm::vec2(0, 1));
}

struct BadPart {
  const char* name;
  std::string from, to;
  const char* message;
  ExitCode exit = ExitCode::kInvalid;
};

class BadGltfTest : public testing::TestWithParam<BadPart> {};

TEST_P(BadGltfTest, IsRefused) {
  const Parsed parsed = Parse(Changed(GetParam().from, GetParam().to));
  EXPECT_FALSE(parsed.mesh);
  EXPECT_THAT(parsed.message(), HasSubstr(GetParam().message));
  EXPECT_EQ(parsed.diagnostics.exit_code(), GetParam().exit);
}

const std::string kPositions = "\"bufferView\": 0, \"componentType\": 5126, \"count\": 3";
const std::string kView = "\"byteOffset\": 0, \"byteLength\": 36";

INSTANTIATE_TEST_SUITE_P(
    Parts, BadGltfTest,
    testing::Values(
        BadPart{"Count", kPositions,
                "\"bufferView\": 0, \"componentType\": 5126, \"count\": 1000000",
                "beyond buffer view 0"},
        BadPart{"HugeCount", kPositions,
                "\"bufferView\": 0, \"componentType\": 5126, \"count\": 9223372036854775807",
                "can be read"},
        BadPart{"ZerosWithoutEnd", kPositions, "\"componentType\": 5126, \"count\": 2147483648",
                "can be read"},
        BadPart{"NoView", kPositions, "\"bufferView\": 99, \"componentType\": 5126, \"count\": 3",
                "no buffer view 99"},
        BadPart{"NegativeView", kPositions,
                "\"bufferView\": -5, \"componentType\": 5126, \"count\": 3", "'a.glb'"},
        BadPart{"Offset", kPositions, kPositions + ", \"byteOffset\": 4611686018427387904",
                "'a.glb'"},
        BadPart{"ViewLength", kView, "\"byteOffset\": 0, \"byteLength\": 1000000000", "'a.glb'"},
        BadPart{"ViewOffset", kView, "\"byteOffset\": 4611686018427387904, \"byteLength\": 36",
                "'a.glb'"},
        BadPart{"NoBuffer", "\"buffer\": 0, \"byteOffset\": 0", "\"buffer\": 7, \"byteOffset\": 0",
                "'a.glb'"},
        BadPart{"Stride", kView, kView + ", \"byteStride\": 4", "a stride of 4"},
        BadPart{"NoAccessor", "\"POSITION\": 0", "\"POSITION\": 55", "no accessor 55"},
        BadPart{"OtherType", "\"TEXCOORD_0\": 1", "\"TEXCOORD_0\": 0", "another type"},
        BadPart{"Index", "\"count\": 3, \"type\": \"VEC2\"", "\"count\": 2, \"type\": \"VEC2\"",
                "different counts"},
        BadPart{"IndicesOfFloats", "\"indices\": 2", "\"indices\": 0", "has no indices"},
        BadPart{"IndexBeyond", "\"byteOffset\": 60", "\"byteOffset\": 40", "into 3 vertices"},
        BadPart{"NoUv", ", \"TEXCOORD_0\": 1", "", "without texture coordinates (TEXCOORD_0)"},
        BadPart{"Points", "\"indices\": 2", "\"indices\": 2, \"mode\": 0", "has no triangles"},
        BadPart{"NoMesh", "{\"mesh\": 0}", "{}", "has no triangles"},
        BadPart{"MissingMesh", "{\"mesh\": 0}", "{\"mesh\": 3}", "no mesh 3"},
        BadPart{"MissingNode", "\"nodes\": [0]", "\"nodes\": [4]", "no node 4"},
        BadPart{"SelfChild", "{\"mesh\": 0}", "{\"mesh\": 0, \"children\": [0]}", "two places"},
        BadPart{"Cycle", "[{\"mesh\": 0}]", "[{\"children\": [1]}, {\"children\": [0]}]",
                "two places"},
        BadPart{"NoScene", "\"scene\": 0", "\"scene\": 5", "no scene 5"},
        BadPart{
            "Sparse", "\"min\": [0, 0, 0], \"max\": [1, 1, 0]}",
            R"("sparse": {"count": 1000000000, "indices": {"bufferView": 2, "componentType": 5123},
                              "values": {"bufferView": 3}}})",
            "sparse"},
        BadPart{
            "SparseIndex", "\"min\": [0, 0, 0], \"max\": [1, 1, 0]}",
            R"("sparse": {"count": 1, "indices": {"bufferView": 1, "byteOffset": 6, "componentType": 5123},
                              "values": {"bufferView": 3}}})",
            "outside of itself"},
        BadPart{"Draco", "\"asset\"",
                "\"extensionsRequired\": [\"KHR_draco_mesh_compression\"], \"asset\"",
                "'KHR_draco_mesh_compression', which is not supported"},
        BadPart{"OtherFile", "{\"byteLength\": 104}",
                "{\"byteLength\": 104, \"uri\": \"/etc/passwd\"}", "refers to other files"},
        BadPart{"HugeScale", "{\"mesh\": 0}", "{\"mesh\": 0, \"scale\": [1e300, 1e300, 1]}",
                "beyond 1e12"}),
    [](const auto& info) { return info.param.name; });

TEST(GltfTest, RefusesNumbersThatAreNone) {
  for (float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    for (size_t at : {0, 36}) {
      std::string binary = TriangleBinary();
      memcpy(binary.data() + at, &bad, sizeof bad);
      const Parsed parsed = Parse(GlbFile(TriangleJson(), binary));
      EXPECT_FALSE(parsed.mesh);
      EXPECT_THAT(parsed.message(), HasSubstr("not finite"));
    }
  }
}

TEST(GltfTest, RefusesWhatIsNoGlb) {
  EXPECT_THAT(Parse("").message(), HasSubstr("no binary glTF"));
  EXPECT_THAT(Parse("solid cube\n").message(), HasSubstr("no binary glTF"));
  const std::string whole = GlbFile(TriangleJson(), TriangleBinary());
  for (size_t size = 0; size < whole.size(); ++size) {
    ASSERT_FALSE(Parse(whole.substr(0, size)).mesh) << size;
  }
  std::string deep;
  for (int i = 0; i < 20000; ++i) deep += "{\"a\":";
  const Parsed nested = Parse(
      Changed("\"asset\"", "\"extras\": " + deep + "1" + std::string(20000, '}') + ", \"asset\""));
  EXPECT_THAT(nested.message(), HasSubstr("nests 20001 deep"));
  EXPECT_EQ(nested.diagnostics.exit_code(), ExitCode::kLimit);
}

// Every byte of the file in turn gets three other values: never a crash, and never an index that
// is not there.
TEST(GltfTest, SurvivesAnyWrongByte) {
  const std::string whole = GlbFile(TriangleJson(), TriangleBinary());
  for (size_t at = 0; at < whole.size(); ++at) {
    for (int change : {0x01, 0x80, 0xff}) {
      std::string bytes = whole;
      bytes[at] = static_cast<char>(bytes[at] ^ change);
      const Parsed parsed = Parse(bytes);
      if (!parsed.mesh) {
        EXPECT_TRUE(parsed.diagnostics.HasErrors());
        continue;
      }
      for (uint32_t index : parsed.mesh->indices) ASSERT_LT(index, parsed.mesh->vertices.size());
    }
  }
}

// Many nodes that all show one mesh make more triangles than the file has.
TEST(GltfTest, LimitsWhatNodesMultiply) {
  std::string nodes = "{\"mesh\": 0}";
  std::string roots = "0";
  std::string primitives;
  for (int i = 0; i < 1000; ++i) {
    primitives += R"(,{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "mode": 1})";
    nodes += ",{\"mesh\": 0}";
    roots += "," + std::to_string(i + 1);
  }
  std::string json = Replaced(TriangleJson(), "\"nodes\": [0]", "\"nodes\": [" + roots + "]");
  json = Replaced(json, "[{\"mesh\": 0}]", "[" + nodes + "]");
  json = Replaced(json, "\"indices\": 2}", "\"indices\": 2}" + primitives);
  const Parsed parsed = Parse(GlbFile(json, TriangleBinary()));
  EXPECT_FALSE(parsed.mesh);
  EXPECT_THAT(parsed.message(), HasSubstr("primitives"));
  EXPECT_EQ(parsed.diagnostics.exit_code(), ExitCode::kLimit);
}

TEST(GltfTest, OpensFilesOnly) {
  ScratchFolder folder;
  mkfifo((folder / "pipe.glb").c_str(), 0600);
  for (const std::string& path : {folder / "pipe.glb", folder.path(), folder / "none.glb"}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(ReadGltf(path, diagnostics));
    EXPECT_EQ(diagnostics.exit_code(), ExitCode::kIo) << path;
  }
  folder.Write("a.glb", GlbFile(TriangleJson(), TriangleBinary()));
  Diagnostics diagnostics;
  EXPECT_TRUE(ReadGltf(folder / "a.glb", diagnostics));
}

}  // namespace
}  // namespace texgraph::runtime
