// SPDX-License-Identifier: Apache-2.0
// Cubes by the colours of their corners: the blocks against the definition of a set (each
// combination of colours once, neighbours that agree), counts of cubes, and what must not repeat.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "tests/blocks/reference.h"
#include "tests/blocks/run_block.h"

namespace texgraph::blocks {
namespace {

using Cell = std::array<int, 3>;
using Corners = std::array<int, 8>;

int Wrapped(int cell, int count) { return count == 0 ? cell : ((cell % count) + count) % count; }

Values Cells3(const std::vector<Cell>& cells) {
  Values values{ir::kIvec3, cells.size(), {}};
  for (size_t axis = 0; axis < 3; ++axis) {
    for (const Cell& cell : cells) values.words.push_back(static_cast<uint32_t>(cell[axis]));
  }
  return values;
}

// The corners of all cubes by where they stand.
std::map<Cell, Corners> PlacesOf(int colors) {
  std::vector<Corners> cubes;
  const int count = static_cast<int>(std::lround(std::pow(colors, 8)));
  for (int i = 0; i < count; ++i) {
    Corners& corners = cubes.emplace_back();
    for (int rest = i, k = 0; k < 8; ++k, rest /= colors)
      corners[static_cast<size_t>(k)] = rest % colors;
  }
  const auto half = [&](size_t first) {
    Values values{ir::kIvec4, cubes.size(), {}};
    for (size_t k = 0; k < 4; ++k) {
      for (const Corners& corners : cubes)
        values.words.push_back(static_cast<uint32_t>(corners[first + k]));
    }
    return values;
  };
  auto outputs = RunBlock("corner_cube_place",
                          {{"below", half(0)}, {"above", half(4)}, {"colors", Ints({colors})}});
  std::map<Cell, Corners> places;
  for (size_t i = 0; i < cubes.size(); ++i) {
    const Values& at = outputs["result"];
    EXPECT_TRUE(places.emplace(Cell{at.Int(i, 0), at.Int(i, 1), at.Int(i, 2)}, cubes[i]).second);
  }
  return places;
}

// N x N x N^2 places, N the square of the colours, each taken; who touches has the same colours at
// the face, around the torus along all axes. So edges and corners agree, too.
TEST(CornerCubePlaceTest, PacksEachCubeOnceWithFittingNeighbours) {
  for (int colors : {2, 3}) {
    const std::map<Cell, Corners> places = PlacesOf(colors);
    const int n = colors * colors;
    const int sides[3] = {n, n, n * n};
    ASSERT_EQ(places.size(), static_cast<size_t>(n * n * n * n));
    for (const auto& [place, corners] : places) {
      for (size_t axis = 0; axis < 3; ++axis) {
        ASSERT_GE(place[axis], 0);
        ASSERT_LT(place[axis], sides[axis]);
        Cell next = place;
        next[axis] = (next[axis] + 1) % sides[axis];
        const Corners& others = places.at(next);
        for (size_t k = 0; k < 8; ++k) {
          if (!(k >> axis & 1)) continue;
          ASSERT_EQ(corners[k], others[k - (size_t{1} << axis)]) << axis;
        }
      }
    }
  }
}

// A pack with one texel a cube, which has its column, its row and its layer.
ir::Texture PackOf(int colors) {
  ir::Texture pack;
  pack.is_3d = true;
  ir::Texture::Level& level = pack.levels.emplace_back();
  const auto n = static_cast<uint32_t>(colors * colors);
  level.width = level.height = n;
  level.depth = n * n;
  for (uint32_t i = 0; i < n * n * n * n; ++i) {
    level.texels.push_back({static_cast<float>(i % n), static_cast<float>(i / n % n),
                            static_cast<float>(i / n / n), 1});
  }
  pack.sampler.filter = ir::Filter::kNearest;
  pack.sampler.mip_filter = ir::MipFilter::kNone;
  return pack;
}

struct Space {
  std::vector<Cell> places;
  std::vector<int> numbers;
};

// At the middles of cells.
Space Fill(int colors, const std::vector<Cell>& cells, int period = 0, int seed = 0) {
  const ir::Texture pack = PackOf(colors);
  std::vector<Vector> at;
  for (const Cell& cell : cells) at.push_back({cell[0] + 0.5, cell[1] + 0.5, cell[2] + 0.5});
  auto outputs = RunBlock("corner_cubes", {{"cubes", pack},
                                           {"position", Vectors(at)},
                                           {"tiling", Vectors({{1, 1, 1}})},
                                           {"colors", Ints({colors})},
                                           {"period", Cells3({{period, period, period}})},
                                           {"seed", Ints({seed})}});
  Space space;
  const int n = colors * colors;
  for (size_t i = 0; i < cells.size(); ++i) {
    Cell& place = space.places.emplace_back();
    for (size_t axis = 0; axis < 3; ++axis)
      place[axis] = static_cast<int>(outputs["color"].Float(i, axis));
    space.numbers.push_back(outputs["index"].Int(i));
    EXPECT_EQ(space.numbers.back(), place[0] + n * (place[1] + n * place[2]));
  }
  return space;
}

std::vector<Cell> Box(Cell first, Cell size) {
  std::vector<Cell> cells;
  for (int z = 0; z < size[2]; ++z) {
    for (int y = 0; y < size[1]; ++y) {
      for (int x = 0; x < size[0]; ++x) cells.push_back({first[0] + x, first[1] + y, first[2] + z});
    }
  }
  return cells;
}

// Each cube is the one whose corners have the colours that the hash draws; also far from the
// origin, with a period and with a seed.
TEST(CornerCubesTest, ShowsTheCubeOfTheDrawnCorners) {
  for (int colors : {2, 3}) {
    const std::map<Cell, Corners> places = PlacesOf(colors);
    for (const auto& [first, period, seed] :
         {std::tuple(Cell{-3, -4, -2}, 0, 0), {{100000, -70000, 31}, 0, 7}, {{-2, 3, -5}, 5, 1}}) {
      const std::vector<Cell> cells = Box(first, {6, 6, 6});
      const Space space = Fill(colors, cells, period, seed);
      for (size_t i = 0; i < cells.size(); ++i) {
        const Corners& corners = places.at(space.places[i]);
        for (int k = 0; k < 8; ++k) {
          using reference::Pcg;
          const auto at = [&](size_t axis) {
            return static_cast<uint32_t>(Wrapped(cells[i][axis] + (k >> axis & 1), period));
          };
          const uint32_t bits =
              Pcg(at(0) + Pcg(at(1) + Pcg(at(2) + Pcg(static_cast<uint32_t>(seed)))));
          ASSERT_EQ(corners[static_cast<size_t>(k)],
                    static_cast<int>(bits % static_cast<uint32_t>(colors)));
        }
      }
    }
  }
}

// Of 256 cubes in 32 x 32 x 32 cells each comes as often as in independent draws. The chi-square
// with 255 degrees of freedom is between 187 and 329 in 998 of 1000; neighbours share corners,
// which makes it wider, so both sides are doubled.
TEST(CornerCubesTest, CubesComeEquallyOften) {
  for (int seed : {0, 77}) {
    const Space space = Fill(2, Box({-16, -16, -16}, {32, 32, 32}), 0, seed);
    std::vector<double> counts(256);
    for (int number : space.numbers) counts[static_cast<size_t>(number)] += 1;
    double chi_square = 0;
    for (double count : counts) chi_square += (count - 128) * (count - 128) / 128;
    EXPECT_GT(chi_square, 187.0 / 2) << seed;
    EXPECT_LT(chi_square, 329.0 * 2) << seed;
  }
}

// No row of 2^12 cubes, along any axis, repeats itself or comes again beside itself.
TEST(CornerCubesTest, NothingRepeats) {
  constexpr int kLong = 1 << 12;
  for (size_t axis = 0; axis < 3; ++axis) {
    const auto line = [&](int beside) {
      Cell first = {beside, beside, beside};
      Cell size = {1, 1, 1};
      first[axis] = -kLong / 2;
      size[axis] = kLong;
      return Fill(2, Box(first, size)).numbers;
    };
    const std::vector<int> one = line(0), other = line(1);
    for (int shift = 0; shift <= kLong / 2; ++shift) {
      const bool repeats = shift > 0 && std::equal(one.begin() + shift, one.end(), one.begin());
      ASSERT_FALSE(repeats) << shift;
      ASSERT_FALSE(std::equal(one.begin() + shift, one.end(), other.begin())) << shift;
    }
  }
}

// The mip level is that of the position, not of the place in the pack, which jumps at faces.
TEST(CornerCubesTest, TheLevelIsThatOfThePosition) {
  ir::Texture pack = PackOf(2);
  ir::Texture::Level& base = pack.levels[0];
  base.width = base.height = 16;
  base.depth = 64;
  base.texels.assign(size_t{16} * 16 * 64, {0, 0, 0, 1});
  BuildMipChain(pack);
  for (size_t level = 0; level < pack.levels.size(); ++level) {
    for (auto& texel : pack.levels[level].texels) texel[2] = static_cast<float>(level);
  }
  pack.sampler.mip_filter = ir::MipFilter::kLinear;
  const std::string graph = R"({"texgraph": 1,
    "textures": {"set": {"layers": ["mortar.png"], "pack": "volume"}},
    "nodes": {"at": {"block": "components", "in": {"vector": "uv"}},
              "place": {"block": "combine3", "in": {"x": "at.x", "y": "at.y", "z": 0.3}},
              "t": {"block": "corner_cubes", "in": {"cubes": "set", "colors": 2, "tiling": 4,
                                                    "position": "place"}}},
    "outputs": {"color": "t.color"}})";
  for (double level : {0.0, 1.0, 1.5}) {
    const double pixel = std::exp2(level) / 16;  // 4 cubes of 4 texels for each unit
    std::vector<Point> points;
    for (int i = 0; i < 64; ++i) points.push_back({-1 + 0.03125 * i + 0.001, 0.3 + 0.0411 * i});
    auto outputs = RunGraph(graph, points, {pixel, pixel}, 1e-4, PictureFolder(), {{"set", pack}});
    ASSERT_EQ(outputs["color"].count, points.size());
    for (size_t i = 0; i < points.size(); ++i)
      EXPECT_NEAR(outputs["color"].Float(i, 2), level, 1e-4);
  }
}

}  // namespace
}  // namespace texgraph::blocks
