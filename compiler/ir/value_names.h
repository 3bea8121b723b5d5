// SPDX-License-Identifier: Apache-2.0
// The names of one function's values in text: "%local" from the side table, "%local.2" for the
// second one of that name, "%7" for the eighth without a name. They depend on the order in which
// values are declared alone: parameters, then bodies from the top, an if or a loop before its
// regions. Constants and globals have no names, they are written where they are used.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "compiler/ir/module.h"

namespace texgraph::ir {

class ValueNames {
 public:
  ValueNames(const Module& module, const Function& function);

  // Gives the next value its name. Each once.
  void Declare(ValueId v);
  // "%local"; "%?" for a value that was not declared.
  std::string_view operator()(ValueId v) const;

 private:
  const Module& module_;
  const Function& function_;
  std::vector<std::string> names_;
  std::unordered_map<std::string_view, uint32_t> uses_;  // of a name
  uint32_t unnamed_ = 0;
};

}  // namespace texgraph::ir
