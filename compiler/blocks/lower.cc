// SPDX-License-Identifier: Apache-2.0
#include "compiler/blocks/lower.h"

#include <algorithm>
#include <memory>

#include "compiler/blocks/check.h"
#include "compiler/blocks/limits.h"
#include "compiler/blocks/lower_function.h"

namespace texgraph::blocks {

const Lowered& Lowering::Function(File& file, uint32_t function, ir::TypeId gen_type,
                                  std::span<const ir::ConstId> values, SourceRange caller) {
  const FunctionInfo& info = file.functions[function];
  if (!info.needs_gen_type) gen_type = {};
  Key key{&file, function, Variant(gen_type), {values.begin(), values.end()}};
  if (auto known = lowered_.find(key); known != lowered_.end()) return known->second;
  static const Lowered kFailed;
  if (!Enter(key, caller)) return kFailed;

  if (open_.empty()) CheckReachable(file, function, gen_type);
  open_.push_back({&file, function, Variant(gen_type)});
  Lowered lowered;
  if (const TypedFunction* typed = CheckBody(program, file, function, gen_type)) {
    lowered = Make(*typed, values);
  }
  open_.pop_back();
  return lowered_.emplace(std::move(key), std::move(lowered)).first->second;
}

// Checks all bodies that a call may lead to, one after the other: lowering finds them checked then,
// so the two recursions are never on top of each other.
void Lowering::CheckReachable(File& file, uint32_t function, ir::TypeId gen_type) {
  std::vector<Callee> waiting{{&file, function, gen_type, {}}};
  while (!waiting.empty()) {
    Callee next = std::move(waiting.back());
    waiting.pop_back();
    bool generic = next.file->functions[next.function].needs_gen_type;
    Open open{next.file, next.function, generic ? Variant(next.gen_type) : 0};
    if (!checked_.insert(open).second) continue;
    const TypedFunction* typed = CheckBody(program, *next.file, next.function, next.gen_type);
    if (typed) waiting.insert(waiting.end(), typed->callees.begin(), typed->callees.end());
  }
}

Lowered Lowering::Make(const TypedFunction& typed, std::span<const ir::ConstId> values) {
  // On the heap: calls within calls would take much of the stack.
  struct Parts {
    Parts(Lowering& lowering, const TypedFunction& typed)
        : builder(lowering.program.module, result, {lowering.fold, nullptr}),
          function(lowering, typed, result, builder) {}
    ir::Function result;
    ir::Builder builder;
    FunctionLowering function;
  };
  const File& file = *typed.file;
  const FunctionInfo& info = file.functions[typed.function];
  auto [origin, added] = origins_.try_emplace(&file);
  if (added) origin->second = program.module.AddOrigin({"", file.name, file.path});
  auto parts = std::make_unique<Parts>(*this, typed);
  parts->result.display_name = info.ast->name;
  parts->result.origin = origin->second;
  parts->builder.SetOrigin(origin->second);
  std::optional<Lowered> made = parts->function.Run(values);
  if (!made) return {};
  parts->result.name = UniqueName(file, info);
  program.module.functions.push_back(std::move(parts->result));
  made->id = ir::FunctionId(program.module.functions.size() - 1);
  return *made;
}

// Whether the function may be lowered now: it must not be at it already.
bool Lowering::Enter(const Key& key, SourceRange caller) {
  auto is_this = [&](const Open& open) {
    return open.file == key.file && open.function == key.function && open.variant == key.variant;
  };
  auto again = std::ranges::find_if(open_, is_this);
  if (again != open_.end()) {
    std::string chain;
    for (auto at = again + 1; at != open_.end() && chain.size() < 200; ++at) {
      chain += (chain.empty() ? " through '" : ", '") + at->Name() + "'";
    }
    program.diagnostics.Error(DiagnosticKind::kBlockRecursion, caller,
                              "'" + again->Name() + "' calls itself" + chain +
                                  ", and GLSL has no recursion; use a counted loop");
    return false;
  }
  if (open_.size() < kMaxCallDepth) return true;
  program.diagnostics.Error(DiagnosticKind::kNestingLimit, caller,
                            "more than 64 functions call each other here");
  return false;
}

std::string Lowering::Open::Name() const {
  return std::string(file->functions[function].ast->name);
}

// "layer", "layer.2"; functions of its own are "layer.rotate".
std::string Lowering::UniqueName(const File& file, const FunctionInfo& info) {
  std::string name = file.name;
  if (!info.is_block) name += "." + std::string(info.ast->name);
  uint32_t count = ++names_[name];
  return count == 1 ? name : name + "." + std::to_string(count);
}

}  // namespace texgraph::blocks
