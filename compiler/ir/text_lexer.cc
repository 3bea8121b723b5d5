// SPDX-License-Identifier: Apache-2.0
#include "compiler/ir/text_lexer.h"

#include <algorithm>
#include <charconv>

namespace texgraph::ir {
namespace {

bool IsDigit(char c) { return c >= '0' && c <= '9'; }
bool IsWord(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || IsDigit(c) || c == '_';
}

class Lexer {
 public:
  Lexer(SourceId source, std::string_view text) : source_(source), text_(text) {}

  std::vector<Token> Split() {
    std::vector<Token> tokens;
    do {
      SkipSpace();
      tokens.push_back(Next());
    } while (tokens.back().kind != TokenKind::kEnd);
    return tokens;
  }

 private:
  char Peek(size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }

  void SkipSpace() {
    while (at_ < text_.size()) {
      char c = text_[at_];
      if (c == '/' && Peek(1) == '/') {
        while (at_ < text_.size() && text_[at_] != '\n') ++at_;
      } else if (c == ' ' || c == '\n' || c == '\t' || c == '\r') {
        ++at_;
      } else {
        return;
      }
    }
  }

  Token Next() {
    begin_ = at_;
    if (at_ == text_.size()) return Make(TokenKind::kEnd, "");
    char c = Peek();
    if (c == '"') return String(TokenKind::kString);
    if (IsDigit(c)) return Number();
    if (c == '-' && (IsDigit(Peek(1)) || Peek(1) == 'i')) return Number();
    if (IsWord(c)) return Make(TokenKind::kIdentifier, Word());
    if (c == '%') return Value();
    ++at_;
    if (c == '@' && Peek() == '"') return String(TokenKind::kGlobal);
    if (c == '@' && IsWord(Peek())) return Make(TokenKind::kGlobal, Word());
    if (c == '#' && IsDigit(Peek())) return Make(TokenKind::kOrigin, Word());
    if (c == '-' && Peek() == '>') {
      ++at_;
      return Make(TokenKind::kPunctuation, "->");
    }
    constexpr std::string_view kPunctuation = "(){}[],:=.";
    if (kPunctuation.find(c) != std::string_view::npos) {
      return Make(TokenKind::kPunctuation, std::string(1, c));
    }
    return Make(TokenKind::kInvalid, std::string(1, c));
  }

  std::string Word() {
    size_t first = at_;
    while (IsWord(Peek())) ++at_;
    return std::string(text_.substr(first, at_ - first));
  }

  // Digits, letters and dots, and the sign of an exponent.
  Token Number() {
    ++at_;
    while (IsWord(Peek()) || Peek() == '.' ||
           (Peek() == '-' && (text_[at_ - 1] == 'e' || text_[at_ - 1] == 'E'))) {
      ++at_;
    }
    return Make(TokenKind::kNumber, std::string(text_.substr(begin_, at_ - begin_)));
  }

  Token Value() {
    ++at_;
    std::string name = Word();
    if (Peek() == '.' && IsDigit(Peek(1))) {
      ++at_;
      name += "." + Word();
    }
    const TokenKind kind = name.empty() ? TokenKind::kInvalid : TokenKind::kValue;
    return Make(kind, std::move(name));
  }

  // The four digits after \u.
  unsigned CodeUnit() {
    unsigned code = 0;
    at_ = std::min(at_, text_.size());
    size_t end = std::min(at_ + 4, text_.size());
    std::from_chars(text_.data() + at_, text_.data() + end, code, 16);
    at_ = end;
    return code;
  }

  static void AppendUtf8(unsigned code, std::string& out) {
    if (code < 0x80) {
      out += static_cast<char>(code);
    } else if (code < 0x800) {
      out += static_cast<char>(0xc0 | code >> 6);
      out += static_cast<char>(0x80 | (code & 0x3f));
    } else {
      out += static_cast<char>(0xe0 | code >> 12);
      out += static_cast<char>(0x80 | (code >> 6 & 0x3f));
      out += static_cast<char>(0x80 | (code & 0x3f));
    }
  }

  // Escapes as JSON's, which JsonQuoted writes.
  Token String(TokenKind kind) {
    ++at_;
    std::string content;
    while (at_ < text_.size() && text_[at_] != '"' && text_[at_] != '\n') {
      if (text_[at_] != '\\') {
        content += text_[at_++];
        continue;
      }
      char escape = Peek(1);
      at_ += 2;
      if (escape == 'u') {
        AppendUtf8(CodeUnit(), content);
        continue;
      }
      constexpr std::string_view kFrom = "nrtbf", kTo = "\n\r\t\b\f";
      size_t known = kFrom.find(escape);
      content += known == std::string_view::npos ? escape : kTo[known];
    }
    at_ = std::min(at_, text_.size());
    if (Peek() != '"') return Make(TokenKind::kInvalid, "\"");
    ++at_;
    return Make(kind, std::move(content));
  }

  Token Make(TokenKind kind, std::string text) {
    return {kind,
            std::move(text),
            {source_, static_cast<uint32_t>(begin_), static_cast<uint32_t>(at_)}};
  }

  SourceId source_;
  std::string_view text_;
  size_t at_ = 0;
  size_t begin_ = 0;
};

}  // namespace

std::vector<Token> SplitTokens(SourceId source, std::string_view text) {
  return Lexer(source, text).Split();
}

}  // namespace texgraph::ir
