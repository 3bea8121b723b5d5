// SPDX-License-Identifier: Apache-2.0
// Where the cubes of a complete set with colours at their eight corners stand in their pack, in
// whole numbers: what a shader computes, too. Cubes that touch in the pack have the same colours
// where they touch, on a torus in all three directions.
//
// Let W be the torus of N x N corners of tile_packing.h, N = colors^2, in which each 2 x 2 window
// of colours is there once. Layer z of corners in the pack is W, moved by s(z): the corner at (x,
// y, z) has colour W(x + s_x(z), y + s_y(z)). So a cube has a window of W below and another above,
// whose place minus that of the one below is s(z + 1) - s(z). If these steps run through all N^2
// pairs of numbers below N, each once, then each two windows lie above each other once: all
// colors^8 cubes are there once, in N x N x N^2. Steps in their usual order, s(z + 1) - s(z) = (z
// mod N, z / N), sum to closed forms (CubeShift), and to a multiple of N over all z, as N^2 (N - 1)
// / 2 is one for odd and for even N: so the last layer is followed by the first.
#pragma once

#include <array>
#include <cstdint>

namespace texgraph::textures {

inline constexpr uint32_t kMinCubeColors = 2;
inline constexpr uint32_t kMaxCubeColors = 3;  // four do not close on a torus of N x N
inline constexpr uint32_t kMinCubeSize = 4;
inline constexpr uint32_t kMaxCubeSize = 64;
inline constexpr uint32_t kMaxCubePackSide = 2048;  // texels: what OpenGL 4.5 promises

// Of the corner at x, y, z, each 0 or 1, at x + 2 y + 4 z.
using CubeColors = std::array<uint32_t, 8>;

struct CubePlace {
  uint32_t x = 0;
  uint32_t y = 0;
  uint32_t z = 0;
  bool operator==(const CubePlace&) const = default;
};

struct CubePackLayout {
  uint32_t colors = 2;
  uint32_t cube_size = 0;  // texels
  uint32_t side = 0;       // cubes, to the right and upwards: colors^2
  uint32_t layers = 0;     // side^2

  uint32_t cubes() const { return side * side * layers; }
  uint32_t width() const { return side * cube_size; }
  uint32_t depth() const { return layers * cube_size; }
};

CubePackLayout LayOutCubes(uint32_t colors, uint32_t cube_size);

// s(z), each below colors^2.
std::array<uint32_t, 2> CubeShift(uint32_t z, uint32_t colors);
CubePlace PackedCube(const CubeColors& corners, uint32_t colors);
// The other way, for any place: the pack repeats.
CubeColors CubeAt(const CubePackLayout& layout, int64_t x, int64_t y, int64_t z);

}  // namespace texgraph::textures
