// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/tile_map.h"

namespace texgraph::textures {
namespace {

// The block hash: PCG RXS-M-XS, a cell's h(x + h(y + h(seed))).
uint32_t Hash(uint32_t value) {
  const uint32_t state = value * 747796405u + 2891336453u;
  const uint32_t word = ((state >> ((state >> 28) + 4)) ^ state) * 277803737u;
  return (word >> 22) ^ word;
}

uint32_t CellHash(int32_t x, int32_t y, uint32_t seed) {
  return Hash(static_cast<uint32_t>(x) + Hash(static_cast<uint32_t>(y) + Hash(seed)));
}

}  // namespace

uint32_t DrawnCorner(int32_t x, int32_t y, uint32_t seed, uint32_t colors) {
  return CellHash(x, y, seed) % colors;
}

std::array<uint32_t, 2> DrawnEdges(int32_t x, int32_t y, uint32_t seed,
                                   std::array<uint32_t, 2> colors) {
  const uint32_t bits = CellHash(x, y, seed);
  return {(bits & 0xffff) % colors[0], (bits >> 16) % colors[1]};
}

NumberMap MakeTileMap(const TilePackLayout& layout, uint32_t width, uint32_t height,
                      uint32_t seed) {
  NumberMap map;
  map.width = width;
  map.height = height;
  map.numbers.reserve(size_t{width} * height);
  const auto at = [&](uint32_t x, uint32_t y) {
    return std::array{static_cast<int32_t>(x % width), static_cast<int32_t>(y % height)};
  };
  const auto corner = [&](uint32_t x, uint32_t y) {
    const auto [column, row] = at(x, y);
    return DrawnCorner(column, row, seed, layout.colors[0]);
  };
  const auto edges = [&](uint32_t x, uint32_t y) {
    const auto [column, row] = at(x, y);
    return DrawnEdges(column, row, seed, layout.colors);
  };
  for (uint32_t y = 0; y < height; ++y) {
    for (uint32_t x = 0; x < width; ++x) {
      TileColors colors{};
      if (layout.kind == TileKind::kCorner) {
        colors = {corner(x, y), corner(x + 1, y), corner(x, y + 1), corner(x + 1, y + 1)};
      } else {
        const auto [south, west] = edges(x, y);
        colors = {south, edges(x + 1, y)[1], edges(x, y + 1)[0], west};
      }
      const TilePlace place = PackedTile(layout, colors);
      map.numbers.push_back(static_cast<int32_t>(place.x + place.y * layout.columns));
    }
  }
  return map;
}

}  // namespace texgraph::textures
