// SPDX-License-Identifier: Apache-2.0
// What the names in one subgraph mean.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/base/name_map.h"
#include "compiler/graph/graph.h"

namespace texgraph::graph {

struct Symbol {
  enum class Kind : uint8_t { kBuiltin, kParameter, kTexture, kFunction, kFunctionInput, kNode };
  Kind kind;
  uint32_t index;  // into kBuiltinInputs, or the vector of the graph or subgraph
};

std::string_view KindText(Symbol::Kind kind);  // "built-in input", "parameter", ...

using SymbolTable = NameMap<Symbol>;

// Built-in inputs, parameters, textures and functions.
SymbolTable GlobalSymbols(const Graph& graph);

class Scope {
 public:
  // Both must outlive the scope.
  Scope(const SymbolTable& globals, const Subgraph& subgraph);

  std::optional<Symbol> Find(std::string_view name) const;
  std::vector<std::string_view> Names() const;

 private:
  const SymbolTable& globals_;
  const Subgraph& subgraph_;
  SymbolTable locals_;
};

// "name" or "name.port".
struct Reference {
  std::string_view name;
  std::optional<std::string_view> port;
  bool has_member = false;  // a second dot, which means nothing
};
Reference SplitReference(std::string_view text);

}  // namespace texgraph::graph
