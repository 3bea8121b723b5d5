// SPDX-License-Identifier: Apache-2.0
// Where the tiles of a complete set stand in their pack, in whole numbers: what a shader computes,
// too. Tiles that touch in the pack have the same colours where they touch, on a torus or, with
// four corner colours, with gutters below and above. x goes to the right, y and v upwards. Wei
// 2004, Tile-Based Texture Mapping on Graphics Hardware, section 4.4 and appendix B.
#pragma once

#include <array>
#include <cstdint>

namespace texgraph::textures {

inline constexpr uint32_t kMaxTileColors = 4;
inline constexpr uint32_t kMinTileSize = 4;
// Texels: what OpenGL 4.5 promises, and what any texture of texgraph has at most.
inline constexpr uint32_t kMaxTilePackSide = 16384;
inline constexpr uint64_t kMaxTilePackTexels = uint64_t{1} << 26;

enum class TileKind : uint8_t {
  kCorner,  // a colour at each corner: all four tiles that meet there fit
  kWang,    // a colour on each edge
};

// kCorner: left bottom, right bottom, left top, right top. kWang: south, east, north, west.
using TileColors = std::array<uint32_t, 4>;

struct TilePlace {
  uint32_t x = 0;
  uint32_t y = 0;
  bool operator==(const TilePlace&) const = default;
};

struct TilePackLayout {
  TileKind kind = TileKind::kCorner;
  // kCorner: both the number of corner colours. kWang: those of the edges that lie (south, north),
  // then those that stand (west, east).
  std::array<uint32_t, 2> colors{2, 2};
  uint32_t tile_size = 0;  // texels
  uint32_t columns = 0;    // tiles
  uint32_t rows = 0;
  // Texels below and above the tiles, with what would lie there: 0, or half a tile rounded up.
  uint32_t gutter = 0;

  uint32_t tiles() const { return columns * rows; }
  uint32_t width() const { return columns * tile_size; }
  uint32_t height() const { return rows * tile_size + 2 * gutter; }
};

// False: kCorner takes 2 to 4 colours, the same number twice, kWang 1 to 4 of each.
bool AreTileColors(TileKind kind, std::array<uint32_t, 2> colors);
// Colours must be good, and the tile size such that nothing overflows.
TilePackLayout LayOutTiles(TileKind kind, std::array<uint32_t, 2> colors, uint32_t tile_size);
// The largest tile whose packs, one for each of `maps`, are within these limits.
uint32_t LargestTile(TileKind kind, std::array<uint32_t, 2> colors, uint64_t maps = 1);

// Wei's equation 6: the place of the pair in a tour that has each ordered pair once.
uint32_t TileIndex1D(uint32_t first, uint32_t second);
// Equation 7: (TileIndex1D(west, east), TileIndex1D(south, north)). Does not depend on how many
// colours there are.
TilePlace PackedWang(uint32_t south, uint32_t east, uint32_t north, uint32_t west);
// c10: right bottom. Two colours: a torus of 4 x 4. Else, with n = colors^2, columns shifted by
// y (y - 1) / 2: y = (TI(c01, c11) - TI(c00, c10)) mod n, x = (TI(c00, c10) - y (y - 1) / 2) mod n.
TilePlace PackedCorner(uint32_t c00, uint32_t c10, uint32_t c01, uint32_t c11, uint32_t colors);
TilePlace PackedTile(const TilePackLayout& layout, const TileColors& colors);

// The other way: the tile at a place. x and y may lie outside: what would be there, which for
// gutters is y = -1 and y = rows.
TileColors TileAt(const TilePackLayout& layout, int64_t x, int64_t y);
// The place of what would lie at x, y.
TilePlace ContinuedPlace(const TilePackLayout& layout, int64_t x, int64_t y);

// The set once more, as the layers of an array: each is a torus of 2 x 2 tiles. In a tiling the
// colours of two columns of corners and two rows of them, those that are even and those that are
// odd, are around every tile, and the torus that has these colours shows the tile where it is: the
// coordinate need not jump from tile to tile, only the layer does. Each tile stands in four layers.
// kCorner: a layer for each four colours of corners, even in both, odd in x, odd in y, odd in both;
// kWang: of edges that stand, even and odd, and of edges that lie, even and odd. The first is the
// last digit of the layer's number.
// There are as many layers as tiles. This is the tile in column and row, 0 or 1, of a layer.
TileColors TileInLayer(const TilePackLayout& layout, uint32_t layer, uint32_t column, uint32_t row);

// Wei's corner pack (equation 10): the corner with these edges around it is the right top corner of
// the tile at this place of MakeWeiCornerPack (tile_pictures.h).
TilePlace PackedWeiCorner(uint32_t bottom, uint32_t right, uint32_t top, uint32_t left);

}  // namespace texgraph::textures
