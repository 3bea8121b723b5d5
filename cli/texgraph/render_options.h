// SPDX-License-Identifier: Apache-2.0
// The command line of texgraph render as a value, checked as far as it can be without reading a
// file.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/compile.h"
#include "runtime/render.h"

namespace texgraph::cli {

enum class PictureFormat : uint8_t { kPng, kExr };

// Files of frames have numbers of four digits.
inline constexpr uint32_t kMaxFrames = 9999;

// A parameter that goes over its range, or over `range`, both ends included.
struct Sweep {
  std::string name;
  std::optional<std::array<double, 2>> range;
};

// What --mesh and the options beside it say; the mesh itself is read later.
struct MeshOptions {
  std::string mesh;  // the name of a shape, or a file; "": none
  runtime::Scene scene;
  bool has_camera = false;  // else each shape has its own
  bool turntable = false;
};

struct RenderOptions {
  std::string input;   // a graph or a manifest; "-" is a graph on standard input
  std::string output;  // the picture, or "-"
  PictureFormat format = PictureFormat::kPng;
  uint32_t width = 512;
  uint32_t height = 512;
  std::array<double, 4> window = {0, 0, 1, 1};
  std::string output_name;  // "": color, or the first
  uint8_t bits = 8;         // PNG 8 or 16; OpenEXR 16 or 32, floating point
  double time = 0;
  std::optional<double> end_time;  // not reached: the frame after the last would have it
  std::optional<Sweep> sweep;
  MeshOptions mesh;
  uint32_t frames = 0;         // 0 if neither the time, a parameter nor the camera varies
  bool contact_sheet = false;  // of the frames, or of all outputs if there are none
  double timeout = 60;
  runtime::ContextChoice context = runtime::ContextChoice::kAuto;
  CompileOptions compile;
  bool color = false;
  bool quiet = false;
};

// From the third argument on. Nothing, with kUsage (or kSizeLimit) reported, if the command line is
// wrong; with `wants_help` nothing else was looked at.
std::optional<RenderOptions> ReadRenderOptions(int argc, const char* const* argv, bool& wants_help,
                                               Diagnostics& diagnostics);

}  // namespace texgraph::cli
