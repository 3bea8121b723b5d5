// SPDX-License-Identifier: Apache-2.0
#include "compiler/graph/scope.h"

#include <algorithm>
#include <iterator>

namespace texgraph::graph {
namespace {

template <class T>
void AddAll(const std::vector<T>& things, Symbol::Kind kind, SymbolTable& table) {
  for (uint32_t i = 0; i < things.size(); ++i) {
    // The last of equal names, which were reported, is meant.
    auto [symbol, added] = table.Add(things[i].name, {kind, i});
    if (!added) *symbol = {kind, i};
  }
}

}  // namespace

std::string_view KindText(Symbol::Kind kind) {
  switch (kind) {
    case Symbol::Kind::kBuiltin:
      return "built-in input";
    case Symbol::Kind::kParameter:
      return "parameter";
    case Symbol::Kind::kTexture:
      return "texture";
    case Symbol::Kind::kFunction:
      return "function";
    case Symbol::Kind::kFunctionInput:
      return "function input";
    case Symbol::Kind::kNode:
      return "node";
  }
  return "";
}

SymbolTable GlobalSymbols(const Graph& graph) {
  SymbolTable table;
  for (uint32_t i = 0; i < std::size(kBuiltinInputs); ++i) {
    table.Add(kBuiltinInputs[i].name, {Symbol::Kind::kBuiltin, i});
  }
  AddAll(graph.parameters, Symbol::Kind::kParameter, table);
  AddAll(graph.textures, Symbol::Kind::kTexture, table);
  AddAll(graph.functions, Symbol::Kind::kFunction, table);
  return table;
}

Scope::Scope(const SymbolTable& globals, const Subgraph& subgraph)
    : globals_(globals), subgraph_(subgraph) {
  locals_.Reserve(subgraph.nodes.size() + subgraph.inputs.size());
  AddAll(subgraph.inputs, Symbol::Kind::kFunctionInput, locals_);
  AddAll(subgraph.nodes, Symbol::Kind::kNode, locals_);
}

std::optional<Symbol> Scope::Find(std::string_view name) const {
  if (const Symbol* local = locals_.Find(name)) return *local;
  if (const Symbol* global = globals_.Find(name)) return *global;
  return std::nullopt;
}

std::vector<std::string_view> Scope::Names() const {
  // In the order of the document, so that the same text gives the same suggestion.
  std::vector<std::string_view> names;
  for (const Node& node : subgraph_.nodes) names.push_back(node.name);
  for (const FunctionInput& input : subgraph_.inputs) names.push_back(input.name);
  std::vector<std::string_view> globals;
  for (const SymbolTable::Entry& global : globals_.entries()) globals.push_back(global.name);
  std::ranges::sort(globals);
  names.insert(names.end(), globals.begin(), globals.end());
  return names;
}

Reference SplitReference(std::string_view text) {
  Reference reference;
  size_t dot = text.find('.');
  reference.name = text.substr(0, dot);
  if (dot == std::string_view::npos) return reference;
  text.remove_prefix(dot + 1);
  dot = text.find('.');
  reference.port = text.substr(0, dot);
  reference.has_member = dot != std::string_view::npos;
  return reference;
}

}  // namespace texgraph::graph
