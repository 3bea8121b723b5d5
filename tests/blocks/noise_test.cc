// SPDX-License-Identifier: Apache-2.0
// Value, gradient and simplex noise in one to four dimensions, against sums over corners in double
// precision.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/blocks/noise_reference.h"
#include "tests/blocks/run_block.h"

namespace texgraph::blocks {
namespace {

using reference::Noise;
using reference::NoiseAt;
using reference::Place;

struct Sampled {
  std::vector<double> values;
  std::vector<Place> gradients;
};

ir::TypeId VectorOf(ir::Scalar scalar, size_t dimensions) {
  return ir::Vector(scalar, static_cast<uint32_t>(dimensions));
}

Values Int(const std::vector<int64_t>& components) {
  Values values{
      components.size() == 1 ? ir::kInt : VectorOf(ir::Scalar::kInt, components.size()), 1, {}};
  for (int64_t component : components) values.words.push_back(static_cast<uint32_t>(component));
  return values;
}

Values Place1To4(const std::vector<Place>& places) {
  if (places[0].size() > 1) return Vectors(places);
  std::vector<double> numbers;
  for (const Place& place : places) numbers.push_back(place[0]);
  return Floats(numbers);
}

// A block at many places. `pixel` is how much the first coordinate changes to the right.
Sampled Sample(const std::string& block, const std::vector<Place>& places, const Place& scale,
               int32_t seed, const std::vector<int64_t>& period = {}, double pixel = 0,
               bool filtered = true) {
  std::vector<Place> quads;
  for (const Place& place : places) {
    for (int lane = 0; lane < 4; ++lane) {
      quads.push_back(place);
      quads.back()[0] += lane % 2 * pixel;
    }
  }
  std::vector<Argument> arguments = {
      {"uv", Place1To4(quads)}, {"scale", Place1To4({scale})}, {"seed", Ints({seed})}};
  if (!filtered) arguments.emplace_back("filtered", Bools({false}));
  if (!period.empty()) arguments.emplace_back("period", Int(period));
  auto outputs = RunBlock(block, arguments);
  Sampled sampled;
  for (size_t i = 0; i < quads.size() && !outputs.empty(); i += 4) {
    sampled.values.push_back(outputs["result"].Float(i));
    Place& gradient = sampled.gradients.emplace_back();
    for (size_t k = 0; k < scale.size(); ++k) gradient.push_back(outputs["gradient"].Float(i, k));
  }
  return sampled;
}

// Places all over a box, both sides of 0, no two alike in any coordinate.
std::vector<Place> Places(size_t dimensions, int count, double side) {
  // Powers of one over the root of x^(d+1) = x + 1: Roberts' sequence.
  double root = 2;
  for (int i = 0; i < 60; ++i) {
    root = std::pow(1 + root, 1.0 / (static_cast<double>(dimensions) + 1));
  }
  std::vector<Place> places;
  for (int i = 0; i < count; ++i) {
    Place& place = places.emplace_back();
    for (size_t k = 1; k <= dimensions; ++k) {
      const double step = std::pow(root, -static_cast<double>(k));
      place.push_back(side * (std::fmod(0.5 + step * i, 1) - 0.5));
    }
  }
  return places;
}

Place InCells(const Place& uv, const Place& scale) {
  Place p = uv;
  for (size_t i = 0; i < p.size(); ++i) p[i] *= scale[i];
  return p;
}

struct Case {
  const char* block;
  Noise noise;
  size_t dimensions;
};

class NoiseTest : public testing::TestWithParam<Case> {
 protected:
  const std::string block_ = GetParam().block;
  const Noise noise_ = GetParam().noise;
  const size_t dimensions_ = GetParam().dimensions;
  Place Scale() const {
    Place scale = {3, -5.5, 4.25, 2};
    scale.resize(dimensions_);
    return scale;
  }
};

TEST_P(NoiseTest, IsTheSumOverTheCorners) {
  const std::vector<Place> places = Places(dimensions_, 500, 7);
  const Sampled seen = Sample(block_, places, Scale(), 42);
  ASSERT_EQ(seen.values.size(), places.size());
  for (size_t i = 0; i < places.size(); ++i) {
    EXPECT_NEAR(seen.values[i], NoiseAt(noise_, InCells(places[i], Scale()), 42), 3e-5) << i;
  }
}

TEST_P(NoiseTest, TheGradientIsTheCentralDifference) {
  constexpr double kStep = 1e-5;
  const std::vector<Place> places = Places(dimensions_, 500, 7);
  const Sampled seen = Sample(block_, places, Scale(), 7);
  ASSERT_EQ(seen.values.size(), places.size());
  for (size_t i = 0; i < places.size(); ++i) {
    for (size_t k = 0; k < dimensions_; ++k) {
      Place before = places[i], after = places[i];
      before[k] -= kStep;
      after[k] += kStep;
      const double slope = (NoiseAt(noise_, InCells(after, Scale()), 7) -
                            NoiseAt(noise_, InCells(before, Scale()), 7)) /
                           (2 * kStep);
      EXPECT_NEAR(seen.gradients[i][k], slope, 5e-4) << i << " " << k;
    }
  }
}

TEST_P(NoiseTest, HasItsRangeMeanAndVariance) {
  const Place one(dimensions_, 1);
  const std::vector<Place> places = Places(dimensions_, 60000, 400);
  const Sampled seen = Sample(block_, places, one, 3);
  ASSERT_EQ(seen.values.size(), places.size());
  double sum = 0, squares = 0, wanted = 0;
  for (size_t i = 0; i < places.size(); ++i) {
    ASSERT_GE(seen.values[i], 0);
    ASSERT_LE(seen.values[i], 1);
    sum += seen.values[i] - 0.5;
    squares += std::pow(seen.values[i] - 0.5, 2);
    wanted += reference::VarianceAt(noise_, places[i]);
  }
  const double count = static_cast<double>(places.size());
  wanted /= count;
  // Four standard deviations of the mean: in one dimension, 400 cells are that many numbers.
  const double independent = dimensions_ == 1 ? 400 : 20000;
  EXPECT_NEAR(sum / count, 0, 4 * std::sqrt(wanted / independent));
  EXPECT_NEAR(squares / count / wanted, 1, dimensions_ == 1 ? 0.25 : 0.04);
  // What the blocks' texts say, of three digits.
  constexpr double kDeviation[3][4] = {
      {0.256, 0.226, 0.200, 0.177}, {0.141, 0.165, 0.120, 0.095}, {0.162, 0.227, 0.138, 0.127}};
  EXPECT_NEAR(std::sqrt(wanted), kDeviation[static_cast<int>(noise_)][dimensions_ - 1], 0.0011);
}

TEST_P(NoiseTest, FadesToItsMeanBetweenHalfACellAndOneAPixel) {
  Place scale(dimensions_, 4);
  const std::vector<Place> places = Places(dimensions_, 100, 7);
  for (auto [pixel, left] : {std::pair{0.5, 1.0}, {0.75, 0.5}, {1.0, 0.0}, {3.0, 0.0}}) {
    for (double side : {1.0, -1.0}) {
      scale[0] = side * 4;
      const Sampled seen = Sample(block_, places, scale, 0, {}, pixel / 4);
      const Sampled near = Sample(block_, places, scale, 0);
      ASSERT_EQ(seen.values.size(), places.size());
      for (size_t i = 0; i < places.size(); ++i) {
        EXPECT_NEAR(seen.values[i] - 0.5, left * (near.values[i] - 0.5), 1e-5);
        for (size_t k = 0; k < dimensions_; ++k) {
          EXPECT_NEAR(seen.gradients[i][k], left * near.gradients[i][k], 1e-4);
        }
      }
    }
  }
}

TEST_P(NoiseTest, StaysWhereItIsNotFiltered) {
  const Place scale(dimensions_, 4);
  const std::vector<Place> places = Places(dimensions_, 100, 7);
  const Sampled seen = Sample(block_, places, scale, 0, {}, 0.25, false);
  const Sampled near = Sample(block_, places, scale, 0);
  ASSERT_EQ(seen.values.size(), places.size());
  for (size_t i = 0; i < places.size(); ++i) {
    EXPECT_NEAR(seen.values[i], near.values[i], 1e-6);
    for (size_t k = 0; k < dimensions_; ++k) {
      EXPECT_NEAR(seen.gradients[i][k], near.gradients[i][k], 1e-5);
    }
  }
}

class PeriodTest : public NoiseTest {};

// To the bit, on both sides of 0 and of the seam.
TEST_P(PeriodTest, RepeatsAfterItsPeriod) {
  const Place one(dimensions_, 1);
  std::vector<int64_t> period = {5, 3, 4, 2};
  period.resize(dimensions_);
  std::vector<Place> places = Places(dimensions_, 200, 12);
  for (Place& place : places) {
    for (double& x : place) x = std::round(x * 64) / 64;
  }
  places.push_back(Place(dimensions_, 0));
  const Sampled here = Sample(block_, places, one, 9, period);
  ASSERT_EQ(here.values.size(), places.size());
  for (size_t k = 0; k < dimensions_; ++k) {
    for (int64_t times : {-3, 1, 2}) {
      std::vector<Place> moved = places;
      for (Place& place : moved) place[k] += static_cast<double>(times * period[k]);
      const Sampled there = Sample(block_, moved, one, 9, period);
      EXPECT_EQ(here.values, there.values) << k;
      EXPECT_EQ(here.gradients, there.gradients) << k;
    }
  }
  for (size_t i = 0; i < places.size(); ++i) {
    EXPECT_NEAR(here.values[i], NoiseAt(noise_, places[i], 9, period), 3e-6) << i;
  }
}

// 0 in one direction is none there.
TEST_P(PeriodTest, APeriodMayBeInOneDirection) {
  const Place one(dimensions_, 1);
  std::vector<int64_t> period(dimensions_, 0);
  period.back() = 3;
  const std::vector<Place> places = Places(dimensions_, 200, 12);
  const Sampled seen = Sample(block_, places, one, 9, period);
  ASSERT_EQ(seen.values.size(), places.size());
  for (size_t i = 0; i < places.size(); ++i) {
    EXPECT_NEAR(seen.values[i], NoiseAt(noise_, places[i], 9, period), 3e-5) << i;
  }
}

std::vector<Case> Cases(bool simplex) {
  std::vector<Case> cases;
  for (size_t n = 1; n <= 4; ++n) {
    cases.push_back({"value_noise", Noise::kValue, n});
    cases.push_back({"gradient_noise", Noise::kGradient, n});
    if (simplex) cases.push_back({"simplex_noise", Noise::kSimplex, n});
  }
  return cases;
}

std::string NameOf(const testing::TestParamInfo<Case>& test) {
  return std::string(test.param.block) + std::to_string(test.param.dimensions);
}

INSTANTIATE_TEST_SUITE_P(All, NoiseTest, testing::ValuesIn(Cases(true)), NameOf);
INSTANTIATE_TEST_SUITE_P(All, PeriodTest, testing::ValuesIn(Cases(false)), NameOf);

// Where coordinates are equal, the order of the corners is still one of the right ones.
TEST(SimplexNoiseTest, OnTheDiagonals) {
  for (size_t n = 2; n <= 4; ++n) {
    std::vector<Place> places;
    for (int i = -40; i < 40; ++i) {
      // Equal in all, then in all but one.
      for (size_t k = 0; k <= n; ++k) {
        Place& place = places.emplace_back(n, i / 16.0);
        if (k < n) place[k] += 0.25;
      }
    }
    const Sampled seen = Sample("simplex_noise", places, Place(n, 1), 1);
    ASSERT_EQ(seen.values.size(), places.size());
    for (size_t i = 0; i < places.size(); ++i) {
      EXPECT_NEAR(seen.values[i], NoiseAt(Noise::kSimplex, places[i], 1), 1e-5) << n << " " << i;
    }
  }
}

TEST(DirectionsTest, AreEvenlySpread) {
  constexpr double kSquare[] = {1 / 3.0, 1 / 6.0, 3 / 4.0};
  const char* const kBlocks[] = {"directions2", "directions3", "directions4"};
  constexpr size_t kCount = 100000;
  Values bits{VectorOf(ir::Scalar::kUint, 4), kCount, {}};
  for (uint32_t i = 0; i < 4 * kCount; ++i) bits.words.push_back(reference::Pcg(i));
  for (size_t n = 2; n <= 4; ++n) {
    auto seen = RunBlock(kBlocks[n - 2], {{"bits", bits}});
    ASSERT_EQ(seen.size(), n);
    const std::string names[] = {"x", "y", "z", "w"};
    double mean[4] = {}, product[4][4] = {};
    for (size_t i = 0; i < kCount; ++i) {
      for (size_t lane = 0; lane < 4; ++lane) {
        const Place slope = reference::SlopeOf(bits.Uint(i, lane), n);
        double around = 0;
        for (size_t k = 0; k < n; ++k) {
          const double component = seen[names[k]].Float(i, lane);
          ASSERT_NEAR(component, slope[k], 1e-6);
          around += std::fabs(component);
          mean[k] += component / (4.0 * kCount);
          for (size_t l = 0; l < n; ++l) {
            product[k][l] += component * seen[names[l]].Float(i, lane) / (4.0 * kCount);
          }
        }
        ASSERT_NEAR(around, n == 4 ? 3 : 1, 1e-6);
      }
    }
    // 400,000 numbers of at most 1: five standard deviations are 0.008.
    for (size_t k = 0; k < n; ++k) {
      EXPECT_NEAR(mean[k], 0, 0.008);
      for (size_t l = 0; l < n; ++l) {
        EXPECT_NEAR(product[k][l], k == l ? kSquare[n - 2] : 0, 0.008) << n << k << l;
      }
    }
  }
}

TEST(LatticeCellsTest, WrapBehindTheLastCell) {
  const std::vector<uint32_t> cells = {0, 3, 4, 5, 0xffffffffu, 0xfffffffbu, 0xfffffffau};
  auto endless = RunBlock("lattice_cells", {{"cell", Uints(cells)}});
  auto five = RunBlock("lattice_cells", {{"cell", Uints(cells)}, {"period", Ints({5})}});
  auto one = RunBlock("lattice_cells", {{"cell", Uints(cells)}, {"period", Ints({1})}});
  const uint32_t wanted[] = {0, 3, 4, 0, 4, 0, 4};
  for (size_t i = 0; i < cells.size(); ++i) {
    EXPECT_EQ(endless["result"].Uint(i, 0), cells[i]);
    EXPECT_EQ(endless["result"].Uint(i, 1), cells[i] + 1);
    EXPECT_EQ(five["result"].Uint(i, 0), wanted[i]);
    EXPECT_EQ(five["result"].Uint(i, 1), (wanted[i] + 1) % 5);
    EXPECT_EQ(one["result"].Uint(i, 0), 0u);
    EXPECT_EQ(one["result"].Uint(i, 1), 0u);
  }
}

}  // namespace
}  // namespace texgraph::blocks
