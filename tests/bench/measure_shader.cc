// SPDX-License-Identifier: Apache-2.0
// Our shader against one that a person wrote for the same picture: both as SPIR-V after spirv-opt
// -O, and both drawn.
#include "tests/bench/measure_shader.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <span>
#include <spirv-tools/optimizer.hpp>
#include <vector>

#include "compiler/base/files.h"
#include "compiler/compile.h"
#include "compiler/spirv/compile_spirv.h"
#include "runtime/render.h"

namespace texgraph::bench {
namespace {

constexpr uint32_t kSide = 1024;
constexpr int kFrames = 4;
// Rounds go on until so many in a row were no faster by 1 %: other work of the machine disturbs
// some.
constexpr int kQuietRounds = 12, kMaxRounds = 60;

// SPIR-V opcodes by number, so that no header of another version is needed.
constexpr uint32_t kOpFunction = 54, kOpFunctionEnd = 56, kOpVariable = 59, kOpLabel = 248;
constexpr uint32_t kOpImageSampleFirst = 87, kOpImageSampleLast = 94, kOpImageFetch = 95;

struct Weight {
  int instructions = 0;
  int samples = 0;
};

std::optional<Weight> WeightOf(const std::vector<uint32_t>& words) {
  spvtools::Optimizer optimizer(SPV_ENV_OPENGL_4_5);
  optimizer.RegisterPerformancePasses();
  std::vector<uint32_t> optimized;
  if (!optimizer.Run(words.data(), words.size(), &optimized)) return std::nullopt;
  Weight weight;
  bool in_function = false;
  for (size_t at = 5; at < optimized.size(); at += optimized[at] >> 16) {
    uint32_t op = optimized[at] & 0xffff;
    if (op == kOpFunction) in_function = true;
    if (in_function && op != kOpFunction && op != kOpFunctionEnd && op != kOpLabel &&
        op != kOpVariable) {
      ++weight.instructions;
    }
    if ((op >= kOpImageSampleFirst && op <= kOpImageSampleLast) || op == kOpImageFetch)
      ++weight.samples;
  }
  return weight;
}

double MeanDifference(const textures::Image& a, const textures::Image& b) {
  double sum = 0;
  for (size_t i = 0; i < a.pixels.size(); ++i) sum += std::abs(int(a.pixels[i]) - int(b.pixels[i]));
  return sum / static_cast<double>(a.pixels.size());
}

// Draws the shaders in turns, so that a machine that slows down slows all of them.
void Draw(runtime::RenderRequest request, std::span<const std::string> shaders, int quiet_rounds,
          ShaderFigures& figures) {
  request.width = request.height = kSide;
  request.timed_frames = kFrames;
  std::vector<textures::Image> pictures(shaders.size());
  std::fill_n(figures.frame_ms, shaders.size(), 1e9);
  int quiet = 0;
  for (int round = 0; round < kMaxRounds && quiet < quiet_rounds; ++round) {
    ++quiet;
    for (size_t which = 0; which < shaders.size(); ++which) {
      request.shader = shaders[which];
      runtime::RenderResult result = runtime::Render(request);
      if (!result.ok()) {
        figures.error = result.diagnostics.all().front().message + "\n" + result.driver_log;
        return;
      }
      figures.renderer = result.context;
      for (double seconds : result.frame_seconds) {
        if (1000 * seconds < 0.99 * figures.frame_ms[which]) quiet = 0;
        figures.frame_ms[which] = std::min(figures.frame_ms[which], 1000 * seconds);
      }
      pictures[which] = result.outputs[0].image;
    }
  }
  figures.difference = MeanDifference(pictures[0], pictures[1]);
}

}  // namespace

ShaderFigures CompareShaders(const std::string& path, std::string_view text,
                             std::span<const std::string> others, int quiet_rounds) {
  ShaderFigures figures;
  Sources sources;
  Diagnostics diagnostics;
  auto fail = [&](std::string what) {
    figures.error = std::move(what) + "\n" + FormatDiagnostics(diagnostics, sources, false);
    return figures;
  };
  SourceId source = sources.Add(path, std::string(text));
  CompileOptions options;
  options.target = Target::kSpirv;
  options.manifest_folder = std::string(FolderOf(path));
  auto ours = Compile(source, graph::FormatOf(path, text), options, sources, diagnostics);
  if (!ours) return fail("the graph does not compile");
  figures.name = ours->name;
  std::vector<std::string> shaders = {ours->glsl};
  std::vector<std::optional<Weight>> weights = {WeightOf(ours->spirv)};
  for (const std::string& other : others) {
    auto theirs = spirv::CompileSpirv(other, diagnostics);
    if (!theirs) return fail("the reference does not compile");
    weights.push_back(WeightOf(*theirs));
    shaders.push_back(other);
  }
  for (size_t i = 0; i < weights.size(); ++i) {
    if (!weights[i]) return fail("spirv-opt fails");
    figures.instructions[i] = weights[i]->instructions;
    figures.samples[i] = weights[i]->samples;
  }

  SourceId manifest_source = sources.Add("manifest", ours->manifest);
  auto document =
      graph::ReadDocument(manifest_source, graph::DocumentFormat::kJson, sources, diagnostics);
  if (!document) return fail("the manifest cannot be read");
  auto manifest = runtime::ReadManifest(*document, diagnostics);
  if (!manifest) return fail("the manifest cannot be read");
  manifest->dialect = runtime::ShaderDialect::kGlsl450;
  runtime::RenderRequest request;
  request.manifest = *manifest;
  if (!runtime::LoadTextures(*manifest, options.manifest_folder, request.textures, diagnostics)) {
    return fail("the pictures cannot be read");
  }
  Draw(request, shaders, quiet_rounds, figures);
  return figures;
}

ShaderFigures MeasureShader(const std::string& graph_path, const std::string& reference_path) {
  Diagnostics diagnostics;
  auto text = ReadFile(graph_path, 1 << 20, {}, diagnostics);
  auto reference = ReadFile(reference_path, 1 << 20, {}, diagnostics);
  if (!text || !reference) {
    ShaderFigures figures;
    figures.error = "cannot read the graph or its reference";
    return figures;
  }
  return CompareShaders(graph_path, *text, {&*reference, 1}, kQuietRounds);
}

}  // namespace texgraph::bench
