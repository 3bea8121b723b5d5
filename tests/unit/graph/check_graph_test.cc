// SPDX-License-Identifier: Apache-2.0
// What CheckGraph makes of graphs that are right.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <string>
#include <vector>

#include "compiler/graph/conversion.h"
#include "tests/unit/graph/check_testing.h"

namespace texgraph::graph {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// The node "n" of this block with these ports, in a function beside other nodes and parameters.
std::string Node(std::string_view block, std::string_view ports) {
  constexpr std::string_view kText = R"(
      "textures": {{ "brick": {{ "file": "b.png" }}, "stack": {{ "layers": ["a.png", "b.png"] }} }},
      "parameters": {{
        "rows": {{ "type": "int", "value": 4 }}, "size": {{ "type": "float", "value": 0.25 }},
        "tint": {{ "type": "vec3", "value": [1, 0.5, 2] }},
        "live": {{ "type": "float", "value": 3, "binding": "uniform" }},
        "count": {{ "type": "int", "value": 3, "binding": "specialization" }} }},
      "functions": {{
        "dots": {{ "inputs": {{ "uv": "vec2", "k": {{ "type": "float", "value": 2 }} }},
                  "nodes": {{ "i": {{ "block": "t_image", "in": {{ "picture": "brick" }} }} }},
                  "outputs": {{ "color": "i" }} }},
        "relief": {{ "inputs": {{ "level": "float", "q": "vec2" }}, "outputs": {{ "h": "level" }} }},
        "probe": {{
          "nodes": {{
            "f": {{ "block": "t_one" }}, "grid": {{ "block": "t_grid" }},
            "extra": {{ "block": "t_extra" }},
            "c": {{ "block": "t_image", "in": {{ "picture": "brick" }} }},
            "n": {{ "block": "{}", "in": {{ {} }} }} }},
          "outputs": {{ "o": "{}" }} }} }})";
  CheckText check(fmt::format(kText, block, ports, block == "t_grid" ? "n.mask" : "n"));
  if (!check.checked) return check.Messages();
  return check.NodeText(check.checked->functions[check.checked->function_of_graph[2]], "n");
}

TEST(CheckGraph, LiteralsTakeThePortsType) {
  EXPECT_EQ(Node("t_one", R"("x": 2)"), "x=2.0:float");
  EXPECT_EQ(Node("t_one", R"("x": 0.1)"), "x=0.1:float");
  EXPECT_EQ(Node("t_gen", R"("a": [1, 2, 3], "b": 1)"), "a=1.0,2.0,3.0:vec3 b=1.0,1.0,1.0:vec3");
  EXPECT_EQ(Node("t_gen", R"("a": -0, "b": -0.0)"), "a=-0.0:float b=-0.0:float");
}

TEST(CheckGraph, IntegersAndBoolsAreRead) {
  CheckText check(R"("nodes": {
      "a": { "block": "t_whole" },
      "b": { "block": "t_whole", "in": { "v": [-3, 2147483647], "u": 4294967295, "b": true } },
      "c": { "block": "t_whole", "in": { "v": 5 } },
      "m": { "block": "t_matrix", "in": { "m": [[1, 2], [3, 4]] } },
      "x": { "block": "t_gen", "in": { "a": 0, "b": 0 } } })",
                  R"("height": "m")");
  ASSERT_TRUE(check.checked) << check.Messages();
  // Only what an output needs is left, but all is checked.
  EXPECT_THAT(check.NodeNames(), ElementsAre("m"));
  // Rows in the graph, columns in GLSL.
  EXPECT_EQ(check.NodeText("m"), "m=1.0,3.0,2.0,4.0:mat2");
}

TEST(CheckGraph, IntegerPortsTakeWholeNumbers) {
  auto node = [](std::string_view ports) {
    CheckText check(fmt::format(R"("functions": {{ "f": {{ "nodes": {{
        "n": {{ "block": "t_whole", "in": {{ {} }} }} }}, "outputs": {{ "o": "n" }} }} }})",
                                ports));
    return check.checked ? check.NodeText(check.checked->functions[0], "n") : check.Messages();
  };
  EXPECT_EQ(node(""), "v=1,2:ivec2 u=7:uint b=0:bool");
  EXPECT_EQ(node(R"("v": [-3, 2147483647], "u": 4294967295, "b": true)"),
            "v=-3,2147483647:ivec2 u=-1:uint b=1:bool");
  EXPECT_EQ(node(R"("v": 5, "u": 0)"), "v=5,5:ivec2 u=0:uint b=0:bool");
}

TEST(CheckGraph, NegativeNumbersAreNoUints) {
  EXPECT_EQ(Node("t_sign", R"("a": 1)"), "a=1:uint");
  EXPECT_EQ(Node("t_sign", R"("a": -1)"), "a=-1.0:float");
}

TEST(CheckGraph, ReferencesAreConverted) {
  EXPECT_EQ(Node("t_one", R"("x": "f")"), "x=f.0:float");
  EXPECT_EQ(Node("t_one", R"("x": "f.result")"), "x=f.0:float");
  EXPECT_EQ(Node("t_one", R"("x": "grid.mask")"), "x=grid.1:float");
  EXPECT_EQ(Node("t_one", R"("x": "time")"), "x=time:float");
  EXPECT_EQ(Node("t_one", R"("x": "live")"), "x=live:float");
  EXPECT_EQ(Node("t_one", R"("x": "count")"), "x=count:int->float");
  EXPECT_EQ(Node("t_gen", R"("a": "c", "b": "f")"), "a=c.0:vec4 b=f.0:float->vec4");
  EXPECT_EQ(Node("t_gen", R"("a": "count", "b": "position")"), "a=count:int->vec3 b=position:vec3");
  EXPECT_EQ(Node("t_cell", R"("tile": "grid.tile")"), "tile=grid.0:Tile");
  // A return value is what the plain name means, whatever else there is.
  EXPECT_EQ(Node("t_gen", R"("a": "extra", "b": "extra.side")"),
            "a=extra.0:vec2 b=extra.1:float->vec2");
}

TEST(CheckGraph, ConstantParametersBecomeConstants) {
  EXPECT_EQ(Node("t_one", R"("x": "size")"), "x=0.25:float");
  EXPECT_EQ(Node("t_one", R"("x": "rows")"), "x=4.0:float");
  EXPECT_EQ(Node("t_gen", R"("a": "tint", "b": "rows")"), "a=1.0,0.5,2.0:vec3 b=4.0,4.0,4.0:vec3");
  EXPECT_EQ(Node("t_count", R"("n": "rows")"), "n=4:int");
}

TEST(CheckGraph, TemplatePortsTakeWordsAndConstants) {
  EXPECT_EQ(Node("t_pick", R"("mode": "add")"), "x=0.0:float mode=3:int");
  EXPECT_EQ(Node("t_pick", R"("mode": "mix")"), "x=0.0:float mode=0:int");
  EXPECT_EQ(Node("t_pick", R"("mode": 3)"), "x=0.0:float mode=3:int");
  EXPECT_EQ(Node("t_pick", ""), "x=0.0:float mode=0:int");
  EXPECT_EQ(Node("t_count", R"("n": 8)"), "n=8:int");
}

TEST(CheckGraph, DefaultsAreTakenFromThePort) {
  EXPECT_EQ(Node("t_one", ""), "x=0.5:float");
  EXPECT_EQ(Node("t_grid", ""), "uv=uv:vec2");
  EXPECT_EQ(Node("t_image", R"("picture": "brick")"), "picture=brick:sampler2D uv=uv:vec2");
  EXPECT_EQ(Node("t_layers", R"("picture": "stack", "where": "position")"),
            "picture=stack:sampler2DArray where=position:vec3");
}

TEST(CheckGraph, FunctionPortsTakeAnything) {
  EXPECT_EQ(Node("t_warp", R"("image": "brick")"), "image=field texture brick:vec4 uv=uv:vec2");
  EXPECT_EQ(Node("t_warp", R"("image": "c")"), "image=field node c.0:vec4 uv=uv:vec2");
  EXPECT_EQ(Node("t_warp", R"("image": "f")"), "image=field node f.0:float->vec4 uv=uv:vec2");
  EXPECT_EQ(Node("t_warp", R"("image": 0.5)"), "image=field 0.5,0.5,0.5,0.5:vec4 uv=uv:vec2");
  EXPECT_EQ(Node("t_warp", R"("image": [1, 2, 3, 4])"),
            "image=field 1.0,2.0,3.0,4.0:vec4 uv=uv:vec2");
  EXPECT_EQ(Node("t_warp", R"("image": "rows")"), "image=field 4.0,4.0,4.0,4.0:vec4 uv=uv:vec2");
  EXPECT_EQ(Node("t_warp", R"("image": "live")"),
            "image=field parameter live:float->vec4 uv=uv:vec2");
  EXPECT_EQ(Node("t_warp", R"("image": "time")"), "image=field input time:float->vec4 uv=uv:vec2");
  EXPECT_EQ(Node("t_slope", ""), "height=field 1.5:float at=uv:vec2");
  EXPECT_EQ(Node("t_slope", R"("height": "grid.mask")"),
            "height=field node grid.1:float at=uv:vec2");
}

// By name, else in the order of the prototype's parameters where the types are equal.
TEST(CheckGraph, GraphFunctionsAtFunctionPorts) {
  EXPECT_EQ(Node("t_warp", R"("image": "dots")"),
            "image=field function dots.0(0-):vec4 uv=uv:vec2");
  EXPECT_EQ(Node("t_warp", R"("image": "dots.color")"),
            "image=field function dots.0(0-):vec4 uv=uv:vec2");
  // float height(vec2 p, float lod) with the inputs level and q.
  EXPECT_EQ(Node("t_slope", R"("height": "relief")"),
            "height=field function relief.0(10):float at=uv:vec2");
}

// A block as the default of a function port: of its versions the one that takes what the port
// gives.
TEST(CheckGraph, BlocksAsDefaultsOfFunctionPorts) {
  EXPECT_EQ(Node("t_sum", ""), "waves=field block t_waves(0-1):float uv=uv:vec2");
  EXPECT_EQ(Node("t_sum", R"("uv": "position")"),
            "waves=field block t_waves(0-1):float uv=position:vec3");
  EXPECT_EQ(Node("t_sum", R"("waves": 0.5)"), "waves=field 0.5:float uv=uv:vec2");
  EXPECT_EQ(Node("t_waves", ""), "uv=uv:vec2 height=1.0:float faint=asked 0:int");
  EXPECT_EQ(Node("t_waves", R"("faint": 3)"), "uv=uv:vec2 height=1.0:float faint=3:int");
  EXPECT_EQ(Node("t_lost", ""),
            "there is no block 't_wave', the default of 'waves'\n"
            "  port 'waves' of node 'n' is not connected\n");
  EXPECT_EQ(Node("t_odd", ""),
            "'t_waves', the default of 'waves', does not take what this gives: field(vec2) -> float\n"
            "  port 'waves' of node 'n' is not connected\n");
  // No version for a number.
  EXPECT_EQ(Node("t_sum", R"("uv": "time")"),
            "'t_waves', the default of 'waves', does not take what this gives: field(float, int) -> float\n"
            "  port 'waves' of node 'n' is not connected\n");
}

TEST(CheckGraph, GraphFunctionsAreBlocks) {
  CheckText check(R"(
      "functions": {
        "outer": { "inputs": { "a": "float" }, "nodes": { "n": { "block": "inner", "in": { "x": "a" } } },
                   "outputs": { "o": "n", "p": "a" } },
        "inner": { "inputs": { "x": "float", "y": { "type": "vec2", "value": 3 }, "t": { "type": "int", "value": 1 } },
                   "nodes": { "m": { "block": "t_gen", "in": { "a": "x", "b": "y" } },
                              "unused": { "block": "t_one" } },
                   "outputs": { "only": "m" } } },
      "nodes": { "n": { "block": "outer", "in": { "a": 2 } },
                 "g": { "block": "t_gen", "in": { "a": "n.p", "b": "n.o" } },
                 "h": { "block": "t_extra", "in": { "uv": "g" } } })",
                  R"("height": "h.side")");
  ASSERT_TRUE(check.checked) << check.Messages();
  const CheckedGraph& checked = *check.checked;
  // Callees come first.
  EXPECT_EQ(checked.functions[0].subgraph->name, "inner");
  EXPECT_EQ(checked.functions[1].subgraph->name, "outer");
  EXPECT_THAT(checked.function_of_graph, ElementsAre(1, 0));
  EXPECT_EQ(checked.functions[0].nodes.size(), 1u);
  EXPECT_THAT(checked.functions[0].input_types, ElementsAre(ir::kFloat, ir::kVec2, ir::kInt));
  EXPECT_FALSE(checked.functions[0].input_defaults[0].valid());
  EXPECT_EQ(check.NodeText(checked.functions[0], "m"), "a=input x:float->vec2 b=input y:vec2");
  EXPECT_EQ(check.NodeText(checked.functions[1], "n"), "x=input a:float y=3.0,3.0:vec2 t=1:int");
  EXPECT_EQ(checked.main.nodes[0].function, 1u);
  EXPECT_EQ(check.NodeText("n"), "a=2.0:float");
  EXPECT_EQ(check.NodeText("g"), "a=n.1:float->vec2 b=n.0:vec2");
}

// A function's input that is called like a built-in input is what defaults mean inside it.
TEST(CheckGraph, FunctionInputsReplaceBuiltinInputs) {
  CheckText check(R"(
      "functions": { "f": { "inputs": { "uv": "vec2" }, "nodes": { "g": { "block": "t_extra" } },
                            "outputs": { "o": "g" } },
                     "k": { "inputs": { "uv": "vec3" }, "nodes": { "g": { "block": "t_extra" } },
                            "outputs": { "o": "g" } } })");
  ASSERT_TRUE(check.checked) << check.Messages();
  EXPECT_EQ(check.NodeText(check.checked->functions[0], "g"), "uv=input uv:vec2");
  // Of another type, it cannot be meant.
  EXPECT_EQ(check.NodeText(check.checked->functions[1], "g"), "uv=uv:vec2");
}

TEST(CheckGraph, ChoosesTheOverloadWithTheFewestConversions) {
  auto type = [](std::string_view block, std::string_view ports) {
    CheckText check(fmt::format(R"("functions": {{ "f": {{
        "nodes": {{ "one": {{ "block": "t_one" }}, "n": {{ "block": "{}", "in": {{ {} }} }} }},
        "outputs": {{ "o": "n" }} }} }})",
                                block, ports));
    if (!check.checked) return check.Messages();
    return check.module.types.Text(check.checked->functions[0].outputs[0].value.type);
  };
  EXPECT_EQ(type("t_kind", R"("a": 1)"), "int");
  EXPECT_EQ(type("t_kind", R"("a": 1.0)"), "float");
  EXPECT_EQ(type("t_kind", R"("a": [1, 2, 3])"), "vec3");
  EXPECT_EQ(type("t_kind", R"("a": "one")"), "float");
  EXPECT_EQ(type("t_kind", R"("a": "position")"), "vec3");
  EXPECT_EQ(type("t_kind", ""), "int");  // all fit: the first
  EXPECT_EQ(type("t_gen", R"("a": 1, "b": 2)"), "float");
  EXPECT_EQ(type("t_gen", R"("a": 1, "b": "uv")"), "vec2");
  EXPECT_EQ(type("t_gen", R"("a": "normal", "b": "time")"), "vec3");
  EXPECT_EQ(type("t_gen", R"("a": [1, 2, 3, 4], "b": 1)"), "vec4");
  EXPECT_EQ(type("t_ports", R"("a": 1)"), "float");
  EXPECT_EQ(type("t_ports", R"("a": 1, "b": 1)"), "vec2");
}

// A word at a template port, and what stands behind it, leave no doubt about the types.
TEST(CheckGraph, WordsDoNotHideTypes) {
  CheckText check(R"("nodes": { "n": { "block": "t_pick", "in": { "mode": "add" } },
                               "add": { "block": "t_one", "in": { "x": "n" } } })",
                  R"("height": "add")");
  EXPECT_EQ(check.OutputText("height"), "add.0:float");
  EXPECT_THAT(check.NodeNames(), ElementsAre("n", "add"));
}

// A parameter of the word's name is not what is meant, whatever its type.
TEST(CheckGraph, WordsGoBeforeNamesInOverloads) {
  CheckText check(R"("parameters": { "add": { "type": "vec3", "value": [1, 2, 3] } },
                     "nodes": { "n": { "block": "t_either", "in": { "x": 1, "mode": "add" } } })",
                  R"("height": "n")");
  ASSERT_TRUE(check.checked) << check.Messages();
  EXPECT_EQ(check.NodeText(check.checked->main, "n"), "x=1.0:float mode=3:int");
}

TEST(CheckGraph, NodesComeAfterWhatTheyNeed) {
  CheckText check(R"("nodes": {
      "last": { "block": "t_gen", "in": { "a": "warp", "b": "a" } },
      "warp": { "block": "t_warp", "in": { "image": "b" } },
      "unused": { "block": "t_one", "in": { "x": "a" } },
      "a": { "block": "t_one" },
      "b": { "block": "t_gen", "in": { "a": 1, "b": "a" } } })",
                  R"("color": "last")");
  EXPECT_THAT(check.NodeNames(), ElementsAre("a", "b", "warp", "last"));
  EXPECT_EQ(check.NodeText("warp"), "image=field node b.0:float->vec4 uv=uv:vec2");
  EXPECT_EQ(check.OutputText("color"), "last.0:vec4");
}

TEST(CheckGraph, OutputsAreConverted) {
  CheckText check(R"("parameters": { "p": { "type": "int", "value": 2 } },
                     "nodes": { "f": { "block": "t_one" } })",
                  R"("color": "f", "normal": [0, 0, 1], "height": "p", "roughness": "time")");
  EXPECT_EQ(check.OutputText("color"), "f.0:float->vec4");
  EXPECT_EQ(check.OutputText("normal"), "0.0,0.0,1.0:vec3");
  EXPECT_EQ(check.OutputText("height"), "2.0:float");
  EXPECT_EQ(check.OutputText("roughness"), "time:float");
}

TEST(CheckGraph, SettingsReplaceValues) {
  constexpr std::string_view kText = R"("parameters": {
      "n": { "type": "int", "value": 2, "range": [1, 9] }, "c": { "type": "vec3", "value": [0, 0, 0] },
      "b": { "type": "bool", "value": false }, "u": { "type": "float", "value": 1, "binding": "uniform" } },
      "nodes": { "k": { "block": "t_count", "in": { "n": "n" } } })";
  CheckText check(kText, R"("height": "k", "normal": "c")",
                  {"n=3", "c=[1, 0.5, 0]", "b=true", "u=7", "n=5"});
  ASSERT_TRUE(check.checked) << check.Messages();
  EXPECT_EQ(check.NodeText("k"), "n=5:int");  // the last one
  EXPECT_EQ(check.OutputText("normal"), "1.0,0.5,0.0:vec3");
  EXPECT_EQ(check.module.Words(check.checked->parameters[2].value)[0], 1u);
  EXPECT_EQ(std::bit_cast<float>(check.module.Words(check.checked->parameters[3].value)[0]), 7.0f);
}

TEST(CheckGraph, SettingsAreReadAsLiterals) {
  Sources sources;
  Diagnostics diagnostics;
  auto settings = ReadSettings({"a=3", "b=-0.5", "c=word", "d=\"a\\u0062\"", "e=[1, 2]", "f=false"},
                               sources, diagnostics);
  ASSERT_EQ(settings.size(), 6u) << Messages(diagnostics);
  EXPECT_TRUE(settings[0].value.is_integer);
  EXPECT_EQ(settings[1].value.numbers[0], -0.5);
  EXPECT_EQ(settings[2].value.text, "word");
  EXPECT_EQ(settings[3].value.text, "ab");
  EXPECT_THAT(settings[4].value.numbers, ElementsAre(1, 2));
  EXPECT_EQ(settings[5].value.kind, Argument::Kind::kBool);
  EXPECT_EQ(settings[4].range.end, 1u);
  EXPECT_EQ(sources.Locate(settings[4].value.range.source, settings[4].value.range.begin).column,
            3u);
}

TEST(CheckGraph, ConversionsAreIntToFloatAndScalarToVector) {
  const std::vector<ir::TypeId> types = {ir::kBool,  ir::kInt,   ir::kUint, ir::kFloat,
                                         ir::kVec2,  ir::kVec3,  ir::kVec4, ir::kIvec2,
                                         ir::kUvec3, ir::kBvec2, ir::kMat2, ir::kSampler2D};
  for (ir::TypeId from : types) {
    for (ir::TypeId to : types) {
      std::optional<int> expected;
      if (from == to) expected = 0;
      if (from == ir::kInt && to == ir::kFloat) expected = 1;
      bool float_vector = to == ir::kVec2 || to == ir::kVec3 || to == ir::kVec4;
      if (from == ir::kFloat && float_vector) expected = 1;
      if (from == ir::kInt && float_vector) expected = 2;
      if (from == ir::kInt && to == ir::kIvec2) expected = 1;
      if (from == ir::kUint && to == ir::kUvec3) expected = 1;
      if (from == ir::kBool && to == ir::kBvec2) expected = 1;
      EXPECT_EQ(ConversionCost(from, to), expected) << from.index << " " << to.index;
    }
  }
}

// The blocks that messages name are blocks of the library and take and give the types.
TEST(CheckGraph, ConvertingBlocksConvert) {
  CheckText check("\"nodes\": {}");
  blocks::Library& library = *check.library;
  const ir::Types& types = check.module.types;
  std::vector<ir::TypeId> all = {ir::kBool, ir::kInt,  ir::kUint, ir::kFloat,
                                 ir::kVec2, ir::kVec3, ir::kVec4, library.FindType("Tile")};
  size_t pairs = 0;
  for (ir::TypeId from : all) {
    for (ir::TypeId to : all) {
      std::string text = ConvertingBlocks(from, to, types, library);
      pairs += !text.empty();
      for (size_t at = text.find('\''); at != std::string::npos; at = text.find('\'', at)) {
        std::string name = text.substr(at + 1, text.find('\'', at + 1) - at - 1);
        at += name.size() + 2;
        const blocks::Block* block = library.Find(name);
        ASSERT_NE(block, nullptr) << name;
        bool converts = false;
        for (const blocks::Overload& overload : block->overloads) {
          bool gives = false, takes = false;
          for (const blocks::Port& port : overload.outputs) gives = gives || port.type == to;
          // Of vectors to be put together, the components.
          for (const blocks::Port& port : overload.inputs) {
            takes = takes || port.type == from || name.starts_with("combine");
          }
          converts = converts || (gives && takes);
        }
        EXPECT_TRUE(converts) << name << " " << types.Text(from) << " " << types.Text(to);
      }
    }
  }
  EXPECT_EQ(pairs, 17u);
}

TEST(CheckGraph, LongChainsAreLinear) {
  auto seconds = [](int count) {
    std::string nodes = "\"nodes\": {\"n0\": {\"block\": \"t_one\"}";
    // The document's order is the wrong way round, which is the slower case.
    for (int i = count; i > 0; --i) {
      nodes += fmt::format(
          ",\n\"n{}\": {{\"block\": \"t_gen\", \"in\": {{\"a\": \"n{}\", \"b\": 1}}}}", i, i - 1);
    }
    double start = CpuSeconds();
    CheckText check(nodes + "}", fmt::format("\"height\": \"n{}\"", count));
    double time = CpuSeconds() - start;
    EXPECT_EQ(check.NodeNames().size(), static_cast<size_t>(count) + 1);
    return time;
  };
  seconds(1000);
  EXPECT_LT(seconds(50'000), 5.0);  // about 0.2 s; quadratic would be minutes
}

}  // namespace
}  // namespace texgraph::graph
