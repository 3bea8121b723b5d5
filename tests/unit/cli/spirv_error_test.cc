// SPDX-License-Identifier: Apache-2.0
// A shader that glslang refuses would be a mistake of texgraph's own, so no graph brings one about.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compiler/base/diagnostics.h"
#include "compiler/spirv/compile_spirv.h"

namespace texgraph {
namespace {

TEST(CompileSpirv, ReportsWhatGlslangRefuses) {
  Diagnostics diagnostics;
  EXPECT_FALSE(spirv::CompileSpirv("#version 450 core\nvoid main() { missing(); }\n", diagnostics)
                   .has_value());
  EXPECT_EQ(diagnostics.exit_code(), ExitCode::kInternal);
  EXPECT_THAT(FormatDiagnostics(diagnostics, Sources(), false), testing::HasSubstr("[spirv]"));
}

TEST(ValidateGlsl, ReportsWhatGlslangRefuses) {
  Diagnostics good;
  EXPECT_TRUE(
      spirv::ValidateGlsl("#version 330\nout vec4 c;\nvoid main() { c = vec4(1.0); }\n", good));
  EXPECT_TRUE(good.all().empty());
  for (const char* wrong :
       {"#version 330\nvoid main() { missing(); }\n",
        "#version 330\nfloat f(float x);\nvoid main() { f(1.0); }\n",
        "#version 450 core\nlayout(binding = 0) uniform float x;\nvoid main() {}\n"}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(spirv::ValidateGlsl(wrong, diagnostics)) << wrong;
    EXPECT_EQ(diagnostics.exit_code(), ExitCode::kInternal);
  }
}

}  // namespace
}  // namespace texgraph
