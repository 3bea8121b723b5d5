// SPDX-License-Identifier: Apache-2.0
// What tiles by example look like through a filter: the blocks are drawn with pixels as large as
// the texels of each mip level and compared with the virtual texture, which is made tile by tile
// and has mip levels of its own. Errors are roots of mean squares as parts of the texture's
// standard deviation.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <string.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "compiler/textures/tile_levels.h"
#include "tests/blocks/run_block.h"
#include "tests/blocks/synthetic_tiles.h"
#include "tests/unit/textures/tile_testing.h"

namespace texgraph::blocks {
namespace {

using textures::Image;
using textures::TileKind;
using textures::TilePackLayout;
using textures::TilePlace;

constexpr uint32_t kTiles = 16;  // of the virtual texture, each way; there it repeats

struct Tiles {
  TilePackLayout layout;
  Image pack;
};

Tiles Synthetic(TileKind kind, uint32_t colors, uint32_t size) {
  const TilePackLayout layout = LayOutTiles(kind, {colors, colors}, size);
  return {layout, synthetic::Pack(layout)};
}

// Cut from a sample, of strokes over one another.
Tiles ByExample(TileKind kind, uint32_t size) {
  const Image sample = textures::test::StrokesImage(3 * size, 3 * size, 1, 8, 11);
  Diagnostics diagnostics;
  auto set = MakeTileSet({&sample, 1}, {}, textures::test::SmallTiles(kind, {2, 2}, size), "grass",
                         {}, diagnostics);
  EXPECT_TRUE(set);
  return {set->layout, std::move(set->packs[0])};
}

// In one picture; `is_array`: in layers.
ir::Texture TextureOf(const Tiles& tiles, bool corners = false, bool is_array = false) {
  textures::TextureOptions options;
  options.is_array = is_array;
  options.srgb = options.alpha_is_opacity = false;
  options.as_float = true;
  Diagnostics diagnostics;
  const auto data = (corners ? textures::MakeCornerTexture : textures::MakeTileTexture)(
      tiles.pack, tiles.layout, options, "pack", {}, diagnostics);
  EXPECT_TRUE(data);
  return ToTexture(*data);
}

// A way to show a set of tiles.
struct Way {
  std::string block;
  std::string ports;  // besides the coordinate and how many tiles there are
  std::map<std::string, ir::Texture> textures;
};

Way CornerTiles(const Tiles& tiles, bool is_array = false) {
  return {
      "corner_tiles",
      fmt::format(R"("tiles": "pack", "colors": {}, "period": {})", tiles.layout.colors[0], kTiles),
      {{"pack", TextureOf(tiles, false, is_array)}}};
}

Way WangTiles(const Tiles& tiles, bool is_array = false) {
  return {"wang_tiles",
          fmt::format(R"("tiles": "pack", "colors": [{}, {}], "period": {})",
                      tiles.layout.colors[0], tiles.layout.colors[1], kTiles),
          {{"pack", TextureOf(tiles, false, is_array)}}};
}

Way WithCorners(const Tiles& tiles) {
  Way way = WangTiles(tiles);
  way.block = "wang_tiles_with_corners";
  way.ports += R"(, "corners": "around")";
  way.textures["around"] = TextureOf(tiles, true);
  return way;
}

// The tiles of `places` in the order of their colours, as nobody should pack them.
Way RowMajor(const Tiles& tiles, const std::vector<TilePlace>& places) {
  const TilePackLayout& layout = tiles.layout;
  const auto moved = [&](const TilePlace& place) {
    const textures::TileColors c = TileAt(layout, place.x, place.y);
    return layout.kind == TileKind::kWang
               ? TilePlace{c[3] + c[1] * layout.colors[1], c[0] + c[2] * layout.colors[0]}
               : TilePlace{c[0] + c[1] * layout.colors[0], c[2] + c[3] * layout.colors[0]};
  };
  Tiles other = tiles;
  const size_t bytes = size_t{layout.tile_size} * tiles.pack.bits / 8;
  for (uint32_t tile = 0; tile < layout.tiles(); ++tile) {
    const TilePlace from{tile % layout.columns, tile / layout.columns};
    const TilePlace to = moved(from);
    for (uint32_t row = 0; row < layout.tile_size; ++row) {
      const auto byte = [&](const TilePlace& place) {
        return (layout.height() - 1 - place.y * layout.tile_size - row) * tiles.pack.RowBytes() +
               place.x * bytes;
      };
      memcpy(&other.pack.pixels[byte(to)], &tiles.pack.pixels[byte(from)], bytes);
    }
  }
  std::vector<std::vector<double>> rows(kTiles);
  for (size_t i = 0; i < places.size(); ++i) {
    const TilePlace place = moved(places[i]);
    rows[i / kTiles].push_back(place.x + place.y * layout.columns);
  }
  return {"tile_map",
          fmt::format(R"("tiles": "pack", "map": "plan", "pack": [{}, {}])", layout.columns,
                      layout.rows),
          {{"pack", TextureOf(other)}, {"plan", MapOf(rows)}}};
}

std::string GraphOf(const Way& way) {
  std::string textures;
  for (const auto& [name, texture] : way.textures)
    // Of another file each, or they were one.
    textures += fmt::format(R"({}"{}": {{{}"{}.png"{}}})", textures.empty() ? "" : ", ", name,
                            texture.is_array ? R"("layers": [)" : R"("file": )",
                            textures.empty() ? "mortar" : "moss", texture.is_array ? "]" : "");
  return fmt::format(R"({{"texgraph": 1, "textures": {{{}}},
    "nodes": {{"t": {{"block": "{}", "in": {{"tiling": {}, {}}}}},
              "number": {{"block": "to_float", "in": {{"value": "t.index"}}}}}},
    "outputs": {{"color": "t.color", "height": "number"}}}})",
                     textures, way.block, kTiles, way.ports);
}

// Which tiles are shown, row by row from the left lower one.
std::vector<TilePlace> PlacesOf(const Way& way, const Tiles& tiles) {
  std::vector<Point> middles;
  for (uint32_t i = 0; i < kTiles * kTiles; ++i)
    middles.push_back({(i % kTiles + 0.5) / kTiles, (i / kTiles + 0.5) / kTiles});
  auto outputs = RunGraph(GraphOf(way), middles, {1e-4, 1e-4}, 1e-4, PictureFolder(), way.textures);
  std::vector<TilePlace> places;
  for (size_t i = 0; i < middles.size(); ++i) {
    const auto number = static_cast<uint32_t>(outputs["height"].Float(i));
    places.push_back({number % tiles.layout.columns, number / tiles.layout.columns});
  }
  return places;
}

struct Reference {
  ir::Texture texture;
  double deviation = 0;
};

// Beginning `from` texels to the right and above.
Reference MakeReference(const Tiles& tiles, const std::vector<TilePlace>& places,
                        uint32_t from = 0) {
  Reference reference;
  const uint32_t size = tiles.layout.tile_size;
  const double most = tiles.pack.bits == 16 ? 65535 : 255;
  ir::Texture::Level& base = reference.texture.levels.emplace_back();
  base.width = base.height = kTiles * size;
  double sum = 0;
  double squares = 0;
  for (uint32_t i = 0; i < base.width * base.height; ++i) {
    const uint32_t x = (i % base.width + from) % base.width;
    const uint32_t y = (i / base.width + from) % base.height;
    const TilePlace& place = places[y / size * kTiles + x / size];
    const double value =
        textures::test::TileTexel(tiles.pack, tiles.layout, place, x % size, y % size, 0) / most;
    base.texels.push_back({static_cast<float>(value), 0, 0, 1});
    sum += value;
    squares += value * value;
  }
  const auto count = static_cast<double>(base.texels.size());
  reference.deviation = std::sqrt(squares / count - sum / count * (sum / count));
  ir::BuildMipChain(reference.texture);
  return reference;
}

enum class Region { kAll, kCorners, kEdges };

// Evenly (Roberts 2018): all over the texture, within 0.05 of a corner of tiles, or so near to an
// edge and a quarter of a tile from corners.
std::vector<Point> PointsIn(Region region, int count) {
  std::vector<Point> points;
  for (int i = 1; i <= count; ++i) {
    const double a = std::fmod(0.5 + i * 0.7548776662466927, 1.0);
    const double b = std::fmod(0.5 + i * 0.5698402909980532, 1.0);
    double x = a * kTiles;
    double y = b * kTiles;
    if (region != Region::kAll) {
      const double column = std::floor(x);
      const double row = std::floor(y);
      x = column + 0.1 * (x - column) - 0.05;
      y = region == Region::kCorners ? row + 0.1 * (y - row) - 0.05 : row + 0.25 + 0.5 * (y - row);
      if (region == Region::kEdges && i % 2 == 0) std::swap(x, y);
    }
    points.push_back({x / kTiles, y / kTiles});
  }
  return points;
}

double ErrorOf(const Way& way, const Tiles& tiles, const Reference& reference, double level,
               Region region = Region::kAll) {
  const std::vector<Point> points = PointsIn(region, region == Region::kAll ? 2000 : 500);
  const double pixel = std::exp2(level) / (kTiles * tiles.layout.tile_size);
  auto outputs =
      RunGraph(GraphOf(way), points, {pixel, pixel}, 1e-4, PictureFolder(), way.textures);
  double sum = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const float at[2] = {static_cast<float>(points[i].x), static_cast<float>(points[i].y)};
    const double difference =
        double{outputs["color"].Float(i)} -
        double{ir::SampleLod(reference.texture, at, static_cast<float>(level))[0]};
    sum += difference * difference;
  }
  return std::sqrt(sum / static_cast<double>(points.size())) / reference.deviation;
}

struct Errors {
  std::vector<double> all;  // by level
  std::vector<double> corners;
  std::vector<double> edges;
};

Errors ErrorsOf(const Way& way, const Tiles& tiles, const Reference& reference, int levels) {
  Errors errors;
  for (int level = 0; level < levels; ++level) {
    errors.all.push_back(ErrorOf(way, tiles, reference, level));
    errors.corners.push_back(ErrorOf(way, tiles, reference, level, Region::kCorners));
    errors.edges.push_back(ErrorOf(way, tiles, reference, level, Region::kEdges));
  }
  return errors;
}

Errors ErrorsOf(const Way& way, const Tiles& tiles, int levels) {
  return ErrorsOf(way, tiles, MakeReference(tiles, PlacesOf(way, tiles)), levels);
}

// Two texels a tile is the last level that shows the tiling.
TEST(TileFilteringTest, CornerTilesAreFilteredAsTheVirtualTexture) {
  const double limits[] = {0.001, 0.001, 0.001, 0.01, 0.05};
  for (const Tiles& tiles :
       {Synthetic(TileKind::kCorner, 2, 32), ByExample(TileKind::kCorner, 32)}) {
    for (const bool is_array : {false, true}) {
      const Errors errors = ErrorsOf(CornerTiles(tiles, is_array), tiles, 5);
      for (size_t level = 0; level < 5; ++level) {
        EXPECT_LE(errors.all[level], limits[level]) << level;
        EXPECT_LE(errors.corners[level], std::max(2.5 * errors.edges[level], 1e-4)) << level;
      }
    }
  }
}

// A size that is no power of two has the same levels as far as it can be halved: 24 three times.
// With three colours the pack has nine tiles a side.
TEST(TileFilteringTest, CornerTilesOfOtherSizesAreToo) {
  for (uint32_t colors : {2u, 3u}) {
    const Tiles tiles = Synthetic(TileKind::kCorner, colors, 24);
    // A texel of a level is a third larger than of a tile of 32.
    const double limits[] = {0.001, 0.001, 0.002, 0.01};
    for (const bool is_array : {false, true}) {
      const Errors errors = ErrorsOf(CornerTiles(tiles, is_array), tiles, 4);
      for (size_t level = 0; level < 4; ++level) {
        EXPECT_LE(errors.all[level], limits[level]) << colors << " " << level;
        // In layers it is 3.005 times at level 2.
        if (is_array) continue;
        EXPECT_LE(errors.corners[level], 3 * errors.edges[level]) << colors << " " << level;
      }
    }
  }
}

// 30 can be halved once. The texels of coarser levels begin elsewhere in a tile of the pack than
// in one of the virtual texture: what is seen is no more wrong than an ordinary texture is that
// begins half a texel of the level later.
TEST(TileFilteringTest, SizesThatCannotBeHalvedAreNoWorseThanAnotherGrid) {
  const Tiles tiles = Synthetic(TileKind::kCorner, 2, 30);
  const Way way = CornerTiles(tiles);
  const std::vector<TilePlace> places = PlacesOf(way, tiles);
  const Reference reference = MakeReference(tiles, places);
  EXPECT_LE(ErrorOf(way, tiles, reference, 1), 0.001);
  const std::vector<Point> points = PointsIn(Region::kAll, 2000);
  for (uint32_t level : {2u, 3u}) {
    const uint32_t from = 1u << (level - 1);
    const Reference other = MakeReference(tiles, places, from);
    const double moved = from / (30.0 * kTiles);
    double sum = 0;
    for (const Point& point : points) {
      const float at[2] = {static_cast<float>(point.x), static_cast<float>(point.y)};
      const float there[2] = {static_cast<float>(point.x - moved),
                              static_cast<float>(point.y - moved)};
      const auto lod = static_cast<float>(level);
      const double difference = double{ir::SampleLod(other.texture, there, lod)[0]} -
                                double{ir::SampleLod(reference.texture, at, lod)[0]};
      sum += difference * difference;
    }
    const double ordinary = std::sqrt(sum / 2000) / reference.deviation;
    EXPECT_LE(ErrorOf(way, tiles, reference, level), ordinary) << level;
  }
}

// The paper's own way: the pack is right along edges, and wrong at three corners in four.
TEST(TileFilteringTest, WangTilesAreRightAlongEdges) {
  const Tiles tiles = Synthetic(TileKind::kWang, 2, 32);
  const double limits[] = {0.0144, 0.0212, 0.0311, 0.0599};
  for (const bool is_array : {false, true}) {
    const Errors errors = ErrorsOf(WangTiles(tiles, is_array), tiles, 4);
    for (size_t level = 0; level < 4; ++level) EXPECT_LE(errors.all[level], limits[level]) << level;
    EXPECT_LE(errors.edges[0], 0.001);
    EXPECT_GT(errors.corners[0], 0.05);
  }
}

// The pack of corners takes nearly all of that away, as long as some texels of a level are within
// an eighth of a tile, and never adds any.
TEST(TileFilteringTest, ThePackOfCornersMendsThem) {
  for (const Tiles& tiles : {Synthetic(TileKind::kWang, 2, 32), ByExample(TileKind::kWang, 64)}) {
    const Way plain = WangTiles(tiles);
    const Way mended = WithCorners(tiles);
    const std::vector<TilePlace> places = PlacesOf(plain, tiles);
    EXPECT_EQ(PlacesOf(mended, tiles), places);
    const Reference reference = MakeReference(tiles, places);
    const Errors before = ErrorsOf(plain, tiles, reference, 4);
    const Errors after = ErrorsOf(mended, tiles, reference, 4);
    for (size_t level = 0; level < 4; ++level) {
      const double left = level < 2 ? 0.2 : level < 3 ? 0.4 : 1;
      EXPECT_LE(after.all[level], left * before.all[level]) << level;
      EXPECT_LE(after.corners[level], 0.5 * before.corners[level]) << level;
    }
    EXPECT_LE(after.corners[0], 0.1 * before.corners[0]);
  }
}

// What packing is for: in another order all borders are wrong.
TEST(TileFilteringTest, TilesInTheOrderOfTheirColoursAreWrongAtAllBorders) {
  for (TileKind kind : {TileKind::kCorner, TileKind::kWang}) {
    const Tiles tiles = Synthetic(kind, 2, 32);
    const Way packed = kind == TileKind::kCorner ? CornerTiles(tiles) : WangTiles(tiles);
    const std::vector<TilePlace> places = PlacesOf(packed, tiles);
    const Reference reference = MakeReference(tiles, places);
    const Way other = RowMajor(tiles, places);
    EXPECT_GT(ErrorOf(other, tiles, reference, 0), 0.05);
    EXPECT_GT(ErrorOf(other, tiles, reference, 0, Region::kEdges), 0.1);
    EXPECT_LT(ErrorOf(packed, tiles, reference, 0, Region::kEdges), 0.001);
  }
}

}  // namespace
}  // namespace texgraph::blocks
