// SPDX-License-Identifier: Apache-2.0
// After it, every operation of the module can be spelled in the dialect, within the limits that drivers have (PrintGlsl then
// cannot fail): operations that a dialect lacks are written with others, functions too long for a driver are split.
#pragma once

#include "compiler/base/diagnostics.h"
#include "compiler/glsl/print_glsl.h"
#include "compiler/ir/module.h"

namespace texgraph::glsl {

// False if the target cannot do it; reported as kTargetLimit or kLoopLimit.
bool Legalize(ir::Module& module, Dialect dialect, Diagnostics& diagnostics);

}  // namespace texgraph::glsl
