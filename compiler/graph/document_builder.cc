// SPDX-License-Identifier: Apache-2.0
#include "compiler/graph/document_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace texgraph::graph {
namespace {

// Objects with fewer keys are compared pair by pair.
constexpr uint32_t kManyKeys = 12;

}  // namespace

// Looks for the key among those of the open object, while they are in the cache.
void DocumentBuilder::CheckKey(const DocumentNode& object, uint32_t index) {
  const std::string_view key = document_.nodes[index].key;
  if (object.child_count < kManyKeys) {
    for (const DocumentNode& before : document_.children(object)) {
      if (before.key != key) continue;
      document_.duplicate_keys.push_back({index, IndexOf(before)});
      return;
    }
    return;
  }
  NameMap<uint32_t>& known = keys_[depth_ - 1];
  if (object.child_count == kManyKeys) {
    known.Clear();
    for (const DocumentNode& before : document_.children(object))
      known.Add(before.key, IndexOf(before));
  }
  auto [first, fresh] = known.Add(key, index);
  if (!fresh) document_.duplicate_keys.push_back({index, *first});
}

// Makes the node at `index` the last child of the open container.
void DocumentBuilder::Link(uint32_t index) {
  DocumentNode& node = document_.nodes[index];
  node.next_sibling = UINT32_MAX;
  if (depth_ == 0) return;
  Frame& frame = open_[depth_ - 1];
  DocumentNode& parent = document_.nodes[frame.node];
  if (parent.kind == DocumentKind::kObject) {
    node.key = key_;
    node.key_range = key_range_;
    CheckKey(parent, index);
  }
  if (parent.child_count++ == 0) {
    parent.first_child = index;
  } else {
    document_.nodes[frame.last_child].next_sibling = index;
  }
  frame.last_child = index;
}

bool DocumentBuilder::Add(const DocumentNode& node) {
  auto index = static_cast<uint32_t>(document_.nodes.size());
  if (index == kMaxDocumentNodes) {
    diagnostics_.Error(DiagnosticKind::kSizeLimit, node.range,
                       fmt::format("the document has more than {} values", kMaxDocumentNodes));
    return false;
  }
  document_.nodes.push_back(node);
  Link(index);
  last_height_ = 0;
  return true;
}

bool DocumentBuilder::TooDeep(SourceRange range) {
  diagnostics_.Error(DiagnosticKind::kNestingLimit, range,
                     fmt::format("arrays and objects are nested deeper than {}", kMaxNesting));
  return false;
}

bool DocumentBuilder::Open(const DocumentNode& node) {
  if (depth_ == kMaxNesting) return TooDeep(node.range);
  auto index = static_cast<uint32_t>(document_.nodes.size());
  if (!Add(node)) return false;
  open_[depth_++] = {index, UINT32_MAX, 0};
  return true;
}

void DocumentBuilder::Close(uint32_t end) {
  Frame frame = open_[--depth_];
  document_.nodes[frame.node].range.end = end;
  last_height_ = frame.height + 1;
  if (depth_ > 0) open_[depth_ - 1].height = std::max(open_[depth_ - 1].height, last_height_);
}

bool DocumentBuilder::AddCopy(uint32_t begin, uint32_t end, int height, SourceRange range) {
  if (depth_ + height > kMaxNesting) return TooDeep(range);
  auto index = static_cast<uint32_t>(document_.nodes.size());
  uint32_t shift = index - begin;
  for (uint32_t i = begin; i < end; ++i) {
    DocumentNode copy = document_.nodes[i];
    if (copy.first_child != UINT32_MAX) copy.first_child += shift;
    if (copy.next_sibling != UINT32_MAX) copy.next_sibling += shift;
    document_.nodes.push_back(copy);
  }
  document_.nodes[index].range = range;
  document_.nodes[index].key = {};
  Link(index);
  last_height_ = height;
  if (depth_ > 0) open_[depth_ - 1].height = std::max(open_[depth_ - 1].height, height);
  return true;
}

std::string_view DocumentBuilder::Keep(std::string text) {
  document_.storage.push_back(std::make_unique<std::string>(std::move(text)));
  return *document_.storage.back();
}

}  // namespace texgraph::graph
