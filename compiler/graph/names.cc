// SPDX-License-Identifier: Apache-2.0
#include "compiler/graph/names.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/base/name_map.h"
#include "compiler/base/text.h"
#include "compiler/graph/graph.h"

namespace texgraph::graph {
namespace {

bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool IsDigit(char c) { return c >= '0' && c <= '9'; }

// Why this is no name; "" if it is one.
std::string WhyNoName(std::string_view name) {
  if (name.empty()) return "a name must not be empty";
  if (name.size() > kMaxNameLength) {
    return fmt::format("the name has {} characters, the limit is {}", name.size(), kMaxNameLength);
  }
  if (!IsIdentifier(name) || !IsLetter(name[0])) {
    return fmt::format(
        "'{}' is no name: names are letters, digits and '_', and begin with a letter",
        Printable(name));
  }
  return {};
}

// Why a name cannot stand in a shader; "" if it can.
std::string WhyNotBound(std::string_view name) {
  if (std::string why = WhyNoName(name); !why.empty()) return why;
  if (name.find("__") != std::string_view::npos) {
    return fmt::format("'{}' has '__', which GLSL keeps for itself", name);
  }
  if (IsReservedInGlsl(name)) {
    return fmt::format(
        "'{}' is a word of GLSL, and programs bind this by its name; take another, 'my_{}' say",
        name, name);
  }
  return {};
}

bool Report(std::string why, SourceRange range, Diagnostics& diagnostics) {
  if (why.empty()) return true;
  diagnostics.Error(DiagnosticKind::kBadName, range, std::move(why));
  return false;
}

struct Owner {
  std::string_view kind;  // "parameter"
  SourceRange range;
};
using Namespace = NameMap<Owner>;

void ReportTaken(std::string_view name, Owner owner, const Owner& known, Diagnostics& diagnostics) {
  Diagnostic& error =
      diagnostics.Error(DiagnosticKind::kDuplicateName, owner.range,
                        fmt::format("{} '{}' has the name of a {}", owner.kind, name, known.kind));
  if (known.range.source.valid()) {
    error.AddNote(known.range, fmt::format("the {} is here", known.kind));
  }
}

// Adds a name, or reports that it is taken. Names of equal kind in one object are equal keys, which
// were reported as such.
void AddName(Namespace& names, std::string_view name, Owner owner, Diagnostics& diagnostics) {
  auto [known, fresh] = names.Add(name, owner);
  if (!fresh && known->kind != owner.kind) ReportTaken(name, owner, *known, diagnostics);
}

void CheckFunction(const Subgraph& function, const Namespace& globals, Diagnostics& diagnostics) {
  Namespace names;
  for (const FunctionInput& input : function.inputs) {
    const Owner* global = globals.Find(input.name);
    if (global && global->kind != "built-in input") names.Add(input.name, *global);
    AddName(names, input.name, {"function input", input.range}, diagnostics);
  }
  for (const Node& node : function.nodes) {
    if (const Owner* global = globals.Find(node.name)) names.Add(node.name, *global);
    AddName(names, node.name, {"node", node.range}, diagnostics);
  }
}

}  // namespace

bool CheckInnerName(std::string_view name, SourceRange range, Diagnostics& diagnostics) {
  return Report(WhyNoName(name), range, diagnostics);
}

bool CheckBoundName(std::string_view name, SourceRange range, Diagnostics& diagnostics) {
  return Report(WhyNotBound(name), range, diagnostics);
}

std::string NameOfFile(std::string_view path) {
  path = path.substr(path.find_last_of('/') + 1);  // npos + 1 is 0
  path = path.substr(0, path.find('.', 1));
  std::string name;
  for (char c : path) {
    if (IsLetter(c) || IsDigit(c)) {
      name += c;
    } else if (!name.empty() && name.back() != '_') {
      name += '_';
    }
    if (name.size() == kMaxNameLength) break;
  }
  while (!name.empty() && name.back() == '_') name.pop_back();
  if (name.empty()) return "graph";
  if (!IsLetter(name[0]) || IsReservedInGlsl(name)) name = "graph_" + name;
  return name.substr(0, kMaxNameLength);
}

void CheckNamespace(const Graph& graph, Diagnostics& diagnostics) {
  Namespace names;
  names.Reserve(graph.parameters.size() + graph.textures.size() + graph.functions.size() + 16);
  for (const BuiltinInput& input : kBuiltinInputs) {
    names.Add(input.name, {"built-in input", {}});
  }
  for (const Parameter& parameter : graph.parameters) {
    AddName(names, parameter.name, {"parameter", parameter.range}, diagnostics);
  }
  for (const Texture& texture : graph.textures) {
    AddName(names, texture.name, {"texture", texture.range}, diagnostics);
  }
  for (const Subgraph& function : graph.functions) {
    AddName(names, function.name, {"function", function.range}, diagnostics);
  }
  for (const Subgraph& function : graph.functions) CheckFunction(function, names, diagnostics);
  // Nodes come last: nothing is compared with them any more.
  for (const Node& node : graph.main.nodes) {
    if (const Owner* known = names.Find(node.name)) {
      ReportTaken(node.name, {"node", node.range}, *known, diagnostics);
    }
  }
}

}  // namespace texgraph::graph
