// SPDX-License-Identifier: Apache-2.0
#include "compiler/glsl/limits.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/base/text.h"
#include "compiler/glsl/legalize.h"
#include "compiler/ir/loop_end.h"
#include "compiler/ir/rebuild.h"

namespace texgraph::glsl {
namespace {

using ir::FunctionId;
using ir::Op;
using ir::ValueId;

// Of one function, with all that it calls.
struct Load {
  uint64_t rounds = 0;  // of loops, all together; saturates
  size_t nesting = 0;   // of its own ifs and loops
};

uint64_t Saturated(uint64_t a) { return std::min(a, uint64_t(1) << 40); }

class LimitChecker {
 public:
  LimitChecker(const ir::Module& module, SourceRange where, Diagnostics& diagnostics)
      : module_(module), where_(where), diagnostics_(diagnostics) {}
  bool Check();

 private:
  void Measure();
  Load MeasureFunction(const ir::Function& function, const ir::Liveness& live);
  void CheckTextures();
  void CheckUniforms();
  void CheckLoops();
  void CheckNesting();
  void Fail(DiagnosticKind kind, std::string message) {
    diagnostics_.Error(kind, where_, std::move(message));
    failed_ = true;
  }
  std::string NameOf(size_t f) const {
    const ir::Function& function = module_.functions[f];
    return Printable(function.display_name.empty() ? function.name : function.display_name);
  }

  const ir::Module& module_;
  const SourceRange where_;
  Diagnostics& diagnostics_;
  std::vector<bool> globals_;  // by GlobalId: used
  std::vector<bool> reached_;  // by FunctionId
  std::vector<Load> loads_;    // by FunctionId
  bool failed_ = false;
};

bool LimitChecker::Check() {
  Measure();
  CheckTextures();
  CheckUniforms();
  size_t outputs = module_[module_.main].results.size();
  if (outputs > kMostOutputs) {
    Fail(DiagnosticKind::kTargetLimit,
         fmt::format("the graph has {} outputs, and a fragment shader may have {}", outputs,
                     kMostOutputs));
  }
  CheckLoops();
  CheckNesting();
  return !failed_;
}

void LimitChecker::Measure() {
  reached_.resize(module_.functions.size());
  loads_.resize(module_.functions.size());
  globals_.resize(module_.globals.size());
  reached_[module_.main.index] = true;
  std::vector<std::unique_ptr<ir::Liveness>> live(module_.functions.size());
  for (size_t f = module_.main.index + 1; f-- > 0;) {
    if (!reached_[f]) continue;
    const ir::Function& function = module_.functions[f];
    live[f] = std::make_unique<ir::Liveness>(module_, function);
    for (size_t i = 0; i < function.insts.size(); ++i) {
      const ir::Inst& inst = function.insts[i];
      if (!live[f]->Live(ValueId(i))) continue;
      if (inst.op == Op::kCall) reached_[inst.aux] = true;
      if (inst.op == Op::kGlobal) globals_[inst.aux] = true;
    }
  }
  for (size_t f = 0; f <= module_.main.index; ++f) {
    if (reached_[f]) loads_[f] = MeasureFunction(module_.functions[f], *live[f]);
  }
}

// Walks the regions with a stack of its own: how deep they nest is what is to be found out.
Load LimitChecker::MeasureFunction(const ir::Function& function, const ir::Liveness& live) {
  struct Open {
    ir::RegionId region;
    size_t next;
    uint64_t times;  // how often its body runs
    size_t depth;
  };
  Load load;
  std::vector<Open> stack{{function.body, 0, 1, 0}};
  while (!stack.empty()) {
    Open& top = stack.back();
    const std::vector<ValueId>& body = function.regions[top.region.index].body;
    if (top.next == body.size()) {
      stack.pop_back();
      continue;
    }
    ValueId v = body[top.next++];
    if (!live.Live(v)) continue;
    const ir::Inst& inst = function[v];
    const uint64_t times = top.times;
    const size_t depth = top.depth + 1;
    if (inst.op == Op::kCall) {
      load.rounds = Saturated(load.rounds + times * loads_[inst.aux].rounds);
    } else if (inst.op == Op::kFor) {
      const ir::ForLoop& loop = function.loops[inst.aux];
      uint64_t rounds = Saturated(times * ir::TypicalRounds(function, loop));
      load.rounds = Saturated(load.rounds + rounds);
      stack.push_back({loop.body, 0, rounds, depth});
    } else if (inst.op == Op::kIf) {
      const ir::Branch& branch = function.branches[inst.aux];
      stack.push_back({branch.then_region, 0, times, depth});
      stack.push_back({branch.else_region, 0, times, depth});
    }
    if (inst.op == Op::kFor || inst.op == Op::kIf) load.nesting = std::max(load.nesting, depth);
  }
  return load;
}

void LimitChecker::CheckTextures() {
  size_t count = 0;
  for (size_t g = 0; g < globals_.size(); ++g) {
    count += globals_[g] && module_.globals[g].kind == ir::GlobalKind::kTexture;
  }
  if (count > kMostTextures) {
    Fail(
        DiagnosticKind::kTargetLimit,
        fmt::format("the shader samples {} textures, and few drivers allow more than {}; put equal "
                    "sizes into one texture with 'layers'",
                    count, kMostTextures));
  } else if (count > kSureTextures) {
    diagnostics_.Warn(DiagnosticKind::kTargetLimit, where_,
                      fmt::format("the shader samples {} textures, and OpenGL promises only {}",
                                  count, kSureTextures));
  }
}

void LimitChecker::CheckUniforms() {
  size_t components = 0;
  for (size_t g = 0; g < globals_.size(); ++g) {
    const ir::Global& global = module_.globals[g];
    if (globals_[g] && global.kind == ir::GlobalKind::kUniform) {
      components += module_.types.Words(global.type);
    }
  }
  if (components > kMostUniformComponents) {
    Fail(DiagnosticKind::kTargetLimit,
         fmt::format(
             "the uniform parameters have {} components, and drivers allow {}; make some of them "
             "constant",
             components, kMostUniformComponents));
  } else if (components > kSureUniformComponents) {
    diagnostics_.Warn(
        DiagnosticKind::kTargetLimit, where_,
        fmt::format("the uniform parameters have {} components, and OpenGL promises only {}",
                    components, kSureUniformComponents));
  }
}

// Reported where the count first goes over, so that the message names the block that loops.
void LimitChecker::CheckLoops() {
  for (size_t f = 0; f <= module_.main.index; ++f) {
    if (!reached_[f] || loads_[f].rounds <= kMostRounds) continue;
    Fail(DiagnosticKind::kLoopLimit,
         fmt::format("the loops of '{}' make {}{} rounds for one pixel, and drivers stop after {}",
                     NameOf(f), loads_[f].rounds >= Saturated(~0ull) ? "more than " : "",
                     loads_[f].rounds, kMostRounds));
    return;
  }
}

void LimitChecker::CheckNesting() {
  for (size_t f = 0; f <= module_.main.index; ++f) {
    if (!reached_[f] || loads_[f].nesting <= kMostNesting) continue;
    Fail(DiagnosticKind::kTargetLimit,
         fmt::format("ifs and loops nest {} deep in '{}', and compilers of GLSL take {}",
                     loads_[f].nesting, NameOf(f), kMostNesting));
  }
}

}  // namespace

bool CheckLimits(const ir::Module& module, SourceRange where, Diagnostics& diagnostics) {
  return LimitChecker(module, where, diagnostics).Check();
}

}  // namespace texgraph::glsl
