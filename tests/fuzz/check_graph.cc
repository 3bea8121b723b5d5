// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/check_graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <random>

#include "compiler/base/files.h"
#include "compiler/ir/verify.h"
#include "compiler/passes/passes.h"
#include "compiler/spirv/compile_spirv.h"
#include "tests/fuzz/glslang_check.h"
#include "tests/fuzz/graph_textures.h"
#include "tests/fuzz/rounding_noise.h"
#include "tests/scan/implicit_samples.h"

// For the members of LoweredText.
#include "compiler/blocks/block.h"
#include "compiler/graph/checked_graph.h"

namespace texgraph::fuzz {
namespace {

using Words = std::vector<uint32_t>;

// More operations for a pixel would take seconds to evaluate, or minutes.
constexpr uint64_t kMostOperations = 500'000;
constexpr uint32_t kLanes = 64;
constexpr double kLoose = 0.01;

struct Attempt {
  Sources sources;
  Diagnostics diagnostics;
  std::optional<Compiled> compiled;
  std::string Messages() const { return FormatDiagnostics(diagnostics, sources, false); }
};

void CompileText(const std::string& text, graph::DocumentFormat format, const std::string& path,
                 const CompileOptions& options, Attempt& attempt) {
  const SourceId source = attempt.sources.Add(path, text);
  attempt.compiled = Compile(source, format, options, attempt.sources, attempt.diagnostics);
}

// What a layer cannot know when the shader is made it may warn of, and of what is the same wherever
// a function port asks: random graphs connect anything.
bool OnlyExpectedWarnings(const Diagnostics& diagnostics) {
  return std::ranges::all_of(diagnostics.all(), [](const Diagnostic& diagnostic) {
    return diagnostic.kind == DiagnosticKind::kNotComputed ||
           diagnostic.kind == DiagnosticKind::kBelowComputed ||
           diagnostic.kind == DiagnosticKind::kIgnoredCoordinate;
  });
}

// Strings of the graph's author are not in the shader.
std::string StrangeBytes(const std::string& glsl) {
  for (unsigned char c : glsl) {
    if (c != '\n' && (c < 0x20 || c > 0x7e)) return fmt::format("byte {} in the shader", int{c});
  }
  if (glsl.find("#error") != std::string::npos) return "a description in the shader";
  return "";
}

std::string CheckOutput(const Compiled& compiled, const CompileOptions& options) {
  if (std::string strange = StrangeBytes(compiled.glsl); !strange.empty()) return strange;
  if (!nlohmann::json::accept(compiled.manifest)) return "the manifest is no JSON";
  if (options.target == Target::kSpirv) {
    const auto found = scan::FindImplicitSamples(compiled.spirv);
    if (!found) return "spirv-opt cannot inline the shader";
    return found->mistakes.empty() ? "" : found->mistakes.front();
  }
  std::string shader = compiled.glsl;
  if (options.emit == Emit::kFunction) {
    shader = (options.target == Target::kGlsl330 ? "#version 330\n" : "#version 450 core\n") +
             shader + "\nvoid main() {}\n";
  }
  return GlslangComplaint(shader);
}

// To SPIR-V, and to both dialects, of which one is a function: which one changes from seed to seed.
// "" and perhaps report.limit, or what is wrong.
std::string CheckTargets(const std::string& text, graph::DocumentFormat format,
                         const std::string& path, uint32_t seed, GraphReport& report) {
  const bool is_odd = seed % 2 != 0;
  const std::pair<Target, Emit> forms[] = {
      {Target::kGlsl330, is_odd ? Emit::kFunction : Emit::kShader},
      {Target::kGlsl450, is_odd ? Emit::kShader : Emit::kFunction},
      {Target::kSpirv, Emit::kShader}};
  for (const auto& [target, emit] : forms) {
    CompileOptions options;
    options.target = target;
    options.emit = emit;
    Attempt attempt;
    CompileText(text, format, path, options, attempt);
    const std::string form = fmt::format("target {}, {}: ", static_cast<int>(target),
                                         emit == Emit::kShader ? "shader" : "function");
    if (!attempt.compiled || !OnlyExpectedWarnings(attempt.diagnostics)) {
      report.limit = ReachedLimit(attempt.diagnostics);
      if (!report.limit.empty()) return "";
      return form + "refused\n" + attempt.Messages();
    }
    if (std::string wrong = CheckOutput(*attempt.compiled, options); !wrong.empty()) {
      return form + wrong + "\n" + attempt.compiled->glsl;
    }
  }
  return "";
}

// --- Optimised and not ---------------------------------------------------------------------------

// Quads at places of all kinds: near and far, around the origin and away from it.
std::map<std::string, Words> SurfaceInputs(uint32_t seed) {
  std::mt19937 random(seed);
  const auto number = [&](float low, float high) {
    return low + (high - low) * static_cast<float>(random() % 65536) / 65536.0f;
  };
  std::map<std::string, Words> inputs;
  inputs["uv"].resize(2 * kLanes);
  inputs["position"].resize(3 * kLanes);
  inputs["normal"].resize(3 * kLanes);
  for (uint32_t quad = 0; quad < kLanes / 4; ++quad) {
    const float pixel = quad % 2 == 0 ? 1.0f / 256 : number(0.05f, 0.6f);
    const float u = number(-2, 3), v = number(-2, 3), z = number(-1, 1), turn = number(0, 6);
    for (uint32_t l = 0; l < 4; ++l) {
      const uint32_t lane = 4 * quad + l;
      const float x = u + pixel * static_cast<float>(l % 2);
      const float y = v + pixel * static_cast<float>(l / 2);
      const float place[] = {x, y, z}, normal[] = {std::cos(turn), std::sin(turn), 0};
      for (uint32_t c = 0; c < 3; ++c) {
        if (c < 2) inputs["uv"][c * kLanes + lane] = std::bit_cast<uint32_t>(place[c]);
        inputs["position"][c * kLanes + lane] = std::bit_cast<uint32_t>(place[c]);
        inputs["normal"][c * kLanes + lane] = std::bit_cast<uint32_t>(normal[c]);
      }
    }
  }
  inputs["time"] = {std::bit_cast<uint32_t>(number(0, 4))};
  return inputs;
}

struct ModuleInputs {
  ir::EvaluateInputs values;
  std::vector<std::unique_ptr<ir::Texture>> textures;
};

ModuleInputs InputsOf(const ir::Module& module, const std::map<std::string, Words>& surface,
                      const GraphTextures& textures) {
  ModuleInputs inputs;
  inputs.values.lanes = kLanes;
  for (const ir::Global& global : module.globals) {
    const auto value = surface.find(global.name);
    inputs.values.globals.push_back(value == surface.end() ? Words() : value->second);
    inputs.values.textures.push_back(nullptr);
    const auto texture = textures.find(global.name);
    if (global.kind != ir::GlobalKind::kTexture || texture == textures.end()) continue;
    inputs.textures.push_back(std::make_unique<ir::Texture>(ToTexture(*texture->second)));
    inputs.values.textures.back() = inputs.textures.back().get();
  }
  return inputs;
}

std::string CompareResults(const ir::Function& main, const NoisyResults& plain,
                           const std::vector<Words>& optimized, GraphReport& report) {
  for (size_t r = 0; r < plain.words.size(); ++r) {
    for (size_t i = 0; i < plain.words[r].size(); ++i) {
      const float a = std::bit_cast<float>(plain.words[r][i]);
      const float b = std::bit_cast<float>(optimized[r][i]);
      ++report.values;
      // No number either way is no difference, and says little.
      if (std::isnan(a) && std::isnan(b)) {
        ++report.loose;
        continue;
      }
      if (plain.slack[r][i] > kLoose) ++report.loose;
      if (a == b || std::fabs(double{a} - b) <= plain.slack[r][i]) continue;
      const size_t lane = i % kLanes;
      // The lanes of a quad share the levels of its samples.
      // Nor is what rounding may turn into no number at all.
      const bool undefined = plain.undefined[lane / 4 * 4] || plain.undefined[lane / 4 * 4 + 1] ||
                             plain.undefined[lane / 4 * 4 + 2] ||
                             plain.undefined[lane / 4 * 4 + 3] || std::isnan(plain.slack[r][i]);
      if (undefined) {
        ++report.undefined;
        continue;
      }
      return fmt::format(
          "output {}, component {}, lane {}: {:.9g} is {:.9g} when optimised, slack {:g}",
          main.results[r].name, i / kLanes, lane, a, b, plain.slack[r][i]);
    }
  }
  return "";
}

bool SamplesImplicitly(const ir::Module& module) {
  return std::ranges::any_of(module.functions, [](const ir::Function& function) {
    return std::ranges::any_of(function.insts,
                               [](const ir::Inst& inst) { return inst.op == ir::Op::kSample; });
  });
}

std::string CheckOptimizer(const std::string& text, graph::DocumentFormat format,
                           const std::string& path, uint32_t seed, GraphReport& report) {
  CompileOptions options;
  options.target = seed % 2 == 0 ? Target::kGlsl330 : Target::kGlsl450;
  LoweredText optimized, plain;
  LowerText(text, format, path, options, optimized);
  options.optimize = false;
  LowerText(text, format, path, options, plain);
  if (!plain.lowered || !optimized.lowered) {
    report.limit = ReachedLimit(plain.diagnostics);
    return report.limit.empty() ? "not lowered without optimising\n" + plain.Errors() : "";
  }
  for (const LoweredText* lowered : {&plain, &optimized}) {
    const std::string wrong = ir::Verify(*lowered->lowered->module);
    if (!wrong.empty()) return "malformed: " + wrong;
  }
  report.costly = passes::OperationsForAPixel(*plain.lowered->module) > kMostOperations;
  if (report.costly) return "";
  const auto surface = SurfaceInputs(seed);
  const ir::Module& module = *plain.lowered->module;
  const ir::Module& optimized_module = *optimized.lowered->module;
  // What is known to be continuous only when it is optimised is sampled with differences between
  // pixels there, and with derivatives here: the levels then differ, and are left out.
  const bool mipmaps = !SamplesImplicitly(module) && !SamplesImplicitly(optimized_module);
  const GraphTextures textures =
      LoadGraphTextures(*plain.lowered->graph, std::string(FolderOf(path)), mipmaps);
  const ModuleInputs plain_inputs = InputsOf(module, surface, textures);
  const ModuleInputs inputs = InputsOf(optimized_module, surface, textures);
  const NoisyResults expected = EvaluateWithNoise(module, plain_inputs.values);
  const auto actual = ir::Evaluate(optimized_module, optimized_module.main, inputs.values);
  return CompareResults(module[module.main], expected, actual, report);
}

}  // namespace

std::string ReachedLimit(const Diagnostics& diagnostics) {
  std::string limit;
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    if (diagnostic.severity == Severity::kWarning) continue;
    // Which numbers come to a port is not known when a random graph is made.
    const bool beyond = diagnostic.kind == DiagnosticKind::kPatternRange;
    if (DiagnosticExit(diagnostic.kind) != ExitCode::kLimit && !beyond) return "";
    limit = DiagnosticName(diagnostic.kind);
  }
  return limit;
}

void LowerText(const std::string& text, graph::DocumentFormat format, const std::string& path,
               const CompileOptions& options, LoweredText& result) {
  const SourceId source = result.sources.Add(path, text);
  auto lowered = Lower(source, format, options, result.sources, result.diagnostics);
  if (lowered) result.lowered.emplace(std::move(*lowered));
}

GraphReport CheckValidGraph(const std::string& text, graph::DocumentFormat format,
                            const std::string& path, uint32_t seed) {
  GraphReport report;
  report.failure = CheckTargets(text, format, path, seed, report);
  if (!report.failure.empty() || !report.limit.empty()) return report;
  report.failure = CheckOptimizer(text, format, path, seed, report);
  return report;
}

std::string CheckBrokenGraph(const std::string& text, graph::DocumentFormat format,
                             const std::string& path) {
  CompileOptions options;
  options.target = Target::kGlsl450;
  std::string first;
  for (int run = 0; run < 2; ++run) {
    Attempt attempt;
    CompileText(text, format, path, options, attempt);
    if (attempt.compiled.has_value() == attempt.diagnostics.HasErrors()) {
      return attempt.compiled ? "compiled in spite of errors" : "refused without a word";
    }
    const std::string messages = attempt.Messages();
    for (unsigned char c : messages) {
      if (c < 0x20 && c != '\n') return fmt::format("control character {} in a message", int{c});
    }
    for (const Diagnostic& diagnostic : attempt.diagnostics.all()) {
      const SourceRange& range = diagnostic.range;
      if (!range.source.valid()) return "a message without a place: " + messages;
      const size_t size = attempt.sources.Text(range.source).size();
      if (range.begin > range.end || range.end > size + 1)
        return "a place beyond the text: " + messages;
    }
    std::string answer = messages;
    if (attempt.compiled) answer += attempt.compiled->glsl + attempt.compiled->manifest;
    if (run > 0 && answer != first) return "two answers to one text:\n" + first + "\n" + answer;
    if (run == 0 && attempt.compiled) {
      const std::string wrong = CheckOutput(*attempt.compiled, options);
      if (!wrong.empty()) return "valid, but " + wrong + "\n" + attempt.compiled->glsl;
    }
    first = std::move(answer);
  }
  return "";
}

}  // namespace texgraph::fuzz
