// SPDX-License-Identifier: Apache-2.0
// Textures on the CPU, sampled as the OpenGL 4.6 core specification words it (section 8.14): wrap modes, nearest and linear
// filters, mip levels, arrays, explicit gradients, sRGB decoding before filtering. The reference for what a GPU draws: the ideal
// scale factor, weights that are not rounded to 8 bits. Every coordinate is defined; one that is not finite counts as 0.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace texgraph::ir {

enum class Wrap : uint8_t { kRepeat, kClamp, kMirror };  // kClamp: GL_CLAMP_TO_EDGE
enum class Filter : uint8_t { kNearest, kLinear };
enum class MipFilter : uint8_t { kNone, kNearest, kLinear };

struct SamplerState {
  Wrap wrap_u = Wrap::kRepeat, wrap_v = Wrap::kRepeat, wrap_w = Wrap::kRepeat;
  Filter filter = Filter::kLinear;  // of magnification and minification
  MipFilter mip_filter = MipFilter::kLinear;
  float max_level = 1000.0f;  // the coarsest level that is used
  float anisotropy = 1.0f;    // above 1: up to so many samples along the longer axis of the footprint
};

struct Texture {
  struct Level {
    uint32_t width = 1, height = 1, depth = 1;  // depth: layers of an array (equal in all levels), or slices
    std::vector<std::array<float, 4>> texels;   // linear light; row 0 is v = 0; x fastest, then y, then depth
  };
  std::vector<Level> levels;  // at least one
  SamplerState sampler;
  bool is_array = false;  // the third coordinate is a layer, rounded (halves up) and clamped
  bool is_3d = false;
};

// `levels[0]` given: makes the full mip chain below it by 2x2 (or 2x2x2) boxes, odd sizes weighted by area.
void BuildMipChain(Texture& texture);

using Texel = std::array<float, 4>;
// `coordinate` has 2 components, 3 for arrays and 3D textures; a gradient has 2, 3 for 3D textures.
// `lod` is the lambda of the specification, before clamping to the levels there are.
Texel SampleLod(const Texture& texture, const float* coordinate, float lod);
// Gradients in texture coordinates; the scale factor rho is the larger of the two lengths in texels. `bias` is added to the
// level that follows from them.
Texel SampleGrad(const Texture& texture, const float* coordinate, const float* dx, const float* dy,
                 float bias = 0.0f);
float LodOfGradients(const Texture& texture, const float* dx, const float* dy);
Texel Fetch(const Texture& texture, const int32_t* coordinate, int32_t level);  // out of range: zeros

}  // namespace texgraph::ir
