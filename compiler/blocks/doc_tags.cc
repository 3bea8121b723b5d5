// SPDX-License-Identifier: Apache-2.0
#include "compiler/blocks/doc_tags.h"

#include <algorithm>

namespace texgraph::blocks {
namespace {

Piece Part(const Piece& piece, size_t begin, size_t end) {
  uint32_t at = piece.range.begin;
  return {{piece.range.source, at + static_cast<uint32_t>(begin), at + static_cast<uint32_t>(end)},
          piece.text.substr(begin, end - begin)};
}

// Where the next '@' begins a word, or the end.
size_t FindTag(std::string_view text) {
  for (size_t i = 0; i + 1 < text.size(); ++i) {
    bool begins = i == 0 || IsBlank(text[i - 1]);
    char next = text[i + 1];
    bool letter = (next >= 'a' && next <= 'z') || (next >= 'A' && next <= 'Z');
    if (text[i] == '@' && begins && letter) return i;
  }
  return text.size();
}

}  // namespace

bool IsBlank(char c) { return c == ' ' || c == '\t'; }

Piece Trim(Piece piece) {
  while (!piece.text.empty() && IsBlank(piece.text.front())) {
    piece.text.remove_prefix(1);
    ++piece.range.begin;
  }
  while (!piece.text.empty() && IsBlank(piece.text.back())) {
    piece.text.remove_suffix(1);
    --piece.range.end;
  }
  return piece;
}

Piece TakeWord(Piece& piece) {
  piece = Trim(piece);
  size_t end = std::min(piece.text.find_first_of(" \t"), piece.text.size());
  Piece word = Part(piece, 0, end);
  piece = Trim(Part(piece, end, piece.text.size()));
  return word;
}

std::vector<Tag> SplitTags(DocLines lines, const FileAst& ast, std::string_view text) {
  std::vector<Tag> tags(1);
  for (uint32_t i = lines.first; i < lines.first + lines.count; ++i) {
    const DocLine& line = ast.docs[i];
    Piece rest{{ast.source, line.begin, line.end}, text.substr(line.begin, line.end - line.begin)};
    bool first = true;
    while (first || !rest.text.empty()) {
      size_t at = FindTag(rest.text);
      if (at > 0 || first) tags.back().pieces.push_back(Trim(Part(rest, 0, at)));
      first = false;
      rest = Part(rest, at, rest.text.size());
      if (!rest.text.empty()) tags.push_back({TakeWord(rest), {}});
    }
  }
  return tags;
}

}  // namespace texgraph::blocks
