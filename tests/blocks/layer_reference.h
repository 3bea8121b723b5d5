// SPDX-License-Identifier: Apache-2.0
// Where a layer's element is, in double precision, from what the documentation of `layer` says.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "tests/blocks/reference.h"
#include "tests/blocks/run_block.h"

namespace texgraph::blocks::reference {

// The reference: a frame with its image's axes in texture space.
struct Frame {
  Point origin;  // of the frame's middle
  double angle = 0;
  Point size;
  uint32_t seed = 0;
};

struct Limits {
  Point position_min{0.5, 0.5}, position_max{0.5, 0.5};
  double scale_min = 1, scale_max = 1, rotation_min = 0, rotation_max = 0;
  bool contain = false;
  uint32_t stream = 0;
  double stretch_min = 1, stretch_max = 1;
};

// The middle of the element in texture space, from its parent's frame: position, scale and rotation
// are drawn from the parent's seed.
inline Frame PlaceIn(const Frame& parent, const Limits& limits) {
  uint32_t seed = Pcg(parent.seed + limits.stream);
  uint32_t place = Pcg(seed - 1), turn = Pcg(seed - 2);
  double px = Mix(limits.position_min.x, limits.position_max.x, Low16(place)) - 0.5;
  double py = Mix(limits.position_min.y, limits.position_max.y, High16(place)) - 0.5;
  double dx = px * parent.size.x, dy = py * parent.size.y;
  double c = std::cos(parent.angle), s = std::sin(parent.angle);
  double scale = Mix(limits.scale_min, limits.scale_max, Low16(turn));
  double angle =
      Mix(limits.rotation_min, limits.rotation_max, High16(turn)) * std::numbers::pi / 180;
  double side = std::fmin(parent.size.x, parent.size.y);
  Point shape = limits.contain ? Point{side, side} : parent.size;
  return {{parent.origin.x + c * dx - s * dy, parent.origin.y + s * dx + c * dy},
          parent.angle + angle,
          {scale * shape.x,
           scale * shape.y * Mix(limits.stretch_min, limits.stretch_max, Low16(Pcg(seed - 4)))},
          seed};
}

inline Point InFrame(const Frame& frame, Point p) {
  double dx = p.x - frame.origin.x, dy = p.y - frame.origin.y;
  double c = std::cos(frame.angle), s = std::sin(frame.angle);
  return {(c * dx + s * dy) / frame.size.x + 0.5, (c * dy - s * dx) / frame.size.y + 0.5};
}

}  // namespace texgraph::blocks::reference
