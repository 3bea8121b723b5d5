// SPDX-License-Identifier: Apache-2.0
#include "compiler/ir/verify_op.h"

#include <algorithm>

namespace texgraph::ir {
namespace {

// The number of operands where the shape leaves it open.
size_t Arity(Op op) {
  switch (op) {
    case Op::kNeg:
    case Op::kAbs:
    case Op::kSign:
    case Op::kNot:
    case Op::kLogicalNot:
    case Op::kFloor:
    case Op::kCeil:
    case Op::kTrunc:
    case Op::kRound:
    case Op::kFract:
    case Op::kSqrt:
    case Op::kInverseSqrt:
    case Op::kExp:
    case Op::kLog:
    case Op::kExp2:
    case Op::kLog2:
    case Op::kSin:
    case Op::kCos:
    case Op::kTan:
    case Op::kAsin:
    case Op::kAcos:
    case Op::kAtan:
    case Op::kSinh:
    case Op::kCosh:
    case Op::kTanh:
    case Op::kAsinh:
    case Op::kAcosh:
    case Op::kAtanh:
    case Op::kNormalize:
    case Op::kDx:
    case Op::kDy:
    case Op::kDfdx:
    case Op::kDfdy:
      return 1;
    case Op::kClamp:
    case Op::kMix:
    case Op::kSmoothstep:
    case Op::kFma:
      return 3;
    default:
      return 2;
  }
}

// Component by component on matrices as well.
bool TakesMatrices(Op op) {
  return op == Op::kAdd || op == Op::kSub || op == Op::kMul || op == Op::kDiv || op == Op::kNeg;
}

class InstChecker {
 public:
  InstChecker(const Module& module, FunctionId function, const Inst& inst)
      : module_(module), types_(module.types), function_(function), inst_(inst), type_(inst.type) {
    for (ValueId v : module[function].Operands(inst)) x_.push_back(module[function][v].type);
  }

  std::string Check() {
    if (!Fits()) return reason_.empty() ? Signature() : reason_;
    return "";
  }

 private:
  bool Fits();
  bool Leaf();
  bool SameTypes();
  bool MatrixProduct();
  bool Selection();
  bool Conversion();
  bool Making();
  bool Taking();
  bool Sampling();
  bool Calling();
  bool FieldRef(const Function& callee);

  bool Count(size_t n) const { return x_.size() == n; }
  bool All(TypeId type) const {
    return std::ranges::all_of(x_, [&](TypeId t) { return t == type; });
  }
  bool Because(std::string reason) {
    reason_ = std::move(reason);
    return false;
  }
  std::string Signature() const {
    std::string text(Info(inst_.op).name);
    if (inst_.op == Op::kExtract) text += "." + std::to_string(inst_.aux);
    for (size_t i = 0; i < x_.size(); ++i) {
      text += i == 0 ? " of " : i + 1 == x_.size() ? " and " : ", ";
      text += types_.Text(x_[i]);
    }
    return text + " giving " + types_.Text(type_);
  }

  const Module& module_;
  const Types& types_;
  FunctionId function_;
  const Inst& inst_;
  TypeId type_;
  std::vector<TypeId> x_;
  std::string reason_;
};

bool InstChecker::Fits() {
  const Op op = inst_.op;
  switch (Info(op).shape) {
    case OpShape::kLeaf:
      return Leaf();
    case OpShape::kNumeric:
    case OpShape::kInteger:
    case OpShape::kFloating:
    case OpShape::kLogic:
      return SameTypes();
    case OpShape::kDotLike:
      return Count(2) && IsVector(x_[0]) && IsFloat(x_[0]) && All(x_[0]) && type_ == kFloat;
    case OpShape::kLengthLike:
      return Count(1) && IsVector(x_[0]) && IsFloat(x_[0]) && type_ == kFloat;
    case OpShape::kMatrixProduct:
      return Count(2) && MatrixProduct();
    case OpShape::kMatrixUnary:
      return Count(1) && IsMatrix(type_) && All(type_);
    case OpShape::kComparison: {
      if (!Count(2) || !IsVector(x_[0]) || !All(x_[0])) return false;
      bool ordered = op == Op::kLt || op == Op::kLe;
      return !(ordered && IsBool(x_[0])) && type_ == Vector(Scalar::kBool, Width(x_[0]));
    }
    case OpShape::kReduceBool:
      return Count(1) && IsBool(x_[0]) && type_ == kBool;
    case OpShape::kTestFloat:
      return Count(1) && IsVector(x_[0]) && IsFloat(x_[0]) &&
             type_ == Vector(Scalar::kBool, Width(x_[0]));
    case OpShape::kSelection:
      return Count(3) && Selection();
    case OpShape::kConversion:
      return Count(1) && Conversion();
    case OpShape::kSplatting:
      return Count(1) && IsScalar(x_[0]) &&
             (IsVector(type_) ? !IsScalar(type_) && ScalarType(type_) == x_[0]
                              : IsMatrix(type_) && x_[0] == kFloat);
    case OpShape::kMaking:
      return Making();
    case OpShape::kTaking:
      return Count(1) && Taking();
    case OpShape::kIndexing: {
      if (!Count(2) || (x_[1] != kInt && x_[1] != kUint)) return false;
      bool indexable = (IsVector(x_[0]) && !IsScalar(x_[0])) || IsMatrix(x_[0]) ||
                       types_.Kind(x_[0]) == TypeKind::kArray;
      return indexable && type_ == types_.ElementType(x_[0], 0);
    }
    case OpShape::kSampling:
      return Sampling();
    case OpShape::kTextureQuery:
      return Count(2) && IsSampler(x_[0]) && x_[1] == kInt &&
             type_ == Vector(Scalar::kInt, CoordinateWidth(x_[0]));
    case OpShape::kControl:
      return op == Op::kIf ? Count(1) && x_[0] == kBool : !x_.empty();
    case OpShape::kCalling:
      return Calling();
  }
  return false;
}

bool InstChecker::Leaf() {
  if (!Count(0)) return false;
  // Parameters: with their region. Constants: with the function.
  if (inst_.op != Op::kGlobal) return true;
  return inst_.aux < module_.globals.size() && module_.globals[inst_.aux].type == type_;
}

bool InstChecker::SameTypes() {
  const Op op = inst_.op;
  if (!Count(Arity(op)) || !All(type_)) return false;
  if (IsMatrix(type_)) return TakesMatrices(op);
  if (!IsVector(type_)) return false;
  switch (Info(op).shape) {
    case OpShape::kNumeric: {
      // GLSL has neither abs nor sign of uint.
      bool is_uint = ScalarOf(type_) == Scalar::kUint;
      return !IsBool(type_) && !(is_uint && (op == Op::kAbs || op == Op::kSign));
    }
    case OpShape::kInteger:
      return IsInteger(type_);
    case OpShape::kLogic:
      return IsBool(type_);
    default:
      return IsFloat(type_) && (op != Op::kCross || type_ == kVec3);
  }
}

bool InstChecker::MatrixProduct() {
  if (IsMatrix(x_[0]) && IsMatrix(x_[1])) return x_[0] == x_[1] && type_ == x_[0];
  if (IsMatrix(x_[0])) return x_[1] == ColumnType(x_[0]) && type_ == x_[1];
  return IsMatrix(x_[1]) && x_[0] == ColumnType(x_[1]) && type_ == x_[0];
}

bool InstChecker::Selection() {
  if (!IsPlainType(types_, type_) || x_[1] != type_ || x_[2] != type_) return false;
  if (x_[0] == kBool) return true;
  return IsVector(type_) && x_[0] == Vector(Scalar::kBool, Width(type_));
}

bool InstChecker::Conversion() {
  if (!IsVector(x_[0]) || !IsVector(type_) || Width(x_[0]) != Width(type_)) return false;
  if (inst_.op == Op::kConvert) return true;
  return !IsBool(x_[0]) && !IsBool(type_);
}

bool InstChecker::Making() {
  uint32_t count = types_.ElementCount(type_);
  // A tuple is what an if or a loop was folded into; nothing but its elements is used then.
  bool made =
      types_.Kind(type_) == TypeKind::kTuple || (IsPlainType(types_, type_) && !IsScalar(type_));
  if (!made || count == 0 || !Count(count)) return false;
  for (uint32_t i = 0; i < count; ++i) {
    if (x_[i] != types_.ElementType(type_, i)) return false;
  }
  return true;
}

bool InstChecker::Taking() {
  if (inst_.op == Op::kExtract) {
    return !IsScalar(x_[0]) && inst_.aux < types_.ElementCount(x_[0]) &&
           type_ == types_.ElementType(x_[0], inst_.aux);
  }
  if (!IsVector(x_[0]) || !IsVector(type_) || IsScalar(type_)) return false;
  for (uint32_t i = 0; i < Width(type_); ++i) {
    uint32_t component = (inst_.aux >> (2 * i)) & 3;
    if (component >= Width(x_[0])) return Because("swizzle beyond " + types_.Text(x_[0]));
  }
  return inst_.aux >> (2 * Width(type_)) == 0 && ScalarOf(type_) == ScalarOf(x_[0]);
}

bool InstChecker::Sampling() {
  if (x_.size() < 2 || !IsSampler(x_[0]) || type_ != kVec4) return false;
  const uint32_t width = CoordinateWidth(x_[0]);
  if (inst_.op == Op::kFetch) {
    return Count(3) && x_[1] == Vector(Scalar::kInt, width) && x_[2] == kInt;
  }
  if (x_[1] != Vector(Scalar::kFloat, width)) return false;
  // A layer has no gradient.
  const TypeId gradient = x_[0] == kSampler3D ? kVec3 : kVec2;
  switch (inst_.op) {
    case Op::kSample:
      return Count(2) || (Count(3) && x_[2] == kFloat);
    case Op::kSampleLod:
      return Count(3) && x_[2] == kFloat;
    default:
      return Count(4) && x_[2] == gradient && x_[3] == gradient;
  }
}

bool InstChecker::Calling() {
  if (inst_.op == Op::kCallField) {
    if (x_.empty() || types_.Kind(x_[0]) != TypeKind::kField) return false;
    const std::vector<TypeId>& field = types_[x_[0]].elements;
    return type_ == field[0] &&
           std::equal(x_.begin() + 1, x_.end(), field.begin() + 1, field.end());
  }
  if (inst_.aux >= function_.index) return Because("calls a function that does not come before it");
  const Function& callee = module_.functions[inst_.aux];
  if (inst_.op == Op::kFieldRef) return FieldRef(callee);
  const std::string call = "call of " + callee.name + ": ";
  if (callee.results.empty()) return Because(call + "it has no result");
  if (!Count(callee.parameters.size())) {
    return Because(call + std::to_string(x_.size()) + " arguments for " +
                   std::to_string(callee.parameters.size()) + " parameters");
  }
  for (size_t i = 0; i < x_.size(); ++i) {
    if (x_[i] != callee.parameters[i].type) {
      return Because(call + types_.Text(x_[i]) + " for parameter " + std::to_string(i) +
                     " of type " + types_.Text(callee.parameters[i].type));
    }
  }
  if (callee.results.size() == 1) return type_ == callee.results[0].type;
  if (types_.Kind(type_) != TypeKind::kTuple) return false;
  return std::ranges::equal(types_[type_].elements, callee.results, {}, {}, &Result::type);
}

// The captured values are the callee's last parameters, what is left are the field's.
bool InstChecker::FieldRef(const Function& callee) {
  if (types_.Kind(type_) != TypeKind::kField) return false;
  const std::string reference = "field of " + callee.name + ": ";
  if (callee.results.size() != 1) return Because(reference + "it must have one result");
  const std::vector<TypeId>& field = types_[type_].elements;
  const size_t open = field.size() - 1;
  if (open + x_.size() != callee.parameters.size()) {
    return Because(reference + std::to_string(open) + " parameters and " +
                   std::to_string(x_.size()) + " captured values for " +
                   std::to_string(callee.parameters.size()) + " parameters");
  }
  for (size_t i = 0; i < callee.parameters.size(); ++i) {
    TypeId type = i < open ? field[i + 1] : x_[i - open];
    if (type != callee.parameters[i].type) {
      return Because(reference + types_.Text(type) + " for parameter " + std::to_string(i) +
                     " of type " + types_.Text(callee.parameters[i].type));
    }
  }
  return field[0] == callee.results[0].type || Because(reference + "its result is another type");
}

}  // namespace

bool IsPlainType(const Types& types, TypeId type) {
  switch (types.Kind(type)) {
    case TypeKind::kVector:
    case TypeKind::kMatrix:
      return true;
    case TypeKind::kArray:
      return types[type].length > 0 && IsPlainType(types, types[type].elements[0]);
    case TypeKind::kStruct:
      return std::ranges::all_of(types[type].fields, [&](const StructField& field) {
        return IsPlainType(types, field.type);
      });
    default:
      return false;
  }
}

std::string CheckInst(const Module& module, FunctionId function, const Inst& inst) {
  return InstChecker(module, function, inst).Check();
}

}  // namespace texgraph::ir
