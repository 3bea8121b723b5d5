// SPDX-License-Identifier: Apache-2.0
// Copies one function with the rules applied, its signature cut to what is used, and the calls of
// functions that were copied before brought up to date.
#pragma once

#include <vector>

#include "compiler/ir/module.h"
#include "compiler/ir/rebuild.h"
#include "compiler/passes/rules.h"

namespace texgraph::passes {

// What callers must know of a function that was copied. Indices are those of its old signature.
struct CopiedFunction {
  // A result that callers can name without the call: a constant, or an argument.
  struct Forward {
    enum class Kind : uint8_t { kNone, kConst, kArgument };
    Kind kind = Kind::kNone;
    uint32_t id = 0;  // ConstId, or the parameter's index
  };
  static constexpr uint32_t kGone = 0xffffffffu;

  std::vector<bool> keeps_parameter;
  std::vector<uint32_t> result_index;  // in the new signature, or kGone
  std::vector<Forward> forwards;       // by result
  bool is_inlined = false;             // small enough to stand at each call

  // Whether callers must be copied too.
  bool ConcernsCallers() const;
};

// A plan for one function: parameters to replace by constants, and what of the signature is used.
struct FunctionPlan {
  std::vector<ir::ConstId> constants;  // by parameter; invalid: it stays one, if it is used
  // By parameter: an earlier one that stands for it, or itself; may be empty.
  const std::vector<uint32_t>& twins;
  const ir::SignatureUse& use;
};

class FunctionSimplifier {
 public:
  // `copies` has an entry for each function of the module, as they are before they are copied.
  FunctionSimplifier(ir::Module& module, const SimplifyRules& rules,
                     std::vector<CopiedFunction>& copies)
      : module_(module), rules_(rules), copies_(copies) {}

  // Copies function `id` and writes its entry. Whether copying it once more may do it good.
  bool Run(ir::FunctionId id, const FunctionPlan& plan, bool may_inline);

 private:
  ir::Module& module_;
  const SimplifyRules& rules_;
  std::vector<CopiedFunction>& copies_;
};

}  // namespace texgraph::passes
