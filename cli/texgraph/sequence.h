// SPDX-License-Identifier: Apache-2.0
// Frames: what differs between them, and the names of their files.
#pragma once

#include <optional>
#include <string>

#include "cli/texgraph/render_options.h"
#include "runtime/live.h"

namespace texgraph::cli {

// "wall.png" is "wall.0001.png" for frame 1.
std::string FramePath(const std::string& output, uint32_t number);

// A sweep whose parameter was found in a manifest.
struct FoundSweep {
  std::string name;
  double first = 0;
  double last = 0;
  bool is_integer = false;
};

// Reported: kUnknownParameter, kNotRenderable for what is no uniform, kPortType for bools and
// matrices, kUsage without a range, kValueRange beyond the parameter's own.
std::optional<FoundSweep> FindSweep(const Sweep& sweep, const runtime::Manifest& manifest,
                                    Diagnostics& diagnostics);

// Frame i of N has the time t0 + (t1 - t0) i / N, so that a period repeats without a double frame,
// and the swept value a + (b - a) i / (N - 1), in each component; integers are rounded. On a
// turntable the camera has gone i / N of the way round.
// False if it could not be drawn; why is in the result.
bool DrawFrame(const RenderOptions& options, const std::optional<FoundSweep>& sweep, uint32_t frame,
               runtime::LiveRenderer& renderer, runtime::RenderResult& result);

}  // namespace texgraph::cli
