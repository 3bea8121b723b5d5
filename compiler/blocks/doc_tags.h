// SPDX-License-Identifier: Apache-2.0
// The lines of documentation ("///") before a declaration, split at their tags: words that begin
// with '@'. Every piece knows its place in the file.
#pragma once

#include <string_view>
#include <vector>

#include "compiler/base/source.h"
#include "compiler/blocks/ast.h"

namespace texgraph::blocks {

// A piece of one line.
struct Piece {
  SourceRange range;
  std::string_view text;
};

struct Tag {
  Piece name;  // with its '@'; empty for the text in front of all tags
  std::vector<Piece> pieces;
};

bool IsBlank(char c);
// Without the blanks around it.
Piece Trim(Piece piece);
// Takes the first word off.
Piece TakeWord(Piece& piece);
// The text in front of all tags first, even if there is none, then each tag with what follows it.
// `text` is the file's.
std::vector<Tag> SplitTags(DocLines lines, const FileAst& ast, std::string_view text);

}  // namespace texgraph::blocks
