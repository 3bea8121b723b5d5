// SPDX-License-Identifier: Apache-2.0
#include "compiler/ir/text_reader.h"

#include <bit>
#include <charconv>
#include <limits>

namespace texgraph::ir {
namespace {

constexpr uint32_t kMaxTypeDepth = 32;
constexpr int64_t kMaxArrayLength = 1 << 16;
constexpr uint64_t kMaxTypeWords = 1 << 20;

template <class T>
bool ReadAll(std::string_view digits, T& value, int base) {
  auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
  return error == std::errc() && end == digits.data() + digits.size();
}

}  // namespace

TextReader::TextReader(SourceId source, std::string_view text, Module& module,
                       Diagnostics& diagnostics)
    : module_(module), diagnostics_(diagnostics), tokens_(SplitTokens(source, text)) {}

bool TextReader::Fail(SourceRange range, std::string message, DiagnosticKind kind) {
  if (!failed_) diagnostics_.Error(kind, range, std::move(message));
  failed_ = true;
  return false;
}

Token TextReader::Take() {
  Token token = Peek();
  if (!AtEnd()) ++at_;
  return token;
}

bool TextReader::At(std::string_view text) const {
  TokenKind kind = Peek().kind;
  return (kind == TokenKind::kPunctuation || kind == TokenKind::kIdentifier) && Peek().text == text;
}

bool TextReader::Accept(std::string_view text) {
  if (failed_ || !At(text)) return false;
  Take();
  return true;
}

bool TextReader::Expect(std::string_view text) {
  return Accept(text) || FailHere("expected '" + std::string(text) + "'");
}

std::string TextReader::Name(std::string_view what) {
  if (Peek().kind != TokenKind::kIdentifier && Peek().kind != TokenKind::kString) {
    FailHere("expected " + std::string(what));
    return "";
  }
  return Take().text;
}

Token TextReader::TakeKind(TokenKind kind, std::string_view what) {
  if (Peek().kind == kind) return Take();
  FailHere("expected " + std::string(what));
  return {};
}

int64_t TextReader::Integer(int64_t low, int64_t high) {
  Token token = TakeKind(TokenKind::kNumber, "a whole number");
  int64_t value = low;
  if (ok() && (!ReadAll(token.text, value, 10) || value < low || value > high)) {
    Fail(token.range,
         "expected a whole number from " + std::to_string(low) + " to " + std::to_string(high));
  }
  return value;
}

OriginId TextReader::ReadOrigin(OriginId otherwise) {
  if (Peek().kind != TokenKind::kOrigin) return otherwise;
  Token token = Take();
  size_t index = 0;
  if (!ReadAll(token.text, index, 10) || index >= module_.origins.size()) {
    Fail(token.range, "no such origin");
    return otherwise;
  }
  return OriginId(index);
}

// --- Types ---------------------------------------------------------------------------------------

TypeId TextReader::ReadType() { return ReadTypeAt(0); }

std::vector<TypeId> TextReader::ReadTypeList(uint32_t depth) {
  std::vector<TypeId> list;
  Expect("(");
  while (ok() && !At(")")) {
    list.push_back(ReadTypeAt(depth + 1));
    if (!Accept(",")) break;
  }
  Expect(")");
  return list;
}

TypeId TextReader::ReadTypeAt(uint32_t depth) {
  const Token first = Peek();
  TypeId type;
  if (depth > kMaxTypeDepth) {
    FailHere("a type nested too deep");
  } else if (At("(")) {
    std::vector<TypeId> elements = ReadTypeList(depth);
    if (ok()) type = module_.types.Tuple(elements);
  } else if (Accept("field")) {
    std::vector<TypeId> parameters = ReadTypeList(depth);
    Expect("->");
    TypeId result = ok() ? ReadTypeAt(depth + 1) : TypeId();
    return ok() ? module_.types.Field(result, parameters) : TypeId();
  } else {
    std::string name = Name("a type");
    if (ok() && !(type = module_.types.Find(name))) {
      Fail(first.range, "unknown type '" + name + "'");
    }
  }
  while (Accept("[")) {
    uint32_t length = static_cast<uint32_t>(Integer(1, kMaxArrayLength));
    Expect("]");
    if (!ok()) break;
    if (uint64_t{module_.types.Words(type)} * length > kMaxTypeWords) {
      Fail(first.range, "a type too large");
      break;
    }
    type = module_.types.Array(type, length);
  }
  return ok() ? type : TypeId();
}

// --- Literals ------------------------------------------------------------------------------------

ConstId TextReader::ReadConstant() {
  std::vector<uint32_t> words;
  TypeId type = ReadLiteral(words);
  return type ? module_.Intern(type, words) : ConstId();
}

TypeId TextReader::ReadLiteral(std::vector<uint32_t>& words) { return ReadLiteralAt(words, 0); }

TypeId TextReader::ReadLiteralAt(std::vector<uint32_t>& words, uint32_t depth) {
  if (Peek().kind == TokenKind::kNumber) return ReadNumber(words);
  if (At("true") || At("false")) {
    words.push_back(Take().text == "true");
    return kBool;
  }
  if (At("inf") || At("nan")) {
    float value = Take().text == "inf" ? std::numeric_limits<float>::infinity()
                                       : std::bit_cast<float>(0x7fc00000u);
    words.push_back(std::bit_cast<uint32_t>(value));
    return kFloat;
  }
  if (Accept("bits")) {
    Expect("(");
    Token token = TakeKind(TokenKind::kNumber, "a number");
    uint32_t bits = 0;
    if (ok() && (!token.text.starts_with("0x") ||
                 !ReadAll(std::string_view(token.text).substr(2), bits, 16))) {
      Fail(token.range, "expected 0x and up to eight digits");
    }
    words.push_back(bits);
    return Expect(")") ? kFloat : TypeId();
  }
  if (Peek().kind != TokenKind::kIdentifier && !At("(")) {
    FailHere("expected a value");
    return TypeId();
  }
  TypeId type = ReadTypeAt(depth);
  Expect("(");
  return ok() && ReadComponents(type, words, depth) && Expect(")") ? type : TypeId();
}

TypeId TextReader::ReadNumber(std::vector<uint32_t>& words) {
  Token token = Take();
  std::string_view text = token.text;
  int32_t number = 0;
  uint32_t bits = 0;
  float value = 0;
  if (ReadAll(text, number, 10)) {
    words.push_back(std::bit_cast<uint32_t>(number));
    return kInt;
  }
  if (text.ends_with('u') && ReadAll(text.substr(0, text.size() - 1), bits, 10)) {
    words.push_back(bits);
    return kUint;
  }
  auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  bool fractional = text.find_first_of(".en") != std::string_view::npos;
  if (fractional && error == std::errc() && end == text.data() + text.size()) {
    words.push_back(std::bit_cast<uint32_t>(value));
    return kFloat;
  }
  Fail(token.range, "no number, or one out of range");
  return TypeId();
}

// Between the parentheses of a literal: scalars for vectors and matrices, elements for what is made
// of them.
bool TextReader::ReadComponents(TypeId type, std::vector<uint32_t>& words, uint32_t depth) {
  const Types& types = module_.types;
  const SourceRange range = Peek().range;
  const size_t first = words.size();
  const bool is_flat = IsVector(type) || IsMatrix(type);
  const uint32_t count = is_flat ? types.Words(type) : types.ElementCount(type);
  if (count == 0) return Fail(range, "no literal of type " + types.Text(type));
  uint32_t seen = 0;
  do {
    const SourceRange element_range = Peek().range;
    TypeId element = ReadLiteralAt(words, depth + 1);
    if (!ok()) return false;
    TypeId wanted = IsMatrix(type) ? kFloat : types.ElementType(type, seen < count ? seen : 0);
    if (seen >= count || element != wanted) {
      return Fail(element_range, "a literal of type " + types.Text(type) + " does not take this");
    }
    ++seen;
  } while (Accept(","));
  if (IsVector(type) && seen == 1) words.resize(first + count, words[first]);
  return seen == count || (IsVector(type) && seen == 1) ||
         Fail(range, "a literal of type " + types.Text(type) + " has " + std::to_string(count) +
                         " components");
}

}  // namespace texgraph::ir
