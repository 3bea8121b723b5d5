// SPDX-License-Identifier: Apache-2.0
#include "compiler/ir/evaluate_quads.h"

#include <array>
#include <bit>

namespace texgraph::ir::quads {
namespace {

float AsFloat(uint32_t word) { return std::bit_cast<float>(word); }

using Coordinate = std::array<float, 3>;

// A float vector of up to three components at one lane; what is missing is 0.
Coordinate VectorAt(const uint32_t* words, uint32_t width, uint32_t lanes, uint32_t lane) {
  Coordinate at{};
  for (uint32_t i = 0; i < width; ++i) at[i] = AsFloat(words[i * lanes + lane]);
  return at;
}

Coordinate Minus(const Coordinate& a, const Coordinate& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Texel SampleImplicit(const SampleArguments& a, const Coordinate& at, uint32_t lane) {
  const uint32_t width = CoordinateWidth(a.sampler), corner = lane & ~3u;
  const Coordinate here = VectorAt(a.operands[0], width, a.lanes, corner);
  Coordinate dx = Minus(VectorAt(a.operands[0], width, a.lanes, corner + 1), here);
  Coordinate dy = Minus(VectorAt(a.operands[0], width, a.lanes, corner + 2), here);
  float bias = a.operands.size() > 1 ? AsFloat(a.operands[1][lane]) : 0.0f;
  return SampleGrad(*a.texture, at.data(), dx.data(), dy.data(), bias);
}

Texel FetchAt(const SampleArguments& a, uint32_t lane) {
  std::array<int32_t, 3> at{};
  for (uint32_t i = 0; i < CoordinateWidth(a.sampler); ++i) {
    at[i] = std::bit_cast<int32_t>(a.operands[0][i * a.lanes + lane]);
  }
  return Fetch(*a.texture, at.data(), std::bit_cast<int32_t>(a.operands[1][lane]));
}

Texel SampleAt(const SampleArguments& a, uint32_t lane) {
  // What GL gives for a texture that is not complete.
  if (a.texture == nullptr) return {0.0f, 0.0f, 0.0f, 1.0f};
  if (a.op == Op::kFetch) return FetchAt(a, lane);
  const Coordinate at = VectorAt(a.operands[0], CoordinateWidth(a.sampler), a.lanes, lane);
  if (a.op == Op::kSampleLod) return SampleLod(*a.texture, at.data(), AsFloat(a.operands[1][lane]));
  if (a.op == Op::kSample) return SampleImplicit(a, at, lane);
  const uint32_t width = a.sampler == kSampler3D ? 3 : 2;
  const Coordinate dx = VectorAt(a.operands[1], width, a.lanes, lane);
  const Coordinate dy = VectorAt(a.operands[2], width, a.lanes, lane);
  return SampleGrad(*a.texture, at.data(), dx.data(), dy.data());
}

}  // namespace

void Difference(bool along_y, const uint32_t* x, uint32_t words, uint32_t lanes, uint32_t* result) {
  const uint32_t step = along_y ? 2 : 1;
  for (uint32_t word = 0; word < words; ++word, x += lanes, result += lanes) {
    for (uint32_t lane = 0; lane < lanes; ++lane) {
      uint32_t low = lane & ~step;
      result[lane] = std::bit_cast<uint32_t>(AsFloat(x[low + step]) - AsFloat(x[low]));
    }
  }
}

void Sample(const SampleArguments& arguments, uint32_t* result) {
  for (uint32_t lane = 0; lane < arguments.lanes; ++lane) {
    Texel texel{};
    if (arguments.active >> lane & 1) texel = SampleAt(arguments, lane);
    for (uint32_t c = 0; c < 4; ++c) {
      result[c * arguments.lanes + lane] = std::bit_cast<uint32_t>(texel[c]);
    }
  }
}

void Size(TypeId sampler, const Texture* texture, const uint32_t* level, uint32_t lanes,
          uint32_t* result) {
  for (uint32_t lane = 0; lane < lanes; ++lane) {
    std::array<uint32_t, 3> size{};
    // Negative levels become larger than any count.
    if (texture != nullptr && level[lane] < texture->levels.size()) {
      const Texture::Level& l = texture->levels[level[lane]];
      size = {l.width, l.height, l.depth};
    }
    for (uint32_t i = 0; i < CoordinateWidth(sampler); ++i) result[i * lanes + lane] = size[i];
  }
}

}  // namespace texgraph::ir::quads
