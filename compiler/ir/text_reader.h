// SPDX-License-Identifier: Apache-2.0
// Reads the pieces that all of the IR's text form is made of: names, types, literals. After the
// first error every further call fails at once, so callers may check at the end of a piece.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/ir/module.h"
#include "compiler/ir/text_lexer.h"

namespace texgraph::ir {

class TextReader {
 public:
  TextReader(SourceId source, std::string_view text, Module& module, Diagnostics& diagnostics);

  bool ok() const { return !failed_; }
  // Always false, so that "return Fail(...)" reads well. Only the first one is reported.
  bool Fail(SourceRange range, std::string message, DiagnosticKind kind = DiagnosticKind::kSyntax);
  bool FailHere(std::string message) { return Fail(Peek().range, std::move(message)); }

  const Token& Peek() const { return tokens_[at_]; }
  // The token after the next one.
  const Token& PeekAfter() const { return tokens_[AtEnd() ? at_ : at_ + 1]; }
  bool AtEnd() const { return Peek().kind == TokenKind::kEnd; }
  Token Take();
  // Punctuation or a word.
  bool At(std::string_view text) const;
  bool Accept(std::string_view text);
  bool Expect(std::string_view text);

  // A word or a string.
  std::string Name(std::string_view what);
  // The next token if it is of that kind.
  Token TakeKind(TokenKind kind, std::string_view what);
  int64_t Integer(int64_t low, int64_t high);
  TypeId ReadType();
  // Appends the words of a literal and gives its type; invalid after an error.
  TypeId ReadLiteral(std::vector<uint32_t>& words);
  ConstId ReadConstant();
  // "#3" if it stands here; else `otherwise`.
  OriginId ReadOrigin(OriginId otherwise);

 private:
  TypeId ReadTypeAt(uint32_t depth);
  std::vector<TypeId> ReadTypeList(uint32_t depth);
  TypeId ReadLiteralAt(std::vector<uint32_t>& words, uint32_t depth);
  TypeId ReadNumber(std::vector<uint32_t>& words);
  bool ReadComponents(TypeId type, std::vector<uint32_t>& words, uint32_t depth);

  Module& module_;
  Diagnostics& diagnostics_;
  std::vector<Token> tokens_;
  size_t at_ = 0;
  bool failed_ = false;
};

}  // namespace texgraph::ir
