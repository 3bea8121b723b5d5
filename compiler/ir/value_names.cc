// SPDX-License-Identifier: Apache-2.0
#include "compiler/ir/value_names.h"

#include "compiler/base/text.h"

namespace texgraph::ir {

ValueNames::ValueNames(const Module& module, const Function& function)
    : module_(module), function_(function), names_(function.insts.size()) {}

void ValueNames::Declare(ValueId v) {
  NameId id = function_.NameOf(v);
  std::string_view name = id ? module_.Name(id) : std::string_view();
  std::string& text = names_[v.index];
  text = "%";
  if (!IsIdentifier(name)) {
    text += std::to_string(unnamed_++);
    return;
  }
  text += name;
  if (uint32_t use = ++uses_[name]; use > 1) text += "." + std::to_string(use);
}

std::string_view ValueNames::operator()(ValueId v) const {
  return names_[v.index].empty() ? std::string_view("%?") : names_[v.index];
}

}  // namespace texgraph::ir
