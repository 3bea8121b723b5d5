// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/principal_axes.h"

#include <algorithm>
#include <cmath>

namespace texgraph::textures {
namespace {

// They converge quadratically: seven are enough for four channels.
constexpr int kSweeps = 16;

// Turns the plane of axes p and q so that matrix[p][q] becomes 0 (Golub and Van Loan, 8.5.2).
void Rotate(Axes& matrix, Axes& axes, size_t n, size_t p, size_t q) {
  if (matrix[p][q] == 0) return;
  const double tau = (matrix[q][q] - matrix[p][p]) / (2 * matrix[p][q]);
  const double t = std::copysign(1.0, tau) / (std::abs(tau) + std::hypot(1.0, tau));
  const double c = 1 / std::hypot(1.0, t);
  const double s = t * c;
  const auto turn = [&](double& a, double& b) {
    const double old = a;
    a = c * old - s * b;
    b = s * old + c * b;
  };
  for (size_t i = 0; i < n; ++i) turn(matrix[i][p], matrix[i][q]);
  for (size_t i = 0; i < n; ++i) turn(matrix[p][i], matrix[q][i]);
  for (size_t i = 0; i < n; ++i) turn(axes[p][i], axes[q][i]);
  matrix[p][q] = matrix[q][p] = 0;
}

}  // namespace

Axes PrincipalAxes(Axes matrix, size_t n) {
  Axes axes{};
  for (size_t i = 0; i < n; ++i) axes[i][i] = 1;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (size_t p = 0; p + 1 < n; ++p) {
      for (size_t q = p + 1; q < n; ++q) Rotate(matrix, axes, n, p, q);
    }
  }
  std::array<size_t, 4> order{0, 1, 2, 3};
  std::stable_sort(order.begin(), order.begin() + n,
                   [&](size_t a, size_t b) { return matrix[a][a] > matrix[b][b]; });
  Axes sorted{};
  for (size_t i = 0; i < n; ++i) {
    Axis axis = axes[order[i]];
    const double largest =
        *std::ranges::max_element(axis, {}, [](double v) { return std::abs(v); });
    if (largest < 0) {
      for (double& value : axis) value = -value;
    }
    sorted[i] = axis;
  }
  return sorted;
}

}  // namespace texgraph::textures
