// SPDX-License-Identifier: Apache-2.0
// The layer of a tile against a reference in double precision, and what must hold for every layer:
// it is rigid in texture space, children move with their parents, edges have the share of the
// pixel, elements that fill their cell have no seam.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/blocks/layer_reference.h"
#include "tests/blocks/reference.h"
#include "tests/blocks/run_block.h"
#include "tests/blocks/scattered_points.h"

namespace texgraph::blocks {
namespace {

using reference::Frame;
using reference::InFrame;
using reference::Limits;
using reference::Pcg;
using reference::PlaceIn;

// What the graphs below give for a layer: the image is a function that paints its own coordinate,
// so the colour shows where in the image a point lies.
struct Seen {
  Point q;  // in the image
  double alpha = 0;
  Point inner;  // the same from the inner tile
  Point size;   // of the inner tile
};

// A graph with one layer, or a parent and a child ("child" not empty); the output is that of the
// last. Each tile shows its own element alone; for the others see overlap_test.cc.
std::string GraphOf(const std::string& grid, const std::string& parent, const std::string& child,
                    const std::string& inner = "inner") {
  std::string last = child.empty() ? "parent" : "child";
  std::string text = R"({"texgraph": 1,
    "functions": {"where": {"inputs": {"uv": "vec2"}, "nodes": {
        "p": {"block": "components", "in": {"vector": "uv"}},
        "c": {"block": "combine4", "in": {"x": "p.x", "y": "p.y"}}}, "outputs": {"color": "c"}}},
    "nodes": {"grid": {"block": "brick_grid", "in": )" +
                     grid + R"(},
      "parent": {"block": "layer", "in": {"tile": "grid", "image": "where", "neighbours": 0)" +
                     parent + "}}";
  if (!child.empty()) {
    text += R"(, "child": {"block": "layer", "in": {"tile": "parent.)" + inner +
            R"(", "image": "where", "neighbours": 0)" + child + "}}";
  }
  text += R"(, "parts": {"block": "tile_parts", "in": {"tile": ")" + last + R"(.inner"}},
      "local": {"block": "components", "in": {"vector": "parts.local"}},
      "size": {"block": "components", "in": {"vector": "parts.size"}},
      "local3": {"block": "combine3", "in": {"x": "local.x", "y": "local.y"}},
      "size3": {"block": "combine3", "in": {"x": "size.x", "y": "size.y"}}},
    "outputs": {"color": ")" +
          last + R"(.color", "normal": "local3", "emission": "size3"}})";
  return text;
}

std::vector<Seen> RunLayer(const std::string& grid, const std::string& parent,
                           const std::string& child, const std::vector<Point>& points,
                           double pixel = 1e-4) {
  auto outputs = RunGraph(GraphOf(grid, parent, child), points, {pixel, pixel}, 1e-3);
  std::vector<Seen> seen(points.size());
  if (outputs.size() != 3) {
    ADD_FAILURE() << "the graph has no outputs";
    return seen;
  }
  for (size_t i = 0; i < points.size(); ++i) {
    const Values& color = outputs["color"];
    seen[i] = {{color.Float(i, 0), color.Float(i, 1)},
               color.Float(i, 3),
               {outputs["normal"].Float(i, 0), outputs["normal"].Float(i, 1)},
               {outputs["emission"].Float(i, 0), outputs["emission"].Float(i, 1)}};
  }
  return seen;
}

constexpr int kRows = 6, kColumns = 3;
const char* const kGrid = R"({"rows": 6, "columns": 3, "row_offset": 0})";

Frame CellFrame(Point p) {
  int column = static_cast<int>(std::floor(p.x * kColumns)),
      row = static_cast<int>(std::floor(p.y * kRows));
  return {{(column + 0.5) / kColumns, (row + 0.5) / kRows},
          0,
          {1.0 / kColumns, 1.0 / kRows},
          reference::CellHash(column, row, 0)};
}

const Limits kParentLimits = {{0.4, 0.45}, {0.6, 0.55}, 0.7, 0.95, -20, 35, false, 0};
const char* const kParent =
    R"(, "position_min": [0.4, 0.45], "position_max": [0.6, 0.55], "scale": [0.7, 0.95], "rotation": [-20, 35])";
const Limits kChildLimits = {{0.1, 0.2}, {0.9, 0.7}, 0.3, 0.6, -180, 180, true, 3};
const char* const kChild =
    R"(, "position_min": [0.1, 0.2], "position_max": [0.9, 0.7], "scale": [0.3, 0.6], "rotation": [-180, 180], "fit": "contain", "stream": 3)";

void ExpectAsTheReferenceSays(const std::string& parent_ports, const Limits& parent_limits) {
  std::vector<Point> points = ScatteredPoints(600);
  std::vector<Seen> parents = RunLayer(kGrid, parent_ports, "", points);
  std::vector<Seen> children = RunLayer(kGrid, parent_ports, kChild, points);
  for (size_t i = 0; i < points.size(); ++i) {
    Frame parent = PlaceIn(CellFrame(points[i]), parent_limits);
    Frame child = PlaceIn(parent, kChildLimits);
    Point p = InFrame(parent, points[i]), c = InFrame(child, points[i]);
    ASSERT_NEAR(parents[i].q.x, p.x, 2e-4);
    ASSERT_NEAR(parents[i].q.y, p.y, 2e-4);
    ASSERT_NEAR(children[i].q.x, c.x, 1e-3);
    ASSERT_NEAR(children[i].q.y, c.y, 1e-3);
    EXPECT_EQ(parents[i].inner.x, parents[i].q.x);
    EXPECT_EQ(children[i].inner.y, children[i].q.y);
    EXPECT_NEAR(children[i].size.x, child.size.x, 1e-5);
    EXPECT_NEAR(children[i].size.y, child.size.y, 1e-5);
    bool inside = c.x > 0.001 && c.x < 0.999 && c.y > 0.001 && c.y < 0.999;
    bool outside = c.x < -0.001 || c.x > 1.001 || c.y < -0.001 || c.y > 1.001;
    if (inside || outside) {
      EXPECT_NEAR(children[i].alpha, inside ? 1 : 0, 1e-4) << points[i].x << " " << points[i].y;
    }
  }
}

// A square pixel of the width w: what the box from 0 to 1 has of it, and of its part in the cell
// from 0 to 1, in the cell's own frame.
double Overlap(double q, double w) {
  return std::max(std::min(q + w / 2, 1.0) - std::max(q - w / 2, 0.0), 0.0) / w;
}

TEST(BoxShareTest, IsTheAreaThatThePixelHasOfTheBox) {
  for (double w : {0.01, 0.2, 0.9}) {
    for (double scale : {0.5, 1.0}) {  // of the box, whose middle is that of its cell
      std::vector<Vector> q, local;
      for (int i = 0; i < 400; ++i) {
        const double x = -0.2 + 1.4 * (i / 4 % 10) / 10, y = -0.2 + 1.4 * (i / 40) / 10;
        // The pixels of a quad: the footprint is w in each direction of the box.
        q.push_back({x + (i % 2) * w, y + (i / 2 % 2) * w});
        local.push_back({0.5 + scale * (q.back()[0] - 0.5), 0.5 + scale * (q.back()[1] - 0.5)});
      }
      for (bool cut : {false, true}) {
        const Values share =
            RunBlock("box_share", {{"q", Vectors(q)},
                                   {"cell_in_q", Vectors({{1 / scale, 1 / scale}})},
                                   {"local", Vectors(local)},
                                   {"cut", Bools({cut})}})["result"];
        ASSERT_EQ(share.count, q.size());
        for (size_t i = 0; i < q.size(); ++i) {
          double wanted = 1;
          for (size_t c = 0; c < 2; ++c) {
            const double within = Overlap(local[i][c], scale * w);
            // Outside of its cell the pixel counts as one that is half in it.
            wanted *= std::min(Overlap(q[i][c], w) / (cut ? std::max(within, 0.5) : 1), 1.0);
          }
          EXPECT_NEAR(share.Float(i), wanted, 2e-4) << w << " " << scale << " " << cut << " " << i;
        }
      }
    }
  }
}

TEST(LayerTest, DrawsWhereTheReferenceSays) { ExpectAsTheReferenceSays(kParent, kParentLimits); }

TEST(LayerTest, StretchedElementsAreWhereTheReferenceSays) {
  Limits limits = kParentLimits;
  limits.stretch_min = 0.6;
  limits.stretch_max = 1.4;
  ExpectAsTheReferenceSays(std::string(kParent) + R"(, "stretch": [0.6, 1.4])", limits);
}

// Within the element the image is turned and mirrored by the bits of the layer's seed.
TEST(LayerTest, TurnsAndFlips) {
  std::vector<Point> points = ScatteredPoints(500);
  std::vector<Seen> plain = RunLayer(kGrid, kParent, "", points);
  struct Mode {
    const char* ports;
    uint32_t bits;  // that have a meaning: 1 a quarter, 2 a half, 4 left and right, 8 up and down
  };
  for (const Mode& mode : {Mode{R"(, "turn": "halves")", 2},
                           {R"(, "turn": "quarters")", 3},
                           {R"(, "flip": "x")", 4},
                           {R"(, "flip": "y")", 8},
                           {R"(, "flip": "both")", 12},
                           {R"(, "turn": "quarters", "flip": "x")", 7}}) {
    std::vector<Seen> seen = RunLayer(kGrid, kParent + std::string(mode.ports), "", points);
    uint32_t set = 0, clear = 0;
    for (size_t i = 0; i < points.size(); ++i) {
      uint32_t seed = PlaceIn(CellFrame(points[i]), kParentLimits).seed;
      uint32_t bits = Pcg(seed - 4) >> 16 & mode.bits;
      set |= bits;
      clear |= ~bits & mode.bits;
      Point p{plain[i].q.x - 0.5, plain[i].q.y - 0.5};
      if (bits & 1) p = {p.y, -p.x};
      if (bits & 2) p = {-p.x, -p.y};
      if (bits & 4) p.x = -p.x;
      if (bits & 8) p.y = -p.y;
      ASSERT_NEAR(seen[i].q.x, p.x + 0.5, 1e-4) << mode.ports;
      ASSERT_NEAR(seen[i].q.y, p.y + 0.5, 1e-4) << mode.ports;
      // The element itself stays where it is, and its children see it turned.
      EXPECT_EQ(seen[i].alpha, plain[i].alpha);
      EXPECT_EQ(seen[i].inner.x, seen[i].q.x);
      EXPECT_EQ(seen[i].size.x, bits & 1 ? plain[i].size.y : plain[i].size.x);
    }
    EXPECT_EQ(set, mode.bits) << mode.ports;
    EXPECT_EQ(clear, mode.bits) << mode.ports;
  }
}

// A child in a frame that follows one thing of its parent lies as in a parent that does nothing
// else.
TEST(LayerTest, ChildrenFollowOneThingOfTheirParents) {
  std::vector<Point> points = ScatteredPoints(400);
  auto run = [&](const std::string& parent, const char* inner) {
    auto outputs = RunGraph(GraphOf(kGrid, parent, kChild, inner), points, {1e-4, 1e-4}, 1e-3);
    std::vector<Point> where;
    for (size_t i = 0; i < points.size(); ++i) {
      where.push_back({outputs["color"].Float(i, 0), outputs["color"].Float(i, 1)});
    }
    return where;
  };
  const std::string position = R"(, "position_min": [0.3, 0.35], "position_max": [0.6, 0.7])";
  const std::string scale = R"(, "scale": [0.6, 0.9], "stretch": [0.8, 1.2])";
  const std::string rotation = R"(, "rotation": [-60, 45])";
  const std::string all = position + scale + rotation + R"(, "turn": "quarters")";
  struct Case {
    const char* inner;
    std::string alone;
  };
  for (const Case& one : {Case{"inner_position", position}, Case{"inner_scale", scale},
                          Case{"inner_rotation", rotation}}) {
    std::vector<Point> followed = run(all, one.inner), wanted = run(one.alone, "inner");
    for (size_t i = 0; i < points.size(); ++i) {
      ASSERT_NEAR(followed[i].x, wanted[i].x, 1e-4) << one.inner;
      ASSERT_NEAR(followed[i].y, wanted[i].y, 1e-4) << one.inner;
    }
  }
}

// Distances in the image, in texture space, are distances on the surface: a turned brick does not
// shear. Without a reference.
TEST(LayerTest, IsRigidInTextureSpace) {
  std::vector<Point> points = ScatteredPoints(400);
  std::vector<Point> moved = points;
  for (Point& p : moved) {
    p = {p.x + 0.003, p.y - 0.002};
  }
  const std::string turned =
      std::string(kParent) + R"(, "turn": "quarters", "flip": "both", "stretch": [0.5, 1.5])";
  for (auto [parent, child] : {std::pair<std::string, const char*>{kParent, ""},
                               {kParent, kChild},
                               {turned, ""},
                               {turned, kChild}}) {
    std::vector<Seen> a = RunLayer(kGrid, parent, child, points),
                      b = RunLayer(kGrid, parent, child, moved);
    int compared = 0;
    for (size_t i = 0; i < points.size(); ++i) {
      if (CellFrame(points[i]).seed != CellFrame(moved[i]).seed) {
        continue;
      }
      ++compared;
      double dx = (b[i].q.x - a[i].q.x) * a[i].size.x, dy = (b[i].q.y - a[i].q.y) * a[i].size.y;
      EXPECT_NEAR(std::hypot(dx, dy), std::hypot(0.003, 0.002), 2e-5);
    }
    EXPECT_GT(compared, 300);
  }
}

// Where the child lies in its parent's image does not depend on how the parent was moved, turned
// and scaled.
TEST(LayerTest, ChildrenMoveWithTheirParents) {
  std::vector<Point> points = ScatteredPoints(300);
  std::vector<std::string> parents = {
      R"(, "rotation": 0)",
      R"(, "rotation": 25, "position_min": [0.3, 0.6], "position_max": [0.3, 0.6], "scale": 0.8)",
      R"(, "rotation": [-40, 40], "scale": [0.5, 1])"};
  for (const std::string& parent : parents) {
    std::vector<Seen> outer = RunLayer(kGrid, parent, "", points),
                      inner = RunLayer(kGrid, parent, kChild, points);
    for (size_t i = 0; i < points.size(); ++i) {
      // The child in a parent that was not moved at all has the cell's own frame around it, with
      // the parent's seed.
      Frame cell = CellFrame(points[i]);
      Frame child = PlaceIn({{0.5 * cell.size.x, 0.5 * cell.size.y}, 0, cell.size, Pcg(cell.seed)},
                            kChildLimits);
      Point q = InFrame(child, {outer[i].q.x * cell.size.x, outer[i].q.y * cell.size.y});
      EXPECT_NEAR(inner[i].q.x, q.x, 2e-3) << parent;
      EXPECT_NEAR(inner[i].q.y, q.y, 2e-3) << parent;
    }
  }
}

TEST(LayerTest, SiblingsVaryIndependently) {
  std::vector<Point> points;
  for (int i = 0; i < 400; ++i) {
    points.push_back({(i % 20 + 0.5) / kColumns, (i / 20 + 0.5) / kRows});
  }
  std::vector<Seen> a =
      RunLayer(kGrid, R"(, "position_min": 0, "position_max": 1, "stream": 1)", "", points);
  std::vector<Seen> b =
      RunLayer(kGrid, R"(, "position_min": 0, "position_max": 1, "stream": 2)", "", points);
  double covariance = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    covariance += (a[i].q.x - 0.5) * (b[i].q.x - 0.5);
  }
  EXPECT_LT(std::fabs(covariance / 400 * 12), 5 / std::sqrt(400.0));
}

// The edge of an element away from the border of its cell: the share of the pixel, exactly.
TEST(LayerTest, EdgesAreTheShareOfThePixel) {
  std::vector<Point> points = ScatteredPoints(2000);
  for (double pixel : {0.002, 0.01}) {
    std::vector<Seen> seen = RunLayer(kGrid, R"(, "scale": 0.5)", "", points, pixel);
    for (size_t i = 0; i < points.size(); ++i) {
      Frame cell = CellFrame(points[i]);
      auto overlap = [&](double p, double middle, double size) {
        double low = middle - size / 4, high = middle + size / 4;
        return std::fmax(0, std::fmin(p + pixel / 2, high) - std::fmax(p - pixel / 2, low)) / pixel;
      };
      double wanted = overlap(points[i].x, cell.origin.x, cell.size.x) *
                      overlap(points[i].y, cell.origin.y, cell.size.y);
      ASSERT_NEAR(seen[i].alpha, wanted, 0.02) << points[i].x << " " << points[i].y;
    }
  }
}

// Elements that fill their cells leave no seam, near or far.
TEST(LayerTest, FullElementsHaveNoSeam) {
  std::vector<Point> points = ScatteredPoints(1000);
  for (int i = 0; i < 100; ++i) {
    points.push_back({i / 100.0, 0.5 / kRows});
    points.push_back({1.0 / kColumns + (i - 50) * 1e-5, 0.31});
  }
  for (double pixel : {0.0005, 0.02, 0.4, 3.0}) {
    for (const Seen& seen : RunLayer(kGrid, "", "", points, pixel)) {
      ASSERT_NEAR(seen.alpha, 1, 1e-4) << pixel;
    }
  }
}

// From afar an element shows, on average, the share of the cell that it takes.
TEST(LayerTest, FarAwayTheCoverageIsTheShareOfTheCell) {
  std::vector<Point> points = ScatteredPoints(2000);
  for (double scale : {0.3, 0.6, 0.9}) {
    double sum = 0;
    for (const Seen& seen :
         RunLayer(kGrid, R"(, "scale": )" + std::to_string(scale), "", points, 1.5)) {
      sum += seen.alpha / static_cast<double>(points.size());
    }
    EXPECT_NEAR(sum, scale * scale, 0.12) << scale;
  }
}

TEST(LayerTest, OpacityAndChance) {
  std::vector<Point> points;
  for (int i = 0; i < 4000; ++i) {
    points.push_back({(i % 80 + 0.5) / kColumns, (i / 80 + 0.5) / kRows});
  }
  double low = 1, high = 0, sum = 0;
  for (const Seen& seen : RunLayer(kGrid, R"(, "opacity": [0.2, 0.6])", "", points)) {
    low = std::fmin(low, seen.alpha);
    high = std::fmax(high, seen.alpha);
    sum += seen.alpha;
  }
  EXPECT_GE(low, 0.2 - 1e-5);
  EXPECT_LE(high, 0.6 + 1e-5);
  EXPECT_NEAR(sum / 4000, 0.4, 5 * 0.4 / std::sqrt(12 * 4000.0));
  int drawn = 0;
  for (const Seen& seen : RunLayer(kGrid, R"(, "chance": 0.3)", "", points)) {
    drawn += seen.alpha > 0.5;
    EXPECT_TRUE(seen.alpha < 1e-4 || seen.alpha > 1 - 1e-4);
  }
  EXPECT_NEAR(drawn, 1200, 5 * std::sqrt(4000 * 0.3 * 0.7));
  // Those that are drawn are as opaque as all would be.
  sum = 0;
  for (const Seen& seen : RunLayer(kGrid, R"(, "opacity": [0, 1], "chance": 0.3)", "", points)) {
    sum += seen.alpha;
  }
  EXPECT_NEAR(sum / drawn, 0.5, 5 / std::sqrt(12.0 * drawn));
}

// All there from the size on, gone at half of it, and between these without a jump.
TEST(LayerTest, GoesToItsMeanFromFarAway) {
  std::vector<Point> points = ScatteredPoints(50);
  const std::string fade = R"(, "scale": 0.8, "fade_size": 20, "far": [0.25, 0.5, 0.75, 0.6])";
  std::vector<Seen> before;
  // The shorter side of an element is 0.8 / 6 of the surface: it has 20 pixels of this size.
  const double size = 0.8 / 6 / 20;
  for (double pixel = 0.9 * size; pixel < 2.5 * size; pixel *= 1.02) {
    std::vector<Seen> seen = RunLayer(kGrid, fade, "", points, pixel),
                      plain = RunLayer(kGrid, R"(, "scale": 0.8)", "", points, pixel);
    for (size_t i = 0; i < points.size(); ++i) {
      if (pixel < size) {
        EXPECT_EQ(seen[i].alpha, plain[i].alpha);
      } else if (pixel > 2 * size) {
        EXPECT_NEAR(seen[i].alpha, 0.6, 1e-6);
        EXPECT_NEAR(seen[i].q.x, 0.25, 1e-6);
      } else {
        double near = 2 * size / pixel - 1;
        EXPECT_NEAR(seen[i].alpha, 0.6 + near * (plain[i].alpha - 0.6), 2e-3);
        double red = 0.25 * 0.6 + near * (plain[i].q.x * plain[i].alpha - 0.25 * 0.6);
        EXPECT_NEAR(seen[i].q.x * seen[i].alpha, red, 2e-3);
      }
      if (!before.empty()) {
        EXPECT_NEAR(seen[i].alpha, before[i].alpha, 0.06);
      }
    }
    before = seen;
  }
}

// A function of the graph gets the element's own tile: what it draws from it is what the inner tile
// says.
TEST(LayerTest, ImagesKnowTheirElement) {
  const std::vector<Point> points = ScatteredPoints(200);
  auto outputs = RunGraph(R"({"texgraph": 1,
    "functions": {"mark": {"inputs": {"uv": "vec2", "tile": "Tile"}, "nodes": {
        "number": {"block": "tile_random", "in": {"tile": "tile", "stream": 5}},
        "c": {"block": "combine4", "in": {"x": "number"}}}, "outputs": {"color": "c"}}},
    "nodes": {"grid": {"block": "brick_grid", "in": {"rows": 6, "columns": 3}},
      "marked": {"block": "layer", "in": {"tile": "grid", "image": "mark"}},
      "number": {"block": "tile_random", "in": {"tile": "marked.inner", "stream": 5}},
      "wanted": {"block": "combine3", "in": {"x": "number"}}},
    "outputs": {"color": "marked.color", "emission": "wanted"}})",
                          points, {1e-4, 1e-4});
  ASSERT_EQ(outputs.size(), 2u);
  float low = 1, high = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const float seen = outputs["color"].Float(i, 0);
    EXPECT_EQ(seen, outputs["emission"].Float(i, 0));
    low = std::min(low, seen);
    high = std::max(high, seen);
  }
  EXPECT_LT(low, 0.2);
  EXPECT_GT(high, 0.8);
}

TEST(LayerTest, Fit) {
  std::vector<Point> points = {{0.5 / kColumns, 0.5 / kRows}};
  Seen stretch = RunLayer(kGrid, "", "", points)[0];
  Seen contain = RunLayer(kGrid, R"(, "fit": "contain")", "", points)[0];
  Seen cover = RunLayer(kGrid, R"(, "fit": "cover")", "", points)[0];
  EXPECT_FLOAT_EQ(stretch.size.x, 1.0f / 3);
  EXPECT_FLOAT_EQ(stretch.size.y, 1.0f / 6);
  EXPECT_FLOAT_EQ(contain.size.x, 1.0f / 6);
  EXPECT_FLOAT_EQ(contain.size.y, 1.0f / 6);
  EXPECT_FLOAT_EQ(cover.size.x, 1.0f / 3);
  EXPECT_FLOAT_EQ(cover.size.y, 1.0f / 3);
}

TEST(LayerTest, TintChangesTheColourAlone) {
  std::vector<Point> points = {{0.4 / kColumns, 0.7 / kRows}};
  Seen seen = RunLayer(kGrid, R"(, "tint": [0.5, 2, 1])", "", points)[0];
  EXPECT_NEAR(seen.q.x, 0.4 * 0.5, 1e-5);
  EXPECT_NEAR(seen.q.y, 0.7 * 2, 1e-5);
  EXPECT_EQ(seen.alpha, 1.0);
}

}  // namespace
}  // namespace texgraph::blocks
