// SPDX-License-Identifier: Apache-2.0
// glslang's opinion of a fragment shader for OpenGL, without a process for each.
#pragma once

#include <string>

namespace texgraph::fuzz {

// "" if the shader is valid in the version that it names; else what glslang says.
std::string GlslangComplaint(const std::string& glsl);

}  // namespace texgraph::fuzz
