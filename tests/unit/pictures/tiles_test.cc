// SPDX-License-Identifier: Apache-2.0
// Sheets of tiles that graphs lay beside each other in any order: nothing shows where two meet,
// they differ, and their mean colours are as the graphs need them.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>

#include "compiler/textures/image.h"

namespace texgraph {
namespace {

constexpr uint32_t kSide = 128;

struct Sheet {
  textures::Image image;
  uint32_t columns = 0;
  uint32_t count = 0;

  uint32_t At(uint32_t tile, uint32_t x, uint32_t y, uint32_t channel) const {
    return image.At(tile % columns * kSide + x, tile / columns * kSide + y, channel);
  }
};

Sheet ReadSheet(const std::string& path, uint32_t columns, uint32_t rows) {
  Diagnostics diagnostics;
  auto image = textures::ReadImage(TEXGRAPH_SOURCE_DIR "/graphs/" + path, {}, diagnostics);
  EXPECT_TRUE(image);
  if (!image) return {};
  EXPECT_EQ(image->width, columns * kSide);
  EXPECT_EQ(image->height, rows * kSide);
  EXPECT_EQ(image->channels, 3);
  return {std::move(*image), columns, columns * rows};
}

enum class Edge { kLeft, kRight, kTop, kBottom };
constexpr Edge kEdges[] = {Edge::kLeft, Edge::kRight, Edge::kTop, Edge::kBottom};

std::vector<uint32_t> Texels(const Sheet& sheet, uint32_t tile, Edge edge) {
  std::vector<uint32_t> texels;
  for (uint32_t i = 0; i < kSide; ++i) {
    const bool is_column = edge == Edge::kLeft || edge == Edge::kRight;
    const uint32_t fixed = edge == Edge::kLeft || edge == Edge::kTop ? 0 : kSide - 1;
    for (uint32_t c = 0; c < 3; ++c)
      texels.push_back(is_column ? sheet.At(tile, fixed, i, c) : sheet.At(tile, i, fixed, c));
  }
  return texels;
}

double MeanDifference(const std::vector<uint32_t>& a, const std::vector<uint32_t>& b) {
  double sum = 0;
  for (size_t i = 0; i < a.size(); ++i) sum += std::abs(static_cast<double>(a[i]) - b[i]);
  return sum / static_cast<double>(a.size());
}

// Between texels beside each other (or above) inside of tiles.
double MeanStep(const Sheet& sheet, bool across) {
  double sum = 0;
  for (uint32_t tile = 0; tile < sheet.count; ++tile) {
    for (uint32_t y = 0; y + 1 < kSide; ++y) {
      for (uint32_t x = 0; x + 1 < kSide; ++x) {
        for (uint32_t c = 0; c < 3; ++c) {
          const double other = across ? sheet.At(tile, x + 1, y, c) : sheet.At(tile, x, y + 1, c);
          sum += std::abs(other - sheet.At(tile, x, y, c));
        }
      }
    }
  }
  return sum / (sheet.count * (kSide - 1.0) * (kSide - 1.0) * 3);
}

std::array<double, 3> LinearMean(const Sheet& sheet, uint32_t tile) {
  std::array<double, 3> mean{};
  for (uint32_t y = 0; y < kSide; ++y) {
    for (uint32_t x = 0; x < kSide; ++x) {
      for (uint32_t c = 0; c < 3; ++c) {
        const double code = sheet.At(tile, x, y, c) / 255.0;
        mean[c] += code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
      }
    }
  }
  for (double& channel : mean) channel /= double{kSide} * kSide;
  return mean;
}

double MeanDifference(const Sheet& sheet, uint32_t a, uint32_t b) {
  double sum = 0;
  for (uint32_t y = 0; y < kSide; ++y) {
    for (uint32_t x = 0; x < kSide; ++x) {
      for (uint32_t c = 0; c < 3; ++c)
        sum += std::abs(static_cast<double>(sheet.At(a, x, y, c)) - sheet.At(b, x, y, c));
    }
  }
  return sum / (3.0 * kSide * kSide);
}

// Steps over borders, in all pairs of tiles that may meet, against steps inside.
void ExpectNoBorders(const Sheet& sheet, const std::function<bool(uint32_t, uint32_t)>& beside,
                     const std::function<bool(uint32_t, uint32_t)>& above) {
  double sums[2] = {0, 0};
  double counts[2] = {0, 0};
  for (uint32_t a = 0; a < sheet.count; ++a) {
    for (uint32_t b = 0; b < sheet.count; ++b) {
      if (beside(a, b)) {
        sums[0] += MeanDifference(Texels(sheet, a, Edge::kRight), Texels(sheet, b, Edge::kLeft));
        ++counts[0];
      }
      if (above(a, b)) {
        sums[1] += MeanDifference(Texels(sheet, a, Edge::kBottom), Texels(sheet, b, Edge::kTop));
        ++counts[1];
      }
    }
  }
  EXPECT_LE(sums[0] / counts[0], 1.1 * MeanStep(sheet, true));
  EXPECT_LE(sums[1] / counts[1], 1.1 * MeanStep(sheet, false));
}

TEST(TilesTest, MeadowsFitInAnyOrder) {
  for (const char* path : {"aperiodic_tiling/ground.png", "landscape/ground.png"}) {
    const Sheet sheet = ReadSheet(path, 4, 4);
    ASSERT_EQ(sheet.count, 16u);
    for (Edge edge : kEdges) {
      for (uint32_t tile = 1; tile < sheet.count; ++tile)
        EXPECT_EQ(Texels(sheet, tile, edge), Texels(sheet, 0, edge)) << path << " " << tile;
    }
    const auto any = [](uint32_t, uint32_t) { return true; };
    ExpectNoBorders(sheet, any, any);
    for (uint32_t a = 0; a < sheet.count; ++a) {
      for (uint32_t b = 0; b < a; ++b) EXPECT_GT(MeanDifference(sheet, a, b), 8) << a << " " << b;
    }
  }
}

// Sand at corner k of a tile, the corners being (0, 0), (1, 0), (0, 1), (1, 1).
bool IsSand(uint32_t tile, uint32_t k) {
  if (tile < 16) return tile >= 8;
  return ((tile - 15) >> k) & 1;
}

TEST(TilesTest, EdgesOfTheShoreDependOnTheirCorners) {
  const Sheet sheet = ReadSheet("transition_tiling/ground.png", 6, 5);
  ASSERT_EQ(sheet.count, 30u);
  constexpr uint32_t kCorners[4][2] = {{0, 2}, {1, 3}, {2, 3}, {0, 1}};  // of kEdges
  for (size_t i = 0; i < 4; ++i) {
    std::map<std::pair<bool, bool>, std::vector<uint32_t>> seen;
    for (uint32_t tile = 0; tile < sheet.count; ++tile) {
      const std::vector<uint32_t> texels = Texels(sheet, tile, kEdges[i]);
      const auto corners = std::pair(IsSand(tile, kCorners[i][0]), IsSand(tile, kCorners[i][1]));
      EXPECT_EQ(seen.try_emplace(corners, texels).first->second, texels) << tile;
    }
    EXPECT_EQ(seen.size(), 4u);
  }
  ExpectNoBorders(
      sheet,
      [](uint32_t a, uint32_t b) {
        return IsSand(a, 1) == IsSand(b, 0) && IsSand(a, 3) == IsSand(b, 2);
      },
      [](uint32_t a, uint32_t b) {
        return IsSand(a, 0) == IsSand(b, 2) && IsSand(a, 1) == IsSand(b, 3);
      });
}

TEST(TilesTest, MeansOfOneMeadowAreAlike) {
  const Sheet sheet = ReadSheet("aperiodic_tiling/ground.png", 4, 4);
  ASSERT_EQ(sheet.count, 16u);
  for (uint32_t c = 0; c < 3; ++c) {
    double sum = 0;
    double squares = 0;
    for (uint32_t tile = 0; tile < 16; ++tile) {
      const double mean = LinearMean(sheet, tile)[c];
      sum += mean / 16;
      squares += mean * mean / 16;
    }
    EXPECT_LE(std::sqrt(std::max(0.0, squares - sum * sum)), 0.02);
  }
}

// What all tiles have near their edges is as bright as what is inside: no lattice shows from afar.
TEST(TilesTest, MeadowsHaveNoMargin) {
  const Sheet sheet = ReadSheet("aperiodic_tiling/ground.png", 4, 4);
  ASSERT_EQ(sheet.count, 16u);
  constexpr uint32_t kMargin = 8;
  for (bool across : {true, false}) {
    double sums[2] = {0, 0};
    for (uint32_t tile = 0; tile < sheet.count; ++tile) {
      for (uint32_t y = 0; y < kSide; ++y) {
        for (uint32_t x = 0; x < kSide; ++x) {
          const uint32_t place = across ? x : y;
          const bool is_inside = place >= kMargin && place < kSide - kMargin;
          const double green = sheet.At(tile, x, y, 1) / 255.0;
          sums[is_inside] += green * green;
        }
      }
    }
    const double margin = sums[0] / (2 * kMargin);
    const double inside = sums[1] / (kSide - 2 * kMargin);
    EXPECT_NEAR(margin / inside, 1, 0.04) << across;
  }
}

// The rows of the landscape are its materials.
TEST(TilesTest, MaterialsDifferModerately) {
  const Sheet sheet = ReadSheet("landscape/ground.png", 4, 4);
  ASSERT_EQ(sheet.count, 16u);
  std::array<double, 3> means[4] = {};
  for (uint32_t tile = 0; tile < 16; ++tile) {
    for (uint32_t c = 0; c < 3; ++c) means[tile / 4][c] += LinearMean(sheet, tile)[c] / 4;
  }
  for (uint32_t a = 0; a < 4; ++a) {
    for (uint32_t b = 0; b < a; ++b) {
      double largest = 0;
      for (uint32_t c = 0; c < 3; ++c)
        largest = std::max(largest, std::abs(means[a][c] - means[b][c]));
      EXPECT_GE(largest, 0.015) << a << " " << b;
      EXPECT_LE(largest, 0.10) << a << " " << b;
    }
  }
}

}  // namespace
}  // namespace texgraph
