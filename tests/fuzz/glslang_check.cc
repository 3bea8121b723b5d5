// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/glslang_check.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>

namespace texgraph::fuzz {

std::string GlslangComplaint(const std::string& glsl) {
  static const bool started = glslang::InitializeProcess();
  if (!started) return "glslang does not start";
  const char* text = glsl.data();
  const int length = static_cast<int>(glsl.size());
  glslang::TShader shader(EShLangFragment);
  shader.setStringsWithLengths(&text, &length, 1);
  if (!shader.parse(GetDefaultResources(), 330, false, EShMsgDefault)) return shader.getInfoLog();
  glslang::TProgram program;
  program.addShader(&shader);
  return program.link(EShMsgDefault) ? "" : program.getInfoLog();
}

}  // namespace texgraph::fuzz
