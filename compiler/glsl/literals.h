// SPDX-License-Identifier: Apache-2.0
// Constants as GLSL: the shortest text that means the same bits. "vec3(1.0)", "-2", "7u", "true",
// "Tile(ivec2(0), vec2(0.5), 0u)", "float[3](0.25, 0.5, 0.25)".
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "compiler/ir/module.h"

namespace texgraph::glsl {

// The name of a type as the shader writes it: structs may have been renamed.
using TypeNamer = std::function<std::string(ir::TypeId)>;

void AppendScalar(ir::Scalar scalar, uint32_t word, std::string& out);
void AppendLiteral(const ir::Types& types, ir::TypeId type, std::span<const uint32_t> words,
                   const TypeNamer& name_of, std::string& out);

// Whether all words are equal.
bool IsSplat(std::span<const uint32_t> words);
// Whether AppendScalar begins with a minus.
bool IsNegative(ir::Scalar scalar, uint32_t word);

}  // namespace texgraph::glsl
