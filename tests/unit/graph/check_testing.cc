// SPDX-License-Identifier: Apache-2.0
#include "tests/unit/graph/check_testing.h"

#include <fmt/format.h>

#include <bit>
#include <filesystem>

#include "compiler/base/text.h"
#include "tests/unit/base/scratch_folder.h"

namespace texgraph::graph {
namespace {

struct BlockText {
  const char* name;
  const char* text;
};

constexpr BlockText kBlocks[] = {
    {"t_one", R"(/// One number.
/// @param x a number @default 0.5 @range 0 10
float t_one(float x) { return x; }
)"},
    {"t_need", R"(/// Needs its input.
/// @param x a number
float t_need(float x) { return x; }
)"},
    {"t_gen", R"(/// Any width.
/// @param a first
/// @param b second
genType t_gen(genType a, genType b) { return a + b; }
)"},
    {"t_either", R"(const int MODE_MIX = 0;
const int MODE_ADD = 3;
/// Picks a mode, in two versions.
/// @param x a value @default 0
/// @param mode how @default MODE_MIX
float t_either(float x, const int mode) { return mode == MODE_ADD ? x : -x; }
/// @param x a value @default 0
/// @param y another value @default 0
/// @param mode how @default MODE_MIX
float t_either(float x, float y, const int mode) { return mode == MODE_ADD ? x : -y; }
)"},
    {"t_pick", R"(const int MODE_MIX = 0;
const int MODE_ADD = 3;
/// Words.
/// @param x a number @default 0
/// @param mode how @default MODE_MIX
float t_pick(float x, const int mode) { return mode == MODE_ADD ? x : -x; }
)"},
    {"t_count", R"(/// A template number.
/// @param n how many @default 1 @range 1 8
float t_count(const int n) { return float(n); }
)"},
    {"t_image", R"(/// Reads a texture.
/// @param picture the texture
/// @param uv where @default uv
vec4 t_image(sampler2D picture, vec2 uv) { return texture(picture, uv); }
)"},
    {"t_layers", R"(/// Reads a layer of a texture.
/// @param picture the texture
/// @param where place and layer
vec4 t_layers(sampler2DArray picture, vec3 where) { return texture(picture, where); }
)"},
    {"t_warp", R"(/// Asks a function.
/// @param image the function
/// @param uv where @default uv
vec4 image(vec2 uv);
vec4 t_warp(vec2 uv) { return image(uv * 2.0); }
)"},
    {"t_slope", R"(/// Asks a function of numbers, with a default.
/// @param height the function @default 1.5
/// @param at where @default uv
float height(vec2 p, float lod);
float t_slope(vec2 at) { return height(at, 0.0); }
)"},
    {"t_grid", R"(/// Two outputs.
/// @param uv where @default uv
/// @param tile the tile
/// @param mask the mask
void t_grid(vec2 uv, out Tile tile, out float mask) {
  tile.cell = ivec2(0);
  tile.local = uv;
  tile.size = vec2(1.0);
  tile.seed = 0u;
  mask = uv.x;
}
)"},
    {"t_extra", R"(/// A result and a further output.
/// @param uv where @default uv
/// @param side another one
vec2 t_extra(vec2 uv, out float side) {
  side = uv.x;
  return uv;
}
)"},
    {"t_cell", R"(/// Takes a struct.
/// @param tile the tile
float t_cell(Tile tile) { return tile.local.x; }
)"},
    {"t_limits", R"(/// Least and greatest values.
/// @param low the least @default vec2(0) @range -10 10
/// @param high the greatest @default vec2(1) @not_below low
/// @param size the least and the greatest @default vec2(1) @ordered
/// @param first the least @default -3
/// @param last the greatest @default 5 @not_below first
vec2 t_limits(vec2 low, vec2 high, vec2 size, const int first, int last) {
  return clamp(size, low, high) + vec2(first, last);
}
)"},
    {"t_waves", R"(/// Waves, which may be told to be faint.
/// @param uv where @default uv
/// @param height how high @default 1.0
/// @param faint how faint @default 0 @asked_at uv
float t_waves(vec2 uv, const float height, int faint) { return height * sin(uv.x) - float(faint); }
/// @param uv where
float t_waves(vec3 uv, const float height, int faint) { return height * sin(uv.x) - float(faint); }
)"},
    {"t_sum", R"(/// Asks waves twice.
/// @param waves what is summed @default t_waves
/// @param uv where @default uv
float waves(genType uv, int faint);
float t_sum(genType uv) { return waves(uv, 1) + waves(uv * 2.0, 2); }
)"},
    {"t_lost", R"(/// Its default is no block.
/// @param waves what is summed @default t_wave
/// @param uv where @default uv
float waves(vec2 uv);
float t_lost(vec2 uv) { return waves(uv); }
)"},
    {"t_odd", R"(/// Its default takes other things.
/// @param waves what is summed @default t_waves
/// @param uv where @default uv
float waves(vec2 place);
float t_odd(vec2 uv) { return waves(uv); }
)"},
    {"t_whole", R"(/// Integers and a bool.
/// @param v a vector @default ivec2(1, 2)
/// @param u not negative @default 7u
/// @param b yes or no @default false
ivec2 t_whole(ivec2 v, uint u, bool b) { return b ? v : v * int(u); }
)"},
    {"t_sign", R"(/// Overloads by sign.
/// @param a any
float t_sign(float a) { return a; }
uint t_sign(uint a) { return a; }
)"},
    {"t_kind", R"(/// Overloads by type.
/// @param a any @default 0
int t_kind(int a) { return a; }
/// @param a any @default 0.0
float t_kind(float a) { return a; }
/// @param a any @default vec3(0.0)
vec3 t_kind(vec3 a) { return a; }
)"},
    {"t_ports", R"(/// Overloads by ports.
/// @param a first
float t_ports(float a) { return a; }
/// @param a first
/// @param b second
vec2 t_ports(float a, float b) { return vec2(a, b); }
)"},
    {"t_matrix", R"(/// A matrix.
/// @param m the matrix
float t_matrix(mat2 m) { return m[0].y; }
)"},
    {"t_broken", "float t_broken(floot x) { return 1.0; }\n"},
};

// The blocks' folder, made once for the program.
const ScratchFolder& BlockFolder() {
  static const ScratchFolder folder;
  static const bool written = [] {
    std::filesystem::create_directory(folder / "t");
    for (const BlockText& block : kBlocks) {
      folder.Write(fmt::format("t/{}.glsl", block.name), block.text);
    }
    return true;
  }();
  (void)written;
  return folder;
}

std::string ConstantText(const ir::Module& module, ir::ConstId id) {
  ir::TypeId type = module.constant(id).type;
  std::string text;
  for (uint32_t word : module.Words(id)) {
    if (!text.empty()) text += ",";
    if (ir::IsFloat(type)) {
      text += FloatText(std::bit_cast<float>(word));
    } else {
      text += fmt::format("{}", static_cast<int32_t>(word));
    }
  }
  return text;
}

}  // namespace

CheckText::CheckText(std::string_view text, std::string_view outputs,
                     const std::vector<std::string>& settings) {
  std::string whole = fmt::format("{{\"texgraph\": 1, \"outputs\": {{{}}},\n{}}}", outputs, text);
  std::vector<Setting> read = ReadSettings(settings, sources, diagnostics);
  SourceId source = sources.Add("graph.json", std::move(whole));
  graph = ReadGraph(source, DocumentFormat::kJson, sources, diagnostics);
  if (!graph) return;
  library.emplace(module, sources, diagnostics, std::vector<std::string>{BlockFolder().path()});
  checked = CheckGraph(*graph, read, *library, module, diagnostics);
}

std::string CheckText::SourceText(const CheckedSubgraph& subgraph, const BoundPort& port) const {
  const Source& source = port.source;
  auto output = [&](NodeOutput from) {
    return fmt::format("{}.{}", subgraph.nodes.at(from.node).node->name, from.output);
  };
  if (auto* value = std::get_if<ConstantValue>(&source)) return ConstantText(module, value->value);
  if (auto* value = std::get_if<AskedValue>(&source)) {
    return "asked " + ConstantText(module, value->otherwise);
  }
  if (auto* from = std::get_if<NodeOutput>(&source)) return output(*from);
  if (auto* from = std::get_if<ParameterRef>(&source)) {
    return std::string(graph->parameters[from->parameter].name);
  }
  if (auto* from = std::get_if<BuiltinRef>(&source)) {
    return std::string(kBuiltinInputs[from->input].name);
  }
  if (auto* from = std::get_if<FunctionInputRef>(&source)) {
    return fmt::format("input {}", subgraph.subgraph->inputs[from->input].name);
  }
  if (auto* from = std::get_if<TextureRef>(&source)) {
    return std::string(graph->textures[from->texture].name);
  }
  if (auto* from = std::get_if<FieldOfTexture>(&source)) {
    return fmt::format("field texture {}", graph->textures[from->texture].name);
  }
  if (auto* from = std::get_if<FieldOfFunction>(&source)) {
    std::string text = fmt::format("field function {}.{}(",
                                   checked->functions[from->function].subgraph->name, from->output);
    for (const auto& p : port.by_parameter) text += p ? fmt::format("{}", *p) : "-";
    return text + ")";
  }
  if (auto* from = std::get_if<FieldOfBlock>(&source)) {
    std::string text =
        fmt::format("field block {}(", checked->default_blocks[from->block].block->name);
    for (const auto& p : port.by_parameter) text += p ? fmt::format("{}", *p) : "-";
    return text + ")";
  }
  if (auto* from = std::get_if<FieldOfNode>(&source)) return "field node " + output(from->source);
  if (auto* from = std::get_if<FieldOfParameter>(&source)) {
    return fmt::format("field parameter {}", graph->parameters[from->parameter].name);
  }
  if (auto* from = std::get_if<FieldOfBuiltin>(&source)) {
    return fmt::format("field input {}", kBuiltinInputs[from->input].name);
  }
  if (auto* from = std::get_if<FieldOfFunctionInput>(&source)) {
    return fmt::format("field function input {}", subgraph.subgraph->inputs[from->input].name);
  }
  return "field " + ConstantText(module, std::get<FieldOfConstant>(source).value);
}

std::string CheckText::PortText(const CheckedSubgraph& subgraph, const BoundPort& port) const {
  std::string text =
      fmt::format("{}:{}", SourceText(subgraph, port), module.types.Text(port.source_type));
  ir::TypeId type = port.type;
  if (module.types.Kind(type) == ir::TypeKind::kField) type = module.types[type].elements[0];
  if (type != port.source_type) text += "->" + module.types.Text(type);
  return text;
}

std::string CheckText::NodeText(const CheckedSubgraph& subgraph, std::string_view name) const {
  for (const CheckedNode& node : subgraph.nodes) {
    if (node.node->name != name) continue;
    std::string text;
    for (size_t i = 0; i < node.inputs.size(); ++i) {
      if (i > 0) text += " ";
      text += node.block ? node.overload->inputs[i].name
                         : std::string(checked->functions[node.function].subgraph->inputs[i].name);
      text += "=" + PortText(subgraph, node.inputs[i]);
    }
    return text;
  }
  return "none";
}

std::string CheckText::NodeText(std::string_view name) const {
  return checked ? NodeText(checked->main, name) : Messages();
}

std::string CheckText::OutputText(std::string_view name) const {
  if (!checked) return Messages();
  for (const CheckedOutput& output : checked->main.outputs) {
    if (output.name == name) return PortText(checked->main, output.value);
  }
  return "none";
}

std::vector<std::string> CheckText::NodeNames() const {
  std::vector<std::string> names;
  if (!checked) return {Messages()};
  for (const CheckedNode& node : checked->main.nodes) names.emplace_back(node.node->name);
  return names;
}

}  // namespace texgraph::graph
