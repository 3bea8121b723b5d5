// SPDX-License-Identifier: Apache-2.0
// Drops the members of struct types that nothing reads, so that a shader carries and computes only
// what it uses of a Tile. A part of Specialize, so that less is copied, and of Simplify, when dead
// reads are gone.
#pragma once

#include <vector>

#include "compiler/ir/module.h"

namespace texgraph::passes {

// Sets `changed`, by FunctionId, for the functions that make values of a narrowed type: what went
// into the dropped members may be dead there now. Whether there were any. A struct keeps at least
// one member. Constants of the wider types, and functions that main does not reach, must not be
// looked at any more.
bool NarrowStructs(ir::Module& module, std::vector<bool>& changed);

}  // namespace texgraph::passes
