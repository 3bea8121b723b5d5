// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/tile_packing.h"

#include <algorithm>

namespace texgraph::textures {
namespace {

// Two corner colours close on a torus of 4 x 4, which the general packing does not: the colours of
// its corners, from the bottom row up. Each 2 x 2 window is there once.
constexpr uint32_t kTwoColors[4][4] = {{1, 1, 1, 0}, {1, 1, 0, 1}, {0, 1, 0, 0}, {1, 0, 0, 0}};

uint32_t Modulo(int64_t value, uint32_t n) {
  const int64_t rest = value % int64_t{n};
  return static_cast<uint32_t>(rest < 0 ? rest + n : rest);
}

// How far row y of corners is shifted.
uint32_t RowShift(int64_t y, uint32_t n) { return Modulo(y * (y - 1) / 2, n); }

// The first colour of the pair at this place of the tour.
uint32_t TourColor(uint32_t index, uint32_t colors) {
  for (uint32_t first = 0; first < colors; ++first) {
    for (uint32_t second = 0; second < colors; ++second) {
      if (TileIndex1D(first, second) == index) return first;
    }
  }
  return 0;
}

uint32_t CornerColor(uint32_t colors, int64_t x, int64_t y) {
  if (colors == 2) return kTwoColors[Modulo(y, 4)][Modulo(x, 4)];
  const uint32_t n = colors * colors;
  return TourColor(Modulo(x + RowShift(y, n), n), colors);
}

}  // namespace

bool AreTileColors(TileKind kind, std::array<uint32_t, 2> colors) {
  if (kind == TileKind::kCorner) {
    return colors[0] == colors[1] && colors[0] >= 2 && colors[0] <= kMaxTileColors;
  }
  return std::ranges::all_of(colors, [](uint32_t n) { return n >= 1 && n <= kMaxTileColors; });
}

TilePackLayout LayOutTiles(TileKind kind, std::array<uint32_t, 2> colors, uint32_t tile_size) {
  TilePackLayout layout;
  layout.kind = kind;
  layout.colors = colors;
  layout.tile_size = tile_size;
  layout.columns = colors[1] * colors[1];
  layout.rows = colors[0] * colors[0];
  if (kind == TileKind::kCorner && colors[0] == 4) layout.gutter = (tile_size + 1) / 2;
  return layout;
}

uint32_t LargestTile(TileKind kind, std::array<uint32_t, 2> colors, uint64_t maps) {
  const TilePackLayout layout = LayOutTiles(kind, colors, 1);
  const bool has_gutters = layout.gutter > 0;
  const uint32_t high = kMaxTilePackSide / (layout.rows + (has_gutters ? 1 : 0));
  uint32_t size = std::min(kMaxTilePackSide / layout.columns, high);
  const auto fits = [&] {
    const TilePackLayout pack = LayOutTiles(kind, colors, size);
    return pack.height() <= kMaxTilePackSide &&
           uint64_t{pack.width()} * pack.height() <= kMaxTilePackTexels / maps;
  };
  while (size > 0 && !fits()) --size;
  return size;
}

uint32_t TileIndex1D(uint32_t first, uint32_t second) {
  if (first == second) return first == 0 ? 0 : (first + 1) * (first + 1) - 2;
  if (second > first) return 2 * first + second * second;
  if (second > 0) return first * first + 2 * second - 1;
  return (first + 1) * (first + 1) - 1;
}

TilePlace PackedWang(uint32_t south, uint32_t east, uint32_t north, uint32_t west) {
  return {TileIndex1D(west, east), TileIndex1D(south, north)};
}

TilePlace PackedCorner(uint32_t c00, uint32_t c10, uint32_t c01, uint32_t c11, uint32_t colors) {
  if (colors == 2) {
    // kTwoColors turned around: two bits for each tile.
    constexpr uint32_t kColumns = 0x313B46E6;
    constexpr uint32_t kRows = 0x0F72275A;
    const uint32_t bit = 2 * (c00 + 2 * c10 + 4 * c01 + 8 * c11);
    return {kColumns >> bit & 3, kRows >> bit & 3};
  }
  const uint32_t n = colors * colors;
  const uint32_t below = TileIndex1D(c00, c10);
  const uint32_t y = (TileIndex1D(c01, c11) + n - below) % n;
  return {Modulo(int64_t{below} - RowShift(y, n), n), y};
}

TilePlace PackedTile(const TilePackLayout& layout, const TileColors& colors) {
  if (layout.kind == TileKind::kWang) {
    return PackedWang(colors[0], colors[1], colors[2], colors[3]);
  }
  return PackedCorner(colors[0], colors[1], colors[2], colors[3], layout.colors[0]);
}

TileColors TileAt(const TilePackLayout& layout, int64_t x, int64_t y) {
  const uint32_t colors = layout.colors[0];
  if (layout.kind == TileKind::kCorner) {
    return {CornerColor(colors, x, y), CornerColor(colors, x + 1, y), CornerColor(colors, x, y + 1),
            CornerColor(colors, x + 1, y + 1)};
  }
  const uint32_t stands = layout.colors[1];
  return {
      TourColor(Modulo(y, layout.rows), colors), TourColor(Modulo(x + 1, layout.columns), stands),
      TourColor(Modulo(y + 1, layout.rows), colors), TourColor(Modulo(x, layout.columns), stands)};
}

TilePlace ContinuedPlace(const TilePackLayout& layout, int64_t x, int64_t y) {
  return PackedTile(layout, TileAt(layout, x, y));
}

TileColors TileInLayer(const TilePackLayout& layout, uint32_t layer, uint32_t column,
                       uint32_t row) {
  // Of a corner tile all four digits have the same base.
  const auto [lie, stand] = layout.colors;
  const std::array<uint32_t, 4> digits = {layer % stand, layer / stand % stand,
                                          layer / (stand * stand) % lie,
                                          layer / (stand * stand * lie) % lie};
  if (layout.kind == TileKind::kWang) {
    return {digits[2 + row], digits[1 - column], digits[3 - row], digits[column]};
  }
  const uint32_t below = 2 * row, above = 2 - below;
  return {digits[below + column], digits[below + 1 - column], digits[above + column],
          digits[above + 1 - column]};
}

TilePlace PackedWeiCorner(uint32_t bottom, uint32_t right, uint32_t top, uint32_t left) {
  return {TileIndex1D(left, right), TileIndex1D(bottom, top)};
}

}  // namespace texgraph::textures
