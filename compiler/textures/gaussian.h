// SPDX-License-Identifier: Apache-2.0
// The normal distribution, and weights that convolve what lies between texels with it.
#pragma once

#include <cstdint>
#include <vector>

namespace texgraph::textures {

// Of noise in a range of 0 to 1 with the mean 1/2, as the papers have it: three of them reach the
// ends of the range (Heitz and Neyret 2018).
inline constexpr double kNoiseSigma = 1.0 / 6.0;

double NormalDensity(double x);
double NormalCdf(double x);
double NormalQuantile(double share);  // 0 < share < 1

// The convolution with a Gaussian, at a place, of the function that is linear between nodes at 0,
// 1, ..., count - 1 and constant beyond them, as a sum over the nodes: exact, in closed form, but
// for weights below 1e-9. Their sum is 1.
struct GaussianWeights {
  uint32_t first = 0;           // the node of the first weight; the others follow
  std::vector<double> weights;  // at least one
};
// `sigma` in steps of nodes; 0 gives the function itself.
GaussianWeights WeightsAt(uint32_t count, double place, double sigma);

}  // namespace texgraph::textures
