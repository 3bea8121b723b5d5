// SPDX-License-Identifier: Apache-2.0
#include "compiler/glsl/line_writer.h"

#include <algorithm>

namespace texgraph::glsl {
namespace {

// A nest of regions may be deeper than a line is wide.
constexpr size_t kMaxIndent = 40;

// How strongly what stands around the space at `i` holds together: after a comma least, then before
// operators as they bind. 0: no place to break at.
int Strength(std::string_view text, size_t i) {
  if (i == 0 || i + 2 >= text.size()) return 0;
  if (text[i - 1] == ',' || text[i - 1] == ';') return 1;
  size_t end = text.find(' ', i + 1);
  if (end == std::string_view::npos || end > i + 3) return 0;
  std::string_view word = text.substr(i + 1, end - i - 1);
  if (word == "?" || word == ":") return 2;
  if (word == "||" || word == "^^" || word == "&&") return 3;
  if (word == "<" || word == ">" || word == "<=" || word == ">=" || word == "==" || word == "!=")
    return 4;
  if (word == "|" || word == "^" || word == "&" || word == "<<" || word == ">>") return 5;
  if (word == "+" || word == "-") return 6;
  return word == "*" || word == "/" || word == "%" ? 7 : 0;
}

// The number of characters that stay on this line, at most `room` if there is a place to break.
size_t BreakAt(std::string_view text, size_t room) {
  size_t best = std::string_view::npos;
  int best_strength = 0, depth = 0;
  for (size_t i = 0; i < text.size(); ++i) {
    if (i > room && best != std::string_view::npos) break;
    if (text[i] == '(' || text[i] == '[' || text[i] == '{') ++depth;
    if (text[i] == ')' || text[i] == ']' || text[i] == '}') --depth;
    int strength = text[i] == ' ' ? Strength(text, i) : 0;
    if (strength == 0) continue;
    strength += 8 * depth;
    // The first third of a line is too soon, unless nothing else will do.
    bool soon = best == std::string_view::npos || best < room / 3;
    if (soon || strength <= best_strength) {
      best = i;
      best_strength = strength;
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
