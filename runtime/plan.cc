// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "compiler/graph/graph.h"
#include "runtime/shared_result.h"

namespace texgraph::runtime {
namespace {

const ManifestOutput* FindOutput(const Manifest& manifest, const std::string& name,
                                 Diagnostics& diagnostics) {
  std::vector<std::string_view> names;
  for (const ManifestOutput& output : manifest.outputs) {
    if (output.name == name) return &output;
    names.push_back(output.name);
  }
  diagnostics.Error(
      DiagnosticKind::kUnknownOutput, {},
      fmt::format("the shader has no output '{}'{}", Printable(name), DidYouMean(name, names)));
  return nullptr;
}

// What there is of a mesh beside the graph's outputs: with alpha only if something shines through.
const ManifestOutput* LitOutput(const Scene& scene) {
  static const ManifestOutput opaque{std::string(kLitOutput), "", ir::kVec3};
  static const ManifestOutput transparent{std::string(kLitOutput), "", ir::kVec4};
  return scene.background[3] < 1 ? &transparent : &opaque;
}

bool PlanOutputs(const RenderRequest& request, RenderPlan& plan, Diagnostics& diagnostics) {
  const Manifest& manifest = request.manifest;
  if (request.outputs.empty() && request.scene) {
    plan.outputs.push_back({LitOutput(*request.scene)});
  } else if (request.outputs.empty()) {
    const auto color =
        std::find_if(manifest.outputs.begin(), manifest.outputs.end(),
                     [](const ManifestOutput& output) { return output.name == "color"; });
    const auto chosen = color != manifest.outputs.end() ? color : manifest.outputs.begin();
    if (chosen != manifest.outputs.end()) plan.outputs.push_back({&*chosen});
  }
  for (const std::string& name : request.outputs) {
    if (request.scene && name == kLitOutput) {
      plan.outputs.push_back({LitOutput(*request.scene)});
      continue;
    }
    const ManifestOutput* output = FindOutput(manifest, name, diagnostics);
    if (output == nullptr) return false;
    plan.outputs.push_back({output});
  }
  if (!plan.outputs.empty() && plan.outputs.size() <= kMaxOutputs) return true;
  diagnostics.Error(DiagnosticKind::kUsage, {},
                    fmt::format("1 to {} outputs can be drawn at once, not {}", kMaxOutputs,
                                plan.outputs.size()));
  return false;
}

bool PlanPixels(const RenderRequest& request, RenderPlan& plan, Diagnostics& diagnostics) {
  if (request.width < 1 || request.height < 1 || request.width > kMaxPictureSide ||
      request.height > kMaxPictureSide) {
    diagnostics.Error(DiagnosticKind::kSizeLimit, {},
                      fmt::format("a picture has 1 to {} pixels each way, not {} x {}",
                                  kMaxPictureSide, request.width, request.height));
    return false;
  }
  for (PlannedOutput& planned : plan.outputs) {
    planned.channels = ir::Width(planned.output->type);
    planned.image_channels = planned.channels == 2 ? 3 : planned.channels;
    const size_t pixel =
        request.format == PixelFormat::kFloat
            ? 4 * sizeof(float)
            : planned.image_channels * (request.format == PixelFormat::kImage16 ? 2 : 1);
    planned.offset = plan.bytes;
    planned.bytes = size_t{request.width} * request.height * pixel;
    plan.bytes += (planned.bytes + 63) / 64 * 64;
  }
  if (plan.bytes <= kMaxPictureBytes) return true;
  diagnostics.Error(DiagnosticKind::kSizeLimit, {},
                    fmt::format("a picture of {} x {} pixels needs {} bytes; the limit is {}",
                                request.width, request.height, plan.bytes, kMaxPictureBytes));
  return false;
}

bool CheckNumbers(const RenderRequest& request, Diagnostics& diagnostics) {
  const auto& window = request.window;
  const bool finite =
      std::all_of(window.begin(), window.end(), [](double x) { return std::abs(x) <= 1e6; });
  if (!finite || window[0] == window[2] || window[1] == window[3]) {
    diagnostics.Error(DiagnosticKind::kUsage, {},
                      "a uv window is u0,v0,u1,v1 with two different ends each way, up to 1000000");
    return false;
  }
  if (!std::isfinite(request.time)) {
    diagnostics.Error(DiagnosticKind::kUsage, {}, "the time is a finite number of seconds");
    return false;
  }
  if (!(request.timeout > 0 && request.timeout <= 1e6)) {
    diagnostics.Error(DiagnosticKind::kUsage, {},
                      "the time limit is more than 0 and up to 1000000 seconds");
    return false;
  }
  if (request.tile < 2 || request.tile % 2 != 0 || request.timed_frames > kMaxTimedFrames) {
    diagnostics.Error(DiagnosticKind::kUsage, {},
                      "tiles have an even side, and up to 1000 frames are timed");
    return false;
  }
  return true;
}

// The light is put around a function, and the names and types of its outputs are the graph's.
bool CheckFunction(const Manifest& manifest, Diagnostics& diagnostics) {
  const auto refuse = [&](std::string text) {
    diagnostics.Error(DiagnosticKind::kNotRenderable, {}, std::move(text));
    return false;
  };
  if (manifest.dialect == ShaderDialect::kSpirv || !manifest.is_function) {
    return refuse(
        "a whole shader cannot be put on a mesh; take the graph, or the manifest of a "
        "function ('texgraphc --emit=function')");
  }
  const ir::Types types;
  std::set<std::string_view> seen;
  for (const ManifestOutput& output : manifest.outputs) {
    const auto known =
        std::find_if(std::begin(graph::kBuiltinOutputs), std::end(graph::kBuiltinOutputs),
                     [&](const auto& entry) { return entry.name == output.name; });
    if (known == std::end(graph::kBuiltinOutputs) || types.Find(known->type) != output.type ||
        !seen.insert(output.name).second) {
      return refuse(fmt::format("output '{}' is none of a graph's, or of another type",
                                Printable(output.name)));
    }
  }
  return true;
}

bool CheckManifest(const RenderRequest& request, Diagnostics& diagnostics) {
  const Manifest& manifest = request.manifest;
  if (request.scene) return CheckFunction(manifest, diagnostics);
  if (manifest.dialect != ShaderDialect::kSpirv && !manifest.is_function) return true;
  diagnostics.Error(DiagnosticKind::kNotRenderable, {},
                    fmt::format("{} cannot be rendered; make a whole shader in glsl330 or glsl450",
                                manifest.is_function ? "a function alone" : "a SPIR-V module"));
  return false;
}

bool PlanSamplers(const RenderRequest& request, RenderPlan& plan, Diagnostics& diagnostics) {
  std::set<std::string_view> variables;
  for (const ManifestTexture& texture : request.manifest.textures) {
    if (!texture.is_used || !variables.insert(texture.variable).second) continue;
    const auto bound = std::find_if(
        request.textures.begin(), request.textures.end(),
        [&](const TextureBinding& binding) { return binding.variable == texture.variable; });
    if (bound == request.textures.end() || !bound->data || bound->data->levels.empty()) {
      diagnostics.Error(DiagnosticKind::kNotRenderable, {},
                        fmt::format("texture '{}' has no image", Printable(texture.name)));
      return false;
    }
    plan.samplers.push_back({texture.variable, bound->data.get()});
  }
  return true;
}

}  // namespace

bool CheckScene(const RenderRequest& request, Diagnostics& diagnostics) {
  if (!request.scene) return true;
  const Scene& scene = *request.scene;
  const Camera& camera = scene.camera;
  const auto between = [](double value, double low, double high) {
    return value >= low && value <= high;
  };
  const bool ok =
      scene.mesh && !scene.mesh->indices.empty() && between(scene.samples, 1, kMaxSampleSide) &&
      between(camera.yaw, -1e6, 1e6) && between(camera.pitch, -90, 90) &&
      between(camera.field_of_view, 1, 170) && between(camera.distance.value_or(1), 1e-12, 1e13) &&
      between(scene.lighting.yaw, -1e6, 1e6) && between(scene.lighting.pitch, -90, 90) &&
      between(std::abs(scene.tiles[0]), 1e-6, 1e6) &&
      between(std::abs(scene.tiles[1]), 1e-6, 1e6) && between(std::abs(scene.relief), 0, 1e6);
  if (ok) return true;
  diagnostics.Error(DiagnosticKind::kUsage, {},
                    "a scene has a mesh with triangles, and its numbers are within their limits");
  return false;
}

bool PlanRender(const RenderRequest& request, RenderPlan& plan, Diagnostics& diagnostics) {
  return CheckNumbers(request, diagnostics) && CheckScene(request, diagnostics) &&
         CheckManifest(request, diagnostics) && PlanSamplers(request, plan, diagnostics) &&
         PlanOutputs(request, plan, diagnostics) && PlanPixels(request, plan, diagnostics);
}

}  // namespace texgraph::runtime
