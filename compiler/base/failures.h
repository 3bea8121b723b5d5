// SPDX-License-Identifier: Apache-2.0
// The ends of a program that no Diagnostics reaches: memory that runs out, and mistakes of the
// program's own. Each removes the temporary files, says one line on standard error and ends with
// its exit code, so that nothing is ever half written.
#pragma once

namespace texgraph {

// For the first lines of main(), after PrepareProcess(): exit code 4 when memory runs out; 70 for
// an exception that nobody catches and for the signals of a crash, a stack that is used up on this
// thread included.
void PrepareFailures();

}  // namespace texgraph
