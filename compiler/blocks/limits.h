// SPDX-License-Identifier: Apache-2.0
// What a block file may have at most. They keep strangers' files from taking the stack, the memory
// or the driver; docs/blocks.md states them to users.
#pragma once

#include <cstddef>
#include <cstdint>

namespace texgraph::blocks {

inline constexpr size_t kMaxFileBytes = size_t{1} << 20;
// Of expressions, and of statements, each counted with what is in it.
inline constexpr uint32_t kMaxNesting = 100;
inline constexpr uint32_t kMaxCallDepth = 64;  // of blocks' functions that call each other
// Of the recursion through checked functions, in units of what an expression takes of the stack:
// all of it fits into 256 kB.
inline constexpr uint32_t kMaxLoweringDepth = 700;
inline constexpr uint32_t kStatementDepth = 3;
inline constexpr uint32_t kCallDepth = 8;
inline constexpr uint32_t kMaxLocals = 4096;  // of one function
inline constexpr uint32_t kMaxArrayLength = 1024;
inline constexpr uint32_t kMaxTypeWords = 4096;  // 32-bit words of one value
inline constexpr uint32_t kMaxStructDepth = 16;
// Elements of an array that is written at a computed index.
inline constexpr uint32_t kMaxComputedWrites = 64;
// llvmpipe silently ends the loops of a shader after so many iterations.
inline constexpr uint64_t kMaxTrips = 65535;

}  // namespace texgraph::blocks
