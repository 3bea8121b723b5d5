// SPDX-License-Identifier: Apache-2.0
// Integer operations, modulo 2^32. Signed ones are computed on unsigned words, where wrapping is
// defined.
#include <limits>

#include "compiler/ir/evaluate_families.h"

namespace texgraph::ir::families {
namespace {

// What ops.def says of the cases that GLSL leaves undefined.
template <class T>
bool Divides(T a, T b) {
  if (b == 0) return false;
  if constexpr (std::numeric_limits<T>::is_signed) {
    return !(a == std::numeric_limits<T>::min() && b == -1);
  }
  return true;
}
template <class T>
T Divide(T a, T b) {
  return Divides(a, b) ? a / b : 0;
}
template <class T>
T Remainder(T a, T b) {
  return Divides(a, b) ? a % b : 0;
}
template <class T>
T Min(T a, T b) {
  return b < a ? b : a;
}
template <class T>
T Max(T a, T b) {
  return a < b ? b : a;
}

// The operations for which signed and unsigned integers differ.
template <class T>
bool Ordered(Op op, Operands x, uint32_t n, uint32_t* r) {
  switch (op) {
    case Op::kDiv:
      Map<T>(x[0], x[1], n, r, Divide<T>);
      return true;
    case Op::kMod:
      Map<T>(x[0], x[1], n, r, Remainder<T>);
      return true;
    case Op::kMin:
      Map<T>(x[0], x[1], n, r, Min<T>);
      return true;
    case Op::kMax:
      Map<T>(x[0], x[1], n, r, Max<T>);
      return true;
    case Op::kClamp:
      Map<T>(x[0], x[1], x[2], n, r, [](T a, T low, T high) { return Min(Max(a, low), high); });
      return true;
    case Op::kAbs:
      // The most negative int stays as it is.
      Map<T>(x[0], n, r, [](T a) { return a < T(0) ? 0u - Word(a) : Word(a); });
      return true;
    case Op::kSign:
      Map<T>(x[0], n, r, [](T a) { return T(a > T(0)) - T(a < T(0)); });
      return true;
    case Op::kShr:
      Map<T>(x[0], x[1], n, r, [](T a, T b) { return a >> (Word(b) & 31u); });
      return true;
    default:
      return false;
  }
}

}  // namespace

bool Integer(Op op, bool is_signed, Operands x, uint32_t n, uint32_t* r) {
  using U = uint32_t;
  switch (op) {
    case Op::kAdd:
      Map<U>(x[0], x[1], n, r, [](U a, U b) { return a + b; });
      return true;
    case Op::kSub:
      Map<U>(x[0], x[1], n, r, [](U a, U b) { return a - b; });
      return true;
    case Op::kMul:
      Map<U>(x[0], x[1], n, r, [](U a, U b) { return a * b; });
      return true;
    case Op::kNeg:
      Map<U>(x[0], n, r, [](U a) { return 0u - a; });
      return true;
    case Op::kAnd:
      Map<U>(x[0], x[1], n, r, [](U a, U b) { return a & b; });
      return true;
    case Op::kOr:
      Map<U>(x[0], x[1], n, r, [](U a, U b) { return a | b; });
      return true;
    case Op::kXor:
      Map<U>(x[0], x[1], n, r, [](U a, U b) { return a ^ b; });
      return true;
    case Op::kNot:
      Map<U>(x[0], n, r, [](U a) { return ~a; });
      return true;
    case Op::kShl:
      Map<U>(x[0], x[1], n, r, [](U a, U b) { return a << (b & 31u); });
      return true;
    default:
      return is_signed ? Ordered<int32_t>(op, x, n, r) : Ordered<uint32_t>(op, x, n, r);
  }
}

}  // namespace texgraph::ir::families
