// SPDX-License-Identifier: Apache-2.0
#include "runtime/mesh_shader.h"

#include <fmt/format.h>

#include "runtime/mesh_light.h"
#include "runtime/scene.h"

namespace texgraph::runtime {
namespace {

std::string WithPrefix(std::string_view text, const std::string& prefix) {
  std::string result;
  for (char c : text) {
    if (c == '$') {
      result += prefix;
    } else {
      result += c;
    }
  }
  return result;
}

// A beginning of names that occurs nowhere in the graph's text.
std::string FreePrefix(const std::string& text) {
  std::string prefix = "mesh_";
  for (int i = 2; text.find(prefix) != std::string::npos; ++i) prefix = fmt::format("mesh{}_", i);
  return prefix;
}

std::string_view TypeText(ir::TypeId type) {
  static constexpr std::string_view names[] = {"float", "vec2", "vec3", "vec4"};
  return names[ir::Width(type) - 1];
}

constexpr std::string_view kVertex = R"(
layout(location = 0) in vec3 $vertex_position;
layout(location = 1) in vec3 $vertex_normal;
layout(location = 2) in vec4 $vertex_tangent;
layout(location = 3) in vec2 $vertex_uv;
uniform mat4 $clip_from_object;
uniform vec2 $tiles;
out vec2 $uv;
out vec3 $position;
out vec3 $normal;
out vec4 $tangent;

void main() {
  $uv = $vertex_uv * $tiles;
  $position = $vertex_position;
  $normal = $vertex_normal;
  $tangent = $vertex_tangent;
  gl_Position = $clip_from_object * vec4($vertex_position, 1.0);
}
)";

constexpr std::string_view kInputs = R"(
in vec2 $uv;
in vec3 $position;
in vec3 $normal;
in vec4 $tangent;
uniform float $relief;
uniform int $side;
)";

bool HasOutput(const Manifest& manifest, std::string_view name) {
  for (const ManifestOutput& output : manifest.outputs) {
    if (output.name == name) return true;
  }
  return false;
}

// The call of the graph's function: each of its outputs is a variable $<name> afterwards.
std::string Call(const Manifest& manifest) {
  std::string text;
  std::string arguments;
  for (const ManifestInput& input : manifest.inputs) {
    if (input.name == "time") continue;             // a uniform in functions, too
    const bool is_normal = input.name == "normal";  // interpolated, it is too short
    arguments += fmt::format("{}{}", arguments.empty() ? "" : ", ",
                             is_normal ? "normalize($normal)" : "$" + input.name);
  }
  const std::string& function = manifest.entry_point;
  if (manifest.outputs.size() == 1) {
    const ManifestOutput& output = manifest.outputs[0];
    return fmt::format("  {} $of_{} = {}({});\n", TypeText(output.type), output.name, function,
                       arguments);
  }
  for (const ManifestOutput& output : manifest.outputs) {
    text += fmt::format("  {} $of_{};\n", TypeText(output.type), output.name);
    arguments += fmt::format("{}$of_{}", arguments.empty() ? "" : ", ", output.name);
  }
  return text + fmt::format("  {}({});\n", function, arguments);
}

// The lit colour, out of whatever the graph gives.
std::string Light(const Manifest& manifest) {
  const auto has = [&](std::string_view name) { return HasOutput(manifest, name); };
  const auto or_default = [&](std::string_view name, std::string_view otherwise) {
    return has(name) ? fmt::format("$of_{}", name) : std::string(otherwise);
  };
  std::string text;
  if (has("normal")) {
    text += "  vec3 $across = $of_normal;\n";
  } else if (has("height")) {
    text += "  vec3 $across = $from_height($of_height * $relief, $uv);\n";
  } else {
    text += "  vec3 $across = vec3(0.0, 0.0, 1.0);\n";
  }
  // The back of a triangle is lit like its front.
  text +=
      "  vec3 $smooth_n = normalize($normal);\n"
      "  vec3 $n = $from_texture($across, $smooth_n, $tangent);\n"
      "  float $face = gl_FrontFacing ? 1.0 : -1.0;\n";
  text += fmt::format(
      "  vec3 $light = $shade(max({}, 0.0), clamp({}, 0.0, 1.0), clamp({}, 0.045, 1.0),\n"
      "                       $face * $n, $face * $smooth_n, $position);\n",
      has("color") ? "$of_color.xyz" : "vec3(0.5)", or_default("metallic", "0.0"),
      or_default("roughness", "0.6"));
  if (has("emission")) text += "  $light += max($of_emission, 0.0);\n";
  return text;
}

// What is not there at all is left out.
std::string Discard(const Manifest& manifest) {
  std::string opacity;
  if (HasOutput(manifest, "opacity")) opacity = "$of_opacity";
  if (HasOutput(manifest, "color")) opacity += opacity.empty() ? "$of_color.w" : " * $of_color.w";
  if (opacity.empty()) return "";
  return fmt::format("  if (!$is_covered({}, $side)) discard;\n", opacity);
}

}  // namespace

MeshShader ComposeMeshShader(const std::string& function, const Manifest& manifest,
                             std::span<const std::string_view> outputs) {
  MeshShader shader;
  shader.prefix = FreePrefix(function + manifest.entry_point);
  const std::string version =
      fmt::format("#version {} core\n", manifest.dialect == ShaderDialect::kGlsl450 ? 450 : 330);
  shader.vertex = version + WithPrefix(kVertex, shader.prefix);
  std::string declarations;
  std::string body = Call(manifest);
  std::string assignments;
  bool is_lit = false;
  for (size_t i = 0; i < outputs.size(); ++i) {
    declarations += fmt::format("layout(location = {}) out vec4 $out{};\n", i, i);
    if (outputs[i] == kLitOutput) {
      is_lit = true;
      assignments += fmt::format("  $out{} = vec4($light, 1.0);\n", i);
      continue;
    }
    for (const ManifestOutput& output : manifest.outputs) {
      if (output.name != outputs[i]) continue;
      static constexpr std::string_view kRest[] = {", 0.0, 0.0, 0.0", ", 0.0, 0.0", ", 0.0", ""};
      assignments += fmt::format("  $out{} = vec4($of_{}{});\n", i, output.name,
                                 kRest[ir::Width(output.type) - 1]);
    }
  }
  if (is_lit) body += Light(manifest);
  // After everything that takes differences between pixels.
  body += Discard(manifest);
  shader.fragment =
      version + WithPrefix(std::string(kInputs) + declarations, shader.prefix) + "\n" + function +
      "\n" +
      WithPrefix(std::string(kMeshLight) + "\nvoid main() {\n" + body + assignments + "}\n",
                 shader.prefix);
  return shader;
}

std::string ResolveVertexShader() {
  return R"(#version 330 core
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(corner, 0.0, 1.0);
}
)";
}

// The tone curve is Khronos' "PBR neutral": colours up to 0.8 keep their numbers, but for the 0.04
// that a surface reflects of a white environment; above, they go to white slowly.
std::string ResolveFragmentShader() {
  return R"(#version 330 core
uniform sampler2D samples;
uniform int side;
uniform int is_light;
uniform int is_toned;
uniform vec4 background;
out vec4 pixel;

vec3 Tone(vec3 light) {
  const float start = 0.8 - 0.04;
  float least = min(light.r, min(light.g, light.b));
  light -= least < 0.08 ? least - 6.25 * least * least : 0.04;
  float peak = max(light.r, max(light.g, light.b));
  if (!(peak > start)) return light;
  float d = 1.0 - start;
  float pressed = 1.0 - d * d / (peak + d - start);
  light *= pressed / peak;
  return mix(vec3(pressed), light, 1.0 / (0.15 * (peak - pressed) + 1.0));
}

void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * side;
  vec4 sum = vec4(0.0);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) sum += texelFetch(samples, first + ivec2(x, y), 0);
  }
  sum /= float(side * side);
  if (is_light == 0) {
    pixel = sum;
    return;
  }
  vec3 light = sum.a > 0.0 ? sum.rgb / sum.a : vec3(0.0);
  if (is_toned != 0) light = Tone(light);
  float behind = background.a * (1.0 - sum.a);
  float alpha = sum.a + behind;
  pixel = alpha > 0.0 ? vec4((light * sum.a + background.rgb * behind) / alpha, alpha) : vec4(0.0);
}
)";
}

}  // namespace texgraph::runtime
