// SPDX-License-Identifier: Apache-2.0
// Lists of transition tiles ("@transitions"): a pattern for each way in which the four corners of a
// tile can be of several families, so that no tile is missing when the shader runs.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "compiler/graph/literal.h"
#include "compiler/graph/subgraph_checker.h"

namespace texgraph::graph {
namespace {

// The families of the tile, of the one to the right, of the upper one and of the one between.
std::array<size_t, 4> CornersOf(size_t number, size_t families) {
  std::array<size_t, 4> corners{};
  for (size_t& corner : corners) {
    corner = number % families;
    number /= families;
  }
  return corners;
}

bool AllAlike(const std::array<size_t, 4>& corners) {
  return std::ranges::all_of(corners, [&](size_t corner) { return corner == corners[0]; });
}

}  // namespace

void SubgraphChecker::CheckTransitions(const CheckedNode& checked, const blocks::Overload& overload,
                                       uint32_t index) {
  const blocks::Port& port = overload.inputs[index];
  const BoundPort& bound = checked.inputs[index];
  const BoundPort& of = checked.inputs[*port.transitions_of];
  const auto* patterns = std::get_if<ConstantValue>(&bound.source);
  const auto* families = std::get_if<ConstantValue>(&of.source);
  if (!patterns || !families || !patterns->value || !families->value) return;
  int64_t greatest = 0;
  for (uint32_t word : check_.module.Words(families->value)) {
    greatest = std::max<int64_t>(greatest, static_cast<int32_t>(word));
  }
  // What is greater than a list can hold is as wrong as 1,000.
  const size_t count = static_cast<size_t>(std::min<int64_t>(greatest, 1000)) + 1;
  const size_t expected = count * count * count * count;
  const std::span<const uint32_t> words = check_.module.Words(patterns->value);
  Place place{"port", port.name, "node", checked.node->name, port.range};
  auto report = [&](std::string message) {
    Diagnostic& error =
        check_.diagnostics.Error(DiagnosticKind::kTransitionSet, bound.range, std::move(message));
    error.AddNote(of.range, fmt::format("the greatest family is {} here", greatest));
    place.AddNote(error);
  };
  if (words.size() != expected) {
    return report(fmt::format("{} takes {} patterns, for four corners of {} {}; got {}",
                              place.Text(), expected, count, count == 1 ? "family" : "families",
                              words.size()));
  }
  std::optional<size_t> first;
  size_t missing = 0;
  for (size_t i = 0; i < words.size(); ++i) {
    if (static_cast<int32_t>(words[i]) >= 0 || AllAlike(CornersOf(i, count))) continue;
    if (!first) first = i;
    ++missing;
  }
  if (!first) return;
  const auto [here, right, up, both] = CornersOf(*first, count);
  report(
      fmt::format("{} has no pattern at number {}, for family {} here, {} to the right, {} above "
                  "and {} between{}",
                  place.Text(), *first, here, right, up, both,
                  missing == 1 ? "" : fmt::format("; {} are missing in all", missing)));
}

}  // namespace texgraph::graph
