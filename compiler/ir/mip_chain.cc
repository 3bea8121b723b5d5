// SPDX-License-Identifier: Apache-2.0
// Mip levels, one axis after the other: a box over two texels is a mean along x, then along y, then
// along z.
#include <algorithm>
#include <cstddef>

#include "compiler/ir/texture.h"

namespace texgraph::ir {
namespace {

// The texels of the finer level that one texel of the coarser covers, and what parts of it. A level
// of 2m + 1 texels has a next one of m, each of which covers 2 + 1/m: three texels, the outer ones
// in part.
struct Box {
  uint32_t first;
  uint32_t count;
  std::array<float, 3> weights;
};

Box BoxOf(uint32_t size, uint32_t coarse_size, uint32_t i) {
  if (size == coarse_size) return {i, 1, {1.0f}};
  if (size == 2 * coarse_size) return {2 * i, 2, {0.5f, 0.5f}};
  // In units of 1/coarse_size texels: from i * size to (i + 1) * size. It begins i units into texel
  // 2i, and ends i + 1 units into texel 2i + 2.
  double area = size;
  return {2 * i,
          3,
          {static_cast<float>((coarse_size - i) / area), static_cast<float>(coarse_size / area),
           static_cast<float>((i + 1) / area)}};
}

// Averages along one axis: `from` is `outer` times `size` times `inner` texels.
std::vector<Texel> Shrink(const std::vector<Texel>& from, size_t outer, uint32_t size,
                          uint32_t coarse_size, size_t inner) {
  std::vector<Texel> to(outer * coarse_size * inner);
  std::vector<Box> boxes;
  for (uint32_t i = 0; i < coarse_size; ++i) boxes.push_back(BoxOf(size, coarse_size, i));
  Texel* target = to.data();
  for (size_t o = 0; o < outer; ++o) {
    for (const Box& box : boxes) {
      const Texel* source = from.data() + (o * size + box.first) * inner;
      for (size_t k = 0; k < inner; ++k, ++source, ++target) {
        for (uint32_t tap = 0; tap < box.count; ++tap) {
          const Texel& texel = source[tap * inner];
          for (size_t c = 0; c < 4; ++c) (*target)[c] += box.weights[tap] * texel[c];
        }
      }
    }
  }
  return to;
}

}  // namespace

void BuildMipChain(Texture& texture) {
  texture.levels.resize(1);
  while (true) {
    const Texture::Level& fine = texture.levels.back();
    Texture::Level coarse;
    coarse.width = std::max(1u, fine.width / 2);
    coarse.height = std::max(1u, fine.height / 2);
    coarse.depth = texture.is_3d ? std::max(1u, fine.depth / 2) : fine.depth;
    bool smaller =
        coarse.width < fine.width || coarse.height < fine.height || coarse.depth < fine.depth;
    if (!smaller) return;
    const size_t rows = size_t{fine.height} * fine.depth;
    coarse.texels = Shrink(fine.texels, rows, fine.width, coarse.width, 1);
    if (coarse.height < fine.height) {
      coarse.texels = Shrink(coarse.texels, fine.depth, fine.height, coarse.height, coarse.width);
    }
    if (coarse.depth < fine.depth) {
      const size_t slice = size_t{coarse.width} * coarse.height;
      coarse.texels = Shrink(coarse.texels, 1, fine.depth, coarse.depth, slice);
    }
    texture.levels.push_back(std::move(coarse));
  }
}

}  // namespace texgraph::ir
