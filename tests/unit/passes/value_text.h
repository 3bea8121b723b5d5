// SPDX-License-Identifier: Apache-2.0
// A value as one expression, for short comparisons: "(mul p 2)", constants as their components.
#pragma once

#include <bit>
#include <string>
#include <vector>

#include "compiler/ir/builder.h"

namespace texgraph::passes {

inline std::string ConstantText(ir::TypeId type, std::span<const uint32_t> words) {
  std::string text;
  for (uint32_t word : words) {
    std::string component;
    if (ir::IsFloat(type)) {
      component = std::to_string(std::bit_cast<float>(word));
      component.erase(component.find_last_not_of('0') + 1);
      if (component.back() == '.') component.pop_back();
    } else if (ir::IsInteger(type) && ir::ScalarOf(type) == ir::Scalar::kInt) {
      component = std::to_string(static_cast<int32_t>(word));
    } else {
      component = std::to_string(word);
    }
    text += (text.empty() ? "" : ",") + component;
  }
  return text;
}

// Parameters by their names, globals as "@name".
inline std::string ValueText(ir::Builder& builder, ir::ValueId v) {
  const ir::Inst inst = builder[v];
  if (inst.op == ir::Op::kParam) return builder.function().parameters[inst.aux].name;
  if (inst.op == ir::Op::kGlobal) return "@" + builder.module().globals[inst.aux].name;
  if (inst.op == ir::Op::kConst) return ConstantText(inst.type, builder.ConstWords(v));
  std::string text = "(" + std::string(ir::Info(inst.op).name);
  if (inst.op == ir::Op::kExtract) text += "." + std::to_string(inst.aux);
  for (ir::ValueId operand : builder.function().Operands(inst))
    text += " " + ValueText(builder, operand);
  return text + ")";
}

}  // namespace texgraph::passes
