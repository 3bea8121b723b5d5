// SPDX-License-Identifier: Apache-2.0
// All that is decided about a module's functions before a character is written.
#pragma once

#include <memory>
#include <vector>

#include "compiler/glsl/variables.h"

namespace texgraph::glsl {

// Mesa takes time that grows with the square of the variables that are written once, and crashes at
// some thousands of them. Functions with more variables or operations than this use their variables
// again, whatever their names.
inline constexpr size_t kManyVariables = 1500;
inline constexpr size_t kManyOperations = 2500;

struct FunctionPlan {
  FunctionPlan(const ir::Module& module, const ir::Function& function, Uses uses,
               const std::vector<bool>& implicit);

  Uses uses;
  bool reuse;
  Forms forms;
  Schedule schedule;
  Variables variables;
  std::vector<bool> globals;  // by GlobalId: whether the function names it

 private:
  Forms DecideForms(const ir::Module& module, const ir::Function& function,
                    const std::vector<bool>& implicit);
};

// The functions that main reaches, and what they use.
struct ModulePlan {
  explicit ModulePlan(const ir::Module& module);

  std::vector<std::unique_ptr<FunctionPlan>>
      functions;                    // by FunctionId; null if main does not reach it
  std::vector<bool> globals;        // by GlobalId: whether any function names it
  std::vector<bool> function_used;  // by FunctionId
  std::vector<bool>
      implicit;  // by FunctionId: whether it takes derivatives across neighbouring pixels
};

}  // namespace texgraph::glsl
