// SPDX-License-Identifier: Apache-2.0
// Checks every rule that module.h and op.h state: types, scopes, order, regions, calls, callees
// before callers.
#pragma once

#include <optional>
#include <string>

#include "compiler/ir/module.h"

namespace texgraph::ir {

// Regions nest no deeper, so that whoever walks them may do so by recursion.
inline constexpr uint32_t kMaxRegionDepth = 256;

struct Violation {
  FunctionId function;  // invalid: of the module
  ValueId value;        // invalid: of the whole function
  std::string message;  // "function layer, %12: add of vec2 and vec3 giving vec3"
};

// The first violation, in the order in which Print prints.
std::optional<Violation> FindViolation(const Module& module);

// "" if the module is well formed; else what is wrong and where.
std::string Verify(const Module& module);

}  // namespace texgraph::ir
