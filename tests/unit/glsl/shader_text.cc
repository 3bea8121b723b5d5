// SPDX-License-Identifier: Apache-2.0
#include "tests/unit/glsl/shader_text.h"

#include <unistd.h>

#include <cstdio>
#include <fstream>

#include "compiler/glsl/legalize.h"
#include "compiler/ir/print.h"
#include "compiler/ir/verify.h"

namespace texgraph::glsl {

ir::Module ModuleOf(std::string text) {
  Sources sources;
  Diagnostics diagnostics;
  SourceId source = sources.Add("test.ir", std::move(text));
  std::optional<ir::Module> module = ir::Parse(source, sources, diagnostics);
  EXPECT_TRUE(module.has_value()) << FormatDiagnostics(diagnostics, sources, false);
  return module ? std::move(*module) : ir::Module();
}

std::string Shader(std::string module_text, Dialect dialect, bool as_function) {
  ir::Module module = ModuleOf(std::move(module_text));
  if (!module.main) return "";
  Diagnostics diagnostics;
  bool legal = Legalize(module, dialect, diagnostics);
  EXPECT_TRUE(legal) << FormatDiagnostics(diagnostics, Sources(), false);
  if (!legal) return "";
  EXPECT_EQ(ir::Verify(module), "");
  PrintOptions options;
  options.dialect = dialect;
  options.as_function = as_function;
  options.name = "test";
  options.version = "1.0";
  return PrintGlsl(module, options);
}

std::string Functions(std::string module_text, Dialect dialect) {
  std::string shader = Shader(std::move(module_text), dialect);
  // The last section before the functions ends with an empty line.
  size_t brace = shader.find(") {\n");
  size_t start = shader.rfind("\n\n", brace);
  return start == std::string::npos ? shader : shader.substr(start + 2);
}

std::string MainBody(std::string module_text, Dialect dialect) {
  std::string shader = Shader(std::move(module_text), dialect);
  constexpr std::string_view kMain = "void main() {\n";
  size_t start = shader.find(kMain);
  if (start == std::string::npos) return shader;
  start += kMain.size();
  return shader.substr(start, shader.rfind('}') - start);
}

std::string Complaint(const std::string& shader) {
  std::string path = testing::TempDir() + "texgraph_glsl_" + std::to_string(getpid()) + ".frag";
  {
    std::ofstream file(path, std::ios::binary);
    file << shader;
  }
  FILE* pipe = popen(("glslangValidator " + path + " 2>&1").c_str(), "r");
  if (!pipe) return "glslangValidator does not start";
  std::string output;
  char buffer[4096];
  while (size_t count = fread(buffer, 1, sizeof buffer, pipe)) output.append(buffer, count);
  int status = pclose(pipe);
  std::remove(path.c_str());
  if (status == 0) return "";
  return output.empty() ? "glslangValidator fails" : output;
}

testing::AssertionResult IsValid(const std::string& module_text) {
  for (Dialect dialect : {Dialect::k330, Dialect::k450}) {
    std::string shader = Shader(module_text, dialect);
    if (std::string reason = Complaint(shader); !reason.empty()) {
      return testing::AssertionFailure() << reason << "\n" << shader;
    }
  }
  return testing::AssertionSuccess();
}

std::string LegalizeReport(std::string module_text, Dialect dialect) {
  ir::Module module = ModuleOf(std::move(module_text));
  if (!module.main) return "no module";
  Diagnostics diagnostics;
  bool legal = Legalize(module, dialect, diagnostics);
  EXPECT_EQ(legal, !diagnostics.HasErrors());
  std::string report;
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    if (diagnostic.severity == Severity::kWarning) report += "warning: ";
    report += std::string(DiagnosticName(diagnostic.kind)) + ": " + diagnostic.message + "\n";
  }
  return report;
}

}  // namespace texgraph::glsl
