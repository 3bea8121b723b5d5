// SPDX-License-Identifier: Apache-2.0
// Textures on the CPU, sampled as the OpenGL 4.6 core specification words it (section 8.14): wrap modes, nearest and linear
// filters, mip levels, arrays, explicit gradients, sRGB decoding before filtering. The reference for what a GPU draws.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace texgraph::ir {

enum class Wrap : uint8_t { kRepeat, kClamp, kMirror };
enum class Filter : uint8_t { kNearest, kLinear };
enum class MipFilter : uint8_t { kNone, kNearest, kLinear };

struct SamplerState {
  Wrap wrap_u = Wrap::kRepeat, wrap_v = Wrap::kRepeat, wrap_w = Wrap::kRepeat;
  Filter filter = Filter::kLinear;
  MipFilter mip_filter = MipFilter::kLinear;
  float max_level = 1000.0f;  // the coarsest level that is used
  float anisotropy = 1.0f;
};

struct Texture {
  struct Level {
    uint32_t width = 1, height = 1, depth = 1;  // depth: layers of an array (equal in all levels), or slices
    std::vector<std::array<float, 4>> texels;   // linear light; row 0 is v = 0; x fastest, then y, then depth
  };
  std::vector<Level> levels;  // at least one
  SamplerState sampler;
  bool is_array = false;  // the third coordinate is a layer, rounded and clamped
  bool is_3d = false;
};

// `levels[0]` given: makes the full mip chain below it by 2x2 (or 2x2x2) boxes, odd sizes weighted by area.
void BuildMipChain(Texture& texture);

using Texel = std::array<float, 4>;
// `lod` is the lambda of the specification, before clamping to the levels there are.
Texel SampleLod(const Texture& texture, const float* coordinate, float lod);
// Gradients in texture coordinates; the scale factor rho is the larger of the two lengths in texels.
Texel SampleGrad(const Texture& texture, const float* coordinate, const float* dx, const float* dy);
float LodOfGradients(const Texture& texture, const float* dx, const float* dy);
Texel Fetch(const Texture& texture, const int32_t* coordinate, int32_t level);  // out of range: zeros

}  // namespace texgraph::ir
