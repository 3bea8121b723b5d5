// SPDX-License-Identifier: Apache-2.0
#include "tests/blocks/mean_error.h"

#include <algorithm>
#include <cmath>

namespace texgraph::blocks {
namespace {

constexpr int kStrata = 32;  // in each direction of a pixel
constexpr size_t kSamples = kStrata * kStrata, kPixels = 32;
constexpr double kTiny = 1e-5;

// Jittered in strata, by a sequence that follows no grid.
std::vector<Point> Samples(Point middle, double pixel) {
  std::vector<Point> points;
  for (int i = 0; i < kStrata * kStrata; ++i) {
    double x = (i % kStrata + std::fmod(0.7548776662 * i, 1)) / kStrata - 0.5;
    double y = (i / kStrata + std::fmod(0.5698402910 * i, 1)) / kStrata - 0.5;
    points.push_back({middle.x + pixel * x, middle.y + pixel * y});
  }
  return points;
}

}  // namespace

std::vector<double> ColorsAt(const std::string& graph, const std::vector<Point>& points,
                             double pixel, const std::string& folder) {
  auto outputs = RunGraph(graph, points, {pixel, pixel}, 1e-3, folder);
  std::vector<double> colors;
  for (size_t i = 0; i < points.size(); ++i) {
    for (size_t c = 0; c < 3; ++c) colors.push_back(outputs["color"].Float(i, c));
  }
  return colors;
}

double MeanError(const std::string& graph, double pixel, const std::string& folder, double span) {
  std::vector<Point> middles, samples;
  for (size_t i = 0; i < kPixels; ++i) {
    middles.push_back({span * std::fmod(0.1234 + 0.7548776662 * double(i), 1),
                       span * std::fmod(0.5678 + 0.5698402910 * double(i), 1)});
    for (Point p : Samples(middles.back(), pixel)) samples.push_back(p);
  }
  const std::vector<double> seen = ColorsAt(graph, middles, pixel, folder);
  const std::vector<double> fine = ColorsAt(graph, samples, kTiny, folder);
  double error[3] = {};
  for (size_t i = 0; i < kPixels; ++i) {
    for (size_t c = 0; c < 3; ++c) {
      double mean = 0;
      for (size_t s = 0; s < kSamples; ++s) mean += fine[3 * (kSamples * i + s) + c] / kSamples;
      error[c] += std::fabs(seen[3 * i + c] - mean) / kPixels;
    }
  }
  return *std::max_element(error, error + 3);
}

}  // namespace texgraph::blocks
