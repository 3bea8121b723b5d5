// SPDX-License-Identifier: Apache-2.0
// Fills a Document in the order of its text, for both readers: links children to their containers
// and bounds the nesting, so neither reader needs recursion.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "compiler/base/name_map.h"
#include "compiler/graph/document.h"

namespace texgraph::graph {

class DocumentBuilder {
 public:
  DocumentBuilder(SourceId source, Document& document, Diagnostics& diagnostics)
      : document_(document), diagnostics_(diagnostics) {
    document_.source = source;
  }

  int depth() const { return depth_; }
  bool InObject() const { return depth_ > 0 && Innermost().kind == DocumentKind::kObject; }
  // The container that is open now; depth() > 0.
  const DocumentNode& Innermost() const { return document_.nodes[open_[depth_ - 1].node]; }
  // The key of the next node that is added; only in an object.
  void SetKey(std::string_view key, SourceRange range) {
    key_ = key;
    key_range_ = range;
  }

  // Appends a node to the open container. False, with a diagnostic, if there are too many.
  bool Add(const DocumentNode& node);
  // The same for an array or object, which stays open; too many may be open, too.
  bool Open(const DocumentNode& node);
  // Ends the innermost container at this offset of its source.
  void Close(uint32_t end);
  // Appends a copy of the finished nodes [begin, end), a node and all below it, shown at `range`.
  // `height` is the number of containers within each other there.
  bool AddCopy(uint32_t begin, uint32_t end, int height, SourceRange range);
  // Of the node that was finished last: the containers within each other, itself included.
  int last_height() const { return last_height_; }
  // A text that lives as long as the document.
  std::string_view Keep(std::string text);

 private:
  struct Frame {
    uint32_t node;
    uint32_t last_child;
    int height;  // of the highest child so far
  };
  void Link(uint32_t index);
  void CheckKey(const DocumentNode& object, uint32_t index);
  uint32_t IndexOf(const DocumentNode& node) const {
    return static_cast<uint32_t>(&node - document_.nodes.data());
  }
  bool TooDeep(SourceRange range);

  Document& document_;
  Diagnostics& diagnostics_;
  std::array<Frame, kMaxNesting> open_;
  std::array<NameMap<uint32_t>, kMaxNesting> keys_;  // of open objects that have many
  int depth_ = 0;
  int last_height_ = 0;
  std::string_view key_;
  SourceRange key_range_;
};

}  // namespace texgraph::graph
