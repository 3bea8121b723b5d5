// SPDX-License-Identifier: Apache-2.0
// A graph's colours against 1,024 samples a pixel.
#pragma once

#include <string>
#include <vector>

#include "tests/blocks/run_block.h"

namespace texgraph::blocks {

// Red, green and blue at each point.
std::vector<double> ColorsAt(const std::string& graph, const std::vector<Point>& points,
                             double pixel, const std::string& folder = PictureFolder());

// The mean error of the channel in which it is largest, over some pixels of that size in uv. With
// `span`, their middles lie from 0 to that in both directions.
double MeanError(const std::string& graph, double pixel,
                 const std::string& folder = PictureFolder(), double span = 1);

}  // namespace texgraph::blocks
