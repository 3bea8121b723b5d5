// SPDX-License-Identifier: Apache-2.0
// A graph's shader against others for the same picture, for the tables of docs/benchmarks.md.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "tests/bench/measure.h"

namespace texgraph::bench {

// The graph `text` that lies at `path`, against at most two shaders in GLSL 450; the first of them
// draws the same picture. `quiet_rounds`: drawing goes on until so many rounds in a row were no
// faster.
ShaderFigures CompareShaders(const std::string& path, std::string_view text,
                             std::span<const std::string> others, int quiet_rounds);

}  // namespace texgraph::bench
