// SPDX-License-Identifier: Apache-2.0
// Shapes as signed distances, against outlines drawn as fine polygons: the distance from the
// nearest side, and the sign by counting the sides that a ray crosses.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "tests/blocks/reference.h"
#include "tests/blocks/run_block.h"
#include "tests/blocks/scattered_points.h"

namespace texgraph::blocks {
namespace {

using std::numbers::pi;

using Line = std::vector<Point>;  // of points, joined by segments

constexpr int kArcSteps = 1000;
constexpr double kNear = 1e-5;  // of the outline's sagittas and of float

double FromSegment(Point p, Point a, Point b) {
  double ex = b.x - a.x, ey = b.y - a.y, square = ex * ex + ey * ey;
  double t = square > 0 ? ((p.x - a.x) * ex + (p.y - a.y) * ey) / square : 0;
  t = reference::Clamp(t, 0, 1);
  return std::hypot(p.x - a.x - t * ex, p.y - a.y - t * ey);
}

double FromLine(const Line& line, Point p) {
  double nearest = INFINITY;
  for (size_t i = 1; i < line.size(); ++i) {
    nearest = std::fmin(nearest, FromSegment(p, line[i - 1], line[i]));
  }
  return nearest;
}

// Closed: the last point is joined with the first.
double SignedDistance(Line outline, Point p) {
  outline.push_back(outline.front());
  bool inside = false;
  for (size_t i = 1; i < outline.size(); ++i) {
    Point a = outline[i - 1], b = outline[i];
    if ((a.y > p.y) != (b.y > p.y)) {
      inside ^= p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x);
    }
  }
  double distance = FromLine(outline, p);
  return inside ? -distance : distance;
}

void AddArc(Line& line, Point center, double radius, double from, double to) {
  for (int i = 0; i <= kArcSteps; ++i) {
    double angle = reference::Mix(from, to, static_cast<double>(i) / kArcSteps) * pi / 180;
    line.push_back({center.x + radius * std::cos(angle), center.y + radius * std::sin(angle)});
  }
}

Line Arc(Point center, double radius, double from, double to) {
  Line line;
  AddArc(line, center, radius, from, to);
  return line;
}

Vector Pair(Point p) { return {p.x, p.y}; }
Values Spot(double x, double y) { return Vectors({{x, y}}); }

Values RunShape(const std::string& block, std::vector<Argument> arguments,
                const std::vector<Point>& points) {
  std::vector<Vector> places;
  for (const Point& point : points) {
    places.push_back(Pair(point));
  }
  arguments.emplace_back("uv", Vectors(places));
  auto outputs = RunBlock(block, arguments);
  return outputs.empty() ? Floats(std::vector<double>(points.size(), NAN)) : outputs["result"];
}

void ExpectDistances(const std::string& block, const std::vector<Argument>& arguments,
                     const std::function<double(Point)>& wanted, double tolerance = kNear) {
  std::vector<Point> points = ScatteredPoints(400, -0.5, 1.5);
  Values seen = RunShape(block, arguments, points);
  for (size_t i = 0; i < points.size(); ++i) {
    ASSERT_NEAR(seen.Float(i), wanted(points[i]), tolerance)
        << block << " " << points[i].x << " " << points[i].y;
  }
}

void ExpectOutline(const std::string& block, const std::vector<Argument>& arguments,
                   const Line& outline) {
  ExpectDistances(block, arguments, [&](Point p) { return SignedDistance(outline, p); });
}

TEST(ShapeTest, Ellipse) {
  for (Point size : {Point{0.9, 0.5}, {0.3, 1.2}, {0.6, 0.6}, {1.4, 0.07}}) {
    Line outline;
    for (int i = 0; i < 8000; ++i) {
      double angle = 2 * pi * i / 8000;
      outline.push_back({0.55 + size.x / 2 * std::cos(angle), 0.45 + size.y / 2 * std::sin(angle)});
    }
    ExpectOutline("sdf_ellipse", {{"center", Spot(0.55, 0.45)}, {"size", Spot(size.x, size.y)}},
                  outline);
  }
}

// On the axes two points of the outline may be equally near, and at the centre of a circle all.
TEST(ShapeTest, EllipseOnItsAxes) {
  auto seen = RunShape("sdf_ellipse", {{"center", Spot(0, 0)}, {"size", Spot(2, 1)}},
                       {{0, 0}, {0, 2}, {3, 0}, {0.9, 0}, {0, -0.25}});
  const double kWanted[] = {-0.5, 1.5, 2, -0.1, -0.25};
  for (size_t i = 0; i < 5; ++i) EXPECT_NEAR(seen.Float(i), kWanted[i], 1e-5) << i;
  auto round =
      RunShape("sdf_ellipse", {{"center", Spot(0, 0)}, {"size", Spot(2, 2)}}, {{0, 0}, {0, 0.5}});
  EXPECT_NEAR(round.Float(0), -1, 1e-5);
  EXPECT_NEAR(round.Float(1), -0.5, 1e-5);
}

// The disc's arc outside of the cut, and the cut's arc inside of the disc.
TEST(ShapeTest, Moon) {
  const Point center{0.5, 0.45};
  for (Point cut : {Point{0.2, 0.1}, {-0.05, 0.3}, {0.02, -0.1}}) {
    const double radius = 0.4, cut_radius = 0.33;
    Line outline;
    double apart = std::hypot(cut.x, cut.y), toward = std::atan2(cut.y, cut.x) * 180 / pi;
    auto half_angle = [&](double own, double other) {
      double foot = (apart * apart + own * own - other * other) / (2 * apart);
      return std::acos(foot / own) * 180 / pi;
    };
    double outer = half_angle(radius, cut_radius), inner = half_angle(cut_radius, radius);
    AddArc(outline, center, radius, toward + outer, toward + 360 - outer);
    AddArc(outline, {center.x + cut.x, center.y + cut.y}, cut_radius, toward + 180 + inner,
           toward + 180 - inner);
    ExpectOutline("sdf_moon",
                  {{"center", Spot(center.x, center.y)},
                   {"radius", Floats({radius})},
                   {"cut", Spot(cut.x, cut.y)},
                   {"cut_radius", Floats({cut_radius})}},
                  outline);
  }
}

// What the cut does not reach is a disc, and what it has all of a ring of another middle.
TEST(ShapeTest, MoonWithoutTips) {
  auto far = RunShape("sdf_moon",
                      {{"center", Spot(0, 0)},
                       {"radius", Floats({0.4})},
                       {"cut", Spot(3, 0)},
                       {"cut_radius", Floats({0.2})}},
                      {{1, 0}, {0, 0.3}, {0.41, 0}});
  const double kFar[] = {0.6, -0.1, 0.01};
  auto inside = RunShape("sdf_moon",
                         {{"center", Spot(0, 0)},
                          {"radius", Floats({1})},
                          {"cut", Spot(0.1, 0)},
                          {"cut_radius", Floats({0.2})}},
                         {{0.1, 0.1}, {0.9, 0}, {-0.3, 0}, {2, 0}});
  const double kInside[] = {0.1, -0.1, -0.2, 1};
  for (size_t i = 0; i < 3; ++i) EXPECT_NEAR(far.Float(i), kFar[i], 1e-6) << i;
  for (size_t i = 0; i < 4; ++i) EXPECT_NEAR(inside.Float(i), kInside[i], 1e-6) << i;
}

TEST(ShapeTest, Circle) {
  ExpectOutline("sdf_circle", {{"center", Spot(0.4, 0.7)}, {"radius", Floats({0.3})}},
                Arc({0.4, 0.7}, 0.3, 0, 360));
}

TEST(ShapeTest, Ring) {
  for (double width : {0.0, 0.1, 0.5, 0.8}) {
    Line outer = Arc({0.4, 0.6}, 0.3 + width / 2, 0, 360);
    Line inner = Arc({0.4, 0.6}, std::fmax(0.3 - width / 2, 0), 0, 360);
    ExpectDistances(
        "sdf_ring",
        {{"center", Spot(0.4, 0.6)}, {"radius", Floats({0.3})}, {"width", Floats({width})}},
        [&](Point p) {
          double from_outer = SignedDistance(outer, p);
          return width < 0.6 ? std::fmax(from_outer, -SignedDistance(inner, p)) : from_outer;
        });
  }
}

Line RoundedRectangle(Point center, Point size, const std::vector<double>& radii) {
  Line outline;
  for (int i = 0; i < 4; ++i) {  // counter-clockwise from the lower left
    double x = i == 0 || i == 3 ? -1 : 1, y = i < 2 ? -1 : 1, r = radii[i];
    Point middle = {center.x + x * (size.x / 2 - r), center.y + y * (size.y / 2 - r)};
    AddArc(outline, middle, r, 180 + 90 * i, 270 + 90 * i);
  }
  return outline;
}

TEST(ShapeTest, RoundedRectangle) {
  auto check = [](const std::vector<double>& given, const std::vector<double>& radii) {
    ExpectOutline("sdf_rounded_rectangle",
                  {{"center", Spot(0.45, 0.6)},
                   {"size", Spot(0.9, 0.5)},
                   {"corner_radius", Vectors({given})}},
                  RoundedRectangle({0.45, 0.6}, {0.9, 0.5}, radii));
  };
  check({0, 0, 0, 0}, {0, 0, 0, 0});
  check({0.1, 0.1, 0.1, 0.1}, {0.1, 0.1, 0.1, 0.1});
  check({0.25, 0.05, 0.15, 0}, {0.25, 0.05, 0.15, 0});
  check({9, 0.2, -1, 0.25}, {0.25, 0.2, 0, 0.25});  // limited
}

TEST(ShapeTest, RegularPolygon) {
  for (int sides : {3, 4, 5, 8, 17}) {
    for (double rounding : {0.0, 0.06}) {
      double angle = 11.5 * sides, radius = 0.35;
      double inner = radius - rounding / std::cos(pi / sides);
      Line outline;
      for (int i = 0; i < sides; ++i) {
        double corner = 90 + angle + 360.0 * i / sides, half = 180.0 / sides;
        Point middle = {0.55 + inner * std::cos(corner * pi / 180),
                        0.45 + inner * std::sin(corner * pi / 180)};
        AddArc(outline, middle, rounding, corner - half, corner + half);
      }
      ExpectOutline("sdf_regular_polygon",
                    {{"center", Spot(0.55, 0.45)},
                     {"radius", Floats({radius})},
                     {"sides", Ints({sides})},
                     {"angle", Floats({angle})},
                     {"rounding", Floats({rounding})}},
                    outline);
    }
  }
  // As round as can be, it is the circle within.
  ExpectOutline("sdf_regular_polygon",
                {{"radius", Floats({0.4})}, {"sides", Ints({3})}, {"rounding", Floats({9})}},
                Arc({0.5, 0.5}, 0.2, 0, 360));
}

TEST(ShapeTest, Star) {
  for (int points : {2, 3, 5, 12}) {
    for (double inner : {0.0, 0.1, 0.3, 0.6}) {  // the last one beyond the points
      Line outline;
      for (int i = 0; i < 2 * points; ++i) {
        double angle = (90 + 20 + 180.0 * i / points) * pi / 180, radius = i % 2 == 0 ? 0.4 : inner;
        outline.push_back({0.5 + radius * std::cos(angle), 0.6 + radius * std::sin(angle)});
      }
      ExpectOutline("sdf_star",
                    {{"center", Spot(0.5, 0.6)},
                     {"radius", Floats({0.4})},
                     {"inner_radius", Floats({inner})},
                     {"points", Ints({points})},
                     {"angle", Floats({20})}},
                    outline);
    }
  }
}

// The outline of a stroke with round ends along a part of a circle, or a straight one.
TEST(ShapeTest, Line) {
  double angle = std::atan2(0.5, 0.3) * 180 / pi;
  Line outline;
  AddArc(outline, {0.6, 0.8}, 0.1, angle - 90, angle + 90);
  AddArc(outline, {0.3, 0.3}, 0.1, angle + 90, angle + 270);
  std::vector<Argument> arguments = {
      {"a", Spot(0.3, 0.3)}, {"b", Spot(0.6, 0.8)}, {"width", Floats({0.2})}};
  ExpectOutline("sdf_line", arguments, outline);
  arguments[1].values = arguments[0].values;  // a dot
  ExpectOutline("sdf_line", arguments, Arc({0.3, 0.3}, 0.1, 0, 360));
}

TEST(ShapeTest, Arc) {
  for (double sweep : {0.0, 40.0, 180.0, 200.0, 330.0}) {
    double start = 100, end = start + sweep, a = start * pi / 180, b = end * pi / 180;
    Point center = {0.4, 0.5};
    Line outline = Arc(center, 0.35, start, end);
    AddArc(outline, {0.4 + 0.3 * std::cos(b), 0.5 + 0.3 * std::sin(b)}, 0.05, end, end + 180);
    AddArc(outline, center, 0.25, end, start);
    AddArc(outline, {0.4 + 0.3 * std::cos(a), 0.5 + 0.3 * std::sin(a)}, 0.05, start + 180,
           start + 360);
    ExpectOutline("sdf_arc",
                  {{"center", Spot(0.4, 0.5)},
                   {"radius", Floats({0.3})},
                   {"width", Floats({0.1})},
                   {"start", Floats({start})},
                   {"sweep", Floats({sweep})}},
                  outline);
  }
}

TEST(ShapeTest, AnArcAllTheWayRoundIsARing) {
  Line circle = Arc({0.5, 0.5}, 0.3, 0, 360);
  ExpectDistances("sdf_arc",
                  {{"radius", Floats({0.3})}, {"width", Floats({0.1})}, {"sweep", Floats({360})}},
                  [&](Point p) { return FromLine(circle, p) - 0.05; });
}

TEST(ShapeTest, TriangleInEitherOrder) {
  const Point a = {0.1, 0.2}, b = {0.9, 0.3}, c = {0.3, 0.9};
  for (Line corners : {Line{a, b, c}, Line{a, c, b}, Line{c, b, a}}) {
    ExpectOutline("sdf_triangle",
                  {{"a", Spot(corners[0].x, corners[0].y)},
                   {"b", Spot(corners[1].x, corners[1].y)},
                   {"c", Spot(corners[2].x, corners[2].y)}},
                  corners);
  }
}

TEST(ShapeTest, TriangleWithoutAnInside) {
  for (Point c : {Point{0.5, 0.5}, Point{0.25, 0.25}, Point{1, 1}}) {
    Line line = {{0.25, 0.25}, {0.5, 0.5}, c};
    ExpectDistances("sdf_triangle",
                    {{"a", Spot(0.25, 0.25)}, {"b", Spot(0.5, 0.5)}, {"c", Spot(c.x, c.y)}},
                    [&](Point p) { return FromLine(line, p); });
  }
}

Line Quadratic(const Line& controls) {
  constexpr int kSteps = 4000;
  Line line;
  for (int i = 0; i <= kSteps; ++i) {
    double t = static_cast<double>(i) / kSteps, u = 1 - t;
    line.push_back({u * u * controls[0].x + 2 * u * t * controls[1].x + t * t * controls[2].x,
                    u * u * controls[0].y + 2 * u * t * controls[1].y + t * t * controls[2].y});
  }
  return line;
}

TEST(ShapeTest, QuadraticCurve) {
  const Point a = {0.2, 0.3}, c = {0.8, 0.4}, middle = {0.5, 0.35};
  std::vector<Line> curves = {{a, {0.5, 1.2}, c},
                              {a, {1.6, 0.5}, c},
                              {a, {0.55, -0.4}, c},
                              {a, middle, c},
                              {a, a, c},
                              {a, c, c},
                              {a, {0.7, 0.8}, a},
                              {a, a, a},
                              {a, {1.4, 0.5}, c},
                              {a, {-1, 0.1}, c},
                              {a, {0.31, 0.32}, c},
                              {{0.5, 0.2}, {0.5, 1}, {0.5, 0.3}}};
  for (double off : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7}) {
    curves.push_back({a, {middle.x, middle.y + off}, c});
    curves.push_back({a, {middle.x + off, middle.y}, c});
    curves.push_back({a, {a.x - off, a.y + off}, a});
  }
  for (const Line& curve : curves) {
    Line line = Quadratic(curve);
    SCOPED_TRACE(testing::Message() << curve[1].x << " " << curve[1].y);
    ExpectDistances("sdf_quadratic_curve",
                    {{"a", Spot(curve[0].x, curve[0].y)},
                     {"b", Spot(curve[1].x, curve[1].y)},
                     {"c", Spot(curve[2].x, curve[2].y)},
                     {"width", Floats({0.1})}},
                    [&](Point p) { return FromLine(line, p) - 0.05; });
  }
}

// Where the nearest point is a double or threefold root, which Newton's method comes to slowly.
TEST(ShapeTest, QuadraticCurveAtCentresOfCurvature) {
  for (const Line& curve : {Line{{0.2, 0.3}, {0.5, 1.2}, {0.8, 0.4}},
                            Line{{-0.662, -0.579}, {1.965, 1.455}, {-0.557, -0.697}},
                            Line{{0.109, 1.892}, {0.6, -0.5}, {0.2, 0.5}},
                            Line{{0.422, 1.819}, {-0.262, -0.529}, {0.384, 1.834}}}) {
    double bend_x = 2 * (curve[0].x - 2 * curve[1].x + curve[2].x);
    double bend_y = 2 * (curve[0].y - 2 * curve[1].y + curve[2].y);
    std::vector<Point> points;
    for (int i = 0; i <= 500; ++i) {
      double t = i / 500.0, u = 1 - t;
      double x = 2 * (curve[1].x - curve[0].x) + t * bend_x;
      double y = 2 * (curve[1].y - curve[0].y) + t * bend_y;
      double radii = (x * x + y * y) / (x * bend_y - y * bend_x);
      points.push_back(
          {u * u * curve[0].x + 2 * u * t * curve[1].x + t * t * curve[2].x - radii * y,
           u * u * curve[0].y + 2 * u * t * curve[1].y + t * t * curve[2].y + radii * x});
    }
    Values seen = RunShape("sdf_quadratic_curve",
                           {{"a", Spot(curve[0].x, curve[0].y)},
                            {"b", Spot(curve[1].x, curve[1].y)},
                            {"c", Spot(curve[2].x, curve[2].y)},
                            {"width", Floats({0})}},
                           points);
    Line line = Quadratic(curve);
    for (size_t i = 0; i < points.size(); ++i) {
      double size = std::fmax(1, std::hypot(points[i].x, points[i].y));
      EXPECT_NEAR(seen.Float(i), FromLine(line, points[i]), 5e-5 * size)
          << points[i].x << " " << points[i].y;
    }
  }
}

// What the second shape of a test takes away from the first, or adds: 0.3 and 0.25 wide circles.
struct Circles {
  Values a, b;   // distances at the points
  Line both[2];  // the outlines
  std::vector<Point> points = ScatteredPoints(400, -0.5, 1.5);

  Circles() {
    both[0] = Arc({0.4, 0.5}, 0.3, 0, 360);
    both[1] = Arc({0.7, 0.6}, 0.25, 0, 360);
    a = RunShape("sdf_circle", {{"center", Spot(0.4, 0.5)}, {"radius", Floats({0.3})}}, points);
    b = RunShape("sdf_circle", {{"center", Spot(0.7, 0.6)}, {"radius", Floats({0.25})}}, points);
  }

  // How far a point is from the nearest place where being in both shapes, as `inside` combines it,
  // changes across one of the outlines.
  double FromBorder(Point p, const std::function<bool(bool, bool)>& inside) const {
    double nearest = INFINITY;
    for (int which : {0, 1}) {
      const Point center = which == 0 ? Point{0.7, 0.6} : Point{0.4, 0.5};
      for (const Point& q : both[which]) {
        bool in = std::hypot(q.x - center.x, q.y - center.y) < (which == 0 ? 0.25 : 0.3);
        bool one = which == 0 ? inside(true, in) : inside(in, true);
        bool other = which == 0 ? inside(false, in) : inside(in, false);
        nearest = one == other ? nearest : std::fmin(nearest, std::hypot(p.x - q.x, p.y - q.y));
      }
    }
    return nearest;
  }
};

// The sign says what is inside; where `exact` the value is the distance, elsewhere no more than it.
void ExpectCombination(const std::string& block, const std::function<bool(bool, bool)>& inside,
                       bool exact_inside) {
  Circles circles;
  auto outputs = RunBlock(block, {{"a", circles.a}, {"b", circles.b}});
  ASSERT_EQ(outputs.size(), 1u);
  for (size_t i = 0; i < circles.points.size(); ++i) {
    double seen = outputs["result"].Float(i);
    bool in = inside(circles.a.Float(i) < 0, circles.b.Float(i) < 0);
    EXPECT_EQ(seen < 0, in) << block << " " << i;
    double wanted = circles.FromBorder(circles.points[i], inside);
    EXPECT_LE(std::fabs(seen), wanted + kNear) << block << " " << i;
    if (in == exact_inside) {
      EXPECT_NEAR(std::fabs(seen), wanted, 1e-3) << block << " " << i;
    }
  }
}

TEST(ShapeCombinationTest, AreOfTheRightSignAndAtMostTheDistance) {
  ExpectCombination(
      "sdf_union", [](bool a, bool b) { return a || b; }, false);
  ExpectCombination(
      "sdf_intersection", [](bool a, bool b) { return a && b; }, true);
  ExpectCombination(
      "sdf_difference", [](bool a, bool b) { return a && !b; }, true);
}

TEST(ShapeCombinationTest, SmoothUnionFollowsItsFormula) {
  Circles circles;
  for (double k : {0.0, 0.05, 0.3}) {
    auto outputs =
        RunBlock("sdf_smooth_union", {{"a", circles.a}, {"b", circles.b}, {"k", Floats({k})}});
    ASSERT_EQ(outputs.size(), 1u);
    for (size_t i = 0; i < circles.points.size(); ++i) {
      double a = circles.a.Float(i), b = circles.b.Float(i);
      // The same polynomial in the distance from where the two are equal.
      double near = std::fmax(k - std::fabs(a - b), 0);
      double wanted = std::fmin(a, b) - (k > 0 ? near * near / (4 * k) : 0);
      EXPECT_NEAR(outputs["result"].Float(i), wanted, 1e-6) << k;
    }
  }
}

// Both are unions of what is outside.
TEST(ShapeCombinationTest, SmoothIntersectionAndDifferenceFollowTheirFormula) {
  Circles circles;
  for (double k : {0.0, 0.05, 0.3}) {
    for (const char* block : {"sdf_smooth_intersection", "sdf_smooth_difference"}) {
      auto outputs = RunBlock(block, {{"a", circles.a}, {"b", circles.b}, {"k", Floats({k})}});
      ASSERT_EQ(outputs.size(), 1u);
      double sign = block == std::string("sdf_smooth_difference") ? -1 : 1;
      for (size_t i = 0; i < circles.points.size(); ++i) {
        double a = circles.a.Float(i), b = sign * circles.b.Float(i);
        double near = std::fmax(k - std::fabs(a - b), 0);
        double wanted = std::fmax(a, b) + (k > 0 ? near * near / (4 * k) : 0);
        EXPECT_NEAR(outputs["result"].Float(i), wanted, 1e-6) << block << " " << k;
      }
    }
  }
}

TEST(ShapeCombinationTest, RoundAndOutline) {
  Values shape = Floats({-0.5, -0.1, 0, 0.1, 0.5});
  auto grown = RunBlock("sdf_round", {{"shape", shape}, {"radius", Floats({0.2})}});
  auto band = RunBlock("sdf_outline", {{"shape", shape}, {"width", Floats({0.4})}});
  const double kGrown[] = {-0.7, -0.3, -0.2, -0.1, 0.3}, kBand[] = {0.3, -0.1, -0.2, -0.1, 0.3};
  for (size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(grown["result"].Float(i), kGrown[i], 1e-6);
    EXPECT_NEAR(band["result"].Float(i), kBand[i], 1e-6);
  }
}

// Nodes that make `shape`, and what to look at.
std::map<std::string, Values> RunNodes(const std::string& nodes, const std::string& output,
                                       const std::vector<Point>& points, Point pixel) {
  std::string text =
      R"({"texgraph": 1, "nodes": {)" + nodes + R"(}, "outputs": {"height": ")" + output + R"("}})";
  return RunGraph(text, points, pixel);
}

// The compiler's footprint of a node's value where a pixel is as wide as the coordinate's unit: the
// length of the slope. It comes out of a threshold that is a quarter below the value, and cannot
// tell what is below 1/2.
std::vector<double> Slopes(const std::string& node, const std::vector<Point>& points) {
  auto outputs =
      RunNodes(R"("shape": )" + node + R"(, "below": {"block": "subtract", "in": {"a": "shape",
          "b": 0.25}}, "share": {"block": "threshold", "in": {"value": "shape", "edge": "below"}})",
               "share", points, {1, 1});
  std::vector<double> slopes;
  for (size_t i = 0; i < points.size(); ++i) {
    slopes.push_back(outputs.empty() ? NAN : 0.25 / (outputs["height"].Float(i) - 0.5));
  }
  return slopes;
}

// One of each shape, at its singular points: the middle, corners, ends, axes, the outline.
struct ShapeNode {
  std::string node;
  std::vector<Point> ridges;    // a slope of 1 is expected here as well
  std::vector<Point> singular;  // any slope that is no more than 1
};

std::vector<ShapeNode> ShapeNodes() {
  const Point m = {0.5, 0.5};
  return {
      {R"({"block": "sdf_circle"})", {{0.875, 0.5}}, {m}},
      {R"({"block": "sdf_ring", "in": {"radius": 0.25}})", {{0.75, 0.5}, {0.5, 0.25}}, {m}},
      {R"({"block": "sdf_rounded_rectangle",
            "in": {"size": [0.75, 0.25], "corner_radius": 0.0625}})",
       {{0.5, 0.5}, {0.625, 0.5}, {0.5, 0.625}, {0.875, 0.5}},
       {{0.8125, 0.5625}, {0.875, 0.625}}},
      {R"({"block": "sdf_rounded_rectangle", "in": {"size": [0.25, 0.75], "corner_radius": 0}})",
       {{0.5, 0.5}, {0.5, 0.625}},
       {{0.625, 0.875}, {0.375, 0.875}}},
      {R"({"block": "sdf_regular_polygon", "in": {"sides": 5}})", {m, {0.5, 0.25}}, {{0.5, 0.9}}},
      {R"({"block": "sdf_regular_polygon", "in": {"sides": 4, "rounding": 0.125}})", {m}, {}},
      {R"({"block": "sdf_star"})", {m, {0.5, 0.75}}, {{0.5, 0.9}}},
      {R"({"block": "sdf_line", "in": {"a": [0.25, 0.5], "b": [0.75, 0.5], "width": 0.125}})",
       {{0.375, 0.5}, {0.5, 0.5}, {0.5, 0.5625}},
       {{0.25, 0.5}, {0.75, 0.5}}},
      {R"({"block": "sdf_line", "in": {"a": 0.5, "b": 0.5}})", {{0.75, 0.5}}, {m}},
      {R"({"block": "sdf_arc", "in": {"radius": 0.25, "start": 0, "sweep": 180}})",
       {{0.5, 0.75}},
       {m, {0.75, 0.5}, {0.25, 0.5}}},
      {R"({"block": "sdf_triangle",
            "in": {"a": [0.25, 0.25], "b": [0.75, 0.25], "c": [0.25, 0.75]}})",
       {{0.5, 0.25}, {0.25, 0.5}, {0.375, 0.375}},
       {{0.25, 0.25}, {0.75, 0.25}, {0.25, 0.75}}},
      {R"({"block": "sdf_triangle", "in": {"a": 0.5, "b": 0.5, "c": 0.5}})", {{0.75, 0.5}}, {m}},
      {R"({"block": "sdf_quadratic_curve"})", {}, {{0.15, 0.2}, {0.85, 0.2}, {0.5, 0.7}}},
      {R"({"block": "sdf_quadratic_curve", "in": {"a": 0.5, "b": 0.5, "c": 0.5}})", {}, {m}},
  };
}

TEST(ShapeSlopeTest, IsOneNearlyEverywhere) {
  for (const ShapeNode& shape : ShapeNodes()) {
    std::vector<Point> points = ScatteredPoints(300, -0.5, 1.5);
    points.insert(points.end(), shape.ridges.begin(), shape.ridges.end());
    std::vector<double> slopes = Slopes(shape.node, points);
    for (size_t i = 0; i < points.size(); ++i) {
      EXPECT_NEAR(slopes[i], 1, 2e-3) << shape.node << " " << points[i].x << " " << points[i].y;
    }
  }
}

TEST(ShapeSlopeTest, IsFiniteAtSingularPoints) {
  for (const ShapeNode& shape : ShapeNodes()) {
    if (shape.singular.empty()) continue;
    std::vector<double> slopes = Slopes(shape.node, shape.singular);
    for (size_t i = 0; i < slopes.size(); ++i) {
      EXPECT_LE(slopes[i], 1.002) << shape.node << " " << shape.singular[i].x;
    }
    auto filled = RunNodes(R"("shape": )" + shape.node +
                               R"(, "fill": {"block": "sdf_fill", "in": {"shape": "shape"}})",
                           "fill", shape.singular, {0.01, 0.01});
    for (size_t i = 0; i < slopes.size(); ++i) {
      EXPECT_GE(filled["height"].Float(i), 0) << shape.node;
      EXPECT_LE(filled["height"].Float(i), 1) << shape.node;
    }
  }
}

TEST(ShapeSlopeTest, OfCombinationsIsAtMostOne) {
  const std::string circles =
      R"("a": {"block": "sdf_circle", "in": {"center": [0.375, 0.5], "radius": 0.25}},
         "b": {"block": "sdf_circle", "in": {"center": [0.625, 0.5], "radius": 0.25}}, )";
  for (const char* block :
       {"sdf_union", "sdf_intersection", "sdf_difference", "sdf_smooth_union"}) {
    std::vector<Point> points = ScatteredPoints(200, -0.5, 1.5);
    points.insert(points.end(), {{0.375, 0.5}, {0.5, 0.5}, {0.5, 0.9}});
    auto outputs = RunNodes(circles + R"("shape": {"block": ")" + block +
                                R"(", "in": {"a": "a", "b": "b"}},
            "below": {"block": "subtract", "in": {"a": "shape", "b": 0.25}},
            "share": {"block": "threshold", "in": {"value": "shape", "edge": "below"}})",
                            "share", points, {1, 1});
    ASSERT_EQ(outputs.size(), 1u);
    for (size_t i = 0; i < points.size(); ++i) {
      EXPECT_GE(outputs["height"].Float(i), 0.7495) << block << " " << i;
    }
  }
}

// The integral of a mask over the square from -1 to 2, at points that are much closer than pixels.
double Area(const std::string& nodes, double pixel) {
  constexpr int kSide = 300;
  std::vector<Point> points;
  for (int i = 0; i < kSide * kSide; ++i) {
    points.push_back({-1 + (i % kSide + 0.5) * 3 / kSide, -1 + (i / kSide + 0.5) * 3 / kSide});
  }
  auto outputs = RunNodes(nodes, "mask", points, {pixel, pixel});
  double sum = 0;
  for (size_t i = 0; !outputs.empty() && i < points.size(); ++i) {
    sum += outputs["height"].Float(i);
  }
  return sum * 9 / (kSide * kSide);
}

// Too much by Steiner's formula: what a band of the pixel's width adds around a convex shape, in
// the mean over the band.
TEST(ShapeMaskTest, FillHasTheAreaAndAQuarterOfAPixel) {
  const std::string fill = R"(, "mask": {"block": "sdf_fill", "in": {"shape": "shape"}})";
  for (double pixel : {0.2, 0.1, 0.05}) {
    EXPECT_NEAR(Area(R"("shape": {"block": "sdf_circle", "in": {"radius": 0.37}})" + fill, pixel),
                pi * 0.37 * 0.37 + pi / 12 * pixel * pixel, 3e-4);
    EXPECT_NEAR(Area(R"("shape": {"block": "sdf_rounded_rectangle",
                      "in": {"size": [0.73, 0.51], "corner_radius": 0.21}})" +
                         fill,
                     pixel),
                0.73 * 0.51 - (4 - pi) * 0.21 * 0.21 + pi / 12 * pixel * pixel, 3e-4);
  }
}

// The share of [at - pixel / 2, at + pixel / 2] that lies between low and high.
double Share(double at, double pixel, double low, double high) {
  return std::fmax(0, std::fmin(at + pixel / 2, high) - std::fmax(at - pixel / 2, low)) / pixel;
}

const char* const kAcross = R"("xy": {"block": "components", "in": {"vector": "uv"}}, )";

TEST(ShapeMaskTest, FillIsTheShareOfTheHalfPlane) {
  for (double pixel : {0.001, 0.1, 3.0}) {
    std::vector<Point> points = ScatteredPoints(100, -0.5, 1.5);
    auto outputs =
        RunNodes(std::string(kAcross) + R"("mask": {"block": "sdf_fill", "in": {"shape": "xy.x"}})",
                 "mask", points, {pixel, pixel});
    auto soft =
        RunNodes(std::string(kAcross) +
                     R"("mask": {"block": "sdf_fill", "in": {"shape": "xy.x", "softness": 0.5}})",
                 "mask", points, {pixel, pixel});
    for (size_t i = 0; i < points.size(); ++i) {
      EXPECT_NEAR(outputs["height"].Float(i), Share(points[i].x, pixel, -99, 0), 2e-3);
      EXPECT_NEAR(soft["height"].Float(i), Share(points[i].x, pixel + 0.5, -99, 0), 2e-3);
    }
  }
}

// A stripe as wide as the stroke, at every size of pixel; a hairline across many pixels.
TEST(ShapeMaskTest, StripesHaveTheirShareAtEverySizeOfPixel) {
  const std::string line = R"("shape": {"block": "sdf_line",
      "in": {"a": [0.5, -9], "b": [0.5, 9], "width": 0.0625}}, )";
  for (double pixel : {0.001, 0.03, 0.1, 0.7, 3.0}) {
    std::vector<Point> points = ScatteredPoints(100, -0.5, 1.5);
    points.insert(points.end(), {{0.5, 0.3}, {0.53125, 0.3}});
    auto fill = RunNodes(line + R"("mask": {"block": "sdf_fill", "in":
        {"shape": "shape", "thickness": 0.0625}})",
                         "mask", points, {pixel, pixel});
    auto stroke = RunNodes(std::string(kAcross) + R"("mask": {"block": "sdf_stroke",
        "in": {"shape": "xy.x", "width": 0.02, "offset": 0.3}})",
                           "mask", points, {pixel, pixel});
    for (size_t i = 0; i < points.size(); ++i) {
      double x = points[i].x;
      EXPECT_NEAR(fill["height"].Float(i), Share(x, pixel, 0.46875, 0.53125), 3e-3) << pixel;
      EXPECT_NEAR(stroke["height"].Float(i), Share(x, pixel, 0.29, 0.31), 3e-3) << pixel;
    }
  }
}

TEST(ShapeMaskTest, AStrokeHasTheAreaOfItsBand) {
  const std::string nodes = R"("shape": {"block": "sdf_circle", "in": {"radius": 0.4}},
      "mask": {"block": "sdf_stroke", "in": {"shape": "shape", "width": 0.01}})";
  for (double pixel : {0.2, 0.1, 0.05}) {
    EXPECT_NEAR(Area(nodes, pixel), 2 * pi * 0.4 * 0.01, 2e-4) << pixel;
  }
}

// At a function port a shape is computed at the layer's places: one star in each tile.
TEST(ShapeMaskTest, StandsAtTheImageOfALayer) {
  auto outputs = RunGraph(R"({"texgraph": 1, "nodes": {
      "grid": {"block": "brick_grid", "in": {"rows": 4, "columns": 4, "row_offset": 0}},
      "ring": {"block": "sdf_ring", "in": {"radius": 0.3, "width": 0.2}},
      "fill": {"block": "sdf_fill", "in": {"shape": "ring"}},
      "paint": {"block": "rgba", "in": {"color": [1, 0.5, 0.25], "alpha": "fill"}},
      "rings": {"block": "layer", "in": {"tile": "grid", "image": "paint"}}},
      "outputs": {"color": "rings.color"}})",
                          ScatteredPoints(300, -0.5, 1.5), {0.0001, 0.0001});
  ASSERT_EQ(outputs.size(), 1u);
  std::vector<Point> points = ScatteredPoints(300, -0.5, 1.5);
  for (size_t i = 0; i < points.size(); ++i) {
    double x = 4 * points[i].x, y = 4 * points[i].y;
    double from = std::hypot(x - std::floor(x) - 0.5, y - std::floor(y) - 0.5) - 0.3;
    if (std::fabs(std::fabs(from) - 0.1) > 0.002) {
      EXPECT_NEAR(outputs["color"].Float(i, 3), std::fabs(from) < 0.1 ? 1 : 0, 1e-3);
    }
  }
}

}  // namespace
}  // namespace texgraph::blocks
