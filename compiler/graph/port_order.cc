// SPDX-License-Identifier: Apache-2.0
// Ports that are the least and the greatest of something, or lists of one length: a block says so
// with "@ordered", "@not_below" and "@as_long_as", and what is known of their values when the graph
// is checked must obey it.
#include <fmt/format.h>

#include <bit>
#include <span>

#include "compiler/graph/subgraph_checker.h"

namespace texgraph::graph {
namespace {

// The first component of `most` that is below its fellow in `least`.
std::optional<size_t> FirstBelow(ir::TypeId type, std::span<const uint32_t> least,
                                 std::span<const uint32_t> most) {
  for (size_t i = 0; i < least.size(); ++i) {
    if (ir::NumberOf(type, most[i]) < ir::NumberOf(type, least[i])) return i;
  }
  return std::nullopt;
}

// Of a value port, or of a function port that is the same everywhere.
ir::ConstId KnownValue(const BoundPort& bound) {
  if (auto* constant = std::get_if<ConstantValue>(&bound.source)) return constant->value;
  if (auto* constant = std::get_if<FieldOfConstant>(&bound.source)) return constant->value;
  return {};
}

std::string WordText(ir::TypeId type, uint32_t word) {
  // The shortest text of a float, not of the double that it is.
  if (ir::IsFloat(type)) return fmt::format("{}", std::bit_cast<float>(word));
  return fmt::format("{}", ir::NumberOf(type, word));
}

}  // namespace

void SubgraphChecker::CheckPortOrder(const CheckedNode& checked, const blocks::Overload& overload) {
  // Where a port is wrong, the others don't stand at their places.
  if (checked.inputs.size() != overload.inputs.size()) return;
  for (uint32_t i = 0; i < overload.inputs.size(); ++i) {
    const blocks::Port& port = overload.inputs[i];
    if (port.not_below) CheckNotBelow(checked, overload, i);
    if (port.transitions_of) CheckTransitions(checked, overload, i);
    if (port.as_long_as) CheckSameLength(checked, overload, i);
    const ir::ConstId constant = KnownValue(checked.inputs[i]);
    if (!port.ordered || !constant) continue;
    const ir::TypeId type = check_.module.constant(constant).type;
    std::span<const uint32_t> words = check_.module.Words(constant);
    auto at = FirstBelow(type, words.first(words.size() - 1), words.subspan(1));
    if (!at) continue;
    Place place{"port", port.name, "node", checked.node->name, port.range};
    place.AddNote(check_.diagnostics.Error(
        DiagnosticKind::kValueRange, checked.inputs[i].range,
        fmt::format("{} takes its least value first, got {} before {}", place.Text(),
                    WordText(type, words[*at]), WordText(type, words[*at + 1]))));
  }
}

// The caret is at this list, the note at the other.
void SubgraphChecker::CheckSameLength(const CheckedNode& checked, const blocks::Overload& overload,
                                      uint32_t index) {
  const blocks::Port& port = overload.inputs[index];
  const blocks::Port& other = overload.inputs[*port.as_long_as];
  const BoundPort& list = checked.inputs[index];
  const BoundPort& measure = checked.inputs[*port.as_long_as];
  const ir::ConstId here = KnownValue(list), there = KnownValue(measure);
  if (!here || !there) return;
  auto length = [&](ir::ConstId value) {
    return check_.module.types.ElementCount(check_.module.constant(value).type);
  };
  if (length(here) == length(there)) return;
  auto count = [](uint32_t elements) {
    return fmt::format("{} element{}", elements, elements == 1 ? "" : "s");
  };
  Place place{"port", port.name, "node", checked.node->name, port.range};
  Diagnostic& error = check_.diagnostics.Error(
      DiagnosticKind::kListLength, list.range,
      fmt::format("{} takes {}, as many as port '{}' has; got {}", place.Text(),
                  count(length(there)), other.name, length(here)));
  error.AddNote(measure.range,
                fmt::format("port '{}' has {} here", other.name, count(length(there))));
  place.AddNote(error);
}

// The caret is at the port that the node names; of two, at the greatest value.
void SubgraphChecker::CheckNotBelow(const CheckedNode& checked, const blocks::Overload& overload,
                                    uint32_t most_index) {
  const uint32_t least_index = *overload.inputs[most_index].not_below;
  const BoundPort& least_bound = checked.inputs[least_index];
  const BoundPort& most_bound = checked.inputs[most_index];
  const ir::ConstId least = KnownValue(least_bound);
  const ir::ConstId most = KnownValue(most_bound);
  if (!least || !most) return;
  const ir::TypeId type = check_.module.constant(most).type;
  std::span<const uint32_t> low = check_.module.Words(least);
  std::span<const uint32_t> high = check_.module.Words(most);
  auto at = FirstBelow(type, low, high);
  if (!at) return;
  // A default has the place of its node.
  auto is_default = [&](const BoundPort& bound) {
    return bound.range.begin == checked.node->range.begin;
  };
  const bool at_most = !is_default(most_bound);
  const blocks::Port& port = overload.inputs[at_most ? most_index : least_index];
  const blocks::Port& other = overload.inputs[at_most ? least_index : most_index];
  const BoundPort& other_bound = at_most ? least_bound : most_bound;
  const std::string got = WordText(type, (at_most ? high : low)[*at]);
  const std::string limit = WordText(type, (at_most ? low : high)[*at]);
  const std::string_view relation = at_most ? "below" : "above";
  Place place{"port", port.name, "node", checked.node->name, port.range};
  Diagnostic& error = check_.diagnostics.Error(
      DiagnosticKind::kValueRange, (at_most ? most_bound : least_bound).range,
      fmt::format("{} must not be {} port '{}', but {} is {} {}{}", place.Text(), relation,
                  other.name, got, relation, limit,
                  ir::IsScalar(type) ? "" : fmt::format(" in {}", "xyzw"[*at])));
  if (is_default(other_bound)) {
    error.AddNote(other.range, fmt::format("port '{}', whose default is {}, is declared here",
                                           other.name, limit));
  } else {
    error.AddNote(other_bound.range, fmt::format("port '{}' is {} here", other.name, limit));
  }
  place.AddNote(error);
}

}  // namespace texgraph::graph
