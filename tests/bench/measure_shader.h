// SPDX-License-Identifier: Apache-2.0
// A graph's shader against others for the same picture, for the tables of docs/benchmarks.md.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/render.h"
#include "tests/bench/measure.h"
#include "tests/bench/spirv_weight.h"

namespace texgraph::bench {

// The graph `text` that lies at `path`, against at most two shaders in GLSL 450; the first of them
// draws the same picture. `quiet_rounds`: drawing goes on until so many rounds in a row were no
// faster.
ShaderFigures CompareShaders(const std::string& path, std::string_view text,
                             std::span<const std::string> others, int quiet_rounds);

// A graph that is ready to be drawn.
struct Drawable {
  runtime::RenderRequest request;  // a square of kSide pixels of uv from 0 to 1
  Weight weight;
  std::string error;  // not empty: why there is no such thing
};
// `settings` as those of texgraphc --set.
Drawable Prepare(const std::string& path, std::string_view text,
                 const std::vector<std::string>& settings = {});

// Draws all of them in turns, so that a machine that slows down slows them all, until
// `quiet_rounds` rounds in a row were no faster. The fastest frame of each, in milliseconds; empty
// with a reason in `error`.
struct Drawn {
  std::vector<double> frame_ms;
  std::vector<textures::Image> pictures;
  std::string renderer;
  std::string error;
};
Drawn DrawInTurns(std::vector<runtime::RenderRequest> requests, int quiet_rounds);

// The mean over all samples of two pictures of the same size, of 255.
double MeanDifference(const textures::Image& a, const textures::Image& b);

}  // namespace texgraph::bench
