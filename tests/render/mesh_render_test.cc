// SPDX-License-Identifier: Apache-2.0
// Meshes as they are drawn, against an independent calculation: where things are, how they are
// turned, and how much light they send back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "runtime/render.h"
#include "tests/render/render_testing.h"

namespace texgraph::runtime {
namespace {

using glm::dvec3;
using test::FirstMessage;
using test::FirstName;
using test::FloatAt;
using testing::HasSubstr;

constexpr double kPi = std::numbers::pi;

struct Wire {
  std::string name;
  ir::TypeId type;
  std::string value;  // in GLSL, of uv, position, normal and time
};

// A request for a function with these outputs, seen straight from the front: one sample a pixel, an
// angle of 90 degrees, no light but what a test sets.
RenderRequest MeshRequest(std::string_view shape, const std::vector<Wire>& outputs, uint32_t size) {
  RenderRequest request;
  request.manifest.is_function = true;
  request.manifest.entry_point = "made";
  request.manifest.inputs = {{"uv", "", ir::kVec2, {}},
                             {"position", "", ir::kVec3, {}},
                             {"normal", "", ir::kVec3, {}},
                             {"time", "", ir::kFloat, {}}};
  const ir::Types types;
  std::string parameters = "vec2 uv, vec3 position, vec3 normal";
  std::string body;
  for (const Wire& wire : outputs) {
    request.manifest.outputs.push_back({wire.name, "", wire.type});
    body += outputs.size() == 1 ? "  return " + wire.value + ";\n"
                                : "  out_" + wire.name + " = " + wire.value + ";\n";
    if (outputs.size() > 1) parameters += ", out " + types.Text(wire.type) + " out_" + wire.name;
  }
  const std::string result = outputs.size() == 1 ? types.Text(outputs[0].type) : "void";
  request.shader =
      "uniform float time;\n" + result + " made(" + parameters + ") {\n" + body + "}\n";
  request.width = size;
  request.height = size;
  request.format = PixelFormat::kFloat;
  Scene& scene = request.scene.emplace();
  scene.mesh = std::make_shared<Mesh>(*MakeShape(shape));
  scene.camera.field_of_view = 90;
  scene.camera.distance = 2;
  scene.samples = 1;
  scene.background = glm::dvec4(0);
  scene.lighting.key = dvec3(0);
  scene.lighting.sky = dvec3(0);
  scene.lighting.ground = dvec3(0);
  scene.lighting.lamps = {};
  return request;
}

class MeshContextTest : public testing::TestWithParam<test::NamedContext> {
 protected:
  RenderResult Draw(RenderRequest request) {
    request.context.choice = GetParam().choice;
    RenderResult result = Render(request);
    EXPECT_TRUE(result.ok()) << FirstMessage(result.diagnostics) << result.driver_log;
    return result;
  }
};
INSTANTIATE_TEST_SUITE_P(Contexts, MeshContextTest, testing::ValuesIn(test::AllContexts()),
                         [](const auto& info) { return info.param.name; });

RenderResult Draw(const RenderRequest& request) {
  RenderResult result = Render(request);
  EXPECT_TRUE(result.ok()) << FirstMessage(result.diagnostics) << result.driver_log;
  return result;
}

// The wall reaches from -1 to 1; at distance 2 and 90 degrees it takes the middle half of the
// picture, and uv is known at every pixel.
TEST_P(MeshContextTest, EverythingIsWhereItShouldBe) {
  RenderRequest request = MeshRequest("wall",
                                      {{"color", ir::kVec4, "vec4(uv, position.x, time)"},
                                       {"emission", ir::kVec3, "normal + vec3(position.yz, 0.0)"}},
                                      64);
  request.time = 3;
  request.outputs = {"color", "emission", "lit"};
  request.scene->tiles = {2, 3};
  const RenderResult result = Draw(request);
  ASSERT_EQ(result.outputs.size(), 3u);
  for (uint32_t y = 0; y < 64; ++y) {
    for (uint32_t x = 0; x < 64; ++x) {
      const bool inside = x >= 16 && x < 48 && y >= 16 && y < 48;
      ASSERT_EQ(FloatAt(result.outputs[2], 64, x, y, 3), inside ? 1 : 0) << x << " " << y;
      const float u = (x + 0.5f - 16) / 32;
      const float v = (y + 0.5f - 16) / 32;
      const float color[] = {2 * u, 3 * v, 2 * u - 1, 3};
      const float emission[] = {2 * v - 1, 0, 1};
      for (uint32_t c = 0; c < 4; ++c)
        ASSERT_NEAR(FloatAt(result.outputs[0], 64, x, y, c), inside ? color[c] : 0, 2e-6);
      for (uint32_t c = 0; c < 3; ++c)
        ASSERT_NEAR(FloatAt(result.outputs[1], 64, x, y, c), inside ? emission[c] : 0, 2e-6);
    }
  }
}

TEST_P(MeshContextTest, TheNearerSurfaceIsSeen) {
  for (int order : {0, 1}) {
    Mesh mesh = *MakeShape("wall");
    const Mesh wall = mesh;
    const auto first = static_cast<uint32_t>(mesh.vertices.size());
    for (Vertex vertex : wall.vertices) {
      vertex.position.z = order == 0 ? 0.5f : -0.5f;
      mesh.vertices.push_back(vertex);
    }
    for (uint32_t index : wall.indices) mesh.indices.push_back(first + index);
    RenderRequest request = MeshRequest("wall", {{"emission", ir::kVec3, "position"}}, 16);
    request.scene->mesh = std::make_shared<Mesh>(mesh);
    request.outputs = {"emission"};
    // The middle of the box moves with the second wall.
    const RenderResult result = Draw(request);
    EXPECT_EQ(FloatAt(result.outputs[0], 16, 8, 8, 2), order == 0 ? 0.5f : 0.0f);
  }
}

// --- Light

struct Surface {
  dvec3 base;
  double metallic;
  double roughness;
};

// GGX with the masking of Smith as a ratio of areas (Heitz 2014, equations 72 and 99), which is
// another way to write what the shader computes; radiance for a light of irradiance pi.
dvec3 Reference(const Surface& surface, const dvec3& n, const dvec3& v, const dvec3& l) {
  const double alpha = surface.roughness * surface.roughness;
  const dvec3 h = glm::normalize(l + v);
  const double nl = glm::dot(n, l), nv = glm::dot(n, v), nh = glm::dot(n, h), vh = glm::dot(v, h);
  if (nl <= 0) return dvec3(0);
  const double tan2 = (1 - nh * nh) / (nh * nh);
  const double d =
      1 / (kPi * alpha * alpha * std::pow(nh, 4) * std::pow(1 + tan2 / (alpha * alpha), 2));
  const auto lambda = [alpha](double c) {
    return (std::sqrt(1 + alpha * alpha * (1 - c * c) / (c * c)) - 1) / 2;
  };
  const double g = 1 / (1 + lambda(nl) + lambda(nv));
  const dvec3 f0 = dvec3(0.04) * (1 - surface.metallic) + surface.base * surface.metallic;
  const dvec3 f = f0 + (dvec3(1) - f0) * std::pow(1 - vh, 5);
  const dvec3 diffuse = surface.base * (1 - surface.metallic) / kPi * (dvec3(1) - f);
  return (diffuse + f * (d * g / (4 * nl * nv))) * nl * kPi;
}

std::vector<Wire> Outputs(const Surface& surface) {
  return {{"color", ir::kVec4,
           "vec4(" + std::to_string(surface.base.x) + "," + std::to_string(surface.base.y) + "," +
               std::to_string(surface.base.z) + ",1.0)"},
          {"metallic", ir::kFloat, std::to_string(surface.metallic)},
          {"roughness", ir::kFloat, std::to_string(surface.roughness)}};
}

const Surface kSurfaces[] = {{{0.8, 0.4, 0.1}, 0, 0.9},
                             {{0.2, 0.3, 0.9}, 0, 0.3},
                             {{0.9, 0.7, 0.3}, 1, 0.5},
                             {{0.5, 0.5, 0.5}, 0.25, 0.2}};

TEST_P(MeshContextTest, AWallIsLitAsTheFormulasSay) {
  constexpr uint32_t kSize = 48;
  const dvec3 light = glm::normalize(dvec3(0.4, 0.5, 0.9));
  for (const Surface& surface : kSurfaces) {
    RenderRequest request = MeshRequest("wall", Outputs(surface), kSize);
    request.scene->lighting.key = {1, 2, 3};
    request.scene->lighting.yaw = std::atan2(light.x, light.z) * 180 / kPi;
    request.scene->lighting.pitch = std::asin(light.y) * 180 / kPi;
    const RenderResult result = Draw(request);
    for (uint32_t y = 12; y < 36; ++y) {
      for (uint32_t x = 12; x < 36; ++x) {
        const dvec3 at((x + 0.5) / 12 - 2, (y + 0.5) / 12 - 2, 0);
        const dvec3 expected =
            Reference(surface, {0, 0, 1}, glm::normalize(dvec3(0, 0, 2) - at), light) *
            dvec3(1, 2, 3);
        for (uint32_t c = 0; c < 3; ++c) {
          ASSERT_NEAR(FloatAt(result.outputs[0], kSize, x, y, c), expected[static_cast<int>(c)],
                      1e-4 * (1 + expected[static_cast<int>(c)]))
              << x << " " << y;
        }
      }
    }
  }
}

// A ray through each pixel meets the sphere; the camera is turned, and the light with it.
TEST(MeshLightTest, ASphereIsLitAsTheFormulasSay) {
  constexpr uint32_t kSize = 96;
  const Surface surface = {{0.7, 0.5, 0.3}, 0, 0.5};
  RenderRequest request = MeshRequest("sphere", Outputs(surface), kSize);
  Scene& scene = *request.scene;
  scene.camera.yaw = 40;
  scene.camera.distance = 3;
  scene.camera.field_of_view = 60;
  scene.lighting.key = dvec3(1);
  scene.lighting.yaw = -40;  // so it comes along +z
  scene.lighting.pitch = 0;
  const RenderResult result = Draw(request);
  const double yaw = 40 * kPi / 180;
  const dvec3 back(std::sin(yaw), 0, std::cos(yaw)), right(std::cos(yaw), 0, -std::sin(yaw));
  const dvec3 eye = back * 3.0;
  uint32_t seen = 0;
  for (uint32_t y = 0; y < kSize; ++y) {
    for (uint32_t x = 0; x < kSize; ++x) {
      const double slope = std::tan(kPi / 6);
      const dvec3 ray = glm::normalize(right * ((2 * x + 1.0) / kSize - 1) * slope +
                                       dvec3(0, 1, 0) * ((2 * y + 1.0) / kSize - 1) * slope - back);
      const double b = glm::dot(ray, eye);
      const double under = b * b - (9 - 1);
      if (under < 0.2) continue;  // the silhouette is of straight lines
      ++seen;
      const dvec3 n = eye + ray * (-b - std::sqrt(under));
      const dvec3 expected = Reference(surface, n, -ray, {0, 0, 1});
      for (uint32_t c = 0; c < 3; ++c)
        ASSERT_NEAR(FloatAt(result.outputs[0], kSize, x, y, c), expected[static_cast<int>(c)],
                    4e-3);
    }
  }
  EXPECT_GT(seen, 1000u);
}

// In a white furnace, what is white and matt cannot be told from its surroundings.
TEST(MeshLightTest, AWhiteFurnaceShowsNothing) {
  for (double roughness : {0.2, 0.6, 1.0}) {
    RenderRequest request = MeshRequest("sphere", Outputs({{1, 1, 1}, 0, roughness}), 32);
    request.scene->camera.distance = 3;
    request.scene->lighting.sky = dvec3(0.5);
    request.scene->lighting.ground = dvec3(0.5);
    const RenderResult result = Draw(request);
    for (uint32_t i = 0; i < 32 * 32; ++i) {
      const float alpha = FloatAt(result.outputs[0], 32, i % 32, i / 32, 3);
      EXPECT_NEAR(FloatAt(result.outputs[0], 32, i % 32, i / 32, 0), 0.5 * alpha, 1e-5);
    }
  }
}

// A mirror ball shows a lamp where it reflects the view towards it, nearly as bright: halfway in
// angle. The lamp stands 60 degrees to the right, so the place is where the normal is at 30.
TEST(MeshLightTest, LampsAreWhereTheyShine) {
  RenderRequest request = MeshRequest("sphere", Outputs({{1, 1, 1}, 1, 0}), 128);
  request.scene->camera.distance = 100;  // so that all rays are nearly parallel
  request.scene->camera.field_of_view = 2 * std::atan(1.0 / 100) * 180 / kPi;
  request.scene->camera.yaw = 70;
  request.scene->lighting.lamps[1] = {{2, 4, 8}, 60, 0, 50};
  const RenderResult result = Draw(request);
  uint32_t brightest = 0;
  for (uint32_t x = 0; x < 128; ++x) {
    if (FloatAt(result.outputs[0], 128, x, 64, 0) >
        FloatAt(result.outputs[0], 128, brightest, 64, 0))
      brightest = x;
  }
  EXPECT_NEAR((brightest + 0.5) / 64 - 1, std::sin(kPi / 6), 0.02);
  for (uint32_t c = 0; c < 3; ++c)
    EXPECT_NEAR(FloatAt(result.outputs[0], 128, brightest, 64, c), 2 << c, 0.05 * (2 << c));
}

// The mean light of a wall whose texture's normal leans by `normal`, with the light from yaw,
// pitch.
float LightOf(RenderRequest request, double yaw, double pitch) {
  request.scene->lighting.key = dvec3(1);
  request.scene->lighting.yaw = yaw;
  request.scene->lighting.pitch = pitch;
  const RenderResult result = Draw(request);
  return result.outputs.empty() ? 0 : FloatAt(result.outputs[0], 16, 8, 8, 0);
}

std::vector<Wire> Leaning(const std::string& normal) {
  return {{"normal", ir::kVec3, normal}, {"roughness", ir::kFloat, "1.0"}};
}

// x of a normal is along u, y along v: a normal that leans to the light is lighter.
TEST(MeshLightTest, NormalsPointWhereUAndVGrow) {
  const RenderRequest right = MeshRequest("wall", Leaning("vec3(0.5, 0.0, 0.8)"), 16);
  const RenderRequest up = MeshRequest("wall", Leaning("vec3(0.0, 0.5, 0.8)"), 16);
  EXPECT_GT(LightOf(right, 50, 0), 1.5f * LightOf(right, -50, 0));
  EXPECT_GT(LightOf(up, 0, 50), 1.5f * LightOf(up, 0, -50));
  EXPECT_NEAR(LightOf(right, 0, 50), LightOf(right, 0, -50), 0.02);
  // On the floor, v grows away from the camera, where a light from behind it comes from.
  RenderRequest floor = MeshRequest("plane", Leaning("vec3(0.0, 0.5, 0.8)"), 16);
  floor.scene->camera.pitch = 60;
  EXPECT_GT(LightOf(floor, 180, 40), 1.5f * LightOf(floor, 0, 40));
  // Where the texture is mirrored, u grows to the left.
  RenderRequest mirrored = right;
  Mesh mesh = *mirrored.scene->mesh;
  for (Vertex& vertex : mesh.vertices) vertex.uv.x = 1 - vertex.uv.x;
  ComputeTangents(mesh);
  mirrored.scene->mesh = std::make_shared<Mesh>(mesh);
  EXPECT_NEAR(LightOf(mirrored, -50, 0), LightOf(right, 50, 0), 1e-3);  // beside the middle
  // v grows upwards all the same.
  RenderRequest mirrored_up = up;
  mirrored_up.scene->mesh = mirrored.scene->mesh;
  EXPECT_NEAR(LightOf(mirrored_up, 0, 50), LightOf(up, 0, 50), 1e-5);
}

// A slope of 3 in a height that counts 0.2 leans like the normal (-0.6, 0, 1); upwards alike.
TEST(MeshLightTest, AHeightLeansLikeItsNormal) {
  for (const auto& [height, normal] :
       {std::pair("3.0 * uv.x", "vec3(-0.6, 0.0, 1.0)"), {"-3.0 * uv.y", "vec3(0.0, 0.6, 1.0)"}}) {
    RenderRequest bumpy =
        MeshRequest("wall", {{"height", ir::kFloat, height}, {"roughness", ir::kFloat, "1.0"}}, 16);
    bumpy.scene->relief = 0.2;
    const RenderRequest leaning =
        MeshRequest("wall", Leaning("normalize(" + std::string(normal) + ")"), 16);
    for (double yaw : {-40, 40})
      EXPECT_NEAR(LightOf(bumpy, yaw, 30), LightOf(leaning, yaw, 30), 1e-4);
  }
}

TEST(MeshLightTest, TheBackIsLitLikeTheFront) {
  RenderRequest request = MeshRequest("wall", Outputs(kSurfaces[0]), 16);
  const float front = LightOf(request, 0, 45);
  request.scene->camera.yaw = 180;  // the light goes with the camera
  EXPECT_NEAR(LightOf(request, 0, 45), front, 1e-5);
}

// --- Samples

// A wall that is turned: what its pixels cover adds up to the area of its projection.
TEST(MeshSamplesTest, EdgesAreCoveredInPart) {
  RenderRequest request = MeshRequest("wall", {{"emission", ir::kVec3, "vec3(1.0)"}}, 64);
  request.scene->samples = 8;
  request.scene->camera.yaw = 30;
  const RenderResult result = Draw(request);
  double area = 0;
  int partly = 0;
  for (uint32_t i = 0; i < 64 * 64; ++i) {
    const float alpha = FloatAt(result.outputs[0], 64, i % 64, i / 64, 3);
    area += alpha;
    if (alpha > 0 && alpha < 1) ++partly;
    EXPECT_EQ(std::fmod(alpha * 64, 1), 0) << alpha;
    // Straight alpha: the light is that of what is covered.
    EXPECT_NEAR(FloatAt(result.outputs[0], 64, i % 64, i / 64, 0), alpha > 0 ? 1.0 : 0.0, 0.1);
  }
  // Corners at (+-cos 30, +-1) seen from 2, at depths 2 -+ sin 30: a trapezium.
  const double c = std::cos(kPi / 6);
  const double near_edge = 32 / 1.5, far_edge = 32 / 2.5;
  const double expected = (near_edge + far_edge) * (c * near_edge + c * far_edge);
  EXPECT_NEAR(area, expected, 0.01 * expected);
  EXPECT_GT(partly, 60);
}

TEST(MeshSamplesTest, SquaresOfThePictureFitTogether) {
  RenderRequest request =
      MeshRequest("sphere", {{"color", ir::kVec4, "vec4(uv, fract(8.0 * uv.x), 1.0)"}}, 100);
  request.height = 70;
  request.scene->samples = 2;
  request.scene->lighting = Lighting();
  const RenderResult whole = Draw(request);
  request.tile = 16;
  const RenderResult tiled = Draw(request);
  ASSERT_EQ(whole.outputs[0].floats.size(), tiled.outputs[0].floats.size());
  size_t differ = 0;
  for (size_t i = 0; i < whole.outputs[0].floats.size(); ++i) {
    if (std::abs(whole.outputs[0].floats[i] - tiled.outputs[0].floats[i]) > 1e-3) ++differ;
  }
  EXPECT_LE(differ, 8u);  // a sample on an edge may fall to either side
}

TEST(MeshSamplesTest, OpacityIsTheShareOfSamples) {
  for (double opacity : {0.0, 0.25, 0.5, 1.0}) {
    RenderRequest request = MeshRequest("wall",
                                        {{"color", ir::kVec4, "vec4(1.0, 1.0, 1.0, 0.5)"},
                                         {"opacity", ir::kFloat, std::to_string(2 * opacity)}},
                                        16);
    request.scene->samples = 4;
    const RenderResult result = Draw(request);
    EXPECT_EQ(FloatAt(result.outputs[0], 16, 8, 7, 3), opacity);
  }
}

// Behind a front side, a back side: what is left of the background are products.
TEST(MeshSamplesTest, TheInsideShowsThroughTheOutside) {
  Mesh mesh = *MakeShape("wall");
  const Mesh wall = mesh;
  for (Vertex vertex : wall.vertices) {
    vertex.position.z = -0.1f;
    mesh.vertices.push_back(vertex);
  }
  for (size_t i = 0; i < wall.indices.size(); i += 3) {
    for (size_t corner : {i, i + 2, i + 1}) mesh.indices.push_back(4 + wall.indices[corner]);
  }
  for (double opacity : {0.25, 0.5, 0.75}) {
    RenderRequest request =
        MeshRequest("wall", {{"opacity", ir::kFloat, std::to_string(opacity)}}, 16);
    request.scene->samples = 4;
    request.scene->mesh = std::make_shared<Mesh>(mesh);
    const RenderResult result = Draw(request);
    EXPECT_EQ(FloatAt(result.outputs[0], 16, 8, 7, 3), 1 - (1 - opacity) * (1 - opacity));
  }
}

TEST(MeshSamplesTest, BackgroundsAreWhatWasAskedFor) {
  RenderRequest request = MeshRequest("wall", {{"emission", ir::kVec3, "vec3(0.2)"}}, 16);
  request.format = PixelFormat::kImage8;
  const RenderResult clear = Draw(request);
  EXPECT_EQ(clear.outputs[0].image.channels, 4);
  EXPECT_EQ(clear.outputs[0].image.At(0, 0, 3), 0u);
  EXPECT_EQ(clear.outputs[0].image.At(8, 8, 3), 255u);
  request.scene->background = {1, 0.2158605, 0, 1};  // the codes 255, 128, 0
  const RenderResult filled = Draw(request);
  EXPECT_EQ(filled.outputs[0].image.channels, 3);
  EXPECT_EQ(filled.outputs[0].image.At(0, 0, 0), 255u);
  EXPECT_EQ(filled.outputs[0].image.At(0, 0, 1), 128u);
  EXPECT_EQ(filled.outputs[0].image.At(0, 0, 2), 0u);
  // The tone curve takes 0.04 off, what white surroundings would add: 0.16 is the code 111.
  EXPECT_EQ(filled.outputs[0].image.At(8, 8, 0), 111u);
}

// --- Requests

TEST(MeshRequestTest, NamesOfTheGraphNeverClash) {
  RenderRequest request =
      MeshRequest("wall", {{"emission", ir::kVec3, "mesh_eye + mesh2_shade(uv)"}}, 16);
  request.shader = "const vec3 mesh_eye = vec3(1.0);\nfloat mesh2_shade(vec2 x) { return x.x; }\n" +
                   request.shader;
  request.outputs = {"emission"};
  EXPECT_NEAR(FloatAt(Draw(request).outputs[0], 16, 8, 8, 0), 1 + 4.5 / 8, 1e-5);
}

TEST(MeshRequestTest, WorksInBothDialects) {
  RenderRequest request = MeshRequest("wall", {{"emission", ir::kVec3, "vec3(uv, 1.0)"}}, 16);
  request.manifest.dialect = ShaderDialect::kGlsl450;
  request.outputs = {"emission", "lit"};
  EXPECT_EQ(FloatAt(Draw(request).outputs[1], 16, 8, 8, 2), 1);
}

TEST(MeshRequestTest, RefusesWhatItCannotDraw) {
  const RenderRequest good = MeshRequest("wall", {{"emission", ir::kVec3, "vec3(1.0)"}}, 16);
  RenderRequest request = good;
  request.manifest.is_function = false;
  EXPECT_THAT(FirstMessage(Render(request).diagnostics), HasSubstr("a whole shader cannot"));
  request = good;
  request.manifest.outputs[0].name = "emission = x; discard; //";
  EXPECT_EQ(FirstName(Render(request).diagnostics), "not-renderable");
  request = good;
  request.manifest.outputs[0].type = ir::kFloat;
  EXPECT_EQ(FirstName(Render(request).diagnostics), "not-renderable");
  request = good;
  request.outputs = {"color"};
  EXPECT_EQ(FirstName(Render(request).diagnostics), "unknown-output");
  for (auto spoil :
       {+[](Scene& s) { s.samples = 0; }, +[](Scene& s) { s.samples = 9; },
        +[](Scene& s) { s.mesh = nullptr; }, +[](Scene& s) { s.camera.pitch = 91; },
        +[](Scene& s) { s.mesh = std::make_shared<Mesh>(); },
        +[](Scene& s) { s.camera.yaw = std::nan(""); }, +[](Scene& s) { s.camera.distance = 0; }}) {
    request = good;
    spoil(*request.scene);
    EXPECT_EQ(FirstName(Render(request).diagnostics), "usage");
  }
  request = good;
  request.scene.reset();
  EXPECT_EQ(FirstName(Render(request).diagnostics), "not-renderable");
}

}  // namespace
}  // namespace texgraph::runtime
