// SPDX-License-Identifier: Apache-2.0
#include "tests/render/render_testing.h"

#include <memory>

namespace texgraph::test {

using runtime::RenderRequest;

RenderRequest ShaderRequest(const std::string& declarations, const std::string& body,
                            uint32_t width, uint32_t height) {
  RenderRequest request;
  request.shader =
      "#version 330 core\n"
      "in vec2 uv;\n"
      "in vec3 position;\n"
      "in vec3 normal;\n"
      "uniform float time;\n"
      "layout(location = 0) out vec4 out_color;\n"
      "layout(location = 1) out float out_height;\n" +
      declarations + "\nvoid main() {\n" + body + "\n}\n";
  request.manifest.inputs = {{"uv", "", ir::kVec2, {}},
                             {"position", "", ir::kVec3, {}},
                             {"normal", "", ir::kVec3, {}},
                             {"time", "", ir::kFloat, {}}};
  request.manifest.outputs = {{"height", "out_height", ir::kFloat},
                              {"color", "out_color", ir::kVec4}};
  request.width = width;
  request.height = height;
  request.format = runtime::PixelFormat::kFloat;
  return request;
}

void AddUniform(RenderRequest& request, const std::string& name, ir::TypeId type,
                std::vector<double> value) {
  runtime::ManifestParameter parameter;
  parameter.name = name;
  parameter.type = type;
  parameter.is_uniform = true;
  parameter.status = "uniform";
  parameter.value = std::move(value);
  request.manifest.parameters.push_back(std::move(parameter));
}

void AddTexture(RenderRequest& request, const std::string& name, textures::TextureData data) {
  runtime::ManifestTexture texture;
  texture.name = name;
  texture.variable = name;
  request.manifest.textures.push_back(std::move(texture));
  request.textures.push_back({name, std::make_shared<textures::TextureData>(std::move(data))});
}

float FloatAt(const runtime::RenderedOutput& output, uint32_t width, uint32_t x, uint32_t y,
              uint32_t c) {
  return output.floats[(size_t{y} * width + x) * 4 + c];
}

std::string FirstMessage(const Diagnostics& diagnostics) {
  return diagnostics.all().empty() ? "" : diagnostics.all().front().message;
}

std::string FirstName(const Diagnostics& diagnostics) {
  return diagnostics.all().empty() ? ""
                                   : std::string(DiagnosticName(diagnostics.all().front().kind));
}

}  // namespace texgraph::test
