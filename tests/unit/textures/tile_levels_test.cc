// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/tile_levels.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/textures/tile_pictures.h"
#include "tests/unit/textures/tile_testing.h"

namespace texgraph::textures {
namespace {

using test::SmallTiles;
using test::StrokesImage;

ir::Texture TileTexture(const Image& pack, const TilePackLayout& layout,
                        TextureOptions options = {}) {
  options.srgb = false;
  options.as_float = true;
  Diagnostics diagnostics;
  const auto data = MakeTileTexture(pack, layout, options, "grass", {}, diagnostics);
  EXPECT_TRUE(data);
  return ToTexture(*data);
}

// The virtual texture of so many tiles each way, with all its levels: what the pack stands for.
struct Virtual {
  ir::Texture texture;
  std::vector<TilePlace> places;  // of the tiles, from the left bottom one
};

constexpr uint32_t kTiles = 16;

uint32_t Color(uint32_t x, uint32_t y, uint32_t axis, uint32_t colors) {
  uint32_t h = (x % kTiles) * 0x9E3779B1u ^ (y % kTiles) * 0x85EBCA77u ^ axis * 0xC2B2AE3Du;
  h = (h ^ h >> 15) * 0x2C1B3C6Du;
  h = (h ^ h >> 12) * 0x297A2D39u;
  return (h ^ h >> 15) % colors;
}

Virtual BruteForce(const ir::Texture& pack, const TilePackLayout& layout) {
  Virtual result;
  const uint32_t size = layout.tile_size;
  ir::Texture::Level& base = result.texture.levels.emplace_back();
  base.width = base.height = kTiles * size;
  base.texels.resize(size_t{base.width} * base.height);
  for (uint32_t y = 0; y < kTiles; ++y) {
    for (uint32_t x = 0; x < kTiles; ++x) {
      const uint32_t n = layout.colors[0];
      const uint32_t m = layout.colors[1];
      const TileColors colors = layout.kind == TileKind::kCorner
                                    ? TileColors{Color(x, y, 0, n), Color(x + 1, y, 0, n),
                                                 Color(x, y + 1, 0, n), Color(x + 1, y + 1, 0, n)}
                                    : TileColors{Color(x, y, 0, n), Color(x + 1, y, 1, m),
                                                 Color(x, y + 1, 0, n), Color(x, y, 1, m)};
      const TilePlace place = PackedTile(layout, colors);
      result.places.push_back(place);
      for (uint32_t row = 0; row < size; ++row) {
        for (uint32_t column = 0; column < size; ++column) {
          const ir::Texture::Level& from = pack.levels[0];
          base.texels[(size_t{y} * size + row) * base.width + x * size + column] =
              from.texels[(size_t{place.y} * size + layout.gutter + row) * from.width +
                          place.x * size + column];
        }
      }
    }
  }
  ir::BuildMipChain(result.texture);
  return result;
}

// Root of the mean squared difference of the pack to the virtual texture at a level, over points
// all over it, as a part of the texture's standard deviation. `near`: only points so near to a
// corner, in tiles.
double FilteringError(const ir::Texture& pack, const TilePackLayout& layout,
                      const Virtual& reference, uint32_t level, double near = 1) {
  const ir::Texture::Level& base = reference.texture.levels[0];
  double mean = 0;
  double square = 0;
  for (const ir::Texel& texel : base.texels) {
    mean += double{texel[0]};
    square += double{texel[0]} * double{texel[0]};
  }
  const auto texels = static_cast<double>(base.texels.size());
  const double variance = square / texels - mean / texels * (mean / texels);
  double sum = 0;
  uint32_t count = 0;
  for (uint32_t i = 0; i < 40000; ++i) {
    // Points that fill the square evenly: Roberts 2018.
    const double u = std::fmod(0.5 + i * 0.7548776662466927, 1.0) * kTiles;
    const double v = std::fmod(0.5 + i * 0.5698402909980532, 1.0) * kTiles;
    if (std::max(std::abs(u - std::round(u)), std::abs(v - std::round(v))) > near) continue;
    const TilePlace place =
        reference.places[static_cast<size_t>(v) * kTiles + static_cast<size_t>(u)];
    const double size = layout.tile_size;
    const float at[2] = {static_cast<float>((place.x + u - std::floor(u)) * size / layout.width()),
                         static_cast<float>(((place.y + v - std::floor(v)) * size + layout.gutter) /
                                            layout.height())};
    const float wanted[2] = {static_cast<float>(u / kTiles), static_cast<float>(v / kTiles)};
    const auto lod = static_cast<float>(level);
    const double difference = double{ir::SampleLod(pack, at, lod)[0]} -
                              double{ir::SampleLod(reference.texture, wanted, lod)[0]};
    sum += difference * difference;
    ++count;
  }
  return std::sqrt(sum / count / variance);
}

std::optional<TileSet> Tiles(TileKind kind, std::array<uint32_t, 2> colors, uint32_t size) {
  const Image sample = StrokesImage(3 * size, 3 * size, 1, 8, 11);
  Diagnostics diagnostics;
  return MakeTileSet({&sample, 1}, {}, SmallTiles(kind, colors, size), "grass", {}, diagnostics);
}

// O23, with the numbers of Wei's and of corner tiles for tiles of 32 texels.
TEST(TileLevelsTest, CornerTilesAreFilteredAsTheVirtualTexture) {
  for (uint32_t colors : {2u, 3u}) {
    const auto set = Tiles(TileKind::kCorner, {colors, colors}, 32);
    ASSERT_TRUE(set);
    const ir::Texture pack = TileTexture(set->packs[0], set->layout);
    ASSERT_EQ(pack.levels.size(), 6u);
    const Virtual reference = BruteForce(pack, set->layout);
    const double limits[] = {0.001, 0.001, 0.001, 0.01, 0.05};
    for (uint32_t level = 0; level < 5; ++level) {
      const double all = FilteringError(pack, set->layout, reference, level);
      EXPECT_LE(all, limits[level]) << colors << " colours, level " << level;
    }
    // Corners are no worse than what is around them; Wei's are wrong by a quarter.
    EXPECT_LE(FilteringError(pack, set->layout, reference, 0, 0.05), 0.001);
    const double corner = FilteringError(pack, set->layout, reference, 4, 0.05);
    EXPECT_LE(corner, 2.5 * FilteringError(pack, set->layout, reference, 4));
  }
}

// The same for Wang tiles as Wei packs them: at corners the neighbours in the pack are others.
TEST(TileLevelsTest, WangTilesAreFilteredNoWorseThanWeisAre) {
  const auto set = Tiles(TileKind::kWang, {2, 2}, 32);
  ASSERT_TRUE(set);
  const ir::Texture pack = TileTexture(set->packs[0], set->layout);
  const Virtual reference = BruteForce(pack, set->layout);
  const double limits[] = {0.0144, 0.0212, 0.0311, 0.0599, 0.2176};
  for (uint32_t level = 0; level < 5; ++level) {
    EXPECT_LE(FilteringError(pack, set->layout, reference, level), limits[level]) << level;
  }
  EXPECT_LE(FilteringError(pack, set->layout, reference, 0, 0.05), 0.246);
}

// Wei's corners: a texel of a level is the mean of the texels below it there, too, and the last
// level is that of the tiles themselves. Other colours of edges than two have another mean.
TEST(TileLevelsTest, CornersEndAtTheMeanOfTheTiles) {
  const TilePackLayout layout = LayOutTiles(TileKind::kWang, {1, 3}, 8);
  const Image pack = test::RandomImage(layout.width(), layout.height(), 1, 16, 2);
  const Image around = MakeWeiCornerPack(pack, layout);
  TextureOptions options;
  options.srgb = options.alpha_is_opacity = false;
  options.as_float = true;
  Diagnostics diagnostics;
  const auto data = MakeCornerTexture(pack, layout, options, "corners", {}, diagnostics);
  ASSERT_TRUE(data);
  const ir::Texture corners = ToTexture(*data);
  const ir::Texture tiles = TileTexture(pack, layout);
  ASSERT_EQ(corners.levels.size(), 4u);
  ASSERT_EQ(corners.levels[0].width, 8u);
  ASSERT_EQ(corners.levels[0].height, 72u);
  for (uint32_t y = 0; y < 36; ++y) {
    for (uint32_t x = 0; x < 4; ++x) {
      double sum = 0;
      for (uint32_t i = 0; i < 4; ++i) sum += test::UpAt(around, 2 * x + i % 2, 2 * y + i / 2, 0);
      ASSERT_NEAR(double{corners.levels[1].texels[y * 4 + x][0]}, sum / (4 * 65535.0), 1e-6);
    }
  }
  for (const ir::Texel& texel : corners.levels[3].texels)
    ASSERT_EQ(texel[0], tiles.levels[3].texels[0][0]);
  double mean = 0;
  for (uint32_t i = 0; i < 8 * 72; ++i) mean += test::UpAt(around, i % 8, i / 8, 0);
  EXPECT_GT(std::abs(mean / (576 * 65535.0) - double{tiles.levels[3].texels[0][0]}), 1e-3);
  EXPECT_FALSE(MakeCornerTexture(around, layout, options, "corners", {}, diagnostics));
}

// A texel of a level is the mean of the texels of the sample's numbers below it, of one tile.
TEST(TileLevelsTest, TexelsAreMeansOfTheirTile) {
  const TilePackLayout layout = LayOutTiles(TileKind::kCorner, {4, 4}, 8);
  const Image pack = test::RandomImage(layout.width(), layout.height(), 1, 16, 1);
  const ir::Texture texture = TileTexture(pack, layout);
  ASSERT_EQ(texture.levels.size(), 4u);
  EXPECT_EQ(texture.sampler.max_level, 3.0f);
  EXPECT_EQ(texture.sampler.wrap_u, ir::Wrap::kRepeat);
  EXPECT_EQ(texture.sampler.wrap_v, ir::Wrap::kClamp);
  for (uint32_t level = 0; level < 3; ++level) {
    const ir::Texture::Level& texels = texture.levels[level];
    ASSERT_EQ(texels.width, layout.width() >> level);
    ASSERT_EQ(texels.height, layout.height() >> level);
    const uint32_t side = 1u << level;
    for (uint32_t y = 0; y < texels.height; ++y) {
      for (uint32_t x = 0; x < texels.width; ++x) {
        double sum = 0;
        for (uint32_t i = 0; i < side * side; ++i)
          sum += test::UpAt(pack, x * side + i % side, y * side + i / side, 0);
        ASSERT_NEAR(double{texels.texels[y * texels.width + x][0]}, sum / (65535.0 * side * side),
                    1e-6);
      }
    }
  }
  double mean = 0;
  for (uint32_t y = layout.gutter; y < layout.height() - layout.gutter; ++y) {
    for (uint32_t x = 0; x < layout.width(); ++x) mean += test::UpAt(pack, x, y, 0);
  }
  mean /= 65535.0 * layout.width() * layout.rows * layout.tile_size;
  for (const ir::Texel& texel : texture.levels[3].texels) ASSERT_NEAR(double{texel[0]}, mean, 1e-6);
}

// In layers of 2 x 2 a tile has the texels of all levels that it has in the picture, but the last,
// which is the mean everywhere, and the tiles beside it are its neighbours in the layer.
TEST(TileLevelsTest, LayersHaveTheSameLevels) {
  for (const TileKind kind : {TileKind::kCorner, TileKind::kWang}) {
    const TilePackLayout layout = LayOutTiles(kind, {4, 4}, 8);
    const Image pack = test::RandomImage(layout.width(), layout.height(), 1, 16, 1);
    const ir::Texture picture = TileTexture(pack, layout);
    TextureOptions options;
    options.is_array = true;
    const ir::Texture layers = TileTexture(pack, layout, options);
    EXPECT_TRUE(layers.is_array);
    EXPECT_EQ(layers.sampler.wrap_v, ir::Wrap::kRepeat);
    ASSERT_EQ(layers.levels.size(), picture.levels.size());
    for (uint32_t level = 0; level < layers.levels.size(); ++level) {
      const ir::Texture::Level& seen = layers.levels[level];
      const ir::Texture::Level& from = picture.levels[level];
      const uint32_t size = 8u >> level, gutter = layout.gutter >> level;
      ASSERT_EQ(seen.width, 2 * size);
      ASSERT_EQ(seen.height, 2 * size);
      ASSERT_EQ(seen.depth, layout.tiles());
      for (uint32_t i = 0; i < seen.texels.size(); ++i) {
        const uint32_t x = i % seen.width, y = i / seen.width % seen.height;
        const uint32_t layer = i / (seen.width * seen.height);
        const TilePlace place = PackedTile(layout, TileInLayer(layout, layer, x / size, y / size));
        const size_t row = size_t{place.y} * size + gutter + y % size;
        // The last level of the picture has half a texel for a gutter.
        const ir::Texel& wanted =
            size == 1 ? from.texels[0] : from.texels[row * from.width + place.x * size + x % size];
        ASSERT_NEAR(double{seen.texels[i][0]}, double{wanted[0]}, 1e-6);
      }
    }
  }
}

// 2^26 texels: four times the tiles.
TEST(TileLevelsTest, LayersHaveALimit) {
  const std::pair<uint32_t, uint32_t> limits[] = {{2, 1024}, {3, 455}, {4, 256}};
  for (const auto& [colors, largest] : limits) {
    Diagnostics diagnostics;
    const auto check = [&](uint32_t size) {
      const TilePackLayout layout = LayOutTiles(TileKind::kCorner, {colors, colors}, size);
      return CheckTileLayers(layout, "grass", {}, diagnostics);
    };
    EXPECT_TRUE(check(largest));
    EXPECT_FALSE(check(largest + 1));
    ASSERT_EQ(diagnostics.all().size(), 1u);
    EXPECT_EQ(diagnostics.all()[0].kind, DiagnosticKind::kSizeLimit);
    EXPECT_EQ(diagnostics.all()[0].message,
              "the tiles of 'grass' have " + std::to_string(largest + 1) +
                  " texels a side; in layers, where each stands four times, up to " +
                  std::to_string(largest) + " are possible; \"pack\": \"atlas\" has each once");
  }
}

TEST(TileLevelsTest, ColoursCountAsMuchAsThereIsOfThem) {
  const TilePackLayout layout = LayOutTiles(TileKind::kWang, {1, 1}, 4);
  // A quarter is red and there, the rest green and not.
  std::vector<uint32_t> samples;
  for (uint32_t i = 0; i < 16; ++i) {
    const bool red = i % 4 == 0;
    samples.insert(samples.end(), {red ? 255u : 0u, red ? 0u : 255u, 0u, red ? 255u : 0u});
  }
  const Image pack = test::MakeImage(4, 4, 4, 8, samples);
  TextureOptions options;
  options.alpha_is_opacity = true;
  const ir::Texture texture = TileTexture(pack, layout, options);
  EXPECT_EQ(texture.sampler.wrap_v, ir::Wrap::kRepeat);
  ASSERT_EQ(texture.levels.size(), 3u);
  const ir::Texel& mean = texture.levels[2].texels[0];
  EXPECT_NEAR(mean[0], 1, 1e-4);
  EXPECT_NEAR(mean[1], 0, 1e-4);
  EXPECT_NEAR(mean[3], 0.25, 1e-6);
}

TEST(TileLevelsTest, LevelsEndAtATexelATile) {
  EXPECT_EQ(TileMaxLevel(4), 2u);
  EXPECT_EQ(TileMaxLevel(100), 6u);
  EXPECT_EQ(TileMaxLevel(256), 8u);
  const TilePackLayout layout = LayOutTiles(TileKind::kCorner, {2, 2}, 5);
  const Image pack = test::RandomImage(20, 20, 3, 8, 1);
  TextureOptions options;
  EXPECT_EQ(TileTexture(pack, layout, options).levels.size(), 3u);
  options.max_level = 1;
  EXPECT_EQ(TileTexture(pack, layout, options).levels.size(), 2u);
  options.mipmaps = false;
  EXPECT_EQ(TileTexture(pack, layout, options).levels.size(), 1u);
}

TEST(TileLevelsTest, PacksOfOtherSizesAreRefused) {
  const TilePackLayout layout = LayOutTiles(TileKind::kCorner, {2, 2}, 8);
  Diagnostics diagnostics;
  EXPECT_FALSE(
      MakeTileTexture(test::RandomImage(32, 24, 1, 8, 1), layout, {}, "grass", {}, diagnostics));
  ASSERT_EQ(diagnostics.all().size(), 1u);
  EXPECT_EQ(diagnostics.all()[0].kind, DiagnosticKind::kBadImage);
  EXPECT_EQ(diagnostics.all()[0].message,
            "the tiles of texture 'grass' have 32 x 24 pixels; 4 x 4 tiles of 8 take 32 x 32");
}

}  // namespace
}  // namespace texgraph::textures
