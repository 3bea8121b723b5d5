// SPDX-License-Identifier: Apache-2.0
#include "compiler/glsl/line_writer.h"

#include <algorithm>

namespace texgraph::glsl {
namespace {

// A nest of regions may be deeper than a line is wide.
constexpr size_t kMaxIndent = 40;

// The number of characters that stay on this line, at most `room` if there is a place to break.
size_t BreakAt(std::string_view text, size_t room) {
  size_t best = std::string_view::npos;
  int best_depth = 0;
  int depth = 0;
  for (size_t i = 0; i + 1 < text.size(); ++i) {
    if (i >= room && best != std::string_view::npos) break;
    if (text[i] == '(' || text[i] == '[' || text[i] == '{') ++depth;
    if (text[i] == ')' || text[i] == ']' || text[i] == '}') --depth;
    // After a comma, or before an operator, which has spaces on both sides.
    bool space = text[i] == ' ' && i > 0;
    bool comma = space && (text[i - 1] == ',' || text[i - 1] == ';');
    bool operation = space && i + 2 < text.size() && text[i + 1] != '=' && text[i + 1] != '{' &&
                     (text[i + 2] == ' ' || (i + 3 < text.size() && text[i + 3] == ' ')) &&
                     text.find_first_of("+-*/%<>=!&|^?:", i + 1) == i + 1;
    // The first half of a line is too soon, unless nothing else will do.
    bool late = i >= room / 2 || best == std::string_view::npos;
    if ((comma || operation) && late &&
        (best == std::string_view::npos || depth <= best_depth || best < room / 2)) {
      best = i;
      best_depth = depth;
    }
  }
  return best;
}

}  // namespace

void LineWriter::Piece(std::string_view text, size_t indent) {
  out_.append(indent, ' ');
  out_ += text;
  out_ += '\n';
}

void LineWriter::Line(std::string_view text) {
  size_t indent = std::min(indent_, kMaxIndent);
  bool is_comment = text.starts_with("//");
  for (bool first = true; !is_comment && indent + text.size() > kColumns; first = false) {
    size_t cut = BreakAt(text, kColumns - indent);
    if (cut == std::string_view::npos) break;
    Piece(text.substr(0, cut), indent);
    text.remove_prefix(cut + 1);
    if (first) indent += 4;
  }
  Piece(text, indent);
}

void LineWriter::Blank() {
  if (!out_.empty() && !out_.ends_with("\n\n")) out_ += '\n';
}

}  // namespace texgraph::glsl
