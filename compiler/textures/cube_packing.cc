// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/cube_packing.h"

#include "compiler/textures/tile_packing.h"

namespace texgraph::textures {
namespace {

uint32_t Residue(int64_t value, uint32_t n) {
  const int64_t rest = value % int64_t{n};
  return static_cast<uint32_t>(rest < 0 ? rest + n : rest);
}

}  // namespace

CubePackLayout LayOutCubes(uint32_t colors, uint32_t cube_size) {
  CubePackLayout layout;
  layout.colors = colors;
  layout.cube_size = cube_size;
  layout.side = colors * colors;
  layout.layers = layout.side * layout.side;
  return layout;
}

// The sum of the steps below z = i + n j: all i below n, j times, and those below i once; each j
// below j n times, which is nothing modulo n, and j itself i times.
std::array<uint32_t, 2> CubeShift(uint32_t z, uint32_t colors) {
  const uint32_t n = colors * colors;
  const uint32_t i = z % n;
  const uint32_t j = z / n;
  const uint32_t below = i > 0 ? i * (i - 1) / 2 : 0;
  return {(below + j * (n * (n - 1) / 2)) % n, i * j % n};
}

CubePlace PackedCube(const CubeColors& c, uint32_t colors) {
  const uint32_t n = colors * colors;
  const TilePlace below = PackedCorner(c[0], c[1], c[2], c[3], colors);
  const TilePlace above = PackedCorner(c[4], c[5], c[6], c[7], colors);
  const uint32_t z = (above.x + n - below.x) % n + n * ((above.y + n - below.y) % n);
  const auto [x, y] = CubeShift(z, colors);
  return {(below.x + n - x) % n, (below.y + n - y) % n, z};
}

CubeColors CubeAt(const CubePackLayout& layout, int64_t x, int64_t y, int64_t z) {
  const TilePackLayout window = LayOutTiles(TileKind::kCorner, {layout.colors, layout.colors}, 1);
  CubeColors corners;
  for (uint32_t layer = 0; layer < 2; ++layer) {
    const auto shift = CubeShift(Residue(z + layer, layout.layers), layout.colors);
    const TileColors tile = TileAt(window, x + shift[0], y + shift[1]);
    for (uint32_t i = 0; i < 4; ++i) corners[4 * layer + i] = tile[i];
  }
  return corners;
}

}  // namespace texgraph::textures
