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

}  // namespace
}  // namespace texgraph
