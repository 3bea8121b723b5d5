// SPDX-License-Identifier: Apache-2.0
// The axes along which the channels of a picture do not correlate.
#pragma once

#include <array>
#include <cstddef>

namespace texgraph::textures {

using Axis = std::array<double, 4>;
using Axes = std::array<Axis, 4>;

// The eigenvectors of the upper left n x n part of a symmetric matrix, n up to 4, by Jacobi
// rotations: as rows, of length 1, perpendicular, the one of the largest eigenvalue first. The
// largest number of each is positive, so that they do not depend on how they were found. The
// rest is zeros.
Axes PrincipalAxes(Axes matrix, size_t n);

}  // namespace texgraph::textures
