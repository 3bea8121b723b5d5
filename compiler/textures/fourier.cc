// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/fourier.h"

#include <algorithm>
#include <kissfft/kissfft.hh>
#include <vector>

namespace texgraph::textures {

void FourierTransform(std::span<std::complex<double>> values, uint32_t width, uint32_t height,
                      bool inverse) {
  std::vector<std::complex<double>> line(std::max(width, height));
  const kissfft<double> rows(width, inverse);
  for (uint32_t y = 0; y < height; ++y) {
    std::complex<double>* row = &values[size_t{y} * width];
    rows.transform(row, line.data());
    std::copy_n(line.data(), width, row);
  }
  const kissfft<double> columns(height, inverse);
  for (uint32_t x = 0; x < width; ++x) {
    columns.transform(&values[x], line.data(), 0, 1, width);
    for (uint32_t y = 0; y < height; ++y) values[size_t{y} * width + x] = line[y];
  }
}

}  // namespace texgraph::textures
