// SPDX-License-Identifier: Apache-2.0
// The tokens of the IR's text form (print.h). The whole text is split at once; what is no token is
// a kInvalid one, which the parser reports when it gets there. The last token is kEnd.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/base/source.h"

namespace texgraph::ir {

enum class TokenKind : uint8_t {
  kIdentifier,   // word
  kString,       // "..." ; text is the content
  kNumber,       // 1  -1  1u  1.0  -1e-5  0x7f  -inf
  kValue,        // %local, %local.2, %7 ; text without the %
  kGlobal,       // @name or @"name" ; text is the name
  kOrigin,       // #3 ; text is the number
  kPunctuation,  // ( ) { } [ ] , : = . ->
  kInvalid,
  kEnd,
};

struct Token {
  TokenKind kind = TokenKind::kEnd;
  std::string text;
  SourceRange range;
};

std::vector<Token> SplitTokens(SourceId source, std::string_view text);

}  // namespace texgraph::ir
