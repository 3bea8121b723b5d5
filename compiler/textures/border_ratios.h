// SPDX-License-Identifier: Apache-2.0
// The two halves of MeasureBorders (pattern_levels.h): what is inside of the patterns is the same
// for many tries of what is at their borders.
#pragma once

#include "compiler/ir/texture.h"
#include "compiler/textures/pattern_levels.h"

namespace texgraph::textures {

class DifferenceMean {
 public:
  void Add(double sum, double count = 1) {
    sum_ += sum;
    count_ += count;
  }
  double Get() const { return count_ > 0 ? sum_ / count_ : 0; }

 private:
  double sum_ = 0, count_ = 0;
};

struct Differences {
  DifferenceMean values, slopes;  // first differences, and second ones
};
struct AxisDifferences {
  Differences right, up;
};

// Of all neighbours within the layers; `skip_ring`: without those that touch the outermost texels.
AxisDifferences MeasureInside(const ir::Texture::Level& level, bool skip_ring);
// Along at most so many lines of texels, evenly spread.
BorderRatios CompareBorders(const ir::Texture::Level& level, const AxisDifferences& inside,
                            size_t most_lines);

}  // namespace texgraph::textures
