// SPDX-License-Identifier: Apache-2.0
// How cubes are divided among the patches of their corners. Patches are joined pairwise, each time
// along the surface of least cost (Kwatra et al. 2003), an exact minimum cut: first along x, so
// that all four patches at a face across z are two pairs, then these along y, then the two faces
// along z. What lies within a border's depth of an edge or a face is joined once for the colours
// there, and that is given when the parts that have this edge or face are joined; so all cubes with
// a face in common have the same texels on both sides of it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "compiler/textures/cube_packing.h"
#include "compiler/textures/cube_sample.h"

namespace texgraph::textures {

// A box of texels, counted from a corner of the grid, and which corner's patch each has: 1 for the
// next one along x, 2 along y, 4 along z, and their sums.
struct CubePart {
  std::array<int32_t, 3> first{};
  std::array<int32_t, 3> size{};
  std::vector<uint8_t> labels;  // x fastest, then y

  bool Has(const std::array<int32_t, 3>& at) const;
  uint8_t At(const std::array<int32_t, 3>& at) const;
};

// What is needed to cut cubes: a patch for each colour, at a scale of the sample.
struct CubePatches {
  const CubeSample& sample;
  uint32_t scale = 0;
  uint32_t size = 0;                // of a cube, texels of the scale
  std::vector<VoxelPlace> corners;  // where the corner lies in the sample, texels of the scale

  // Where the texel `at` of a cube lies in the sample if it is of that corner's patch.
  VoxelPlace PlaceOf(const CubeColors& colors, uint8_t label,
                     const std::array<int32_t, 3>& at) const;
};

class CubeParts {
 public:
  // Joins all that cubes have in common, on up to `threads` threads (as in tile_threads.h).
  CubeParts(CubePatches patches, uint32_t threads);

  // The cube with these colours, from (0, 0, 0) to the size.
  CubePart Cube(const CubeColors& colors) const;
  // What all seams of the parts cost.
  int64_t Energy() const;

 private:
  struct Joined {
    CubePart part;
    int64_t energy = 0;
  };
  // A part that stands in a box, moved by one cube along `axis` if `moved`.
  struct Given {
    const CubePart* part;
    uint32_t axis = 0;
    bool moved = false;
  };
  struct Join;

  Joined Cut(const Join& join) const;
  // Pairs of colours along each axis, x fastest; four colours of a face, its lower axis fastest.
  const CubePart& Edge(uint32_t axis, uint32_t from, uint32_t to) const {
    return edges_[axis][from + count_ * to].part;
  }
  const CubePart& Face(uint32_t axis, std::array<uint32_t, 4> colors) const;
  void JoinEdges(uint32_t threads);
  void JoinFaces(uint32_t threads);

  CubePatches patches_;
  uint32_t count_;  // of colours
  int32_t size_;
  int32_t reach_;
  int32_t depth_;
  std::array<std::vector<Joined>, 3> edges_;
  std::array<std::vector<Joined>, 3> faces_;  // by the axis that they lie across
};

}  // namespace texgraph::textures
