// SPDX-License-Identifier: Apache-2.0
// Checking of block files: names, types, and what the block language leaves out of GLSL. Every
// mistake is reported with its place.
#pragma once

#include "compiler/blocks/file.h"

namespace texgraph::blocks {

// Fills everything in `file` behind its syntax tree; `file.valid` tells whether it is right.
void CheckFile(Program& program, File& file);

// The checked body of a function, made when first asked for. Null if it is wrong (reported once).
const TypedFunction* CheckBody(Program& program, File& file, uint32_t function,
                               ir::TypeId gen_type);

// Sets the block's texts and its ports' help, units, defaults and ranges from the lines of
// documentation (check_docs.cc).
void CheckDocs(Program& program, File& file);

// The value of an expression that names constants only, as a constant of that type; `splat` lets a
// scalar stand for a vector. Invalid, and reported as `kind`, if it is none.
ir::ConstId CheckConstant(Program& program, File& file, const Expr& expr, ir::TypeId type,
                          bool splat, DiagnosticKind kind);

// A scalar or vector may turn into another of its width without being asked: int into uint and
// float, uint into float. An array may stand for one of any length.
bool ConvertsTo(const ir::Types& types, ir::TypeId from, ir::TypeId to);
// An array as a 'const' parameter may have it, "vec2[]".
inline bool IsUnsized(const ir::Types& types, ir::TypeId type) {
  return types.Kind(type) == ir::TypeKind::kArray && types[type].length == 0;
}

// "float[4]", "genType" replaced; invalid and reported if there is no such type here. An array
// without a length gets `unsized_length`, or is refused if that is 0, or stays without one.
inline constexpr uint32_t kAnyLength = 0xffffffffu;
ir::TypeId ResolveType(Program& program, File& file, const TypeName& name, ir::TypeId gen_type,
                       uint32_t unsized_length = 0);

// Whether a variable, a parameter or a function may have this name; reports it if not.
bool CheckName(Diagnostics& diagnostics, std::string_view name, SourceRange range,
               bool is_function);

}  // namespace texgraph::blocks
