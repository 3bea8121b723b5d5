// SPDX-License-Identifier: Apache-2.0
// What a target can hold: textures, outputs, parameters, nesting and rounds of loops.
#pragma once

#include "compiler/base/diagnostics.h"
#include "compiler/ir/module.h"

namespace texgraph::glsl {

// Reports every limit of legalize.h that the part of the module that main reaches exceeds. False if
// one of them is an error.
bool CheckLimits(const ir::Module& module, SourceRange where, Diagnostics& diagnostics);

}  // namespace texgraph::glsl
