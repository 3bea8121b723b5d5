// SPDX-License-Identifier: Apache-2.0
#include "compiler/manifest/manifest.h"

#include <fmt/format.h>

#include <bit>
#include <optional>
#include <string_view>
#include <vector>

#include "compiler/base/files.h"
#include "compiler/base/text.h"
#include "compiler/graph/graph.h"
#include "compiler/manifest/json_writer.h"
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

class Printer {
 public:
  Printer(const graph::CheckedGraph& graph, const ir::Module& module, const CompileOptions& options,
          const std::string& graph_folder)
      : graph_(graph),
        module_(module),
        options_(options),
        graph_folder_(graph_folder),
        used_(UsedGlobals(module)),
        // Only a whole shader of the newer dialect numbers its inputs, uniforms and textures.
        numbered_(options.emit == Emit::kShader && options.target != Target::kGlsl330) {}

  std::string Print() {
    json_.OpenObject();
    json_.Integer("texgraph_manifest", kVersion);
    json_.String("name", graph_.graph->name);
    if (!graph_.graph->description.empty()) json_.String("description", graph_.graph->description);
    json_.String("shader", ShaderName());
    json_.String("dialect", DialectName(options_.target));
    json_.String("emit", options_.emit == Emit::kShader ? "shader" : "function");
    json_.String("entry_point", options_.emit == Emit::kShader ? "main" : graph_.graph->name);
    PrintInputs();
    PrintOutputs();
    PrintParameters();
    PrintTextures();
    json_.CloseObject();
    return json_.Take();
  }

 private:
  std::string ShaderName() const {
    const std::string& name = options_.shader_name;
    if (!name.empty() && !name.ends_with('/')) return name;
    return name + graph_.graph->name + std::string(ShaderExtension(options_.target, options_.emit));
  }

  // The used global of that kind and name, and how many used ones of the kind come before it.
  struct Found {
    const ir::Global* global;
    size_t number;
  };
  std::optional<Found> Find(ir::GlobalKind kind, std::string_view name) const {
    size_t number = 0;
    for (size_t i = 0; i < module_.globals.size(); ++i) {
      const ir::Global& global = module_.globals[i];
      if (global.kind != kind || !used_[i]) continue;
      if (global.name == name) return Found{&global, number};
      ++number;
    }
    return std::nullopt;
  }

  void PrintNumber(std::string_view key, size_t number) {
    if (numbered_) json_.Integer(key, static_cast<long long>(number));
  }

  void PrintInputs() {
    json_.OpenList("inputs");
    for (const BuiltinInput& input : kBuiltinInputs) {
      std::optional<Found> varying = Find(ir::GlobalKind::kInput, input.name);
      std::optional<Found> uniform = Find(ir::GlobalKind::kUniform, input.name);
      if (!varying && !uniform) continue;
      json_.OpenObject();
      json_.String("name", input.name);
      json_.String("type", input.type);
      json_.String("binding", varying ? "input" : "uniform");
      PrintNumber("location", (varying ? varying : uniform)->number);
      json_.CloseObject();
    }
    json_.CloseList();
  }

  void PrintOutputs() {
    json_.OpenList("outputs");
    const std::vector<ir::Result>& results = module_[module_.main].results;
    for (size_t i = 0; i < results.size(); ++i) {
      json_.OpenObject();
      json_.String("name", results[i].name);
      json_.String("type", module_.types.Text(results[i].type));
      if (options_.emit == Emit::kShader) {
        json_.String("variable", "out_" + results[i].name);
        json_.Integer("location", static_cast<long long>(i));
      }
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
    std::optional<Found> found;
    switch (parameter.binding) {
      case graph::Binding::kConstant:
        json_.String("binding", "constant");
        json_.String("status", needed ? "folded" : "unused");
        return;
      case graph::Binding::kUniform:
        found = Find(ir::GlobalKind::kUniform, parameter.name);
        json_.String("binding", "uniform");
        json_.String("status", found ? "uniform" : "unused");
        if (found) PrintNumber("location", found->number);
        return;
      case graph::Binding::kSpecialization:
        found = Find(ir::GlobalKind::kSpecialization, parameter.name);
        json_.String("binding", "specialization");
        json_.String("status", found ? "specialization" : "unused");
        if (found) PrintNumber("constant_id", found->number);
        return;
    }
  }

  void PrintTextures() {
    json_.OpenList("textures");
    const std::vector<graph::Texture>& textures = graph_.graph->textures;
    for (size_t i = 0; i < textures.size(); ++i) {
      uint32_t same = graph::FirstEqualTexture(*graph_.graph, static_cast<uint32_t>(i));
      PrintTexture(textures[i], textures[same]);
    }
    json_.CloseList();
  }

  // `sampled`: the texture whose sampler it shares, perhaps itself.
  void PrintTexture(const graph::Texture& texture, const graph::Texture& sampled) {
    std::optional<Found> found = Find(ir::GlobalKind::kTexture, sampled.name);
    json_.OpenObject();
    json_.String("name", texture.name);
    json_.String("type", texture.is_array ? "sampler2DArray" : "sampler2D");
    json_.String("status", found ? "used" : "unused");
    if (found) {
      json_.String("variable", sampled.name);
      PrintNumber("binding", found->number);
    }
    std::vector<std::string> files;
    for (std::string_view file : texture.files) {
      std::string path = JoinPath(graph_folder_, file);
      files.push_back(
          JsonQuoted(file.starts_with('/') ? path : RelativePath(path, options_.manifest_folder)));
    }
    json_.Raw("files", JsonList(files));
    json_.String("color_space",
                 texture.color_space == graph::ColorSpace::kSrgb ? "srgb" : "linear");
    json_.String("filter", texture.filter == graph::TextureFilter::kLinear ? "linear" : "nearest");
    json_.Raw("wrap", JsonList({JsonQuoted(WrapName(texture.wrap_u)),
                                JsonQuoted(WrapName(texture.wrap_v))}));
    json_.Bool("mipmaps", texture.mipmaps);
    if (texture.max_level) json_.Integer("max_level", *texture.max_level);
    json_.CloseObject();
  }

  static std::string_view WrapName(graph::TextureWrap wrap) {
    switch (wrap) {
      case graph::TextureWrap::kRepeat:
        return "repeat";
      case graph::TextureWrap::kClamp:
        return "clamp";
      case graph::TextureWrap::kMirror:
        return "mirror";
    }
    return {};
  }

  const graph::CheckedGraph& graph_;
  const ir::Module& module_;
  const CompileOptions& options_;
  const std::string& graph_folder_;
  std::vector<bool> used_;
  bool numbered_;
  JsonWriter json_;
};

}  // namespace

std::string PrintManifest(const graph::CheckedGraph& graph, const ir::Module& module,
                          const CompileOptions& options, const std::string& graph_folder) {
  return Printer(graph, module, options, graph_folder).Print();
}

}  // namespace texgraph::manifest
