// SPDX-License-Identifier: Apache-2.0
#include "compiler/blocks/lexer.h"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <span>

#include "compiler/base/text.h"

namespace texgraph::blocks {
namespace {

struct Spelling {
  TokenKind kind;
  std::string_view text;
};

constexpr Spelling kPunctuation[] = {
#define TOKEN(id, text) {TokenKind::id, text},
#include "compiler/blocks/tokens.def"
};

constexpr Spelling kKeywords[] = {
#define KEYWORD(id, text) {TokenKind::id, text},
#include "compiler/blocks/tokens.def"
};

// The spellings that begin with a character: from `first`, `count` of them, in their order.
struct Spellings {
  uint8_t first = 0, count = 0;
};

template <size_t kCount>
struct SpellingTable {
  std::array<Spelling, kCount> sorted{};
  std::array<Spellings, 128> by_character{};

  constexpr explicit SpellingTable(const Spelling (&spellings)[kCount]) {
    uint8_t next = 0;
    for (size_t c = 0; c < by_character.size(); ++c) {
      by_character[c].first = next;
      for (const Spelling& spelling : spellings) {
        if (static_cast<size_t>(spelling.text[0]) == c) sorted[next++] = spelling;
      }
      by_character[c].count = static_cast<uint8_t>(next - by_character[c].first);
    }
  }

  std::span<const Spelling> BeginningWith(char c) const {
    const auto index = static_cast<unsigned char>(c);
    if (index >= by_character.size()) return {};
    return std::span(sorted).subspan(by_character[index].first, by_character[index].count);
  }
};

constexpr SpellingTable kPunctuationTable(kPunctuation);
constexpr SpellingTable kKeywordTable(kKeywords);

constexpr bool IsDigit(char c) { return c >= '0' && c <= '9'; }
constexpr bool IsHexDigit(char c) {
  return IsDigit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}
constexpr bool IsWord(char c) {
  return IsDigit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

class Lexer {
 public:
  // `text` is the source's up to the end of the range, so that offsets are the source's.
  Lexer(SourceRange range, std::string_view text, Diagnostics& diagnostics)
      : source_(range.source), text_(text), diagnostics_(diagnostics), at_(range.begin) {}

  Tokens Run() {
    if (at_ == 0 && text_.starts_with("\xef\xbb\xbf")) at_ = 3;
    while (true) {
      SkipBlanks();
      if (at_ >= text_.size()) break;
      LexToken();
    }
    Push(TokenKind::kEnd, text_.size());
    return std::move(result_);
  }

 private:
  char Peek(size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }

  void Push(TokenKind kind, size_t begin, uint32_t bits = 0) {
    result_.tokens.push_back(
        {kind, static_cast<uint32_t>(begin), static_cast<uint32_t>(at_), bits});
  }

  void Error(DiagnosticKind kind, size_t begin, size_t end, std::string message) {
    diagnostics_.Error(kind, {source_, static_cast<uint32_t>(begin), static_cast<uint32_t>(end)},
                       std::move(message));
  }

  size_t LineEnd() const {
    size_t end = text_.find_first_of("\r\n", at_);
    return end == std::string_view::npos ? text_.size() : end;
  }

  void SkipBlanks() {
    while (at_ < text_.size()) {
      char c = Peek();
      if (c == ' ' || c == '\t' || c == '\n' || c == '\r') {
        ++at_;
      } else if (c == '/' && Peek(1) == '/') {
        LexLineComment();
      } else if (c == '/' && Peek(1) == '*') {
        size_t end = text_.find("*/", at_ + 2);
        if (end == std::string_view::npos) {
          Error(DiagnosticKind::kBlockSyntax, at_, at_ + 2, "this comment does not end");
          at_ = text_.size();
        } else {
          at_ = end + 2;
        }
      } else if (c == '#') {
        size_t end = LineEnd();
        Error(DiagnosticKind::kBlockSubset, at_, end,
              "blocks have no preprocessor; use constants, 'const' parameters and functions");
        at_ = end;
      } else {
        return;
      }
    }
  }

  void LexLineComment() {
    size_t end = LineEnd();
    std::string_view line = text_.substr(at_, end - at_);
    if (line.starts_with("///") && !line.starts_with("////")) {
      size_t begin = at_ + 3;
      if (begin < end && text_[begin] == ' ') ++begin;
      result_.docs.push_back({static_cast<uint32_t>(begin), static_cast<uint32_t>(end),
                              static_cast<uint32_t>(result_.tokens.size())});
    }
    // GLSL would join the next line to the comment.
    if (line.ends_with('\\')) {
      Error(DiagnosticKind::kBlockSubset, end - 1, end, "blocks have no line continuation");
    }
    at_ = end;
  }

  void LexToken() {
    char c = Peek();
    if (IsDigit(c) || (c == '.' && IsDigit(Peek(1)))) return LexNumber();
    if (IsWord(c)) return LexWord();
    size_t begin = at_;
    for (const Spelling& spelling : kPunctuationTable.BeginningWith(c)) {
      if (!text_.substr(at_).starts_with(spelling.text)) continue;
      at_ += spelling.text.size();
      return Push(spelling.kind, begin);
    }
    uint32_t length = std::max(1u, DecodeUtf8(text_, at_).length);
    at_ += length;
    Error(DiagnosticKind::kBlockSyntax, begin, at_,
          "'" + Printable(text_.substr(begin, length)) + "' means nothing here");
  }

  void LexWord() {
    size_t begin = at_;
    while (IsWord(Peek())) ++at_;
    std::string_view word = text_.substr(begin, at_ - begin);
    for (const Spelling& keyword : kKeywordTable.BeginningWith(word[0])) {
      if (word == keyword.text) return Push(keyword.kind, begin);
    }
    Push(TokenKind::kIdentifier, begin);
  }

  void LexNumber() {
    size_t begin = at_;
    if (Peek() == '0' && (Peek(1) == 'x' || Peek(1) == 'X')) {
      at_ += 2;
      size_t digits = at_;
      while (IsHexDigit(Peek())) ++at_;
      return FinishInteger(begin, text_.substr(digits, at_ - digits), 16);
    }
    while (IsDigit(Peek())) ++at_;
    bool is_float = false;
    if (Peek() == '.') {
      is_float = true;
      ++at_;
      while (IsDigit(Peek())) ++at_;
    }
    if (Peek() == 'e' || Peek() == 'E') {
      size_t sign = Peek(1) == '+' || Peek(1) == '-' ? 1 : 0;
      if (IsDigit(Peek(1 + sign))) {
        is_float = true;
        at_ += 1 + sign;
        while (IsDigit(Peek())) ++at_;
      }
    }
    std::string_view digits = text_.substr(begin, at_ - begin);
    if (is_float || Peek() == 'f' || Peek() == 'F') return FinishFloat(begin, digits);
    bool octal = digits.size() > 1 && digits[0] == '0';
    FinishInteger(begin, digits, octal ? 8 : 10);
  }

  // True, and reported, if letters or digits follow the number at once.
  bool HasTail(size_t begin) {
    if (!IsWord(Peek()) && Peek() != '.') return false;
    while (IsWord(Peek()) || Peek() == '.') ++at_;
    Error(DiagnosticKind::kBlockSyntax, begin, at_,
          "'" + Printable(text_.substr(begin, at_ - begin), 60) + "' is not a number");
    return true;
  }

  void FinishInteger(size_t begin, std::string_view digits, int base) {
    uint32_t value = 0;
    auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
    bool is_unsigned = Peek() == 'u' || Peek() == 'U';
    if (is_unsigned) ++at_;
    TokenKind kind = is_unsigned ? TokenKind::kUint : TokenKind::kInt;
    if (HasTail(begin)) return Push(kind, begin);
    // A hexadecimal int is a pattern of 32 bits, as in GLSL.
    bool too_large = error == std::errc::result_out_of_range ||
                     (base != 16 && !is_unsigned && value > 0x7fffffffu);
    if (too_large) {
      Error(DiagnosticKind::kBlockSyntax, begin, at_,
            is_unsigned ? "this number is larger than the largest uint, 4294967295"
                        : "this number is larger than the largest int, 2147483647");
    } else if (error != std::errc() || end != digits.data() + digits.size()) {
      Error(DiagnosticKind::kBlockSyntax, begin, at_,
            "'" + Printable(text_.substr(begin, at_ - begin), 60) + "' is not a number");
    }
    Push(kind, begin, value);
  }

  void FinishFloat(size_t begin, std::string_view digits) {
    float value = 0;
    // from_chars leaves the value alone when it is out of range; both ends have a sound meaning as
    // a double.
    double wide = 0;
    auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error == std::errc::result_out_of_range) {
      auto wide_result = std::from_chars(digits.data(), digits.data() + digits.size(), wide);
      value = static_cast<float>(wide);
      bool tiny = wide_result.ec == std::errc() && wide < 1;
      bool zero_exponent = digits.find("e-") != digits.npos || digits.find("E-") != digits.npos;
      if (!tiny && !zero_exponent) {
        Error(DiagnosticKind::kBlockSyntax, begin, at_, "this number is larger than any float");
        value = 0;
      }
    }
    if (Peek() == 'f' || Peek() == 'F') {
      ++at_;
    } else if (Peek() == 'l' || Peek() == 'L') {
      Error(DiagnosticKind::kBlockSubset, at_, at_ + 1, "blocks have no doubles; drop the 'lf'");
      while (IsWord(Peek())) ++at_;
    }
    HasTail(begin);
    Push(TokenKind::kFloat, begin, std::bit_cast<uint32_t>(value));
  }

  SourceId source_;
  std::string_view text_;
  Diagnostics& diagnostics_;
  size_t at_;
  Tokens result_;
};

// The first byte that is not UTF-8, or the size.
size_t InvalidByte(std::string_view text) {
  for (size_t i = 0; i < text.size();) {
    // Most text is ASCII: eight bytes at a time.
    uint64_t eight = 0x80;
    if (i + 8 <= text.size()) std::memcpy(&eight, text.data() + i, 8);
    if ((eight & 0x8080808080808080u) == 0) {
      i += 8;
      continue;
    }
    if (static_cast<uint8_t>(text[i]) < 0x80) {
      ++i;
      continue;
    }
    uint32_t length = DecodeUtf8(text, i).length;
    if (length == 0) return i;
    i += length;
  }
  return text.size();
}

}  // namespace

std::string_view TokenText(TokenKind kind) {
  switch (kind) {
    case TokenKind::kEnd:
      return "the end of the file";
    case TokenKind::kIdentifier:
      return "a name";
    case TokenKind::kInt:
    case TokenKind::kUint:
    case TokenKind::kFloat:
      return "a number";
#define TOKEN(id, text) \
  case TokenKind::id:   \
    return "'" text "'";
#define KEYWORD(id, text) \
  case TokenKind::id:     \
    return "'" text "'";
#include "compiler/blocks/tokens.def"
  }
  return "";
}

Tokens Lex(SourceRange range, const Sources& sources, Diagnostics& diagnostics) {
  std::string_view text = sources.Text(range.source).substr(0, range.end);
  if (size_t bad = InvalidByte(text); bad < text.size()) {
    uint32_t at = static_cast<uint32_t>(bad);
    diagnostics.Error(DiagnosticKind::kEncoding, {range.source, at, at + 1}, "this is not UTF-8");
    Tokens none;
    none.tokens.push_back({TokenKind::kEnd, at, at, 0});
    return none;
  }
  return Lexer(range, text, diagnostics).Run();
}

}  // namespace texgraph::blocks
