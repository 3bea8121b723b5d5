// SPDX-License-Identifier: Apache-2.0
#include "compiler/glsl/expressions.h"

#include <algorithm>

#include "compiler/glsl/literals.h"

namespace texgraph::glsl {
namespace {

Precedence Tighter(Precedence p) { return static_cast<Precedence>(static_cast<int>(p) - 1); }

bool IsCommutative(Op op) {
  return op == Op::kAdd || op == Op::kMul || op == Op::kAnd || op == Op::kOr || op == Op::kXor;
}

// The operators that have an assignment of their own.
bool HasAssignment(Op op) {
  switch (op) {
    case Op::kAdd:
    case Op::kSub:
    case Op::kMul:
    case Op::kDiv:
    case Op::kMod:
    case Op::kAnd:
    case Op::kOr:
    case Op::kXor:
    case Op::kShl:
    case Op::kShr:
      return true;
    default:
      return false;
  }
}

}  // namespace

// --- What an expression is ---------------------------------------------------------------------

bool Expressions::IsUniform(ValueId v) const {
  const Inst& inst = function_[v];
  if (!(ir::IsVector(inst.type) && !ir::IsScalar(inst.type)) && !ir::IsMatrix(inst.type))
    return false;
  if (inst.op == Op::kConst) return IsSplat(Words(inst));
  return inst.op == Op::kSplat && IsInline(v);
}

bool Expressions::IsNegativeConstant(ValueId v) const {
  const Inst& inst = function_[v];
  if (inst.op != Op::kConst || !(ir::IsVector(inst.type) || ir::IsMatrix(inst.type))) return false;
  std::span<const uint32_t> words = Words(inst);
  return IsSplat(words) && IsNegative(ScalarKind(inst.type), words[0]);
}

Expressions::Infix Expressions::InfixOf(const Inst& inst) const {
  const bool is_scalar = ir::IsScalar(inst.type);
  switch (inst.op) {
    case Op::kAdd:
      return {" + ", Precedence::kAdditive};
    case Op::kSub:
      return {" - ", Precedence::kAdditive};
    case Op::kMul: {
      // Between two matrices the sign means their product.
      std::span<const ValueId> operands = function_.Operands(inst);
      bool product = ir::IsMatrix(inst.type) && !IsUniform(operands[0]) && !IsUniform(operands[1]);
      return product ? Infix{} : Infix{" * ", Precedence::kMultiplicative};
    }
    case Op::kMatMul:
      return {" * ", Precedence::kMultiplicative};
    case Op::kDiv:
      return {" / ", Precedence::kMultiplicative};
    case Op::kMod:
      return {" % ", Precedence::kMultiplicative};
    case Op::kAnd:
      return {" & ", Precedence::kBitAnd};
    case Op::kOr:
      return {" | ", Precedence::kBitOr};
    case Op::kXor:
      return {" ^ ", Precedence::kBitXor};
    case Op::kShl:
      return {" << ", Precedence::kShift};
    case Op::kShr:
      return {" >> ", Precedence::kShift};
    case Op::kLt:
      return is_scalar ? Infix{" < ", Precedence::kRelational} : Infix{};
    case Op::kLe:
      return is_scalar ? Infix{" <= ", Precedence::kRelational} : Infix{};
    case Op::kEq:
      return is_scalar ? Infix{" == ", Precedence::kEquality} : Infix{};
    case Op::kNe:
      return is_scalar ? Infix{" != ", Precedence::kEquality} : Infix{};
    case Op::kLogicalAnd:
      return {" && ", Precedence::kAnd};
    case Op::kLogicalOr:
      return {" || ", Precedence::kOr};
    case Op::kLogicalXor:
      return is_scalar ? Infix{" ^^ ", Precedence::kXor} : Infix{};
    default:
      return {};
  }
}

Precedence Expressions::PrecedenceOf(ValueId v) const {
  const Inst& inst = function_[v];
  if (Infix infix = InfixOf(inst); !infix.symbol.empty()) return infix.precedence;
  switch (inst.op) {
    case Op::kNeg:
    case Op::kNot:
      return Precedence::kUnary;
    case Op::kLogicalNot:
      return ir::IsScalar(inst.type) ? Precedence::kUnary : Precedence::kPostfix;
    case Op::kIf:
      return Precedence::kConditional;
    case Op::kSelect:
      return ir::IsScalar(function_[function_.Operands(inst)[0]].type) ? Precedence::kConditional
                                                                       : Precedence::kPostfix;
    default:
      return Precedence::kPostfix;
  }
}

void Expressions::CollectReads(ValueId v, std::vector<VariableId>& reads) const {
  if (VariableId variable = variables_.Of(v)) {
    reads.push_back(variable);
  } else if (IsInline(v)) {
    ForEachOperand(function_, v, [&](ValueId operand) { CollectReads(operand, reads); });
  }
}

// --- Writing -------------------------------------------------------------------------------------

void Expressions::Append(ValueId v, Precedence limit, std::string& out) const {
  if (VariableId variable = variables_.Of(v)) {
    out += NameOf(variable);
    return;
  }
  const Inst& inst = function_[v];
  if (forms_.Of(v) == Form::kLeaf) return AppendLeaf(inst, limit, out);
  // any() and all() of a scalar are the scalar.
  if ((inst.op == Op::kAny || inst.op == Op::kAll) &&
      ir::IsScalar(function_[function_.Operands(inst)[0]].type)) {
    return Append(function_.Operands(inst)[0], limit, out);
  }
  bool parentheses = PrecedenceOf(v) > limit;
  if (parentheses) out += '(';
  AppendOperation(v, out);
  if (parentheses) out += ')';
}

void Expressions::AppendLeaf(const Inst& inst, Precedence limit, std::string& out) const {
  if (inst.op == Op::kParam) {
    out += parameter_names_[inst.aux];
  } else if (inst.op == Op::kGlobal) {
    names_.AppendRead(GlobalId(inst.aux), out);
  } else if (names_.HasArray(ir::ConstId(inst.aux))) {
    out += names_.Array(ir::ConstId(inst.aux));
  } else {
    std::span<const uint32_t> words = Words(inst);
    bool negative = ir::IsScalar(inst.type) && IsNegative(ir::ScalarOf(inst.type), words[0]) &&
                    limit < Precedence::kUnary;
    if (negative) out += '(';
    AppendLiteral(
        module_.types, inst.type, words, [&](TypeId t) { return names_.Type(t); }, out);
    if (negative) out += ')';
  }
}

void Expressions::AppendOperation(ValueId v, std::string& out) const {
  const Inst& inst = function_[v];
  std::span<const ValueId> operands = function_.Operands(inst);
  if (Infix infix = InfixOf(inst); !infix.symbol.empty()) return AppendInfix(v, infix, out);
  switch (inst.op) {
    case Op::kMul:
      return AppendCall(v, "matrixCompMult", out);
    case Op::kNeg:
    case Op::kNot:
      return AppendNegative(inst, out);
    case Op::kLogicalNot:
      if (!ir::IsScalar(inst.type)) return AppendCall(v, "not", out);
      out += '!';
      return Append(operands[0], Precedence::kUnary, out);
    case Op::kLogicalXor:
      return AppendCall(v, "notEqual", out);
    case Op::kLt:
      return AppendCall(v, "lessThan", out);
    case Op::kLe:
      return AppendCall(v, "lessThanEqual", out);
    case Op::kEq:
      return AppendCall(v, "equal", out);
    case Op::kNe:
      return AppendCall(v, "notEqual", out);
    case Op::kSelect:
      return AppendSelect(v, out);
    case Op::kIf: {
      const ir::Branch& branch = function_.branches[inst.aux];
      return AppendConditional(operands[0], function_.regions[branch.then_region.index].results[0],
                               function_.regions[branch.else_region.index].results[0], out);
    }
    case Op::kConvert:
      return AppendCall(v, names_.Type(inst.type), out);
    case Op::kBitcast:
      return AppendBitcast(inst, operands[0], out);
    case Op::kSplat:
      return AppendSplat(inst, out);
    case Op::kConstruct:
      return AppendConstruct(v, out);
    case Op::kExtract:
    case Op::kSwizzle:
    case Op::kIndex:
      return AppendAccess(v, out);
    case Op::kCall:
      return AppendCall(v, names_.Function(FunctionId(inst.aux)), out);
    case Op::kAny:
    case Op::kAll:
      if (ir::IsScalar(function_[operands[0]].type))
        return Append(operands[0], Precedence::kAnything, out);
      break;
    default:
      break;
  }
  std::string_view name = ir::Info(inst.op).glsl;
  if (name.ends_with('(')) name.remove_suffix(1);
  AppendCall(v, name, out);
}

// --- Operators -----------------------------------------------------------------------------------

void Expressions::AppendOperand(ValueId v, bool as_scalar, Precedence limit,
                                std::string& out) const {
  const Inst& inst = function_[v];
  if (!as_scalar || !IsUniform(v)) return Append(v, limit, out);
  if (inst.op == Op::kSplat) return Append(function_.Operands(inst)[0], limit, out);
  bool negative = IsNegativeConstant(v) && limit < Precedence::kUnary;
  if (negative) out += '(';
  AppendScalar(ScalarKind(inst.type), Words(inst)[0], out);
  if (negative) out += ')';
}

void Expressions::AppendInfix(ValueId v, Infix infix, std::string& out) const {
  const Inst& inst = function_[v];
  std::span<const ValueId> operands = function_.Operands(inst);
  if ((inst.op == Op::kAdd || inst.op == Op::kSub) && AppendSum(v, out)) return;
  if (infix.precedence == Precedence::kRelational) return AppendComparison(v, out);
  // One side must stay what the result is; a shift's left one always.
  bool may_left = inst.op != Op::kMatMul && !IsUniform(operands[1]) && inst.op != Op::kShl &&
                  inst.op != Op::kShr;
  bool may_right = inst.op != Op::kMatMul;
  // People do not remember how bits, shifts and arithmetic bind, so mixtures get parentheses.
  auto limit_of = [&](ValueId operand, Precedence limit) {
    bool bits = infix.precedence >= Precedence::kBitAnd && infix.precedence <= Precedence::kBitOr;
    bool logic = infix.precedence >= Precedence::kAnd;
    bool same = function_[operand].op == inst.op;
    if (same || !(bits || logic || infix.precedence == Precedence::kShift)) return limit;
    return logic ? std::min(limit, Precedence::kEquality) : Precedence::kUnary;
  };
  AppendOperand(operands[0], may_left, limit_of(operands[0], infix.precedence), out);
  out += infix.symbol;
  // What is associative to the bit needs no parentheses on the right.
  bool associative =
      infix.precedence >= Precedence::kBitAnd && function_[operands[1]].op == inst.op;
  Precedence right = associative ? infix.precedence : Tighter(infix.precedence);
  AppendOperand(operands[1], may_right, limit_of(operands[1], right), out);
}

// "a - 2.0" for a + -2.0, "a - b" for a + -b, "a + 2.0" for a - -2.0. True if it was one of these.
bool Expressions::AppendSum(ValueId v, std::string& out) const {
  const Inst& inst = function_[v];
  ValueId left = function_.Operands(inst)[0], right = function_.Operands(inst)[1];
  const Inst& other = function_[right];
  bool is_add = inst.op == Op::kAdd;
  bool negated = is_add && other.op == Op::kNeg && IsInline(right);
  bool constant = IsNegativeConstant(right);
  if (!negated && !constant) return false;
  AppendOperand(left, !IsUniform(right), Precedence::kAdditive, out);
  out += is_add ? " - " : " + ";
  if (negated) {
    AppendOperand(function_.Operands(other)[0], true, Precedence::kMultiplicative, out);
  } else {
    std::string scalar;
    AppendScalar(ScalarKind(other.type), Words(other)[0], scalar);
    out += std::string_view(scalar).substr(1);
  }
  return true;
}

// A constant stands on the right: "x > 0.5" for 0.5 < x.
void Expressions::AppendComparison(ValueId v, std::string& out) const {
  const Inst& inst = function_[v];
  ValueId left = function_.Operands(inst)[0], right = function_.Operands(inst)[1];
  bool turn = function_[left].op == Op::kConst && function_[right].op != Op::kConst;
  if (turn) std::swap(left, right);
  Append(left, Precedence::kShift, out);
  out += turn ? (inst.op == Op::kLt ? " > " : " >= ") : (inst.op == Op::kLt ? " < " : " <= ");
  Append(right, Precedence::kShift, out);
}

void Expressions::AppendNegative(const Inst& inst, std::string& out) const {
  std::string operand;
  Append(function_.Operands(inst)[0], Precedence::kUnary, operand);
  bool parentheses = operand.starts_with('-');
  out += inst.op == Op::kNeg ? '-' : '~';
  if (parentheses) out += '(';
  out += operand;
  if (parentheses) out += ')';
}

void Expressions::AppendConditional(ValueId condition, ValueId then_value, ValueId else_value,
                                    std::string& out) const {
  Append(condition, Precedence::kOr, out);
  out += " ? ";
  Append(then_value, Precedence::kOr, out);
  out += " : ";
  Append(else_value, Precedence::kConditional, out);
}

void Expressions::AppendSelect(ValueId v, std::string& out) const {
  std::span<const ValueId> operands = function_.Operands(v);
  if (ir::IsScalar(function_[operands[0]].type)) {
    return AppendConditional(operands[0], operands[1], operands[2], out);
  }
  out += "mix(";
  AppendArguments(std::array{operands[2], operands[1], operands[0]}, out);
  out += ')';
}

void Expressions::AppendNegation(ValueId v, std::string& out) const {
  const Inst& inst = function_[v];
  bool is_operation = !variables_.Of(v) && IsInline(v);
  if (is_operation && inst.op == Op::kLogicalNot) {
    return Append(function_.Operands(inst)[0], Precedence::kAnything, out);
  }
  bool equality = inst.op == Op::kEq || inst.op == Op::kNe;
  if (is_operation && equality) {
    Append(function_.Operands(inst)[0], Precedence::kRelational, out);
    out += inst.op == Op::kEq ? " != " : " == ";
    return Append(function_.Operands(inst)[1], Precedence::kRelational, out);
  }
  out += '!';
  Append(v, Precedence::kUnary, out);
}

void Expressions::AppendAssignment(VariableId to, ValueId v, bool is_definition,
                                   std::string& out) const {
  const Inst& inst = function_[v];
  bool is_operation = is_definition || (!variables_.Of(v) && IsInline(v));
  Infix infix = InfixOf(inst);
  out += NameOf(to);
  if (is_operation && HasAssignment(inst.op) && !infix.symbol.empty()) {
    std::span<const ValueId> operands = function_.Operands(inst);
    bool first = variables_.Of(operands[0]) == to;
    bool second = variables_.Of(operands[1]) == to && IsCommutative(inst.op);
    if (first || second) {
      ValueId other = operands[first ? 1 : 0];
      if (inst.op == Op::kAdd && IsNegativeConstant(other)) {
        std::string scalar;
        AppendScalar(ScalarKind(function_[other].type), Words(function_[other])[0], scalar);
        out += " -= ";
        out += std::string_view(scalar).substr(1);
        return;
      }
      out += infix.symbol.substr(0, infix.symbol.size() - 1);
      out += "= ";
      return AppendOperand(other, true, Precedence::kConditional, out);
    }
  }
  out += " = ";
  if (is_definition) {
    AppendOperation(v, out);
  } else {
    Append(v, Precedence::kAnything, out);
  }
}

}  // namespace texgraph::glsl
