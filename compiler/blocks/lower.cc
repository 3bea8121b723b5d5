// SPDX-License-Identifier: Apache-2.0
#include "compiler/blocks/lower.h"

#include <algorithm>

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

  open_.push_back({&file, function, Variant(gen_type)});
  Lowered lowered;
  if (const TypedFunction* typed = CheckBody(program, file, function, gen_type)) {
    auto [origin, added] = origins_.try_emplace(&file);
    if (added) origin->second = program.module.AddOrigin({"", file.name, file.path});
    ir::Function result;
    result.display_name = info.ast->name;
    result.origin = origin->second;
    ir::Builder builder(program.module, result, {fold, nullptr});
    builder.SetOrigin(origin->second);
    std::optional<Lowered> made = FunctionLowering(*this, *typed, result, builder).Run(values);
    if (made) {
      lowered = std::move(*made);
      result.name = UniqueName(file, info);
      program.module.functions.push_back(std::move(result));
      lowered.id = ir::FunctionId(program.module.functions.size() - 1);
    }
  }
  open_.pop_back();
  return lowered_.emplace(std::move(key), std::move(lowered)).first->second;
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
