// SPDX-License-Identifier: Apache-2.0
// The coordinate family: each block against complex numbers, quaternions, or what it must leave as
// it is.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "tests/blocks/run_block.h"

namespace texgraph::blocks {
namespace {

using Complex = std::complex<double>;
using Vec3 = std::array<double, 3>;

constexpr double kTurn = 2 * std::numbers::pi;

// Places all over [-2, 3]^2.
std::vector<Vector> Places(int count) {
  std::vector<Vector> places;
  for (int i = 0; i < count; ++i) {
    places.push_back({5 * std::fmod(0.1234 + 0.7548776662 * i, 1) - 2,
                      5 * std::fmod(0.5678 + 0.5698402910 * i, 1) - 2});
  }
  return places;
}

std::vector<Vector> Places3(int count) {
  std::vector<Vector> places;
  for (const Vector& p : Places(count)) places.push_back({p[0], p[1], 1.7 * p[0] * p[1] - 0.4});
  return places;
}

Complex At(const Values& values, size_t i) { return {values.Float(i, 0), values.Float(i, 1)}; }
Complex At(const std::vector<Vector>& places, size_t i) { return {places[i][0], places[i][1]}; }

void ExpectClose(Complex seen, Complex wanted, double tolerance, const std::string& what) {
  EXPECT_LE(std::abs(seen - wanted), tolerance) << what << ": " << seen << ", wanted " << wanted;
}

// q p q* with q = (cos a/2, sin a/2 axis), all products of quaternions written out.
Vec3 TurnByQuaternion(const Vec3& p, double degrees, Vec3 axis) {
  using Quaternion = std::array<double, 4>;
  auto times = [](const Quaternion& a, const Quaternion& b) {
    return Quaternion{a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
                      a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
                      a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
                      a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
  };
  double length = std::hypot(axis[0], axis[1], axis[2]);
  double half = degrees / 360 * kTurn / 2;
  double s = std::sin(half) / length;
  Quaternion q = {std::cos(half), s * axis[0], s * axis[1], s * axis[2]};
  Quaternion back = {q[0], -q[1], -q[2], -q[3]};
  Quaternion turned = times(times(q, {0, p[0], p[1], p[2]}), back);
  return {turned[1], turned[2], turned[3]};
}

TEST(CoordinatesTest, Rotate2dIsAProductOfComplexNumbers) {
  std::vector<Vector> places = Places(50);
  for (double angle : {0.0, 30.0, -135.0, 400.0}) {
    auto outputs = RunBlock("rotate2d", {{"vector", Vectors(places)},
                                         {"angle", Floats({angle})},
                                         {"pivot", Vectors({{0.3, -0.7}})}});
    ASSERT_EQ(outputs.size(), 1u);
    for (size_t i = 0; i < places.size(); ++i) {
      Complex pivot(0.3, -0.7);
      ExpectClose(At(outputs["result"], i),
                  pivot + (At(places, i) - pivot) * std::polar(1.0, angle / 360 * kTurn), 3e-6,
                  "rotate2d");
    }
  }
}

TEST(CoordinatesTest, Rotate3dIsAProductOfQuaternions) {
  std::vector<Vector> places = Places3(40);
  const Vec3 axis = {0.5, -2, 1};
  for (double angle : {0.0, 47.0, 180.0, -250.0}) {
    auto outputs = RunBlock("rotate3d", {{"vector", Vectors(places)},
                                         {"angle", Floats({angle})},
                                         {"axis", Vectors({{axis[0], axis[1], axis[2]}})},
                                         {"pivot", Vectors({{1, 2, 3}})}});
    ASSERT_EQ(outputs.size(), 1u);
    for (size_t i = 0; i < places.size(); ++i) {
      const Vector& p = places[i];
      Vec3 wanted = TurnByQuaternion({p[0] - 1, p[1] - 2, p[2] - 3}, angle, axis);
      for (size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(outputs["result"].Float(i, c), wanted[c] + 1.0 + static_cast<double>(c), 2e-5);
      }
    }
  }
}

// What is drawn at a place is seen where the place is taken to by scaling, turning and moving.
TEST(CoordinatesTest, PositionTransformMovesWhatIsDrawn) {
  std::vector<Vector> places = Places3(40);
  const Vec3 axis = {1, 1, -0.5}, scale = {2, 0.5, -1.5}, move = {0.25, -1, 4}, pivot = {1, 2, 3};
  auto outputs =
      RunBlock("position_transform", {{"position", Vectors(places)},
                                      {"translate", Vectors({{move[0], move[1], move[2]}})},
                                      {"angle", Floats({70})},
                                      {"axis", Vectors({{axis[0], axis[1], axis[2]}})},
                                      {"scale", Vectors({{scale[0], scale[1], scale[2]}})},
                                      {"pivot", Vectors({{pivot[0], pivot[1], pivot[2]}})}});
  ASSERT_EQ(outputs.size(), 1u);
  for (size_t i = 0; i < places.size(); ++i) {
    Vec3 drawn;
    for (size_t c = 0; c < 3; ++c) {
      drawn[c] = (outputs["result"].Float(i, c) - pivot[c]) * scale[c];
    }
    Vec3 seen = TurnByQuaternion(drawn, 70, axis);
    for (size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(seen[c] + pivot[c] + move[c], places[i][c], 1e-4);
    }
  }
}

TEST(CoordinatesTest, PolarIsAngleAndDistance) {
  std::vector<Vector> places = Places(60);
  places.push_back({0.4, 0.6});  // the middle
  auto outputs = RunBlock("polar", {{"uv", Vectors(places)},
                                    {"center", Vectors({{0.4, 0.6}})},
                                    {"angle", Floats({50})},
                                    {"radius", Floats({0.25})}});
  ASSERT_EQ(outputs.size(), 1u);
  const Values& polar = outputs["result"];
  for (size_t i = 0; i + 1 < places.size(); ++i) {
    Complex p = At(places, i) - Complex(0.4, 0.6);
    double turns = std::arg(p) / kTurn - 50.0 / 360;
    EXPECT_NEAR(std::remainder(polar.Float(i, 0) - turns, 1), 0, 1e-6);
    EXPECT_GE(polar.Float(i, 0), 0);
    EXPECT_LE(polar.Float(i, 0), 1);
    EXPECT_NEAR(polar.Float(i, 1), std::abs(p) / 0.25, 1e-5);
  }
  EXPECT_TRUE(std::isfinite(polar.Float(places.size() - 1, 0)));
  EXPECT_EQ(polar.Float(places.size() - 1, 1), 0.0f);
  auto back = RunBlock("from_polar", {{"polar", polar},
                                      {"center", Vectors({{0.4, 0.6}})},
                                      {"angle", Floats({50})},
                                      {"radius", Floats({0.25})}});
  ASSERT_EQ(back.size(), 1u);
  for (size_t i = 0; i < places.size(); ++i) {
    ExpectClose(At(back["result"], i), At(places, i), 1e-5, "from_polar");
  }
}

// 20 teeth around the middle, seen where the angle comes round: had the footprint a jump there, a
// whole turn's worth, the teeth would be their mean.
TEST(CoordinatesTest, PolarHasNoSeam) {
  std::vector<Point> points;
  for (double x : {0.7, 0.9, 1.3}) {
    for (double y : {-0.0016, -0.0009, -0.0004, 0.0003}) points.push_back({0.5 + x, 0.5 + y});
  }
  auto outputs = RunGraph(R"({"texgraph": 1, "nodes": {
      "p": {"block": "polar"},
      "c": {"block": "components", "in": {"vector": "p"}},
      "phase": {"block": "multiply", "in": {"a": "c.x", "b": 20}},
      "teeth": {"block": "triangle_wave", "in": {"phase": "phase"}}},
      "outputs": {"height": "teeth"}})",
                          points, {0.001, 0.001});
  ASSERT_EQ(outputs.size(), 1u);
  for (size_t i = 0; i < points.size(); ++i) {
    double turns = std::atan2(points[i].y - 0.5, points[i].x - 0.5) / kTurn;
    double tooth = std::fabs(2 * std::remainder(20 * turns, 1));
    // A pixel is at most 0.007 of a tooth here.
    EXPECT_NEAR(outputs["height"].Float(i), tooth, 0.004) << points[i].x << " " << points[i].y;
    EXPECT_LT(outputs["height"].Float(i), 0.03);
  }
}

TEST(CoordinatesTest, MirrorShowsOneSide) {
  std::vector<Vector> places = {{0.1, 0.9}, {0.6, 0.2}, {-3, 2}, {4, -1}};
  struct Row {
    const char* flip;
    bool above, x, y;
  };
  for (Row row : {Row{"none", false, false, false}, Row{"x", false, true, false},
                  Row{"y", true, false, true}, Row{"both", true, true, true}}) {
    auto outputs = RunBlock("mirror", {{"uv", Vectors(places)},
                                       {"center", Vectors({{0.5, 0.3}})},
                                       {"flip", Word{row.flip}},
                                       {"from_above", Bools({row.above})}});
    ASSERT_EQ(outputs.size(), 1u);
    auto folded = [&](double p, double center, bool folds) {
      bool shown = !folds || (p > center) == row.above;
      return shown ? p : 2 * center - p;
    };
    for (size_t i = 0; i < places.size(); ++i) {
      EXPECT_NEAR(outputs["result"].Float(i, 0), folded(places[i][0], 0.5, row.x), 1e-6);
      EXPECT_NEAR(outputs["result"].Float(i, 1), folded(places[i][1], 0.3, row.y), 1e-6);
    }
  }
}

TEST(CoordinatesTest, RepeatCountsItsCopies) {
  const std::vector<double> values = {-1.3, -0.5, -0.01, 0, 0.2, 0.49, 0.6, 1.3, 7.77};
  for (bool mirrored : {false, true}) {
    auto wanted = [&](double p) {
      double cell = std::floor(p);
      bool turned = mirrored && std::fmod(std::fabs(cell), 2) == 1;
      return turned ? cell + 1 - p : p - cell;
    };
    std::vector<Vector> planes, spaces;
    for (double v : values) {
      planes.push_back({v, 2 - v});
      spaces.push_back({0, 1, v});
    }
    auto line = RunBlock(
        "repeat",
        {{"value", Floats(values)}, {"scale", Floats({3})}, {"mirrored", Bools({mirrored})}});
    auto plane = RunBlock(
        "repeat",
        {{"uv", Vectors(planes)}, {"scale", Vectors({{2, 3}})}, {"mirrored", Bools({mirrored})}});
    auto space = RunBlock("repeat", {{"position", Vectors(spaces)},
                                     {"scale", Vectors({{1, 1, 3}})},
                                     {"mirrored", Bools({mirrored})}});
    ASSERT_EQ(line.size() + plane.size() + space.size(), 3u);
    for (size_t i = 0; i < values.size(); ++i) {
      EXPECT_NEAR(line["result"].Float(i), wanted(3 * values[i]), 4e-6) << values[i];
      EXPECT_NEAR(plane["result"].Float(i, 1), wanted(3 * (2 - values[i])), 4e-6) << values[i];
      EXPECT_NEAR(space["result"].Float(i, 2), wanted(3 * values[i]), 4e-6) << values[i];
    }
  }
}

// The place goes to the one wedge at the same distance from the middle, and all places that are
// mirror images of each other go to the same.
TEST(CoordinatesTest, KaleidoscopeShowsOneHalfWedge) {
  const Complex center(0.5, 0.5);
  const double start = 25.0 / 360 * kTurn;
  std::vector<Vector> places, twins;
  for (const Vector& p : Places(100)) {
    Complex from_middle = Complex(p[0], p[1]) - center;
    double angle = std::arg(from_middle);
    // Mirrored at the beginning of the wedge, then turned by three of five segments.
    Complex twin = center + std::polar(std::abs(from_middle), 2 * start - angle + 3 * kTurn / 5);
    places.push_back(p);
    twins.push_back({twin.real(), twin.imag()});
  }
  auto run = [&](const std::vector<Vector>& uv) {
    return RunBlock(
        "kaleidoscope",
        {{"uv", Vectors(uv)}, {"segments", Ints({5})}, {"angle", Floats({25})}})["result"];
  };
  Values seen = run(places), twin = run(twins);
  ASSERT_EQ(seen.count + twin.count, 200u);
  for (size_t i = 0; i < places.size(); ++i) {
    Complex q = At(seen, i) - center;
    double angle = std::arg(q * std::polar(1.0, -start));
    EXPECT_GE(angle, -1e-5);
    EXPECT_LE(angle, kTurn / 10 + 1e-5);
    EXPECT_NEAR(std::abs(q), std::abs(At(places, i) - center), 1e-5);
    ExpectClose(At(twin, i), At(seen, i), 2e-5, "kaleidoscope");
  }
  Values same = run({{0.5 + std::cos(start + 0.3), 0.5 + std::sin(start + 0.3)}});
  EXPECT_NEAR(same.Float(0, 0), 0.5 + std::cos(start + 0.3), 1e-6);
  EXPECT_NEAR(same.Float(0, 1), 0.5 + std::sin(start + 0.3), 1e-6);
}

TEST(CoordinatesTest, SwirlTurnsLessAndLess) {
  std::vector<Vector> places = Places(80);
  auto outputs = RunBlock("swirl", {{"uv", Vectors(places)},
                                    {"center", Vectors({{0.5, 0.5}})},
                                    {"angle", Floats({90})},
                                    {"radius", Floats({1.5})}});
  ASSERT_EQ(outputs.size(), 1u);
  for (size_t i = 0; i < places.size(); ++i) {
    Complex p = At(places, i) - Complex(0.5, 0.5);
    double t = std::fmax(1 - std::abs(p) / 1.5, 0);
    // What is drawn turns counter-clockwise, so the coordinate turns back.
    double turn = -(3 * std::pow(t, 2) - 2 * std::pow(t, 3)) * kTurn / 4;
    ExpectClose(At(outputs["result"], i), Complex(0.5, 0.5) + p * std::polar(1.0, turn), 5e-6,
                "swirl");
  }
}

}  // namespace
}  // namespace texgraph::blocks
