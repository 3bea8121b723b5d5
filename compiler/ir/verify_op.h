// SPDX-License-Identifier: Apache-2.0
// The typing rules of single instructions, by the shapes of op.h.
#pragma once

#include <string>

#include "compiler/ir/module.h"

namespace texgraph::ir {

// Whether values of the type may be computed, stored, selected and returned: no void, sampler,
// field or tuple, nor anything made of them.
bool IsPlainType(const Types& types, TypeId type);

// "" if the operands of `inst` fit its operation and its result type; else what they are.
// `function` is the id of the function that it stands in: calls go to earlier ones only. All ids in
// `inst` and its operands must be in range. The regions of ifs and loops are the verifier's own
// business.
std::string CheckInst(const Module& module, FunctionId function, const Inst& inst);

}  // namespace texgraph::ir
