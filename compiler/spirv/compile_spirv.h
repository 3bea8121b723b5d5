// SPDX-License-Identifier: Apache-2.0
// GLSL to SPIR-V for OpenGL, through glslang, checked by SPIRV-Tools. Nothing of either library
// runs before the first call.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compiler/base/diagnostics.h"

namespace texgraph::spirv {

// The words of a SPIR-V 1.0 module for OpenGL 4.5 (GL_ARB_gl_spirv), with the entry point "main".
// `glsl` is a fragment shader that texgraph printed in the dialect 450, for SPIR-V; so whatever
// glslang or spirv-val say against it is texgraph's own mistake, kSpirv, reported at `where`.
std::optional<std::vector<uint32_t>> CompileSpirv(const std::string& glsl, Diagnostics& diagnostics,
                                                  SourceRange where = {});

// Whether glslang takes `glsl`, a whole fragment shader that says its #version, as OpenGL's. What it
// says against the shader is reported like above.
bool ValidateGlsl(const std::string& glsl, Diagnostics& diagnostics, SourceRange where = {});

}  // namespace texgraph::spirv
