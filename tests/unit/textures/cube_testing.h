// SPDX-License-Identifier: Apache-2.0
// Solid samples for tests of cubes.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "compiler/textures/cube_set.h"
#include "compiler/textures/image.h"
#include "tests/unit/textures/tile_testing.h"

namespace texgraph::textures::test {

// Grains of different shades, some fine noise. Periodic.
inline std::vector<Image> GrainSlices(uint32_t side, uint8_t channels, uint8_t bits,
                                      uint32_t seed) {
  std::mt19937 random(seed);
  const auto below = [&](uint32_t n) { return static_cast<uint32_t>(random() % n); };
  struct Grain {
    std::array<uint32_t, 3> at;
    uint32_t shade;
  };
  const uint32_t most = bits == 8 ? 255 : 65535;
  std::vector<Grain> grains(std::max(side * side * side / 200, 8u));
  for (Grain& grain : grains) {
    grain.at = {below(side), below(side), below(side)};
    grain.shade = most / 8 + below(most * 3 / 4);
  }
  std::vector<Image> slices;
  for (uint32_t z = 0; z < side; ++z) {
    std::vector<uint32_t> samples;
    for (uint32_t i = 0; i < side * side; ++i) {
      const uint32_t at[3] = {i % side, i / side, z};
      uint32_t nearest = ~0u;
      uint32_t shade = 0;
      for (const Grain& grain : grains) {
        uint32_t distance = 0;
        for (size_t axis = 0; axis < 3; ++axis) {
          const uint32_t apart = (at[axis] + side - grain.at[axis]) % side;
          distance += std::min(apart, side - apart) * std::min(apart, side - apart);
        }
        if (distance >= nearest) continue;
        nearest = distance;
        shade = grain.shade;
      }
      for (uint32_t c = 0; c < channels; ++c)
        samples.push_back(std::min(shade / (c + 1) + below(most / 16), most));
    }
    slices.push_back(MakeImage(side, side, channels, bits, samples));
  }
  return slices;
}

inline CubeSetOptions SmallCubes(uint32_t colors, uint32_t size) {
  CubeSetOptions options;
  options.colors = colors;
  options.cube_size = size;
  options.wraps = true;
  options.candidates = 12;
  options.seed = 5;
  options.threads = 1;
  return options;
}

// Row by row upwards, slice by slice; around the sample if it lies outside.
inline uint32_t SolidAt(const std::vector<Image>& slices, std::array<int64_t, 3> at,
                        uint32_t channel) {
  const auto depth = static_cast<int64_t>(slices.size());
  return UpAt(slices[static_cast<size_t>((at[2] % depth + depth) % depth)], at[0], at[1], channel);
}

// Texel of a cube of the pack; outside of it what lies there in the pack.
inline uint32_t CubeTexel(const CubeSet& set, CubePlace cube, std::array<int64_t, 3> at,
                          uint32_t channel) {
  const int64_t size = set.layout.cube_size;
  const auto side = int64_t{set.layout.width()};
  const auto depth = int64_t{set.layout.depth()};
  const int64_t x = (cube.x * size + at[0] + side) % side;
  const int64_t y = (cube.y * size + at[1] + side) % side;
  const int64_t z = (cube.z * size + at[2] + depth) % depth;
  return UpAt(set.pack, x, z * side + y, channel);
}

// Calls `work` for each place of a box.
template <class Work>
void ForBox(std::array<int64_t, 3> first, std::array<int64_t, 3> end, const Work& work) {
  for (int64_t z = first[2]; z < end[2]; ++z) {
    for (int64_t y = first[1]; y < end[1]; ++y) {
      for (int64_t x = first[0]; x < end[0]; ++x) work(std::array<int64_t, 3>{x, y, z});
    }
  }
}

}  // namespace texgraph::textures::test
