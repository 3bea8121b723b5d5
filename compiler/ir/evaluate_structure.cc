// SPDX-License-Identifier: Apache-2.0
// Operations that move words without looking at them.
#include <algorithm>

#include "compiler/ir/evaluate_families.h"

namespace texgraph::ir::families {
namespace {

void Select(const OpArguments& arguments, uint32_t words, uint32_t* r) {
  const uint32_t lanes = arguments.lanes;
  const uint32_t condition_words = Width(arguments.operand_types[0]);
  for (uint32_t word = 0; word < words; ++word) {
    const uint32_t* condition = arguments.operands[0] + (condition_words == 1 ? 0 : word) * lanes;
    const uint32_t* a = arguments.operands[1] + word * lanes;
    const uint32_t* b = arguments.operands[2] + word * lanes;
    uint32_t* to = r + word * lanes;
    for (uint32_t lane = 0; lane < lanes; ++lane) to[lane] = condition[lane] ? a[lane] : b[lane];
  }
}

// The index is clamped to the elements that there are.
void Index(const Types& types, const OpArguments& arguments, uint32_t words, uint32_t* r) {
  const uint32_t lanes = arguments.lanes;
  const int64_t last = int64_t(types.ElementCount(arguments.operand_types[0])) - 1;
  const bool is_signed = ScalarOf(arguments.operand_types[1]) == Scalar::kInt;
  for (uint32_t lane = 0; lane < lanes; ++lane) {
    uint32_t bits = arguments.operands[1][lane];
    int64_t index = is_signed ? int64_t(As<int32_t>(bits)) : int64_t(bits);
    index = std::clamp<int64_t>(index, 0, last);
    const uint32_t* from = arguments.operands[0] + size_t(index) * words * lanes;
    for (uint32_t word = 0; word < words; ++word) {
      r[word * lanes + lane] = from[word * lanes + lane];
    }
  }
}

}  // namespace

bool Structure(const Types& types, const OpArguments& arguments, uint32_t* r) {
  const uint32_t lanes = arguments.lanes;
  const uint32_t words = types.Words(arguments.type);
  switch (arguments.op) {
    case Op::kSelect:
      Select(arguments, words, r);
      return true;
    case Op::kSplat:
      for (uint32_t word = 0; word < words; ++word) {
        std::copy_n(arguments.operands[0], lanes, r + word * lanes);
      }
      return true;
    case Op::kConstruct:
      for (size_t i = 0; i < arguments.operands.size(); ++i) {
        r = std::copy_n(arguments.operands[i], types.Words(arguments.operand_types[i]) * lanes, r);
      }
      return true;
    case Op::kExtract: {
      uint32_t offset = types.ElementOffset(arguments.operand_types[0], arguments.aux);
      std::copy_n(arguments.operands[0] + offset * lanes, words * lanes, r);
      return true;
    }
    case Op::kSwizzle:
      for (uint32_t word = 0; word < words; ++word) {
        uint32_t component = (arguments.aux >> (2 * word)) & 3;
        std::copy_n(arguments.operands[0] + component * lanes, lanes, r + word * lanes);
      }
      return true;
    case Op::kIndex:
      Index(types, arguments, words, r);
      return true;
    default:
      return false;
  }
}

}  // namespace texgraph::ir::families
