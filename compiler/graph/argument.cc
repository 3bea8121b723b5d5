// SPDX-License-Identifier: Apache-2.0
#include "compiler/graph/argument.h"

#include <fmt/format.h>

namespace texgraph::graph {
namespace {

void AppendNumber(const DocumentNode& node, Argument& argument) {
  argument.numbers.push_back(node.number);
  argument.is_integer = argument.is_integer && node.is_integer;
}

bool Fail(const DocumentNode& node, std::string message, Diagnostics& diagnostics) {
  diagnostics.Error(DiagnosticKind::kBadValue, node.range, std::move(message));
  return false;
}

// One row of a list of vectors or of a matrix, or a vector; `columns` is the number that it must
// have, 0 for any.
bool ReadRow(const Document& document, const DocumentNode& row, uint32_t columns,
             Argument& argument, Diagnostics& diagnostics) {
  if (columns != 0 && row.child_count != columns) {
    return Fail(row,
                fmt::format("this row has {} numbers, the first has {}", row.child_count, columns),
                diagnostics);
  }
  for (const DocumentNode& child : document.children(row)) {
    if (child.kind != DocumentKind::kNumber) {
      return Fail(child, fmt::format("a vector has numbers only, got {}", KindText(child.kind)),
                  diagnostics);
    }
    AppendNumber(child, argument);
  }
  return true;
}

bool ReadVector(const Document& document, const DocumentNode& node, Argument& argument,
                Diagnostics& diagnostics) {
  argument.kind = Argument::Kind::kVector;
  if (node.child_count == 0) return Fail(node, "an empty array is no value", diagnostics);
  const DocumentNode& first = document.nodes[node.first_child];
  if (first.kind != DocumentKind::kArray) return ReadRow(document, node, 0, argument, diagnostics);
  if (first.child_count == 0) return Fail(first, "an empty array is no value", diagnostics);
  argument.columns = first.child_count;
  for (const DocumentNode& row : document.children(node)) {
    if (row.kind != DocumentKind::kArray) {
      return Fail(row, fmt::format("expected a row like the first, got {}", KindText(row.kind)),
                  diagnostics);
    }
    if (!ReadRow(document, row, first.child_count, argument, diagnostics)) return false;
  }
  return true;
}

}  // namespace

std::string_view KindText(DocumentKind kind) {
  switch (kind) {
    case DocumentKind::kNull:
      return "null";
    case DocumentKind::kBool:
      return "a bool";
    case DocumentKind::kNumber:
      return "a number";
    case DocumentKind::kString:
      return "text";
    case DocumentKind::kArray:
      return "an array";
    case DocumentKind::kObject:
      return "an object";
  }
  return "";
}

std::optional<Argument> ReadArgument(const Document& document, const DocumentNode& node,
                                     Diagnostics& diagnostics) {
  Argument argument;
  argument.range = node.range;
  argument.is_integer = true;
  bool ok = true;
  switch (node.kind) {
    case DocumentKind::kBool:
      argument.kind = Argument::Kind::kBool;
      argument.boolean = node.boolean;
      break;
    case DocumentKind::kNumber:
      argument.kind = Argument::Kind::kNumber;
      AppendNumber(node, argument);
      break;
    case DocumentKind::kString:
      argument.kind = Argument::Kind::kString;
      argument.text = node.text;
      break;
    case DocumentKind::kArray:
      ok = ReadVector(document, node, argument, diagnostics);
      break;
    case DocumentKind::kNull:
      ok = Fail(node, "null is no value; leave the key out instead", diagnostics);
      break;
    case DocumentKind::kObject:
      ok = Fail(node, "an object is no value; nodes stand in 'nodes' and are named here",
                diagnostics);
      break;
  }
  if (!ok) return std::nullopt;
  if (argument.numbers.empty()) argument.is_integer = false;
  return argument;
}

}  // namespace texgraph::graph
