// SPDX-License-Identifier: Apache-2.0
// The names at global scope: inputs, uniforms and textures keep the graph's; then come outputs,
// structs, functions and constant arrays. Functions that want one name share it, as overloads,
// where their parameters differ.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "compiler/glsl/names.h"
#include "compiler/glsl/uses.h"

namespace texgraph::glsl {

class ModuleNames {
 public:
  // `global_used` and `function_used`: by id, what the shader contains. `local_names`: the names
  // that main's variables want, which functions leave to them. `shader_name`, if not empty, is
  // taken first, and begins the names of all functions, structs and arrays: such shaders stand
  // beside others in one file.
  ModuleNames(const ir::Module& module, const std::vector<bool>& global_used,
              const std::vector<bool>& function_used,
              const std::vector<std::string_view>& local_names, std::string_view shader_name);

  const std::string& Global(GlobalId id) const { return globals_[id.index]; }
  // What reads the global: its name, of a bool that comes as a uint "bool(name)".
  void AppendRead(GlobalId id, std::string& out) const {
    bool converted = bools_are_uints_ && module_.globals[id.index].type == ir::kBool &&
                     module_.globals[id.index].kind == ir::GlobalKind::kUniform;
    out += converted ? "bool(" + Global(id) + ")" : Global(id);
  }
  // Uniforms of type bool are declared as uint: no bool comes into SPIR-V from outside.
  void DeclareBoolsAsUints() { bools_are_uints_ = true; }
  const std::string& Function(FunctionId id) const { return functions_[id.index]; }
  const std::string& Shader() const { return shader_; }
  // The variable of main's i-th result: "out_color".
  const std::string& Output(size_t i) const { return outputs_[i]; }
  // "vec3", "Tile", "float[4]".
  std::string Type(TypeId id) const;
  // "vec3 tint", "float weights[4]".
  std::string Declaration(TypeId type, std::string_view name) const;
  void AppendDeclaration(TypeId type, std::string_view name, std::string& out) const;
  // An array constant; DeclareArray gives it a name.
  const std::string& Array(ir::ConstId id) const { return arrays_.at(id); }
  bool HasArray(ir::ConstId id) const { return arrays_.contains(id); }
  void DeclareArray(ir::ConstId id, std::string_view wish);

  // Whether a local name would hide something at global scope that a function needs: any function
  // or struct, and those globals that it uses.
  bool Hides(std::string_view name, const std::vector<bool>& globals_of_function) const;

 private:
  struct Overloads {
    std::string name;
    std::vector<FunctionId> functions;
  };
  std::string FunctionName(FunctionId id, const std::string& wish);
  std::string Own(std::string_view wish) const;

  const ir::Module& module_;
  NameTable table_;
  bool bools_are_uints_ = false;
  std::string shader_;
  std::vector<std::string> globals_;
  std::vector<std::string> outputs_;
  std::vector<std::string> functions_;
  std::unordered_map<std::string, std::vector<Overloads>> overloads_;  // by wish
  std::unordered_map<TypeId, std::string> structs_;
  std::unordered_map<ir::ConstId, std::string> arrays_;
  std::unordered_map<std::string_view, GlobalId> global_by_name_;
};

}  // namespace texgraph::glsl
