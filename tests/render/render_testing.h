// SPDX-License-Identifier: Apache-2.0
// Requests for hand-written shaders, as the tests of rendering need them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/render.h"

namespace texgraph::test {

// A request in floats for a GLSL 3.30 fragment shader that is `declarations` and a main of `body`.
// It has the inputs uv, position, normal and time, and the outputs color (vec4 out_color) and
// height (float out_height).
runtime::RenderRequest ShaderRequest(const std::string& declarations, const std::string& body,
                                     uint32_t width, uint32_t height);
void AddUniform(runtime::RenderRequest& request, const std::string& name, ir::TypeId type,
                std::vector<double> value);
void AddTexture(runtime::RenderRequest& request, const std::string& name,
                textures::TextureData data);

// The contexts that there are on this machine, each with its name.
struct NamedContext {
  std::string name;
  runtime::ContextChoice choice;
};
inline std::vector<NamedContext> AllContexts() {
  return {{"egl", runtime::ContextChoice::kEgl}, {"osmesa", runtime::ContextChoice::kOsmesa}};
}

// Component `c` of pixel (x, y), y from the bottom, of a float output.
float FloatAt(const runtime::RenderedOutput& output, uint32_t width, uint32_t x, uint32_t y,
              uint32_t c);
std::string FirstMessage(const Diagnostics& diagnostics);
std::string FirstName(const Diagnostics& diagnostics);

}  // namespace texgraph::test
