// SPDX-License-Identifier: Apache-2.0
// The sample of a tile set as its seams are judged: all maps as one picture of whole numbers, each
// channel scaled by its map's weight, at several scales, each half as large as the one before.
// Rows go upwards. Whole numbers, so that all machines cut alike.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/textures/image.h"

namespace texgraph::textures {

struct TexelPlace {
  int64_t x = 0;
  int64_t y = 0;
};

class TileSample {
 public:
  // `weights`: one a map, none negative, one above 0; maps of weight 0 are left out. `scales`: how
  // many, at least 1.
  TileSample(std::span<const Image> maps, std::span<const double> weights, bool wraps,
             uint32_t scales);

  uint32_t width() const { return static_cast<uint32_t>(scales_[0].width); }
  uint32_t height() const { return static_cast<uint32_t>(scales_[0].height); }
  bool wraps() const { return wraps_; }
  uint32_t channels() const { return channels_; }  // of all maps
  // The channels of a place, as of Difference.
  const uint16_t* At(uint32_t scale, TexelPlace place) const { return At(scales_[scale], place); }

  // Sum of the differences of all channels of two places, at most 2^20; what lies outside is the
  // nearest inside, or comes around.
  int32_t Difference(uint32_t scale, TexelPlace a, TexelPlace b) const;
  // That, and half of how the steps to the right and upwards differ: a metric among places, so that
  // a cut of least cost has neither jumps nor kinks.
  int32_t SeamCost(uint32_t scale, TexelPlace a, TexelPlace b) const;
  // Mean Difference of neighbours, beside and above each other; at scale 0.
  double MeanStep(bool upwards) const;

 private:
  struct Scale {
    int64_t width = 0;
    int64_t height = 0;
    std::vector<uint16_t> values;
  };
  const uint16_t* At(const Scale& scale, TexelPlace place) const;
  Scale Halved(const Scale& from) const;
  void Fill(std::span<const Image> maps, std::span<const double> weights);

  bool wraps_;
  uint32_t channels_ = 0;
  std::vector<Scale> scales_;
};

}  // namespace texgraph::textures
