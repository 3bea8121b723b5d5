// SPDX-License-Identifier: Apache-2.0
#include "compiler/ir/parse_function.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "compiler/ir/verify.h"

namespace texgraph::ir {
namespace {

constexpr int64_t kIntMin = std::numeric_limits<int32_t>::min();
constexpr int64_t kIntMax = std::numeric_limits<int32_t>::max();

class FunctionParser {
 public:
  FunctionParser(TextReader& reader, Module& module, const TextNames& names, Function& function,
                 FunctionRanges& ranges)
      : reader_(reader), module_(module), names_(names), f_(function), ranges_(ranges) {}

  bool Parse();

 private:
  struct Statement {
    Token name;
    Op op = Op::kConst;
    TypeId type;
    uint32_t aux = 0;
    std::vector<ValueId> operands;
    Token mask;  // of a swizzle
  };

  bool ParseParameters();
  bool ParseResults();
  bool ParseRegion(RegionId region, std::string_view end);
  bool ParseStatement();
  bool ParsePlain(Statement& statement);
  bool ParseExtract(Statement& statement);
  bool ParseSwizzle(Statement& statement);
  bool ParseCall(Statement& statement);
  bool ParseIf(Statement& statement);
  bool ParseFor(Statement& statement);
  bool ParseOperands(std::vector<ValueId>& operands);
  bool ParseArguments(std::vector<ValueId>& operands);
  ValueId Operand();
  ValueId Constant(SourceRange range);
  ValueId Global(const Token& token);

  RegionId BeginRegion() {
    f_.regions.emplace_back();
    return RegionId(f_.regions.size() - 1);
  }
  ValueId Append(Op op, TypeId type, uint32_t aux, std::span<const ValueId> operands,
                 SourceRange range);
  ValueId Parameter(RegionId region, const Token& name, TypeId type);
  bool Declare(const Token& name, ValueId v);

  TextReader& reader_;
  Module& module_;
  const TextNames& names_;
  Function& f_;
  FunctionRanges& ranges_;
  std::unordered_map<std::string, ValueId> values_;
  std::unordered_map<ConstId, ValueId> constants_;
  std::vector<RegionId> open_;
  std::vector<std::pair<GlobalId, ValueId>> globals_;  // in scope
};

ValueId FunctionParser::Append(Op op, TypeId type, uint32_t aux, std::span<const ValueId> operands,
                               SourceRange range) {
  Inst inst;
  inst.op = op;
  inst.type = type;
  inst.aux = aux;
  inst.operand_count = static_cast<uint16_t>(operands.size());
  inst.first_operand = static_cast<uint32_t>(f_.operands.size());
  f_.operands.insert(f_.operands.end(), operands.begin(), operands.end());
  f_.insts.push_back(inst);
  f_.names.emplace_back();
  f_.origins.push_back(f_.origin);
  ranges_.values.push_back(range);
  ValueId v(f_.insts.size() - 1);
  if (op != Op::kConst && op != Op::kParam) f_.regions[open_.back().index].body.push_back(v);
  return v;
}

// The side table has the name without the number that tells it from others, and nothing for "%7".
bool FunctionParser::Declare(const Token& name, ValueId v) {
  if (!reader_.ok()) return false;
  if (!values_.emplace(name.text, v).second) {
    return reader_.Fail(name.range, "a second value named '" + name.text + "'");
  }
  std::string_view base = std::string_view(name.text).substr(0, name.text.find('.'));
  if (base[0] < '0' || base[0] > '9') f_.names[v.index] = module_.InternName(base);
  return true;
}

ValueId FunctionParser::Parameter(RegionId region, const Token& name, TypeId type) {
  uint32_t index = static_cast<uint32_t>(f_.regions[region.index].params.size());
  ValueId v = Append(Op::kParam, type, index, {}, name.range);
  f_.regions[region.index].params.push_back(v);
  Declare(name, v);
  return v;
}

// --- The header ----------------------------------------------------------------------------------

bool FunctionParser::Parse() {
  ranges_.header = reader_.Peek().range;
  f_.name = reader_.Name("the function's name");
  f_.display_name = reader_.Accept("as") ? reader_.Name("a name") : f_.name;
  f_.body = BeginRegion();
  if (!ParseParameters() || !ParseResults()) return false;
  f_.origin = reader_.ReadOrigin(OriginId());
  f_.origins.assign(f_.insts.size(), f_.origin);
  return reader_.Expect("{") && ParseRegion(f_.body, "return") && reader_.Expect("}");
}

bool FunctionParser::ParseParameters() {
  if (!reader_.Expect("(")) return false;
  while (reader_.ok() && !reader_.At(")")) {
    ir::Parameter parameter;
    parameter.is_template = reader_.Accept("const");
    Token name = reader_.TakeKind(TokenKind::kValue, "a parameter");
    reader_.Expect(":");
    parameter.type = reader_.ReadType();
    parameter.repeats = reader_.Accept("repeats");
    if (!reader_.ok()) return false;
    ValueId v = Parameter(f_.body, name, parameter.type);
    if (NameId id = f_.NameOf(v)) parameter.name = module_.Name(id);
    f_.parameters.push_back(std::move(parameter));
    if (!reader_.Accept(",")) break;
  }
  return reader_.Expect(")") && reader_.Expect("->");
}

bool FunctionParser::ParseResults() {
  if (!reader_.Accept("(")) {
    f_.results.push_back({"", reader_.ReadType()});
    return reader_.ok();
  }
  while (reader_.ok() && !reader_.At(")")) {
    Result result;
    // A word is a name if a colon follows it, and a type otherwise.
    if (reader_.PeekAfter().text == ":") {
      result.name = reader_.Name("the result's name");
      reader_.Expect(":");
    }
    result.type = reader_.ReadType();
    f_.results.push_back(std::move(result));
    if (!reader_.Accept(",")) break;
  }
  return reader_.Expect(")");
}

// --- Bodies --------------------------------------------------------------------------------------

bool FunctionParser::ParseRegion(RegionId region, std::string_view end) {
  if (open_.size() == kMaxRegionDepth) {
    return reader_.Fail(reader_.Peek().range,
                        "regions nest deeper than " + std::to_string(kMaxRegionDepth),
                        DiagnosticKind::kNestingLimit);
  }
  open_.push_back(region);
  const size_t globals_outside = globals_.size();
  while (reader_.ok() && !reader_.At(end)) ParseStatement();
  std::vector<ValueId> results;
  if (!reader_.Expect(end)) return false;
  if (!reader_.At("}") && !ParseOperands(results)) return false;
  f_.regions[region.index].results = std::move(results);
  globals_.resize(globals_outside);
  open_.pop_back();
  return true;
}

bool FunctionParser::ParseStatement() {
  Statement statement;
  if (!reader_.ok()) return false;
  statement.name = reader_.TakeKind(TokenKind::kValue, "a value, 'yield' or 'return'");
  reader_.Expect("=");
  const Token word = reader_.TakeKind(TokenKind::kIdentifier, "an operation");
  if (!reader_.ok()) return false;
  std::optional<Op> op = FindOp(word.text);
  if (!op || Info(*op).shape == OpShape::kLeaf) {
    return reader_.Fail(word.range, "unknown operation '" + word.text + "'");
  }
  statement.op = *op;
  bool parsed = statement.op == Op::kIf    ? ParseIf(statement)
                : statement.op == Op::kFor ? ParseFor(statement)
                                           : ParsePlain(statement);
  if (!parsed) return false;
  if (statement.operands.size() > std::numeric_limits<uint16_t>::max()) {
    return reader_.Fail(word.range, "too many operands");
  }
  ValueId v =
      Append(statement.op, statement.type, statement.aux, statement.operands, statement.name.range);
  f_.origins[v.index] = reader_.ReadOrigin(f_.origin);
  return Declare(statement.name, v);
}

bool FunctionParser::ParsePlain(Statement& statement) {
  bool parsed = false;
  switch (statement.op) {
    case Op::kExtract:
      parsed = ParseExtract(statement);
      break;
    case Op::kSwizzle:
      parsed = ParseSwizzle(statement);
      break;
    case Op::kCall:
    case Op::kFieldRef:
      parsed = ParseCall(statement);
      break;
    case Op::kCallField:
      statement.operands.push_back(Operand());
      parsed = reader_.ok() && ParseArguments(statement.operands);
      break;
    default:
      parsed = reader_.At(":") || ParseOperands(statement.operands);
      break;
  }
  if (!parsed || !reader_.Expect(":")) return false;
  statement.type = reader_.ReadType();
  const size_t components = statement.mask.text.size();
  if (reader_.ok() && components > 0 && components != module_.types.Words(statement.type)) {
    return reader_.Fail(statement.mask.range, "as many components as the result has");
  }
  return reader_.ok();
}

bool FunctionParser::ParseExtract(Statement& statement) {
  if (!reader_.Expect(".")) return false;
  statement.aux = static_cast<uint32_t>(reader_.Integer(0, kIntMax));
  return ParseOperands(statement.operands);
}

bool FunctionParser::ParseSwizzle(Statement& statement) {
  if (!reader_.Expect(".")) return false;
  statement.mask = reader_.TakeKind(TokenKind::kIdentifier, "components");
  const Token& mask = statement.mask;
  if (mask.text.size() > 4) return reader_.Fail(mask.range, "more than four components");
  for (size_t i = 0; i < mask.text.size(); ++i) {
    constexpr std::string_view kComponents = "xyzw";
    size_t component = kComponents.find(mask.text[i]);
    if (component == std::string_view::npos) {
      return reader_.Fail(mask.range, "components are x, y, z and w");
    }
    statement.aux |= static_cast<uint32_t>(component) << (2 * i);
  }
  return ParseOperands(statement.operands);
}

bool FunctionParser::ParseCall(Statement& statement) {
  const SourceRange range = reader_.Peek().range;
  std::string name = reader_.Name("a function");
  if (!reader_.ok()) return false;
  auto callee = names_.functions.find(name);
  if (callee == names_.functions.end()) {
    return reader_.Fail(range, "no function '" + name + "' before this one");
  }
  statement.aux = callee->second.index;
  return ParseArguments(statement.operands);
}

bool FunctionParser::ParseIf(Statement& statement) {
  statement.operands.push_back(Operand());
  if (!reader_.Expect(":")) return false;
  statement.type = reader_.ReadType();
  Branch branch;
  branch.then_region = BeginRegion();
  if (!reader_.Expect("{") || !ParseRegion(branch.then_region, "yield")) return false;
  if (!reader_.Expect("}") || !reader_.Expect("else")) return false;
  branch.else_region = BeginRegion();
  if (!reader_.Expect("{") || !ParseRegion(branch.else_region, "yield")) return false;
  f_.branches.push_back(branch);
  statement.aux = static_cast<uint32_t>(f_.branches.size() - 1);
  return reader_.Expect("}");
}

bool FunctionParser::ParseFor(Statement& statement) {
  ForLoop loop;
  loop.body = BeginRegion();
  const Token index = reader_.TakeKind(TokenKind::kValue, "the index");
  reader_.Expect("=");
  loop.first = static_cast<int32_t>(reader_.Integer(kIntMin, kIntMax));
  reader_.Expect("to");
  loop.last = static_cast<int32_t>(reader_.Integer(kIntMin, kIntMax));
  reader_.Expect("step");
  loop.step = static_cast<int32_t>(reader_.Integer(kIntMin, kIntMax));
  if (!reader_.Expect("(")) return false;
  std::vector<Token> carried;
  while (reader_.ok() && !reader_.At(")")) {
    carried.push_back(reader_.TakeKind(TokenKind::kValue, "a carried value"));
    reader_.Expect("=");
    statement.operands.push_back(Operand());
    if (!reader_.Accept(",")) break;
  }
  if (!reader_.Expect(")") || !reader_.Expect(":")) return false;
  statement.type = reader_.ReadType();
  if (!reader_.ok()) return false;
  Parameter(loop.body, index, kInt);
  for (size_t i = 0; i < carried.size(); ++i) {
    Parameter(loop.body, carried[i], f_[statement.operands[i]].type);
  }
  if (!reader_.Expect("{") || !ParseRegion(loop.body, "yield")) return false;
  f_.loops.push_back(loop);
  statement.aux = static_cast<uint32_t>(f_.loops.size() - 1);
  return reader_.Expect("}");
}

// --- Operands ------------------------------------------------------------------------------------

bool FunctionParser::ParseOperands(std::vector<ValueId>& operands) {
  do {
    operands.push_back(Operand());
  } while (reader_.Accept(","));
  return reader_.ok();
}

bool FunctionParser::ParseArguments(std::vector<ValueId>& operands) {
  if (!reader_.Expect("(")) return false;
  if (!reader_.At(")") && !ParseOperands(operands)) return false;
  return reader_.Expect(")");
}

ValueId FunctionParser::Operand() {
  if (!reader_.ok()) return ValueId();
  const TokenKind kind = reader_.Peek().kind;
  if (kind == TokenKind::kGlobal) return Global(reader_.Take());
  if (kind != TokenKind::kValue) return Constant(reader_.Peek().range);
  const Token token = reader_.Take();
  auto known = values_.find(token.text);
  if (known != values_.end()) return known->second;
  reader_.Fail(token.range, "no value '" + token.text + "' before this");
  return ValueId();
}

ValueId FunctionParser::Constant(SourceRange range) {
  ConstId id = reader_.ReadConstant();
  if (!id) return ValueId();
  auto [known, added] = constants_.try_emplace(id);
  if (added) known->second = Append(Op::kConst, module_.constant(id).type, id.index, {}, range);
  return known->second;
}

ValueId FunctionParser::Global(const Token& token) {
  auto found = names_.globals.find(token.text);
  if (found == names_.globals.end()) {
    reader_.Fail(token.range, "no input, uniform or texture '" + token.text + "'");
    return ValueId();
  }
  const GlobalId id = found->second;
  auto known = std::ranges::find(globals_, id, &std::pair<GlobalId, ValueId>::first);
  if (known != globals_.end()) return known->second;
  ValueId v = Append(Op::kGlobal, module_.globals[id.index].type, id.index, {}, token.range);
  globals_.emplace_back(id, v);
  return v;
}

}  // namespace

bool ParseFunction(TextReader& reader, Module& module, const TextNames& names, Function& function,
                   FunctionRanges& ranges) {
  return FunctionParser(reader, module, names, function, ranges).Parse();
}

}  // namespace texgraph::ir
