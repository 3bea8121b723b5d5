// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/tile_pictures.h"

#include <string.h>

#include <algorithm>
#include <array>

#include "compiler/textures/tile_patches.h"

namespace texgraph::textures {
namespace {

using Rgb = std::array<uint8_t, 3>;

// Told apart by people who see few colours, too: Okabe and Ito 2008. The second four are those of
// edges that stand.
constexpr Rgb kMarks[2 * kMaxTileColors] = {{230, 159, 0},   {86, 180, 233}, {0, 158, 115},
                                            {240, 228, 66},  {0, 114, 178},  {213, 94, 0},
                                            {204, 121, 167}, {240, 240, 240}};
constexpr Rgb kGround = {32, 32, 32};

Image Empty(const ImageInfo& info, uint32_t width, uint32_t height) {
  Image image;
  static_cast<ImageInfo&>(image) = info;
  image.width = width;
  image.height = height;
  image.pixels.resize(image.RowBytes() * height);
  return image;
}

// Copies the tile at a place of the pack to the tile at x, y of `to`, from its left bottom corner.
void CopyPackedTile(const Image& pack, const TilePackLayout& layout, TilePlace from, uint32_t x,
                    uint32_t y, Image& to) {
  const size_t bytes = size_t{pack.channels} * (pack.bits / 8) * layout.tile_size;
  for (uint32_t row = 0; row < layout.tile_size; ++row) {
    const size_t source = pack.height - 1 - layout.gutter - size_t{from.y} * layout.tile_size - row;
    const size_t target = to.height - 1 - size_t{y} * layout.tile_size - row;
    memcpy(&to.pixels[to.RowBytes() * target + x * bytes],
           &pack.pixels[pack.RowBytes() * source + from.x * bytes], bytes);
  }
}

class TileView {
 public:
  TileView(const Image& pack, const TilePackLayout& layout)
      : pack_(pack),
        layout_(layout),
        mark_(std::max(layout.tile_size / 16, 2u)),
        pitch_(layout.tile_size + 3 * mark_) {
    const ImageInfo rgb{.channels = 3, .bits = 8};
    view_ = Empty(rgb, layout.columns * pitch_, layout.rows * pitch_);
    FillRect(0, 0, view_.width, view_.height, kGround);
  }

  Image Draw() {
    for (uint32_t y = 0; y < layout_.rows; ++y) {
      for (uint32_t x = 0; x < layout_.columns; ++x) DrawTile(x, y);
    }
    return std::move(view_);
  }

 private:
  // In the view, y upwards.
  void FillRect(uint32_t x, uint32_t y, uint32_t width, uint32_t height, const Rgb& color) {
    for (uint32_t row = y; row < y + height; ++row) {
      for (uint32_t column = x; column < x + width; ++column) SetTexel(column, row, color);
    }
  }
  void SetTexel(uint32_t x, uint32_t y, const Rgb& color) {
    memcpy(&view_.pixels[view_.RowBytes() * (view_.height - 1 - y) + 3 * x], color.data(), 3);
  }

  void DrawTile(uint32_t x, uint32_t y) {
    const uint32_t left = x * pitch_ + 3 * mark_ / 2;
    const uint32_t bottom = y * pitch_ + 3 * mark_ / 2;
    const uint32_t size = layout_.tile_size;
    for (uint32_t row = 0; row < size; ++row) {
      const uint32_t from = pack_.height - 1 - layout_.gutter - y * size - row;
      for (uint32_t column = 0; column < size; ++column) {
        Rgb color;
        for (uint32_t c = 0; c < 3; ++c) {
          const uint32_t value = pack_.At(x * size + column, from, pack_.channels < 3 ? 0 : c);
          color[c] = static_cast<uint8_t>(pack_.bits == 16 ? value / 257 : value);
        }
        SetTexel(left + column, bottom + row, color);
      }
    }
    MarkTile(TileAt(layout_, x, y), left, bottom);
  }

  // Corners have squares beside them, edges bars along them.
  void MarkTile(const TileColors& colors, uint32_t left, uint32_t bottom) {
    const uint32_t size = layout_.tile_size;
    if (layout_.kind == TileKind::kCorner) {
      for (uint32_t corner = 0; corner < 4; ++corner) {
        const uint32_t x = corner % 2 == 1 ? left + size : left - mark_;
        const uint32_t y = corner / 2 == 1 ? bottom + size : bottom - mark_;
        FillRect(x, y, mark_, mark_, kMarks[colors[corner]]);
      }
      return;
    }
    const Rgb* stands = kMarks + kMaxTileColors;
    FillRect(left, bottom - mark_, size, mark_, kMarks[colors[0]]);
    FillRect(left + size, bottom, mark_, size, stands[colors[1]]);
    FillRect(left, bottom + size, size, mark_, kMarks[colors[2]]);
    FillRect(left - mark_, bottom, mark_, size, stands[colors[3]]);
  }

  const Image& pack_;
  const TilePackLayout& layout_;
  uint32_t mark_;
  uint32_t pitch_;
  Image view_;
};

}  // namespace

Image MakeWeiCornerPack(const Image& pack, const TilePackLayout& layout) {
  const uint32_t columns = layout.colors[0] * layout.colors[0];
  const uint32_t rows = layout.colors[1] * layout.colors[1];
  Image corners = Empty(pack, columns * layout.tile_size, rows * layout.tile_size);
  // Around the corner at the right top of this tile, the edge at the left is the tile's north, that
  // below its east; all along a column and a row they are the same.
  const TilePackLayout turned =
      LayOutTiles(TileKind::kWang, {layout.colors[1], layout.colors[0]}, layout.tile_size);
  for (uint32_t y = 0; y < rows; ++y) {
    for (uint32_t x = 0; x < columns; ++x) {
      const TileColors pairs = TileAt(turned, x, y);
      const uint32_t north = pairs[3];
      const uint32_t east = pairs[0];
      CopyPackedTile(pack, layout, PackedWang(north, east, north, east), x, y, corners);
    }
  }
  return corners;
}

Image MakeTileView(const Image& pack, const TilePackLayout& layout) {
  return TileView(pack, layout).Draw();
}

Image MakeTiling(const Image& pack, const TilePackLayout& layout, uint32_t columns, uint32_t rows,
                 uint32_t seed) {
  Image tiling = Empty(pack, columns * layout.tile_size, rows * layout.tile_size);
  const auto color = [&](uint32_t x, uint32_t y, uint32_t stream) {
    return TileHash(TileHash(TileHash(seed, stream), x), y) %
           layout.colors[layout.kind == TileKind::kWang ? stream : 0];
  };
  for (uint32_t y = 0; y < rows; ++y) {
    for (uint32_t x = 0; x < columns; ++x) {
      const TileColors colors =
          layout.kind == TileKind::kCorner
              ? TileColors{color(x, y, 0), color(x + 1, y, 0), color(x, y + 1, 0),
                           color(x + 1, y + 1, 0)}
              : TileColors{color(x, y, 0), color(x + 1, y, 1), color(x, y + 1, 0), color(x, y, 1)};
      CopyPackedTile(pack, layout, PackedTile(layout, colors), x, y, tiling);
    }
  }
  return tiling;
}

}  // namespace texgraph::textures
