// SPDX-License-Identifier: Apache-2.0
#include "compiler/glsl/names.h"

#include "compiler/base/text.h"

namespace texgraph::glsl {
namespace {

// GLSL promises 1,024 characters.
constexpr size_t kMaxLength = 256;

bool IsWord(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

bool IsDigit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

std::string Identifier(std::string_view wish) {
  std::string name;
  for (char c : wish) {
    if (!IsWord(c)) c = '_';
    if (c == '_' && name.ends_with('_')) continue;
    if (name.empty() && IsDigit(c)) continue;
    name += c;
    if (name.size() == kMaxLength) break;
  }
  if (name.starts_with("gl_")) name.erase(0, 3);
  while (!name.empty() && IsDigit(name[0])) name.erase(0, 1);
  return name.empty() || name == "_" ? "value" : name;
}

void AppendComment(std::string_view text, std::string& out) {
  for (char c : text.substr(0, 200)) out += c < ' ' || c > '~' || c == '\\' ? '_' : c;
}

// --- NameTable ---------------------------------------------------------------------------------

bool NameTable::IsFree(std::string_view name) const {
  return !IsTaken(name) && !(unwanted_ && unwanted_(name)) && !IsReservedInGlsl(name);
}

std::string_view NameTable::Add(std::string name) {
  texts_.push_back(std::move(name));
  std::string_view text = texts_.back();
  ++*taken_.Add(text, 0).first;
  log_.push_back(text);
  return text;
}

std::string_view NameTable::Claim(std::string_view wish) {
  std::string base = Identifier(wish);
  if (IsFree(base)) return Add(std::move(base));
  auto number = next_number_.find(base);
  if (number == next_number_.end()) {
    texts_.push_back(base);
    number = next_number_.emplace(texts_.back(), 2).first;
    number_log_.emplace_back(number->first, 0);
  } else {
    number_log_.emplace_back(number->first, number->second);
  }
  if (IsDigit(base.back())) base += '_';
  for (;;) {
    std::string name = base + std::to_string(number->second++);
    if (IsFree(name)) return Add(std::move(name));
  }
}

void NameTable::Close() {
  Mark mark = marks_.back();
  marks_.pop_back();
  while (log_.size() > mark.names) {
    --*taken_.Find(log_.back());
    log_.pop_back();
  }
  while (number_log_.size() > mark.numbers) {
    auto [base, before] = number_log_.back();
    number_log_.pop_back();
    if (before == 0) {
      next_number_.erase(base);
    } else {
      next_number_[base] = before;
    }
  }
}

// --- Descriptions ------------------------------------------------------------------------------

namespace {

std::string_view OperationName(ir::Op op) {
  using ir::Op;
  switch (op) {
    case Op::kAdd:
    case Op::kFma:
      return "sum";
    case Op::kSub:
      return "difference";
    case Op::kMul:
      return "product";
    case Op::kDiv:
      return "ratio";
    case Op::kNeg:
      return "negative";
    case Op::kMin:
      return "least";
    case Op::kMax:
      return "greatest";
    case Op::kClamp:
      return "clamped";
    case Op::kAbs:
      return "magnitude";
    case Op::kSign:
      return "direction";
    case Op::kMod:
    case Op::kFmod:
      return "remainder";
    case Op::kAnd:
    case Op::kOr:
    case Op::kXor:
    case Op::kNot:
    case Op::kShl:
    case Op::kShr:
    case Op::kBitcast:
      return "bits";
    case Op::kFloor:
    case Op::kCeil:
    case Op::kTrunc:
    case Op::kRound:
      return "whole";
    case Op::kFract:
      return "fraction";
    case Op::kStep:
      return "edge";
    case Op::kMix:
      return "blend";
    case Op::kSmoothstep:
      return "ramp";
    case Op::kSqrt:
      return "root";
    case Op::kInverseSqrt:
      return "inverse_root";
    case Op::kPow:
      return "power";
    case Op::kExp:
    case Op::kExp2:
      return "growth";
    case Op::kLog:
    case Op::kLog2:
      return "logarithm";
    case Op::kSin:
      return "sine";
    case Op::kCos:
      return "cosine";
    case Op::kTan:
      return "tangent";
    case Op::kAsin:
    case Op::kAcos:
    case Op::kAtan:
    case Op::kAtan2:
      return "angle";
    case Op::kDot:
      return "projection";
    case Op::kLength:
      return "norm";
    case Op::kDistance:
      return "gap";
    case Op::kNormalize:
      return "unit";
    case Op::kCross:
      return "perpendicular";
    case Op::kReflect:
      return "mirrored";
    case Op::kMatMul:
      return "transformed";
    case Op::kTranspose:
      return "transposed";
    case Op::kLt:
    case Op::kLe:
    case Op::kEq:
    case Op::kNe:
    case Op::kLogicalAnd:
    case Op::kLogicalOr:
    case Op::kLogicalXor:
    case Op::kLogicalNot:
    case Op::kAny:
    case Op::kAll:
    case Op::kIsNan:
    case Op::kIsInf:
      return "test";
    case Op::kSelect:
    case Op::kIf:
      return "choice";
    case Op::kFor:
      return "total";
    case Op::kSample:
    case Op::kSampleGrad:
    case Op::kSampleLod:
    case Op::kFetch:
      return "texel";
    case Op::kTextureSize:
      return "size";
    case Op::kIndex:
      return "item";
    case Op::kDfdx:
      return "dx";
    case Op::kDfdy:
      return "dy";
    default:
      return "";
  }
}

}  // namespace

std::string_view TypeWord(const ir::Types& types, ir::TypeId type) {
  if (ir::IsMatrix(type)) return "matrix";
  if (types.Kind(type) == ir::TypeKind::kArray) return "table";
  if (!ir::IsVector(type)) return "value";
  if (ir::IsBool(type)) return "flags";
  if (ir::IsInteger(type)) return ir::Width(type) == 1 ? "number" : "numbers";
  return ir::Width(type) == 1 ? "value" : ir::Width(type) == 2 ? "point" : "vector";
}

std::string DescriptiveName(const ir::Module& module, const ir::Function& function, ir::ValueId v) {
  const ir::Inst& inst = function[v];
  const ir::Types& types = module.types;
  if (inst.op == ir::Op::kCall) {
    const ir::Function& callee = module[ir::FunctionId(inst.aux)];
    return (callee.display_name.empty() ? callee.name : callee.display_name) + "_value";
  }
  if (inst.op == ir::Op::kDfdx || inst.op == ir::Op::kDfdy) {
    const ir::Inst& of = function[function.Operands(inst)[0]];
    if (of.op == ir::Op::kGlobal) {
      return module.globals[of.aux].name + (inst.op == ir::Op::kDfdx ? "_dx" : "_dy");
    }
  }
  if (inst.op == ir::Op::kConstruct && types.Kind(inst.type) == ir::TypeKind::kStruct) {
    std::string name = types[inst.type].name;
    for (char& c : name) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return name;
  }
  std::string_view name = OperationName(inst.op);
  return std::string(name.empty() ? TypeWord(types, inst.type) : name);
}

}  // namespace texgraph::glsl
