// SPDX-License-Identifier: Apache-2.0
// A JSON, JSONC or YAML document as one tree, each node with its range in the source. Neither
// format's library types escape.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/base/ids.h"
#include "compiler/base/source.h"

namespace texgraph::graph {

enum class DocumentKind : uint8_t { kNull, kBool, kNumber, kString, kArray, kObject };
enum class DocumentFormat : uint8_t { kJson, kJsonc, kYaml };

struct DocumentNode {
  DocumentKind kind = DocumentKind::kNull;
  bool boolean = false;
  bool is_integer = false;  // kNumber: written without '.' and exponent, and fits int64
  int64_t integer = 0;
  double number = 0;      // kNumber, always set
  std::string_view text;  // kString: decoded UTF-8
  SourceRange range;      // strings with their quotes
  std::string_view key;   // in an object
  SourceRange key_range;
  // kArray, kObject: the children, in order.
  uint32_t first_child = UINT32_MAX;  // index into Document::nodes
  uint32_t next_sibling = UINT32_MAX;
  uint32_t child_count = 0;
};

// Limits on documents from strangers; reaching one is kNestingLimit, kAliasLimit or kSizeLimit.
inline constexpr size_t kMaxDocumentBytes = 256u << 20;
inline constexpr size_t kMaxDocumentNodes = 12'000'000;  // values; a graph node takes about eight
inline constexpr int kMaxNesting = 64;
inline constexpr size_t kMaxAliasNodes = 100'000;  // nodes made by expanding YAML aliases

class Document {
 public:
  std::vector<DocumentNode> nodes;  // nodes[0] is the root
  SourceId source;

  class Children;  // for (const DocumentNode& child : document.children(node))
  Children children(const DocumentNode& node) const;
  const DocumentNode* Find(const DocumentNode& object, std::string_view key) const;
  // Keys that stand twice in one object, as indices of nodes.
  struct DuplicateKey {
    uint32_t later, first;
  };
  std::vector<DuplicateKey> duplicate_keys;
  // Where strings with escapes live.
  std::vector<std::unique_ptr<std::string>> storage;
};

class Document::Children {
 public:
  struct Iterator {
    const Document* document;
    uint32_t index;
    const DocumentNode& operator*() const { return document->nodes[index]; }
    Iterator& operator++() {
      index = document->nodes[index].next_sibling;
      return *this;
    }
    bool operator==(const Iterator& other) const { return index == other.index; }
  };
  Iterator begin() const { return {document, first}; }
  Iterator end() const { return {document, UINT32_MAX}; }
  const Document* document;
  uint32_t first;
};

inline Document::Children Document::children(const DocumentNode& node) const {
  return {this, node.first_child};
}

// By the name's extension: .json, .jsonc, .yaml, .yml; anything else (standard input, say) by its
// first character.
DocumentFormat FormatOf(std::string_view file_name, std::string_view text);

// Reads the whole document. Nothing on a syntax error, which is reported; duplicate keys are
// reported with both places.
std::optional<Document> ReadDocument(SourceId source, DocumentFormat format, const Sources& sources,
                                     Diagnostics& diagnostics);

}  // namespace texgraph::graph
