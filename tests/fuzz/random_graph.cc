// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/random_graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <random>

#include "compiler/textures/image.h"
#include "tests/fuzz/random_nodes.h"

namespace texgraph::fuzz {
namespace {

using blocks::Overload;
using blocks::Port;

struct ImageFile {
  const char* name;
  uint32_t width, height;
  uint8_t channels;
  uint32_t smoothness;  // in pixels; 0: noise
};
// All kinds of sizes; the first two and the last are equally large, for array textures.
constexpr ImageFile kImages[] = {{"noise.png", 8, 8, 4, 0},
                                 {"soft.png", 8, 8, 3, 4},
                                 {"odd.png", 5, 7, 1, 2},
                                 {"wide.png", 16, 4, 2, 3},
                                 {"dots.png", 8, 8, 4, 1}};
constexpr const char* kEqualFiles[] = {"noise.png", "soft.png", "dots.png"};

// Words of GLSL, and what it keeps for itself, for what no program binds.
constexpr const char* kTakenNames[] = {"dot", "all",    "round",   "distance",    "float", "main",
                                       "if",  "sample", "texture", "gl_Position", "a__b",  "dot2"};

// Names as people choose them, and names that the shader has for things of its own: of blocks and
// their parameters and variables, of words of template ports, of what the printer adds.
constexpr const char* kNames[] = {
    "base",     "color", "out_color",   "tile",    "grid",   "hash",   "random",    "result",
    "value",    "uv2",   "p",           "local",   "seed",   "layer",  "noise_2",   "brick",
    "linear",   "add",   "multiply",    "stretch", "cover",  "image2", "size",      "t",
    "a",        "b",     "x",           "scale",   "amount", "image",  "checker",   "blend",
    "coverage", "Wall",  "k",           "i",       "tex",    "uv_dx",  "uv_dy",     "main_node",
    "dx",       "dy",    "footprint_x", "mask",    "over",   "angle",  "position2", "corner"};

constexpr const char* kDescriptions[] = {"plain words",
                                         "*/ } void main() {",
                                         "#error no\n#define vec4 no",
                                         "\"quotes\" and \\ slashes",
                                         "ends in a slash \\",
                                         "\xc3\xa4\xe2\x82\xac",
                                         "//",
                                         "?\?/"};

template <class T, size_t n>
const T& OneOf(const T (&list)[n], std::mt19937& random) {
  return list[random() % n];
}

class Generator {
 public:
  Generator(uint32_t seed, const RandomGraphOptions& options) : options_(options), random_(seed) {}

  RandomGraphText Run() {
    Tree root = Tree::Object();
    root.Set("texgraph", Tree::Raw("1"));
    if (OneIn(4)) root.Set("name", Tree::String(FreshName()));
    MaybeDescribe(root);
    RandomNodes nodes(random_, functions_, shadowed_, result_.blocks);
    for (const BuiltinInput& input : kBuiltinInputs) nodes.AddThing(BuiltinThing(input));
    MakeTextures(root, nodes);
    MakeParameters(root, nodes);
    globals_ = nodes.things();
    MakeFunctions(root, nodes);
    Tree section = Tree::Object();
    MakeNodes(nodes, 1 + Below(options_.nodes), Scope::kNode, section);
    if (!section.empty()) root.Set("nodes", std::move(section));
    root.Set("outputs", MakeOutputs(nodes));
    std::shuffle(root.children.begin(), root.children.end(), random_);
    result_.format = OneIn(4) ? graph::DocumentFormat::kYaml : graph::DocumentFormat::kJson;
    result_.text = PrintTree(root, result_.format);
    result_.tree = std::move(root);
    return std::move(result_);
  }

 private:
  uint32_t Below(uint32_t n) { return static_cast<uint32_t>(random_() % n); }
  bool OneIn(uint32_t n) { return Below(n) == 0; }

  // A name that nothing else in its scope has. Nodes of functions may be called like nodes of the
  // graph and of other functions.
  enum class Scope { kGraph, kFunction, kNode };
  std::string FreshName(Scope scope = Scope::kGraph) {
    std::set<std::string>& own = scope == Scope::kFunction ? locals_ : names_;
    std::string name =
        scope != Scope::kGraph && OneIn(8) ? OneOf(kTakenNames, random_) : OneOf(kNames, random_);
    const auto taken = [&] {
      if (names_.contains(name)) return true;
      return scope == Scope::kGraph ? all_locals_.contains(name) : own.contains(name);
    };
    while (taken()) name = fmt::format("{}{}", name, Below(10));
    own.insert(name);
    if (scope == Scope::kFunction) all_locals_.insert(name);
    return name;
  }

  void MaybeDescribe(Tree& tree) {
    if (OneIn(6)) tree.Set("description", Tree::String(OneOf(kDescriptions, random_)));
  }

  static Thing BuiltinThing(const BuiltinInput& input) {
    Thing thing;
    thing.reference = input.name;
    thing.type = BlockCatalog::Instance().types().Find(input.type);
    thing.varies = input.name != "time";
    return thing;
  }

  // A few rows of small numbers, or as many lists.
  void MakeMap(Tree& texture) {
    Tree& rows = texture.Set(OneIn(3) ? "lists" : "map", Tree::Array());
    const uint32_t width = 1 + Below(4);
    for (uint32_t y = 0, height = 1 + Below(4); y < height; ++y) {
      Tree row = Tree::Array();
      for (uint32_t x = 0; x < width; ++x) {
        row.Add(Tree::Raw(std::to_string(static_cast<int>(Below(6)) - 1)));
      }
      rows.Add(std::move(row));
    }
    if (OneIn(2)) texture.Set("binding", Tree::String(OneIn(3) ? "texture" : "constant"));
  }

  void MakeTextures(Tree& root, RandomNodes& nodes) {
    Tree section = Tree::Object();
    for (uint32_t i = 0, n = 1 + Below(3); i < n; ++i) {
      Tree texture = Tree::Object();
      Thing thing;
      thing.kind = Thing::Kind::kTexture;
      thing.reference = FreshName();
      thing.type = OneIn(5) ? ir::kSampler2DArray : ir::kSampler2D;
      if (thing.type == ir::kSampler2D && OneIn(4)) {
        MakeMap(texture);
        section.Set(thing.reference, std::move(texture));
        nodes.AddThing(std::move(thing));
        continue;
      }
      if (thing.type == ir::kSampler2D) {
        texture.Set("file", Tree::String(OneOf(kImages, random_).name));
      } else {
        Tree& layers = texture.Set("layers", Tree::Array());
        for (uint32_t l = 0, m = 1 + Below(3); l < m; ++l) {
          layers.Add(Tree::String(OneOf(kEqualFiles, random_)));
        }
        if (OneIn(3)) {
          texture.Set("pack", Tree::String("volume"));
          thing.type = ir::kSampler3D;
        }
      }
      constexpr const char* kWraps[] = {"repeat", "clamp", "mirror"};
      constexpr const char* kSpaces[] = {"srgb", "linear", "data"};
      constexpr const char* kFilters[] = {"linear", "nearest"};
      if (OneIn(2)) texture.Set("color_space", Tree::String(OneOf(kSpaces, random_)));
      if (OneIn(3)) texture.Set("filter", Tree::String(OneOf(kFilters, random_)));
      if (OneIn(3)) texture.Set("wrap", Tree::String(OneOf(kWraps, random_)));
      if (OneIn(5)) texture.Set("wrap_u", Tree::String(OneOf(kWraps, random_)));
      if (OneIn(5)) texture.Set("wrap_v", Tree::String(OneOf(kWraps, random_)));
      if (OneIn(4)) texture.Set("mipmaps", Tree::Bool(OneIn(2)));
      if (OneIn(5)) texture.Set("max_level", Tree::Raw(std::to_string(Below(4))));
      section.Set(thing.reference, std::move(texture));
      nodes.AddThing(std::move(thing));
    }
    root.Set("textures", std::move(section));
  }

  void MakeParameters(Tree& root, RandomNodes& nodes) {
    constexpr const char* kTypes[] = {"float", "float", "int",  "int",   "vec2",  "vec3",
                                      "vec4",  "bool",  "uint", "ivec2", "ivec3", "ivec4"};
    Tree section = Tree::Object();
    for (uint32_t i = 0, n = Below(5); i < n; ++i) {
      Thing thing;
      thing.reference = FreshName();
      Tree parameter = Tree::Object();
      Port port;  // what the value must be
      const char* type = OneOf(kTypes, random_);
      thing.type = port.type = BlockCatalog::Instance().types().Find(type);
      parameter.Set("type", Tree::String(type));
      const bool has_range = !ir::IsBool(port.type) && OneIn(2);
      if (has_range) {
        port.minimum = thing.minimum = OneIn(2) ? 0 : 1;
        port.maximum = thing.maximum = *port.minimum + (OneIn(2) ? 1 : 15);
        thing.bounded = true;
        Tree& range = parameter.Set("range", Tree::Array());
        range.Add(Tree::Raw(fmt::format("{}", *port.minimum)));
        range.Add(Tree::Raw(fmt::format("{}", *port.maximum)));
      }
      thing.literal = *nodes.Literal(port);
      parameter.Set("value", nodes.TreeOf(thing.literal));
      const uint32_t binding = Below(4);
      if (binding == 0) parameter.Set("binding", Tree::String("uniform"));
      const bool specialization = binding == 1 && ir::IsScalar(port.type);
      if (specialization) parameter.Set("binding", Tree::String("specialization"));
      if (binding != 0 && !specialization) thing.kind = Thing::Kind::kConstant;
      if (OneIn(4)) parameter.Set("label", Tree::String(OneOf(kDescriptions, random_)));
      section.Set(thing.reference, std::move(parameter));
      nodes.AddThing(std::move(thing));
    }
    if (!section.empty()) root.Set("parameters", std::move(section));
  }

  // The nodes stand in any order in the text.
  void MakeNodes(RandomNodes& nodes, uint32_t count, Scope scope, Tree& section) {
    for (uint32_t i = 0; i < count; ++i) {
      const std::string name = FreshName(scope);
      std::optional<Tree> node = nodes.MakeNode(name);
      if (!node) continue;
      MaybeDescribe(*node);
      section.Set(name, std::move(*node));
    }
    if (OneIn(2)) std::shuffle(section.children.begin(), section.children.end(), random_);
  }

  void MakeFunctions(Tree& root, RandomNodes& nodes) {
    Tree section = Tree::Object();
    for (uint32_t i = 0, n = Below(options_.functions + 1); i < n; ++i) {
      // A function with the name of a block stands in its place, in all of the graph.
      GraphFunction function;
      do {
        function.name = FreshName();
      } while (result_.blocks.contains(function.name));
      shadowed_.insert(function.name);
      std::optional<Tree> tree = MakeFunction(function);
      if (!tree) continue;
      section.Set(function.name, std::move(*tree));
      functions_.push_back(std::move(function));
      const GraphFunction& made = functions_.back();
      // From now on it can stand at function ports, of the graph and of later functions.
      RandomNodes things(random_, functions_, shadowed_, result_.blocks);
      Thing like;
      like.kind = Thing::Kind::kFunction;
      like.function = &made.signature;
      like.varies = true;
      things.AddOutputs(made.name, made.signature.outputs, like);
      for (const Thing& thing : things.things()) {
        globals_.push_back(thing);
        nodes.AddThing(thing);
      }
    }
    if (!section.empty()) root.Set("functions", std::move(section));
  }

  std::optional<Tree> MakeFunction(GraphFunction& function) {
    constexpr const char* kTypes[] = {"float", "vec2", "vec3", "vec4", "int",
                                      "Tile",  "bool", "uint", "ivec2"};
    Tree tree = Tree::Object();
    MaybeDescribe(tree);
    RandomNodes nodes(random_, functions_, shadowed_, result_.blocks);
    std::vector<std::pair<std::string, std::string>> inputs;
    locals_.clear();
    if (!OneIn(4)) inputs.emplace_back("uv", OneIn(8) ? "vec3" : "vec2");
    if (OneIn(8)) inputs.emplace_back("time", "float");
    for (uint32_t i = 0, n = Below(3); i < n; ++i) {
      inputs.emplace_back(FreshName(Scope::kFunction), OneOf(kTypes, random_));
    }
    for (const Thing& thing : globals_) {
      const bool replaced = std::ranges::any_of(
          inputs, [&](const auto& input) { return input.first == thing.reference; });
      if (!replaced) nodes.AddThing(thing);
    }
    Tree& section = tree.Set("inputs", Tree::Object());
    for (const auto& [name, type] : inputs)
      section.Set(name, MakeInput(name, type, nodes, function));
    Tree body = Tree::Object();
    MakeNodes(nodes, 1 + Below(options_.function_nodes), Scope::kFunction, body);
    if (!body.empty()) tree.Set("nodes", std::move(body));
    Tree outputs = MakeFunctionOutputs(nodes, function);
    if (outputs.empty()) return std::nullopt;
    tree.Set("outputs", std::move(outputs));
    return tree;
  }

  Tree MakeInput(const std::string& name, const std::string& type, RandomNodes& nodes,
                 GraphFunction& function) {
    Port port;
    port.name = name;
    port.type = BlockCatalog::Instance().types().Find(type);
    Thing thing;
    thing.reference = name;
    thing.type = port.type;
    thing.varies = true;
    nodes.AddThing(thing);
    Tree tree = Tree::String(type);
    std::optional<graph::Argument> value = OneIn(2) ? nodes.Literal(port) : std::nullopt;
    if (value) {
      tree = Tree::Object();
      tree.Set("type", Tree::String(type));
      tree.Set("value", nodes.TreeOf(*value));
      port.default_value = ir::ConstId(0);  // there is one; which does not matter here
    }
    function.signature.inputs.push_back(std::move(port));
    return tree;
  }

  Tree MakeFunctionOutputs(RandomNodes& nodes, GraphFunction& function) {
    constexpr const char* kOutputNames[] = {"color", "result", "mask", "tile", "height", "uv"};
    Tree outputs = Tree::Object();
    std::vector<const Thing*> values;
    for (const Thing& thing : nodes.things()) {
      if (thing.kind == Thing::Kind::kValue || thing.kind == Thing::Kind::kConstant) {
        values.push_back(&thing);
      }
    }
    for (uint32_t i = 0, n = 1 + Below(3); i < n && !values.empty(); ++i) {
      const std::string name = OneOf(kOutputNames, random_);
      const auto has_name = [&](const auto& child) { return child.first == name; };
      if (std::ranges::any_of(outputs.children, has_name)) continue;
      const auto count = static_cast<uint32_t>(values.size());
      const Thing& thing = *values[count - 1 - Below(std::min(count, 5u))];
      outputs.Set(name, Tree::String(thing.reference));
      Port port;
      port.name = name;
      port.type = thing.type;
      function.signature.outputs.push_back(std::move(port));
    }
    return outputs;
  }

  Tree MakeOutputs(RandomNodes& nodes) {
    Tree outputs = Tree::Object();
    for (const graph::BuiltinOutput& output : graph::kBuiltinOutputs) {
      if (!outputs.empty() && !OneIn(3)) continue;
      Port port;
      port.name = output.name;
      port.type = BlockCatalog::Instance().types().Find(output.type);
      PortArgument argument;
      if (std::optional<Tree> tree = nodes.MakeArgument(port, 9, argument)) {
        outputs.Set(output.name, std::move(*tree));
      }
    }
    return outputs;
  }

  const RandomGraphOptions& options_;
  std::mt19937 random_;
  RandomGraphText result_;
  std::set<std::string> names_;       // of the graph
  std::set<std::string> locals_;      // of the function that is being made
  std::set<std::string> all_locals_;  // of all functions
  std::deque<GraphFunction> functions_;
  std::set<std::string> shadowed_;  // their names
  std::deque<Thing> globals_;       // what functions can name of the graph
};

uint8_t ImageValue(const ImageFile& file, uint32_t x, uint32_t y, uint32_t channel) {
  if (file.smoothness == 0) {
    uint32_t bits = (x * 73856093u) ^ (y * 19349663u) ^ (channel * 83492791u);
    bits = (bits ^ (bits >> 13)) * 0x5bd1e995u;
    return static_cast<uint8_t>(bits >> 20);
  }
  const uint32_t period = 4 * file.smoothness;
  const uint32_t phase = (x + 2 * y + channel * file.smoothness) % period;
  return static_cast<uint8_t>(255 * std::min(phase, period - phase) / (2 * file.smoothness));
}

}  // namespace

std::string RandomGraphText::FileName(uint32_t seed) const {
  return fmt::format("graph_{}.{}", seed, format == graph::DocumentFormat::kYaml ? "yaml" : "json");
}

RandomGraphText RandomGraph(uint32_t seed, const RandomGraphOptions& options) {
  return Generator(seed, options).Run();
}

std::string PrintTree(const Tree& tree, graph::DocumentFormat format) {
  return format == graph::DocumentFormat::kYaml ? PrintYaml(tree) : PrintJson(tree);
}

std::set<std::string> UsableBlocks() {
  std::set<std::string> names;
  for (const blocks::Block* block : BlockCatalog::Instance().blocks()) names.insert(block->name);
  return names;
}

bool WriteGraphImages(const std::string& folder) {
  for (const ImageFile& file : kImages) {
    textures::Image image;
    image.width = file.width;
    image.height = file.height;
    image.channels = file.channels;
    for (uint32_t y = 0; y < file.height; ++y) {
      for (uint32_t x = 0; x < file.width; ++x) {
        for (uint32_t c = 0; c < file.channels; ++c)
          image.pixels.push_back(ImageValue(file, x, y, c));
      }
    }
    std::optional<std::string> png = textures::EncodePng(image);
    if (!png) return false;
    std::ofstream out(folder + "/" + file.name, std::ios::binary);
    out << *png;
    if (!out.flush()) return false;
  }
  return true;
}

}  // namespace texgraph::fuzz
