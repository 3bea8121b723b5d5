// SPDX-License-Identifier: Apache-2.0
// Small things seen from above, to be laid on a canvas: each at a place, with a size in the
// canvas's unit and a number that makes it one of its kind. The light comes from the upper left.
#pragma once

#include "graphs/pictures/canvas.h"

namespace texgraph::pictures {

// How far each of them reaches from its place, in its size, shadow and all.
inline constexpr double kThingReach = 1.5;

void LayStone(Canvas& canvas, Point at, double size, uint32_t seed);
void LayPoppy(Canvas& canvas, Point at, double size, uint32_t seed);
void LayDaisy(Canvas& canvas, Point at, double size, uint32_t seed);
void LayClover(Canvas& canvas, Point at, double size, uint32_t seed);
void LayTwig(Canvas& canvas, Point at, double size, uint32_t seed);
void LayMoss(Canvas& canvas, Point at, double size, uint32_t seed);
void LayShell(Canvas& canvas, Point at, double size, uint32_t seed);

}  // namespace texgraph::pictures
