// SPDX-License-Identifier: Apache-2.0
// Loops that end before their last round: where all that the body does is an if without which the
// carried values stay as they are, and whose condition depends on them alone, the condition is
// false for ever when it is false once. Layers from the topmost down until nothing shows through
// are such a loop.
#pragma once

#include "compiler/ir/module.h"

namespace texgraph::ir {

// The if of such a loop; invalid if the loop runs all its rounds.
ValueId EndingIf(const Function& function, const ForLoop& loop);

// How often the body runs, as a rule: a loop that ends early is counted as two rounds.
uint32_t TypicalRounds(const Function& function, const ForLoop& loop);

}  // namespace texgraph::ir
