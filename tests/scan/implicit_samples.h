// SPDX-License-Identifier: Apache-2.0
// A second opinion on filtering that shares nothing with the compiler: reads SPIR-V, and finds samples with implicit derivatives
// where these are wrong.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace texgraph::scan {

struct ImplicitSamples {
  int implicit = 0;  // OpImageSampleImplicitLod in the whole shader
  int explicit_ = 0;  // OpImageSampleExplicitLod
  // What is wrong, a line each: a sample that not every pixel comes to just once, or whose coordinate jumps.
  std::vector<std::string> mistakes;
};

// `words`: a fragment shader as glslang makes it. It is inlined and put into single assignment first. Nothing if SPIRV-Tools
// cannot do that.
std::optional<ImplicitSamples> FindImplicitSamples(const std::vector<uint32_t>& words);

}  // namespace texgraph::scan
