// SPDX-License-Identifier: Apache-2.0
// Shaders from the text of modules, for tests; and glslangValidator's opinion of them.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "compiler/base/diagnostics.h"
#include "compiler/glsl/print_glsl.h"
#include "compiler/ir/module.h"

namespace texgraph::glsl {

// The module that `text` is; a failure and an empty one if it is none.
ir::Module ModuleOf(std::string text);

// The whole shader, legalised and printed, named "test" by version "1.0".
std::string Shader(std::string module_text, Dialect dialect = Dialect::k330,
                   bool as_function = false);

// The same, without what is outside of functions: from the first function's comment or main on.
std::string Functions(std::string module_text, Dialect dialect = Dialect::k330);

// The lines of main between its braces.
std::string MainBody(std::string module_text, Dialect dialect = Dialect::k330);

// What glslangValidator says against a fragment shader; "" if nothing.
std::string Complaint(const std::string& shader);

// Whether glslangValidator accepts the module's shader in both dialects.
testing::AssertionResult IsValid(const std::string& module_text);

// "name: message" of every diagnostic of Legalize, a line each; warnings with "warning: " before
// it.
std::string LegalizeReport(std::string module_text, Dialect dialect = Dialect::k330);

}  // namespace texgraph::glsl
