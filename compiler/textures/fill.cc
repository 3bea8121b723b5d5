// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/fill.h"

#include <algorithm>
#include <cstddef>

namespace texgraph::textures {
namespace {

using Texel = std::array<float, 4>;

struct Level {
  uint32_t width;
  uint32_t height;
  std::vector<Texel> texels;
};

// Each texel of the coarser level is the sum of up to four, with a weight of 1 at most.
Level Pull(const std::vector<Texel>& fine, uint32_t width, uint32_t height) {
  Level coarse{(width + 1) / 2, (height + 1) / 2, {}};
  coarse.texels.resize(size_t{coarse.width} * coarse.height);
  for (uint32_t y = 0; y < height; ++y) {
    for (uint32_t x = 0; x < width; ++x) {
      const Texel& from = fine[size_t{y} * width + x];
      Texel& to = coarse.texels[size_t{y / 2} * coarse.width + x / 2];
      for (size_t c = 0; c < 4; ++c) to[c] += from[c];
    }
  }
  for (Texel& texel : coarse.texels) {
    if (texel[3] <= 1.0f) continue;
    const float scale = 1.0f / texel[3];
    for (float& c : texel) c *= scale;
  }
  return coarse;
}

// The two coarse texels around the middle of a fine one: 3/4 of `near` and 1/4 of `far`.
struct Taps {
  uint32_t near, far;
};

Taps TapsOf(uint32_t fine, uint32_t coarse_size) {
  const uint32_t near = fine / 2;
  if (fine % 2 == 0) return {near, near == 0 ? 0 : near - 1};
  return {near, std::min(near + 1, coarse_size - 1)};
}

// What the weights leave open comes from the coarser level, which is whole.
void Push(const Level& coarse, std::vector<Texel>& fine, uint32_t width, uint32_t height) {
  for (uint32_t y = 0; y < height; ++y) {
    const Taps v = TapsOf(y, coarse.height);
    for (uint32_t x = 0; x < width; ++x) {
      Texel& to = fine[size_t{y} * width + x];
      const float open = 1.0f - to[3];
      if (open <= 0.0f) continue;
      const Taps u = TapsOf(x, coarse.width);
      const Texel& a = coarse.texels[size_t{v.near} * coarse.width + u.near];
      const Texel& b = coarse.texels[size_t{v.near} * coarse.width + u.far];
      const Texel& c = coarse.texels[size_t{v.far} * coarse.width + u.near];
      const Texel& d = coarse.texels[size_t{v.far} * coarse.width + u.far];
      for (size_t k = 0; k < 3; ++k) {
        to[k] += open * (0.5625f * a[k] + 0.1875f * (b[k] + c[k]) + 0.0625f * d[k]);
      }
      to[3] = 1.0f;
    }
  }
}

}  // namespace

bool FillColors(std::vector<Texel>& texels, uint32_t width, uint32_t height) {
  if (std::ranges::none_of(texels, [](const Texel& texel) { return texel[3] > 0.0f; })) {
    return false;
  }
  std::vector<Level> levels;
  uint32_t w = width, h = height;
  while (w > 1 || h > 1) {
    levels.push_back(Pull(levels.empty() ? texels : levels.back().texels, w, h));
    w = levels.back().width;
    h = levels.back().height;
  }
  Texel& top = levels.empty() ? texels[0] : levels.back().texels[0];
  for (size_t c = 0; c < 3; ++c) top[c] /= top[3];
  top[3] = 1.0f;
  for (size_t i = levels.size(); i-- > 0;) {
    const bool last = i == 0;
    Push(levels[i], last ? texels : levels[i - 1].texels, last ? width : levels[i - 1].width,
         last ? height : levels[i - 1].height);
    levels.pop_back();
  }
  return true;
}

}  // namespace texgraph::textures
