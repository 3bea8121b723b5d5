// SPDX-License-Identifier: Apache-2.0
#include "compiler/glsl/print_glsl.h"

#include <algorithm>

#include "compiler/glsl/function_plan.h"
#include "compiler/glsl/function_printer.h"
#include "compiler/glsl/literals.h"

namespace texgraph::glsl {
namespace {

using ir::GlobalKind;

// The names of main's variables that come from the graph's nodes.
std::vector<std::string_view> LocalNames(const ir::Module& module, const ModulePlan& all) {
  std::vector<std::string_view> names;
  const FunctionPlan& plan = *all.functions[module.main.index];
  // Only functions mind.
  if (std::ranges::count(all.function_used, true) == 1) return names;
  for (size_t i = 0; i < plan.variables.size(); ++i) {
    VariableId v(i);
    if (plan.variables.IsRoot(v) && plan.variables[v].name) {
      names.push_back(module.Name(plan.variables[v].name));
    }
  }
  return names;
}

class ShaderPrinter {
 public:
  ShaderPrinter(const ir::Module& module, const PrintOptions& options)
      : module_(module),
        options_(options),
        plan_(module),
        names_(module, plan_.globals, plan_.function_used, LocalNames(module, plan_),
               options.as_function
                   ? std::string_view(options.name.empty() ? "texture_graph" : options.name)
                   : std::string_view()),
        out_(text_) {}

  std::string Print() {
    if (options_.for_spirv) names_.DeclareBoolsAsUints();
    PlaceGlobals();
    interface_.entry_point = options_.as_function ? names_.Shader() : "main";
    PrintHeader();
    PrintInputs();
    PrintParameters();
    PrintTextures();
    PrintOutputs();
    PrintTypes();
    PrintConstants();
    PrintFunctions();
    return std::move(text_);
  }
  ShaderInterface& interface() { return interface_; }

 private:
  void PlaceGlobals();
  void PrintHeader();
  void PrintInputs();
  void PrintParameters();
  void PrintSpecialization(const ShaderInterface::Entry& entry);
  void PrintTextures();
  void PrintOutputs();
  void PrintTypes();
  void PrintConstants();
  void PrintFunctions();
  void Section(std::string_view title);
  bool HasLayout() const { return options_.dialect == Dialect::k450 && !options_.as_function; }
  const ir::Global& Global(const ShaderInterface::Entry& entry) const {
    return module_.globals[entry.global.index];
  }
  std::string Literal(ir::ConstId id) const;
  void MarkType(TypeId type, std::vector<bool>& used) const;

  const ir::Module& module_;
  const PrintOptions& options_;
  ModulePlan plan_;
  ModuleNames names_;
  ShaderInterface interface_;
  std::string text_;
  LineWriter out_;
};

std::string Layout(std::initializer_list<std::pair<std::string_view, uint32_t>> entries) {
  std::string text = "layout(";
  for (const auto& [key, value] : entries) {
    if (text.back() != '(') text += ", ";
    text += key;
    text += " = " + std::to_string(value);
  }
  return text + ") ";
}

void ShaderPrinter::PlaceGlobals() {
  uint32_t input = 0, location = 0, binding = 0, constant = 0;
  for (size_t i = 0; i < module_.globals.size(); ++i) {
    const ir::Global& global = module_.globals[i];
    ShaderInterface::Entry entry{GlobalId(i), names_.Global(GlobalId(i))};
    bool used = plan_.globals[i];
    switch (global.kind) {
      case GlobalKind::kInput:
        if (HasLayout() && used) entry.location = input++;
        if (used) interface_.inputs.push_back(entry);
        break;
      case GlobalKind::kUniform:
        if (HasLayout() && used) entry.location = location++;
        if (used) interface_.uniforms.push_back(entry);
        break;
      case GlobalKind::kSpecialization:
        if (options_.for_spirv && used) entry.constant_id = constant++;
        if (used) interface_.specializations.push_back(entry);
        break;
      case GlobalKind::kTexture:
        if (used) interface_.textures.push_back(entry);
        break;
    }
  }
  for (ShaderInterface::Entry& entry : interface_.textures) {
    if (!HasLayout()) continue;
    entry.location = location++;
    entry.binding = binding++;
  }
  const std::vector<ir::Result>& results = module_[module_.main].results;
  for (size_t i = 0; i < results.size(); ++i) {
    std::string name = !options_.as_function ? names_.Output(i)
                       : results.size() > 1  ? results[i].name
                                             : "";
    interface_.outputs.push_back({name, results[i].type, static_cast<uint32_t>(i)});
  }
}

void ShaderPrinter::Section(std::string_view title) {
  out_.Blank();
  out_.Line("// " + std::string(title));
}

void ShaderPrinter::PrintHeader() {
  std::string name, by = ", compiled by texgraphc";
  AppendComment(options_.name.empty() ? "texgraph" : options_.name, name);
  if (!options_.version.empty()) {
    by += ' ';
    AppendComment(options_.version, by);
  }
  if (!options_.as_function) {
    out_.Line("// " + name + ": a fragment shader" + by + ".");
    out_.Line(options_.dialect == Dialect::k450 ? "#version 450 core" : "#version 330");
    return;
  }
  out_.Line("// " + name + ": a function for a shader of " +
            (options_.dialect == Dialect::k450 ? "#version 450" : "#version 330") + " or later" +
            by + ".");
  if (!plan_.implicit[module_.main.index]) return;
  out_.Line(
      "// Call it in the main part of a fragment shader, outside branches and loops: textures are");
  out_.Line("// sampled with derivatives, which neighbouring pixels have to compute together.");
}

void ShaderPrinter::PrintInputs() {
  if (options_.as_function || interface_.inputs.empty()) return;
  Section("Inputs");
  for (const ShaderInterface::Entry& entry : interface_.inputs) {
    std::string line = HasLayout() ? Layout({{"location", entry.location}}) : "";
    if (!ir::IsFloat(Global(entry).type)) line += "flat ";
    out_.Line(line + "in " + names_.Declaration(Global(entry).type, entry.name) + ";");
  }
}

std::string ShaderPrinter::Literal(ir::ConstId id) const {
  std::string text;
  AppendLiteral(
      module_.types, module_.constant(id).type, module_.Words(id),
      [&](TypeId t) { return names_.Type(t); }, text);
  return text;
}

void ShaderPrinter::PrintParameters() {
  if (interface_.uniforms.empty() && interface_.specializations.empty()) return;
  Section("Parameters");
  for (const ShaderInterface::Entry& entry : interface_.specializations) PrintSpecialization(entry);
  for (const ShaderInterface::Entry& entry : interface_.uniforms) {
    std::string line = HasLayout() ? Layout({{"location", entry.location}}) : "";
    TypeId type = Global(entry).type;
    if (options_.for_spirv && type == ir::kBool) type = ir::kUint;
    line += "uniform " + names_.Declaration(type, entry.name) + ";";
    if (ir::ConstId value = Global(entry).value) line += "  // default " + Literal(value);
    out_.Line(line);
  }
}

void ShaderPrinter::PrintSpecialization(const ShaderInterface::Entry& entry) {
  const ir::Global& global = Global(entry);
  std::string line = options_.for_spirv ? Layout({{"constant_id", entry.constant_id}}) : "";
  line += "const " + names_.Declaration(global.type, entry.name) + " = " + Literal(global.value);
  out_.Line(line + ";");
}

void ShaderPrinter::PrintTextures() {
  if (interface_.textures.empty()) return;
  Section("Textures");
  for (const ShaderInterface::Entry& entry : interface_.textures) {
    std::string line =
        HasLayout() ? Layout({{"location", entry.location}, {"binding", entry.binding}}) : "";
    out_.Line(line + "uniform " + names_.Type(Global(entry).type) + " " + entry.name + ";");
  }
}

void ShaderPrinter::PrintOutputs() {
  if (options_.as_function) return;
  Section("Outputs");
  for (const ShaderInterface::Output& output : interface_.outputs) {
    out_.Line(Layout({{"location", output.location}}) + "out " + names_.Type(output.type) + " " +
              output.name + ";");
  }
}

void ShaderPrinter::MarkType(TypeId type, std::vector<bool>& used) const {
  if (used[type.index]) return;
  used[type.index] = true;
  const ir::Type& t = module_.types[type];
  for (TypeId element : t.elements) MarkType(element, used);
  for (const ir::StructField& field : t.fields) MarkType(field.type, used);
}

void ShaderPrinter::PrintTypes() {
  std::vector<bool> used(module_.types.size());
  for (size_t f = 0; f < plan_.functions.size(); ++f) {
    if (!plan_.functions[f]) continue;
    const ir::Function& function = module_.functions[f];
    for (size_t i = 0; i < function.insts.size(); ++i) {
      if (plan_.functions[f]->uses.IsWritten(ValueId(i))) MarkType(function.insts[i].type, used);
    }
    for (const ir::Parameter& parameter : function.parameters) MarkType(parameter.type, used);
  }
  bool titled = false;
  for (size_t i = ir::kBasicTypeCount; i < used.size(); ++i) {
    const ir::Type& type = module_.types[TypeId(i)];
    if (!used[i] || type.kind != ir::TypeKind::kStruct) continue;
    if (!titled) Section("Types");
    titled = true;
    out_.Line("struct " + names_.Type(TypeId(i)) + " {");
    out_.Indent();
    for (const ir::StructField& field : type.fields) {
      out_.Line(names_.Declaration(field.type, field.name) + ";");
    }
    out_.Outdent();
    out_.Line("};");
  }
}

// Arrays are written once, under a name.
void ShaderPrinter::PrintConstants() {
  bool titled = false;
  for (size_t f = 0; f < plan_.functions.size(); ++f) {
    if (!plan_.functions[f]) continue;
    const ir::Function& function = module_.functions[f];
    for (size_t i = 0; i < function.insts.size(); ++i) {
      const Inst& inst = function.insts[i];
      if (inst.op != Op::kConst || module_.types.Kind(inst.type) != ir::TypeKind::kArray) continue;
      ir::ConstId id(inst.aux);
      if (!plan_.functions[f]->uses.IsWritten(ValueId(i)) || names_.HasArray(id)) continue;
      if (!titled) Section("Constants");
      titled = true;
      auto name = module_.constant_names.find(id);
      bool named = name != module_.constant_names.end();
      names_.DeclareArray(id, named ? module_.Name(name->second) : "table");
      out_.Line("const " + names_.Declaration(inst.type, names_.Array(id)) + " = " + Literal(id) +
                ";");
    }
  }
}

void ShaderPrinter::PrintFunctions() {
  for (size_t f = 0; f < plan_.functions.size(); ++f) {
    if (!plan_.functions[f]) continue;
    out_.Blank();
    FunctionPrinter printer(module_, module_.functions[f], *plan_.functions[f], names_, out_);
    if (FunctionId(f) != module_.main) {
      printer.PrintBlock(names_.Function(FunctionId(f)));
    } else if (!options_.as_function) {
      printer.PrintMain();
    } else {
      std::vector<GlobalId> inputs;
      for (const ShaderInterface::Entry& entry : interface_.inputs) inputs.push_back(entry.global);
      printer.PrintShaderFunction(inputs);
    }
  }
}

}  // namespace

std::string PrintGlsl(const ir::Module& module, const PrintOptions& options,
                      ShaderInterface* interface) {
  ShaderPrinter printer(module, options);
  std::string text = printer.Print();
  if (interface) *interface = std::move(printer.interface());
  return text;
}

}  // namespace texgraph::glsl
