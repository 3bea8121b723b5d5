// SPDX-License-Identifier: Apache-2.0
// Literals become constants of the type that is needed where they stand.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "compiler/base/diagnostics.h"
#include "compiler/graph/graph.h"
#include "compiler/ir/module.h"

namespace texgraph::graph {

// What takes a value, for messages: "port 'rows' of node 'grid'". Made into text only for these.
struct Place {
  std::string_view kind;  // "port", "parameter", "input", "output"
  std::string_view name;
  std::string_view owner_kind;  // "node", "function", or ""
  std::string_view owner;
  SourceRange declared;  // for a note, or no place
  DiagnosticKind mismatch = DiagnosticKind::kPortType;

  std::string Text() const;
  // Adds the note about where it is declared.
  void AddNote(Diagnostic& diagnostic) const;
};

// "0.5", "true", "3 numbers", "the text 'x'".
std::string ArgumentText(const Argument& argument);
// "12", "0.5".
std::string NumberText(double number);

// For a text that other programs read as a number or a bool, "yes" and "0x10": what to write
// instead, to go after a message. Else "".
std::string_view TextHint(std::string_view text);

// How many conversions a literal needs to be of the type, nothing if it cannot. Looks at the kinds
// of numbers, not at their sizes.
std::optional<int> LiteralCost(const Argument& argument, ir::TypeId type, const ir::Types& types);

// The literal as a constant; of an array of any length, with as many elements as there are. Reports
// what does not fit: its kind as place.mismatch, its size as kNumberRange; a float that becomes
// zero with a warning.
std::optional<ir::ConstId> MakeLiteral(const Argument& argument, ir::TypeId type,
                                       const Place& place, ir::Module& module,
                                       Diagnostics& diagnostics);

// A constant in another type, to which ConversionCost leads.
ir::ConstId ConvertConstant(ir::ConstId constant, ir::TypeId type, ir::Module& module);

// False, with kValueRange or kSizeLimit at `range`, if an array has too few elements or too many.
bool CheckLength(ir::ConstId constant, uint32_t minimum, uint32_t maximum, SourceRange range,
                 const Place& place, const ir::Module& module, Diagnostics& diagnostics);

struct ValueLimits {
  std::optional<double> minimum, maximum;  // of each component
};
// False, with kValueRange at `range`, if a component lies outside.
bool CheckLimits(ir::ConstId constant, const ValueLimits& limits, SourceRange range,
                 const Place& place, const ir::Module& module, Diagnostics& diagnostics);

}  // namespace texgraph::graph
