// SPDX-License-Identifier: Apache-2.0
// The conversions that a connection makes by itself: int to float, and a scalar to a vector. For
// any other pair of types, the blocks that convert.
#pragma once

#include <optional>
#include <string>

#include "compiler/blocks/block.h"
#include "compiler/ir/type.h"

namespace texgraph::graph {

// How many conversions lead from one type to the other: 0 to 2, or nothing if it cannot be done.
std::optional<int> ConversionCost(ir::TypeId from, ir::TypeId to);

// "; the block 'rgb' converts", with names of blocks that the library has; else "".
std::string ConvertingBlocks(ir::TypeId from, ir::TypeId to, const ir::Types& types,
                             const blocks::Library& library);

}  // namespace texgraph::graph
