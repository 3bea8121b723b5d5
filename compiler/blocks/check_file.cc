// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <tuple>

#include "compiler/base/text.h"
#include "compiler/blocks/check.h"
#include "compiler/blocks/limits.h"

namespace texgraph::blocks {
namespace {

using ir::TypeId;

constexpr size_t kMaxParameters = 256;
constexpr size_t kMaxFields = 64;

bool IsGeneric(const FunctionAst& function) {
  return function.result.name == "genType" ||
         std::ranges::any_of(function.parameters, [](const ParameterAst& parameter) {
           return parameter.type.name == "genType";
         });
}

bool SameParameters(const Signature& a, const Signature& b) {
  return std::ranges::equal(
      a.parameters, b.parameters,
      [](const SignatureParameter& x, const SignatureParameter& y) { return x.type == y.type; });
}

class FileChecker {
 public:
  FileChecker(Program& program, File& file)
      : program_(program), file_(file), ast_(*file.ast), types_(program.module.types) {}

  void Run() {
    size_t errors = program_.diagnostics.error_count();
    CheckConstantsAndStructs();
    SortFunctions();
    for (FieldInfo& field : file_.fields)
      CheckSignatures(*field.ast, field.is_generic, field.signatures);
    for (FunctionInfo& function : file_.functions) {
      CheckSignatures(*function.ast, function.is_generic, function.signatures);
    }
    CheckPrototypes();
    CheckOverloads();
    GiveFields();
    if (file_.name == "types" && file_.family.empty()) {
      for (const FunctionAst& function : ast_.functions) {
        Error(DiagnosticKind::kBlockName, function.range,
              "types.glsl holds structs and constants only");
      }
    } else if (program_.diagnostics.error_count() == errors) {
      MakeBlock();
    }
    file_.valid = program_.diagnostics.error_count() == errors;
  }

 private:
  Diagnostic& Error(DiagnosticKind kind, SourceRange range, std::string message) {
    return program_.diagnostics.Error(kind, range, std::move(message));
  }

  // A name stands for one thing in a file; functions may share theirs.
  void TakeName(std::string_view name, SourceRange range, bool is_function) {
    CheckName(program_.diagnostics, name, range, true);
    auto [known, added] = names_.try_emplace(name, range, is_function);
    const File* shared = program_.SharedFile();
    SourceRange first = known->second.first;
    bool clash = !added && !(is_function && known->second.second);
    if (shared && added) {
      auto as_struct = shared->structs.find(name);
      auto as_constant = shared->constants.find(name);
      clash = as_struct != shared->structs.end() || as_constant != shared->constants.end();
      if (as_struct != shared->structs.end()) first = as_struct->second.range;
      if (as_constant != shared->constants.end()) first = as_constant->second.range;
    }
    if (!clash) return;
    Error(DiagnosticKind::kBlockName, range, "'" + Printable(name, 60) + "' is declared twice")
        .AddNote(first, "the first time is here");
  }

  // --- Constants and structs, in the order of the file ---

  void CheckConstantsAndStructs() {
    auto constant = ast_.constants.begin();
    auto structure = ast_.structs.begin();
    while (constant != ast_.constants.end() || structure != ast_.structs.end()) {
      bool take_constant =
          structure == ast_.structs.end() ||
          (constant != ast_.constants.end() && constant->whole.begin < structure->whole.begin);
      if (take_constant) {
        CheckConstantDeclaration(*constant++);
      } else {
        CheckStruct(*structure++);
      }
    }
  }

  void CheckConstantDeclaration(const ConstantAst& constant) {
    const Declarator& declarator = constant.declarator;
    TakeName(declarator.name, declarator.range, false);
    ConstantInfo info{{}, declarator.range.begin, declarator.range};
    if (!declarator.value) {
      Error(DiagnosticKind::kBlockSyntax, declarator.range,
            "the constant '" + std::string(declarator.name) + "' needs a value");
    } else {
      const Expr& value = *declarator.value;
      uint32_t length = value.type ? static_cast<uint32_t>(value.args.size()) : 0;
      TypeId type = ResolveType(program_, file_, declarator.type, {}, length);
      if (type) {
        info.value =
            CheckConstant(program_, file_, value, type, false, DiagnosticKind::kBlockConstant);
        ir::Module& module = program_.module;
        if (info.value && module.types.Kind(type) == ir::TypeKind::kArray) {
          module.constant_names.try_emplace(info.value, module.InternName(declarator.name));
        }
      }
    }
    file_.constants.try_emplace(declarator.name, info);
  }

  void CheckStruct(const StructAst& structure) {
    TakeName(structure.name, structure.range, false);
    std::vector<ir::StructField> fields;
    StructInfo info{{}, 1, structure.range.begin, structure.range};
    bool sound = true;
    uint64_t words = 0;
    for (const Declarator& member : structure.members) {
      CheckName(program_.diagnostics, member.name, member.range, false);
      TypeId type = ResolveType(program_, file_, member.type, {});
      sound = sound && type.valid() && CheckMember(structure, member, type, fields);
      if (!sound) continue;
      fields.push_back({std::string(member.name), type});
      words += types_.Words(type);
      info.depth = std::max(info.depth, DepthOf(member.type.name) + 1);
    }
    if (structure.members.empty()) {
      Error(DiagnosticKind::kBlockType, structure.range, "a struct needs a member");
      sound = false;
    }
    if (words > kMaxTypeWords || info.depth > kMaxStructDepth) {
      Error(DiagnosticKind::kSizeLimit, structure.range,
            words > kMaxTypeWords ? "this struct has more than 4096 numbers"
                                  : "structs nest more than 16 deep here");
      sound = false;
    }
    if (sound) info.type = MakeStruct(structure, fields);
    file_.structs.try_emplace(structure.name, info);
  }

  bool CheckMember(const StructAst& structure, const Declarator& member, TypeId type,
                   const std::vector<ir::StructField>& fields) {
    if (ir::IsSampler(type) || type == ir::kVoid || member.value) {
      Error(DiagnosticKind::kBlockType, member.value ? member.value->range : member.type.range,
            member.value ? "a member has no value of its own"
                         : "a member cannot be a " + types_.Text(type));
      return false;
    }
    auto same = [&](const ir::StructField& field) { return field.name == member.name; };
    if (std::ranges::none_of(fields, same)) return true;
    Error(
        DiagnosticKind::kBlockName, member.range,
        "'" + std::string(structure.name) + "' has two members '" + std::string(member.name) + "'");
    return false;
  }

  // Another file's struct of this name may have other members; then this one gets a name of its
  // own.
  TypeId MakeStruct(const StructAst& structure, const std::vector<ir::StructField>& fields) {
    if (TypeId type = types_.Struct(structure.name, fields)) return type;
    std::string own = file_.name + "_" + std::string(structure.name);
    if (TypeId type = types_.Struct(own, fields)) return type;
    Error(DiagnosticKind::kBlockName, structure.range,
          "another block has a struct '" + std::string(structure.name) + "' with other members");
    return {};
  }

  uint32_t DepthOf(std::string_view name) const {
    if (auto own = file_.structs.find(name); own != file_.structs.end()) return own->second.depth;
    const File* shared = program_.SharedFile();
    if (!shared) return 0;
    auto found = shared->structs.find(name);
    return found == shared->structs.end() ? 0 : found->second.depth;
  }

  // --- Functions and fields ---

  // A prototype of a function that the file defines declares that one; any other is a field.
  void SortFunctions() {
    for (const FunctionAst& function : ast_.functions) {
      TakeName(function.name, function.range, true);
      if (!function.body) continue;
      FunctionInfo& info = file_.functions.emplace_back();
      info.ast = &function;
      info.declared_at = function.whole.begin;
      info.is_block = function.name == file_.name;
      info.is_generic = IsGeneric(function);
      file_.functions_by_name[function.name].push_back(
          static_cast<uint32_t>(file_.functions.size() - 1));
    }
    for (const FunctionAst& function : ast_.functions) {
      if (function.body || file_.functions_by_name.contains(function.name)) continue;
      auto known = std::ranges::find(file_.fields, function.name,
                                     [](const FieldInfo& field) { return field.ast->name; });
      if (known != file_.fields.end()) {
        Error(DiagnosticKind::kBlockName, function.range,
              "the field '" + std::string(function.name) + "' is declared twice")
            .AddNote(known->ast->range, "the first time is here");
        continue;
      }
      if (function.name == file_.name) {
        Error(DiagnosticKind::kBlockName, function.range,
              "the block's function '" + std::string(function.name) + "' has no body");
        continue;
      }
      FieldInfo& field = file_.fields.emplace_back();
      field.ast = &function;
      field.is_generic = IsGeneric(function);
      if (file_.fields.size() == kMaxFields + 1) {
        Error(DiagnosticKind::kSizeLimit, function.range, "a file has at most 64 fields");
      }
    }
  }

  void CheckSignatures(const FunctionAst& function, bool is_generic,
                       std::array<Signature, kVariants>& signatures) {
    if (function.parameters.size() > kMaxParameters) {
      Error(DiagnosticKind::kSizeLimit, function.range, "a function has at most 256 parameters");
      return;
    }
    for (uint32_t variant = 0; variant < kVariants; ++variant) {
      if ((variant > 0) != is_generic) continue;
      TypeId gen_type = variant ? ir::Vector(ir::Scalar::kFloat, variant) : TypeId();
      size_t errors = program_.diagnostics.error_count();
      signatures[variant] = MakeSignature(function, gen_type);
      signatures[variant].valid = program_.diagnostics.error_count() == errors;
      // The others would be wrong in the same way.
      if (!signatures[variant].valid) return;
    }
  }

  Signature MakeSignature(const FunctionAst& function, TypeId gen_type) {
    Signature signature;
    signature.result = ResolveType(program_, file_, function.result, gen_type);
    if (signature.result && ir::IsSampler(signature.result)) {
      Error(DiagnosticKind::kBlockType, function.result.range,
            "a function cannot return a texture");
    }
    if (!function.body && signature.result == ir::kVoid) {
      Error(DiagnosticKind::kBlockType, function.result.range, "a field returns a value");
    }
    for (const ParameterAst& ast : function.parameters) {
      SignatureParameter& parameter = signature.parameters.emplace_back();
      parameter.name = ast.name;
      parameter.type = ResolveType(program_, file_, ast.type, gen_type, kAnyLength);
      parameter.is_template = ast.is_const;
      parameter.is_in = !ast.is_out || ast.is_inout;
      parameter.is_out = ast.is_out;
      parameter.range = ast.range;
      if (parameter.type) CheckParameter(function, ast, parameter.type);
    }
    return signature;
  }

  void CheckParameter(const FunctionAst& function, const ParameterAst& ast, TypeId type) {
    bool is_field = !function.body && !file_.functions_by_name.contains(function.name);
    bool is_port = is_field || function.name == file_.name;
    std::string quoted = "'" + std::string(ast.name) + "'";
    if (ast.name.empty()) {
      Error(DiagnosticKind::kBlockName, ast.range, "this parameter needs a name");
    } else if (!function.body) {
      CheckName(program_.diagnostics, ast.name, ast.range, false);
    }
    if (type == ir::kVoid) {
      Error(DiagnosticKind::kBlockType, ast.type.range, "a parameter cannot be void");
    } else if (is_field && (ast.is_const || ast.is_out || ir::IsSampler(type))) {
      Error(DiagnosticKind::kBlockSubset, ast.range,
            "the parameters of a field are plain values that go in");
    } else if (ast.is_const && (ast.is_out || !IsTemplateType(type))) {
      Error(DiagnosticKind::kBlockType, ast.range,
            ast.is_out ? "a parameter cannot be 'const' and 'out'"
                       : "a 'const' parameter is a scalar, a vector, or an array of numbers or of "
                         "vectors of numbers, not " +
                             types_.Text(type));
    } else if (ast.is_out && ir::IsSampler(type)) {
      Error(DiagnosticKind::kBlockType, ast.range, "a texture cannot go out");
    } else if (is_port && ast.is_inout) {
      Error(DiagnosticKind::kBlockSubset, ast.range,
            "the parameters of a block go in or out; make two of " + quoted);
    } else if (ast.is_const) {
      return;
    } else if (is_port && types_.Kind(type) == ir::TypeKind::kArray) {
      Error(DiagnosticKind::kBlockType, ast.range,
            "an array cannot be a port, unless it is 'const'");
    } else if (IsUnsized(types_, type)) {
      Error(DiagnosticKind::kBlockType, ast.range,
            "an array without a length must be a 'const' parameter");
    }
  }

  bool IsTemplateType(TypeId type) const {
    if (types_.Kind(type) != ir::TypeKind::kArray) return ir::IsVector(type);
    TypeId element = types_.ElementType(type, 0);
    return ir::IsVector(element) && !ir::IsBool(element);
  }

  // Prototypes of functions that the file defines agree with one of them.
  void CheckPrototypes() {
    for (const FunctionAst& prototype : ast_.functions) {
      auto named = file_.functions_by_name.find(prototype.name);
      if (prototype.body || named == file_.functions_by_name.end()) continue;
      std::array<Signature, kVariants> signatures;
      CheckSignatures(prototype, IsGeneric(prototype), signatures);
      const Signature& wanted = signatures[IsGeneric(prototype) ? 1 : 0];
      if (!wanted.valid) continue;
      bool found = false;
      for (uint32_t index : named->second) {
        FunctionInfo& function = file_.functions[index];
        const Signature& signature = function.signatures[function.is_generic ? 1 : 0];
        bool same = function.is_generic == IsGeneric(prototype) && signature.valid &&
                    SameParameters(signature, wanted) && signature.result == wanted.result;
        if (!same) continue;
        found = true;
        function.declared_at = std::min(function.declared_at, prototype.whole.begin);
      }
      if (!found) {
        Error(DiagnosticKind::kBlockType, prototype.range,
              "no function '" + std::string(prototype.name) + "' below agrees with this prototype")
            .AddNote(file_.functions[named->second[0]].ast->range, "this one has its name");
      }
    }
  }

  // Two functions of one name differ in the types of their parameters.
  void CheckOverloads() {
    for (const auto& [name, functions] : file_.functions_by_name) {
      std::map<std::vector<TypeId>, const FunctionAst*> seen;
      for (uint32_t index : functions) {
        const FunctionInfo& function = file_.functions[index];
        bool reported = false;
        for (const Signature& signature : function.signatures) {
          if (!signature.valid || reported) continue;
          std::vector<TypeId> types;
          for (const SignatureParameter& parameter : signature.parameters) {
            types.push_back(parameter.type);
          }
          // A function whose parameters don't tell what genType is has one signature for all four.
          auto [known, added] = seen.try_emplace(std::move(types), function.ast);
          if (added || known->second == function.ast) continue;
          reported = true;
          Error(DiagnosticKind::kBlockName, function.ast->range,
                "two functions '" + std::string(name) + "' take the same types")
              .AddNote(known->second->range, "the first one is here");
        }
      }
    }
  }

  // --- Who is given which field ---

  void GiveFields() {
    if (file_.fields.empty()) {
      for (FunctionInfo& function : file_.functions) function.needs_gen_type = function.is_generic;
      return;
    }
    // By name, so overloads share what they need: too much does no harm.
    std::map<std::string_view, std::vector<uint32_t>> callers;
    std::vector<std::vector<bool>> needs(file_.functions.size(),
                                         std::vector<bool>(file_.fields.size()));
    for (uint32_t i = 0; i < file_.functions.size(); ++i) FindCalls(i, callers, needs);
    for (uint32_t field = 0; field < file_.fields.size(); ++field) Spread(field, callers, needs);
    for (uint32_t i = 0; i < file_.functions.size(); ++i) {
      FunctionInfo& function = file_.functions[i];
      function.needs_gen_type = function.is_generic;
      for (uint32_t field = 0; field < file_.fields.size(); ++field) {
        if (!needs[i][field] && !function.is_block) continue;
        function.fields.push_back(field);
        function.needs_gen_type = function.needs_gen_type || file_.fields[field].is_generic;
      }
    }
  }

  void FindCalls(uint32_t index, std::map<std::string_view, std::vector<uint32_t>>& callers,
                 std::vector<std::vector<bool>>& needs) {
    const FunctionAst& function = *file_.functions[index].ast;
    for (size_t i = function.first_expr; i < function.last_expr; ++i) {
      const Expr& expr = ast_.exprs[i];
      if (expr.kind != ExprKind::kCall) continue;
      bool own = file_.functions_by_name.contains(expr.name);
      if (own) callers[expr.name].push_back(index);
      for (uint32_t field = 0; field < file_.fields.size() && !own; ++field) {
        bool called = file_.fields[field].ast->name == expr.name;
        // Another block's function may have fields that are handed on to it.
        if (called || program_.HasFile(expr.name)) needs[index][field] = true;
      }
    }
  }

  void Spread(uint32_t field, const std::map<std::string_view, std::vector<uint32_t>>& callers,
              std::vector<std::vector<bool>>& needs) {
    std::vector<uint32_t> open;
    for (uint32_t i = 0; i < needs.size(); ++i) {
      if (needs[i][field]) open.push_back(i);
    }
    while (!open.empty()) {
      auto called = callers.find(file_.functions[open.back()].ast->name);
      open.pop_back();
      if (called == callers.end()) continue;
      for (uint32_t caller : called->second) {
        if (needs[caller][field]) continue;
        needs[caller][field] = true;
        open.push_back(caller);
      }
    }
  }

  // --- The block ---

  void MakeBlock() {
    Block& block = file_.block;
    block.name = file_.name;
    block.family = file_.family;
    block.path = file_.path;
    block.file = &file_;
    for (uint32_t i = 0; i < file_.functions.size(); ++i) {
      const FunctionInfo& function = file_.functions[i];
      if (!function.is_block) continue;
      if (block.overloads.empty()) block.range = function.ast->range;
      if (!function.needs_gen_type) MakeOverload(i, {});
      for (uint32_t width = 1; width <= 4 && function.needs_gen_type; ++width) {
        MakeOverload(i, ir::Vector(ir::Scalar::kFloat, width));
      }
    }
    if (!block.overloads.empty()) return;
    Error(DiagnosticKind::kBlockName, {file_.source, 0, 0},
          "this file must define the function '" + Printable(file_.name, 60) + "'");
  }

  void MakeOverload(uint32_t index, TypeId gen_type) {
    const FunctionInfo& function = file_.functions[index];
    const Signature& signature = function.signatures[function.is_generic ? Variant(gen_type) : 0];
    Overload overload;
    overload.gen_type = gen_type;
    overload.function = index;
    for (const FieldInfo& field : file_.fields) {
      Port port;
      port.name = field.ast->name;
      port.kind = PortKind::kField;
      port.type = field.Type(types_, gen_type);
      port.range = field.ast->range;
      for (const ParameterAst& parameter : field.ast->parameters) {
        port.field_parameters.emplace_back(parameter.name);
      }
      overload.inputs.push_back(std::move(port));
    }
    if (signature.result != ir::kVoid) {
      overload.outputs.push_back(MakePort("result", signature.result, function.ast->range));
    }
    for (const SignatureParameter& parameter : signature.parameters) {
      Port port = MakePort(parameter.name, parameter.type, parameter.range);
      if (parameter.is_template) port.kind = PortKind::kTemplate;
      if (ir::IsSampler(parameter.type)) port.kind = PortKind::kTexture;
      (parameter.is_out ? overload.outputs : overload.inputs).push_back(std::move(port));
    }
    if (overload.outputs.empty()) {
      Error(DiagnosticKind::kBlockType, function.ast->range,
            "a block returns a value or has an 'out' parameter");
    }
    CheckPortNames(overload);
    file_.block.overloads.push_back(std::move(overload));
  }

  Port MakePort(std::string_view name, TypeId type, SourceRange range) const {
    Port port;
    port.name = name;
    port.type = type;
    port.range = range;
    if (type && types_.Kind(type) == ir::TypeKind::kArray) {
      uint32_t length = types_[type].length;
      port.min_length = length ? length : 1;
      port.max_length = length ? length : kMaxArrayLength;
    }
    return port;
  }

  void CheckPortNames(const Overload& overload) {
    // Reported for one meaning of genType.
    if (overload.gen_type && overload.gen_type != ir::kFloat) return;
    for (const std::vector<Port>* ports : {&overload.inputs, &overload.outputs}) {
      std::map<std::string_view, SourceRange> seen;
      for (const Port& port : *ports) {
        auto [known, added] = seen.try_emplace(port.name, port.range);
        if (added) continue;
        Error(DiagnosticKind::kBlockName, port.range,
              port.name == "result" ? "'result' is the name of the returned value's port"
                                    : "two ports have the name '" + port.name + "'")
            .AddNote(known->second, "the other one is here");
      }
    }
  }

  Program& program_;
  File& file_;
  FileAst& ast_;
  ir::Types& types_;
  std::map<std::string_view, std::pair<SourceRange, bool>> names_;  // where, and whether a function
};

}  // namespace

TypeId FieldInfo::Type(ir::Types& types, TypeId gen_type) const {
  const Signature& signature = signatures[is_generic ? Variant(gen_type) : 0];
  std::vector<TypeId> parameters;
  for (const SignatureParameter& parameter : signature.parameters) {
    parameters.push_back(parameter.type);
  }
  return signature.valid ? types.Field(signature.result, parameters) : TypeId();
}

void CheckFile(Program& program, File& file) { FileChecker(program, file).Run(); }

}  // namespace texgraph::blocks
