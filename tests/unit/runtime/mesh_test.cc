// SPDX-License-Identifier: Apache-2.0
#include "runtime/mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <set>

#include "runtime/camera.h"

namespace texgraph::runtime {
namespace {

class ShapeTest : public testing::TestWithParam<std::string_view> {};
INSTANTIATE_TEST_SUITE_P(Shapes, ShapeTest, testing::ValuesIn(ShapeNames()),
                         [](const auto& info) { return std::string(info.param); });

// Triangles face the way of their normals, frames are right-angled, and the tangent and the
// bitangent lead to where u and v grow.
TEST_P(ShapeTest, HasTrueFrames) {
  const Mesh mesh = *MakeShape(GetParam());
  ASSERT_FALSE(mesh.indices.empty());
  for (size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Vertex* corners[3];
    for (size_t c = 0; c < 3; ++c) corners[c] = &mesh.vertices.at(mesh.indices[i + c]);
    const glm::dvec3 e1 = glm::dvec3(corners[1]->position) - glm::dvec3(corners[0]->position);
    const glm::dvec3 e2 = glm::dvec3(corners[2]->position) - glm::dvec3(corners[0]->position);
    if (glm::length(glm::cross(e1, e2)) < 1e-9) continue;  // at a pole
    const glm::dvec3 face = glm::normalize(glm::cross(e1, e2));
    for (const Vertex* corner : corners) {
      const glm::dvec3 normal(corner->normal);
      const glm::dvec3 tangent(corner->tangent);
      EXPECT_GT(glm::dot(face, normal), 0.99);
      EXPECT_NEAR(glm::length(normal), 1, 1e-6);
      EXPECT_NEAR(glm::length(tangent), 1, 1e-6);
      EXPECT_NEAR(glm::dot(normal, tangent), 0, 1e-6);
      EXPECT_EQ(corner->tangent.w, 1);
    }
    const glm::dvec2 d1 = corners[1]->uv - corners[0]->uv;
    const glm::dvec2 d2 = corners[2]->uv - corners[0]->uv;
    EXPECT_GT(d1.x * d2.y - d1.y * d2.x, 0);  // not mirrored
    // Along an edge, a step to the right goes with more u.
    const glm::dvec3 tangent(corners[0]->tangent);
    const glm::dvec3 up = glm::cross(glm::dvec3(corners[0]->normal), tangent);
    if (std::abs(d1.x) > 2 * std::abs(d1.y)) {
      EXPECT_GT(d1.x * glm::dot(e1, tangent), 0);
    }
    if (std::abs(d2.y) > 2 * std::abs(d2.x)) {
      EXPECT_GT(d2.y * glm::dot(e2, up), 0);
    }
  }
}

// What is computed from positions and uv is what the formulas of the shapes say.
TEST_P(ShapeTest, ComputedTangentsAreTheShapesOwn) {
  const Mesh mesh = *MakeShape(GetParam());
  Mesh computed = mesh;
  ComputeTangents(computed);
  ASSERT_EQ(computed.vertices.size(), mesh.vertices.size());
  for (size_t i = 0; i < mesh.vertices.size(); ++i) {
    if (std::abs(mesh.vertices[i].position.y) > 0.97f && GetParam() == "sphere") continue;
    EXPECT_GT(
        glm::dot(glm::vec3(computed.vertices[i].tangent), glm::vec3(mesh.vertices[i].tangent)),
        0.999f);
    EXPECT_EQ(computed.vertices[i].tangent.w, 1);
  }
}

TEST(ShapeTest, KnowsItsNames) {
  EXPECT_FALSE(MakeShape("teapot"));
  EXPECT_FALSE(MakeShape(""));
}

// Two squares side by side that share their middle edge; the right one has the texture mirrored.
TEST(TangentTest, MirroredHalvesHaveFramesOfTheirOwn) {
  Mesh mesh;
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 2; ++y) {
      Vertex vertex;
      vertex.position = {x, y, 0};
      vertex.uv = {x == 2 ? 0 : x, y};  // 0, 1, and back to 0
      mesh.vertices.push_back(vertex);
    }
  }
  mesh.indices = {0, 2, 3, 0, 3, 1, 2, 4, 5, 2, 5, 3};
  ComputeTangents(mesh);
  EXPECT_EQ(mesh.vertices.size(), 8u);  // the two in the middle are doubled
  for (size_t i = 0; i < mesh.indices.size(); ++i) {
    const Vertex& vertex = mesh.vertices.at(mesh.indices[i]);
    const float side = i < 6 ? 1.0f : -1.0f;
    EXPECT_NEAR(vertex.tangent.x, side, 1e-6) << i;
    EXPECT_EQ(vertex.tangent.w, side) << i;
    // v goes up in both.
    const glm::vec3 up = glm::cross(vertex.normal, glm::vec3(vertex.tangent)) * vertex.tangent.w;
    EXPECT_NEAR(up.y, 1, 1e-6) << i;
  }
}

TEST(TangentTest, WithoutUvAnyDirectionAlongTheSurface) {
  Mesh mesh;
  for (int i = 0; i < 3; ++i) {
    Vertex vertex;
    vertex.position = {i == 1, i == 2, 0};
    vertex.uv = {0.5, 0.5};
    mesh.vertices.push_back(vertex);
  }
  mesh.indices = {0, 1, 2};
  ComputeTangents(mesh);
  for (const Vertex& vertex : mesh.vertices) {
    EXPECT_NEAR(glm::length(glm::vec3(vertex.tangent)), 1, 1e-6);
    EXPECT_NEAR(vertex.tangent.z, 0, 1e-6);
  }
}

// --- The camera

// Where a point is in the picture: from -1 to 1 to the right and up; z is its depth.
glm::dvec3 Projected(const glm::dmat4& clip, const glm::dvec3& point) {
  const glm::dvec4 at = clip * glm::dvec4(point, 1);
  return glm::dvec3(at) / at.w;
}

const Box kBox{{-1, -2, -3}, {3, 2, 1}};  // its middle is (1, 0, -1)

TEST(CameraTest, ProjectsKnownPoints) {
  Camera camera;
  camera.distance = 10;
  camera.field_of_view = 90;
  const View view = ViewOf(kBox, camera, 200, 100);
  EXPECT_NEAR(view.eye.z, 9, 1e-12);
  // With 90 degrees, a point as high above the axis as it is far away is at the upper edge.
  const glm::dvec3 up = Projected(view.clip_from_object, {1, 10, -1});
  EXPECT_NEAR(up.x, 0, 1e-9);
  EXPECT_NEAR(up.y, 1, 1e-9);
  const glm::dvec3 right = Projected(view.clip_from_object, {1 + 9, 0, 0});
  EXPECT_NEAR(right.x, 0.5, 1e-9);  // a picture twice as wide as high
  EXPECT_NEAR(right.y, 0, 1e-9);
  EXPECT_LT(right.z, Projected(view.clip_from_object, {1, 0, -1}).z);  // nearer
}

TEST(CameraTest, YawGoesRightAndPitchUp) {
  Camera camera;
  camera.distance = 10;
  camera.yaw = 90;
  View view = ViewOf(kBox, camera, 100, 100);
  EXPECT_NEAR(view.eye.x, 11, 1e-9);
  EXPECT_GT(Projected(view.clip_from_object, {1, 0, -2}).x, 0);  // seen from +x, -z is to the right
  camera.yaw = 0;
  camera.pitch = 90;
  view = ViewOf(kBox, camera, 100, 100);
  EXPECT_NEAR(view.eye.y, 10, 1e-9);
  EXPECT_GT(Projected(view.clip_from_object, {1, 0, -2}).y, 0);  // from above, the back is up
  EXPECT_GT(Projected(view.clip_from_object, {2, 0, -1}).x, 0);
}

// All of the mesh is in the picture and in front of the camera; something is near its edge.
TEST(CameraTest, FramesTheMesh) {
  for (std::string_view name : ShapeNames()) {
    const Mesh mesh = *MakeShape(name);
    const Box box = BoundsOf(mesh);
    for (double yaw : {0.0, 33.0, 200.0}) {
      for (double pitch : {-90.0, 0.0, 40.0}) {
        for (uint32_t width : {100u, 300u}) {
          Camera camera;
          camera.yaw = yaw;
          camera.pitch = pitch;
          camera.distance = FramingDistance(mesh, box, camera, width, 200);
          const View view = ViewOf(box, camera, width, 200);
          double farthest = 0;
          for (const Vertex& vertex : mesh.vertices) {
            const glm::dvec3 at = Projected(view.clip_from_object, glm::dvec3(vertex.position));
            farthest = std::max({farthest, std::abs(at.x), std::abs(at.y)});
            EXPECT_LE(std::abs(at.z), 1);
          }
          EXPECT_LE(farthest, 0.9001) << name;
          EXPECT_GE(farthest, 0.89) << name;
        }
      }
    }
  }
}

TEST(CameraTest, TilesAreCutOutOfThePicture) {
  Camera camera;
  camera.distance = 10;
  const View view = ViewOf(kBox, camera, 100, 60);
  const glm::dvec3 point(1.7, 0.6, -0.4);
  const glm::dvec3 whole = Projected(view.clip_from_object, point);
  const glm::dvec3 tile = Projected(TileOf(view.clip_from_object, 100, 60, 32, 16, 16), point);
  EXPECT_NEAR((tile.x + 1) / 2 * 16 + 32, (whole.x + 1) / 2 * 100, 1e-9);
  EXPECT_NEAR((tile.y + 1) / 2 * 16 + 16, (whole.y + 1) / 2 * 60, 1e-9);
  EXPECT_NEAR(tile.z, whole.z, 1e-12);
}

}  // namespace
}  // namespace texgraph::runtime
