// SPDX-License-Identifier: Apache-2.0
// Checks every rule that module.h and op.h state: types, scopes, order, regions, calls, callees before callers.
#pragma once

#include <string>

#include "compiler/ir/module.h"

namespace texgraph::ir {

// "" if the module is well formed; else what is wrong and where ("function layer, %12: add of vec2 and vec3").
std::string Verify(const Module& module);

}  // namespace texgraph::ir
