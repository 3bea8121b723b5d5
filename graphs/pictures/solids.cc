// SPDX-License-Identifier: Apache-2.0
// Solid samples for cubes by example: volumes that repeat along all three axes, as a sheet of their
// slices.
#include <array>

#include "graphs/pictures/noise.h"
#include "graphs/pictures/picture.h"

namespace texgraph::pictures {

namespace {

constexpr uint32_t kGranite = 800000;
constexpr int kSide = 40;    // texels
constexpr int kColumns = 8;  // of slices
constexpr int kGrains = 13;  // each way
constexpr int kParts = 2;    // samples of a texel, each way

using Place = std::array<double, 3>;

double RandomInSpace(int x, int y, int z, uint32_t seed) { return Random(x + 256 * z, y, seed); }

int Around(int cell) { return (cell % kGrains + kGrains) % kGrains; }

Color Mineral(int x, int y, int z) {
  const double kind = RandomInSpace(x, y, z, kGranite + 4);
  const double tone = RandomInSpace(x, y, z, kGranite + 5);
  if (kind < 0.13) return Mix({0.07, 0.07, 0.08}, {0.20, 0.18, 0.16}, tone);  // mica
  if (kind < 0.42) return Mix({0.50, 0.49, 0.49}, {0.66, 0.65, 0.63}, tone);  // quartz
  if (kind < 0.60) return Mix({0.80, 0.78, 0.74}, {0.91, 0.89, 0.86}, tone);  // white
  return Mix({0.66, 0.49, 0.41}, {0.82, 0.66, 0.57}, tone);                   // feldspar
}

// Grains are the cells of random points, one in each cell of a grid, some larger than others.
Color GraniteAt(const Place& place) {
  std::array<int, 3> cell;
  for (size_t i = 0; i < 3; ++i) cell[i] = static_cast<int>(place[i] * kGrains);
  double nearest = 1e9;
  double second = 1e9;
  Color color;
  for (int n = 0; n < 27; ++n) {
    const std::array<int, 3> at = {cell[0] + n % 3 - 1, cell[1] + n / 3 % 3 - 1,
                                   cell[2] + n / 9 - 1};
    const int x = Around(at[0]);
    const int y = Around(at[1]);
    const int z = Around(at[2]);
    double distance = 0.22 * RandomInSpace(x, y, z, kGranite + 3);
    for (uint32_t i = 0; i < 3; ++i) {
      const double apart =
          place[i] * kGrains - at[i] - 0.08 - 0.84 * RandomInSpace(x, y, z, kGranite + i);
      distance += apart * apart;
    }
    if (distance < nearest) {
      second = nearest;
      nearest = distance;
      color = Mineral(x, y, z);
    } else if (distance < second) {
      second = distance;
    }
  }
  return color * Mix(0.86, 1.0, SmoothStep(0.0, 0.12, second - nearest));
}

}  // namespace

Picture MakeGranite() {
  Picture picture;
  picture.width = kColumns * kSide;
  picture.height = kSide / kColumns * kSide;
  picture.pixels.resize(static_cast<size_t>(3 * picture.width * picture.height));
  for (int z = 0; z < kSide; ++z) {
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        std::array<double, 3> sum{};
        for (int part = 0; part < kParts * kParts * kParts; ++part) {
          const auto middle = [&](int texel, int at) {
            return (texel + (at + 0.5) / kParts) / kSide;
          };
          const Color color =
              GraniteAt({middle(x, part % kParts), middle(y, part / kParts % kParts),
                         middle(z, part / kParts / kParts)});
          sum[0] += color.r;
          sum[1] += color.g;
          sum[2] += color.b;
        }
        // The slices from w = 0 on stand row by row from the left top; v goes up.
        const int column = z % kColumns * kSide + x;
        const int row = z / kColumns * kSide + kSide - 1 - y;
        for (size_t c = 0; c < 3; ++c) {
          const double value = sum[c] / (kParts * kParts * kParts);
          picture.pixels[3 * static_cast<size_t>(row * picture.width + column) + c] =
              static_cast<uint8_t>(Clamp(value, 0, 1) * 255 + 0.5);
        }
      }
    }
  }
  return picture;
}

}  // namespace texgraph::pictures
