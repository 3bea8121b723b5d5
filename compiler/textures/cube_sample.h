// SPDX-License-Identifier: Apache-2.0
// The sample of a set of cubes as its seams are judged: a volume of whole numbers, at several
// scales, each half as large as the one before. x goes to the right, y upwards, z along the slices.
// Whole numbers, so that all machines cut alike.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "compiler/textures/image.h"

namespace texgraph::textures {

using VoxelPlace = std::array<int64_t, 3>;

class CubeSample {
 public:
  // `slices`: of one size, at least one. `scales`: how many, at least 1.
  CubeSample(std::span<const Image> slices, bool wraps, uint32_t scales);

  const std::array<int64_t, 3>& size() const { return scales_[0].size; }
  bool wraps() const { return wraps_; }
  uint32_t channels() const { return channels_; }

  // The numbers of a place, each below 2^16; what lies outside is the nearest inside, or comes
  // around.
  const uint16_t* At(uint32_t scale, const VoxelPlace& place) const;
  // Sum of the differences of all channels of two places, below 2^18.
  int32_t Difference(uint32_t scale, const VoxelPlace& a, const VoxelPlace& b) const;
  // Mean Difference of neighbours along an axis; at scale 0.
  double MeanStep(uint32_t axis) const;

 private:
  struct Scale {
    std::array<int64_t, 3> size{};
    std::vector<uint16_t> values;
  };
  Scale Halved(uint32_t from) const;

  bool wraps_;
  uint32_t channels_;
  std::vector<Scale> scales_;
};

}  // namespace texgraph::textures
