// SPDX-License-Identifier: Apache-2.0
#include "compiler/ir/evaluate_op.h"

#include "compiler/ir/evaluate_families.h"

namespace texgraph::ir {

bool EvaluateOp(const Types& types, const OpArguments& arguments, uint32_t* result) {
  const Op op = arguments.op;
  const auto x = arguments.operands;
  const uint32_t lanes = arguments.lanes;
  const uint32_t n = types.Words(arguments.type) * lanes;
  switch (Info(op).shape) {
    case OpShape::kNumeric:
    case OpShape::kInteger:
      if (IsFloat(arguments.type)) return families::Arithmetic(op, x, n, result);
      return families::Integer(op, ScalarOf(arguments.type) == Scalar::kInt, x, n, result);
    case OpShape::kFloating:
      if (op == Op::kDx || op == Op::kDy || op == Op::kDfdx || op == Op::kDfdy) return false;
      return families::Arithmetic(op, x, n, result) || families::Math(op, x, n, result) ||
             families::Vectors(op, Width(arguments.type), lanes, x, result);
    case OpShape::kDotLike:
    case OpShape::kLengthLike:
      return families::Vectors(op, Width(arguments.operand_types[0]), lanes, x, result);
    case OpShape::kMatrixProduct:
    case OpShape::kMatrixUnary:
      return families::Matrices(arguments, result);
    case OpShape::kComparison:
    case OpShape::kLogic:
    case OpShape::kReduceBool:
    case OpShape::kTestFloat:
      return families::Comparison(op, arguments.operand_types[0], lanes, x, result);
    case OpShape::kConversion:
      families::Conversion(op, ScalarOf(arguments.operand_types[0]), ScalarOf(arguments.type), x[0],
                           n, result);
      return true;
    case OpShape::kSelection:
    case OpShape::kSplatting:
    case OpShape::kMaking:
    case OpShape::kTaking:
    case OpShape::kIndexing:
      return families::Structure(types, arguments, result);
    case OpShape::kLeaf:
    case OpShape::kSampling:
    case OpShape::kTextureQuery:
    case OpShape::kControl:
    case OpShape::kCalling:
      return false;
  }
  return false;
}

}  // namespace texgraph::ir
