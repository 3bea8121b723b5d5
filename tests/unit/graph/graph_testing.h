// SPDX-License-Identifier: Apache-2.0
// Short forms for the tests of the graph reader: a text in, what was found and reported out.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/base/source.h"
#include "compiler/graph/document.h"
#include "compiler/graph/graph.h"

namespace texgraph::graph {

// Each diagnostic as "line:column kind" ("warning: " before it if it is one), with its notes'
// places after it: "3:5 duplicate-key (1:5)".
std::vector<std::string> Places(const Diagnostics& diagnostics, const Sources& sources);
// The messages and notes, one a line.
std::string Messages(const Diagnostics& diagnostics);

struct ReadText {
  explicit ReadText(std::string text, DocumentFormat format = DocumentFormat::kJson,
                    std::string name = "graph.json");
  std::vector<std::string> Places() const { return graph::Places(diagnostics, sources); }
  std::string Messages() const { return graph::Messages(diagnostics); }

  Sources sources;
  Diagnostics diagnostics;
  SourceId source;
  std::optional<Document> document;
};

// The same for whole graphs.
struct ReadGraphText {
  explicit ReadGraphText(std::string text, DocumentFormat format = DocumentFormat::kJson,
                         std::string name = "graph.json");
  std::vector<std::string> Places() const { return graph::Places(diagnostics, sources); }
  std::string Messages() const { return graph::Messages(diagnostics); }

  Sources sources;
  Diagnostics diagnostics;
  SourceId source;
  std::optional<Graph> graph;
};

// The processor's time that the program has taken. Waiting for a busy machine does not count.
double CpuSeconds();

// A document as text, so that trees can be compared: {"a": [1, 0.5, "x", true, null]}. Integers are
// written without, other numbers with a '.' or an exponent.
std::string TreeText(const Document& document);

}  // namespace texgraph::graph
