// SPDX-License-Identifier: Apache-2.0
#include "compiler/blocks/parser.h"

#include <algorithm>

#include "compiler/blocks/parse.h"

namespace texgraph::blocks {

// --- Tokens
// ------------------------------------------------------------------------------------------------------

TokenKind Parser::Kind(size_t ahead) const {
  size_t last = tokens_.tokens.size() - 1;
  return tokens_.tokens[std::min(at_ + ahead, last)].kind;
}

bool Parser::Accept(TokenKind kind) {
  if (!At(kind)) return false;
  ++at_;
  return true;
}

bool Parser::Expect(TokenKind kind, std::string_view where) {
  if (Accept(kind)) return true;
  SourceRange range = Range();
  // What is missing at the end of a line is missing there, not at the next line's first word.
  bool ends = kind == TokenKind::kSemicolon || kind == TokenKind::kRightParen;
  if (ends && at_ > 0) {
    uint32_t end = tokens_.tokens[at_ - 1].end;
    if (text_.substr(end, Now().begin - end).find('\n') != std::string_view::npos) {
      range = {file_.source, end, end + 1};
    }
  }
  Error(DiagnosticKind::kBlockSyntax, range,
        "expected " + std::string(TokenText(kind)) + " " + std::string(where) + ", " + Seen());
  return false;
}

SourceRange Parser::RangeFrom(uint32_t begin) const {
  return {file_.source, begin, at_ > 0 ? tokens_.tokens[at_ - 1].end : begin};
}

std::string Parser::Seen() const {
  if (At(TokenKind::kEnd)) return "found the end";
  return "found '" + Printable(Text(), 40) + "'";
}

Diagnostic* Parser::Error(DiagnosticKind kind, SourceRange range, std::string message) {
  return gave_up_ ? nullptr : &diagnostics_.Error(kind, range, std::move(message));
}

bool Parser::Enter() {
  if (++nesting_ <= kMaxNesting) return true;
  GiveUp(Range(), "this is nested too deeply; make functions of its parts");
  return false;
}

void Parser::GiveUp(SourceRange range, std::string message) {
  Error(DiagnosticKind::kNestingLimit, range, std::move(message));
  gave_up_ = true;
  at_ = tokens_.tokens.size() - 1;
}

void Parser::SkipBalanced() {
  TokenKind open = Kind();
  bool is_brace = open == TokenKind::kLeftBrace;
  TokenKind close = is_brace ? TokenKind::kRightBrace : TokenKind::kRightParen;
  uint32_t depth = 0;
  for (; !At(TokenKind::kEnd); ++at_) {
    // Parentheses hold no braces: one of these was never closed.
    if (!is_brace && (At(TokenKind::kLeftBrace) || At(TokenKind::kRightBrace))) return;
    if (At(open)) ++depth;
    if (At(close) && --depth == 0) {
      ++at_;
      return;
    }
  }
}

void Parser::SkipStatement() {
  while (!At(TokenKind::kEnd) && !At(TokenKind::kRightBrace)) {
    if (At(TokenKind::kLeftBrace)) return SkipBalanced();
    if (Accept(TokenKind::kSemicolon)) return;
    ++at_;
  }
}

// --- Declarations
// ------------------------------------------------------------------------------------------------

void Parser::ParseDeclarations() {
  file_.docs = tokens_.docs;
  while (!At(TokenKind::kEnd)) {
    size_t before = at_;
    ParseDeclaration();
    if (at_ == before) ++at_;
  }
}

DocLines Parser::TakeDocs() {
  DocLines lines;
  // Those inside the last declaration are for readers of the text.
  while (next_doc_ < file_.docs.size() && file_.docs[next_doc_].next_token < at_) ++next_doc_;
  lines.first = static_cast<uint32_t>(next_doc_);
  while (next_doc_ < file_.docs.size() && file_.docs[next_doc_].next_token == at_) ++next_doc_;
  lines.count = static_cast<uint32_t>(next_doc_) - lines.first;
  return lines;
}

void Parser::ParseDeclaration() {
  DocLines docs = TakeDocs();
  if (Accept(TokenKind::kSemicolon)) return;
  if (At(TokenKind::kStruct)) return ParseStruct(docs);
  if (At(TokenKind::kConst)) return ParseConstants(docs);
  if (RefusedQualifier()) return SkipStatement();
  if (At(TokenKind::kIdentifier)) return ParseFunctionOrVariable(docs);
  Error(DiagnosticKind::kBlockSyntax, Range(),
        "expected a function, a constant or a struct, " + Seen());
  // Behind a stray '}', the next declaration may be sound.
  if (!Accept(TokenKind::kRightBrace)) SkipStatement();
}

// Words of GLSL that a declaration may begin with elsewhere.
bool Parser::RefusedQualifier() {
  constexpr std::string_view kInterface =
      "what a block needs comes in through its function's parameters";
  constexpr std::string_view kNeedless = "blocks have no such qualifiers; leave it out";
  struct Refusal {
    std::string_view word;
    std::string_view advice;
  };
  constexpr Refusal kRefusals[] = {
      {"uniform", kInterface},   {"layout", kInterface},       {"varying", kInterface},
      {"attribute", kInterface}, {"buffer", kInterface},       {"shared", kInterface},
      {"highp", kNeedless},      {"mediump", kNeedless},       {"lowp", kNeedless},
      {"precision", kNeedless},  {"precise", kNeedless},       {"invariant", kNeedless},
      {"flat", kNeedless},       {"smooth", kNeedless},        {"centroid", kNeedless},
      {"coherent", kNeedless},   {"volatile", kNeedless},      {"restrict", kNeedless},
      {"subroutine", kNeedless}, {"noperspective", kNeedless},
  };
  std::string_view advice;
  if (At(TokenKind::kIn) || At(TokenKind::kOut) || At(TokenKind::kInout)) advice = kInterface;
  if (At(TokenKind::kIdentifier)) {
    for (const Refusal& refusal : kRefusals) {
      if (Text() == refusal.word) advice = refusal.advice;
    }
  }
  if (advice.empty()) return false;
  Error(DiagnosticKind::kBlockSubset, Range(), std::string(advice));
  return true;
}

bool Parser::ParseName(std::string_view what, std::string_view& name, SourceRange& range) {
  if (!At(TokenKind::kIdentifier)) {
    Error(DiagnosticKind::kBlockSyntax, Range(), "expected " + std::string(what) + ", " + Seen());
    return false;
  }
  name = Text();
  range = Range();
  ++at_;
  return true;
}

bool Parser::ParseType(TypeName& type) {
  if (!ParseName("a type", type.name, type.range)) return false;
  return ParseArraySuffix(type);
}

bool Parser::ParseArraySuffix(TypeName& type) {
  if (!At(TokenKind::kLeftBracket)) return true;
  if (type.is_array) {
    Error(DiagnosticKind::kBlockSubset, Range(), "blocks have no arrays of arrays");
    return false;
  }
  ++at_;
  type.is_array = true;
  if (!At(TokenKind::kRightBracket)) {
    type.length = ParseExpression();
    if (!type.length) return false;
  }
  if (!Expect(TokenKind::kRightBracket, "after the array's length")) return false;
  return ParseArraySuffix(type);
}

bool Parser::ParseDeclarators(const TypeName& type, std::vector<Declarator>& declarators) {
  do {
    Declarator& declarator = declarators.emplace_back();
    declarator.type = type;
    if (!ParseName("a name", declarator.name, declarator.range)) return false;
    if (!ParseArraySuffix(declarator.type)) return false;
    if (Accept(TokenKind::kAssign)) {
      declarator.value = ParseExpression();
      if (!declarator.value) return false;
    }
  } while (Accept(TokenKind::kComma));
  return true;
}

void Parser::ParseStruct(DocLines docs) {
  uint32_t begin = Now().begin;
  ++at_;
  StructAst& result = file_.structs.emplace_back();
  result.docs = docs;
  if (!ParseName("the struct's name", result.name, result.range) ||
      !Expect(TokenKind::kLeftBrace, "after the struct's name")) {
    return SkipStatement();
  }
  while (!At(TokenKind::kRightBrace) && !At(TokenKind::kEnd)) {
    TypeName type;
    bool whole = !RefusedQualifier() && ParseType(type) && ParseDeclarators(type, result.members) &&
                 Expect(TokenKind::kSemicolon, "after the member");
    if (!whole) SkipStatement();
  }
  if (Expect(TokenKind::kRightBrace, "after the struct's members")) {
    Expect(TokenKind::kSemicolon, "after the struct");
  }
  result.whole = RangeFrom(begin);
}

void Parser::ParseConstants(DocLines docs) {
  uint32_t begin = Now().begin;
  ++at_;
  TypeName type;
  std::vector<Declarator> declarators;
  bool whole = ParseType(type);
  if (whole && At(TokenKind::kIdentifier) && Kind(1) == TokenKind::kLeftParen) {
    Error(DiagnosticKind::kBlockSyntax, RangeFrom(begin), "a function's result is not 'const'");
    whole = false;
    ++at_;
    SkipBalanced();
  }
  whole = whole && ParseDeclarators(type, declarators) &&
          Expect(TokenKind::kSemicolon, "after the constant");
  if (!whole) return SkipStatement();
  for (Declarator& declarator : declarators) {
    file_.constants.push_back({declarator, docs, RangeFrom(begin)});
  }
}

void Parser::ParseFunctionOrVariable(DocLines docs) {
  FunctionAst& function = file_.functions.emplace_back();
  function.docs = docs;
  function.first_expr = file_.exprs.size();
  uint32_t begin = Now().begin;
  if (!ParseType(function.result) ||
      !ParseName("a function's name", function.name, function.range)) {
    file_.functions.pop_back();
    return SkipStatement();
  }
  if (!At(TokenKind::kLeftParen)) {
    if (At(TokenKind::kAssign) || At(TokenKind::kSemicolon) || At(TokenKind::kLeftBracket)) {
      Error(DiagnosticKind::kBlockSubset, function.range,
            "blocks have no global variables but constants; write 'const' or use a parameter");
    } else {
      Expect(TokenKind::kLeftParen, "after the function's name");
    }
    file_.functions.pop_back();
    return SkipStatement();
  }
  size_t open = at_;
  if (!ParseParameters(function)) SkipHeader(open);
  if (At(TokenKind::kLeftBrace)) {
    function.body = ParseBlock();
  } else if (!Expect(TokenKind::kSemicolon, "or a body in braces after the parameters")) {
    SkipStatement();
  }
  function.whole = RangeFrom(begin);
  function.last_expr = file_.exprs.size();
}

bool Parser::ParseParameters(FunctionAst& function) {
  ++at_;
  if (At(TokenKind::kIdentifier) && Text() == "void" && Kind(1) == TokenKind::kRightParen) ++at_;
  if (Accept(TokenKind::kRightParen)) return true;
  do {
    if (!ParseParameter(function)) return false;
  } while (Accept(TokenKind::kComma));
  return Expect(TokenKind::kRightParen, "or ',' after the parameter");
}

bool Parser::ParseParameter(FunctionAst& function) {
  ParameterAst& parameter = function.parameters.emplace_back();
  for (;; ++at_) {
    if (At(TokenKind::kConst)) {
      parameter.is_const = true;
    } else if (At(TokenKind::kOut) || At(TokenKind::kInout)) {
      parameter.is_out = true;
      parameter.is_inout = At(TokenKind::kInout);
    } else if (!At(TokenKind::kIn)) {
      break;
    }
  }
  if (RefusedQualifier() || !ParseType(parameter.type)) return false;
  parameter.range = parameter.type.range;
  if (!At(TokenKind::kIdentifier)) return true;
  parameter.name = Text();
  parameter.range = Range();
  ++at_;
  if (At(TokenKind::kAssign)) {
    Error(DiagnosticKind::kBlockSubset, Range(),
          "GLSL has no defaults here; write '/// @param " + std::string(parameter.name) +
              " ... @default value' above the function");
    return false;
  }
  return ParseArraySuffix(parameter.type);
}

// --- Entry points
// ------------------------------------------------------------------------------------------------

std::unique_ptr<FileAst> ParseFile(SourceId source, const Sources& sources,
                                   Diagnostics& diagnostics) {
  auto file = std::make_unique<FileAst>();
  file->source = source;
  std::string_view text = sources.Text(source);
  SourceRange all{source, 0, static_cast<uint32_t>(text.size())};
  Parser(*file, text, Lex(all, sources, diagnostics), diagnostics).ParseDeclarations();
  return file;
}

Expr* ParseDocExpression(FileAst& file, SourceRange range, const Sources& sources,
                         Diagnostics& diagnostics) {
  Diagnostics found;
  Tokens tokens = Lex(range, sources, found);
  Expr* expr = nullptr;
  if (!found.HasErrors()) {
    expr = Parser(file, sources.Text(file.source), std::move(tokens), found).ParseOnlyExpression();
  }
  if (!found.HasErrors()) return expr;
  const Diagnostic& first = found.all().front();
  diagnostics.Error(DiagnosticKind::kBlockDoc, first.range, first.message);
  return nullptr;
}

}  // namespace texgraph::blocks
