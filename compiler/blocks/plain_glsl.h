// SPDX-License-Identifier: Apache-2.0
// A block as a complete fragment shader in plain GLSL, so that a GLSL compiler can be asked whether
// it is one.
#pragma once

#include <string>

#include "compiler/blocks/block.h"

namespace texgraph::blocks {

// The file's own text behind the shared types, prototypes of the footprint and the functions of the
// blocks that it calls; with genType defined as `overload.gen_type`, or as float if it stands for
// nothing, and arrays of any length with the greatest one. Version 4.50.
std::string PlainGlsl(Library& library, const Sources& sources, const Block& block,
                      const Overload& overload);

}  // namespace texgraph::blocks
