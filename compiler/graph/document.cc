// SPDX-License-Identifier: Apache-2.0
#include "compiler/graph/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "compiler/graph/encoding.h"
#include "compiler/graph/json.h"
#include "compiler/graph/yaml.h"

namespace texgraph::graph {
namespace {

void ReportDuplicateKeys(Document& document, Diagnostics& diagnostics) {
  auto place = [&](const Document::DuplicateKey& key) {
    return document.nodes[key.later].key_range.begin;
  };
  std::ranges::sort(document.duplicate_keys, {}, place);
  for (const Document::DuplicateKey& key : document.duplicate_keys) {
    const DocumentNode& later = document.nodes[key.later];
    diagnostics
        .Error(DiagnosticKind::kDuplicateKey, later.key_range,
               fmt::format("the key '{}' stands twice in one object", Printable(later.key)))
        .AddNote(document.nodes[key.first].key_range, "it stands here first");
  }
}

bool EndsWith(std::string_view name, std::string_view extension) {
  if (name.size() < extension.size()) return false;
  name.remove_prefix(name.size() - extension.size());
  return std::ranges::equal(name, extension, {}, [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
}

}  // namespace

const DocumentNode* Document::Find(const DocumentNode& object, std::string_view key) const {
  for (const DocumentNode& child : children(object)) {
    if (child.key == key) return &child;
  }
  return nullptr;
}

DocumentFormat FormatOf(std::string_view file_name, std::string_view text) {
  if (EndsWith(file_name, ".json")) return DocumentFormat::kJson;
  if (EndsWith(file_name, ".jsonc")) return DocumentFormat::kJsonc;
  if (EndsWith(file_name, ".yaml") || EndsWith(file_name, ".yml")) return DocumentFormat::kYaml;
  text.remove_prefix(ByteOrderMarkLength(text));
  size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return DocumentFormat::kJson;
  if (text[first] == '/') return DocumentFormat::kJsonc;
  bool json = text[first] == '{' || text[first] == '[' || text[first] == '"';
  return json ? DocumentFormat::kJson : DocumentFormat::kYaml;
}

std::optional<Document> ReadDocument(SourceId source, DocumentFormat format, const Sources& sources,
                                     Diagnostics& diagnostics) {
  std::string_view text = sources.Text(source);
  size_t limit = format == DocumentFormat::kYaml ? kMaxYamlBytes : kMaxDocumentBytes;
  if (text.size() > limit) {
    diagnostics.Error(
        DiagnosticKind::kSizeLimit, {source, 0, 0},
        fmt::format("the document has {} bytes; the limit is {} MiB", text.size(), limit >> 20));
    return std::nullopt;
  }
  if (!CheckEncoding(source, text, diagnostics)) return std::nullopt;
  Document document;
  document.source = source;
  // About what a graph has; a large document grows by itself.
  document.nodes.reserve(std::min<size_t>(text.size() / 12, 1 << 20));
  bool ok = false;
  if (format == DocumentFormat::kYaml) {
    ok = ReadYaml(source, text, document, diagnostics);
  } else {
    auto begin = static_cast<uint32_t>(ByteOrderMarkLength(text));
    ok = ReadJson({source, text, begin, format == DocumentFormat::kJsonc}, document, diagnostics);
  }
  if (!ok) return std::nullopt;
  ReportDuplicateKeys(document, diagnostics);
  return document;
}

}  // namespace texgraph::graph
