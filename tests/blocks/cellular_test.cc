// SPDX-License-Identifier: Apache-2.0
// The cellular patterns against brute force in double precision. TEXGRAPH_CELLULAR_SAMPLES sets how
// many places are compared in each test; see docs/testing.md.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>

#include "compiler/base/diagnostics.h"
#include "compiler/base/source.h"
#include "compiler/compile.h"
#include "tests/blocks/cellular_reference.h"
#include "tests/blocks/run_block.h"

namespace texgraph::blocks {
namespace {

using reference::Scattered;

constexpr double kGreatest = std::numeric_limits<double>::infinity();

size_t Samples(size_t fewest) {
  const char* wanted = std::getenv("TEXGRAPH_CELLULAR_SAMPLES");
  return wanted ? std::strtoull(wanted, nullptr, 10) : fewest;
}

// Places from -side to side in each direction, in quads so small that nothing is faded.
std::vector<Vector> Places(size_t count, int dimensions, double side, std::mt19937& random) {
  std::uniform_real_distribution<double> where(-side, side), beside(-0.1, 0.1);
  std::vector<Vector> places;
  Vector corner(static_cast<size_t>(dimensions));
  for (size_t i = 0; i < count; ++i) {
    Vector place = corner;
    for (size_t k = 0; k < place.size(); ++k) {
      if (i % 4 == 0) corner[k] = where(random);
      // As a float, so that the reference sees the very place.
      place[k] = static_cast<float>(corner[k] + (i % 4 == 0 ? 0.0 : beside(random)));
    }
    places.push_back(place);
  }
  return places;
}

struct Case {
  const char* metric;
  double exponent;
  double jitter;
};

void PrintTo(const Case& what, std::ostream* out) {
  *out << what.metric << ", exponent " << what.exponent << ", jitter " << what.jitter;
}

struct Errors {
  size_t f1 = 0, f2 = 0, cell = 0, center = 0, neighbor = 0, border = 0, samples = 0;
};

std::vector<Argument> Arguments(const std::vector<Vector>& places, const Case& what, int32_t seed,
                                bool exact) {
  Vector one(places[0].size(), 1.0);
  double exponent = std::isinf(what.exponent) ? 3 : what.exponent;
  return {{"uv", Vectors(places)},
          {"scale", Vectors({one})},
          {"metric", Word{what.metric}},
          {"exponent", Floats({exponent})},
          {"jitter", Floats({what.jitter})},
          {"exact", Bools({exact})},
          {"seed", Ints({seed})},
          {"time", Floats({0.0})}};
}

constexpr double kRounding = 2e-5;

template <int kDimensions>
void Compare(const Case& what, bool exact, int32_t seed, size_t count, std::mt19937& random,
             Errors& errors) {
  constexpr int kSide = kDimensions == 2 ? 60 : 8;
  const Scattered<kDimensions> points(-kSide - 1, kSide + 1, seed, what.jitter);
  std::vector<Vector> places = Places(count, kDimensions, kSide, random);
  auto seen = RunBlock("voronoi", Arguments(places, what, seed, exact));
  ASSERT_FALSE(seen.empty());
  const bool straight = what.exponent == 2;
  for (size_t i = 0; i < count; ++i) {
    typename Scattered<kDimensions>::Place place;
    std::copy_n(places[i].begin(), kDimensions, place.begin());
    auto truth = points.At(place, what.exponent, straight);
    errors.f1 += !(std::fabs(seen["f1"].Float(i) - truth.f1) < kRounding);
    errors.f2 += !(std::fabs(seen["f2"].Float(i) - truth.f2) < kRounding);
    double border = straight ? truth.border : 0.5 * (truth.f2 - truth.f1);
    errors.border += !(std::fabs(seen["border"].Float(i) - border) < 2 * kRounding);
    if (truth.f2 - truth.f1 < 2 * kRounding) continue;
    for (size_t k = 0; k < kDimensions; ++k) {
      errors.cell += seen["tile"].Int(i, k) != truth.cell[k];
      errors.center += !(std::fabs(seen["center"].Float(i, k) - truth.point[k]) < kRounding);
    }
    if (truth.f3 - truth.f2 < 2 * kRounding) continue;
    for (size_t k = 0; k < kDimensions; ++k) {
      errors.neighbor += seen["neighbor"].Int(i, k) != truth.second_cell[k];
    }
  }
  errors.samples += count;
}

template <int kDimensions>
Errors CompareAll(const Case& what, bool exact, size_t fewest) {
  std::mt19937 random(7);
  Errors errors;
  const size_t wanted = Samples(fewest);
  for (int32_t seed = 0; errors.samples < wanted && !testing::Test::HasFailure(); ++seed) {
    size_t count = std::min<size_t>(wanted - errors.samples, 20000) / 4 * 4 + 4;
    Compare<kDimensions>(what, exact, 1000 * seed + kDimensions, count, random, errors);
  }
  return errors;
}

class ExactVoronoiTest : public testing::TestWithParam<Case> {
 protected:
  template <int kDimensions>
  void ExpectNoErrors(size_t fewest) {
    Errors errors = CompareAll<kDimensions>(GetParam(), true, fewest);
    EXPECT_EQ(errors.f1, 0u) << "of " << errors.samples;
    EXPECT_EQ(errors.f2, 0u) << "of " << errors.samples;
    EXPECT_EQ(errors.cell, 0u) << "of " << errors.samples;
    EXPECT_EQ(errors.center, 0u) << "of " << errors.samples;
    EXPECT_EQ(errors.neighbor, 0u) << "of " << errors.samples;
    EXPECT_EQ(errors.border, 0u) << "of " << errors.samples;
  }
};

// O16.
TEST_P(ExactVoronoiTest, InThePlaneAllIsAsByBruteForce) { ExpectNoErrors<2>(40000); }
TEST_P(ExactVoronoiTest, InSpaceAllIsAsByBruteForce) { ExpectNoErrors<3>(8000); }

INSTANTIATE_TEST_SUITE_P(Metrics, ExactVoronoiTest,
                         testing::Values(Case{"euclidean", 2, 1}, Case{"euclidean", 2, 0.4},
                                         Case{"manhattan", 1, 1}, Case{"chebyshev", kGreatest, 1},
                                         Case{"minkowski", 1.5, 1}, Case{"minkowski", 4, 0.8}));

double Share(size_t errors, size_t samples) {
  return static_cast<double>(errors) / static_cast<double>(samples);
}

TEST(FastVoronoiTest, IsWrongAsOftenAsItsTextSays) {
  Errors plane = CompareAll<2>({"euclidean", 2, 1}, false, 100000);
  EXPECT_NEAR(Share(plane.f1, plane.samples), 0.009, 0.0015);
  EXPECT_NEAR(Share(plane.f2, plane.samples), 0.13, 0.01);
  Errors space = CompareAll<3>({"euclidean", 2, 1}, false, 30000);
  EXPECT_NEAR(Share(space.f1, space.samples), 0.019, 0.004);
  EXPECT_NEAR(Share(space.f2, space.samples), 0.117, 0.012);
}

// O17.
TEST(VoronoiTest, NoDistanceGrowsFasterThanTheWay) {
  // Along lines, in steps of a 200th of a cell.
  for (const char* metric : {"euclidean", "manhattan", "chebyshev"}) {
    std::vector<Vector> places;
    for (int i = 0; i < 40000; ++i) places.push_back({0.005 * (i % 20000), i < 20000 ? 0.3 : 7.77});
    auto seen = RunBlock("voronoi", Arguments(places, {metric, 2, 1}, 3, true));
    ASSERT_FALSE(seen.empty());
    for (size_t i = 1; i < places.size(); ++i) {
      if (i == 20000) continue;
      for (const char* output : {"f1", "f2", "border"}) {
        ASSERT_LE(std::fabs(seen[output].Float(i) - seen[output].Float(i - 1)), 0.005 + 3e-5)
            << output << " " << metric << " " << places[i][0];
      }
    }
  }
}

TEST(VoronoiTest, InSpaceNoDistanceGrowsFasterThanTheWay) {
  // Along a line that meets no edge of cells, in steps of a 100th of a cell.
  std::vector<Vector> places;
  constexpr double kStep = 0.01;
  for (int i = 0; i < 8000; ++i) {
    const double way = kStep * i;
    places.push_back({2.0 / 3 * way, 1.0 / 3 * way + 0.21, 0.4 - 2.0 / 3 * way});
  }
  for (const char* metric : {"euclidean", "chebyshev"}) {
    auto seen = RunBlock("voronoi", Arguments(places, {metric, 2, 1}, 3, true));
    ASSERT_FALSE(seen.empty());
    for (size_t i = 1; i < places.size(); ++i) {
      for (const char* output : {"f1", "f2", "border"}) {
        ASSERT_LE(std::fabs(seen[output].Float(i) - seen[output].Float(i - 1)), kStep + 3e-5)
            << output << " " << metric << " " << i;
      }
    }
  }
}

TEST(VoronoiTest, RepeatsAfterItsPeriod) {
  std::mt19937 random(5);
  for (int32_t period : {1, 3, 5, 64}) {
    std::vector<Vector> places = Places(4000, 2, 12, random), further = places;
    for (Vector& place : further) place = {place[0] - 2.0 * period, place[1] + period};
    auto run = [&](const std::vector<Vector>& at) {
      auto arguments = Arguments(at, {"euclidean", 2, 1}, 9, true);
      arguments.push_back({"period", CellsOf({{period, period}})});
      return RunBlock("voronoi", arguments);
    };
    auto here = run(places), there = run(further);
    ASSERT_FALSE(here.empty() || there.empty());
    for (size_t i = 0; i < places.size(); ++i) {
      for (const char* output : {"f1", "f2", "border"}) {
        ASSERT_NEAR(here[output].Float(i), there[output].Float(i), kRounding) << period;
      }
      if (here["difference"].Float(i) < 2 * kRounding) continue;
      for (size_t k = 0; k < 2; ++k) {
        ASSERT_EQ(here["tile"].Int(i, k), there["tile"].Int(i, k)) << period;
        ASSERT_GE(here["tile"].Int(i, k), 0);
        ASSERT_LT(here["tile"].Int(i, k), period);
      }
    }
  }
}

TEST(VoronoiTest, RepeatsAfterItsPeriodInSpace) {
  std::mt19937 random(5);
  std::vector<Vector> places = Places(4000, 3, 6, random), further = places;
  for (Vector& place : further) place = {place[0] - 6, place[1] + 5, place[2] + 2};
  auto run = [&](const std::vector<Vector>& at) {
    auto arguments = Arguments(at, {"euclidean", 2, 1}, 9, true);
    Values period = CellsOf({{3, 5}});
    period.type = ir::kIvec3;
    period.words.push_back(1);
    arguments.push_back({"period", period});
    return RunBlock("voronoi", arguments);
  };
  auto here = run(places), there = run(further);
  ASSERT_FALSE(here.empty() || there.empty());
  for (size_t i = 0; i < places.size(); ++i) {
    for (const char* output : {"f1", "f2", "border"}) {
      ASSERT_NEAR(here[output].Float(i), there[output].Float(i), kRounding) << i;
    }
  }
}

std::map<std::string, Values> AtTime(const std::vector<Vector>& places, double time, int steps) {
  auto arguments = Arguments(places, {"euclidean", 2, 0.1}, 4, true);
  arguments.back() = {"time", Floats({time})};
  arguments.push_back({"interval", Floats({2})});
  arguments.push_back({"steps", Ints({steps})});
  return RunBlock("voronoi", arguments);
}

TEST(VoronoiTest, PointsMoveWithBoundedSpeedWhereverTheyAre) {
  // With so small a jitter a place keeps its point.
  std::vector<Vector> places;
  for (int i = 0; i < 400; ++i) {
    for (int corner = 0; corner < 4; ++corner) places.push_back({i * i + 0.5, 0.5 - 3.0 * i});
  }
  constexpr double kStep = 0.01;
  double greatest = 0, way = 0;
  auto before = AtTime(places, 100, 0);
  for (int step = 1; step <= 300; ++step) {
    auto after = AtTime(places, 100 + kStep * step, 0);
    ASSERT_FALSE(after.empty());
    for (size_t i = 0; i < places.size(); ++i) {
      // The local coordinate is exact far from the origin, too.
      for (size_t k = 2; k < 4; ++k) {
        double moved = std::fabs(after["tile"].Float(i, k) - before["tile"].Float(i, k));
        greatest = std::max(greatest, moved);
        way += moved;
      }
    }
    before = after;
  }
  // 1.5 / interval cells a second, times the jitter.
  EXPECT_LE(greatest, 1.5 / 2 * kStep * 0.1 + 1e-5);
  // The mean distance of two random numbers is a third; 3 seconds are one and a half intervals.
  EXPECT_NEAR(way / (2.0 * static_cast<double>(places.size())), 1.5 * 0.1 / 3, 0.005);
}

TEST(VoronoiTest, InSpaceOverTimeNoDistanceChangesFasterThanThePoints) {
  std::mt19937 random(8);
  std::vector<Vector> places = Places(1000, 3, 20, random);
  auto at = [&](double time) {
    auto arguments = Arguments(places, {"euclidean", 2, 1}, 4, true);
    arguments.back() = {"time", Floats({time})};
    arguments.push_back({"interval", Floats({4})});
    return RunBlock("voronoi", arguments);
  };
  constexpr double kStep = 0.05;
  auto before = at(-3);
  double change = 0;
  for (int step = 1; step <= 100; ++step) {
    auto after = at(-3 + kStep * step);
    ASSERT_FALSE(after.empty());
    for (size_t i = 0; i < places.size(); ++i) {
      for (const char* output : {"f1", "f2"}) {
        double moved = std::fabs(after[output].Float(i) - before[output].Float(i));
        ASSERT_LE(moved, std::sqrt(3.0) * 1.5 / 4 * kStep + 1e-4) << output;
        change = std::max(change, moved);
      }
    }
    before = after;
  }
  EXPECT_GT(change, 0.25 * 1.5 / 4 * kStep);
}

TEST(VoronoiTest, MovementRepeatsAfterItsSteps) {
  std::mt19937 random(5);
  std::vector<Vector> places = Places(400, 2, 12, random);
  auto first = AtTime(places, 1.7, 3), again = AtTime(places, 1.7 + 4 * 6, 3),
       other = AtTime(places, 1.7 + 2, 3), still = AtTime(places, 1.7 + 6, 0);
  size_t moved = 0, moved_without = 0;
  for (size_t i = 0; i < places.size(); ++i) {
    EXPECT_NEAR(first["f1"].Float(i), again["f1"].Float(i), kRounding);
    moved += std::fabs(first["f1"].Float(i) - other["f1"].Float(i)) > 1e-4;
    moved_without += std::fabs(first["f1"].Float(i) - still["f1"].Float(i)) > 1e-4;
  }
  EXPECT_GT(moved, 350u);
  EXPECT_GT(moved_without, 350u);
}

template <int kDimensions>
void ExpectMeans(const Case& what, double tolerance) {
  std::mt19937 random(11);
  double f1 = 0, f2 = 0;
  constexpr size_t kCount = kDimensions == 2 ? 60000 : 30000;
  constexpr int kSide = kDimensions == 2 ? 60 : 8;
  std::uniform_real_distribution<double> where(-kSide, kSide);
  for (int32_t seed = 0; seed < 3; ++seed) {
    const Scattered<kDimensions> points(-kSide - 1, kSide + 1, seed + 77, what.jitter);
    for (size_t i = 0; i < kCount; ++i) {
      typename Scattered<kDimensions>::Place place;
      for (double& component : place) component = where(random);
      auto found = points.At(place, what.exponent, false);
      f1 += found.f1 / (3.0 * kCount);
      f2 += found.f2 / (3.0 * kCount);
    }
  }
  std::vector<Vector> wide;
  for (int i = 0; i < 4; ++i) {
    Vector place(kDimensions, 0.0);
    place[0] = 3.0 * (i % 2);
    place[1] = 3.0 * (i / 2);
    wide.push_back(place);
  }
  auto seen = RunBlock("voronoi", Arguments(wide, what, 1, true));
  ASSERT_FALSE(seen.empty());
  EXPECT_NEAR(seen["f1"].Float(0), f1, tolerance) << what.metric << " " << what.jitter;
  EXPECT_NEAR(seen["f2"].Float(0), f2, tolerance) << what.metric << " " << what.jitter;
}

TEST(VoronoiMeansTest, WithoutJitterTheyAreTheIntegralsOverASquare) {
  auto mean = [](const char* metric) {
    return RunBlock(
        "voronoi_means",
        {{"dimensions", Ints({2})}, {"metric", Word{metric}}, {"jitter", Floats({0.0})}})["result"];
  };
  EXPECT_NEAR(mean("euclidean").Float(0), (std::sqrt(2.0) + std::asinh(1.0)) / 6, 1e-4);
  EXPECT_NEAR(mean("manhattan").Float(0), 0.5, 1e-4);
  EXPECT_NEAR(mean("manhattan").Float(0, 1), 5.0 / 6, 1e-4);
  EXPECT_NEAR(mean("chebyshev").Float(0), 1.0 / 3, 1e-4);
  EXPECT_NEAR(mean("chebyshev").Float(0, 1), 2.0 / 3, 1e-4);
}

TEST(VoronoiTest, FarAwayItIsItsMean) {
  // Sampling is off by 0.002.
  for (double jitter : {0.0, 0.3, 0.7, 1.0}) {
    for (const Case& what : {Case{"euclidean", 2, jitter}, Case{"manhattan", 1, jitter},
                             Case{"chebyshev", kGreatest, jitter}}) {
      ExpectMeans<2>(what, 0.003);
    }
  }
  ExpectMeans<2>({"minkowski", 3, 1}, 0.006);
  ExpectMeans<3>({"euclidean", 2, 1}, 0.003);
  ExpectMeans<3>({"manhattan", 1, 0.5}, 0.003);
}

// The sum of the block's text, over all points within 1.5 cells.
double SmoothReference(const Vector& place, double smoothness, int32_t seed) {
  double terms = 0;
  for (int y = -3; y <= 3; ++y) {
    for (int x = -3; x <= 3; ++x) {
      std::array<int32_t, 2> cell = {static_cast<int32_t>(std::floor(place[0])) + x,
                                     static_cast<int32_t>(std::floor(place[1])) + y};
      auto point = reference::PointOf<2>(reference::CellBits<2>(cell, seed));
      double d = std::hypot(cell[0] + point[0] - place[0], cell[1] + point[1] - place[1]);
      double rest = std::max(0.0, 1 - d * d / 2.25);
      terms += rest * rest * std::exp2(-d / smoothness);
    }
  }
  return std::max(0.0, -smoothness * std::log2(terms));
}

TEST(SmoothVoronoiTest, IsTheSumOfItsTextAndNearF1WhereItIsSharp) {
  std::mt19937 random(3);
  std::vector<Vector> places = Places(4000, 2, 30, random);
  auto run = [&](double smoothness) {
    return RunBlock("smooth_voronoi", {{"uv", Vectors(places)},
                                       {"scale", Vectors({{1, 1}})},
                                       {"smoothness", Floats({smoothness})},
                                       {"seed", Ints({8})},
                                       {"time", Floats({0.0})}})["result"];
  };
  auto sharp = RunBlock("voronoi", Arguments(places, {"euclidean", 2, 1}, 8, true));
  for (double smoothness : {0.01, 0.1, 0.3}) {
    Values seen = run(smoothness);
    for (size_t i = 0; i < places.size(); ++i) {
      ASSERT_NEAR(seen.Float(i), SmoothReference(places[i], smoothness, 8), 1e-4) << smoothness;
    }
  }
  Values limit = run(0.001);
  for (size_t i = 0; i < places.size(); ++i) {
    ASSERT_NEAR(limit.Float(i), sharp["f1"].Float(i), 0.01);
  }
}

TEST(SmoothVoronoiTest, FarAwayItIsItsMean) {
  std::mt19937 random(6);
  for (double smoothness : {0.05, 0.2, 0.4}) {
    double mean = 0;
    constexpr int kCount = 40000;
    std::uniform_real_distribution<double> where(-1000, 1000);
    for (int i = 0; i < kCount; ++i) {
      mean += SmoothReference({where(random), where(random)}, smoothness, 1) / kCount;
    }
    std::vector<Vector> wide = {{0, 0}, {3, 0}, {0, 3}, {3, 3}};
    auto seen = RunBlock("smooth_voronoi", {{"uv", Vectors(wide)},
                                            {"scale", Vectors({{1, 1}})},
                                            {"smoothness", Floats({smoothness})},
                                            {"time", Floats({0.0})}});
    EXPECT_NEAR(seen["result"].Float(0), mean, 0.006) << smoothness;
    auto known = RunBlock("smooth_voronoi_mean",
                          {{"dimensions", Ints({2})}, {"smoothness", Floats({smoothness})}});
    EXPECT_NEAR(known["result"].Float(0), mean, 0.006) << smoothness;
  }
}

TEST(SmoothVoronoiTest, ItsPointsMoveAsThoseOfVoronoi) {
  std::mt19937 random(4);
  for (int dimensions : {2, 3}) {
    const std::vector<Vector> places = Places(400, dimensions, 20, random);
    double moved = 0;
    std::vector<float> before;
    // 10.3 and 16.3 are the same place of a movement that repeats after three intervals of 2.
    for (double time : {1.7, 2.9, 10.3, 16.3}) {
      auto arguments = Arguments(places, {"euclidean", 2, 1}, 8, true);
      arguments.back() = {"time", Floats({time})};
      arguments.push_back({"interval", Floats({2})});
      arguments.push_back({"steps", Ints({3})});
      const Values sharp = RunBlock("voronoi", arguments)["f1"];
      const Values seen = RunBlock("smooth_voronoi", {{"uv", Vectors(places)},
                                                      {"scale", Vectors({Vector(dimensions, 1.0)})},
                                                      {"smoothness", Floats({0.001})},
                                                      {"seed", Ints({8})},
                                                      {"time", Floats({time})},
                                                      {"interval", Floats({2})},
                                                      {"steps", Ints({3})}})["result"];
      for (size_t i = 0; i < places.size(); ++i) {
        ASSERT_NEAR(seen.Float(i), sharp.Float(i), 0.012) << dimensions << " " << time;
        if (!before.empty()) moved += std::fabs(seen.Float(i) - before[i]);
        if (time == 16.3) {
          ASSERT_NEAR(seen.Float(i), before[i], 1e-4);
        }
      }
      before.clear();
      for (size_t i = 0; i < places.size(); ++i) before.push_back(seen.Float(i));
    }
    EXPECT_GT(moved, 0.05 * 2 * static_cast<double>(places.size()));
  }
}

// Cells of one colour: the reference colours places of a pixel by their nearest point, and takes
// the mean. Only pixels that a third cell does not reach are compared.
TEST(VoronoiTest, BordersBetweenColoursAreAntialiased) {
  const std::string graph = R"({"texgraph": 1, "functions": {"paint": {"inputs": {"tile": "Tile"},
      "nodes": {"n": {"block": "tile_random", "in": {"tile": "tile"}}}, "outputs": {"value": "n"}}},
      "nodes": {
      "cells": {"block": "voronoi", "in": {"scale": 1, "seed": 6, "metric": "METRIC"}},
      "drawn": {"block": "blend_tiles", "in": {"image": "paint", "tile": "cells.tile",
                "neighbor": "cells.neighbor", "share": "cells.share"}},
      "plain": {"block": "tile_random", "in": {"tile": "cells.tile"}}},
      "outputs": {"height": "drawn", "roughness": "plain"}})";
  constexpr double kPixel = 0.02;
  const Scattered<2> points(-1, 31, 6, 1);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> where(1, 29);
  std::vector<Point> places;
  for (int i = 0; i < 20000; ++i) places.push_back({where(random), where(random)});
  for (const Case& what : {Case{"euclidean", 2, 1}, Case{"manhattan", 1, 1}}) {
    std::string text = graph;
    text.replace(text.find("METRIC"), 6, what.metric);
    auto seen = RunGraph(text, places, {kPixel, kPixel}, 2e-3);
    ASSERT_FALSE(seen.empty());
    auto paint = [&](const std::array<int32_t, 2>& cell) {
      return reference::Unit24(reference::Pcg(reference::CellBits<2>(cell, 6)));
    };
    size_t compared = 0;
    double worst = 0, error = 0, flat_error = 0;
    for (size_t i = 0; i < places.size(); ++i) {
      const auto middle = points.At({places[i].x, places[i].y}, what.exponent, false);
      if (middle.f2 - middle.f1 > 1.5 * kPixel || middle.f3 - middle.f2 < 3 * kPixel) continue;
      if (++compared > 400) break;
      // The pixel that the compiler sees is a box across the border, as wide as the footprint of
      // the distance: for a straight border, kPixel whatever its direction.
      const auto second = middle.second_point;
      double across[2] = {second[0] - middle.point[0], second[1] - middle.point[1]};
      const double length = std::hypot(across[0], across[1]);
      double mean = 0;
      constexpr int kSamples = 201;
      if (what.exponent != 2) {
        // The border is along an axis or a diagonal; its normal is that of f2 - f1.
        auto gap = [&](double x, double y) {
          return Scattered<2>::Length({second[0] - x, second[1] - y}, what.exponent) -
                 Scattered<2>::Length({middle.point[0] - x, middle.point[1] - y}, what.exponent);
        };
        across[0] = gap(places[i].x - 1e-5, places[i].y) - gap(places[i].x + 1e-5, places[i].y);
        across[1] = gap(places[i].x, places[i].y - 1e-5) - gap(places[i].x, places[i].y + 1e-5);
      }
      const double norm = what.exponent == 2 ? length : std::hypot(across[0], across[1]);
      bool third = false, bent = norm == 0;
      for (int k = 0; k < kSamples && !bent; ++k) {
        const double t = kPixel * ((k + 0.5) / kSamples - 0.5) / norm;
        const Scattered<2>::Place at = {places[i].x + t * across[0], places[i].y + t * across[1]};
        const auto cell = points.At(at, what.exponent, false).cell;
        third = third || (cell != middle.cell && cell != middle.second_cell);
        // Not where the distance bends within the pixel.
        for (size_t c = 0; c < 2 && what.exponent != 2; ++c) {
          bent = bent || std::fabs(at[c] - middle.point[c]) < 2 * kPixel ||
                 std::fabs(at[c] - second[c]) < 2 * kPixel;
        }
        mean += paint(cell) / kSamples;
      }
      if (third || bent) continue;
      worst = std::max(worst, std::fabs(seen["height"].Float(i) - mean));
      error += std::fabs(seen["height"].Float(i) - mean);
      flat_error += std::fabs(seen["roughness"].Float(i) - mean);
    }
    EXPECT_GT(compared, 300u);
    EXPECT_LT(worst, 0.01) << what.metric;
    // Without the blend, every pixel on a border is jagged.
    EXPECT_LT(20 * error, flat_error) << what.metric;
  }
}

std::string ShaderOf(const std::string& output) {
  std::string text = R"({"texgraph": 1, "nodes": {"cells": {"block": "voronoi"}},
      "outputs": {"height": "cells.)" +
                     output + R"("}})";
  Sources sources;
  Diagnostics diagnostics;
  SourceId source = sources.Add("cells.json", text);
  auto compiled = Compile(source, graph::DocumentFormat::kJson, {}, sources, diagnostics);
  EXPECT_TRUE(compiled.has_value()) << FormatDiagnostics(diagnostics, sources, false);
  return compiled.has_value() ? compiled->glsl : "";
}

TEST(VoronoiTest, WhatIsNotConnectedIsNotInTheShader) {
  struct {
    const char* output;
    bool second, border, struct_tile;
  } const kCases[] = {
      {"f1", false, false, false}, {"f2", true, false, false}, {"border", false, true, false}};
  for (const auto& [output, second, border, struct_tile] : kCases) {
    std::string shader = ShaderOf(output);
    EXPECT_EQ(shader.find("second") != std::string::npos, second) << shader;
    EXPECT_EQ(shader.find("half_way") != std::string::npos, border) << shader;
    EXPECT_EQ(shader.find("Tile") != std::string::npos, struct_tile) << shader;
  }
}

TEST(VoronoiTest, LinesAlongTheBordersHaveTheirShareAtEachSizeOfPixel) {
  const std::string graph = R"({"texgraph": 1, "nodes": {
      "cells": {"block": "voronoi", "in": {"scale": 1, "seed": 2}},
      "lines": {"block": "joint", "in": {"edge": "cells.border", "width": 0.1,
                                         "spacing": "cells.spacing"}}},
      "outputs": {"height": "lines"}})";
  // The truth: places within half the width of a border.
  const Scattered<2> points(-1, 41, 2, 1);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> where(0, 40);
  double share = 0;
  constexpr int kCount = 60000;
  for (int i = 0; i < kCount; ++i) {
    share += (points.At({where(random), where(random)}, 2, true).border < 0.05) / double(kCount);
  }
  for (double pixel : {0.002, 0.05, 0.2}) {
    std::vector<Point> places;
    for (int i = 0; i < 20000; ++i) places.push_back({where(random), where(random)});
    auto seen = RunGraph(graph, places, {pixel, pixel}, 2e-3);
    ASSERT_FALSE(seen.empty());
    double mean = 0;
    for (size_t i = 0; i < places.size(); ++i) mean += seen["height"].Float(i) / 20000;
    EXPECT_NEAR(mean, share, 0.02) << pixel;
  }
}

}  // namespace
}  // namespace texgraph::blocks
