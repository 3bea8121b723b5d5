// SPDX-License-Identifier: Apache-2.0
#include "compiler/blocks/builtins.h"

#include <algorithm>
#include <iterator>

namespace texgraph::blocks {
namespace {

using enum BuiltinFamily;
using ir::Op;

// In the order of bytes, for the binary search.
constexpr Builtin kBuiltins[] = {
    {"abs", kSigned, Op::kAbs, 1, 1},
    {"acos", kFloats, Op::kAcos, 1, 1},
    {"acosh", kFloats, Op::kAcosh, 1, 1},
    {"all", kReduce, Op::kAll, 1, 1},
    {"any", kReduce, Op::kAny, 1, 1},
    {"asin", kFloats, Op::kAsin, 1, 1},
    {"asinh", kFloats, Op::kAsinh, 1, 1},
    {"atan", kAtan, Op::kAtan, 1, 2},
    {"atanh", kFloats, Op::kAtanh, 1, 1},
    {"ceil", kFloats, Op::kCeil, 1, 1},
    {"clamp", kNumbers, Op::kClamp, 3, 3, 0b110},
    {"cos", kFloats, Op::kCos, 1, 1},
    {"cosh", kFloats, Op::kCosh, 1, 1},
    {"cross", kCross, Op::kCross, 2, 2},
    {"degrees", kScale, Op::kMul, 1, 1},
    {"determinant", kDeterminant, Op::kMul, 1, 1},
    {"distance", kToFloat, Op::kDistance, 2, 2},
    {"dot", kToFloat, Op::kDot, 2, 2},
    {"equal", kEqual, Op::kEq, 2, 2},
    {"exp", kFloats, Op::kExp, 1, 1},
    {"exp2", kFloats, Op::kExp2, 1, 1},
    {"faceforward", kFaceforward, Op::kMul, 3, 3},
    {"floatBitsToInt", kBits, Op::kBitcast, 1, 1},
    {"floatBitsToUint", kBits, Op::kBitcast, 1, 1},
    {"floor", kFloats, Op::kFloor, 1, 1},
    {"fma", kFloats, Op::kFma, 3, 3},
    {"footprint", kFootprint, Op::kDx, 1, 1},
    {"footprint_x", kFloats, Op::kDx, 1, 1},
    {"footprint_y", kFloats, Op::kDy, 1, 1},
    {"fract", kFloats, Op::kFract, 1, 1},
    {"greaterThan", kGreater, Op::kLt, 2, 2},
    {"greaterThanEqual", kGreater, Op::kLe, 2, 2},
    {"intBitsToFloat", kBits, Op::kBitcast, 1, 1},
    {"inverse", kInverse, Op::kMul, 1, 1},
    {"inversesqrt", kFloats, Op::kInverseSqrt, 1, 1},
    {"isinf", kTestFloat, Op::kIsInf, 1, 1},
    {"isnan", kTestFloat, Op::kIsNan, 1, 1},
    {"length", kToFloat, Op::kLength, 1, 1},
    {"lessThan", kLess, Op::kLt, 2, 2},
    {"lessThanEqual", kLess, Op::kLe, 2, 2},
    {"log", kFloats, Op::kLog, 1, 1},
    {"log2", kFloats, Op::kLog2, 1, 1},
    {"matrixCompMult", kMatrixCompMult, Op::kMul, 2, 2},
    {"max", kNumbers, Op::kMax, 2, 2, 0b10},
    {"min", kNumbers, Op::kMin, 2, 2, 0b10},
    {"mix", kMix, Op::kMix, 3, 3, 0b100},
    {"mod", kFloats, Op::kFmod, 2, 2, 0b10},
    {"normalize", kFloats, Op::kNormalize, 1, 1},
    {"not", kNot, Op::kLogicalNot, 1, 1},
    {"notEqual", kEqual, Op::kNe, 2, 2},
    {"outerProduct", kOuterProduct, Op::kMul, 2, 2},
    {"pow", kFloats, Op::kPow, 2, 2},
    {"radians", kScale, Op::kMul, 1, 1},
    {"reflect", kFloats, Op::kReflect, 2, 2},
    {"refract", kRefract, Op::kMul, 3, 3},
    {"round", kFloats, Op::kRound, 1, 1},
    {"sign", kSigned, Op::kSign, 1, 1},
    {"sin", kFloats, Op::kSin, 1, 1},
    {"sinh", kFloats, Op::kSinh, 1, 1},
    {"smoothstep", kFloats, Op::kSmoothstep, 3, 3, 0b011},
    {"sqrt", kFloats, Op::kSqrt, 1, 1},
    {"step", kFloats, Op::kStep, 2, 2, 0b01},
    {"tan", kFloats, Op::kTan, 1, 1},
    {"tanh", kFloats, Op::kTanh, 1, 1},
    {"texelFetch", kTexelFetch, Op::kFetch, 3, 3},
    {"texture", kTexture, Op::kSample, 2, 3},
    {"textureGrad", kTextureGrad, Op::kSampleGrad, 4, 4},
    {"textureLod", kTextureLod, Op::kSampleLod, 3, 3},
    {"textureSize", kTextureSize, Op::kTextureSize, 2, 2},
    {"transpose", kTranspose, Op::kTranspose, 1, 1},
    {"trunc", kFloats, Op::kTrunc, 1, 1},
    {"uintBitsToFloat", kBits, Op::kBitcast, 1, 1},
};

constexpr bool ByName(const Builtin& a, const Builtin& b) { return a.name < b.name; }
static_assert(std::is_sorted(std::begin(kBuiltins), std::end(kBuiltins), ByName));

}  // namespace

const Builtin* FindBuiltin(std::string_view name) {
  const Builtin* found =
      std::lower_bound(std::begin(kBuiltins), std::end(kBuiltins), name,
                       [](const Builtin& builtin, std::string_view n) { return builtin.name < n; });
  return found != std::end(kBuiltins) && found->name == name ? found : nullptr;
}

std::vector<std::string_view> BuiltinNames() {
  std::vector<std::string_view> names;
  for (const Builtin& builtin : kBuiltins) names.push_back(builtin.name);
  return names;
}

std::string_view BuiltinAdvice(std::string_view name) {
  if (name.starts_with("dFd") || name.starts_with("fwidth")) {
    return "the compiler owns derivatives; use 'footprint'";
  }
  if (name == "texture2D" || name == "texture3D") return "write 'texture'";
  if (name.starts_with("noise") && name.size() == 6) return "use a noise block of the library";
  if (name == "modf") return "use 'trunc' and 'fract'";
  if (name == "roundEven") return "use 'round', or 'floor' of the value plus 0.5";
  return "";
}

}  // namespace texgraph::blocks
