// SPDX-License-Identifier: Apache-2.0
// Pebbles of a river, of several sizes, kinds of rock and colours, packed as they come to lie: the
// large ones first, smaller ones where there is room, grit between them. Four maps of one pile,
// which repeats: colour, normals, height and roughness.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "graphs/pictures/canvas.h"

namespace texgraph::pictures {

namespace {

constexpr uint32_t kPile = 720000;
constexpr int kPebblesSide = 256;        // of the pictures
constexpr int kFine = 2 * kPebblesSide;  // of what they are the mean of
constexpr double kLargest = 0.033;
constexpr double kSmallest = 0.0058;
constexpr double kSmaller = 0.93;  // each size is this part of the one before
constexpr double kHighest = 0.025;
constexpr int kBuckets = 30;  // a side, to find stones by place

struct Rock {
  Color color;
  double roughness;
  double speckles;  // how strong
  double bands;
};
constexpr Rock kRocks[] = {{{0.45, 0.46, 0.48}, 0.55, 0.10, 0.05},   // slate
                           {{0.54, 0.51, 0.47}, 0.62, 0.22, 0.00},   // granite
                           {{0.66, 0.57, 0.44}, 0.75, 0.10, 0.22},   // sandstone
                           {{0.55, 0.41, 0.35}, 0.60, 0.12, 0.10},   // jasper
                           {{0.37, 0.37, 0.38}, 0.45, 0.08, 0.00},   // basalt
                           {{0.70, 0.67, 0.61}, 0.35, 0.06, 0.08},   // quartz
                           {{0.48, 0.50, 0.46}, 0.58, 0.14, 0.16},   // greenstone
                           {{0.60, 0.55, 0.50}, 0.66, 0.16, 0.00}};  // porphyry

struct Stone {
  Point at;
  Point along;  // its longer axis
  double length = 0;
  double width = 0;  // both of half of it
  Point tilt;
  double base = 0;  // of its lower side
  uint32_t seed = 0;
  const Rock* rock = nullptr;
  double tone = 1;
};

// From `a` to the nearest of the places that `b` has in a pattern that repeats.
Point Across(Point a, Point b) {
  const auto near = [](double apart) { return apart - std::floor(apart + 0.5); };
  return {near(b.x - a.x), near(b.y - a.y)};
}

// How far the ellipse reaches in a direction of length 1.
double ReachOf(const Stone& stone, Point direction) {
  const Point turned = Turned(direction, stone.along);
  const double x = turned.x * stone.width;
  const double y = turned.y * stone.length;
  return stone.length * stone.width / std::sqrt(x * x + y * y);
}

struct Pile {
  double height = 0;
  double rim = 1;  // 0 in the middle of a stone to 1 at its rim
  const Stone* stone = nullptr;
  Point offset;  // from its middle, in its own frame
};

class Pebbles {
 public:
  Pebbles();
  Pile At(Point p) const;

 private:
  Stone StoneOf(int size, int dart) const;
  bool HasRoom(const Stone& stone) const;
  const Rock* RareRock(const Stone& stone) const;
  void Lay(const Stone& stone);
  static int Bucket(double at) {
    return std::clamp(static_cast<int>((at - std::floor(at)) * kBuckets), 0, kBuckets - 1);
  }
  // Indices of the stones that may be within `reach` of a place.
  template <typename Use>
  void Near(Point p, double reach, const Use& use) const {
    const int around = static_cast<int>(reach * kBuckets) + 1;
    for (int y = -around; y <= around; ++y) {
      for (int x = -around; x <= around; ++x) {
        const int row = (Bucket(p.y) + y + kBuckets) % kBuckets;
        const int column = (Bucket(p.x) + x + kBuckets) % kBuckets;
        for (int i : buckets_[static_cast<size_t>(row * kBuckets + column)]) use(i);
      }
    }
  }

  std::vector<Stone> stones_;
  std::vector<std::vector<int>> buckets_{kBuckets * kBuckets};
};

Pebbles::Pebbles() {
  double radius = kLargest;
  for (int size = 0; radius > kSmallest; ++size, radius *= kSmaller) {
    // As many of each size as leave room for the others.
    const int darts = static_cast<int>(0.9 / (radius * radius));
    for (int dart = 0; dart < darts; ++dart) {
      Stone stone = StoneOf(size, dart);
      if (!HasRoom(stone)) continue;
      stone.rock = RareRock(stone);
      Lay(stone);
    }
  }
}

Stone Pebbles::StoneOf(int size, int dart) const {
  double radius = kLargest;
  for (int i = 0; i < size; ++i) radius *= kSmaller;
  const uint32_t seed = kPile + 100 + static_cast<uint32_t>(size) * 100003;
  const auto random = [&](uint32_t stream) { return Random(dart, 0, seed + stream); };
  Stone stone;
  stone.at = {random(0), random(1)};
  stone.along = Direction(dart, 1, seed);
  const double slim = 0.62 + 0.33 * random(2);
  stone.length = radius / std::sqrt(slim);
  stone.width = radius * std::sqrt(slim);
  stone.tilt = Direction(dart, 2, seed) * (0.16 * random(3));
  // Small stones lie on others that are not seen.
  stone.base = 0.25 * (kLargest - radius);
  stone.seed = seed + 1000 + static_cast<uint32_t>(dart) * 16;
  stone.tone = 0.84 + 0.30 * random(5);
  return stone;
}

bool Pebbles::HasRoom(const Stone& stone) const {
  bool room = true;
  Near(stone.at, 1.3 * (stone.length + kLargest), [&](int i) {
    if (!room) return;
    const Stone& other = stones_[static_cast<size_t>(i)];
    const Point apart = Across(stone.at, other.at);
    const Point direction = Unit(apart);
    room = Length(apart) > 0.985 * (ReachOf(stone, direction) + ReachOf(other, direction));
  });
  return room;
}

// One of which there is little nearby. Drawn at random, kinds would lie in heaps, and a heap is
// seen wherever its part of the picture is.
const Rock* Pebbles::RareRock(const Stone& stone) const {
  constexpr double kNear = 0.2;
  double areas[std::size(kRocks)] = {};
  Near(stone.at, kNear, [&](int i) {
    const Stone& other = stones_[static_cast<size_t>(i)];
    const double nearness = std::max(1 - Length(Across(stone.at, other.at)) / kNear, 0.0);
    areas[other.rock - kRocks] += other.length * other.width * nearness * nearness;
  });
  size_t rare = 0;
  for (size_t kind = 0; kind < std::size(kRocks); ++kind) {
    areas[kind] += stone.length * stone.width * Random(static_cast<int>(kind), 3, stone.seed);
    if (areas[kind] < areas[rare]) rare = kind;
  }
  return &kRocks[rare];
}

void Pebbles::Lay(const Stone& stone) {
  const int bucket = Bucket(stone.at.y) * kBuckets + Bucket(stone.at.x);
  buckets_[static_cast<size_t>(bucket)].push_back(static_cast<int>(stones_.size()));
  stones_.push_back(stone);
}

Pile Pebbles::At(Point p) const {
  Pile top;
  top.height = 0.0022 + 0.0015 * Fractal(p * 80, 2, kPile + 1, 80);
  Near(p, 1.45 * kLargest, [&](int i) {
    const Stone& stone = stones_[static_cast<size_t>(i)];
    const Point offset = Turned(Across(stone.at, p), stone.along);
    const Point q{offset.x / stone.length, offset.y / stone.width};
    if (std::max(std::abs(q.x), std::abs(q.y)) > 1.2) return;
    // No stone is an ellipse: its outline has flat parts and blunt corners.
    const double bulge = Noise(Unit(q) * 1.1 + Point{7.3, 2.9}, stone.seed);
    const double far = Length(q) * (1 + 0.13 * bulge);
    if (far >= 1) return;
    const double dent = Noise(q * 1.7, stone.seed + 1);
    const double dome = std::sqrt(1 - far * far * (0.45 + 0.55 * far));
    const double height =
        stone.base + stone.width * (0.62 * dome * (1 + 0.10 * dent) + Dot(stone.tilt, q) * dome);
    if (height > top.height) top = {height, far, &stone, offset};
  });
  return top;
}

Color ColorOf(const Pile& pile, Point p) {
  const double grain = Fractal(p * 90, 2, kPile + 11, 90);
  if (!pile.stone) {
    return Color{0.36, 0.32, 0.27} * (0.8 + 0.7 * grain);
  }
  const Stone& stone = *pile.stone;
  const Rock& rock = *stone.rock;
  const double cloud = Noise(pile.offset * 40, stone.seed + 2);
  const double band = Noise({pile.offset.x * 24, pile.offset.y * 140 + 3 * cloud}, stone.seed + 3);
  const double vein = Noise(pile.offset * 24 + Point{band, cloud}, stone.seed + 4);
  const double light = stone.tone * (1 + rock.speckles * 1.9 * grain + rock.bands * 1.5 * band +
                                     0.16 * cloud - 0.12 * pile.rim * pile.rim);
  Color color = rock.color * light;
  // Thin pale veins run through some.
  if (Random(5, 0, stone.seed) < 0.16) {
    color = Mix(color, {0.82, 0.80, 0.76}, 0.75 * SmoothStep(0.030, 0.008, std::abs(vein)));
  }
  return color;
}

double RoughnessOf(const Pile& pile, Point p) {
  if (!pile.stone) return 0.95;
  const double wear = Noise(pile.offset * 40, pile.stone->seed + 5);
  return pile.stone->rock->roughness + 0.10 * wear + 0.12 * pile.rim * pile.rim +
         0.05 * Noise(p * 120, kPile + 21, 120);
}

struct Point3 {
  double x = 0;
  double y = 0;
  double z = 0;
};

// All of the pile on a grid.
struct Maps {
  std::vector<double> heights;
  std::vector<Color> colors;
  std::vector<double> roughness;
};

size_t IndexOf(int x, int y) {
  const auto around = [](int at) { return (at % kFine + kFine) % kFine; };
  return static_cast<size_t>(around(y) * kFine + around(x));
}

Maps MakeMaps() {
  const Pebbles pebbles;
  Maps maps;
  for (int y = 0; y < kFine; ++y) {
    for (int x = 0; x < kFine; ++x) {
      const Point p{(x + 0.5) / kFine, (y + 0.5) / kFine};
      const Pile pile = pebbles.At(p);
      maps.heights.push_back(pile.height);
      maps.colors.push_back(ColorOf(pile, p));
      maps.roughness.push_back(RoughnessOf(pile, p));
    }
  }
  return maps;
}

// The mean height within `reach` of each place, by sums along rows, then along columns.
std::vector<double> Blurred(const std::vector<double>& heights, int reach) {
  std::vector<double> from = heights;
  for (const bool upright : {false, true}) {
    std::vector<double> to(from.size());
    for (int i = 0; i < kFine; ++i) {
      for (int j = 0; j < kFine; ++j) {
        double sum = 0;
        for (int k = -reach; k <= reach; ++k)
          sum += from[upright ? IndexOf(i, j + k) : IndexOf(j + k, i)];
        to[upright ? IndexOf(i, j) : IndexOf(j, i)] = sum / (2 * reach + 1);
      }
    }
    from = std::move(to);
  }
  return from;
}

uint8_t Byte(double value) { return static_cast<uint8_t>(Clamp(value, 0, 1) * 255 + 0.5); }

// The mean of what the four places of the grid have that a pixel is made of.
template <typename PartOf>
Point3 MeanOf(int x, int y, const PartOf& part_of) {
  Point3 sum;
  for (int i = 0; i < 4; ++i) {
    const Point3 part = part_of(2 * x + i % 2, 2 * y + i / 2);
    sum = {sum.x + part.x / 4, sum.y + part.y / 4, sum.z + part.z / 4};
  }
  return sum;
}

template <typename PixelOf>
Picture MakePicture(const PixelOf& pixel_of) {
  Picture picture{kPebblesSide, kPebblesSide, false, {}};
  for (int y = 0; y < kPebblesSide; ++y) {
    for (int x = 0; x < kPebblesSide; ++x) {
      const Point3 pixel = pixel_of(x, y);
      picture.pixels.insert(picture.pixels.end(), {Byte(pixel.x), Byte(pixel.y), Byte(pixel.z)});
    }
  }
  return picture;
}

// The same number in all three channels.
Picture MakeGrey(const std::vector<double>& values, double unit) {
  return MakePicture([&](int x, int y) {
    return MeanOf(x, y, [&](int column, int row) {
      const double value = values[IndexOf(column, row)] / unit;
      return Point3{value, value, value};
    });
  });
}

}  // namespace

Picture MakePebbles() {
  const Maps maps = MakeMaps();
  const std::vector<double> near = Blurred(maps.heights, 4);
  const std::vector<double> around = Blurred(maps.heights, 11);
  const auto lit = [&](int x, int y) {
    const size_t i = IndexOf(x, y);
    // Little light of the sky comes to what lies lower than what is around it.
    const double below = std::max(near[i] - maps.heights[i], 0.0) * 85 +
                         std::max(around[i] - maps.heights[i], 0.0) * 55;
    const Color color = maps.colors[i] * (1 / (1 + below));
    return Point3{color.r, color.g, color.b};
  };
  return Coarse(MakePicture([&](int x, int y) { return MeanOf(x, y, lit); }));
}

// From 0, the lowest place, to 1.
Picture MakePebblesHeight() { return MakeGrey(MakeMaps().heights, kHighest); }

Picture MakePebblesRelief() {
  const Maps maps = MakeMaps();
  const auto slope = [&](int x, int y) {
    const auto step = [&](int dx, int dy) {
      return (maps.heights[IndexOf(x + dx, y + dy)] - maps.heights[IndexOf(x - dx, y - dy)]) *
             kFine / 2;
    };
    return Point3{step(1, 0), step(0, 1), 0};
  };
  return MakePicture([&](int x, int y) {
    const Point3 mean = MeanOf(x, y, slope);
    const double length = std::sqrt(1 + mean.x * mean.x + mean.y * mean.y);
    return Point3{0.5 - 0.5 * mean.x / length, 0.5 + 0.5 * mean.y / length, 0.5 + 0.5 / length};
  });
}

Picture MakePebblesRoughness() { return MakeGrey(MakeMaps().roughness, 1); }

}  // namespace texgraph::pictures
