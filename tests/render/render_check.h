// SPDX-License-Identifier: Apache-2.0
// The GPU against the CPU: prints a module as GLSL, draws it, evaluates the same module at the
// inputs that the GPU interpolated, and says how far the two are apart. The module is evaluated as
// it is given and legalised afterwards, so that Legalize and PrintGlsl are under test too.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compiler/glsl/print_glsl.h"
#include "compiler/ir/module.h"
#include "compiler/textures/texels.h"
#include "runtime/render.h"
#include "tests/fuzz/rounding_noise.h"

namespace texgraph::test {

struct CheckOptions {
  uint32_t width = 64;  // even numbers, up to runtime::kTileSide
  uint32_t height = 64;
  std::array<double, 4> window = {0, 0, 1, 1};
  double time = 0;
  glsl::Dialect dialect = glsl::Dialect::k330;
  runtime::ContextOptions context;
  // Drivers may reassociate and factor what a shader says. With this, outputs and local variables
  // are declared `precise` for the check, so that operations of the exact class agree to the bit;
  // without it the shader is drawn as it is emitted.
  bool precise = true;
  // By the name of the global. Made with TextureOptions::as_float they differ by nothing but the
  // filter.
  std::map<std::string, std::shared_ptr<const textures::TextureData>> textures;
  // Uniforms with other values than their defaults: words as in the module.
  std::map<std::string, std::vector<uint32_t>> uniforms;
  // If set, how far each value may be off is found out: OutputDifference::slack.
  std::optional<fuzz::NoiseOptions> slack;
};

struct OutputDifference {
  std::string name;
  uint32_t width = 1;  // components
  std::vector<float>
      cpu;  // component c of pixel (x, y) at [(y * W + x) * width + c], y from the bottom
  std::vector<float> gpu;
  uint64_t identical = 0;  // values that are equal to the bit; +0 equals -0, any NaN any other
  uint64_t max_ulp =
      0;  // units in the last place between floats next to each other; a NaN against a number: 2^32
  double max_abs = 0;  // infinite for a NaN or an infinity against another value
  uint32_t worst = 0;  // the index of the value with the largest difference
  // By value: what roundings may do to it; infinite where something on the way is not defined on a
  // GPU. Empty unless CheckOptions::slack is set.
  std::vector<double> slack;
  uint64_t CountBeyond(double tolerance) const;  // values that differ by more
  uint64_t CountBeyondSlack() const;
};

struct CheckReport {
  std::string error;  // "" if both ran; else what went wrong, and the shader
  std::string glsl;   // as it was drawn
  std::vector<OutputDifference> outputs;
  // The outputs' differences for a message: sizes, places and values.
  std::string Text() const;
  uint64_t max_ulp() const;
  double max_abs() const;
};

struct CheckCase {
  ir::Module* module;  // is legalised
  CheckOptions options;
};

CheckReport CompareCpuAndGpu(ir::Module& module, const CheckOptions& options = {});
// Many at once, in few processes.
std::vector<CheckReport> CompareCpuAndGpu(std::span<const CheckCase> cases);

// The shader with `precise` before what computes floats.
std::string MakePrecise(const std::string& glsl, std::span<const std::string> outputs);

// Units in the last place between two floats, as in OutputDifference::max_ulp.
uint64_t UlpDistance(float a, float b);

// What the GPU interpolates: vectors of the lanes in quads, as ir::EvaluateInputs wants them.
struct Surface {
  std::vector<uint32_t> uv;        // 2 words a lane
  std::vector<uint32_t> position;  // 3 words
  std::vector<uint32_t> normal;    // 3 words
};
// Kept for the next call with the same size, window and context. Null, with the reason in `error`,
// if nothing can be drawn.
const Surface* InterpolatedSurface(const CheckOptions& options, std::string& error);
// The pixel of lane `lane` in a picture of that width: x, y.
std::array<uint32_t, 2> PixelOfLane(uint32_t lane, uint32_t width);

}  // namespace texgraph::test
