// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/cube_levels.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/textures/cube_testing.h"

namespace texgraph::textures {
namespace {

using test::GrainSlices;
using test::SmallCubes;

constexpr uint32_t kCubes = 4;  // of the virtual volume, each way

std::optional<CubeSet> Cubes(uint32_t size) {
  Diagnostics diagnostics;
  return MakeCubeSet(GrainSlices(2 * size, 1, 8, 11), SmallCubes(2, size), "granite", {},
                     diagnostics);
}

ir::Texture CubeTexture(const CubeSet& set, TextureOptions options = {}) {
  options.srgb = false;
  options.as_float = true;
  Diagnostics diagnostics;
  const auto data = MakeCubeTexture(set, options, "granite", {}, diagnostics);
  EXPECT_TRUE(data);
  return ToTexture(*data);
}

uint32_t Color(uint32_t x, uint32_t y, uint32_t z) {
  uint32_t h = (x % kCubes) * 0x9E3779B1u ^ (y % kCubes) * 0x85EBCA77u ^ (z % kCubes) * 0xC2B2AE3Du;
  h = (h ^ h >> 15) * 0x2C1B3C6Du;
  return (h ^ h >> 12) >> 5 & 1;
}

// A volume of some cubes that repeats, with all its levels: what the pack stands for.
struct Virtual {
  ir::Texture texture;
  std::vector<CubePlace> places;
};

Virtual BruteForce(const ir::Texture& pack, const CubeSet& set) {
  Virtual result;
  const uint32_t size = set.layout.cube_size;
  result.texture.is_3d = true;
  ir::Texture::Level& base = result.texture.levels.emplace_back();
  base.width = base.height = base.depth = kCubes * size;
  base.texels.resize(size_t{base.width} * base.height * base.depth);
  const ir::Texture::Level& from = pack.levels[0];
  for (uint32_t cube = 0; cube < kCubes * kCubes * kCubes; ++cube) {
    const uint32_t at[3] = {cube % kCubes, cube / kCubes % kCubes, cube / kCubes / kCubes};
    CubeColors colors;
    for (uint32_t i = 0; i < 8; ++i)
      colors[i] = Color(at[0] + (i & 1), at[1] + (i >> 1 & 1), at[2] + (i >> 2));
    const CubePlace place = PackedCube(colors, 2);
    result.places.push_back(place);
    test::ForBox({0, 0, 0}, {size, size, size}, [&](std::array<int64_t, 3> texel) {
      const auto x = static_cast<size_t>(texel[0]);
      const auto y = static_cast<size_t>(texel[1]);
      const auto z = static_cast<size_t>(texel[2]);
      base.texels[((at[2] * size + z) * base.height + at[1] * size + y) * base.width +
                  at[0] * size + x] =
          from.texels[((place.z * size + z) * from.height + place.y * size + y) * from.width +
                      place.x * size + x];
    });
  }
  ir::BuildMipChain(result.texture);
  return result;
}

// Root of the mean squared difference of the pack to the virtual volume at a level, over points all
// over it, as a part of the volume's standard deviation.
double FilteringError(const ir::Texture& pack, const CubeSet& set, const Virtual& reference,
                      uint32_t level) {
  double mean = 0;
  double square = 0;
  for (const ir::Texel& texel : reference.texture.levels[0].texels) {
    mean += double{texel[0]};
    square += double{texel[0]} * double{texel[0]};
  }
  const auto texels = static_cast<double>(reference.texture.levels[0].texels.size());
  const double variance = square / texels - mean / texels * (mean / texels);
  double sum = 0;
  constexpr uint32_t kPoints = 8000;
  for (uint32_t i = 0; i < kPoints; ++i) {
    // Points that fill the cube evenly: Roberts 2018.
    const double at[3] = {std::fmod(0.5 + i * 0.8191725133961645, 1.0) * kCubes,
                          std::fmod(0.5 + i * 0.6710436067037893, 1.0) * kCubes,
                          std::fmod(0.5 + i * 0.5497004779019703, 1.0) * kCubes};
    const auto cell = [&](int axis) { return static_cast<size_t>(at[axis]); };
    const CubePlace place = reference.places[(cell(2) * kCubes + cell(1)) * kCubes + cell(0)];
    const double n = set.layout.side;
    const float packed[3] = {static_cast<float>((place.x + at[0] - std::floor(at[0])) / n),
                             static_cast<float>((place.y + at[1] - std::floor(at[1])) / n),
                             static_cast<float>((place.z + at[2] - std::floor(at[2])) / (n * n))};
    const float wanted[3] = {static_cast<float>(at[0] / kCubes), static_cast<float>(at[1] / kCubes),
                             static_cast<float>(at[2] / kCubes)};
    const auto lod = static_cast<float>(level);
    const double difference = double{ir::SampleLod(pack, packed, lod)[0]} -
                              double{ir::SampleLod(reference.texture, wanted, lod)[0]};
    sum += difference * difference;
  }
  return std::sqrt(sum / kPoints / variance);
}

// As tiles do with as many texels a side: down to eight exactly, then by the neighbours' insides.
TEST(CubeLevelsTest, CubesAreFilteredAsTheVirtualVolume) {
  const auto set = Cubes(16);
  ASSERT_TRUE(set);
  const ir::Texture pack = CubeTexture(*set);
  ASSERT_EQ(pack.levels.size(), 5u);
  const Virtual reference = BruteForce(pack, *set);
  const double limits[] = {0.001, 0.001, 0.01, 0.05};
  for (uint32_t level = 0; level < 4; ++level) {
    EXPECT_LE(FilteringError(pack, *set, reference, level), limits[level]) << level;
  }
}

TEST(CubeLevelsTest, TheCoarsestLevelIsTheMeanOfTheSet) {
  const auto set = Cubes(4);
  ASSERT_TRUE(set);
  const ir::Texture pack = CubeTexture(*set);
  ASSERT_EQ(pack.levels.size(), 3u);
  EXPECT_EQ(pack.sampler.max_level, 2.0f);
  EXPECT_EQ(pack.sampler.wrap_w, ir::Wrap::kRepeat);
  EXPECT_EQ(pack.levels[0].depth, 64u);
  EXPECT_EQ(pack.levels[2].depth, 16u);
  double mean = 0;
  for (uint32_t y = 0; y < set->pack.height; ++y) {
    for (uint32_t x = 0; x < set->pack.width; ++x) mean += set->pack.At(x, y, 0) / 255.0;
  }
  mean /= static_cast<double>(size_t{set->pack.width} * set->pack.height);
  for (const ir::Texel& texel : pack.levels[2].texels) ASSERT_NEAR(double{texel[0]}, mean, 1e-6);
  TextureOptions options;
  options.max_level = 1;
  EXPECT_EQ(CubeTexture(*set, options).levels.size(), 2u);
  options.mipmaps = false;
  EXPECT_EQ(CubeTexture(*set, options).levels.size(), 1u);
}

}  // namespace
}  // namespace texgraph::textures
