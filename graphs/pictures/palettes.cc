// SPDX-License-Identifier: Apache-2.0
// Maps that give two noises a colour: across the one, up the other, both from 0 to 1. What lies
// next to each other here does so on the surface too.
#include <cmath>

#include "graphs/pictures/canvas.h"

namespace texgraph::pictures {

namespace {

// 1 within `radius` of a place, 0 outside.
double MapDisc(Point p, Point center, double radius, double soft) {
  return SmoothStep(radius + soft, radius - soft, Length(p - center));
}

}  // namespace

// Stone with lichens on it: where the first noise is high a pale one grows, ringed by its dark
// prothallus; on it, where it is highest, an orange one. The second noise is the grain of all.
Picture MakeLichenMap() {
  Canvas canvas(128, 128);
  canvas.Fill([](Point p) {
    const double grain = 1 - p.y;
    const Color stone = Mix({0.27, 0.26, 0.26}, {0.56, 0.54, 0.51}, SmoothStep(0.1, 0.9, grain));
    const Color brown = Mix({0.32, 0.25, 0.20}, {0.58, 0.49, 0.41}, SmoothStep(0.1, 0.9, grain));
    const Color warm = Mix(stone, brown, SmoothStep(0.48, 0.20, p.x));
    const Color pale = Mix({0.47, 0.52, 0.38}, {0.80, 0.83, 0.68}, SmoothStep(0.25, 0.75, grain));
    const Color orange = Mix({0.66, 0.36, 0.06}, {0.95, 0.72, 0.22}, SmoothStep(0.30, 0.80, grain));
    // Borders run aslant, so that the grain frays them.
    const double border = p.x + 0.10 * (grain - 0.5);
    Color color = Mix(warm, {0.16, 0.17, 0.13}, SmoothStep(0.555, 0.57, border));
    color = Mix(color, pale, SmoothStep(0.59, 0.605, border));
    color = Mix(color, orange, SmoothStep(0.735, 0.75, p.x - 0.16 * (grain - 0.5)));
    // Fruit bodies on the pale lichen, and chips in the stone.
    color = Mix(color, {0.22, 0.17, 0.13}, MapDisc(p, {0.66, 0.20}, 0.055, 0.008));
    return Mix(color, {0.70, 0.68, 0.66}, MapDisc(p, {0.36, 0.14}, 0.07, 0.01));
  });
  return canvas.FinishOpaque();
}

}  // namespace texgraph::pictures
