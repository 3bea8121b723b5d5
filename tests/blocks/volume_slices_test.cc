// SPDX-License-Identifier: Apache-2.0
// volume_slices against the mathematics of slices that lie on each other.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/blocks/run_block.h"

namespace texgraph::blocks {
namespace {

// The volume's colour is its place: red and green from u and v, blue from the height.
std::string Graph(const std::string& alpha, const std::string& slices) {
  return R"({"texgraph": 1, "functions": {"fog": {"inputs": {"position": "vec3"}, "nodes": {
      "thick": )" +
         alpha + R"(,
      "paint": {"block": "rgba", "in": {"color": "position", "alpha": "thick"}}},
      "outputs": {"color": "paint"}}}, "nodes": {
      "seen": {"block": "volume_slices", "in": {"volume": "fog", "height": 0.5, "view": [0.2, -0.4],
               "slices": )" +
         slices + R"(}}}, "outputs": {"color": "seen"}})";
}

const std::string kEven = R"({"block": "float_constant", "in": {"value": 0.25}})";

TEST(VolumeSlicesTest, EvenFogIsTheSumOfItsSlices) {
  const std::vector<Point> points = {{0.1, 0.7}, {0.6, 0.2}};
  for (int slices : {1, 2, 5}) {
    auto seen = RunGraph(Graph(kEven, std::to_string(slices)), points, {1e-3, 1e-3})["color"];
    ASSERT_EQ(seen.count, points.size());
    for (size_t i = 0; i < points.size(); ++i) {
      double sum[3] = {}, alpha = 0, left = 1;
      for (int k = slices - 1; k >= 0; --k) {
        const double z = (k + 0.5) / slices, share = 0.25 * left;
        const double place[3] = {points[i].x - 0.2 * 0.5 * z, points[i].y + 0.4 * 0.5 * z, z};
        for (int c = 0; c < 3; ++c) sum[c] += share * place[c];
        alpha += share;
        left -= share;
      }
      EXPECT_NEAR(seen.Float(i, 3), 1 - std::pow(0.75, slices), 1e-6);
      for (size_t c = 0; c < 3; ++c) EXPECT_NEAR(seen.Float(i, c), sum[c] / alpha, 1e-5);
    }
  }
}

// The top slice hides all others.
TEST(VolumeSlicesTest, WhatIsAboveHidesWhatIsBelow) {
  auto seen = RunGraph(Graph(R"({"block": "float_constant", "in": {"value": 1}})", "8"),
                       {{0.3, 0.3}}, {1e-3, 1e-3})["color"];
  ASSERT_EQ(seen.count, 1u);
  EXPECT_NEAR(seen.Float(0, 2), 7.5 / 8, 1e-6);
  EXPECT_NEAR(seen.Float(0, 3), 1, 1e-6);
}

}  // namespace
}  // namespace texgraph::blocks
