// SPDX-License-Identifier: Apache-2.0
// A zoom over a factor of 1,024 out of the grass of graphs/grass_tiles: everywhere it has the
// brightness of its picture, and nowhere a grid.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "compiler/textures/image.h"
#include "compiler/textures/texels.h"
#include "compiler/textures/tile_levels.h"
#include "compiler/textures/tile_set.h"
#include "tests/blocks/run_block.h"

namespace texgraph::blocks {
namespace {

using textures::TileKind;

constexpr uint32_t kSize = 64;  // texels of a tile

textures::TileSet GrassTiles(TileKind kind, bool even) {
  Diagnostics diagnostics;
  const auto grass =
      textures::ReadImage(TEXGRAPH_SOURCE_DIR "/graphs/grass_tiles/grass.png", {}, diagnostics);
  textures::TileSetOptions options;
  options.kind = kind;
  options.tile_size = kSize;
  options.candidates = 64;
  options.wraps = true;
  options.even = even;
  return *textures::MakeTileSet({&*grass, 1}, {}, options, "grass", {}, diagnostics);
}

ir::Texture TextureOf(const textures::TileSet& set) {
  Diagnostics diagnostics;
  textures::TextureOptions options;
  options.srgb = true;
  options.as_float = true;
  return ToTexture(*MakeTileTexture(set.packs[0], set.layout, options, "grass", {}, diagnostics));
}

using Rgb = std::array<double, 3>;

struct View {
  Rgb mean{};
  Rgb deviation{};
  double grid = 0;  // root mean square of how the 4 x 4 parts of all tiles differ from the mean
};

constexpr int kPlaces = 4096;
constexpr double kTiles = 64;  // each way

// Pixels of so many tiles, all over the plane.
View Look(TileKind kind, const ir::Texture& pack, double pixel) {
  const std::string colors = kind == TileKind::kCorner ? "2" : "[2, 2]";
  const std::string block = kind == TileKind::kCorner ? "corner_tiles" : "wang_tiles";
  const std::string graph = R"({"texgraph": 1, "textures": {"set": {"file": "mortar.png"}},
    "nodes": {"t": {"block": ")" +
                            block + R"(",
                    "in": {"tiles": "set", "colors": )" +
                            colors + R"(, "tiling": 1}}},
    "outputs": {"color": "t.color"}})";
  std::vector<Point> places;
  for (int i = 0; i < kPlaces; ++i) {
    // Points that fill the square evenly: Roberts 2018.
    places.push_back({std::fmod(0.5 + i * 0.7548776662466927, 1.0) * kTiles,
                      std::fmod(0.5 + i * 0.5698402909980532, 1.0) * kTiles});
  }
  auto outputs = RunGraph(graph, places, {pixel, pixel}, 1e-4, PictureFolder(), {{"set", pack}});
  View view;
  std::array<double, 16> parts{};
  std::array<double, 16> counts{};
  Rgb squares{};
  for (size_t i = 0; i < places.size(); ++i) {
    for (uint32_t c = 0; c < 3; ++c) {
      const double value = outputs["color"].Float(i, c);
      view.mean[c] += value / kPlaces;
      squares[c] += value * value / kPlaces;
    }
    const auto part = [](double at) { return static_cast<size_t>((at - std::floor(at)) * 4); };
    const size_t in = part(places[i].y) * 4 + part(places[i].x);
    parts[in] += outputs["color"].Float(i, 1);
    counts[in] += 1;
  }
  for (size_t c = 0; c < 3; ++c)
    view.deviation[c] = std::sqrt(std::max(squares[c] - view.mean[c] * view.mean[c], 0.0));
  for (size_t i = 0; i < 16; ++i) {
    const double off = parts[i] / counts[i] - view.mean[1];
    view.grid += off * off / 16;
  }
  view.grid = std::sqrt(view.grid);
  return view;
}

class FarFieldTest : public testing::TestWithParam<TileKind> {};

TEST_P(FarFieldTest, AZoomKeepsTheMeanAndShowsNoGrid) {
  const textures::TileSet set = GrassTiles(GetParam(), true);
  const ir::Texture pack = TextureOf(set);
  Rgb mean{};
  for (const ir::Texel& texel : pack.levels[0].texels) {
    for (size_t c = 0; c < 3; ++c)
      mean[c] += double{texel[c]} / static_cast<double>(pack.levels[0].texels.size());
  }
  double last = 1;
  for (int scale = -6; scale <= 4; ++scale) {
    const View view = Look(GetParam(), pack, std::exp2(scale));
    for (size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(view.mean[c], mean[c], 0.005) << "2^" << scale << " tiles a pixel";
    }
    // The further away, the less there is to be seen, down to nothing at a tile a pixel.
    EXPECT_LE(view.deviation[1], last + 0.002) << "2^" << scale << " tiles a pixel";
    last = view.deviation[1];
    // Near by, so few points know it no better.
    EXPECT_LE(view.grid, scale < -4 ? 0.004 : 0.0015) << "2^" << scale << " tiles a pixel";
    if (scale >= 0) {
      for (double deviation : view.deviation) EXPECT_LE(deviation, 1e-5);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, FarFieldTest, testing::Values(TileKind::kCorner, TileKind::kWang),
                         [](const auto& info) {
                           return info.param == TileKind::kCorner ? "corner_tiles" : "wang_tiles";
                         });

}  // namespace
}  // namespace texgraph::blocks
