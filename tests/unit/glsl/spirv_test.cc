// SPDX-License-Identifier: Apache-2.0
// SPIR-V through glslang, and what is said when a shader is none.
#include <gmock/gmock.h>

#include <string>

#include "compiler/glsl/legalize.h"
#include "compiler/spirv/compile_spirv.h"
#include "tests/unit/glsl/shader_text.h"

namespace texgraph::spirv {
namespace {

constexpr char kModule[] = R"(struct Tile { cell: ivec2, local: vec2 }
input uv: vec2
uniform tint: vec3 = vec3(1.0)
specialization rows: int = 12
specialization flip: bool = false
texture brick: sampler2D
texture layers: sampler2DArray
function pick(%image: sampler2D, %tile: Tile) -> (vec4, more: float) {
  %1 = extract.1 %tile : vec2
  %2 = sample_lod %image, %1, 0.0 : vec4
  %3 = extract.3 %2 : float
  return %2, %3
}
function main() -> (color: vec4, height: float) {
  %1 = convert @rows : float
  %2 = splat %1 : vec2
  %3 = mul @uv, %2 : vec2
  %4 = floor %3 : vec2
  %5 = convert %4 : ivec2
  %6 = construct %5, %3 : Tile
  %7 = call pick(@brick, %6) : (vec4, float)
  %8 = extract.0 %7 : vec4
  %9 = extract.1 %7 : float
  %10 = construct %9, %9, 1.0 : vec3
  %11 = sample_grad @layers, %10, @uv, @uv : vec4
  %12 = select @flip, %11, %8 : vec4
  %13 = extract.0 @tint : float
  %14 = for %i = 0 to 4 step 1 (%a = %13) : float {
    %15 = fma %a, 0.5, %9 : float
    yield %15
  }
  return %12, %14
}
main main
)";

std::string PrintedForSpirv() {
  ir::Module module = glsl::ModuleOf(kModule);
  Diagnostics diagnostics;
  EXPECT_TRUE(glsl::Legalize(module, glsl::Dialect::k450, diagnostics));
  glsl::PrintOptions options;
  options.dialect = glsl::Dialect::k450;
  options.for_spirv = true;
  return glsl::PrintGlsl(module, options);
}

TEST(CompileSpirv, MakesAModuleForOpenGl) {
  std::string shader = PrintedForSpirv();
  Diagnostics diagnostics;
  auto words = CompileSpirv(shader, diagnostics);
  ASSERT_TRUE(words) << FormatDiagnostics(diagnostics, Sources(), false) << shader;
  ASSERT_GT(words->size(), 5u);
  EXPECT_EQ((*words)[0], 0x07230203u);  // the magic number
  EXPECT_EQ((*words)[1], 0x00010000u);  // version 1.0
  // The specialisation constants have their numbers: OpDecorate (71) id SpecId (1) n.
  std::vector<uint32_t> ids;
  for (size_t i = 5; i < words->size(); i += (*words)[i] >> 16) {
    ASSERT_GT((*words)[i] >> 16, 0u);
    if (((*words)[i] & 0xffff) == 71 && (*words)[i + 2] == 1) ids.push_back((*words)[i + 3]);
  }
  EXPECT_EQ(ids, (std::vector<uint32_t>{0, 1}));
}

// SPIR-V has no bool that comes from outside.
TEST(CompileSpirv, TakesBoolUniformsAsUints) {
  ir::Module module = glsl::ModuleOf(R"(
uniform wet: bool = true
input uv: vec2
function main() -> (color: vec4) {
  %1 = extract.0 @uv : float
  %2 = select @wet, %1, 0.5 : float
  %3 = splat %2 : vec4
  return %3
}
main main
)");
  Diagnostics diagnostics;
  ASSERT_TRUE(glsl::Legalize(module, glsl::Dialect::k450, diagnostics));
  glsl::PrintOptions options;
  options.dialect = glsl::Dialect::k450;
  EXPECT_THAT(glsl::PrintGlsl(module, options), testing::HasSubstr("uniform bool wet;"));
  options.for_spirv = true;
  const std::string shader = glsl::PrintGlsl(module, options);
  EXPECT_THAT(shader, testing::HasSubstr("uniform uint wet;"));
  EXPECT_THAT(shader, testing::HasSubstr("bool(wet) ?"));
  EXPECT_TRUE(CompileSpirv(shader, diagnostics)) << FormatDiagnostics(diagnostics, Sources(), false);
}

TEST(CompileSpirv, GivesTheSameBytes) {
  std::string shader = PrintedForSpirv();
  Diagnostics diagnostics;
  EXPECT_EQ(CompileSpirv(shader, diagnostics), CompileSpirv(shader, diagnostics));
}

TEST(CompileSpirv, ReportsWhatGlslangRefuses) {
  Diagnostics diagnostics;
  EXPECT_FALSE(CompileSpirv("#version 450 core\nvoid main() { x = 1; }\n", diagnostics));
  ASSERT_EQ(diagnostics.all().size(), 1u);
  const Diagnostic& diagnostic = diagnostics.all().front();
  EXPECT_EQ(DiagnosticName(diagnostic.kind), "spirv");
  EXPECT_EQ(diagnostic.message,
            "glslang refuses the shader: ERROR: 0:2: 'x' : undeclared identifier");
  EXPECT_EQ(diagnostics.exit_code(), ExitCode::kInternal);
}

TEST(CompileSpirv, ReportsAMissingMain) {
  Diagnostics diagnostics;
  EXPECT_FALSE(CompileSpirv("#version 450 core\nfloat f() { return 1.0; }\n", diagnostics));
  EXPECT_EQ(diagnostics.exit_code(), ExitCode::kInternal);
}

}  // namespace
}  // namespace texgraph::spirv
