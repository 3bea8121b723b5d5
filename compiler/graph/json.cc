// SPDX-License-Identifier: Apache-2.0
#include "compiler/graph/json.h"

#include <fmt/format.h>

#include <array>
#include <string>
#include <utility>

#include "compiler/base/text.h"
#include "compiler/graph/document_builder.h"
#include "compiler/graph/encoding.h"
#include "compiler/graph/number.h"

namespace texgraph::graph {
namespace {

bool IsWordStart(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '$';
}
bool IsWord(char c) { return IsWordStart(c) || (c >= '0' && c <= '9'); }

constexpr std::array<bool, 256> kIsSpace = [] {
  std::array<bool, 256> is{};
  is[' '] = is['\n'] = is['\r'] = is['\t'] = true;
  return is;
}();

// The bytes that end the plain part of a string: quote, backslash, control characters.
constexpr std::array<bool, 256> kStopsString = [] {
  std::array<bool, 256> stops{};
  for (int i = 0; i < 0x20; ++i) stops[i] = true;
  stops['"'] = stops['\\'] = true;
  return stops;
}();

class JsonReader {
 public:
  JsonReader(const JsonText& json, Document& document, Diagnostics& diagnostics)
      : source_(json.source),
        text_(json.text),
        extended_(json.extended),
        diagnostics_(diagnostics),
        builder_(json.source, document, diagnostics),
        at_(json.begin) {}

  bool Read();

 private:
  enum class Step : uint8_t { kFailed, kOpened, kFinished };

  bool AtEnd() const { return at_ == text_.size(); }
  // The next byte; NUL, which the text has nowhere else, at the end.
  char Peek() const { return AtEnd() ? '\0' : text_[at_]; }
  SourceRange Range(size_t begin, size_t end) const {
    return {source_, static_cast<uint32_t>(begin), static_cast<uint32_t>(end)};
  }
  bool Fail(SourceRange range, std::string message) {
    diagnostics_.Error(DiagnosticKind::kSyntax, range, std::move(message));
    return false;
  }
  std::string_view Word() const;
  const char* ContainerName() const { return builder_.InObject() ? "object" : "array"; }

  // Between tokens; false after a wrong comment. Mostly there is nothing, or one space.
  bool SkipSpace() {
    if (Peek() > '/') return true;
    return SkipMore();
  }
  bool SkipMore();
  bool SkipComment();
  Step ReadValue();
  Step OpenContainer(DocumentKind kind);
  bool ReadKey();
  bool ReadString(std::string_view& out, SourceRange& range);
  bool ReadEscape(std::string& out);
  bool ReadHex4(size_t escape, uint32_t& out);
  bool ReadNumber();
  bool ReadWord();
  bool FinishContainers();
  bool ReadComma();
  bool EndsTooEarly();
  bool WrongValue();
  bool WrongSeparator();

  SourceId source_;
  std::string_view text_;
  bool extended_;
  Diagnostics& diagnostics_;
  DocumentBuilder builder_;
  size_t at_;
};

bool JsonReader::Read() {
  if (!SkipSpace()) return false;
  if (AtEnd()) {
    diagnostics_.Error(DiagnosticKind::kEmptyDocument, Range(at_, at_), "the document is empty");
    return false;
  }
  do {
    Step step = ReadValue();
    if (step == Step::kFailed) return false;
    if (step == Step::kFinished && !FinishContainers()) return false;
  } while (builder_.depth() > 0);
  if (!SkipSpace()) return false;
  if (AtEnd()) return true;
  return Fail(Range(at_, at_ + 1), "nothing may follow the end of the document");
}

// The identifier that begins here, at most 40 bytes of it.
std::string_view JsonReader::Word() const {
  size_t end = at_;
  while (end < text_.size() && end < at_ + 40 && IsWord(text_[end])) ++end;
  return text_.substr(at_, end - at_);
}

bool JsonReader::SkipMore() {
  while (true) {
    size_t at = at_;
    while (at < text_.size() && kIsSpace[static_cast<uint8_t>(text_[at])]) ++at;
    at_ = at;
    const char c = Peek();
    if (c != '/' && c != '#') return true;
    if (!SkipComment()) return false;
  }
}

bool JsonReader::SkipComment() {
  std::string_view rest = text_.substr(at_);
  bool line = rest.starts_with("//"), block = rest.starts_with("/*");
  if (rest[0] == '#') return Fail(Range(at_, at_ + 1), "comments begin with '//' in JSONC");
  if (!line && !block) return Fail(Range(at_, at_ + 1), "unexpected '/'");
  if (!extended_) {
    return Fail(Range(at_, at_ + 2), "comments need a file name that ends in .jsonc");
  }
  size_t length = line ? rest.find('\n') : rest.find("*/", 2);
  if (length == std::string_view::npos) {
    if (block) return Fail(Range(at_, at_ + 2), "the comment is not closed");
    length = rest.size();
  }
  at_ += block ? length + 2 : length;
  return true;
}

JsonReader::Step JsonReader::ReadValue() {
  bool ok = false;
  char c = Peek();
  if (c == '{') return OpenContainer(DocumentKind::kObject);
  if (c == '[') return OpenContainer(DocumentKind::kArray);
  if (c == '"') {
    DocumentNode node;
    node.kind = DocumentKind::kString;
    ok = ReadString(node.text, node.range);
    ok = ok && builder_.Add(node);
  } else if (c == '-' || (c >= '0' && c <= '9')) {
    ok = ReadNumber();
  } else if (IsWordStart(c)) {
    ok = ReadWord();
  } else {
    ok = WrongValue();
  }
  return ok ? Step::kFinished : Step::kFailed;
}

JsonReader::Step JsonReader::OpenContainer(DocumentKind kind) {
  DocumentNode node;
  node.kind = kind;
  node.range = Range(at_, at_ + 1);
  if (!builder_.Open(node)) return Step::kFailed;
  ++at_;
  if (!SkipSpace()) return Step::kFailed;
  bool object = kind == DocumentKind::kObject;
  if (Peek() == (object ? '}' : ']')) {
    builder_.Close(static_cast<uint32_t>(++at_));
    return Step::kFinished;
  }
  if (object && !ReadKey()) return Step::kFailed;
  return Step::kOpened;
}

// A key and its colon.
bool JsonReader::ReadKey() {
  if (Peek() != '"') {
    if (AtEnd()) return EndsTooEarly();
    if (Peek() == '\'') {
      return Fail(Range(at_, at_ + 1), "keys stand in double quotes, not in single ones");
    }
    if (std::string_view word = Word(); !word.empty()) {
      return Fail(Range(at_, at_ + word.size()),
                  fmt::format("keys need double quotes: \"{}\"", word));
    }
    return Fail(Range(at_, at_ + 1), "expected a key in double quotes");
  }
  std::string_view key;
  SourceRange range;
  if (!ReadString(key, range) || !SkipSpace()) return false;
  if (Peek() != ':') {
    if (AtEnd()) return EndsTooEarly();
    return Fail(Range(at_, at_ + 1), "expected ':' after the key");
  }
  ++at_;
  builder_.SetKey(key, range);
  return SkipSpace();
}

bool JsonReader::ReadString(std::string_view& out, SourceRange& range) {
  size_t begin = at_++;
  size_t plain = at_;  // from here on the text is not yet copied
  std::string copy;
  bool escaped = false;
  while (true) {
    size_t at = at_;
    while (at < text_.size() && !kStopsString[static_cast<uint8_t>(text_[at])]) ++at;
    at_ = at;
    char c = Peek();
    if (c == '"') break;
    if (c == '\\') {
      escaped = true;
      copy += text_.substr(plain, at_ - plain);
      if (!ReadEscape(copy)) return false;
      plain = at_;
    } else if (AtEnd() || c == '\n' || c == '\r') {
      return Fail(Range(begin, begin + 1), "the text that begins here is not closed on its line");
    } else {
      return Fail(Range(at_, at_ + 1), fmt::format("control character in a text; write \\u{:04x}",
                                                   static_cast<unsigned>(static_cast<uint8_t>(c))));
    }
  }
  if (escaped) {
    copy += text_.substr(plain, at_ - plain);
    out = builder_.Keep(std::move(copy));
  } else {
    out = text_.substr(plain, at_ - plain);
  }
  range = Range(begin, ++at_);
  return true;
}

bool JsonReader::ReadEscape(std::string& out) {
  size_t begin = at_++;
  constexpr std::string_view kNames = "\"\\/bfnrt";
  constexpr std::string_view kValues = "\"\\/\b\f\n\r\t";
  char c = Peek();
  if (size_t i = kNames.find(c); !AtEnd() && i != std::string_view::npos) {
    out += kValues[i];
    ++at_;
    return true;
  }
  if (c != 'u') {
    return Fail(Range(begin, at_), "unknown escape; '\\\\' stands for a backslash");
  }
  ++at_;
  uint32_t unit = 0;
  if (!ReadHex4(begin, unit)) return false;
  bool high = unit >= 0xd800 && unit < 0xdc00;
  if (high && text_.substr(at_, 2) == "\\u") {
    at_ += 2;
    uint32_t low = 0;
    if (!ReadHex4(begin, low)) return false;
    if (low >= 0xdc00 && low < 0xe000) {
      AppendUtf8(out, 0x10000 + ((unit - 0xd800) << 10) + (low - 0xdc00));
      return true;
    }
  }
  if (unit >= 0xd800 && unit < 0xe000) {
    diagnostics_.Error(DiagnosticKind::kEncoding, Range(begin, begin + 6),
                       fmt::format("\\u{:04x} is half of a surrogate pair", unit));
    return false;
  }
  AppendUtf8(out, unit);
  return true;
}

bool JsonReader::ReadHex4(size_t escape, uint32_t& out) {
  for (int i = 0; i < 4; ++i) {
    char c = Peek();
    uint32_t digit = 16;
    if (c >= '0' && c <= '9') digit = static_cast<uint32_t>(c - '0');
    if (c >= 'a' && c <= 'f') digit = static_cast<uint32_t>(c - 'a' + 10);
    if (c >= 'A' && c <= 'F') digit = static_cast<uint32_t>(c - 'A' + 10);
    if (digit == 16) return Fail(Range(escape, at_), "four hexadecimal digits must follow \\u");
    out = out << 4 | digit;
    ++at_;
  }
  return true;
}

bool JsonReader::ReadNumber() {
  NumberSpelling spelling = SpellNumber(text_.substr(at_));
  if (spelling.length == 0) {
    if (text_.substr(at_).starts_with("-Infinity")) {
      return Fail(Range(at_, at_ + 9), "numbers are finite: '-Infinity' is none");
    }
    return Fail(Range(at_, at_ + 1), spelling.problem);
  }
  DocumentNode node;
  node.range = Range(at_, at_ + spelling.length);
  if (!SetNumber(text_.substr(at_, spelling.length), node, diagnostics_)) return false;
  at_ += spelling.length;
  return builder_.Add(node);
}

bool JsonReader::ReadWord() {
  std::string_view word = Word();
  DocumentNode node;
  node.range = Range(at_, at_ + word.size());
  if (word == "true" || word == "false") {
    node.kind = DocumentKind::kBool;
    node.boolean = word == "true";
  } else if (word != "null") {
    if (word == "NaN" || word == "Infinity") {
      return Fail(node.range, fmt::format("numbers are finite: '{}' is none", word));
    }
    if (word == "True" || word == "TRUE") return Fail(node.range, "write 'true'");
    if (word == "False" || word == "FALSE") return Fail(node.range, "write 'false'");
    return Fail(node.range, fmt::format("text needs double quotes: \"{}\"", word));
  }
  at_ += word.size();
  return builder_.Add(node);
}

// After a value: closes containers that end here, up to the next value or the end of the document.
bool JsonReader::FinishContainers() {
  while (builder_.depth() > 0) {
    if (!SkipSpace()) return false;
    char c = Peek();
    if (c == (builder_.InObject() ? '}' : ']')) {
      builder_.Close(static_cast<uint32_t>(++at_));
      continue;
    }
    if (c != ',') return WrongSeparator();
    size_t comma = at_++;
    if (!SkipSpace()) return false;
    c = Peek();
    if (c == ',') return Fail(Range(at_, at_ + 1), "a value is missing before this ','");
    if (c != '}' && c != ']') return builder_.InObject() ? ReadKey() : true;
    if (!extended_) {
      return Fail(Range(comma, comma + 1),
                  "no ',' after the last value, unless the file name ends in .jsonc");
    }
  }
  return true;
}

bool JsonReader::EndsTooEarly() {
  diagnostics_
      .Error(DiagnosticKind::kSyntax, Range(at_, at_),
             fmt::format("the document ends inside an {}", ContainerName()))
      .AddNote(builder_.Innermost().range, fmt::format("the {} begins here", ContainerName()));
  return false;
}

// Something stands here that begins no value.
bool JsonReader::WrongValue() {
  if (AtEnd()) return EndsTooEarly();
  SourceRange range = Range(at_, at_ + 1);
  switch (Peek()) {
    case '\'':
      return Fail(range, "text stands in double quotes, not in single ones");
    case '+':
      return Fail(range, "numbers have no leading '+'");
    case '.':
      return Fail(range, "numbers begin with a digit: 0.5");
    case ',':
      return Fail(range, "a value is missing before this ','");
    default:
      return Fail(range, "expected a value");
  }
}

// Something else than ',' or the right bracket follows a value.
bool JsonReader::WrongSeparator() {
  if (AtEnd()) return EndsTooEarly();
  SourceRange range = Range(at_, at_ + 1);
  char c = Peek();
  const char* close = builder_.InObject() ? "}" : "]";
  if (c == ':') {
    return Fail(range, builder_.InObject() ? "expected ',' or '}' here"
                                           : "an array has no keys; objects stand in '{' and '}'");
  }
  if (c == ']' || c == '}') {
    diagnostics_
        .Error(DiagnosticKind::kSyntax, range,
               fmt::format("expected '{}', since an {} is open", close, ContainerName()))
        .AddNote(builder_.Innermost().range, fmt::format("the {} begins here", ContainerName()));
    return false;
  }
  return Fail(range, fmt::format("expected ',' or '{}' here", close));
}

}  // namespace

bool ReadJson(const JsonText& json, Document& document, Diagnostics& diagnostics) {
  return JsonReader(json, document, diagnostics).Read();
}

}  // namespace texgraph::graph
