// SPDX-License-Identifier: Apache-2.0
// The expressions that look like calls, and those that take values apart.
#include "compiler/glsl/expressions.h"
#include "compiler/ir/builder.h"

namespace texgraph::glsl {
namespace {

constexpr char kComponents[] = "xyzw";

void AppendComponents(uint32_t mask, uint32_t width, std::string& out) {
  for (uint32_t i = 0; i < width; ++i) out += kComponents[ir::SwizzleComponent(mask, i)];
}

// Which arguments of a built-in function may be scalars beside vectors; groups of bits go together.
uint32_t ScalarArguments(Op op) {
  switch (op) {
    case Op::kMin:
    case Op::kMax:
    case Op::kFmod:
      return 0b010;
    case Op::kClamp:
      return 0b110;
    case Op::kMix:
      return 0b100;
    case Op::kStep:
      return 0b001;
    case Op::kSmoothstep:
      return 0b011;
    default:
      return 0;
  }
}

}  // namespace

void Expressions::AppendArguments(std::span<const ValueId> operands, std::string& out) const {
  for (size_t i = 0; i < operands.size(); ++i) {
    if (i > 0) out += ", ";
    Append(operands[i], Precedence::kConditional, out);
  }
}

void Expressions::AppendCall(ValueId v, std::string_view name, std::string& out) const {
  const Inst& inst = function_[v];
  std::span<const ValueId> operands = function_.Operands(inst);
  uint32_t scalars = ScalarArguments(inst.op);
  for (size_t i = 0; i < operands.size() && i < 3; ++i) {
    if ((scalars >> i & 1) && !IsUniform(operands[i])) scalars = 0;
  }
  out += name;
  out += '(';
  for (size_t i = 0; i < operands.size(); ++i) {
    if (i > 0) out += ", ";
    AppendOperand(operands[i], i < 3 && (scalars >> i & 1), Precedence::kConditional, out);
  }
  out += ')';
}

void Expressions::AppendConstruct(ValueId v, std::string& out) const {
  const Inst& inst = function_[v];
  if (!ir::IsVector(inst.type)) return AppendCall(v, names_.Type(inst.type), out);
  Parts parts = ConstructParts(function_, inst);
  auto append_part = [&](const Part& part, Precedence limit) {
    Append(part.value, part.width ? Precedence::kPostfix : limit, out);
    if (!part.width) return;
    out += '.';
    AppendComponents(part.mask, part.width, out);
  };
  if (parts.count == 1) return append_part(parts.list[0], Precedence::kPostfix);
  out += names_.Type(inst.type);
  out += '(';
  for (uint32_t i = 0; i < parts.count; ++i) {
    if (i > 0) out += ", ";
    append_part(parts.list[i], Precedence::kConditional);
  }
  out += ')';
}

// A matrix of one number everywhere is its outer product with ones: mat2(s) would be a diagonal.
void Expressions::AppendSplat(const Inst& inst, std::string& out) const {
  ValueId scalar = function_.Operands(inst)[0];
  TypeId column = ir::IsMatrix(inst.type) ? ir::ColumnType(inst.type) : inst.type;
  if (ir::IsMatrix(inst.type)) out += "outerProduct(";
  out += names_.Type(column);
  out += '(';
  Append(scalar, Precedence::kConditional, out);
  out += ')';
  if (ir::IsMatrix(inst.type)) out += ", " + names_.Type(column) + "(1.0))";
}

void Expressions::AppendAccess(ValueId v, std::string& out) const {
  const Inst& inst = function_[v];
  ValueId from = function_.Operands(inst)[0];
  TypeId type = function_[from].type;
  if (inst.op == Op::kSwizzle && ir::IsScalar(type)) {
    out += names_.Type(inst.type) + "(";
    Append(from, Precedence::kConditional, out);
    out += ')';
    return;
  }
  Append(from, Precedence::kPostfix, out);
  if (inst.op == Op::kIndex) {
    out += '[';
    Append(function_.Operands(inst)[1], Precedence::kAnything, out);
    out += ']';
  } else if (inst.op == Op::kSwizzle) {
    out += '.';
    AppendComponents(inst.aux, ir::Width(inst.type), out);
  } else if (module_.types.Kind(type) == ir::TypeKind::kStruct) {
    out += '.';
    out += module_.types[type].fields[inst.aux].name;
  } else if (ir::IsVector(type)) {
    out += '.';
    out += kComponents[inst.aux];
  } else {
    out += '[' + std::to_string(inst.aux) + ']';
  }
}

void Expressions::AppendBitcast(const Inst& inst, ValueId operand, std::string& out) const {
  ir::Scalar from = ir::ScalarOf(function_[operand].type), to = ir::ScalarOf(inst.type);
  if (from == ir::Scalar::kFloat && to == ir::Scalar::kUint) {
    out += "floatBitsToUint";
  } else if (from == ir::Scalar::kFloat && to == ir::Scalar::kInt) {
    out += "floatBitsToInt";
  } else if (from == ir::Scalar::kUint && to == ir::Scalar::kFloat) {
    out += "uintBitsToFloat";
  } else if (from == ir::Scalar::kInt && to == ir::Scalar::kFloat) {
    out += "intBitsToFloat";
  } else {
    out += names_.Type(inst.type);  // between int and uint, conversion keeps the bits
  }
  out += '(';
  Append(operand, Precedence::kConditional, out);
  out += ')';
}

}  // namespace texgraph::glsl
