// SPDX-License-Identifier: Apache-2.0
// Our shader against one that a person wrote for the same picture: both as SPIR-V after spirv-opt
// -O, and both drawn.
#include "tests/bench/measure_shader.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <span>
#include <vector>

#include "compiler/base/files.h"
#include "compiler/compile.h"
#include "compiler/spirv/compile_spirv.h"
#include "runtime/render.h"
#include "tests/bench/spirv_weight.h"

namespace texgraph::bench {
namespace {

constexpr uint32_t kSide = 1024;
constexpr int kFrames = 4;
// Rounds go on until so many in a row were no faster by 1 %: other work of the machine disturbs
// some.
constexpr int kQuietRounds = 12, kMaxRounds = 60;

}  // namespace

double MeanDifference(const textures::Image& a, const textures::Image& b) {
  double sum = 0;
  for (size_t i = 0; i < a.pixels.size(); ++i) sum += std::abs(int(a.pixels[i]) - int(b.pixels[i]));
  return sum / static_cast<double>(a.pixels.size());
}

Drawn DrawInTurns(std::vector<runtime::RenderRequest> requests, int quiet_rounds) {
  Drawn drawn;
  drawn.frame_ms.assign(requests.size(), 1e9);
  drawn.pictures.resize(requests.size());
  int quiet = 0;
  for (int round = 0; round < kMaxRounds && quiet < quiet_rounds; ++round) {
    ++quiet;
    for (size_t which = 0; which < requests.size(); ++which) {
      requests[which].timed_frames = kFrames;
      runtime::RenderResult result = runtime::Render(requests[which]);
      if (!result.ok()) {
        drawn.error = result.diagnostics.all().front().message + "\n" + result.driver_log;
        return drawn;
      }
      drawn.renderer = result.context;
      for (double seconds : result.frame_seconds) {
        if (1000 * seconds < 0.99 * drawn.frame_ms[which]) quiet = 0;
        drawn.frame_ms[which] = std::min(drawn.frame_ms[which], 1000 * seconds);
      }
      drawn.pictures[which] = result.outputs[0].image;
    }
  }
  return drawn;
}

Drawable Prepare(const std::string& path, std::string_view text,
                 const std::vector<std::string>& settings) {
  Drawable drawable;
  Sources sources;
  Diagnostics diagnostics;
  auto fail = [&](std::string what) {
    drawable.error = std::move(what) + "\n" + FormatDiagnostics(diagnostics, sources, false);
    return drawable;
  };
  SourceId source = sources.Add(path, std::string(text));
  CompileOptions options;
  options.target = Target::kSpirv;
  options.manifest_folder = std::string(FolderOf(path));
  options.settings = settings;
  options.derive_textures = true;
  auto ours = Compile(source, graph::FormatOf(path, text), options, sources, diagnostics);
  if (!ours) return fail("the graph does not compile");
  std::optional<Weight> weight = WeightOf(ours->spirv);
  if (!weight) return fail("spirv-opt fails");
  drawable.weight = *weight;
  SourceId manifest_source = sources.Add("manifest", ours->manifest);
  auto document =
      graph::ReadDocument(manifest_source, graph::DocumentFormat::kJson, sources, diagnostics);
  if (!document) return fail("the manifest cannot be read");
  auto manifest = runtime::ReadManifest(*document, diagnostics);
  if (!manifest) return fail("the manifest cannot be read");
  manifest->dialect = runtime::ShaderDialect::kGlsl450;
  runtime::RenderRequest& request = drawable.request;
  request.shader = ours->glsl;
  request.manifest = *manifest;
  request.width = request.height = kSide;
  runtime::MadeTextures made;
  for (const Compiled::Texture& texture : ours->textures) made.emplace(texture.file, texture.data);
  if (!runtime::LoadTextures(*manifest, options.manifest_folder, request.textures, diagnostics, {},
                             made)) {
    return fail("the pictures cannot be read");
  }
  return drawable;
}

ShaderFigures CompareShaders(const std::string& path, std::string_view text,
                             std::span<const std::string> others, int quiet_rounds) {
  ShaderFigures figures;
  const Drawable ours = Prepare(path, text);
  figures.name = ours.request.manifest.name;
  figures.error = ours.error;
  if (!figures.error.empty()) return figures;
  std::vector<runtime::RenderRequest> requests = {ours.request};
  std::vector<Weight> weights = {ours.weight};
  for (const std::string& other : others) {
    Diagnostics diagnostics;
    auto theirs = spirv::CompileSpirv(other, diagnostics);
    auto weight = theirs ? WeightOf(*theirs) : std::nullopt;
    if (!weight) {
      figures.error = "the reference does not compile";
      if (diagnostics.HasErrors()) figures.error += ": " + diagnostics.all().front().message;
      return figures;
    }
    weights.push_back(*weight);
    requests.push_back(ours.request);
    requests.back().shader = other;
  }
  for (size_t i = 0; i < weights.size(); ++i) {
    figures.instructions[i] = weights[i].instructions;
    figures.samples[i] = weights[i].samples;
  }
  Drawn drawn = DrawInTurns(std::move(requests), quiet_rounds);
  figures.error = drawn.error;
  if (!figures.error.empty()) return figures;
  figures.renderer = drawn.renderer;
  std::ranges::copy(drawn.frame_ms, figures.frame_ms);
  figures.difference = MeanDifference(drawn.pictures[0], drawn.pictures[1]);
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
