// SPDX-License-Identifier: Apache-2.0
// What holds for a whole wall of layers: it has no border where its grid is toroidal (O35), and
// what is painted on an element moves with it as if it were a part of it (O36). That a brick has
// one seed (O34) and that joints are equally wide and filtered exactly (O37) is in tiles_test.cc,
// and for the other grids in grids_test.cc.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/blocks/run_block.h"

namespace texgraph::blocks {
namespace {

// Bricks that reach over their cells, with a smaller one on each, all of random colours.
std::string ToroidalWall(bool toroidal) {
  return std::string(R"({"texgraph": 1,
    "functions": {"face": {"inputs": {"uv": "vec2", "tile": "Tile"}, "nodes": {
        "shade": {"block": "tile_random_color", "in": {"tile": "tile"}},
        "c": {"block": "rgba", "in": {"color": "shade"}}}, "outputs": {"color": "c"}}},
    "nodes": {"grid": {"block": "brick_grid", "in": {"rows": 4, "columns": 2, "toroidal": )") +
         (toroidal ? "true" : "false") + R"(}},
      "brick": {"block": "layer", "in": {"tile": "grid", "image": "face", "rotation": [-10, 10],
        "position_min": 0.3, "position_max": 0.7, "scale": [0.7, 1.1]}},
      "mark": {"block": "layer", "in": {"tile": "brick.inner", "image": "face", "scale": [0.3, 0.5],
        "position_min": 0.2, "position_max": 0.8, "stream": 1}},
      "wall": {"block": "over", "in": {"foreground": "mark.color", "background": "brick.color"}}},
    "outputs": {"color": "wall"}})";
}

// The mean difference of the colours at two lists of points.
double Difference(const std::string& graph, const std::vector<Point>& a,
                  const std::vector<Point>& b) {
  std::vector<Point> both = a;
  both.insert(both.end(), b.begin(), b.end());
  auto outputs = RunGraph(graph, both, {1.0 / 512, 1.0 / 512}, 2e-3);
  double sum = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    for (size_t c = 0; c < 4; ++c) {
      sum += std::fabs(outputs["color"].Float(i, c) - outputs["color"].Float(a.size() + i, c));
    }
  }
  return sum / (4 * static_cast<double>(a.size()));
}

// O35
TEST(WallTest, ToroidalWallsRepeat) {
  std::vector<Point> here, right, above;
  for (int i = 0; i < 256; ++i) {
    Point p = {(i * 37 % 256) / 256.0 + 1.0 / 1024, (i * 101 % 256) / 256.0 + 1.0 / 1024};
    here.push_back(p);
    right.push_back({p.x + 1, p.y});
    above.push_back({p.x - 1, p.y + 2});
  }
  EXPECT_LT(Difference(ToroidalWall(true), here, right), 1e-4);
  EXPECT_LT(Difference(ToroidalWall(true), here, above), 1e-4);
  EXPECT_GT(Difference(ToroidalWall(false), here, right), 0.05);
}

// A parent that is the same for all tiles.
struct Pose {
  Point position;
  double scale, degrees;
};

// Where in the child's image the points lie that have the coordinates `local` in the parent.
std::vector<Point> InChild(const Pose& pose, const std::vector<Point>& local) {
  constexpr int kColumns = 3, kRows = 6;
  const std::string at = std::to_string(pose.position.x) + ", " + std::to_string(pose.position.y);
  const std::string scale = std::to_string(pose.scale), angle = std::to_string(pose.degrees);
  const std::string graph = R"({"texgraph": 1,
    "functions": {"where": {"inputs": {"uv": "vec2"}, "nodes": {
        "p": {"block": "components", "in": {"vector": "uv"}},
        "c": {"block": "combine4", "in": {"x": "p.x", "y": "p.y"}}}, "outputs": {"color": "c"}}},
    "nodes": {"grid": {"block": "brick_grid", "in": {"rows": 6, "columns": 3, "row_offset": 0}},
      "parent": {"block": "layer", "in": {"tile": "grid", "image": "where", "neighbours": 0,
        "position_min": [)" +
                            at + R"(], "position_max": [)" + at + R"(],
        "scale": [)" + scale +
                            ", " + scale + R"(], "rotation": [)" + angle + ", " + angle + R"(]}},
      "child": {"block": "layer", "in": {"tile": "parent.inner", "image": "where", "neighbours": 0,
        "position_min": 0.3, "position_max": 0.7, "scale": [0.3, 0.6], "rotation": [-180, 180],
        "fit": "contain", "stream": 3}}},
    "outputs": {"color": "child.color"}})";
  const double c = std::cos(pose.degrees * std::numbers::pi / 180);
  const double s = std::sin(pose.degrees * std::numbers::pi / 180);
  std::vector<Point> points;
  for (int cell = 0; cell < 6; ++cell) {
    for (const Point& p : local) {
      // In texture space, from the middle of the parent.
      double x = (p.x - 0.5) * pose.scale / kColumns, y = (p.y - 0.5) * pose.scale / kRows;
      points.push_back({(cell % 3 + pose.position.x) / kColumns + c * x - s * y,
                        (cell + pose.position.y) / kRows + s * x + c * y});
    }
  }
  auto outputs = RunGraph(graph, points, {1e-4, 1e-4}, 1e-3);
  std::vector<Point> seen;
  for (size_t i = 0; i < points.size(); ++i) {
    seen.push_back({outputs["color"].Float(i, 0), outputs["color"].Float(i, 1)});
  }
  return seen;
}

// O36
TEST(WallTest, AParentMovesItsChildRigidly) {
  std::vector<Point> local;
  for (const Vector& p : Lattice(0.2, 0.8, 8)) local.push_back({p[0], p[1]});
  const std::vector<Point> still = InChild({{0.5, 0.5}, 0.8, 0}, local);
  for (Pose pose : {Pose{{0.45, 0.52}, 0.8, 0}, {{0.5, 0.5}, 0.8, 11}, {{0.55, 0.47}, 0.5, -16}}) {
    const std::vector<Point> moved = InChild(pose, local);
    for (size_t i = 0; i < still.size(); ++i) {
      ASSERT_NEAR(still[i].x, moved[i].x, 2e-3) << i;
      ASSERT_NEAR(still[i].y, moved[i].y, 2e-3) << i;
    }
  }
}

}  // namespace
}  // namespace texgraph::blocks
