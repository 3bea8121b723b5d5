// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cmath>

#include "compiler/blocks/check_body.h"

namespace texgraph::blocks {

using ir::Op;
using ir::Scalar;
using ir::TypeId;

TypedId BodyChecker::CheckBuiltin(const Expr& expr, const Builtin& builtin) {
  std::vector<TypedId> args;
  if (!CheckArguments(expr, args)) return {};
  if (args.size() < builtin.least || args.size() > builtin.most) {
    std::string wanted = std::to_string(builtin.least);
    if (builtin.most > builtin.least) wanted += " or " + std::to_string(builtin.most);
    Error(DiagnosticKind::kBlockType, expr.range,
          "'" + std::string(builtin.name) + "' takes " + wanted +
              (wanted == "1" ? " argument, got " : " arguments, got ") +
              std::to_string(args.size()));
    return {};
  }
  if (IsSineHash(expr)) {
    Error(DiagnosticKind::kBlockSubset, expr.range,
          "the fraction of a large sine differs between machines; use a hash block of the library");
    return {};
  }
  return CheckFamily(expr, builtin, args);
}

TypedId BodyChecker::WrongArguments(const Expr& expr, std::span<const TypedId> args,
                                    std::string_view wanted) {
  std::string types;
  for (TypedId arg : args) types += (types.empty() ? "" : ", ") + Text(TypeOf(arg));
  Error(DiagnosticKind::kBlockType, expr.range,
        "'" + std::string(expr.name) + "' does not take (" + types + ")" + std::string(wanted));
  return {};
}

// Gives all arguments one type between `least` and `most` in the order int, uint, float. Those of
// `scalars` may all be scalars beside vectors, and are made vectors then.
bool BodyChecker::UnifyAll(const Expr& expr, std::vector<TypedId>& args, Scalar least, Scalar most,
                           uint8_t scalars) {
  Scalar scalar = least;
  uint32_t width = 0, narrow = 0;
  bool fits = true;
  for (size_t i = 0; i < args.size(); ++i) {
    TypeId type = TypeOf(args[i]);
    if (!ir::IsVector(type) || ir::IsBool(type)) {
      WrongArguments(expr, args, "");
      return false;
    }
    scalar = std::max(scalar, ir::ScalarOf(type));
    if (!(scalars >> i & 1)) {
      fits = fits && (width == 0 || width == ir::Width(type));
      width = ir::Width(type);
    }
  }
  for (size_t i = 0; i < args.size(); ++i) {
    if (!(scalars >> i & 1)) continue;
    uint32_t w = ir::Width(TypeOf(args[i]));
    fits = fits && (w == width || w == 1) && (narrow == 0 || narrow == w);
    narrow = w;
  }
  if (!fits || scalar > most) {
    WrongArguments(expr, args, fits ? "" : "; they must be of one size");
    return false;
  }
  for (TypedId& arg : args) {
    arg = SplatTo(ConvertTo(arg, ir::Vector(scalar, ir::Width(TypeOf(arg)))),
                  ir::Vector(scalar, width));
  }
  return true;
}

bool BodyChecker::CheckFloats(const Expr& expr, std::vector<TypedId>& args, uint8_t scalars) {
  return UnifyAll(expr, args, Scalar::kFloat, Scalar::kFloat, scalars);
}

TypedId BodyChecker::CheckFamily(const Expr& expr, const Builtin& builtin,
                                 std::vector<TypedId>& args) {
  using enum BuiltinFamily;
  auto operation = [&](Op op, TypeId type) {
    TypedExpr result;
    result.kind = TypedKind::kOp;
    result.op = op;
    result.type = type;
    return Add(result, args, expr.range);
  };
  switch (builtin.family) {
    case kFloats:
      if (!CheckFloats(expr, args, builtin.scalars)) return {};
      return operation(builtin.op, TypeOf(args[0]));
    case kNumbers:
      if (!UnifyAll(expr, args, Scalar::kInt, Scalar::kFloat, builtin.scalars)) return {};
      return operation(builtin.op, TypeOf(args[0]));
    case kSigned: {
      bool is_int = ir::IsInteger(TypeOf(args[0])) && ir::ScalarOf(TypeOf(args[0])) == Scalar::kInt;
      if (!is_int && !CheckFloats(expr, args)) return {};
      return operation(builtin.op, TypeOf(args[0]));
    }
    case kToFloat:
      if (!CheckFloats(expr, args)) return {};
      return operation(builtin.op, ir::kFloat);
    case kCross:
      if (!CheckFloats(expr, args)) return {};
      if (TypeOf(args[0]) != ir::kVec3) return WrongArguments(expr, args, "; it takes vec3");
      return operation(builtin.op, ir::kVec3);
    case kMix:
      return CheckMix(expr, args);
    case kAtan:
      if (!CheckFloats(expr, args)) return {};
      return operation(args.size() == 2 ? Op::kAtan2 : Op::kAtan, TypeOf(args[0]));
    case kScale: {
      if (!CheckFloats(expr, args)) return {};
      float factor = builtin.name == "radians" ? 0.017453292519943295f : 57.29577951308232f;
      TypedId constant = AddScalar(ir::kFloat, std::bit_cast<uint32_t>(factor), expr.range);
      args.push_back(SplatTo(constant, TypeOf(args[0])));
      return operation(Op::kMul, TypeOf(args[0]));
    }
    case kTestFloat:
      if (!CheckFloats(expr, args)) return {};
      return operation(builtin.op, ir::Vector(Scalar::kBool, ir::Width(TypeOf(args[0]))));
    case kLess:
    case kGreater:
    case kEqual:
      return CheckComparisonFunction(expr, builtin, args);
    case kReduce:
    case kNot:
      if (!ir::IsBool(TypeOf(args[0])) || ir::IsScalar(TypeOf(args[0]))) {
        return WrongArguments(expr, args, "; it takes a vector of bool");
      }
      return operation(builtin.op, builtin.family == kNot ? TypeOf(args[0]) : ir::kBool);
    case kBits:
      return CheckBits(expr, args[0]);
    case kTexture:
    case kTextureLod:
    case kTextureGrad:
    case kTexelFetch:
    case kTextureSize:
      return CheckSampling(expr, builtin, args);
    case kRefract: {
      std::vector<TypedId> vectors(args.begin(), args.begin() + 2);
      if (!CheckFloats(expr, vectors)) return {};
      TypedId eta = Coerce(args[2], ir::kFloat, "the ratio of refraction");
      return AddComposite(Composite::kRefract, TypeOf(vectors[0]), {{vectors[0], vectors[1], eta}},
                          expr.range);
    }
    case kFaceforward:
      if (!CheckFloats(expr, args)) return {};
      return AddComposite(Composite::kFaceforward, TypeOf(args[0]), args, expr.range);
    case kFootprint:
      if (!CheckFloats(expr, args)) return {};
      return AddComposite(Composite::kFootprint, TypeOf(args[0]), args, expr.range);
    case kMatrixCompMult:
    case kOuterProduct:
    case kTranspose:
    case kDeterminant:
    case kInverse:
      return CheckMatrixFunction(expr, builtin, args);
  }
  return {};
}

// mix with a float weight interpolates, with a bool it chooses.
TypedId BodyChecker::CheckMix(const Expr& expr, std::vector<TypedId>& args) {
  TypeId weight = TypeOf(args[2]);
  if (!ir::IsBool(weight)) {
    if (!CheckFloats(expr, args, 0b100)) return {};
    return AddOp(Op::kMix, TypeOf(args[0]), {args[0], args[1], args[2]}, expr.range);
  }
  TypedId a = args[0], b = args[1];
  Unify(a, b);
  bool fits = TypeOf(a) == TypeOf(b) && ir::IsVector(TypeOf(a)) &&
              ir::Width(TypeOf(a)) == ir::Width(weight);
  if (!fits) return WrongArguments(expr, args, "");
  return AddOp(Op::kSelect, TypeOf(a), {args[2], b, a}, expr.range);
}

TypedId BodyChecker::CheckComparisonFunction(const Expr& expr, const Builtin& builtin,
                                             std::vector<TypedId>& args) {
  bool bools = builtin.family == BuiltinFamily::kEqual && ir::IsBool(TypeOf(args[0])) &&
               TypeOf(args[0]) == TypeOf(args[1]);
  if (!bools && !UnifyAll(expr, args, Scalar::kInt, Scalar::kFloat, 0)) return {};
  uint32_t width = ir::Width(TypeOf(args[0]));
  if (width == 1) return WrongArguments(expr, args, "; compare scalars with an operator");
  if (builtin.family == BuiltinFamily::kGreater) std::swap(args[0], args[1]);
  return AddOp(builtin.op, ir::Vector(Scalar::kBool, width), {args[0], args[1]}, expr.range);
}

// floatBitsToInt and its kind: the name says from what to what.
TypedId BodyChecker::CheckBits(const Expr& expr, TypedId arg) {
  Scalar from = expr.name.starts_with("float") ? Scalar::kFloat
                : expr.name.starts_with("int") ? Scalar::kInt
                                               : Scalar::kUint;
  Scalar to = expr.name.ends_with("Float")  ? Scalar::kFloat
              : expr.name.ends_with("Uint") ? Scalar::kUint
                                            : Scalar::kInt;
  TypeId type = TypeOf(arg);
  if (!ir::IsVector(type)) return WrongArguments(expr, {{arg}}, "");
  arg = Coerce(arg, ir::Vector(from, ir::Width(type)), "the argument");
  return AddOp(Op::kBitcast, ir::Vector(to, ir::Width(type)), {arg}, expr.range);
}

TypedId BodyChecker::CheckSampling(const Expr& expr, const Builtin& builtin,
                                   std::vector<TypedId>& args) {
  using enum BuiltinFamily;
  TypeId sampler = TypeOf(args[0]);
  if (!ir::IsSampler(sampler)) return WrongArguments(expr, args, "; the first must be a sampler");
  uint32_t size = ir::CoordinateWidth(sampler);
  // A layer has no gradient.
  TypeId gradient = ir::Vector(Scalar::kFloat, sampler == ir::kSampler3D ? 3 : 2);
  bool fetch = builtin.family == kTexelFetch;
  TypedExpr result;
  result.kind = TypedKind::kOp;
  result.op = builtin.op;
  result.type = ir::kVec4;
  if (builtin.family == kTextureSize) {
    result.type = ir::Vector(Scalar::kInt, size);
    args[1] = Coerce(args[1], ir::kInt, "the level");
    return Add(result, args, expr.range);
  }
  args[1] =
      Coerce(args[1], ir::Vector(fetch ? Scalar::kInt : Scalar::kFloat, size), "the coordinate");
  if (builtin.family == kTextureGrad) {
    args[2] = Coerce(args[2], gradient, "the gradient");
    args[3] = Coerce(args[3], gradient, "the gradient");
  } else if (args.size() > 2) {
    args[2] = Coerce(args[2], fetch ? ir::kInt : ir::kFloat,
                     builtin.family == kTexture ? "the bias" : "the level");
  }
  return Add(result, args, expr.range);
}

TypedId BodyChecker::CheckMatrixFunction(const Expr& expr, const Builtin& builtin,
                                         std::vector<TypedId>& args) {
  using enum BuiltinFamily;
  TypeId type = TypeOf(args[0]);
  if (builtin.family == kOuterProduct) {
    if (!CheckFloats(expr, args)) return {};
    type = TypeOf(args[0]);
    if (ir::IsScalar(type)) return WrongArguments(expr, args, "; it takes vectors of one size");
    TypeId matrix(ir::kMat2.index + ir::Width(type) - 2);
    return AddComposite(Composite::kOuterProduct, matrix, args, expr.range);
  }
  if (!ir::IsMatrix(type)) return WrongArguments(expr, args, "; it takes a matrix");
  switch (builtin.family) {
    case kTranspose:
      return AddOp(Op::kTranspose, type, {args[0]}, expr.range);
    case kMatrixCompMult:
      if (TypeOf(args[1]) != type) return WrongArguments(expr, args, "");
      return AddComposite(Composite::kByColumn, type, args, expr.range, Op::kMul);
    default:
      break;
  }
  bool inverse = builtin.family == kInverse;
  if (type == ir::kMat4) return WrongArguments(expr, args, "; blocks have it for mat2 and mat3");
  return AddComposite(inverse ? Composite::kInverse : Composite::kDeterminant,
                      inverse ? type : ir::kFloat, args, expr.range);
}

// fract(sin(...) * 43758.5): a sine of a machine's own accuracy, made large.
bool BodyChecker::IsSineHash(const Expr& expr) const {
  if (expr.name != "fract") return false;
  bool has_sine = false, is_large = false;
  std::vector<const Expr*> open(expr.args.begin(), expr.args.end());
  while (!open.empty()) {
    const Expr& part = *open.back();
    open.pop_back();
    if (part.kind == ExprKind::kCall) {
      has_sine = has_sine || part.name == "sin" || part.name == "cos" || part.name == "tan";
    } else if (part.kind == ExprKind::kLiteral) {
      float value = part.op == TokenKind::kFloat ? std::bit_cast<float>(part.bits)
                                                 : static_cast<float>(part.bits);
      is_large = is_large || std::fabs(value) >= 100.0f;
    } else if (part.kind != ExprKind::kName) {
      open.insert(open.end(), part.args.begin(), part.args.end());
    }
  }
  return has_sine && is_large;
}

}  // namespace texgraph::blocks
