// SPDX-License-Identifier: Apache-2.0
// A block file as tokens. Comments and white space are gone but for the lines of documentation
// ("///"), which remember the token that they stand before. Preprocessor lines and characters
// outside ASCII (but in comments) are reported.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/base/source.h"

namespace texgraph::blocks {

enum class TokenKind : uint8_t {
  kEnd,
  kIdentifier,
  kInt,
  kUint,
  kFloat,
#define TOKEN(id, text) id,
#define KEYWORD(id, text) id,
#include "compiler/blocks/tokens.def"
};

// "';'", "'for'", "a name", "the end of the file".
std::string_view TokenText(TokenKind kind);

struct Token {
  TokenKind kind = TokenKind::kEnd;
  uint32_t begin = 0;  // byte offsets in the source
  uint32_t end = 0;
  uint32_t bits = 0;  // the value of a number
};

struct DocLine {
  uint32_t begin = 0;  // of the text after "///" and one blank
  uint32_t end = 0;
  uint32_t next_token = 0;  // index of the token that follows
};

struct Tokens {
  std::vector<Token> tokens;  // the last one is kEnd
  std::vector<DocLine> docs;
};

// Reports what is wrong and goes on; what comes back can always be parsed. `range` is the whole
// source or a part of it.
Tokens Lex(SourceRange range, const Sources& sources, Diagnostics& diagnostics);

}  // namespace texgraph::blocks
