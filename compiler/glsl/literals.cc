// SPDX-License-Identifier: Apache-2.0
#include "compiler/glsl/literals.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>

#include "compiler/base/text.h"

namespace texgraph::glsl {
namespace {

template <class T>
void AppendNumber(T value, std::string& out) {
  char buffer[16];
  auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  out.append(buffer, end);
}

void AppendFloat(uint32_t word, std::string& out) {
  float value = std::bit_cast<float>(word);
  if (std::isfinite(value)) {
    out += FloatText(value);
  } else {
    out += "uintBitsToFloat(";
    AppendNumber(word, out);
    out += "u)";
  }
}

// One number on the diagonal and zeros elsewhere: what mat3(s) means.
bool IsDiagonal(uint32_t size, std::span<const uint32_t> words) {
  for (uint32_t i = 0; i < size * size; ++i) {
    if (words[i] != (i % (size + 1) == 0 ? words[0] : 0)) return false;
  }
  return true;
}

}  // namespace

bool IsSplat(std::span<const uint32_t> words) {
  return std::ranges::all_of(words, [&](uint32_t word) { return word == words[0]; });
}

bool IsNegative(ir::Scalar scalar, uint32_t word) {
  bool high_bit = word >> 31;
  if (scalar == ir::Scalar::kInt) return high_bit && word != 0x80000000u;
  return scalar == ir::Scalar::kFloat && high_bit && (word & 0x7f800000u) != 0x7f800000u;
}

void AppendScalar(ir::Scalar scalar, uint32_t word, std::string& out) {
  switch (scalar) {
    case ir::Scalar::kBool:
      out += word ? "true" : "false";
      return;
    case ir::Scalar::kFloat:
      AppendFloat(word, out);
      return;
    case ir::Scalar::kUint:
      AppendNumber(word, out);
      out += 'u';
      return;
    case ir::Scalar::kInt:
      // 2147483648 is no int, so its negative cannot be written.
      if (word == 0x80000000u) {
        out += "(-2147483647 - 1)";
      } else {
        AppendNumber(static_cast<int32_t>(word), out);
      }
      return;
  }
}

void AppendLiteral(const ir::Types& types, ir::TypeId type, std::span<const uint32_t> words,
                   const TypeNamer& name_of, std::string& out) {
  if (ir::IsScalar(type)) return AppendScalar(ir::ScalarOf(type), words[0], out);
  out += name_of(type);
  out += '(';
  bool is_numbers = ir::IsVector(type) || ir::IsMatrix(type);
  ir::Scalar scalar = ir::IsVector(type) ? ir::ScalarOf(type) : ir::Scalar::kFloat;
  bool is_short = ir::IsVector(type)
                      ? IsSplat(words)
                      : ir::IsMatrix(type) && IsDiagonal(ir::MatrixSize(type), words);
  if (is_numbers) {
    for (size_t i = 0; i < (is_short ? 1 : words.size()); ++i) {
      if (i > 0) out += ", ";
      AppendScalar(scalar, words[i], out);
    }
  } else {
    size_t first = 0;
    for (uint32_t i = 0; i < types.ElementCount(type); ++i) {
      ir::TypeId element = types.ElementType(type, i);
      if (i > 0) out += ", ";
      AppendLiteral(types, element, words.subspan(first, types.Words(element)), name_of, out);
      first += types.Words(element);
    }
  }
  out += ')';
}

}  // namespace texgraph::glsl
