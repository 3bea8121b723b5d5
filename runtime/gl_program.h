// SPDX-License-Identifier: Apache-2.0
// A fragment shader made ready to draw: linked to the vertex shader that gives it its inputs, with
// its uniforms set.
#pragma once

#include <array>
#include <string>

#include "runtime/gl_context.h"
#include "runtime/render.h"

namespace texgraph::runtime {

// The vertex attribute that holds the uv of the corners of the viewport: left, bottom, right, top.
inline constexpr GLuint kWindowAttribute = 1;

// One triangle that covers the left bottom half of the viewport. Its outputs are the manifest's
// inputs, at their locations.
std::string VertexShader(const Manifest& manifest);

// The program, or 0 with the driver's words in `log` and what failed in `what`.
GLuint LinkProgram(const GlContext& context, const std::string& vertex_text,
                   const std::string& fragment_text, std::string& what, std::string& log);
// Of the program in use.
void SetUniforms(const GlFunctions& gl, GLuint program, const RenderRequest& request);

}  // namespace texgraph::runtime
