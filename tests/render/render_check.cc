// SPDX-License-Identifier: Apache-2.0
#include "tests/render/render_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "compiler/glsl/legalize.h"
#include "compiler/ir/evaluate.h"

namespace texgraph::test {
namespace {

using runtime::ManifestParameter;
using runtime::RenderRequest;
using runtime::RenderResult;
using Words = std::vector<uint32_t>;

std::string ErrorText(const Diagnostics& diagnostics) {
  return FormatDiagnostics(diagnostics, Sources(), false);
}

RenderRequest RequestFor(const CheckOptions& options) {
  RenderRequest request;
  request.width = options.width;
  request.height = options.height;
  request.window = options.window;
  request.time = options.time;
  request.context = options.context;
  request.format = runtime::PixelFormat::kFloat;
  return request;
}

RenderRequest SurfaceRequest(const CheckOptions& options) {
  RenderRequest request = RequestFor(options);
  request.shader =
      "#version 330 core\n"
      "in vec2 uv; in vec3 position; in vec3 normal;\n"
      "layout(location = 0) out vec2 out_uv;\n"
      "layout(location = 1) out vec3 out_position;\n"
      "layout(location = 2) out vec3 out_normal;\n"
      "void main() { out_uv = uv; out_position = position; out_normal = normal; }\n";
  request.manifest.inputs = {
      {"uv", "", ir::kVec2, {}}, {"position", "", ir::kVec3, {}}, {"normal", "", ir::kVec3, {}}};
  request.manifest.outputs = {{"uv", "out_uv", ir::kVec2},
                              {"position", "out_position", ir::kVec3},
                              {"normal", "out_normal", ir::kVec3}};
  request.outputs = {"uv", "position", "normal"};
  return request;
}

Words LaneWords(const runtime::RenderedOutput& output, uint32_t width, uint32_t lanes) {
  Words words(size_t{output.channels} * lanes);
  for (uint32_t lane = 0; lane < lanes; ++lane) {
    const auto [x, y] = PixelOfLane(lane, width);
    for (uint32_t c = 0; c < output.channels; ++c) {
      words[size_t{c} * lanes + lane] =
          std::bit_cast<uint32_t>(output.floats[4 * (size_t{y} * width + x) + c]);
    }
  }
  return words;
}

// --- The CPU's side
// ------------------------------------------------------------------------------------------------

// Textures decoded once for each check; they live as long as the evaluation.
struct Inputs {
  ir::EvaluateInputs values;
  std::vector<std::unique_ptr<ir::Texture>> textures;
};

void FillGlobal(const ir::Global& global, const CheckOptions& options, const Surface& surface,
                size_t index, Inputs& inputs) {
  switch (global.kind) {
    case ir::GlobalKind::kInput:
      if (global.name == "uv") inputs.values.globals[index] = surface.uv;
      if (global.name == "position") inputs.values.globals[index] = surface.position;
      if (global.name == "normal") inputs.values.globals[index] = surface.normal;
      return;
    case ir::GlobalKind::kUniform:
      if (global.name == "time") {
        inputs.values.globals[index] = {std::bit_cast<uint32_t>(static_cast<float>(options.time))};
      } else if (const auto set = options.uniforms.find(global.name);
                 set != options.uniforms.end()) {
        inputs.values.globals[index] = set->second;
      }
      return;
    case ir::GlobalKind::kSpecialization:
      return;
    case ir::GlobalKind::kTexture:
      if (const auto data = options.textures.find(global.name); data != options.textures.end()) {
        inputs.textures.push_back(std::make_unique<ir::Texture>(ToTexture(*data->second)));
        inputs.values.textures[index] = inputs.textures.back().get();
      }
      return;
  }
}

fuzz::NoisyResults RunOnCpu(const ir::Module& module, const CheckOptions& options,
                            const Surface& surface) {
  Inputs inputs;
  inputs.values.lanes = options.width * options.height;
  inputs.values.globals.resize(module.globals.size());
  inputs.values.textures.resize(module.globals.size());
  for (size_t i = 0; i < module.globals.size(); ++i) {
    FillGlobal(module.globals[i], options, surface, i, inputs);
  }
  if (options.slack) return fuzz::EvaluateWithNoise(module, inputs.values, *options.slack);
  fuzz::NoisyResults results;
  results.words = ir::Evaluate(module, module.main, inputs.values);
  return results;
}

// --- The GPU's side
// ------------------------------------------------------------------------------------------------

std::vector<double> Numbers(const ir::Module& module, const ir::Global& global,
                            const CheckOptions& options) {
  Words words;
  if (const auto set = options.uniforms.find(global.name); set != options.uniforms.end()) {
    words = set->second;
  } else if (global.value.valid()) {
    const auto value = module.Words(global.value);
    words.assign(value.begin(), value.end());
  } else {
    words.assign(module.types.Words(global.type), 0);
  }
  const ir::Scalar scalar =
      ir::IsVector(global.type) ? ir::ScalarOf(global.type) : ir::Scalar::kFloat;
  std::vector<double> numbers;
  for (uint32_t word : words) {
    if (scalar == ir::Scalar::kFloat) {
      numbers.push_back(std::bit_cast<float>(word));
    } else if (scalar == ir::Scalar::kInt) {
      numbers.push_back(std::bit_cast<int32_t>(word));
    } else {
      numbers.push_back(word);
    }
  }
  return numbers;
}

std::optional<uint32_t> Location(uint32_t location) {
  if (location == glsl::ShaderInterface::kNone) return std::nullopt;
  return location;
}

RenderRequest ShaderRequestFor(const ir::Module& module, const CheckOptions& options,
                               CheckReport& report) {
  glsl::PrintOptions print;
  print.dialect = options.dialect;
  print.name = "check";
  glsl::ShaderInterface shader;
  report.glsl = glsl::PrintGlsl(module, print, &shader);

  if (options.precise) {
    std::vector<std::string> outputs;
    for (const auto& output : shader.outputs) outputs.push_back(output.name);
    report.glsl = MakePrecise(report.glsl, outputs);
  }
  RenderRequest request = RequestFor(options);
  request.shader = report.glsl;
  runtime::Manifest& manifest = request.manifest;
  manifest.dialect = options.dialect == glsl::Dialect::k330 ? runtime::ShaderDialect::kGlsl330
                                                            : runtime::ShaderDialect::kGlsl450;
  for (const auto& entry : shader.inputs) {
    const ir::Global& global = module.globals[entry.global.index];
    manifest.inputs.push_back({global.name, entry.name, global.type, Location(entry.location)});
  }
  for (const auto& entry : shader.uniforms) {
    const ir::Global& global = module.globals[entry.global.index];
    if (global.name == "time") {
      manifest.inputs.push_back({global.name, entry.name, global.type, {}});
      continue;
    }
    ManifestParameter& parameter = manifest.parameters.emplace_back();
    parameter.name = global.name;
    parameter.variable = entry.name;
    parameter.type = global.type;
    parameter.is_uniform = true;
    parameter.value = Numbers(module, global, options);
  }
  for (const auto& entry : shader.textures) {
    const ir::Global& global = module.globals[entry.global.index];
    runtime::ManifestTexture& texture = manifest.textures.emplace_back();
    texture.name = global.name;
    texture.variable = entry.name;
    if (const auto data = options.textures.find(global.name); data != options.textures.end()) {
      request.textures.push_back({entry.name, data->second});
    }
  }
  const auto& results = module[module.main].results;
  for (size_t i = 0; i < results.size(); ++i) {
    manifest.outputs.push_back({results[i].name, shader.outputs[i].name, results[i].type});
    request.outputs.push_back(results[i].name);
  }
  return request;
}

// --- Comparing
// -----------------------------------------------------------------------------------------------------

// By value, as OutputDifference has them. All lanes of a quad share the levels of its samples.
std::vector<double> SlackOf(const fuzz::NoisyResults& cpu, size_t result, uint32_t channels,
                            const CheckOptions& options) {
  const uint32_t lanes = options.width * options.height;
  std::vector<double> slack(size_t{lanes} * channels);
  for (uint32_t lane = 0; lane < lanes; ++lane) {
    const auto [x, y] = PixelOfLane(lane, options.width);
    bool undefined = false;
    for (uint32_t l = 0; l < 4; ++l) undefined = undefined || cpu.undefined[lane / 4 * 4 + l];
    for (uint32_t c = 0; c < channels; ++c) {
      slack[(size_t{y} * options.width + x) * channels + c] =
          undefined ? std::numeric_limits<double>::infinity()
                    : cpu.slack[result][size_t{c} * lanes + lane];
    }
  }
  return slack;
}

void Compare(const Words& cpu, const runtime::RenderedOutput& gpu, const CheckOptions& options,
             OutputDifference& difference) {
  const uint32_t lanes = options.width * options.height;
  const uint32_t width = gpu.channels;
  difference.name = gpu.name;
  difference.width = width;
  difference.cpu.resize(size_t{lanes} * width);
  difference.gpu.resize(size_t{lanes} * width);
  for (uint32_t lane = 0; lane < lanes; ++lane) {
    const auto [x, y] = PixelOfLane(lane, options.width);
    const size_t pixel = size_t{y} * options.width + x;
    for (uint32_t c = 0; c < width; ++c) {
      difference.cpu[pixel * width + c] = std::bit_cast<float>(cpu[size_t{c} * lanes + lane]);
      difference.gpu[pixel * width + c] = gpu.floats[pixel * 4 + c];
    }
  }
  for (size_t i = 0; i < difference.cpu.size(); ++i) {
    const float a = difference.cpu[i];
    const float b = difference.gpu[i];
    const uint64_t ulp = UlpDistance(a, b);
    if (ulp == 0) {
      ++difference.identical;
      continue;
    }
    const double distance = std::isfinite(a) && std::isfinite(b)
                                ? std::abs(static_cast<double>(a) - b)
                                : std::numeric_limits<double>::infinity();
    if (distance > difference.max_abs) difference.worst = static_cast<uint32_t>(i);
    difference.max_abs = std::max(difference.max_abs, distance);
    difference.max_ulp = std::max(difference.max_ulp, ulp);
  }
}

void Finish(const RenderResult& result, const fuzz::NoisyResults& cpu, const CheckOptions& options,
            CheckReport& report) {
  if (!result.ok()) {
    report.error = ErrorText(result.diagnostics) + result.driver_log + "\n" + report.glsl;
    return;
  }
  for (size_t i = 0; i < result.outputs.size(); ++i) {
    OutputDifference& difference = report.outputs.emplace_back();
    Compare(cpu.words[i], result.outputs[i], options, difference);
    if (options.slack) difference.slack = SlackOf(cpu, i, difference.width, options);
  }
}

}  // namespace

std::string MakePrecise(const std::string& glsl, std::span<const std::string> outputs) {
  static constexpr std::string_view kFloats[] = {"float ", "vec2 ", "vec3 ", "vec4 ",
                                                 "mat2 ",  "mat3 ", "mat4 "};
  std::string text;
  for (size_t begin = 0; begin < glsl.size();) {
    const size_t end = std::min(glsl.find('\n', begin), glsl.size() - 1) + 1;
    const std::string_view line = std::string_view(glsl).substr(begin, end - begin);
    begin = end;
    const size_t indent = line.find_first_not_of(' ');
    const bool initialized = indent != std::string_view::npos && indent > 0 &&
                             line.find(" = ") != std::string_view::npos;
    if (line.starts_with("void main()")) {
      for (const std::string& output : outputs) text += "precise " + output + ";\n";
    }
    if (initialized &&
        std::any_of(std::begin(kFloats), std::end(kFloats),
                    [&](std::string_view type) { return line.substr(indent).starts_with(type); })) {
      text += std::string(line.substr(0, indent)) + "precise ";
      text += line.substr(indent);
      continue;
    }
    text += line;
    // `precise` is of GLSL 4.00; the extension brings it to 3.30.
    if (line.starts_with("#version 330")) text += "#extension GL_ARB_gpu_shader5 : require\n";
  }
  return text;
}

uint64_t UlpDistance(float a, float b) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b) ? 0 : uint64_t{1} << 32;
  const auto order = [](float value) {
    const auto bits = std::bit_cast<int32_t>(value);
    return bits < 0 ? -static_cast<int64_t>(bits & 0x7fffffff) : static_cast<int64_t>(bits);
  };
  return static_cast<uint64_t>(std::abs(order(a) - order(b)));
}

std::array<uint32_t, 2> PixelOfLane(uint32_t lane, uint32_t width) {
  const uint32_t quad = lane / 4;
  const uint32_t quads_in_row = width / 2;
  return {2 * (quad % quads_in_row) + lane % 2, 2 * (quad / quads_in_row) + lane / 2 % 2};
}

const Surface* InterpolatedSurface(const CheckOptions& options, std::string& error) {
  static std::map<std::string, Surface> surfaces;
  const auto& window = options.window;
  const std::string key =
      fmt::format("{} {} {} {} {} {} {} {} {}", options.width, options.height, window[0], window[1],
                  window[2], window[3], static_cast<int>(options.context.choice),
                  options.context.egl_library, options.context.osmesa_library);
  if (const auto known = surfaces.find(key); known != surfaces.end()) return &known->second;
  if (options.width % 2 != 0 || options.height % 2 != 0 || options.width > runtime::kTileSide ||
      options.height > runtime::kTileSide) {
    error = "checked pictures have even sides of a tile at most";
    return nullptr;
  }
  const RenderResult result = Render(SurfaceRequest(options));
  if (!result.ok()) {
    error = ErrorText(result.diagnostics) + result.driver_log;
    return nullptr;
  }
  const uint32_t lanes = options.width * options.height;
  Surface& surface = surfaces[key];
  surface.uv = LaneWords(result.outputs[0], options.width, lanes);
  surface.position = LaneWords(result.outputs[1], options.width, lanes);
  surface.normal = LaneWords(result.outputs[2], options.width, lanes);
  return &surface;
}

std::vector<CheckReport> CompareCpuAndGpu(std::span<const CheckCase> cases) {
  std::vector<CheckReport> reports(cases.size());
  std::vector<fuzz::NoisyResults> cpu(cases.size());
  std::vector<RenderRequest> requests;
  std::vector<size_t> request_of;
  for (size_t i = 0; i < cases.size(); ++i) {
    ir::Module& module = *cases[i].module;
    const Surface* surface = InterpolatedSurface(cases[i].options, reports[i].error);
    if (surface == nullptr) continue;
    cpu[i] = RunOnCpu(module, cases[i].options, *surface);
    Diagnostics diagnostics;
    if (!glsl::Legalize(module, cases[i].options.dialect, diagnostics)) {
      reports[i].error = ErrorText(diagnostics);
      continue;
    }
    requests.push_back(ShaderRequestFor(module, cases[i].options, reports[i]));
    request_of.push_back(i);
  }
  const std::vector<RenderResult> results = RenderAll(requests);
  for (size_t r = 0; r < results.size(); ++r) {
    const size_t i = request_of[r];
    Finish(results[r], cpu[i], cases[i].options, reports[i]);
  }
  return reports;
}

CheckReport CompareCpuAndGpu(ir::Module& module, const CheckOptions& options) {
  const CheckCase one{&module, options};
  return std::move(CompareCpuAndGpu(std::span<const CheckCase>(&one, 1))[0]);
}

uint64_t OutputDifference::CountBeyond(double tolerance) const {
  uint64_t count = 0;
  for (size_t i = 0; i < cpu.size(); ++i) {
    if (UlpDistance(cpu[i], gpu[i]) == 0) continue;
    const double distance = std::abs(static_cast<double>(cpu[i]) - gpu[i]);
    if (!(distance <= tolerance)) ++count;
  }
  return count;
}

uint64_t OutputDifference::CountBeyondSlack() const {
  uint64_t count = 0;
  for (size_t i = 0; i < slack.size(); ++i) {
    if (UlpDistance(cpu[i], gpu[i]) == 0 || std::isinf(slack[i])) continue;
    const double distance = std::abs(static_cast<double>(cpu[i]) - gpu[i]);
    if (!(distance <= slack[i])) ++count;
  }
  return count;
}

uint64_t CheckReport::max_ulp() const {
  uint64_t most = 0;
  for (const OutputDifference& output : outputs) most = std::max(most, output.max_ulp);
  return most;
}

double CheckReport::max_abs() const {
  double most = 0;
  for (const OutputDifference& output : outputs) most = std::max(most, output.max_abs);
  return most;
}

std::string CheckReport::Text() const {
  if (!error.empty()) return error;
  std::string text;
  for (const OutputDifference& output : outputs) {
    text += fmt::format("{}: {} of {} values identical, at most {} ulp and {:g} apart", output.name,
                        output.identical, output.cpu.size(), output.max_ulp, output.max_abs);
    if (output.identical != output.cpu.size()) {
      text += fmt::format("; worst at pixel {}, component {}: CPU {:.9g}, GPU {:.9g}",
                          output.worst / output.width, output.worst % output.width,
                          output.cpu[output.worst], output.gpu[output.worst]);
    }
    text += '\n';
  }
  return text;
}

}  // namespace texgraph::test
