// SPDX-License-Identifier: Apache-2.0
#include "compiler/manifest/manifest.h"

#include <fmt/format.h>

#include <bit>
#include <string_view>
#include <vector>

#include "compiler/base/text.h"
#include "compiler/graph/graph.h"
#include "compiler/manifest/json_writer.h"
#include "compiler/manifest/print_textures.h"
#include "compiler/manifest/usage.h"

namespace texgraph::manifest {
namespace {

constexpr int kVersion = 1;

std::string_view DialectName(Target target) {
  switch (target) {
    case Target::kGlsl330:
      return "glsl330";
    case Target::kGlsl450:
      return "glsl450";
    case Target::kSpirv:
      return "spirv";
  }
  return {};
}

std::string ScalarJson(ir::Scalar scalar, uint32_t word) {
  switch (scalar) {
    case ir::Scalar::kBool:
      return word != 0 ? "true" : "false";
    case ir::Scalar::kInt:
      return fmt::format("{}", std::bit_cast<int32_t>(word));
    case ir::Scalar::kUint:
      return fmt::format("{}", word);
    case ir::Scalar::kFloat:
      return FloatText(std::bit_cast<float>(word));
  }
  return {};
}

// A number, a truth value, or a list of them; matrices column by column.
std::string ConstantJson(const ir::Module& module, ir::ConstId id) {
  ir::TypeId type = module.constant(id).type;
  ir::Scalar scalar = ir::IsVector(type) ? ir::ScalarOf(type) : ir::Scalar::kFloat;
  std::vector<std::string> items;
  for (uint32_t word : module.Words(id)) items.push_back(ScalarJson(scalar, word));
  return items.size() == 1 ? items[0] : JsonList(items);
}

using Entry = glsl::ShaderInterface::Entry;

class Printer {
 public:
  Printer(const graph::CheckedGraph& graph, const ir::Module& module,
          const glsl::ShaderInterface& shader, const CompileOptions& options,
          const std::string& graph_folder, std::span<const DerivedTexture> derived)
      : graph_(graph),
        module_(module),
        shader_(shader),
        options_(options),
        graph_folder_(graph_folder),
        derived_(derived) {}

  std::string Print() {
    json_.OpenObject();
    json_.Integer("texgraph_manifest", kVersion);
    json_.String("name", graph_.graph->name);
    if (!graph_.graph->description.empty()) json_.String("description", graph_.graph->description);
    json_.String("shader", ShaderName());
    json_.String("dialect", DialectName(options_.target));
    json_.String("emit", options_.emit == Emit::kShader ? "shader" : "function");
    json_.String("entry_point", shader_.entry_point);
    PrintInputs();
    PrintOutputs();
    PrintParameters();
    PrintTextures({*graph_.graph, module_, shader_, options_, graph_folder_, derived_}, json_);
    json_.CloseObject();
    return json_.Take();
  }

 private:
  std::string ShaderName() const {
    const std::string& name = options_.shader_name;
    if (!name.empty() && !name.ends_with('/')) return name;
    return name + graph_.graph->name + std::string(ShaderExtension(options_.target, options_.emit));
  }

  // What the shader declares for the graph's thing of that name; null if nothing.
  const Entry* Find(const std::vector<Entry>& entries, std::string_view name) const {
    for (const Entry& entry : entries) {
      if (module_.globals[entry.global.index].name == name) return &entry;
    }
    return nullptr;
  }

  void PrintNumber(std::string_view key, uint32_t number) {
    if (number != glsl::ShaderInterface::kNone) json_.Integer(key, number);
  }

  void PrintInputs() {
    json_.OpenList("inputs");
    for (const BuiltinInput& input : kBuiltinInputs) {
      const Entry* varying = Find(shader_.inputs, input.name);
      const Entry* entry = varying != nullptr ? varying : Find(shader_.uniforms, input.name);
      if (entry == nullptr) continue;
      json_.OpenObject();
      json_.String("name", input.name);
      json_.String("type", input.type);
      json_.String("binding", varying != nullptr ? "input" : "uniform");
      // The inputs of a function are its parameters, in this order.
      if (varying == nullptr || options_.emit == Emit::kShader)
        json_.String("variable", entry->name);
      PrintNumber("location", entry->location);
      json_.CloseObject();
    }
    json_.CloseList();
  }

  void PrintOutputs() {
    json_.OpenList("outputs");
    const std::vector<ir::Result>& results = module_[module_.main].results;
    for (size_t i = 0; i < results.size(); ++i) {
      const glsl::ShaderInterface::Output& output = shader_.outputs[i];
      json_.OpenObject();
      json_.String("name", results[i].name);
      json_.String("type", module_.types.Text(output.type));
      if (!output.name.empty()) json_.String("variable", output.name);
      if (options_.emit == Emit::kShader) PrintNumber("location", output.location);
      json_.CloseObject();
    }
    json_.CloseList();
  }

  void PrintParameters() {
    std::vector<bool> needed = NeededParameters(graph_);
    json_.OpenList("parameters");
    for (size_t i = 0; i < graph_.parameters.size(); ++i)
      PrintParameter(graph_.parameters[i], needed[i]);
    json_.CloseList();
  }

  void PrintParameter(const graph::CheckedParameter& checked, bool needed) {
    const graph::Parameter& parameter = *checked.parameter;
    json_.OpenObject();
    json_.String("name", parameter.name);
    json_.String("type", module_.types.Text(checked.type));
    PrintBinding(parameter, needed);
    json_.Raw("value", ConstantJson(module_, checked.value));
    if (parameter.minimum && parameter.maximum) {
      auto bound = [&](double value) {
        bool whole = ir::IsInteger(checked.type);
        return whole ? fmt::format("{}", static_cast<long long>(value)) : DoubleText(value);
      };
      json_.Raw("range", JsonList({bound(*parameter.minimum), bound(*parameter.maximum)}));
    }
    if (!parameter.label.empty()) json_.String("label", parameter.label);
    if (!parameter.help.empty()) json_.String("help", parameter.help);
    if (!parameter.unit.empty()) json_.String("unit", parameter.unit);
    json_.CloseObject();
  }

  void PrintBinding(const graph::Parameter& parameter, bool needed) {
    const Entry* entry = nullptr;
    switch (parameter.binding) {
      case graph::Binding::kConstant:
        json_.String("binding", "constant");
        json_.String("status", needed ? "folded" : "unused");
        return;
      case graph::Binding::kUniform:
        entry = Find(shader_.uniforms, parameter.name);
        json_.String("binding", "uniform");
        json_.String("status", entry != nullptr ? "uniform" : "unused");
        break;
      case graph::Binding::kSpecialization:
        entry = Find(shader_.specializations, parameter.name);
        json_.String("binding", "specialization");
        json_.String("status", entry != nullptr ? "specialization" : "unused");
        break;
    }
    if (entry == nullptr) return;
    json_.String("variable", entry->name);
    PrintNumber("location", entry->location);
    PrintNumber("constant_id", entry->constant_id);
  }

  const graph::CheckedGraph& graph_;
  const ir::Module& module_;
  const glsl::ShaderInterface& shader_;
  const CompileOptions& options_;
  const std::string& graph_folder_;
  std::span<const DerivedTexture> derived_;
  JsonWriter json_;
};

}  // namespace

std::string PrintManifest(const graph::CheckedGraph& graph, const ir::Module& module,
                          const glsl::ShaderInterface& shader, const CompileOptions& options,
                          const std::string& graph_folder,
                          std::span<const DerivedTexture> derived) {
  return Printer(graph, module, shader, options, graph_folder, derived).Print();
}

}  // namespace texgraph::manifest
