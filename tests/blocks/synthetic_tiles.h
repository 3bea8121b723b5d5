// SPDX-License-Identifier: Apache-2.0
// Tiles whose value is known everywhere: each colour of a corner or an edge has a field of waves
// around it, and a tile passes from one to the other, smoothly but at the corners of Wang tiles.
#pragma once

#include <cmath>
#include <cstdint>

#include "compiler/textures/tile_packing.h"
#include "tests/blocks/reference.h"
#include "tests/unit/textures/texture_testing.h"

namespace texgraph::blocks::synthetic {

using textures::TileColors;
using textures::TileKind;
using textures::TilePackLayout;
using textures::TilePlace;

// Wavelengths from a sixth of a tile on: colours have means of their own, too.
inline double Waves(uint32_t which, double x, double y) {
  double sum = 0;
  for (uint32_t wave = 0; wave < 12; ++wave) {
    const auto draw = [&](int32_t number) {
      return reference::CellHash(number, static_cast<int32_t>(wave), which) * 0x1p-32;
    };
    const double turn = 6.283185307179586 * draw(0);
    const double frequency = 6.283185307179586 * 6 * draw(1);
    sum += std::cos(frequency * (std::cos(turn) * x + std::sin(turn) * y) +
                    6.283185307179586 * draw(2));
  }
  return 0.5 + 0.04 * sum;
}

// From 0 to 1 with two derivatives that are 0 at both ends.
inline double Fade(double t) { return t * t * t * (t * (6 * t - 15) + 10); }

inline double CornerTile(const TileColors& corners, double x, double y) {
  double sum = 0;
  for (uint32_t corner = 0; corner < 4; ++corner) {
    const double dx = x - (corner & 1);
    const double dy = y - (corner >> 1);
    sum += Fade(1 - std::abs(dx)) * Fade(1 - std::abs(dy)) * Waves(corners[corner], dx, dy);
  }
  return sum;
}

// An edge weighs as much as the other three are far away.
inline double WangTile(const TileColors& edges, double x, double y) {
  const double far[4] = {Fade(y), Fade(1 - x), Fade(1 - y), Fade(x)};
  const double dx[4] = {x - 0.5, x - 1, x - 0.5, x};
  const double dy[4] = {y, y - 0.5, y - 1, y - 0.5};
  double sum = 0;
  double total = 0;
  for (uint32_t edge = 0; edge < 4; ++edge) {
    double weight = 1;
    for (uint32_t other = 0; other < 4; ++other) weight *= other == edge ? 1 : far[other];
    sum += weight * Waves(edges[edge] + (edge % 2 == 0 ? 8 : 16), dx[edge], dy[edge]);
    total += weight;
  }
  return sum / total;
}

inline double Tile(TileKind kind, const TileColors& colors, double x, double y) {
  return kind == TileKind::kCorner ? CornerTile(colors, x, y) : WangTile(colors, x, y);
}

// 16 bits.
inline textures::Image Pack(const TilePackLayout& layout) {
  const uint32_t width = layout.width();
  const uint32_t height = layout.height();
  std::vector<uint32_t> samples(size_t{width} * height);
  for (uint32_t y = 0; y < height; ++y) {
    const double up = (height - y - 0.5 - layout.gutter) / layout.tile_size;
    for (uint32_t x = 0; x < width; ++x) {
      const double right = (x + 0.5) / layout.tile_size;
      const double column = std::floor(right);
      const double row = std::floor(up);
      const TileColors colors =
          TileAt(layout, static_cast<int64_t>(column), static_cast<int64_t>(row));
      samples[size_t{y} * width + x] = static_cast<uint32_t>(
          std::lround(65535 * Tile(layout.kind, colors, right - column, up - row)));
    }
  }
  return textures::test::MakeImage(width, height, 1, 16, samples);
}

}  // namespace texgraph::blocks::synthetic
