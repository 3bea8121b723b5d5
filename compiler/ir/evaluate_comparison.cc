// SPDX-License-Identifier: Apache-2.0
// Comparisons, logic and conversions. Comparisons with NaN are false, but for ne.
#include <cmath>
#include <limits>

#include "compiler/ir/evaluate_families.h"

namespace texgraph::ir::families {
namespace {

template <class T>
bool Compare(Op op, Operands x, uint32_t n, uint32_t* r) {
  switch (op) {
    case Op::kLt:
      Map<T>(x[0], x[1], n, r, [](T a, T b) { return a < b; });
      return true;
    case Op::kLe:
      Map<T>(x[0], x[1], n, r, [](T a, T b) { return a <= b; });
      return true;
    case Op::kEq:
      Map<T>(x[0], x[1], n, r, [](T a, T b) { return a == b; });
      return true;
    case Op::kNe:
      Map<T>(x[0], x[1], n, r, [](T a, T b) { return a != b; });
      return true;
    default:
      return false;
  }
}

void Reduce(bool all, uint32_t width, uint32_t lanes, const uint32_t* x, uint32_t* r) {
  for (uint32_t lane = 0; lane < lanes; ++lane) {
    uint32_t value = x[lane];
    for (uint32_t i = 1; i < width; ++i) {
      uint32_t word = x[i * lanes + lane];
      value = all ? value & word : value | word;
    }
    r[lane] = value;
  }
}

// Truncates; beyond the range the nearest value that there is, NaN gives 0.
template <class T>
T Truncate(float x) {
  constexpr float kLow = static_cast<float>(std::numeric_limits<T>::min());
  // The first float above the range: a power of two.
  constexpr float kEnd = 2.0f * static_cast<float>(1u << (std::numeric_limits<T>::digits - 1));
  if (!(x == x)) return 0;
  if (x < kLow) return std::numeric_limits<T>::min();
  if (x >= kEnd) return std::numeric_limits<T>::max();
  return static_cast<T>(x);
}

}  // namespace

bool Comparison(Op op, TypeId operand, uint32_t lanes, Operands x, uint32_t* r) {
  using U = uint32_t;
  uint32_t n = Width(operand) * lanes;
  switch (op) {
    case Op::kLogicalAnd:
      Map<U>(x[0], x[1], n, r, [](U a, U b) { return a & b; });
      return true;
    case Op::kLogicalOr:
      Map<U>(x[0], x[1], n, r, [](U a, U b) { return a | b; });
      return true;
    case Op::kLogicalXor:
      Map<U>(x[0], x[1], n, r, [](U a, U b) { return a ^ b; });
      return true;
    case Op::kLogicalNot:
      Map<U>(x[0], n, r, [](U a) { return a ^ 1u; });
      return true;
    case Op::kAny:
      Reduce(false, Width(operand), lanes, x[0], r);
      return true;
    case Op::kAll:
      Reduce(true, Width(operand), lanes, x[0], r);
      return true;
    case Op::kIsNan:
      Map<float>(x[0], n, r, [](float a) { return a != a; });
      return true;
    case Op::kIsInf:
      Map<float>(x[0], n, r,
                 [](float a) { return std::fabs(a) == std::numeric_limits<float>::infinity(); });
      return true;
    default:
      break;
  }
  switch (ScalarOf(operand)) {
    case Scalar::kFloat:
      return Compare<float>(op, x, n, r);
    case Scalar::kInt:
      return Compare<int32_t>(op, x, n, r);
    default:
      return Compare<uint32_t>(op, x, n, r);
  }
}

void Conversion(Op op, Scalar from, Scalar to, const uint32_t* x, uint32_t n, uint32_t* r) {
  if (op == Op::kConvert && to != from) {
    if (to == Scalar::kBool && from == Scalar::kFloat) {
      return Map<float>(x, n, r, [](float a) { return a != 0.0f; });
    }
    if (to == Scalar::kBool) return Map<uint32_t>(x, n, r, [](uint32_t a) { return a != 0; });
    if (to == Scalar::kFloat && from == Scalar::kInt) {
      return Map<int32_t>(x, n, r, [](int32_t a) { return static_cast<float>(a); });
    }
    if (to == Scalar::kFloat) {
      return Map<uint32_t>(x, n, r, [](uint32_t a) { return static_cast<float>(a); });
    }
    if (from == Scalar::kFloat && to == Scalar::kInt) {
      return Map<float>(x, n, r, Truncate<int32_t>);
    }
    if (from == Scalar::kFloat) return Map<float>(x, n, r, Truncate<uint32_t>);
  }
  // The same bits: bitcast, int to uint and back, bool to either.
  for (uint32_t i = 0; i < n; ++i) r[i] = x[i];
}

}  // namespace texgraph::ir::families
