// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/gaussian.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "compiler/textures/principal_axes.h"

namespace texgraph::textures {
namespace {

TEST(GaussianTest, QuantilesOfTables) {
  // Abramowitz and Stegun, tables 26.1 and 26.5.
  EXPECT_EQ(NormalQuantile(0.5), 0);
  EXPECT_NEAR(NormalQuantile(0.975), 1.959963984540054, 1e-13);
  EXPECT_NEAR(NormalQuantile(0.001), -3.090232306167813, 1e-13);
  EXPECT_NEAR(NormalQuantile(1e-9), -5.997807015007686, 1e-11);
  EXPECT_NEAR(NormalCdf(1), 0.8413447460685429, 1e-15);
  EXPECT_NEAR(NormalDensity(0), 0.3989422804014327, 1e-15);
  for (double x = -6; x < 6; x += 0.37) EXPECT_NEAR(NormalQuantile(NormalCdf(x)), x, 1e-6) << x;
}

// The definition: the integral of the piecewise linear function against the density, by Simpson's
// rule between the nodes, and the constants beyond them.
double Convolved(const std::vector<double>& nodes, double place, double sigma) {
  const double last = static_cast<double>(nodes.size()) - 1;
  double sum = nodes.front() * std::erfc(place / sigma / std::sqrt(2)) / 2 +
               nodes.back() * std::erfc((last - place) / sigma / std::sqrt(2)) / 2;
  constexpr int kSteps = 400;
  for (size_t i = 0; i + 1 < nodes.size(); ++i) {
    for (int s = 0; s <= kSteps; ++s) {
      const double part = double(s) / kSteps;
      const double z = (double(i) + part - place) / sigma;
      const double weight = (s == 0 || s == kSteps ? 1 : s % 2 ? 4 : 2) / (3.0 * kSteps);
      sum += weight * std::lerp(nodes[i], nodes[i + 1], part) * std::exp(-z * z / 2) /
             (sigma * std::sqrt(2 * std::acos(-1.0)));
    }
  }
  return sum;
}

TEST(GaussianTest, WeightsAreTheIntegral) {
  std::mt19937 random(3);
  for (const uint32_t count : {1u, 2u, 5u, 40u}) {
    std::vector<double> nodes(count);
    for (double& node : nodes) node = random() * 0x1p-32;
    for (const double sigma : {0.1, 0.7, 3.0, 60.0}) {
      for (const double place : {-4.0, 0.0, 0.4, 1.0, count - 1.0, count + 2.5}) {
        const GaussianWeights at = WeightsAt(count, place, sigma);
        ASSERT_LE(at.first + at.weights.size(), count);
        double sum = 0;
        for (size_t i = 0; i < at.weights.size(); ++i) sum += at.weights[i] * nodes[at.first + i];
        EXPECT_NEAR(sum, Convolved(nodes, place, sigma), 1e-7)
            << count << " nodes, " << sigma << " at " << place;
      }
    }
  }
}

TEST(GaussianTest, NoWidthIsTheFunctionItself) {
  const GaussianWeights node = WeightsAt(9, 3, 0);
  EXPECT_EQ(node.first, 3u);
  EXPECT_EQ(node.weights, std::vector<double>{1});
  const GaussianWeights between = WeightsAt(9, 3.25, 0);
  EXPECT_EQ(between.first, 3u);
  EXPECT_EQ(between.weights, (std::vector<double>{0.75, 0.25}));
  EXPECT_EQ(WeightsAt(9, -5, 0).first, 0u);
  EXPECT_EQ(WeightsAt(9, 50, 0).first, 8u);
}

TEST(PrincipalAxesTest, OfAMatrixByHand) {
  const Axes axes = PrincipalAxes({{{2, 1}, {1, 2}}}, 2);
  const double half = std::sqrt(0.5);
  EXPECT_NEAR(axes[0][0], half, 1e-15);
  EXPECT_NEAR(axes[0][1], half, 1e-15);
  EXPECT_NEAR(axes[1][0] * axes[1][1], -0.5, 1e-15);
  EXPECT_EQ(axes[2], Axis{});
}

TEST(PrincipalAxesTest, AreEigenvectors) {
  std::mt19937 random(8);
  for (int round = 0; round < 50; ++round) {
    const size_t n = 1 + random() % 4;
    Axes matrix{};
    for (size_t i = 0; i < n; ++i) {
      for (size_t j = 0; j <= i; ++j)
        matrix[i][j] = matrix[j][i] = (random() % 3 == 0) ? 0 : random() * 0x1p-31 - 1;
    }
    const Axes axes = PrincipalAxes(matrix, n);
    double before = INFINITY;
    for (size_t a = 0; a < n; ++a) {
      Axis image{};
      double value = 0;
      for (size_t i = 0; i < n; ++i) {
        for (size_t j = 0; j < n; ++j) image[i] += matrix[i][j] * axes[a][j];
      }
      for (size_t i = 0; i < n; ++i) value += image[i] * axes[a][i];
      for (size_t i = 0; i < n; ++i) EXPECT_NEAR(image[i], value * axes[a][i], 1e-12);
      EXPECT_LE(value, before + 1e-12);
      before = value;
      for (size_t b = 0; b <= a; ++b) {
        double product = 0;
        for (size_t i = 0; i < n; ++i) product += axes[a][i] * axes[b][i];
        EXPECT_NEAR(product, a == b ? 1 : 0, 1e-12);
      }
    }
  }
}

}  // namespace
}  // namespace texgraph::textures
