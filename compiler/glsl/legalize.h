// SPDX-License-Identifier: Apache-2.0
// After it, every operation of the module can be spelled in the dialect, within the limits that
// drivers have (PrintGlsl then cannot fail): operations that a dialect lacks are written with
// others, indexes stay inside their arrays, only main names the graph's inputs, and a function with
// one result returns it. Functions too long for a driver are PrintGlsl's care: it uses their
// variables again.
#pragma once

#include "compiler/base/diagnostics.h"
#include "compiler/glsl/print_glsl.h"
#include "compiler/ir/module.h"

namespace texgraph::glsl {

// Texture units: every OpenGL 3.3 driver has 16 for fragment shaders, most have 32.
inline constexpr size_t kSureTextures = 16;
inline constexpr size_t kMostTextures = 32;
// GL_MAX_DRAW_BUFFERS is at least this.
inline constexpr size_t kMostOutputs = 8;
// GL_MAX_FRAGMENT_UNIFORM_COMPONENTS is at least 1,024 and nowhere more than 4,096 as a rule.
inline constexpr size_t kSureUniformComponents = 1024;
inline constexpr size_t kMostUniformComponents = 4096;
// Ifs and loops inside one another: compilers of GLSL parse and traverse them recursively.
inline constexpr size_t kMostNesting = 200;
// llvmpipe ends loops without a word after this many rounds of all loops of a shader together.
inline constexpr uint64_t kMostRounds = 65535;

// False if the target cannot do it; reported as kTargetLimit or kLoopLimit, at `where`.
bool Legalize(ir::Module& module, Dialect dialect, Diagnostics& diagnostics,
              SourceRange where = {});

}  // namespace texgraph::glsl
