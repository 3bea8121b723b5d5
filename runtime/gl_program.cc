// SPDX-License-Identifier: Apache-2.0
#include "runtime/gl_program.h"

#include <fmt/format.h>

#include <vector>

namespace texgraph::runtime {
namespace {

GLuint Compile(const GlFunctions& gl, GLenum stage, const std::string& text, std::string& log) {
  const GLuint shader = gl.CreateShader(stage);
  const GLchar* const texts[] = {text.data()};
  const GLint sizes[] = {static_cast<GLint>(text.size())};
  gl.ShaderSource(shader, 1, texts, sizes);
  gl.CompileShader(shader);
  GLint compiled = GL_FALSE;
  GLint size = 0;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  gl.GetShaderiv(shader, GL_INFO_LOG_LENGTH, &size);
  std::string words(size > 0 ? static_cast<size_t>(size) : 0, '\0');
  if (size > 0) gl.GetShaderInfoLog(shader, size, &size, words.data());
  words.resize(size > 0 ? static_cast<size_t>(size) : 0);
  log += words;
  if (compiled == GL_TRUE) return shader;
  gl.DeleteShader(shader);
  return 0;
}

const std::string& OrName(const std::string& variable, const std::string& name) {
  return variable.empty() ? name : variable;
}

template <class T>
std::vector<T> As(const std::vector<double>& numbers) {
  return std::vector<T>(numbers.begin(), numbers.end());
}

void SetFloats(const GlFunctions& gl, GLint location, ir::TypeId type, const float* values) {
  if (ir::IsMatrix(type)) {
    const uint32_t size = ir::MatrixSize(type);
    if (size == 2) gl.UniformMatrix2fv(location, 1, GL_FALSE, values);
    if (size == 3) gl.UniformMatrix3fv(location, 1, GL_FALSE, values);
    if (size == 4) gl.UniformMatrix4fv(location, 1, GL_FALSE, values);
    return;
  }
  const PFNGLUNIFORM1FVPROC set[] = {gl.Uniform1fv, gl.Uniform2fv, gl.Uniform3fv, gl.Uniform4fv};
  set[ir::Width(type) - 1](location, 1, values);
}

void SetUniform(const GlFunctions& gl, GLint location, const ManifestParameter& parameter) {
  if (ir::IsFloat(parameter.type)) {
    SetFloats(gl, location, parameter.type, As<float>(parameter.value).data());
    return;
  }
  const uint32_t index = ir::Width(parameter.type) - 1;
  if (ir::ScalarOf(parameter.type) == ir::Scalar::kUint) {
    const PFNGLUNIFORM1UIVPROC set[] = {gl.Uniform1uiv, gl.Uniform2uiv, gl.Uniform3uiv,
                                        gl.Uniform4uiv};
    set[index](location, 1, As<GLuint>(parameter.value).data());
  } else {
    const PFNGLUNIFORM1IVPROC set[] = {gl.Uniform1iv, gl.Uniform2iv, gl.Uniform3iv, gl.Uniform4iv};
    set[index](location, 1, As<GLint>(parameter.value).data());
  }
}

}  // namespace

std::string VertexShader(const Manifest& manifest) {
  const bool is_450 = manifest.dialect == ShaderDialect::kGlsl450;
  std::string declarations;
  std::string body;
  for (const ManifestInput& input : manifest.inputs) {
    std::string_view type;
    std::string_view value;
    if (input.name == "uv") {
      type = "vec2";
      value = "surface";
    } else if (input.name == "position") {
      type = "vec3";
      value = "vec3(surface, 0.0)";
    } else if (input.name == "normal") {
      type = "vec3";
      value = "vec3(0.0, 0.0, 1.0)";
    } else {
      continue;  // time is a uniform
    }
    const std::string place =
        input.location && is_450 ? fmt::format("layout(location = {}) ", *input.location) : "";
    declarations += fmt::format("{}out {} {};\n", place, type, OrName(input.variable, input.name));
    body += fmt::format("  {} = {};\n", OrName(input.variable, input.name), value);
  }
  return fmt::format(
      "#version {} core\n"
      "layout(location = {}) in vec4 texgraph_window;\n"
      "{}"
      "void main() {{\n"
      "  vec2 corner = vec2(gl_VertexID == 1 ? 1.0 : 0.0, gl_VertexID == 2 ? 1.0 : 0.0);\n"
      "  vec2 surface = mix(texgraph_window.xy, texgraph_window.zw, equal(corner, vec2(1.0)));\n"
      "{}"
      "  gl_Position = vec4(2.0 * corner - 1.0, 0.0, 1.0);\n"
      "}}\n",
      is_450 ? 450 : 330, kWindowAttribute, declarations, body);
}

GLuint LinkProgram(const GlContext& context, const std::string& vertex_text,
                   const std::string& fragment_text, std::string& what, std::string& log) {
  const GlFunctions& gl = context.gl;
  const GLuint vertex = Compile(gl, GL_VERTEX_SHADER, vertex_text, log);
  if (vertex == 0) {
    what = "the driver refuses the vertex shader";
    return 0;
  }
  const GLuint fragment = Compile(gl, GL_FRAGMENT_SHADER, fragment_text, log);
  if (fragment == 0) {
    gl.DeleteShader(vertex);
    what = "the driver refuses the shader";
    return 0;
  }
  const GLuint program = gl.CreateProgram();
  gl.AttachShader(program, vertex);
  gl.AttachShader(program, fragment);
  gl.LinkProgram(program);
  gl.DeleteShader(vertex);
  gl.DeleteShader(fragment);
  GLint linked = GL_FALSE;
  GLint size = 0;
  gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
  gl.GetProgramiv(program, GL_INFO_LOG_LENGTH, &size);
  std::string words(size > 0 ? static_cast<size_t>(size) : 0, '\0');
  if (size > 0) gl.GetProgramInfoLog(program, size, &size, words.data());
  words.resize(size > 0 ? static_cast<size_t>(size) : 0);
  log += words;
  if (linked == GL_TRUE) return program;
  gl.DeleteProgram(program);
  what = "the driver cannot link the shader";
  return 0;
}

void SetUniforms(const GlFunctions& gl, GLuint program, const RenderRequest& request) {
  for (const ManifestParameter& parameter : request.manifest.parameters) {
    if (!parameter.is_uniform) continue;
    const GLint location =
        gl.GetUniformLocation(program, OrName(parameter.variable, parameter.name).c_str());
    if (location >= 0)
      SetUniform(gl, location, parameter);  // else the driver found that it changes nothing
  }
  for (const ManifestInput& input : request.manifest.inputs) {
    if (input.name != "time") continue;
    const float time = static_cast<float>(request.time);
    const GLint location =
        gl.GetUniformLocation(program, OrName(input.variable, input.name).c_str());
    if (location >= 0) gl.Uniform1fv(location, 1, &time);
  }
}

}  // namespace texgraph::runtime
