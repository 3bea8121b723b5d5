// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/random_values.h"

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>

namespace texgraph::fuzz {
namespace {

using ir::Op;
using ir::Scalar;
using ir::TypeId;
using ir::ValueId;

// Operations that are brought back below kBound keep at most this for one step.
constexpr double kStepBound = 1e6;

}  // namespace

TypeId RandomValues::AnyType() {
  if (options_.matrices && OneIn(12)) return OneIn(2) ? ir::kMat2 : ir::kMat3;
  constexpr Scalar kScalars[] = {Scalar::kFloat, Scalar::kFloat, Scalar::kFloat,
                                 Scalar::kInt,   Scalar::kUint,  Scalar::kBool};
  return Vector(kScalars[Below(std::size(kScalars))]);
}

TypeId RandomValues::AnyNumericType() {
  constexpr Scalar kScalars[] = {Scalar::kFloat, Scalar::kFloat, Scalar::kInt, Scalar::kUint};
  return Vector(kScalars[Below(std::size(kScalars))]);
}

TypeId RandomValues::AnyFloatType() { return Vector(Scalar::kFloat); }

ValueId RandomValues::Constant(TypeId type) {
  constexpr float kFloats[] = {0, 0, 1, 1, -1, 2, 0.5f, -0.5f, 3, 0.25f, -2.75f, 10};
  constexpr uint32_t kIntegers[] = {0, 0,  1,  1,           2,           3,           4,  5,
                                    8, 16, 31, 0xffffffffu, 0xfffffffeu, 0x80000000u, 255};
  std::vector<uint32_t> words(builder_.module().types.Words(type));
  const bool same = OneIn(2);
  for (size_t i = 0; i < words.size(); ++i) {
    if (i > 0 && same) {
      words[i] = words[0];
    } else if (ir::IsFloat(type)) {
      words[i] = std::bit_cast<uint32_t>(kFloats[Below(std::size(kFloats))]);
    } else if (ir::IsBool(type)) {
      words[i] = Below(2);
    } else {
      words[i] = kIntegers[Below(std::size(kIntegers))];
    }
  }
  return builder_.Const(type, words);
}

ValueId RandomValues::Pick(TypeId type) {
  if ((ir::IsVector(type) || ir::IsMatrix(type)) && OneIn(8)) return Constant(type);
  std::vector<const Entry*> fitting;
  for (const Entry& entry : scope_) {
    if (builder_.TypeOf(entry.value) == type) fitting.push_back(&entry);
  }
  if (fitting.empty() || OneIn(10)) return Make(type);
  // More often a recent one, so that operations build upon one another.
  size_t last = fitting.size() - 1, at = Below(static_cast<uint32_t>(fitting.size()));
  const Entry entry =
      *fitting[OneIn(2) ? at : last - Below(static_cast<uint32_t>(std::min<size_t>(last + 1, 3)))];
  return entry.bound <= kBound ? entry.value : Bounded(entry.value, kBound);
}

std::vector<ValueId> RandomValues::Newest(size_t count) {
  std::vector<ValueId> newest;
  for (auto it = scope_.rbegin(); it != scope_.rend() && newest.size() < count; ++it) {
    const TypeId type = builder_.TypeOf(it->value);
    if (!ir::IsVector(type) || ir::IsBool(type) || builder_.IsConst(it->value)) continue;
    newest.push_back(it->bound <= kBound ? it->value : Bounded(it->value, kBound));
  }
  return newest;
}

// A value of the type from values of other types; for scalars and vectors at last a constant.
ValueId RandomValues::Make(TypeId type) {
  if (ir::IsMatrix(type)) {
    std::vector<ValueId> columns;
    for (uint32_t i = 0; i < ir::MatrixSize(type); ++i)
      columns.push_back(Pick(ir::ColumnType(type)));
    return builder_.Construct(type, columns);
  }
  if (!ir::IsVector(type)) {
    std::vector<ValueId> parts;
    const ir::Types& types = builder_.module().types;
    for (uint32_t i = 0; i < types.ElementCount(type); ++i)
      parts.push_back(Pick(types.ElementType(type, i)));
    return builder_.Construct(type, parts);
  }
  for (size_t tries = 0; tries < 4 && !scope_.empty(); ++tries) {
    const Entry entry = scope_[Below(static_cast<uint32_t>(scope_.size()))];
    const TypeId from = builder_.TypeOf(entry.value);
    if (!ir::IsVector(from) || ir::ScalarOf(from) != ir::ScalarOf(type) || from == type) continue;
    ValueId value = Bounded(entry.value, kBound);
    if (ir::IsScalar(from)) return builder_.SplatTo(value, type);
    if (ir::IsScalar(type)) return builder_.Extract(value, Below(ir::Width(from)));
    std::array<uint8_t, 4> components;
    for (uint8_t& c : components) c = static_cast<uint8_t>(Below(ir::Width(from)));
    return builder_.Swizzle(value, {components.data(), ir::Width(type)});
  }
  return Constant(type);
}

ValueId RandomValues::Bounded(ValueId value, double bound) {
  const TypeId type = builder_.TypeOf(value);
  if (!options_.tame || !ir::IsFloat(type) || !ir::IsVector(type)) return value;
  if (bound >= 1 && OneIn(2)) return Op1(Op::kFract, value);
  return Op3(Op::kClamp, value, builder_.Float(static_cast<float>(-bound)),
             builder_.Float(static_cast<float>(bound)));
}

void RandomValues::Add(ValueId value, double bound) {
  const TypeId type = builder_.TypeOf(value);
  if (options_.tame && bound > kStepBound) {
    if (!ir::IsVector(type)) return;
    value = Bounded(value, kBound);
    bound = kBound;
  }
  scope_.push_back({value, bound});
}

// At least a half, in tame modules.
ValueId RandomValues::Positive(ValueId value) {
  if (!options_.tame) return value;
  return Op2(Op::kAdd, Op1(Op::kAbs, value), builder_.Float(0.5f));
}

void RandomValues::AddOperation() {
  switch (Below(12)) {
    case 0:
    case 1:
    case 2:
      return Arithmetic();
    case 3:
      return Integers();
    case 4:
    case 5:
      return Floats();
    case 6:
    case 7:
      return Logic();
    case 8:
      return Conversions();
    case 9:
      return Vectors();
    case 10:
      return Shapes();
    default:
      return options_.textures && OneIn(3) ? Textures() : Aggregates();
  }
}

void RandomValues::Arithmetic() {
  const TypeId type = AnyNumericType();
  ValueId a = Pick(type), b = OneIn(8) ? a : Pick(type);
  const double square = kBound * kBound;
  switch (Below(12)) {
    case 0:
    case 1:
      return Add(Op2(Op::kAdd, a, b), 2 * kBound);
    case 2:
      return Add(Op2(Op::kSub, a, b), 2 * kBound);
    case 3:
    case 4:
      return Add(Op2(Op::kMul, a, b), square);
    case 5:
      if (ir::IsFloat(type)) return Add(Op2(Op::kDiv, a, Positive(b)), 2 * kBound);
      // Nonzero and positive, and no least int by minus one.
      if (options_.tame)
        b = Op2(Op::kOr, Op2(Op::kAnd, b, builder_.Splat(type, 255)), builder_.Splat(type, 1));
      return Add(Op2(Op::kDiv, a, b));
    case 6:
      return Add(Op1(Op::kNeg, a));
    case 7:
      return Add(Op2(Op::kMin, a, b));
    case 8:
      return Add(Op2(Op::kMax, a, b));
    case 9: {
      ValueId c = Pick(type);
      if (options_.tame) c = Op2(Op::kMax, b, c);
      return Add(Op3(Op::kClamp, a, b, c));
    }
    case 10:
      if (ir::ScalarOf(type) != Scalar::kUint) return Add(Op1(Op::kAbs, a));
      return;
    default:
      if (ir::ScalarOf(type) != Scalar::kUint) return Add(Op1(Op::kSign, a), 1);
  }
}

void RandomValues::Integers() {
  const TypeId type = Vector(OneIn(2) ? Scalar::kInt : Scalar::kUint);
  ValueId a = Pick(type), b = OneIn(8) ? a : Pick(type);
  auto masked = [&](ValueId v, double mask) {
    return options_.tame ? Op2(Op::kAnd, v, builder_.Splat(type, mask)) : v;
  };
  switch (Below(7)) {
    case 0: {
      ValueId divisor = masked(b, 0x7fffffff);
      if (options_.tame) divisor = Op2(Op::kOr, divisor, builder_.Splat(type, 1));
      return Add(Op2(Op::kMod, masked(a, 0x7fffffff), divisor));
    }
    case 1:
      return Add(Op2(Op::kAnd, a, b));
    case 2:
      return Add(Op2(Op::kOr, a, b));
    case 3:
      return Add(Op2(Op::kXor, a, b));
    case 4:
      return Add(Op1(Op::kNot, a));
    case 5:
      return Add(Op2(Op::kShl, a, masked(b, 31)));
    default:
      return Add(Op2(Op::kShr, a, masked(b, 31)));
  }
}

void RandomValues::Floats() {
  const TypeId type = AnyFloatType();
  ValueId a = Pick(type), b = OneIn(8) ? a : Pick(type), c = Pick(type);
  switch (Below(options_.exact ? 10 : 24)) {
    case 0:
      return Add(Op1(Op::kFloor, a));
    case 1:
      return Add(Op1(Op::kCeil, a));
    case 2:
      return Add(Op1(Op::kTrunc, a));
    // Halves may go either way on a GPU.
    case 3:
      return options_.tame ? Add(Op1(Op::kFract, a), 1) : Add(Op1(Op::kRound, a));
    case 4:
      return Add(Op1(Op::kFract, a), 1);
    case 5:
      return Add(Op2(Op::kStep, a, b), 1);
    case 6:
      return Add(Op3(Op::kMix, a, b, c), 4 * kBound * kBound);
    case 7:
      return Add(Op2(Op::kFmod, a, Positive(b)), 2 * kBound);
    case 8:
      return Add(Op1(Op::kSqrt, Positive(a)));
    case 9: {
      ValueId x = OneIn(2) ? builder_.Float(OneIn(2) ? 0.0f : 1.0f) : Op1(Op::kFract, c);
      return Add(Op3(Op::kMix, a, b, x), 2 * kBound);
    }
    case 10:
      return Add(Op1(Op::kSin, a), 1);
    case 11:
      return Add(Op1(Op::kCos, a), 1);
    case 12:
      return Add(Op1(Op::kExp2, Op3(Op::kClamp, a, builder_.Float(-8), builder_.Float(8))), 256);
    case 13:
      return Add(Op1(Op::kLog2, Positive(a)));
    case 14: {
      constexpr float kPowers[] = {0, 0.5f, 1, 2, -1, 3};
      return Add(Op2(Op::kPow, Positive(a), builder_.Splat(type, kPowers[Below(6)])), 1e6);
    }
    case 15:
      return Add(Op2(Op::kAtan2, a, Positive(b)), 4);
    case 16:
      return Add(Op1(Op::kInverseSqrt, Positive(a)), 2);
    case 17:
      return Add(Op3(Op::kSmoothstep, builder_.Float(0), Positive(b), a), 1);
    case 18:
      return Add(Op3(Op::kFma, a, b, c), 2 * kBound * kBound);
    case 19:
      return Add(Op1(Op::kExp, Op3(Op::kClamp, a, builder_.Float(-8), builder_.Float(8))), 3000);
    case 20:
      return Add(Op1(Op::kLog, Positive(a)));
    case 21:
      return Add(Op1(Op::kAtan, a), 2);
    case 22:
      return Add(Op1(Op::kTanh, a), 1);
    default:
      return Add(Op1(Op::kAsin, Op3(Op::kClamp, a, builder_.Float(-1), builder_.Float(1))), 2);
  }
}

void RandomValues::Logic() {
  const uint32_t width = 1 + Below(4);
  const TypeId bools = ir::Vector(Scalar::kBool, width);
  switch (Below(6)) {
    case 0:
    case 1: {
      constexpr Op kOps[] = {Op::kLt, Op::kLe, Op::kEq, Op::kNe};
      const TypeId type = ir::WithWidth(AnyNumericType(), width);
      ValueId a = Pick(type);
      return Add(Op2(kOps[Below(4)], a, OneIn(8) ? a : Pick(type)));
    }
    case 2: {
      constexpr Op kOps[] = {Op::kLogicalAnd, Op::kLogicalOr, Op::kLogicalXor, Op::kEq, Op::kNe};
      return Add(Op2(kOps[Below(5)], Pick(bools), Pick(bools)));
    }
    case 3:
      if (width > 1 && OneIn(2)) return Add(Op1(OneIn(2) ? Op::kAny : Op::kAll, Pick(bools)));
      return Add(Op1(Op::kLogicalNot, Pick(bools)));
    default: {
      const TypeId type = OneIn(6) ? AnyType() : ir::WithWidth(AnyNumericType(), width);
      const bool by_component = ir::IsVector(type) && OneIn(3);
      ValueId condition =
          Pick(by_component ? ir::Vector(Scalar::kBool, ir::Width(type)) : ir::kBool);
      return Add(Op3(Op::kSelect, condition, Pick(type), Pick(type)));
    }
  }
}

void RandomValues::Conversions() {
  const uint32_t width = 1 + Below(4);
  constexpr Scalar kScalars[] = {Scalar::kFloat, Scalar::kInt, Scalar::kUint, Scalar::kBool};
  const Scalar from = kScalars[Below(4)], to = kScalars[Below(4)];
  if (from == to) return;
  ValueId value = Pick(ir::Vector(from, width));
  const TypeId type = ir::Vector(to, width);
  const bool both_integers = from != Scalar::kFloat && to != Scalar::kFloat &&
                             from != Scalar::kBool && to != Scalar::kBool;
  if (both_integers && OneIn(2)) return Add(builder_.Emit(Op::kBitcast, type, {value}));
  if (from == Scalar::kFloat && to == Scalar::kUint && options_.tame) value = Op1(Op::kAbs, value);
  if (to == Scalar::kFloat && from != Scalar::kBool && options_.tame) {
    value = Op2(Op::kAnd, value, builder_.Splat(builder_.TypeOf(value), 63));
  }
  Add(builder_.Convert(value, type));
}

void RandomValues::Vectors() {
  const TypeId type = ir::Vector(Scalar::kFloat, 2 + Below(3));
  ValueId a = Pick(type), b = Pick(type);
  if (options_.matrices && OneIn(3)) {
    const uint32_t size = 2 + Below(2);
    const TypeId matrix = size == 2 ? ir::kMat2 : ir::kMat3;
    if (OneIn(4)) return Add(builder_.Op1(Op::kTranspose, Pick(matrix)));
    if (options_.exact) return;
    ValueId v = Pick(ir::Vector(Scalar::kFloat, size)), m = Pick(matrix);
    return Add(OneIn(2) ? Op2(Op::kMatMul, m, v) : Op2(Op::kMatMul, v, m), 4 * kBound * kBound);
  }
  if (options_.exact) return;
  switch (Below(5)) {
    case 0:
      return Add(Op2(Op::kDot, a, b), 4 * kBound * kBound);
    case 1:
      return Add(Op1(Op::kLength, a), 2 * kBound);
    case 2:
      return Add(Op2(Op::kDistance, a, b), 4 * kBound);
    case 3:
      return Add(Op1(Op::kNormalize, Positive(a)), 1);
    default:
      return ir::Width(type) == 3 ? Add(Op2(Op::kCross, a, b), 2 * kBound * kBound)
                                  : Add(Op2(Op::kReflect, a, b), 1e6);
  }
}

void RandomValues::Shapes() {
  const TypeId type = ir::WithWidth(AnyNumericType(), 2 + Below(3));
  switch (Below(5)) {
    case 0:
      return Add(Make(type));
    case 1:
      return Add(builder_.SplatTo(Pick(ir::ScalarType(type)), type));
    case 2: {
      std::vector<ValueId> parts;
      for (uint32_t i = 0; i < ir::Width(type); ++i) parts.push_back(Pick(ir::ScalarType(type)));
      return Add(builder_.Construct(type, parts));
    }
    case 3:
      return Add(builder_.Insert(Pick(type), Below(ir::Width(type)), Pick(ir::ScalarType(type))));
    default:
      return Add(builder_.Extract(Pick(type), Below(ir::Width(type))));
  }
}

void RandomValues::Aggregates() {
  ir::Types& types = builder_.module().types;
  if (!options_.aggregates) return Shapes();
  const TypeId vector = ir::WithWidth(AnyNumericType(), 2 + Below(3));
  ValueId index = Pick(OneIn(2) ? ir::kInt : ir::kUint);
  if (OneIn(3)) {
    return Add(builder_.Emit(Op::kIndex, ir::ScalarType(vector), {Pick(vector), index}));
  }
  if (OneIn(2)) {
    TypeId array = types.Array(OneIn(2) ? ir::kFloat : ir::kVec2, 3);
    TypeId element = types.ElementType(array, 0);
    ValueId value = Pick(array);
    Add(value);
    return Add(builder_.Emit(Op::kIndex, element, {value, index}));
  }
  TypeId tile =
      types.Struct("Tile", {{"cell", ir::kIvec2}, {"local", ir::kVec2}, {"seed", ir::kUint}});
  ValueId value = Pick(tile);
  if (OneIn(3)) value = builder_.Insert(value, 1, Pick(ir::kVec2));
  if (OneIn(4)) value = Op3(Op::kSelect, Pick(ir::kBool), value, Pick(tile));
  Add(value);
  Add(builder_.Extract(value, Below(3)));
}

void RandomValues::Textures() {
  std::vector<ir::GlobalId> textures;
  for (size_t i = 0; i < builder_.module().globals.size(); ++i) {
    if (builder_.module().globals[i].kind == ir::GlobalKind::kTexture) textures.emplace_back(i);
  }
  if (textures.empty()) return;
  ValueId sampler = builder_.Global(textures[Below(static_cast<uint32_t>(textures.size()))]);
  const uint32_t width = ir::CoordinateWidth(builder_.TypeOf(sampler));
  if (OneIn(3)) {
    ValueId at = Op2(Op::kAnd, Pick(ir::Vector(Scalar::kInt, width)), builder_.Int(1));
    return Add(builder_.Emit(Op::kFetch, ir::kVec4, {sampler, at, builder_.Int(0)}), 1);
  }
  ValueId at = Pick(ir::Vector(Scalar::kFloat, width));
  ValueId level = Op1(Op::kFloor, Op1(Op::kFract, Pick(ir::kFloat)));
  Add(builder_.Emit(Op::kSampleLod, ir::kVec4, {sampler, at, level}), 1);
}

}  // namespace texgraph::fuzz
