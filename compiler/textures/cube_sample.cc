// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/cube_sample.h"

#include <cstdlib>

namespace texgraph::textures {
namespace {

constexpr uint32_t kEightBits = 257;  // makes 8 bits 16

int64_t PlaceWithin(int64_t at, int64_t size, bool wraps) {
  if (at >= 0 && at < size) return at;
  if (!wraps) return at < 0 ? 0 : size - 1;
  const int64_t rest = at % size;
  return rest < 0 ? rest + size : rest;
}

}  // namespace

CubeSample::CubeSample(std::span<const Image> slices, bool wraps, uint32_t scales)
    : wraps_(wraps), channels_(slices[0].channels) {
  scales_.reserve(scales);
  Scale& base = scales_.emplace_back();
  base.size = {slices[0].width, slices[0].height, static_cast<int64_t>(slices.size())};
  base.values.reserve(size_t{slices[0].width} * slices[0].height * slices.size() * channels_);
  for (const Image& slice : slices) {
    const uint32_t unit = slice.bits == 8 ? kEightBits : 1;
    for (uint32_t y = 0; y < slice.height; ++y) {
      for (uint32_t x = 0; x < slice.width; ++x) {
        for (uint32_t c = 0; c < channels_; ++c) {
          const uint32_t value = slice.At(x, slice.height - 1 - y, c) * unit;
          base.values.push_back(static_cast<uint16_t>(value));
        }
      }
    }
  }
  for (uint32_t scale = 1; scale < scales; ++scale) scales_.push_back(Halved(scale - 1));
}

CubeSample::Scale CubeSample::Halved(uint32_t from) const {
  Scale scale;
  for (size_t axis = 0; axis < 3; ++axis) scale.size[axis] = (scales_[from].size[axis] + 1) / 2;
  const auto [width, height, depth] = scale.size;
  scale.values.reserve(static_cast<size_t>(width * height * depth) * channels_);
  for (int64_t z = 0; z < depth; ++z) {
    for (int64_t y = 0; y < height; ++y) {
      for (int64_t x = 0; x < width; ++x) {
        std::array<const uint16_t*, 8> parts;
        for (int64_t i = 0; i < 8; ++i)
          parts[static_cast<size_t>(i)] =
              At(from, {2 * x + (i & 1), 2 * y + (i >> 1 & 1), 2 * z + (i >> 2)});
        for (uint32_t c = 0; c < channels_; ++c) {
          uint32_t sum = 4;
          for (const uint16_t* part : parts) sum += part[c];
          scale.values.push_back(static_cast<uint16_t>(sum / 8));
        }
      }
    }
  }
  return scale;
}

const uint16_t* CubeSample::At(uint32_t scale, const VoxelPlace& place) const {
  const Scale& from = scales_[scale];
  const int64_t x = PlaceWithin(place[0], from.size[0], wraps_);
  const int64_t y = PlaceWithin(place[1], from.size[1], wraps_);
  const int64_t z = PlaceWithin(place[2], from.size[2], wraps_);
  return &from.values[static_cast<size_t>((z * from.size[1] + y) * from.size[0] + x) * channels_];
}

int32_t CubeSample::Difference(uint32_t scale, const VoxelPlace& a, const VoxelPlace& b) const {
  const uint16_t* left = At(scale, a);
  const uint16_t* right = At(scale, b);
  int32_t sum = 0;
  for (uint32_t c = 0; c < channels_; ++c) sum += std::abs(int32_t{left[c]} - int32_t{right[c]});
  return sum;
}

double CubeSample::MeanStep(uint32_t axis) const {
  std::array<int64_t, 3> ends = size();
  --ends[axis];
  int64_t sum = 0;
  int64_t count = 0;
  VoxelPlace at{};
  for (at[2] = 0; at[2] < ends[2]; ++at[2]) {
    for (at[1] = 0; at[1] < ends[1]; ++at[1]) {
      for (at[0] = 0; at[0] < ends[0]; ++at[0], ++count) {
        VoxelPlace next = at;
        ++next[axis];
        sum += Difference(0, at, next);
      }
    }
  }
  return count > 0 ? static_cast<double>(sum) / static_cast<double>(count) : 0;
}

}  // namespace texgraph::textures
