// SPDX-License-Identifier: Apache-2.0
// The parts of EvaluateOp, one a family of operations. Each computes `n` words (width times lanes)
// component by component, or whole vectors lane by lane; `r` overlaps no operand. Nothing here is
// undefined behaviour for any bits.
#pragma once

#include <bit>
#include <cstdint>
#include <span>

#include "compiler/ir/evaluate_op.h"

namespace texgraph::ir::families {

using Operands = std::span<const uint32_t* const>;

// The words of one value of type T, and back.
template <class T>
T As(uint32_t word) {
  return std::bit_cast<T>(word);
}
template <class T>
uint32_t Word(T value) {
  return std::bit_cast<uint32_t>(value);
}
template <>
inline uint32_t Word<bool>(bool value) {
  return value ? 1u : 0u;
}

template <class T, class F>
void Map(const uint32_t* a, uint32_t n, uint32_t* r, F f) {
  for (uint32_t i = 0; i < n; ++i) r[i] = Word(f(As<T>(a[i])));
}
template <class T, class F>
void Map(const uint32_t* a, const uint32_t* b, uint32_t n, uint32_t* r, F f) {
  for (uint32_t i = 0; i < n; ++i) r[i] = Word(f(As<T>(a[i]), As<T>(b[i])));
}
template <class T, class F>
void Map(const uint32_t* a, const uint32_t* b, const uint32_t* c, uint32_t n, uint32_t* r, F f) {
  for (uint32_t i = 0; i < n; ++i) r[i] = Word(f(As<T>(a[i]), As<T>(b[i]), As<T>(c[i])));
}

// kNumeric on floats, and the exactly defined part of kFloating (rounding, mod, mix, step, sqrt).
bool Arithmetic(Op op, Operands x, uint32_t n, uint32_t* r);
// kNumeric on int and uint, and kInteger.
bool Integer(Op op, bool is_signed, Operands x, uint32_t n, uint32_t* r);
// Powers, exponentials, trigonometry.
bool Math(Op op, Operands x, uint32_t n, uint32_t* r);
// dot, length, distance, normalize, cross, reflect of vectors of `width`.
bool Vectors(Op op, uint32_t width, uint32_t lanes, Operands x, uint32_t* r);
// matmul, transpose.
bool Matrices(const OpArguments& arguments, uint32_t* r);
// kComparison, kLogic, kReduceBool, kTestFloat. `operand` is the operands' type.
bool Comparison(Op op, TypeId operand, uint32_t lanes, Operands x, uint32_t* r);
// convert and bitcast from one scalar kind to another.
void Conversion(Op op, Scalar from, Scalar to, const uint32_t* x, uint32_t n, uint32_t* r);
// select, splat, construct, extract, swizzle, index.
bool Structure(const Types& types, const OpArguments& arguments, uint32_t* r);

}  // namespace texgraph::ir::families
