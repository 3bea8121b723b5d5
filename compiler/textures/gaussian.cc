// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/gaussian.h"

#include <algorithm>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <numbers>

namespace texgraph::textures {
namespace {

constexpr double kLeastWeight = 1e-9;
// Beyond so many standard deviations all weights together are below kLeastWeight.
constexpr double kReach = 6.5;

// No wider type than double, so that all machines agree, and no exceptions.
using Policy = boost::math::policies::policy<
    boost::math::policies::promote_double<false>,
    boost::math::policies::domain_error<boost::math::policies::ignore_error>,
    boost::math::policies::overflow_error<boost::math::policies::ignore_error>>;

// The integral of NormalCdf(t / sigma) from minus infinity to x: what a Gaussian makes of the ramp
// max(x, 0).
double Ramp(double x, double sigma) {
  if (sigma <= 0) return std::max(x, 0.0);
  const double z = x / sigma;
  return x * NormalCdf(z) + sigma * NormalDensity(z);
}

}  // namespace

double NormalDensity(double x) { return std::exp(-0.5 * x * x) / std::sqrt(2 * std::numbers::pi); }

double NormalCdf(double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); }

double NormalQuantile(double share) {
  return -std::numbers::sqrt2 * boost::math::erfc_inv(2 * share, Policy());
}

GaussianWeights WeightsAt(uint32_t count, double place, double sigma) {
  const double last = count - 1.0;
  const double reach = kReach * sigma + 1;
  const auto from = static_cast<uint32_t>(std::clamp(std::floor(place - reach), 0.0, last));
  const auto to = static_cast<uint32_t>(std::clamp(std::ceil(place + reach), 0.0, last));
  GaussianWeights result;
  result.weights.assign(to - from + 1, 0.0);
  // From node i on the function climbs to the one after it: what of the step between them has been
  // climbed is weight that moves from the one to the other.
  double before = 1;
  double ramp = Ramp(place - from, sigma);
  for (uint32_t i = from; i <= to; ++i) {
    const double next = Ramp(place - i - 1, sigma);
    const double climbed = i == to ? 0 : ramp - next;
    result.weights[i - from] = before - climbed;
    before = climbed;
    ramp = next;
  }
  const auto counts = [](double weight) { return weight >= kLeastWeight; };
  const auto begin = std::ranges::find_if(result.weights, counts);
  result.first = from + static_cast<uint32_t>(begin - result.weights.begin());
  result.weights.erase(result.weights.begin(), begin);
  while (!counts(result.weights.back())) result.weights.pop_back();
  double sum = 0;
  for (const double weight : result.weights) sum += weight;
  for (double& weight : result.weights) weight /= sum;
  return result;
}

}  // namespace texgraph::textures
