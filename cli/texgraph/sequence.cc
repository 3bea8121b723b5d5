// SPDX-License-Identifier: Apache-2.0
#include "cli/texgraph/sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/base/files.h"

namespace texgraph::cli {
namespace {

using runtime::ManifestParameter;

const ManifestParameter* FindUniform(const std::string& name, const runtime::Manifest& manifest,
                                     Diagnostics& diagnostics) {
  std::vector<std::string_view> names;
  for (const ManifestParameter& parameter : manifest.parameters) {
    if (parameter.is_uniform) names.push_back(parameter.name);
    if (parameter.name != name) continue;
    if (parameter.is_uniform) return &parameter;
    diagnostics
        .Error(
            DiagnosticKind::kNotRenderable, {},
            fmt::format("parameter '{}' is no uniform of this shader ({}), so it cannot be swept",
                        Printable(name), Printable(parameter.status)))
        .AddNote({},
                 "a parameter of a graph with \"binding\": \"uniform\" can, if an output needs it");
    return nullptr;
  }
  diagnostics.Error(
      DiagnosticKind::kUnknownParameter, {},
      fmt::format("the shader has no parameter '{}'{}", Printable(name), DidYouMean(name, names)));
  return nullptr;
}

bool IsInside(const std::array<double, 2>& range, const std::array<double, 2>& limits) {
  for (double end : range) {
    if (!(end >= limits[0] && end <= limits[1])) return false;
  }
  return true;
}

// What the parameter may be: its own range, or what its type holds.
std::array<double, 2> Limits(const ManifestParameter& parameter) {
  if (parameter.range) return *parameter.range;
  if (!ir::IsInteger(parameter.type)) return {-3.402823466e38, 3.402823466e38};
  if (ir::ScalarOf(parameter.type) == ir::Scalar::kUint) return {0, 4294967295.0};
  return {-2147483648.0, 2147483647.0};
}

}  // namespace

std::string FramePath(const std::string& output, uint32_t number) {
  const size_t name = output.size() - FileNameOf(output).size();
  const size_t dot = output.rfind('.');
  const size_t end = dot != std::string::npos && dot > name ? dot : output.size();
  return fmt::format("{}.{:04}{}", std::string_view(output).substr(0, end), number,
                     std::string_view(output).substr(end));
}

std::optional<FoundSweep> FindSweep(const Sweep& sweep, const runtime::Manifest& manifest,
                                    Diagnostics& diagnostics) {
  const ManifestParameter* parameter = FindUniform(sweep.name, manifest, diagnostics);
  if (parameter == nullptr) return std::nullopt;
  if (ir::IsBool(parameter->type) || ir::IsMatrix(parameter->type)) {
    diagnostics.Error(DiagnosticKind::kPortType, {},
                      fmt::format("parameter '{}' is a {}; numbers and vectors can be swept",
                                  Printable(sweep.name), ir::Types().Text(parameter->type)));
    return std::nullopt;
  }
  if (!sweep.range && !parameter->range) {
    diagnostics.Error(DiagnosticKind::kUsage, {},
                      fmt::format("parameter '{}' has no range; --sweep {}=A,B gives one",
                                  Printable(sweep.name), Printable(sweep.name)));
    return std::nullopt;
  }
  const std::array<double, 2> range = sweep.range ? *sweep.range : *parameter->range;
  const std::array<double, 2> limits = Limits(*parameter);
  if (!IsInside(range, limits)) {
    diagnostics.Error(DiagnosticKind::kValueRange, {},
                      fmt::format("parameter '{}' is from {} to {}", Printable(sweep.name),
                                  limits[0], limits[1]));
    return std::nullopt;
  }
  return FoundSweep{sweep.name, range[0], range[1], ir::IsInteger(parameter->type)};
}

bool DrawFrame(const RenderOptions& options, const std::optional<FoundSweep>& sweep, uint32_t frame,
               runtime::LiveRenderer& renderer, runtime::RenderResult& result) {
  const double count = std::max(options.frames, 1u);
  double time = options.time;
  if (options.end_time) time += (*options.end_time - options.time) * frame / count;
  Diagnostics diagnostics;
  if (options.mesh.turntable && renderer.request().scene) {
    runtime::Camera camera = renderer.request().scene->camera;
    camera.yaw = std::fmod(options.mesh.scene.camera.yaw + 360 * (frame / count), 360);
    renderer.SetCamera(camera, diagnostics);
  }
  if (sweep) {
    // The last frame has the last value exactly.
    const bool is_last = frame > 0 && frame + 1 == options.frames;
    double value =
        is_last ? sweep->last
                : sweep->first + (sweep->last - sweep->first) * frame / std::max(count - 1, 1.0);
    if (sweep->is_integer) value = std::nearbyint(value);
    renderer.SetParameter(sweep->name, std::span<const double>(&value, 1), diagnostics);
  }
  if (diagnostics.error_count() == 0) {
    result = renderer.Draw(time);
  } else {
    result.diagnostics = std::move(diagnostics);
  }
  return result.ok();
}

}  // namespace texgraph::cli
