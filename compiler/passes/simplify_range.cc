// SPDX-License-Identifier: Apache-2.0
#include "compiler/passes/simplify_range.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

namespace texgraph::passes {
namespace {

using ir::Builder;
using ir::Op;
using ir::Scalar;
using ir::TypeId;
using ir::ValueId;

constexpr int kDepth = 4;
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr Range kNotNegative{0, kInfinity};
constexpr Range kUnit{0, 1};

Range Everything(TypeId type) {
  switch (ir::ScalarOf(type)) {
    case Scalar::kBool:
      return kUnit;
    case Scalar::kInt:
      return {-0x1p31, 0x1p31 - 1};
    case Scalar::kUint:
      return {0, 0x1p32 - 1};
    case Scalar::kFloat:
      break;
  }
  return {-kInfinity, kInfinity};
}

Range Union(Range a, Range b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }

Range RangeOfConst(TypeId type, std::span<const uint32_t> words) {
  Range range{kInfinity, -kInfinity};
  for (uint32_t word : words) {
    double component = ir::NumberOf(type, word);
    if (component != component) return Everything(type);
    range = Union(range, {component, component});
  }
  return range;
}

// Rounding is monotonic, so the rounded bounds bound what is rounded.
Range Rounded(double low, double high) {
  return {static_cast<float>(low), static_cast<float>(high)};
}

// `range` if it fits the integer type, else whatever wrapping may give.
Range Wrapped(TypeId type, Range range) {
  Range all = Everything(type);
  return range.low < all.low || range.high > all.high ? all : range;
}

Range Finish(TypeId type, double low, double high) {
  if (low != low || high != high) return Everything(type);
  return ir::IsFloat(type) ? Rounded(low, high) : Wrapped(type, {low, high});
}

Range Product(TypeId type, Range a, Range b) {
  const double corners[] = {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
  for (double corner : corners) {
    if (corner == corner) continue;
    // Zero times infinity.
    return a.low >= 0 && b.low >= 0 ? kNotNegative : Everything(type);
  }
  auto [low, high] = std::minmax_element(std::begin(corners), std::end(corners));
  return Finish(type, *low, *high);
}

class Analysis {
 public:
  explicit Analysis(const Builder& builder) : builder_(builder) {}

  Range Of(ValueId value, int depth) const {
    const ir::Inst& inst = builder_[value];
    if (inst.op == Op::kConst) return RangeOfConst(inst.type, builder_.ConstWords(value));
    if (depth == 0 || inst.operand_count == 0) return Everything(inst.type);
    std::span<const ValueId> x = builder_.function().Operands(inst);
    if (ir::IsFloat(inst.type)) {
      switch (inst.op) {
        case Op::kFract:
        case Op::kStep:
        case Op::kSmoothstep:
          return kUnit;
        case Op::kSqrt:
        case Op::kInverseSqrt:
        case Op::kExp:
        case Op::kExp2:
        case Op::kPow:
        case Op::kLength:
        case Op::kDistance:
        case Op::kAcos:
        case Op::kCosh:
          return kNotNegative;
        case Op::kDot:
          return x[0] == x[1] ? kNotNegative : Everything(inst.type);
        default:
          break;
      }
    }
    return Moved(inst, x, depth - 1);
  }

 private:
  // Operations that only choose or move components.
  Range Moved(const ir::Inst& inst, std::span<const ValueId> x, int depth) const {
    switch (inst.op) {
      case Op::kSelect:
        return Union(Of(x[1], depth), Of(x[2], depth));
      case Op::kSplat:
        return Of(x[0], depth);
      case Op::kIndex:
        if (IsConstantArray(x[0])) return RangeOfConst(inst.type, builder_.ConstWords(x[0]));
        [[fallthrough]];
      case Op::kExtract:
      case Op::kSwizzle:
        return ir::IsVector(builder_.TypeOf(x[0])) ? Of(x[0], depth) : Everything(inst.type);
      case Op::kConstruct: {
        Range range = Of(x[0], depth);
        for (ValueId part : x.subspan(1)) range = Union(range, Of(part, depth));
        return range;
      }
      case Op::kConvert:
        return Converted(inst.type, x[0], depth);
      case Op::kMin:
      case Op::kMax:
      case Op::kClamp:
      case Op::kNeg:
      case Op::kAbs:
      case Op::kSign:
      case Op::kFloor:
      case Op::kCeil:
      case Op::kTrunc:
      case Op::kRound:
        return Monotonic(inst, x, depth);
      default:
        return Computed(inst, x, depth);
    }
  }

  // Of scalars or vectors.
  bool IsConstantArray(ValueId value) const {
    const ir::Types& types = builder_.module().types;
    const TypeId type = builder_.TypeOf(value);
    return builder_[value].op == Op::kConst && types.Kind(type) == ir::TypeKind::kArray &&
           ir::IsVector(types.ElementType(type, 0));
  }

  Range Monotonic(const ir::Inst& inst, std::span<const ValueId> x, int depth) const {
    Range a = Of(x[0], depth);
    auto both = [&](auto f) { return Range{f(a.low), f(a.high)}; };
    auto min = [](Range p, Range q) {
      return Range{std::min(p.low, q.low), std::min(p.high, q.high)};
    };
    auto max = [](Range p, Range q) {
      return Range{std::max(p.low, q.low), std::max(p.high, q.high)};
    };
    switch (inst.op) {
      case Op::kMin:
        return min(a, Of(x[1], depth));
      case Op::kMax:
        return max(a, Of(x[1], depth));
      case Op::kClamp:
        return min(max(a, Of(x[1], depth)), Of(x[2], depth));
      case Op::kNeg:
        return Finish(inst.type, -a.high, -a.low);
      case Op::kAbs:
        if (a.low >= 0) return a;
        return Finish(inst.type, a.high <= 0 ? -a.high : 0, std::max(-a.low, a.high));
      case Op::kSign:
        return both([](double v) { return double(v > 0) - double(v < 0); });
      case Op::kFloor:
        return both([](double v) { return std::floor(v); });
      case Op::kCeil:
        return both([](double v) { return std::ceil(v); });
      case Op::kTrunc:
        return both([](double v) { return std::trunc(v); });
      // Halves may go either way.
      default:
        return {std::floor(a.low), std::ceil(a.high)};
    }
  }

  Range Computed(const ir::Inst& inst, std::span<const ValueId> x, int depth) const {
    const TypeId type = inst.type;
    const bool is_float = ir::IsFloat(type);
    switch (inst.op) {
      case Op::kAdd:
      case Op::kSub: {
        Range a = Of(x[0], depth), b = Of(x[1], depth);
        if (inst.op == Op::kSub) b = {-b.high, -b.low};
        return Finish(type, a.low + b.low, a.high + b.high);
      }
      case Op::kMul: {
        if (is_float && x[0] == x[1]) return kNotNegative;
        return Product(type, Of(x[0], depth), Of(x[1], depth));
      }
      case Op::kMix: {
        Range t = Of(x[2], depth);
        bool blends =
            t.low >= 0 && t.high <= 1 && Of(x[0], depth).low >= 0 && Of(x[1], depth).low >= 0;
        return blends ? kNotNegative : Everything(type);
      }
      case Op::kDiv: {
        Range a = Of(x[0], depth), b = Of(x[1], depth);
        if (a.low < 0 || b.low < 0) return Everything(type);
        if (is_float) return kNotNegative;
        // By zero it is 0.
        return {b.high > 0 ? std::floor(a.low / b.high) * double(b.low > 0) : 0,
                std::floor(a.high / std::max(b.low, 1.0))};
      }
      case Op::kMod: {
        Range a = Of(x[0], depth), b = Of(x[1], depth);
        // Never more than the dividend; by zero it is 0.
        return a.low < 0 || b.low < 0 ? Everything(type)
                                      : Range{0, std::min(a.high, std::max(b.high - 1, 0.0))};
      }
      case Op::kAnd: {
        Range a = Of(x[0], depth), b = Of(x[1], depth);
        if (a.low < 0 && b.low < 0) return Everything(type);
        return {0, a.low < 0 ? b.high : b.low < 0 ? a.high : std::min(a.high, b.high)};
      }
      case Op::kShr: {
        Range a = Of(x[0], depth), b = Of(x[1], depth);
        if (a.low < 0 || b.low != b.high || b.low < 0 || b.low > 31) return Everything(type);
        return {std::floor(std::ldexp(a.low, -int(b.low))),
                std::floor(std::ldexp(a.high, -int(b.low)))};
      }
      default:
        return Everything(type);
    }
  }

  Range Converted(TypeId type, ValueId from, int depth) const {
    Range range = Of(from, depth);
    if (ir::IsFloat(type)) return Rounded(range.low, range.high);
    if (ir::IsBool(type)) return kUnit;
    return Wrapped(type, {std::trunc(range.low), std::trunc(range.high)});
  }

  const Builder& builder_;
};

bool IsIntegral(const Builder& builder, ValueId value, int depth) {
  const ir::Inst& inst = builder[value];
  if (inst.op == Op::kConst) {
    for (uint32_t word : builder.ConstWords(value)) {
      float component = std::bit_cast<float>(word);
      if (!(component == std::floor(component))) return false;
    }
    return true;
  }
  if (depth == 0) return false;
  std::span<const ValueId> x = builder.function().Operands(inst);
  switch (inst.op) {
    case Op::kFloor:
    case Op::kCeil:
    case Op::kTrunc:
    case Op::kRound:
    case Op::kSign:
    case Op::kStep:
      return true;
    case Op::kConvert:
      return true;  // to a float, so from something else
    // A sum or a product that is no whole number would have to lie where floats are finer than 1,
    // and there it is exact.
    case Op::kAdd:
    case Op::kSub:
    case Op::kMul:
    case Op::kNeg:
    case Op::kAbs:
    case Op::kMin:
    case Op::kMax:
    case Op::kClamp:
    case Op::kSplat:
    case Op::kConstruct:
      return std::ranges::all_of(x, [&](ValueId v) { return IsIntegral(builder, v, depth - 1); });
    case Op::kSelect:
      return IsIntegral(builder, x[1], depth - 1) && IsIntegral(builder, x[2], depth - 1);
    case Op::kExtract:
    case Op::kSwizzle:
      return ir::IsVector(builder.TypeOf(x[0])) && IsIntegral(builder, x[0], depth - 1);
    default:
      return false;
  }
}

}  // namespace

Range RangeOf(const Builder& builder, ValueId value) { return Analysis(builder).Of(value, kDepth); }

bool IsIntegral(const Builder& builder, ValueId value) {
  return IsIntegral(builder, value, kDepth);
}

}  // namespace texgraph::passes
