// SPDX-License-Identifier: Apache-2.0
// The rules for the names that a graph gives to things. What an engine binds, parameters, textures,
// outputs and the graph itself, is called in the shader what the graph calls it, in every dialect.
// Nodes, functions and their inputs are the graph's own: a name that GLSL takes for itself is
// changed by the printer, as any other that clashes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "compiler/base/diagnostics.h"

namespace texgraph::graph {

struct Graph;

inline constexpr size_t kMaxNameLength = 64;

// [A-Za-z][A-Za-z0-9_]*, at most kMaxNameLength bytes; else kBadName.
bool CheckInnerName(std::string_view name, SourceRange range, Diagnostics& diagnostics);
// The same, and no "__" and no word of GLSL.
bool CheckBoundName(std::string_view name, SourceRange range, Diagnostics& diagnostics);

// The file's name without folders and extensions, made a name: "walls/brick-wall.v2.json" gives
// "brick_wall".
std::string NameOfFile(std::string_view path);

// Reports names that two things share (kDuplicateName). Built-in inputs, parameters, textures and
// functions have names in the whole graph; nodes and inputs of a function only in it. A function's
// input may have the name of a built-in input, which it then replaces inside the function.
void CheckNamespace(const Graph& graph, Diagnostics& diagnostics);

}  // namespace texgraph::graph
