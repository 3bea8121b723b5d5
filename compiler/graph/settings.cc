// SPDX-License-Identifier: Apache-2.0
// ReadSettings: "name=value" texts of the command line.
#include <fmt/format.h>

#include "compiler/base/text.h"
#include "compiler/graph/argument.h"
#include "compiler/graph/checked_graph.h"
#include "compiler/graph/encoding.h"
#include "compiler/graph/json.h"

namespace texgraph::graph {
namespace {

std::optional<Argument> ReadValue(SourceId source, uint32_t begin, Sources& sources,
                                  Diagnostics& diagnostics) {
  std::string_view text = sources.Text(source);
  std::string_view value = text.substr(begin);
  bool word = IsIdentifier(value) && value != "true" && value != "false" && value != "null";
  if (word) {
    Argument argument;
    argument.kind = Argument::Kind::kString;
    argument.text = value;
    argument.range = {source, begin, static_cast<uint32_t>(text.size())};
    return argument;
  }
  Document document;
  if (!ReadJson({source, text, begin, false}, document, diagnostics)) return std::nullopt;
  std::optional<Argument> argument = ReadArgument(document, document.nodes[0], diagnostics);
  if (argument && !document.storage.empty()) {
    // A text with escapes lives in the document, which ends here; the sources stay.
    SourceId decoded = sources.Add("--set", std::string(argument->text));
    argument->text = sources.Text(decoded);
  }
  return argument;
}

}  // namespace

std::vector<Setting> ReadSettings(const std::vector<std::string>& texts, Sources& sources,
                                  Diagnostics& diagnostics) {
  std::vector<Setting> settings;
  for (const std::string& text : texts) {
    SourceId source = sources.Add("--set", text);
    size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
      diagnostics.Error(DiagnosticKind::kUsage, {source, 0, static_cast<uint32_t>(text.size())},
                        fmt::format("'{}' is not of the form name=value", Printable(text, 64)));
      continue;
    }
    if (!CheckEncoding(source, text, diagnostics)) continue;
    auto begin = static_cast<uint32_t>(equals) + 1;
    std::optional<Argument> value = ReadValue(source, begin, sources, diagnostics);
    if (!value) continue;
    settings.push_back(
        {text.substr(0, equals), std::move(*value), {source, 0, static_cast<uint32_t>(equals)}});
  }
  return settings;
}

}  // namespace texgraph::graph
