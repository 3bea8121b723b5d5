// SPDX-License-Identifier: Apache-2.0
// Sets of tiles that are drawn tile by tile: garden paths for Wang tiles, packed as they should be
// and as they should not, and red dots at the corners of tiles, where a filter goes wrong first.
#include <array>
#include <cmath>
#include <functional>

#include "graphs/pictures/picture.h"

namespace texgraph::pictures {

namespace {

constexpr uint32_t kPaths = 720000;

struct Edges {  // the colours, 0 or 1
  int south = 0;
  int east = 0;
  int north = 0;
  int west = 0;
};

// Wei's tour of the pairs of two colours: 00 01 11 10.
constexpr int kFirst[4] = {0, 0, 1, 1};
constexpr int kSecond[4] = {0, 1, 1, 0};

// Column and row are counted from the left lower corner.
Edges InTilePack(int column, int row) {
  return {kFirst[row], kSecond[column], kSecond[row], kFirst[column]};
}

Edges InRowMajorPack(int column, int row) { return {row % 2, column / 2, row / 2, column % 2}; }

// The tile at whose right top the corner of that place is, Wei's equation 10.
Edges InCornerPack(int column, int row) {
  const int north = kFirst[column];
  const int east = kFirst[row];
  return {north, east, north, east};
}

// Four tiles a side; `surface` gets a tile's column and row, and where in it, y upwards.
Picture DrawPack(int texels, const std::function<double(int, int, Point)>& height,
                 const std::function<Surface(int, int, Point)>& surface, double relief) {
  const auto split = [](Point p, int& column, int& row) {
    const double x = 4 * p.x;
    const double y = 4 * (1 - p.y);
    column = static_cast<int>(Clamp(std::floor(x), 0, 3));
    row = static_cast<int>(Clamp(std::floor(y), 0, 3));
    return Point{x - column, y - row};
  };
  return Paint(4 * texels, 4 * texels, false,
               {[&](Point p) {
                  int column;
                  int row;
                  const Point local = split(p, column, row);
                  return height(column, row, local);
                },
                [&](Point p) {
                  int column;
                  int row;
                  const Point local = split(p, column, row);
                  return surface(column, row, local);
                },
                relief});
}

// ---- Paths: they cross the edges of colour 1 in the middle, and meet in the middle of the tile.

double DistanceTo(Point p, Point end) {
  const Point from{p.x - 0.5, p.y - 0.5};
  const Point along{end.x - 0.5, end.y - 0.5};
  const double t = Clamp((from.x * along.x + from.y * along.y) / 0.25, 0, 1);
  const double dx = from.x - t * along.x;
  const double dy = from.y - t * along.y;
  return std::sqrt(dx * dx + dy * dy);
}

// How far from the middle line of the nearest path, rounded where paths meet.
double FromPath(const Edges& edges, Point p) {
  const std::array<int, 4> open = {edges.south, edges.east, edges.north, edges.west};
  const std::array<Point, 4> ends = {Point{0.5, 0}, {1, 0.5}, {0.5, 1}, {0, 0.5}};
  double distance = 1;
  for (size_t i = 0; i < 4; ++i) {
    if (open[i] == 0) continue;
    const double other = DistanceTo(p, ends[i]);
    const double h = Clamp(0.5 + (distance - other) / 0.2, 0, 1);
    distance = Mix(distance, other, h) - 0.1 * h * (1 - h);
  }
  return distance;
}

// Of sizes that have no common lines; it repeats after a tile.
double Uneven(Point p, int cells, uint32_t seed) {
  const auto noise = [&](int across, double from) {
    return Noise({across * p.x + from, across * p.y + from}, seed + static_cast<uint32_t>(across),
                 across);
  };
  return noise(cells, 0.3) + 0.6 * noise(2 * cells + 1, 0.7) + 0.4 * noise(4 * cells + 1, 0.45);
}

// 1 on the path, 0 on the grass. All that is random repeats after a tile, so that tiles fit.
double OnPath(const Edges& edges, Point p) {
  const double wobble = 0.035 * Noise({5 * p.x, 5 * p.y}, kPaths + 1, 5);
  return SmoothStep(0.165, 0.125, FromPath(edges, p) + wobble);
}

Picture DrawPaths(Edges (*at)(int, int)) {
  const auto height = [at](int column, int row, Point p) {
    const double on = OnPath(at(column, row), p);
    const double grass = 0.012 * Uneven(p, 13, kPaths + 200);
    const Cell stone = Cells({9 * p.x, 9 * p.y}, kPaths + 3, 9);
    return Mix(0.010 + grass, 0.010 * SmoothStep(0.0, 0.35, stone.border), on);
  };
  const auto surface = [at](int column, int row, Point p) {
    const double on = OnPath(at(column, row), p);
    const double clump = Uneven(p, 5, kPaths + 400);
    const Color grass = Mix({0.20, 0.34, 0.12}, {0.44, 0.58, 0.22}, Clamp(0.5 + 0.7 * clump, 0, 1));
    const Cell stone = Cells({9 * p.x, 9 * p.y}, kPaths + 3, 9);
    const Color slab = Mix({0.74, 0.66, 0.52}, {0.90, 0.84, 0.72}, stone.value);
    const Color path = Mix({0.50, 0.43, 0.33}, slab, SmoothStep(0.02, 0.12, stone.border));
    return Surface{Mix(grass, path, on), 1};
  };
  return DrawPack(64, height, surface, 6);
}

// ---- Dots.

constexpr Color kGround = {0.93, 0.91, 0.84};
constexpr Color kDot = {0.80, 0.10, 0.10};
constexpr int kDotTile = 32;  // texels

// `dots`: left bottom, right bottom, left top, right top.
Color DotColor(const std::array<bool, 4>& dots, Point p) {
  double red = 0;
  for (size_t corner = 0; corner < 4; ++corner) {
    const double dx = p.x - static_cast<double>(corner % 2);
    const double dy = p.y - static_cast<double>(corner / 2);
    const double distance = std::sqrt(dx * dx + dy * dy) * kDotTile;
    if (dots[corner]) red = std::fmax(red, Clamp(7.5 - distance, 0, 1));
  }
  return Mix(kGround, kDot, red);
}

// A tile has a quarter of a dot at a corner if both edges that meet there have colour 1.
Picture DrawDots(Edges (*at)(int, int)) {
  return DrawPack(
      kDotTile, [](int, int, Point) { return 0.0; },
      [at](int column, int row, Point p) {
        const Edges e = at(column, row);
        return Surface{DotColor({e.south + e.west == 2, e.south + e.east == 2,
                                 e.north + e.west == 2, e.north + e.east == 2},
                                p),
                       1};
      },
      0);
}

}  // namespace

Picture MakePaths() { return DrawPaths(InTilePack); }
Picture MakePathsRowMajor() { return DrawPaths(InRowMajorPack); }
Picture MakeEdgeDots() { return DrawDots(InTilePack); }
Picture MakeEdgeDotCorners() { return DrawDots(InCornerPack); }

// Corner tiles with a dot around each corner of colour 1, packed on the torus of 4 x 4.
Picture MakeCornerDots() {
  static constexpr int kColors[4][4] = {{1, 1, 1, 0}, {1, 1, 0, 1}, {0, 1, 0, 0}, {1, 0, 0, 0}};
  return DrawPack(
      kDotTile, [](int, int, Point) { return 0.0; },
      [](int column, int row, Point p) {
        std::array<bool, 4> dots{};
        for (int corner = 0; corner < 4; ++corner) {
          dots[static_cast<size_t>(corner)] =
              kColors[(row + corner / 2) % 4][(column + corner % 2) % 4] == 1;
        }
        return Surface{DotColor(dots, p), 1};
      },
      0);
}

}  // namespace texgraph::pictures
