// SPDX-License-Identifier: Apache-2.0
#include "compiler/glsl/module_names.h"

#include <algorithm>
#include <unordered_set>

#include "compiler/base/text.h"

namespace texgraph::glsl {

ModuleNames::ModuleNames(const ir::Module& module, const std::vector<bool>& global_used,
                         const std::vector<bool>& function_used,
                         const std::vector<std::string_view>& local_names,
                         std::string_view shader_name)
    : module_(module), globals_(module.globals.size()), functions_(module.functions.size()) {
  for (size_t i = 0; i < globals_.size(); ++i) {
    if (!global_used[i]) continue;
    globals_[i] = table_.Claim(module.globals[i].name);
    global_by_name_.emplace(globals_[i], GlobalId(i));
  }
  if (!shader_name.empty()) shader_ = table_.Claim(shader_name);
  for (const ir::Result& result : module[module.main].results) {
    if (shader_name.empty()) outputs_.emplace_back(table_.Claim("out_" + Identifier(result.name)));
  }
  for (size_t i = ir::kBasicTypeCount; i < module.types.size(); ++i) {
    TypeId type(i);
    if (module.types.Kind(type) == ir::TypeKind::kStruct) {
      structs_[type] = table_.Claim(Own(module.types[type].name));
    }
  }
  std::unordered_set<std::string_view> local(local_names.begin(), local_names.end());
  for (size_t i = 0; i < functions_.size(); ++i) {
    if (!function_used[i] || FunctionId(i) == module.main) continue;
    const ir::Function& function = module.functions[i];
    std::string wish =
        Identifier(function.display_name.empty() ? function.name : function.display_name);
    wish = Own(wish);
    if (local.contains(wish)) wish += "_block";
    functions_[i] = FunctionName(FunctionId(i), wish);
  }
}

std::string ModuleNames::Own(std::string_view wish) const {
  return shader_.empty() ? std::string(wish) : shader_ + "_" + std::string(wish);
}

std::string ModuleNames::FunctionName(FunctionId id, const std::string& wish) {
  // Results follow the parameters, so that parameters that differ are enough.
  auto apart = [&](FunctionId other) {
    const std::vector<ir::Parameter>& a = module_[id].parameters;
    const std::vector<ir::Parameter>& b = module_[other].parameters;
    for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
      if (a[i].type != b[i].type) return true;
    }
    return false;
  };
  std::vector<Overloads>& same_wish = overloads_[wish];
  for (Overloads& overloads : same_wish) {
    if (!std::ranges::all_of(overloads.functions, apart)) continue;
    overloads.functions.push_back(id);
    return overloads.name;
  }
  same_wish.push_back({std::string(table_.Claim(wish)), {id}});
  return same_wish.back().name;
}

std::string ModuleNames::Type(TypeId id) const {
  const ir::Type& type = module_.types[id];
  if (type.kind == ir::TypeKind::kArray) {
    return Type(type.elements[0]) + "[" + std::to_string(type.length) + "]";
  }
  if (type.kind == ir::TypeKind::kStruct) return structs_.at(id);
  return type.name;
}

std::string ModuleNames::Declaration(TypeId type, std::string_view name) const {
  std::string text;
  AppendDeclaration(type, name, text);
  return text;
}

void ModuleNames::AppendDeclaration(TypeId type, std::string_view name, std::string& out) const {
  const ir::Type& t = module_.types[type];
  if (type.index < ir::kBasicTypeCount) {
    out += t.name;
  } else {
    out += Type(t.kind == ir::TypeKind::kArray ? t.elements[0] : type);
  }
  out += ' ';
  out += name;
  if (t.kind == ir::TypeKind::kArray) out += "[" + std::to_string(t.length) + "]";
}

void ModuleNames::DeclareArray(ir::ConstId id, std::string_view wish) {
  if (!arrays_.contains(id)) arrays_.emplace(id, table_.Claim(Own(wish)));
}

bool ModuleNames::Hides(std::string_view name, const std::vector<bool>& globals_of_function) const {
  if (!table_.IsTaken(name)) return false;
  if (auto global = global_by_name_.find(name); global != global_by_name_.end()) {
    return globals_of_function[global->second.index];
  }
  return true;
}

}  // namespace texgraph::glsl
