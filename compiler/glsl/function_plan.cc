// SPDX-License-Identifier: Apache-2.0
#include "compiler/glsl/function_plan.h"

#include <optional>

namespace texgraph::glsl {

FunctionPlan::FunctionPlan(const ir::Module& module, const ir::Function& function, Uses known,
                           const std::vector<bool>& implicit)
    : uses(std::move(known)),
      reuse(false),
      forms(DecideForms(module, function, implicit)),
      schedule(function, uses, forms),
      variables(module, function, uses, forms, schedule, reuse),
      globals(module.globals.size()) {
  for (size_t i = 0; i < function.insts.size(); ++i) {
    const Inst& inst = function.insts[i];
    if (inst.op == Op::kGlobal && uses.Count(ValueId(i)) > 0) globals[inst.aux] = true;
  }
}

Forms FunctionPlan::DecideForms(const ir::Module& module, const ir::Function& function,
                                const std::vector<bool>& implicit) {
  Forms readable(module, function, uses, implicit, false);
  if (readable.variable_count() <= kManyVariables &&
      readable.operation_count() <= kManyOperations) {
    return readable;
  }
  reuse = true;
  return Forms(module, function, uses, implicit, true);
}

ModulePlan::ModulePlan(const ir::Module& module)
    : functions(module.functions.size()),
      globals(module.globals.size()),
      function_used(module.functions.size()),
      implicit(module.functions.size()) {
  // Callers come after callees: backwards for what is reached, forwards for what it does.
  std::vector<std::optional<Uses>> uses(functions.size());
  function_used[module.main.index] = true;
  for (size_t f = module.main.index + 1; f-- > 0;) {
    if (!function_used[f]) continue;
    const ir::Function& function = module.functions[f];
    uses[f].emplace(module, function);
    for (size_t i = 0; i < function.insts.size(); ++i) {
      const Inst& inst = function.insts[i];
      if (inst.op == Op::kCall && uses[f]->IsWritten(ValueId(i))) function_used[inst.aux] = true;
    }
  }
  for (size_t f = 0; f <= module.main.index; ++f) {
    if (!function_used[f]) continue;
    const ir::Function& function = module.functions[f];
    for (size_t i = 0; i < function.insts.size(); ++i) {
      const Inst& inst = function.insts[i];
      bool takes = inst.op == Op::kSample || inst.op == Op::kDfdx || inst.op == Op::kDfdy ||
                   (inst.op == Op::kCall && implicit[inst.aux]);
      if (takes && uses[f]->IsWritten(ValueId(i))) implicit[f] = true;
    }
    functions[f] = std::make_unique<FunctionPlan>(module, function, std::move(*uses[f]), implicit);
    for (size_t g = 0; g < globals.size(); ++g) {
      if (functions[f]->globals[g]) globals[g] = true;
    }
  }
}

}  // namespace texgraph::glsl
