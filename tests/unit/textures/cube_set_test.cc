// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/cube_set.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "compiler/textures/cube_parts.h"
#include "tests/unit/textures/cube_testing.h"

namespace texgraph::textures {
namespace {

using test::CubeTexel;
using test::ForBox;
using test::GrainSlices;
using test::SmallCubes;
using test::SolidAt;

std::optional<CubeSet> Make(const std::vector<Image>& slices, const CubeSetOptions& options) {
  Diagnostics diagnostics;
  auto set = MakeCubeSet(slices, options, "granite", {}, diagnostics);
  EXPECT_TRUE(set);
  return set;
}

template <class Work>
void ForEachCube(const CubePackLayout& layout, const Work& work) {
  for (uint32_t i = 0; i < layout.cubes(); ++i) {
    const CubePlace place{i % layout.side, i / layout.side % layout.side,
                          i / layout.side / layout.side};
    work(place, CubeAt(layout, place.x, place.y, place.z));
  }
}

// Around a corner, as far as no other patch reaches, all cubes show the sample around its patch's.
TEST(CubeSetTest, CornersShowTheirPatch) {
  for (uint8_t bits : {uint8_t{8}, uint8_t{16}}) {
    const std::vector<Image> slices = GrainSlices(16, 2, bits, 1);
    CubeSetOptions options = SmallCubes(2, 8);
    options.wraps = bits == 8;
    const auto set = Make(slices, options);
    ASSERT_TRUE(set);
    ASSERT_EQ(set->corners.size(), 2u);
    EXPECT_NE(set->corners[0], set->corners[1]);
    ForEachCube(set->layout, [&](CubePlace cube, const CubeColors& colors) {
      for (uint32_t corner = 0; corner < 8; ++corner) {
        std::array<int64_t, 3> first;
        for (size_t axis = 0; axis < 3; ++axis) first[axis] = corner >> axis & 1 ? 6 : 0;
        ForBox(first, {first[0] + 2, first[1] + 2, first[2] + 2}, [&](std::array<int64_t, 3> at) {
          std::array<int64_t, 3> from = set->corners[colors[corner]];
          for (size_t axis = 0; axis < 3; ++axis)
            from[axis] += at[axis] - (corner >> axis & 1 ? 8 : 0);
          for (uint32_t c = 0; c < 2; ++c)
            ASSERT_EQ(CubeTexel(*set, cube, at, c), SolidAt(slices, from, c));
        });
      }
    });
  }
}

// So in any tiling the texels on both sides of a face, an edge and a corner are those that a filter
// finds in the pack: what lies there depends on the colours there alone.
TEST(CubeSetTest, CubesWithAFaceInCommonAgreeAtIt) {
  for (uint32_t size : {5u, 16u}) {
    const uint32_t depth = size < 8 ? 1 : size / 8;
    const auto set = Make(GrainSlices(24, 1, 8, 2), SmallCubes(2, size));
    ASSERT_TRUE(set);
    using Face = std::array<uint32_t, 5>;  // axis and four colours
    std::map<Face, std::vector<uint32_t>> faces;
    uint32_t compared = 0;
    ForEachCube(set->layout, [&](CubePlace cube, const CubeColors& colors) {
      for (uint32_t axis = 0; axis < 3; ++axis) {
        for (const bool far : {false, true}) {
          Face face{axis};
          size_t count = 1;
          for (uint32_t corner = 0; corner < 8; ++corner) {
            if ((corner >> axis & 1) == (far ? 1 : 0)) face[count++] = colors[corner];
          }
          // Both sides of it, as the pack has them.
          std::array<int64_t, 3> first{};
          std::array<int64_t, 3> end{size, size, size};
          first[axis] = (far ? int64_t{size} : 0) - depth;
          end[axis] = first[axis] + 2 * depth;
          std::vector<uint32_t> texels;
          ForBox(first, end, [&](std::array<int64_t, 3> at) {
            texels.push_back(CubeTexel(*set, cube, at, 0));
          });
          const auto [known, is_new] = faces.emplace(face, texels);
          if (is_new) continue;
          ASSERT_EQ(known->second, texels) << "size " << size << ", axis " << axis;
          ++compared;
        }
      }
    });
    EXPECT_EQ(faces.size(), 48u);
    EXPECT_EQ(compared, 256u * 6 - 48);
  }
}

// Where seams move by little at the finest scale the cubes agree as well.
TEST(CubeSetTest, LargeCubesAgreeAtFaces) {
  const std::vector<Image> slices = GrainSlices(24, 1, 8, 3);
  const CubeSample sample(slices, true, 1);
  constexpr int32_t kSize = 32;
  const CubeParts parts({sample, 0, kSize, {{3, 5, 20}, {20, 14, 10}}}, 1);
  const CubePart cube = parts.Cube({0, 1, 1, 0, 0, 0, 1, 0});
  uint32_t labels = 0;
  ForBox({0, 0, 0}, {kSize, kSize, kSize}, [&](std::array<int64_t, 3> place) {
    const std::array<int32_t, 3> at = {static_cast<int32_t>(place[0]),
                                       static_cast<int32_t>(place[1]),
                                       static_cast<int32_t>(place[2])};
    const uint8_t label = cube.At(at);
    labels |= 1u << label;
    for (size_t axis = 0; axis < 3; ++axis) {
      // Patches reach three quarters of a cube.
      const int32_t from = label >> axis & 1 ? kSize - 1 - at[axis] : at[axis];
      ASSERT_LT(from, kSize * 3 / 4);
    }
  });
  EXPECT_EQ(labels, 0xFFu);
  // With the same colours at the right, and at the top.
  const CubePart beside = parts.Cube({1, 1, 0, 0, 1, 0, 1, 0});
  const CubePart above = parts.Cube({1, 0, 1, 0, 1, 1, 1, 0});
  ForBox({kSize - 4, 0, 0}, {kSize, kSize, kSize}, [&](std::array<int64_t, 3> place) {
    const auto x = static_cast<int32_t>(place[0]);
    const auto y = static_cast<int32_t>(place[1]);
    const auto z = static_cast<int32_t>(place[2]);
    ASSERT_EQ(cube.At({x, y, z}), beside.At({x, y, z}));
    ASSERT_EQ(cube.At({y, x, z}), above.At({y, x, z}));
  });
  EXPECT_NE(cube.labels, beside.labels);
  EXPECT_NE(cube.labels, above.labels);
}

// Joined at planes in the middle instead: the mean over both orders of all pairs of patches.
double PlaneSeams(const std::vector<Image>& slices, const CubeSet& set) {
  const CubeSample sample(slices, true, 1);
  const int64_t size = set.layout.cube_size;
  double sum = 0;
  uint32_t count = 0;
  for (uint32_t pair = 0; pair < 12; ++pair) {
    const uint32_t axis = pair / 4;
    const VoxelPlace& from = set.corners[pair % 2];
    const VoxelPlace& to = set.corners[pair / 2 % 2];
    std::array<int64_t, 3> first = {-size / 2, -size / 2, -size / 2};
    std::array<int64_t, 3> end = {size / 2, size / 2, size / 2};
    first[axis] = size / 2;
    end[axis] = size / 2 + 1;
    ForBox(first, end, [&](std::array<int64_t, 3> at) {
      VoxelPlace a = from;
      VoxelPlace b = to;
      for (size_t i = 0; i < 3; ++i) {
        a[i] += at[i] - (i == axis ? 1 : 0);
        b[i] += at[i] - (i == axis ? size : 0);
      }
      sum += sample.Difference(0, a, b) / sample.MeanStep(axis);
      ++count;
    });
  }
  return sum / count;
}

// Pebbles in sand: a surface that goes around nearly all of them exists, and is found.
TEST(CubeSetTest, SeamsGoAroundThings) {
  constexpr uint32_t kSide = 24;
  std::mt19937 random(8);
  std::vector<std::vector<uint32_t>> samples(kSide, std::vector<uint32_t>(kSide * kSide, 90));
  for (int pebble = 0; pebble < 90; ++pebble) {
    const uint32_t at[3] = {static_cast<uint32_t>(random() % kSide),
                            static_cast<uint32_t>(random() % kSide),
                            static_cast<uint32_t>(random() % kSide)};
    for (uint32_t i = 0; i < 8; ++i) {
      samples[(at[2] + (i >> 2)) % kSide]
             [(at[1] + (i >> 1 & 1)) % kSide * kSide + (at[0] + (i & 1)) % kSide] = 200;
    }
  }
  std::vector<Image> slices;
  for (const auto& slice : samples) slices.push_back(test::MakeImage(kSide, kSide, 1, 8, slice));
  const auto set = Make(slices, SmallCubes(2, 12));
  ASSERT_TRUE(set);
  EXPECT_LT(set->seams, 0.25 * PlaneSeams(slices, *set));
}

TEST(CubeSetTest, TheSameSetWithAnyNumberOfThreads) {
  const std::vector<Image> slices = GrainSlices(16, 3, 8, 5);
  CubeSetOptions options = SmallCubes(2, 4);
  const auto one = Make(slices, options);
  options.threads = 3;
  const auto three = Make(slices, options);
  options.seed = 6;
  const auto other = Make(slices, options);
  ASSERT_TRUE(one && three && other);
  EXPECT_EQ(one->pack.pixels, three->pack.pixels);
  EXPECT_EQ(one->corners, three->corners);
  EXPECT_NE(one->pack.pixels, other->pack.pixels);
}

TEST(CubeSetTest, ThreeColoursMakeAllCubes) {
  const auto set = Make(GrainSlices(12, 1, 8, 6), SmallCubes(3, 4));
  ASSERT_TRUE(set);
  EXPECT_EQ(set->corners.size(), 3u);
  EXPECT_EQ(set->pack.width, 36u);
  EXPECT_EQ(set->pack.height, 36u * 324);
}

std::string ErrorOf(const std::vector<Image>& slices, const CubeSetOptions& options) {
  Diagnostics diagnostics;
  EXPECT_FALSE(MakeCubeSet(slices, options, "granite", {}, diagnostics));
  EXPECT_EQ(diagnostics.all().size(), 1u);
  return diagnostics.all().empty() ? "" : diagnostics.all()[0].message;
}

TEST(CubeSetTest, WhatCannotBeDoneIsSaid) {
  const std::vector<Image> slices = GrainSlices(16, 1, 8, 7);
  EXPECT_EQ(ErrorOf(slices, SmallCubes(4, 8)),
            "the cubes of 'granite' have 4 corner colours; 2 to 3 are possible");
  EXPECT_EQ(ErrorOf(slices, SmallCubes(2, 65)),
            "the cubes of 'granite' have 65 texels a side; with 2 colours 4 to 64 are possible");
  // 21^3 * 6561 texels are below 2^26, 22^3 * 6561 are not.
  EXPECT_EQ(ErrorOf(slices, SmallCubes(3, 22)),
            "the cubes of 'granite' have 22 texels a side; with 3 colours 4 to 21 are possible");
  EXPECT_EQ(ErrorOf(slices, SmallCubes(2, 12)),
            "the sample of 'granite' has 16 x 16 pixels in 16 slices; cubes of 12 texels take at "
            "least 18 each way; cubes of 10 texels would do");
  CubeSetOptions options = SmallCubes(2, 9);
  options.wraps = false;
  EXPECT_EQ(ErrorOf(slices, options),
            "the sample of 'granite' has 16 x 16 pixels in 16 slices; cubes of 9 texels take at "
            "least 18 each way; cubes of 8 texels would do");
  options = SmallCubes(2, 8);
  options.candidates = 7;
  EXPECT_EQ(ErrorOf(slices, options),
            "the cubes of 'granite' try 7 patches; 8 to 256 are possible");
  EXPECT_EQ(ErrorOf({}, SmallCubes(2, 8)), "the cubes of 'granite' have no sample");
  std::vector<Image> mixed = slices;
  mixed[3] = test::RandomImage(16, 16, 3, 8, 1);
  EXPECT_EQ(ErrorOf(mixed, SmallCubes(2, 8)),
            "the slices of 'granite' differ: 1 channels of 8 bits and 3 of 8");
}

}  // namespace
}  // namespace texgraph::textures
