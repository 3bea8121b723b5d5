// SPDX-License-Identifier: Apache-2.0
#include "compiler/passes/leaves.h"

namespace texgraph::passes {

using ir::TypeId;
using ir::TypeKind;

void Leaves::Collect(TypeId type, Leaf prefix, std::vector<Leaf>& out) {
  TypeKind kind = types_.Kind(type);
  if (kind != TypeKind::kStruct && kind != TypeKind::kTuple) {
    prefix.type = type;
    out.push_back(std::move(prefix));
    return;
  }
  for (uint32_t i = 0; i < types_.ElementCount(type); ++i) {
    Leaf element = prefix;
    element.path.push_back(i);
    if (kind == TypeKind::kStruct) element.suffix += "_" + types_[type].fields[i].name;
    Collect(types_.ElementType(type, i), std::move(element), out);
  }
}

const std::vector<Leaf>& Leaves::Of(TypeId type) {
  if (type.index >= by_type_.size()) by_type_.resize(type.index + 1);
  std::vector<Leaf>& leaves = by_type_[type.index];
  if (leaves.empty()) Collect(type, {}, leaves);
  return leaves;
}

uint32_t Leaves::Count(TypeId type) {
  return type.index < ir::kBasicTypeCount ? 1 : static_cast<uint32_t>(Of(type).size());
}

uint32_t Leaves::Offset(TypeId aggregate, uint32_t index) {
  TypeKind kind = types_.Kind(aggregate);
  if (kind != TypeKind::kStruct && kind != TypeKind::kTuple) return 0;
  uint32_t offset = 0;
  for (uint32_t i = 0; i < index; ++i) offset += Count(types_.ElementType(aggregate, i));
  return offset;
}

}  // namespace texgraph::passes
