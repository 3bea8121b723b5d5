// SPDX-License-Identifier: Apache-2.0
// Materials: normals turn and mirror with their elements, all channels are composited by one share,
// and channels that nobody needs leave nothing in the shader.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/base/source.h"
#include "compiler/compile.h"
#include "tests/blocks/reference.h"
#include "tests/blocks/run_block.h"
#include "tests/blocks/scattered_points.h"

namespace texgraph::blocks {
namespace {

double Length(const Values& v, size_t i) {
  return std::hypot(v.Float(i, 0), v.Float(i, 1), v.Float(i, 2));
}

// ---- The small blocks.

TEST(MaterialsTest, NormalMapsAreWhatTheyMean) {
  const std::vector<Vector> texels = {
      {0.5, 0.5, 1}, {1, 0.5, 0.5}, {0.8, 0.5, 0.9}, {0.3, 0.9, 0.7}, {0.1, 0.2, 0.6}};
  for (bool y_down : {false, true}) {
    for (double strength : {0.0, 1.0, 2.5}) {
      auto out = RunBlock("normal_map", {{"texel", Vectors(texels)},
                                         {"strength", Floats({strength})},
                                         {"y_down", Bools({y_down})}});
      ASSERT_TRUE(out.contains("result"));
      for (size_t i = 0; i < texels.size(); ++i) {
        double x = strength * (2 * texels[i][0] - 1);
        double y = strength * (2 * texels[i][1] - 1) * (y_down ? -1 : 1);
        double z = 2 * texels[i][2] - 1;
        double length = std::sqrt(x * x + y * y + z * z);
        if (length < 1e-6) {
          continue;  // no direction at all
        }
        EXPECT_NEAR(out["result"].Float(i, 0), x / length, 1e-6);
        EXPECT_NEAR(out["result"].Float(i, 1), y / length, 1e-6);
        EXPECT_NEAR(out["result"].Float(i, 2), z / length, 1e-6);
      }
    }
  }
}

TEST(MaterialsTest, CombinedNormalsAreThoseOfTheSumOfHeights) {
  // Two planes, z = a x + b y.
  const double a[2] = {0.3, -1.2}, b[2] = {0.7, 0.25};
  std::vector<Vector> normals;
  for (int i = 0; i < 2; ++i) {
    double length = std::sqrt(1 + a[i] * a[i] + b[i] * b[i]);
    normals.push_back({-a[i] / length, -b[i] / length, 1 / length});
  }
  auto out = RunBlock("combine_normals", {{"base", Vectors({normals[0]})},
                                          {"detail", Vectors({normals[1]})},
                                          {"strength", Floats({0.5})}});
  double x = -(a[0] + 0.5 * a[1]), y = -(b[0] + 0.5 * b[1]), length = std::sqrt(1 + x * x + y * y);
  EXPECT_NEAR(out["result"].Float(0, 0), x / length, 1e-6);
  EXPECT_NEAR(out["result"].Float(0, 1), y / length, 1e-6);
  EXPECT_NEAR(out["result"].Float(0, 2), 1 / length, 1e-6);
}

// ---- One material over another.

struct Channels {
  std::array<double, 4> color;
  std::array<double, 2> slope;  // of the surface's height
  double height, roughness, metallic;
};
const Channels kFront = {{0.9, 0.3, 0.1, 0.8}, {0.4, -0.3}, 0.7, 0.2, 1};
const Channels kBack = {{0.1, 0.2, 0.6, 0.9}, {-0.8, 0.1}, 0.1, 0.75, 0.25};

std::array<double, 3> NormalOf(const std::array<double, 2>& slope) {
  double length = std::sqrt(1 + slope[0] * slope[0] + slope[1] * slope[1]);
  return {-slope[0] / length, -slope[1] / length, 1 / length};
}

std::string Text(const double* values, size_t count) {
  std::string text = "[";
  for (size_t i = 0; i < count; ++i) text += (i > 0 ? "," : "") + std::to_string(values[i]);
  return text + "]";
}

std::string MaterialNode(const std::string& name, const Channels& channels) {
  return "\"" + name + R"(": {"block": "material", "in": {"color": )" +
         Text(channels.color.data(), 4) + R"(, "normal": )" +
         Text(NormalOf(channels.slope).data(), 3) + R"(, "height": )" +
         std::to_string(channels.height) + R"(, "roughness": )" +
         std::to_string(channels.roughness) + R"(, "metallic": )" +
         std::to_string(channels.metallic) + "}}, ";
}

const std::string kOutputs = R"(
    "outputs": {"color": "parts.color", "normal": "parts.normal", "height": "parts.height",
      "roughness": "parts.roughness", "metallic": "parts.metallic", "opacity": "parts.opacity"}})";

TEST(MaterialsTest, OverMixesAllChannelsByTheForegroundsShare) {
  for (bool add : {false, true}) {
    auto out = RunGraph(
        R"({"texgraph": 1, "nodes": {)" + MaterialNode("front", kFront) +
            MaterialNode("back", kBack) +
            R"("both": {"block": "material_over", "in": {"foreground": "front",
        "background": "back", "opacity": 0.5, "mask": 0.9, "relief": ")" +
            (add ? "add" : "replace") +
            R"("}}, "parts": {"block": "material_parts", "in": {"surface": "both"}}},)" + kOutputs,
        ScatteredPoints(4), {0.01, 0.01});
    ASSERT_EQ(out.size(), 6u);
    // Porter and Duff, with premultiplied colours.
    double cover = 0.8 * 0.5 * 0.9, alpha = cover + 0.9 * (1 - cover), share = cover / alpha;
    for (size_t k = 0; k < 3; ++k) {
      double light = kFront.color[k] * cover + kBack.color[k] * 0.9 * (1 - cover);
      EXPECT_NEAR(out["color"].Float(0, k), light / alpha, 1e-5);
    }
    EXPECT_NEAR(out["color"].Float(0, 3), alpha, 1e-5);
    EXPECT_NEAR(out["opacity"].Float(0), alpha, 1e-5);
    EXPECT_NEAR(out["roughness"].Float(0), reference::Mix(0.75, 0.2, share), 1e-5);
    EXPECT_NEAR(out["metallic"].Float(0), reference::Mix(0.25, 1, share), 1e-5);
    EXPECT_NEAR(out["height"].Float(0), add ? 0.1 + share * 0.7 : reference::Mix(0.1, 0.7, share),
                1e-5);
    std::array<double, 3> normal, front = NormalOf(kFront.slope), back = NormalOf(kBack.slope);
    if (add) {
      normal = NormalOf({-0.8 + share * 0.4, 0.1 - share * 0.3});
    } else {
      for (size_t k = 0; k < 3; ++k) normal[k] = reference::Mix(back[k], front[k], share);
      double length = std::hypot(normal[0], normal[1], normal[2]);
      for (double& component : normal) component /= length;
    }
    for (size_t k = 0; k < 3; ++k) EXPECT_NEAR(out["normal"].Float(0, k), normal[k], 1e-5) << add;
  }
}

// ---- Layers of materials.

// A ball's dent in the middle of each element: its slope is twice the way from there, in texture
// space and in the element's frame. The roughness is the element's own number.
const std::string kDome = R"({"texgraph": 1, "functions": {"dome": {
    "inputs": {"uv": "vec2", "tile": "Tile"}, "nodes": {
      "parts": {"block": "tile_parts", "in": {"tile": "tile"}},
      "off": {"block": "add", "in": {"a": "uv", "b": [-0.5, -0.5]}},
      "way": {"block": "multiply", "in": {"a": "off", "b": "parts.size"}},
      "slope": {"block": "multiply", "in": {"a": "way", "b": 2}},
      "xy": {"block": "components", "in": {"vector": "slope"}},
      "up": {"block": "combine3", "in": {"x": "xy.x", "y": "xy.y", "z": 1}},
      "unit": {"block": "normalized", "in": {"vector": "up"}},
      "id": {"block": "tile_random", "in": {"tile": "tile", "stream": 9}},
      "surface": {"block": "material", "in": {"normal": "unit", "roughness": "id",
          "color": [0.5, 0.5, 0.5, 1]}}}, "outputs": {"surface": "surface"}}},
  "nodes": {)";

// In texture space the dent looks the same however the element is turned, mirrored, scaled or
// nested: from one point to another of the same element the slope changes by twice the way.
void ExpectDents(const std::string& nodes, size_t at_least) {
  const std::string text =
      kDome + nodes +
      R"(, "parts": {"block": "material_parts", "in": {"surface": "last.surface"}}},
      "outputs": {"normal": "parts.normal", "roughness": "parts.roughness",
        "opacity": "parts.opacity"}})";
  std::vector<Point> points;
  constexpr double kX = 0.013, kY = -0.008;
  for (Point p : ScatteredPoints(120)) {
    points.push_back(p);
    points.push_back({p.x + kX, p.y + kY});
  }
  auto out = RunGraph(text, points, {1e-5, 1e-5}, 1e-3);
  ASSERT_EQ(out.size(), 3u) << nodes;
  size_t seen = 0;
  for (size_t i = 0; i < points.size(); i += 2) {
    const Values &n = out["normal"], &id = out["roughness"];
    bool same = std::fabs(id.Float(i) - id.Float(i + 1)) < 1e-6;
    if (!same || out["opacity"].Float(i) < 0.999 || out["opacity"].Float(i + 1) < 0.999) continue;
    ++seen;
    EXPECT_NEAR(Length(n, i), 1, 1e-5);
    auto slope = [&](size_t j, size_t axis) { return n.Float(j, axis) / n.Float(j, 2); };
    ASSERT_NEAR(slope(i + 1, 0) - slope(i, 0), 2 * kX, 1e-3) << nodes;
    ASSERT_NEAR(slope(i + 1, 1) - slope(i, 1), 2 * kY, 1e-3) << nodes;
  }
  EXPECT_GE(seen, at_least) << nodes;
}

const std::string kBricks = R"("grid": {"block": "brick_grid", "in": {"rows": 5, "columns": 3}}, )";

TEST(MaterialLayerTest, NormalsTurnWithTheirElements) {
  for (const char* ports :
       {"", R"(, "rotation": [-180, 180])", R"(, "turn": "halves")", R"(, "turn": "quarters")",
        R"(, "flip": "x")", R"(, "flip": "y")",
        R"(, "rotation": [-70, 120], "turn": "quarters", "flip": "both", "scale": [0.6, 1.3],
             "stretch": [0.7, 1.5], "position_min": 0.2, "position_max": 0.8)"}) {
    ExpectDents(kBricks + R"("last": {"block": "material_layer", "in": {"tile": "grid",
        "image": "dome")" +
                    ports + "}}",
                60);
  }
}

TEST(MaterialLayerTest, NormalsTurnWithLyingAndStandingTiles) {
  for (const char* grid : {"herringbone_grid", "basket_weave_grid", "hexagon_grid", "triangle_grid",
                           "octagon_square_grid"}) {
    ExpectDents(std::string(R"("grid": {"block": ")") + grid +
                    R"("}, "last": {"block": "material_layer", "in": {"tile": "grid.tile",
          "image": "dome", "flip": "x"}})",
                20);
  }
}

TEST(MaterialLayerTest, NormalsOfChildrenTurnWithTheirParents) {
  const std::string parent = R"("parent": {"block": "material_layer", "in": {"tile": "grid",
      "image": "dome", "rotation": [-90, 90], "flip": "both", "scale": [0.8, 1.1], "neighbours": 0}}, )";
  const std::string child = R"("child": {"block": "material_layer", "in": {"tile": "parent.inner",
      "image": "dome", "rotation": [20, 60], "turn": "quarters", "flip": "x", "stream": 1, "neighbours": 0}}, )";
  for (const char* inner : {"child.inner", "parent.inner", "parent.inner_rotation"}) {
    ExpectDents(kBricks + parent + child +
                    R"("last": {"block": "material_layer", "in": {"tile": ")" + inner +
                    R"(", "image": "dome", "rotation": [-180, 180], "flip": "y",
          "stretch": [0.8, 1.2], "stream": 2, "neighbours": 0}})",
                20);
  }
}

// Counter-clockwise by 37 degrees, without relief to hide a wrong sign.
TEST(MaterialLayerTest, AKnownAngle) {
  auto out = RunGraph(R"({"texgraph": 1, "functions": {"tilted": {"inputs": {"uv": "vec2"},
      "nodes": {"m": {"block": "material", "in": {"normal": [0.6, 0, 0.8]}}},
      "outputs": {"surface": "m"}}}, "nodes": {
      "grid": {"block": "brick_grid", "in": {"rows": 1, "columns": 1, "row_offset": 0}},
      "last": {"block": "material_layer", "in": {"tile": "grid", "image": "tilted",
        "rotation": [37, 37]}},
      "turned": {"block": "turn_normal", "in": {"normal": [0, 0.6, 0.8], "tile": "last.inner"}},
      "parts": {"block": "material_parts", "in": {"surface": "last.surface"}}},
    "outputs": {"normal": "parts.normal", "emission": "turned"}})",
                      {{0.5, 0.5}, {0.55, 0.45}, {0.4, 0.5}, {0.5, 0.6}}, {1e-4, 1e-4});
  ASSERT_EQ(out.size(), 2u);
  double c = std::cos(37 * std::numbers::pi / 180), s = std::sin(37 * std::numbers::pi / 180);
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(out["normal"].Float(i, 0), 0.6 * c, 1e-5);
    EXPECT_NEAR(out["normal"].Float(i, 1), 0.6 * s, 1e-5);
    EXPECT_NEAR(out["normal"].Float(i, 2), 0.8, 1e-5);
    EXPECT_NEAR(out["emission"].Float(i, 0), -0.6 * s, 1e-5);
    EXPECT_NEAR(out["emission"].Float(i, 1), 0.6 * c, 1e-5);
  }
}

// Where red, green and blue are roughness, metallic and height in every element, they are in what
// is seen, however many half transparent elements lie on each other; and the colour is that of
// `layer`.
TEST(MaterialLayerTest, AllChannelsAreCompositedByOneShare) {
  const std::string element = R"(
      "r": {"block": "tile_random", "in": {"tile": "tile", "stream": 1}},
      "g": {"block": "tile_random", "in": {"tile": "tile", "stream": 2}},
      "xy": {"block": "components", "in": {"vector": "uv"}},
      "rgb": {"block": "combine4", "in": {"x": "r", "y": "g", "z": "xy.x", "w": 1}})";
  const std::string ports = R"("tile": "grid", "rotation": [-40, 40], "scale": [0.8, 1.5],
      "opacity": [0.2, 0.9], "chance": 0.8, "position_min": 0.3, "position_max": 0.7)";
  for (const char* fade : {"", R"(, "fade_size": 16)"}) {
    const std::string far = *fade == '\0' ? "" : R"(, "far": "mean")";
    const std::string far_color = *fade == '\0' ? "" : R"(, "far": [0.3, 0.6, 0.2, 0.7])";
    const std::string text =
        R"({"texgraph": 1, "functions": {
      "whole": {"inputs": {"uv": "vec2", "tile": "Tile"}, "nodes": {)" +
        element + R"(, "m": {"block": "material", "in": {"color": "rgb", "roughness": "r",
          "metallic": "g", "height": "xy.x"}}}, "outputs": {"surface": "m"}},
      "colored": {"inputs": {"uv": "vec2", "tile": "Tile"}, "nodes": {)" +
        element + R"(}, "outputs": {"color": "rgb"}}},
    "nodes": {"grid": {"block": "brick_grid", "in": {"rows": 4, "columns": 3}},
      "mean": {"block": "material", "in": {"color": [0.3, 0.6, 0.2, 0.7], "roughness": 0.3,
        "metallic": 0.6, "height": 0.2}},
      "both": {"block": "material_layer", "in": {"image": "whole", )" +
        ports + fade + far + R"(}},
      "one": {"block": "layer", "in": {"image": "colored", )" +
        ports + fade + far_color + R"(}},
      "one_rgb": {"block": "rgb", "in": {"color": "one.color"}},
      "one_alpha": {"block": "channel", "in": {"color": "one.color", "name": "a"}},
      "parts": {"block": "material_parts", "in": {"surface": "both.surface"}}},
    "outputs": {"color": "parts.color", "emission": "one_rgb", "opacity": "one_alpha",
      "roughness": "parts.roughness", "metallic": "parts.metallic", "height": "parts.height"}})";
    const double pixel = *fade == '\0' ? 1e-4 : 0.018;
    auto out = RunGraph(text, ScatteredPoints(100), {pixel, pixel}, 1e-3);
    ASSERT_EQ(out.size(), 6u);
    const Values& color = out["color"];
    int mixed = 0;
    for (size_t i = 0; i < 100; ++i) {
      double alpha = color.Float(i, 3);
      EXPECT_NEAR(alpha, out["opacity"].Float(i), 1e-4);
      if (alpha < 0.01) continue;
      mixed += alpha > 0.05 && alpha < 0.95;
      ASSERT_NEAR(out["roughness"].Float(i), color.Float(i, 0), 1e-3);
      ASSERT_NEAR(out["metallic"].Float(i), color.Float(i, 1), 1e-3);
      ASSERT_NEAR(out["height"].Float(i), color.Float(i, 2), 1e-3);
      for (size_t k = 0; k < 3; ++k) {
        ASSERT_NEAR(color.Float(i, k), out["emission"].Float(i, k), 1e-3);
      }
    }
    EXPECT_GT(mixed, 50);
  }
}

// ---- What is not needed is not there.

std::string ShaderOf(const std::string& outputs) {
  const std::string text = R"({"texgraph": 1,
    "textures": {"paint": {"file": "brick.png"},
      "relief": {"file": "mortar.png", "color_space": "data"}},
    "functions": {"tile_surface": {"inputs": {"uv": "vec2"}, "nodes": {
        "picture": {"block": "image", "in": {"picture": "paint", "uv": "uv"}},
        "texel": {"block": "image", "in": {"picture": "relief", "uv": "uv"}},
        "slope": {"block": "normal_map", "in": {"texel": "texel"}},
        "m": {"block": "material", "in": {"color": "picture", "normal": "slope",
          "roughness": 0.3}}}, "outputs": {"surface": "m"}}},
    "nodes": {"grid": {"block": "brick_grid", "in": {}},
      "tiles": {"block": "material_layer", "in": {"tile": "grid", "image": "tile_surface",
        "rotation": [-20, 20]}},
      "ground": {"block": "material", "in": {"roughness": 0.9}},
      "both": {"block": "material_over", "in": {"foreground": "tiles.surface",
        "background": "ground"}},
      "parts": {"block": "material_parts", "in": {"surface": "both"}}},
    "outputs": {)" + outputs +
                           "}}";
  Sources sources;
  Diagnostics diagnostics;
  SourceId source = sources.Add(PictureFolder() + "materials.json", text);
  std::optional<Compiled> compiled =
      Compile(source, graph::DocumentFormat::kJson, {}, sources, diagnostics);
  EXPECT_TRUE(compiled.has_value()) << FormatDiagnostics(diagnostics, sources, false);
  return compiled.has_value() ? compiled->glsl : "";
}

TEST(MaterialTracesTest, ChannelsThatNobodyNeedsAreGone) {
  const std::string color = ShaderOf(R"("color": "parts.color")");
  EXPECT_NE(color.find("texture"), std::string::npos);
  for (const char* gone : {"relief", "normal", "roughness", "metallic", "height", "right", "slope"})
    EXPECT_EQ(color.find(gone), std::string::npos) << gone << "\n" << color;
  const std::string lit = ShaderOf(R"("color": "parts.color", "normal": "parts.normal")");
  EXPECT_NE(lit.find("relief"), std::string::npos);
  for (const char* gone : {"roughness", "metallic", "height"})
    EXPECT_EQ(lit.find(gone), std::string::npos) << gone << "\n" << lit;
}

}  // namespace
}  // namespace texgraph::blocks
