// SPDX-License-Identifier: Apache-2.0
// Vectors and matrices, each product and sum rounded. As in Mesa, dot products add from the last
// component to the first, and a matrix times a column adds its columns from the first to the last.
#include <cmath>

#include "compiler/ir/evaluate_families.h"

namespace texgraph::ir::families {
namespace {

// One value at each lane: component i of lane l is at [i * lanes + l].
struct VectorView {
  const uint32_t* words;
  uint32_t lanes;
  float operator()(uint32_t component, uint32_t lane) const {
    return As<float>(words[component * lanes + lane]);
  }
};

float Dot(VectorView a, VectorView b, uint32_t width, uint32_t lane) {
  float sum = a(width - 1, lane) * b(width - 1, lane);
  for (uint32_t i = width - 1; i-- > 0;) sum += a(i, lane) * b(i, lane);
  return sum;
}

// The length of a scalar is its magnitude, also where its square would overflow or vanish.
float Length(VectorView a, uint32_t width, uint32_t lane) {
  return width == 1 ? std::fabs(a(0, lane)) : std::sqrt(Dot(a, a, width, lane));
}

float Distance(VectorView a, VectorView b, uint32_t width, uint32_t lane) {
  if (width == 1) return std::fabs(a(0, lane) - b(0, lane));
  float last = a(width - 1, lane) - b(width - 1, lane);
  float sum = last * last;
  for (uint32_t i = width - 1; i-- > 0;) {
    float difference = a(i, lane) - b(i, lane);
    sum += difference * difference;
  }
  return std::sqrt(sum);
}

// NaN for the null vector, as on GPUs; for a scalar the sign.
void Normalize(VectorView a, uint32_t width, uint32_t lane, uint32_t* r) {
  if (width == 1) {
    float x = a(0, lane);
    r[lane] = Word(x > 0.0f ? 1.0f : x < 0.0f ? -1.0f : 0.0f);
    return;
  }
  float scale = 1.0f / std::sqrt(Dot(a, a, width, lane));
  for (uint32_t i = 0; i < width; ++i) r[i * a.lanes + lane] = Word(a(i, lane) * scale);
}

void Cross(VectorView a, VectorView b, uint32_t lane, uint32_t* r) {
  for (uint32_t i = 0; i < 3; ++i) {
    uint32_t j = (i + 1) % 3, k = (i + 2) % 3;
    r[i * a.lanes + lane] = Word(a(j, lane) * b(k, lane) - b(j, lane) * a(k, lane));
  }
}

// a - 2 dot(b, a) b, for a normalised b.
void Reflect(VectorView a, VectorView b, uint32_t width, uint32_t lane, uint32_t* r) {
  float along = Dot(b, a, width, lane);
  for (uint32_t i = 0; i < width; ++i) {
    r[i * a.lanes + lane] = Word(a(i, lane) - 2.0f * (along * b(i, lane)));
  }
}

}  // namespace

bool Vectors(Op op, uint32_t width, uint32_t lanes, Operands x, uint32_t* r) {
  VectorView a{x[0], lanes}, b{x.size() > 1 ? x[1] : x[0], lanes};
  for (uint32_t lane = 0; lane < lanes; ++lane) {
    switch (op) {
      case Op::kDot:
        r[lane] = Word(Dot(a, b, width, lane));
        break;
      case Op::kLength:
        r[lane] = Word(Length(a, width, lane));
        break;
      case Op::kDistance:
        r[lane] = Word(Distance(a, b, width, lane));
        break;
      case Op::kNormalize:
        Normalize(a, width, lane, r);
        break;
      case Op::kCross:
        Cross(a, b, lane, r);
        break;
      case Op::kReflect:
        Reflect(a, b, width, lane, r);
        break;
      default:
        return false;
    }
  }
  return true;
}

bool Matrices(const OpArguments& arguments, uint32_t* r) {
  const uint32_t lanes = arguments.lanes;
  if (arguments.op == Op::kTranspose) {
    uint32_t size = MatrixSize(arguments.type);
    for (uint32_t column = 0; column < size; ++column) {
      for (uint32_t row = 0; row < size; ++row) {
        const uint32_t* from = arguments.operands[0] + (row * size + column) * lanes;
        uint32_t* to = r + (column * size + row) * lanes;
        for (uint32_t lane = 0; lane < lanes; ++lane) to[lane] = from[lane];
      }
    }
    return true;
  }
  if (arguments.op != Op::kMatMul) return false;
  // A column is a matrix of one column, and a row one of one row; matrices lie column after column.
  TypeId left = arguments.operand_types[0], right = arguments.operand_types[1];
  uint32_t size = IsMatrix(left) ? MatrixSize(left) : MatrixSize(right);
  uint32_t rows = IsMatrix(left) ? size : 1, columns = IsMatrix(right) ? size : 1;
  VectorView a{arguments.operands[0], lanes}, b{arguments.operands[1], lanes};
  for (uint32_t column = 0; column < columns; ++column) {
    for (uint32_t row = 0; row < rows; ++row) {
      uint32_t* to = r + (column * rows + row) * lanes;
      for (uint32_t lane = 0; lane < lanes; ++lane) {
        // The i-th term of a row's dot product or of a sum of columns.
        auto term = [&](uint32_t i) {
          return a(i * rows + row, lane) * b(column * size + i, lane);
        };
        const bool backwards = rows == 1;
        float sum = term(backwards ? size - 1 : 0);
        for (uint32_t i = 1; i < size; ++i) sum += term(backwards ? size - 1 - i : i);
        to[lane] = Word(sum);
      }
    }
  }
  return true;
}

}  // namespace texgraph::ir::families
