// SPDX-License-Identifier: Apache-2.0
#include "compiler/spirv/compile_spirv.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <spirv-tools/libspirv.hpp>
#include <string_view>

namespace texgraph::spirv {
namespace {

// glslang's tables, for as long as the process lives.
bool StartGlslang() {
  static const bool started = glslang::InitializeProcess();
  return started;
}

// The first line of a log that says something.
std::string FirstLine(std::string_view log) {
  size_t begin = log.find_first_not_of(" \r\n");
  if (begin == std::string_view::npos) return "no reason given";
  log = log.substr(begin, log.find_first_of("\r\n", begin) - begin);
  return Printable(log.substr(0, log.find_last_not_of(' ') + 1));
}

std::nullopt_t Fail(SourceRange where, std::string message, Diagnostics& diagnostics) {
  diagnostics.Error(DiagnosticKind::kSpirv, where, std::move(message));
  return std::nullopt;
}

// What spirv-val has to say; "" if the module is valid.
std::string Validate(const std::vector<uint32_t>& words) {
  spvtools::SpirvTools tools(SPV_ENV_OPENGL_4_5);
  std::string message;
  tools.SetMessageConsumer(
      [&](spv_message_level_t level, const char*, const spv_position_t&, const char* text) {
        if (level <= SPV_MSG_ERROR && message.empty()) message = text;
      });
  if (tools.Validate(words)) return "";
  return FirstLine(message);
}

}  // namespace

std::optional<std::vector<uint32_t>> CompileSpirv(const std::string& glsl, Diagnostics& diagnostics,
                                                  SourceRange where) {
  if (!StartGlslang()) return Fail(where, "glslang does not start", diagnostics);
  const auto rules = static_cast<EShMessages>(EShMsgDefault | EShMsgSpvRules);
  const char* text = glsl.data();
  const int length = static_cast<int>(glsl.size());
  glslang::TShader shader(EShLangFragment);
  shader.setStringsWithLengths(&text, &length, 1);
  shader.setEnvInput(glslang::EShSourceGlsl, EShLangFragment, glslang::EShClientOpenGL, 100);
  shader.setEnvClient(glslang::EShClientOpenGL, glslang::EShTargetOpenGL_450);
  shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_0);
  if (!shader.parse(GetDefaultResources(), 450, false, rules)) {
    return Fail(where, "glslang refuses the shader: " + FirstLine(shader.getInfoLog()),
                diagnostics);
  }
  glslang::TProgram program;
  program.addShader(&shader);
  if (!program.link(rules)) {
    return Fail(where, "glslang does not link the shader: " + FirstLine(program.getInfoLog()),
                diagnostics);
  }
  std::vector<uint32_t> words;
  spv::SpvBuildLogger log;
  glslang::SpvOptions options;
  options.disableOptimizer = true;
  glslang::GlslangToSpv(*program.getIntermediate(EShLangFragment), words, &log, &options);
  if (words.empty())
    return Fail(where, "glslang makes no SPIR-V: " + FirstLine(log.getAllMessages()), diagnostics);
  if (std::string reason = Validate(words); !reason.empty()) {
    return Fail(where, "spirv-val refuses the shader: " + reason, diagnostics);
  }
  return words;
}

bool ValidateGlsl(const std::string& glsl, Diagnostics& diagnostics, SourceRange where) {
  if (!StartGlslang()) {
    Fail(where, "glslang does not start", diagnostics);
    return false;
  }
  glslang::TShader shader(EShLangFragment);
  const char* text = glsl.data();
  const int length = static_cast<int>(glsl.size());
  shader.setStringsWithLengths(&text, &length, 1);
  glslang::TProgram program;
  std::string problem;
  if (!shader.parse(GetDefaultResources(), 330, false, EShMsgDefault)) {
    problem = "glslang refuses the shader: " + FirstLine(shader.getInfoLog());
  } else {
    program.addShader(&shader);
    if (!program.link(EShMsgDefault))
      problem = "glslang does not link the shader: " + FirstLine(program.getInfoLog());
  }
  if (problem.empty()) return true;
  Fail(where, std::move(problem), diagnostics);
  return false;
}

}  // namespace texgraph::spirv
