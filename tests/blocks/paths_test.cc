// SPDX-License-Identifier: Apache-2.0
// Shapes from points of the graph, against the same outlines drawn as many short segments: the
// distance from the nearest one, and the winding number as the sum of the angles at which they are
// seen.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "tests/blocks/reference.h"
#include "tests/blocks/run_block.h"
#include "tests/blocks/scattered_points.h"

namespace texgraph::blocks {
namespace {

using std::numbers::pi;

constexpr int kCurveSteps = 600;
// Of the segments' sagittas, of float, and of Newton's method where three nearest points meet.
constexpr double kNear = 4e-5;

using Line = std::vector<Point>;
using Outline = std::vector<Line>;  // closed lines, or open ones

// As they stand in the graph: x, y, and what it is.
struct PathPoint {
  double x, y;
  int kind;
};
using Path = std::vector<PathPoint>;

Point Between(Point a, Point b, double t) {
  return {reference::Mix(a.x, b.x, t), reference::Mix(a.y, b.y, t)};
}

// A letter of fonts, contour by contour, after the format's description: a control point between
// two control points has one on the curve half-way to each.
Outline Flatten(const Path& path, bool open = false) {
  Outline outline;
  for (size_t begin = 0; begin < path.size();) {
    size_t end = begin + 1;
    while (end < path.size() && path[end].kind != 2) ++end;
    // The contour with all points on the curve written out: every other one may be a control point.
    std::vector<PathPoint> full;
    size_t count = end - begin;
    for (size_t i = 0; i <= count - (open ? 1 : 0); ++i) {
      PathPoint p = path[begin + i % count];
      p.kind = p.kind == 1 && i % count > 0;
      if (p.kind && full.back().kind) {
        full.push_back({(p.x + full.back().x) / 2, (p.y + full.back().y) / 2, 0});
      }
      full.push_back(p);
    }
    Line line{{full[0].x, full[0].y}};
    for (size_t i = 1; i < full.size(); ++i) {
      Point p{full[i].x, full[i].y};
      if (full[i].kind == 0) {
        line.push_back(p);
        continue;
      }
      Point a = line.back(), c{full[i + 1].x, full[i + 1].y};
      for (int s = 1; s <= kCurveSteps; ++s) {
        double t = static_cast<double>(s) / kCurveSteps;
        line.push_back(Between(Between(a, p, t), Between(p, c, t), t));
      }
      ++i;
    }
    outline.push_back(std::move(line));
    begin = end;
  }
  return outline;
}

double FromSegment(Point p, Point a, Point b) {
  double ex = b.x - a.x, ey = b.y - a.y, square = ex * ex + ey * ey;
  double t = square > 0 ? ((p.x - a.x) * ex + (p.y - a.y) * ey) / square : 0;
  t = reference::Clamp(t, 0, 1);
  return std::hypot(p.x - a.x - t * ex, p.y - a.y - t * ey);
}

double Distance(const Outline& outline, Point p) {
  double nearest = INFINITY;
  for (const Line& line : outline) {
    for (size_t i = 1; i < line.size(); ++i) {
      nearest = std::fmin(nearest, FromSegment(p, line[i - 1], line[i]));
    }
  }
  return nearest;
}

// How often the outline goes around p, counter-clockwise.
int Winding(const Outline& outline, Point p) {
  double sum = 0;
  for (const Line& line : outline) {
    for (size_t i = 1; i < line.size(); ++i) {
      double ax = line[i - 1].x - p.x, ay = line[i - 1].y - p.y;
      double bx = line[i].x - p.x, by = line[i].y - p.y;
      sum += std::atan2(ax * by - ay * bx, ax * bx + ay * by);
    }
  }
  return static_cast<int>(std::lround(sum / (2 * pi)));
}

double SignedDistance(const Outline& outline, Point p, const std::string& rule) {
  int winding = Winding(outline, p);
  bool inside = rule == "even_odd" ? winding % 2 != 0 : winding != 0;
  return inside ? -Distance(outline, p) : Distance(outline, p);
}

std::string Row(const PathPoint& p) { return fmt::format("[{}, {}, {}]", p.x, p.y, p.kind); }
std::string Row(const Point& p) { return fmt::format("[{}, {}]", p.x, p.y); }

template <class T>
std::string Rows(const std::vector<T>& points) {
  std::string text;
  for (const T& point : points) text += (text.empty() ? "" : ", ") + Row(point);
  return "[" + text + "]";
}

// "shape" is a node of that block, "mask" its inside.
Values RunShape(const std::string& block, const std::string& ports,
                const std::vector<Point>& points, Point pixel = {0.001, 0.001},
                const std::string& more = "", const std::string& output = "shape") {
  std::string text =
      fmt::format(R"({{"texgraph": 1, "nodes": {{{}"shape": {{"block": "{}", "in": {{{}}}}},
          "mask": {{"block": "sdf_fill", "in": {{"shape": "shape"}}}}}},
          "outputs": {{"height": "{}"}}}})",
                  more, block, ports, output);
  auto outputs = RunGraph(text, points, pixel);
  return outputs.empty() ? Floats(std::vector<double>(points.size(), NAN)) : outputs["height"];
}

// At the heights, and at the columns, of corners that are multiples of 1/8.
std::vector<Point> Eighths() {
  std::vector<Point> points;
  for (int y = -1; y <= 9; ++y) {
    for (int x = -2; x <= 18; ++x) points.push_back({x / 16.0, y / 8.0});
  }
  return points;
}

void ExpectSigned(const Values& seen, const std::vector<Point>& points, const Outline& outline,
                  const std::string& rule) {
  for (size_t i = 0; i < points.size(); ++i) {
    double wanted = SignedDistance(outline, points[i], rule);
    // On the outline itself either side will do.
    double got = std::fabs(wanted) < kNear ? std::fabs(seen.Float(i)) : seen.Float(i);
    if (std::fabs(wanted) < kNear) wanted = std::fabs(wanted);
    ASSERT_NEAR(got, wanted, kNear) << rule << " at " << points[i].x << " " << points[i].y;
  }
}

Line Closed(Line corners) {
  corners.push_back(corners[0]);
  return corners;
}

double Eighth(std::mt19937& random) { return static_cast<double>(random() % 9) / 8; }

// --- Polygons ---

// With random corners they cross themselves, and the rules differ. With `non_zero` only the sign is
// promised then.
TEST(PolygonTest, HasTheSignAndTheDistanceOfItsSides) {
  std::mt19937 random(7);
  std::vector<Point> points = ScatteredPoints(150, -0.25, 1.25), eighths = Eighths();
  points.insert(points.end(), eighths.begin(), eighths.end());
  for (int round = 0; round < 12; ++round) {
    Line corners;
    for (int i = 0; i < 3 + round; ++i) corners.push_back({Eighth(random), Eighth(random)});
    std::string ports = "\"points\": " + Rows(corners);
    ExpectSigned(RunShape("sdf_polygon", ports, points), points, {Closed(corners)}, "even_odd");
    ExpectSigned(RunShape("sdf_polygon", ports + ", \"rule\": \"non_zero\"", points), points,
                 {Closed(corners)}, "non_zero");
  }
}

TEST(PolygonTest, DefaultIsAnArrowHead) {
  std::vector<Point> points = ScatteredPoints(200, -0.25, 1.25);
  ExpectSigned(RunShape("sdf_polygon", "", points), points,
               {Closed({{0.1, 0.1}, {0.5, 0.3}, {0.9, 0.1}, {0.5, 0.9}})}, "even_odd");
}

TEST(PolygonTest, TakesAThousandCorners) {
  Line corners;
  for (int i = 0; i < 1024; ++i) {
    double radius = i % 2 == 0 ? 0.45 : 0.35, angle = 2 * pi * i / 1024;
    corners.push_back({0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle)});
  }
  std::vector<Point> points = ScatteredPoints(60, -0.25, 1.25);
  ExpectSigned(RunShape("sdf_polygon", "\"points\": " + Rows(corners), points), points,
               {Closed(corners)}, "even_odd");
}

TEST(PolylineTest, HasTheDistanceOfItsSegments) {
  Line corners{{0.1, 0.2}, {0.4, 0.9}, {0.4, 0.9}, {0.5, 0.1}, {0.9, 0.6}};
  std::vector<Point> points = ScatteredPoints(300, -0.25, 1.25);
  for (double width : {0.0, 0.2}) {
    Values seen = RunShape(
        "sdf_polyline", fmt::format("\"points\": {}, \"width\": {}", Rows(corners), width), points);
    for (size_t i = 0; i < points.size(); ++i) {
      ASSERT_NEAR(seen.Float(i), Distance({corners}, points[i]) - width / 2, kNear);
    }
  }
}

// --- Paths ---

// A bowl with straight and curved parts, and a hole that goes around the same way.
const Path kLetter = {{0.125, 0, 0},    {0.625, 0, 0},   {1, 0, 1},        {1, 0.5, 1},
                      {0.75, 0.5, 0},   {1, 0.75, 1},    {0.75, 1, 1},     {0.125, 1, 0},
                      {0.375, 0.25, 2}, {0.75, 0.25, 1}, {0.375, 0.625, 0}};

TEST(PathTest, HolesAreHoles) {
  std::vector<Point> points = ScatteredPoints(300, -0.25, 1.25), eighths = Eighths();
  points.insert(points.end(), eighths.begin(), eighths.end());
  Outline outline = Flatten(kLetter);
  ASSERT_EQ(outline.size(), 2u);
  std::string ports = "\"points\": " + Rows(kLetter);
  ExpectSigned(RunShape("sdf_path", ports, points), points, outline, "even_odd");
  ExpectSigned(RunShape("sdf_path", ports + ", \"rule\": \"non_zero\"", points), points, outline,
               "non_zero");
  // Around the other way, a contour is a hole for both.
  Path turned(kLetter.begin(), kLetter.begin() + 8);
  turned.insert(turned.end(), {{0.375, 0.625, 2}, {0.75, 0.25, 1}, {0.375, 0.25, 0}});
  ports = "\"points\": " + Rows(turned) + ", \"rule\": \"non_zero\"";
  ExpectSigned(RunShape("sdf_path", ports, points), points, outline, "even_odd");
}

// Contours of all kinds of points, on a coarse lattice: control points next to each other and at
// the ends, curves that are straight, go there and back or turn at the height of a point.
TEST(PathTest, AnyContoursHaveTheirSignAndDistance) {
  std::mt19937 random(11);
  std::vector<Point> points = ScatteredPoints(80, -0.25, 1.25), eighths = Eighths();
  points.insert(points.end(), eighths.begin(), eighths.end());
  for (int round = 0; round < 24; ++round) {
    Path path;
    for (int i = 0; i < 4 + round; ++i) {
      int kind = random() % 5 == 0 ? 2 : random() % 2 == 0;
      path.push_back({Eighth(random), Eighth(random), kind});
    }
    std::string ports = "\"points\": " + Rows(path);
    ExpectSigned(RunShape("sdf_path", ports, points), points, Flatten(path), "even_odd");
    ExpectSigned(RunShape("sdf_path", ports + ", \"rule\": \"non_zero\"", points), points,
                 Flatten(path), "non_zero");
  }
}

TEST(PathTest, OpenContoursEndWhereTheyEnd) {
  Path path = {{0.1, 0.1, 0}, {0.5, 0.9, 1}, {0.9, 0.1, 1}, {0.9, 0.9, 0},
               {0.2, 0.8, 2}, {0.4, 0.9, 0}, {0.7, 0.7, 1}, {0.3, 0.6, 0}};
  std::vector<Point> points = ScatteredPoints(300, -0.25, 1.25);
  Values seen = RunShape("sdf_path", "\"points\": " + Rows(path) + ", \"rule\": \"open\"", points);
  for (size_t i = 0; i < points.size(); ++i) {
    ASSERT_NEAR(seen.Float(i), Distance(Flatten(path, true), points[i]), kNear) << i;
  }
}

TEST(PathTest, DefaultIsARoundShapeWithAHole) {
  Path path = {{0.1, 0.5, 0}, {0.1, 0.9, 1}, {0.9, 0.9, 1}, {0.9, 0.5, 0}, {0.9, 0.1, 1},
               {0.1, 0.1, 1}, {0.4, 0.4, 2}, {0.6, 0.4, 0}, {0.5, 0.7, 0}};
  std::vector<Point> points = ScatteredPoints(300, -0.25, 1.25);
  ExpectSigned(RunShape("sdf_path", "", points), points, Flatten(path), "even_odd");
}

// --- Edges ---

// The mask of a straight edge is 1/2 - distance / width, where the width is the footprint of the
// distance: the pixel's, seen through the coordinate. Its slope comes from differences of the
// reference.
void ExpectEdges(const std::string& block, const std::string& rows, const Outline& outline,
                 double stretch) {
  const double pixel = 0.02, step = 1e-4;
  std::vector<Point> points = ScatteredPoints(2000, -0.25, 1.25), places;
  for (Point p : points) places.push_back({p.x * stretch, p.y});
  std::string more = fmt::format(
      R"("place": {{"block": "multiply", "in": {{"a": "uv", "b": [{}, 1]}}}}, )", stretch);
  Values seen = RunShape(block, "\"uv\": \"place\", \"points\": " + rows, points, {pixel, pixel},
                         more, "mask");
  int edges = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    Point p = places[i];
    auto at = [&](double dx, double dy) {
      return SignedDistance(outline, {p.x + dx, p.y + dy}, "even_odd");
    };
    double gx = (at(step, 0) - at(-step, 0)) / (2 * step);
    double gy = (at(0, step) - at(0, -step)) / (2 * step);
    if (std::fabs(std::hypot(gx, gy) - 1) > 1e-3) continue;  // two sides are equally near
    double width = pixel * std::hypot(stretch * gx, gy);
    double wanted = reference::Clamp(0.5 - at(0, 0) / width, 0, 1);
    ASSERT_NEAR(seen.Float(i), wanted, 0.01) << block << " at " << p.x << " " << p.y;
    edges += wanted > 0 && wanted < 1;
  }
  EXPECT_GT(edges, 20) << block;
}

TEST(PathTest, EdgesAreAsWideAsThePixel) {
  Line corners{{0.125, 0.125}, {0.5, 0.25}, {0.875, 0.125}, {0.5, 0.875}};
  for (double stretch : {1.0, 0.6}) {
    ExpectEdges("sdf_polygon", Rows(corners), {Closed(corners)}, stretch);
    ExpectEdges("sdf_path", Rows(kLetter), Flatten(kLetter), stretch);
  }
}

// The mean over the plane is the area, which Green's theorem gives.
TEST(PathTest, FillHasTheArea) {
  double area = 0;
  for (const Line& line : Flatten(kLetter)) {
    double twice = 0;
    for (size_t i = 1; i < line.size(); ++i) {
      twice += line[i - 1].x * line[i].y - line[i].x * line[i - 1].y;
    }
    area += (area == 0 ? 1 : -1) * std::fabs(twice) / 2;
  }
  const int side = 100;
  const double pixel = 1.5 / side;
  std::vector<Point> points;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      points.push_back({-0.25 + (x + 0.5) * pixel, -0.25 + (y + 0.5) * pixel});
    }
  }
  Values seen =
      RunShape("sdf_path", "\"points\": " + Rows(kLetter), points, {pixel, pixel}, "", "mask");
  double sum = 0;
  for (size_t i = 0; i < points.size(); ++i) sum += seen.Float(i);
  EXPECT_NEAR(sum * pixel * pixel, area, 3e-4);
}

}  // namespace
}  // namespace texgraph::blocks
