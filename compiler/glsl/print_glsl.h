// SPDX-License-Identifier: Apache-2.0
// Prints a legalised module as GLSL that a person can read and edit: sections inputs, parameters, textures, outputs, blocks,
// main; the user's names; one short comment a node. It cannot fail, and the text depends on its arguments alone.
#pragma once

#include <cstdint>
#include <string>

#include "compiler/ir/module.h"

namespace texgraph::glsl {

enum class Dialect : uint8_t { k330, k450 };

struct PrintOptions {
  Dialect dialect = Dialect::k330;
  bool as_function = false;  // a function named `name` instead of main; inputs are its parameters, outputs its result(s)
  std::string name;          // of the graph: an identifier
  std::string version;       // of texgraphc, for the first comment line
};

std::string PrintGlsl(const ir::Module& module, const PrintOptions& options);

}  // namespace texgraph::glsl
