// SPDX-License-Identifier: Apache-2.0
#include "tests/unit/graph/graph_testing.h"

#include <fmt/format.h>

#include <ctime>
#include <utility>

#include "compiler/base/text.h"

namespace texgraph::graph {
namespace {

std::string Place(SourceRange range, const Sources& sources) {
  if (!range.source.valid()) return "none";
  LineColumn at = sources.Locate(range.source, range.begin);
  return fmt::format("{}:{}", at.line, at.column);
}

// Tests only: the depth is bounded by kMaxNesting.
void AppendTree(const Document& document, const DocumentNode& node, std::string& out) {
  switch (node.kind) {
    case DocumentKind::kNull:
      out += "null";
      return;
    case DocumentKind::kBool:
      out += node.boolean ? "true" : "false";
      return;
    case DocumentKind::kNumber:
      out += node.is_integer ? fmt::format("{}", node.integer) : DoubleText(node.number);
      return;
    case DocumentKind::kString:
      out += JsonQuoted(node.text);
      return;
    default:
      break;
  }
  bool object = node.kind == DocumentKind::kObject;
  out += object ? "{" : "[";
  bool first = true;
  for (const DocumentNode& child : document.children(node)) {
    if (!first) out += ", ";
    first = false;
    if (object) out += JsonQuoted(child.key) + ": ";
    AppendTree(document, child, out);
  }
  out += object ? "}" : "]";
}

}  // namespace

std::vector<std::string> Places(const Diagnostics& diagnostics, const Sources& sources) {
  std::vector<std::string> places;
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    std::string text = diagnostic.severity == Severity::kWarning ? "warning: " : "";
    text += Place(diagnostic.range, sources);
    text += fmt::format(" {}", DiagnosticName(diagnostic.kind));
    for (const Diagnostic::Note& note : diagnostic.notes) {
      text += fmt::format(" ({})", Place(note.range, sources));
    }
    places.push_back(std::move(text));
  }
  return places;
}

std::string Messages(const Diagnostics& diagnostics) {
  std::string out;
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    out += diagnostic.message + "\n";
    for (const Diagnostic::Note& note : diagnostic.notes) out += "  " + note.message + "\n";
  }
  return out;
}

ReadText::ReadText(std::string text, DocumentFormat format, std::string name)
    : source(sources.Add(std::move(name), std::move(text))),
      document(ReadDocument(source, format, sources, diagnostics)) {}

ReadGraphText::ReadGraphText(std::string text, DocumentFormat format, std::string name)
    : source(sources.Add(std::move(name), std::move(text))),
      graph(ReadGraph(source, format, sources, diagnostics)) {}

double CpuSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

std::string TreeText(const Document& document) {
  std::string out;
  AppendTree(document, document.nodes.at(0), out);
  return out;
}

}  // namespace texgraph::graph
