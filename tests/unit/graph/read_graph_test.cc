// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "compiler/base/text.h"
#include "compiler/graph/names.h"
#include "tests/unit/graph/graph_testing.h"

namespace texgraph::graph {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::string_view kWhole = R"({
  "$schema": "graph.schema.json",
  "texgraph": 1,
  "name": "wall",
  "description": "a wall",
  "textures": {
    "brick": { "file": "brick.png" },
    "stains": { "layers": ["a.png", "b.png"], "color_space": "data", "filter": "nearest",
                "wrap": "clamp", "wrap_v": "mirror", "mipmaps": false, "max_level": 4 }
  },
  "parameters": {
    "rows": { "type": "int", "value": 12, "range": [1, 64], "label": "Rows", "help": "how many",
              "unit": "bricks" },
    "tint": { "type": "vec3", "value": [1, 0.5, 1], "binding": "uniform" },
    "fast": { "type": "bool", "value": true, "binding": "specialization" }
  },
  "functions": {
    "spots": {
      "description": "round spots",
      "inputs": { "uv": "vec2", "scale": { "type": "float", "value": 2 } },
      "nodes": { "cells": { "block": "checker", "in": { "uv": "uv", "scale": "scale" } } },
      "outputs": { "color": "cells" }
    }
  },
  "nodes": {
    "grid": { "block": "brick_grid", "in": { "rows": "rows", "matrix": [[1, 2], [3, 4.5]] } },
    "face": { "block": "layer", "description": "bricks" }
  },
  "outputs": { "color": "face", "height": 0.5 }
})";

TEST(ReadGraph, ReadsTheWholeFormat) {
  ReadGraphText read{std::string(kWhole)};
  ASSERT_TRUE(read.graph) << read.Messages();
  const Graph& graph = *read.graph;
  EXPECT_EQ(graph.name, "wall");
  EXPECT_EQ(graph.description, "a wall");
  ASSERT_EQ(graph.textures.size(), 2u);
  EXPECT_EQ(graph.textures[0].name, "brick");
  EXPECT_THAT(graph.textures[0].files, ElementsAre("brick.png"));
  EXPECT_FALSE(graph.textures[0].is_array);
  EXPECT_EQ(graph.textures[0].color_space, ColorSpace::kSrgb);
  EXPECT_EQ(graph.textures[0].wrap_u, TextureWrap::kRepeat);
  EXPECT_TRUE(graph.textures[0].mipmaps);
  EXPECT_EQ(graph.textures[0].max_level, std::nullopt);
  EXPECT_THAT(graph.textures[1].files, ElementsAre("a.png", "b.png"));
  EXPECT_TRUE(graph.textures[1].is_array);
  EXPECT_EQ(graph.textures[1].color_space, ColorSpace::kLinear);
  EXPECT_EQ(graph.textures[1].filter, TextureFilter::kNearest);
  EXPECT_EQ(graph.textures[1].wrap_u, TextureWrap::kClamp);
  EXPECT_EQ(graph.textures[1].wrap_v, TextureWrap::kMirror);
  EXPECT_FALSE(graph.textures[1].mipmaps);
  EXPECT_EQ(graph.textures[1].max_level, 4);
  ASSERT_EQ(graph.parameters.size(), 3u);
  EXPECT_EQ(graph.parameters[0].type, "int");
  EXPECT_EQ(graph.parameters[0].minimum, 1);
  EXPECT_EQ(graph.parameters[0].maximum, 64);
  EXPECT_EQ(graph.parameters[0].label, "Rows");
  EXPECT_EQ(graph.parameters[0].help, "how many");
  EXPECT_EQ(graph.parameters[0].unit, "bricks");
  EXPECT_EQ(graph.parameters[0].binding, Binding::kConstant);
  EXPECT_TRUE(graph.parameters[0].value.is_integer);
  EXPECT_EQ(graph.parameters[1].binding, Binding::kUniform);
  EXPECT_THAT(graph.parameters[1].value.numbers, ElementsAre(1, 0.5, 1));
  EXPECT_FALSE(graph.parameters[1].value.is_integer);
  EXPECT_EQ(graph.parameters[2].binding, Binding::kSpecialization);
  EXPECT_TRUE(graph.parameters[2].value.boolean);
}

TEST(ReadGraph, ReadsFunctionsNodesAndOutputs) {
  ReadGraphText read{std::string(kWhole)};
  ASSERT_TRUE(read.graph) << read.Messages();
  const Graph& graph = *read.graph;
  ASSERT_EQ(graph.functions.size(), 1u);
  const Subgraph& spots = graph.functions[0];
  EXPECT_EQ(spots.name, "spots");
  ASSERT_EQ(spots.inputs.size(), 2u);
  EXPECT_EQ(spots.inputs[0].name, "uv");
  EXPECT_EQ(spots.inputs[0].type, "vec2");
  EXPECT_FALSE(spots.inputs[0].value);
  EXPECT_EQ(spots.inputs[1].type, "float");
  EXPECT_THAT(spots.inputs[1].value->numbers, ElementsAre(2));
  EXPECT_EQ(spots.nodes[0].block, "checker");
  EXPECT_EQ(spots.outputs[0].argument.text, "cells");
  ASSERT_EQ(graph.main.nodes.size(), 2u);
  EXPECT_EQ(graph.main.nodes[0].name, "grid");
  EXPECT_EQ(graph.main.nodes[0].inputs[0].port, "rows");
  EXPECT_EQ(graph.main.nodes[0].inputs[0].argument.text, "rows");
  EXPECT_THAT(graph.main.nodes[0].inputs[1].argument.numbers, ElementsAre(1, 2, 3, 4.5));
  EXPECT_THAT(graph.main.nodes[1].inputs, IsEmpty());
  EXPECT_EQ(graph.main.outputs[1].name, "height");
  EXPECT_EQ(graph.main.outputs[1].argument.kind, Argument::Kind::kNumber);
}

TEST(ReadGraph, TheNameComesFromTheFile) {
  constexpr std::string_view kText = R"({"texgraph": 1, "outputs": {"height": 1}})";
  auto name = [&](std::string file) {
    ReadGraphText read{std::string(kText), DocumentFormat::kJson, std::move(file)};
    return read.graph ? read.graph->name : read.Messages();
  };
  EXPECT_EQ(name("graphs/brick_wall.json"), "brick_wall");
  EXPECT_EQ(name("a.b/brick-wall.v2.jsonc"), "brick_wall");
  EXPECT_EQ(name("/x/--a__b--.yaml"), "a_b");
  EXPECT_EQ(name("3d.json"), "graph_3d");
  EXPECT_EQ(name("sample.json"), "graph_sample");
  EXPECT_EQ(name("<stdin>"), "stdin");
  EXPECT_EQ(name("\xc3\xa4.json"), "graph");
  EXPECT_EQ(name(std::string(100, 'x')).size(), kMaxNameLength);
}

TEST(ReadGraph, YamlGivesTheSameGraph) {
  ReadGraphText json{std::string(kWhole)};
  // JSON is YAML.
  ReadGraphText yaml{std::string(kWhole), DocumentFormat::kYaml, "graph.yaml"};
  ASSERT_TRUE(yaml.graph) << yaml.Messages();
  EXPECT_EQ(TreeText(yaml.graph->document), TreeText(json.graph->document));
  ReadGraphText block{
      "texgraph: 1\n"
      "parameters:\n"
      "  rows: {type: int, value: 12}\n"
      "nodes:\n"
      "  grid:\n"
      "    block: brick_grid\n"
      "    in: {rows: rows, size: [1, 0.5], name: 'a'}\n"
      "outputs:\n"
      "  color: grid\n",
      DocumentFormat::kYaml, "graph.yaml"};
  ReadGraphText same{R"({"texgraph": 1, "parameters": {"rows": {"type": "int", "value": 12}},
      "nodes": {"grid": {"block": "brick_grid",
                         "in": {"rows": "rows", "size": [1, 0.5], "name": "a"}}},
      "outputs": {"color": "grid"}})"};
  ASSERT_TRUE(block.graph) << block.Messages();
  EXPECT_EQ(TreeText(block.graph->document), TreeText(same.graph->document));
  EXPECT_EQ(block.sources.Locate(block.source, block.graph->main.nodes[0].range.begin).line, 5u);
}

TEST(ReadGraph, EveryTruncationIsRefused) {
  for (size_t i = 0; i < kWhole.size(); ++i) {
    ReadGraphText read{std::string(kWhole.substr(0, i))};
    EXPECT_FALSE(read.graph) << i;
    EXPECT_EQ(read.diagnostics.error_count(), 1u) << i << read.Messages();
  }
}

// A graph with one more part, on the second line.
std::string With(std::string_view part) {
  return fmt::format("{{\"texgraph\": 1, \"outputs\": {{\"height\": 1}},\n{}}}", part);
}

struct Mistake {
  std::string text;
  std::vector<std::string> places;
  std::string message;
};

void ExpectMistakes(const std::vector<Mistake>& mistakes) {
  for (const Mistake& mistake : mistakes) {
    ReadGraphText read{mistake.text};
    EXPECT_FALSE(read.graph) << mistake.text;
    EXPECT_EQ(read.Places(), mistake.places) << mistake.text << read.Messages();
    EXPECT_THAT(read.Messages(), HasSubstr(mistake.message)) << mistake.text;
  }
}

TEST(ReadGraph, ReportsMistakesOfTheRoot) {
  ExpectMistakes({
      {"[]", {"1:1 graph-shape"}, "a graph must be an object, not an array"},
      {"3", {"1:1 graph-shape"}, "not a number"},
      {"{\"outputs\": {\"height\": 1}}", {"1:1 missing-key"}, "needs the key 'texgraph'"},
      {"{\"texgraph\": 1}", {"1:1 missing-key"}, "needs the key 'outputs'"},
      {"{\"texgraph\": 2, \"outputs\": {\"height\": 1}}",
       {"1:14 graph-version"},
       "version 2 of the graph format is not known"},
      {"{\"texgraph\": \"1\", \"outputs\": {\"height\": 1}}", {"1:14 graph-version"}, "format, 1"},
      {"{\"texgraph\": 1, \"outputs\": {}}", {"1:28 graph-shape"}, "at least one output"},
      {With("\"node\": {}"), {"2:1 unknown-key"}, "no key 'node'; did you mean 'nodes'?"},
      {With("\"nodes\": []"), {"2:10 graph-shape"}, "'nodes' of a graph must be an object"},
      {With("\"name\": 3"), {"2:9 graph-shape"}, "'name' of the graph must be text"},
      {With("\"name\": \"a b\""), {"2:9 bad-name"}, "'a b' is no name"},
      {With("\"description\": []"), {"2:16 graph-shape"}, "must be text, not an array"},
  });
}

TEST(ReadGraph, ReportsMistakesOfTextures) {
  auto texture = [](std::string_view body) {
    return With(fmt::format("\"textures\": {{\n\"t\": {{{}}}}}", body));
  };
  ExpectMistakes({
      {With("\"textures\": {\"t\": \"a.png\"}"),
       {"2:19 graph-shape"},
       "texture 't' must be an object, not text"},
      {texture(""), {"3:1 missing-key"}, "texture 't' needs one of the keys 'file', 'layers'"},
      {texture(R"("file": "a", "layers": ["b"])"),
       {"3:20 graph-shape (3:7)"},
       "'file' and 'layers'"},
      {texture(R"("file": "")"), {"3:15 bad-value"}, "the file's name is empty"},
      {texture(R"("file": "a\u0000b")"), {"3:15 bad-value"}, "control characters"},
      {texture(R"("file": "a\nb")"), {"3:15 bad-value"}, "control characters"},
      {texture(R"("layers": [])"), {"3:17 bad-value"}, "at least one file"},
      {texture(R"("layers": ["a", 3])"), {"3:23 graph-shape"}, "an entry of texture 't'"},
      {texture(R"("file": "a", "colour_space": "srgb")"),
       {"3:20 unknown-key"},
       "texture 't' has no key 'colour_space'; did you mean 'color_space'?"},
      {texture(R"("file": "a", "color_space": "sRGB")"),
       {"3:35 bad-value"},
       "is 'srgb', 'linear' or 'data', not 'sRGB'; did you mean 'srgb'?"},
      {texture(R"("file": "a", "wrap": "edge")"),
       {"3:28 bad-value"},
       "'wrap' of texture 't' is 'repeat', 'clamp' or 'mirror', not 'edge'"},
      {texture(R"("file": "a", "filter": 1)"), {"3:30 graph-shape"}, "must be text"},
      {texture(R"("file": "a", "mipmaps": 1)"), {"3:31 graph-shape"}, "must be a bool"},
      {texture(R"("file": "a", "max_level": 1.5)"), {"3:33 bad-value"}, "from 0 to 30"},
      {texture(R"("file": "a", "max_level": -1)"), {"3:33 bad-value"}, "from 0 to 30"},
      {texture(R"("file": "a", "alpha": "mask")"),
       {"3:29 bad-value"},
       "'alpha' of texture 't' is 'opacity' or 'data', not 'mask'"},
  });
}

TEST(ReadGraph, ReadsMasksAndKeys) {
  ReadGraphText read{With(R"("textures": {
    "plain": { "file": "a" },
    "data": { "file": "a", "color_space": "data" },
    "cut": { "file": "a", "mask": "m", "color_space": "data" },
    "turned": { "file": "a", "mask": { "file": "m", "channel": "alpha", "invert": true }, "alpha": "data" },
    "each": { "layers": ["a", "b"], "mask": ["m", { "file": "n" }], "key": {} },
    "both": { "layers": ["a", "b"], "mask": "m" },
    "key": { "file": "a", "key": { "color": [1, 0.5, 0], "tolerance": 0, "edge": 64 } } })")};
  ASSERT_TRUE(read.graph) << read.Messages();
  const std::vector<Texture>& textures = read.graph->textures;
  EXPECT_FALSE(textures[0].IsPrepared());
  EXPECT_TRUE(textures[0].alpha_is_opacity);
  EXPECT_FALSE(textures[1].alpha_is_opacity);
  EXPECT_TRUE(textures[2].IsPrepared() && textures[2].alpha_is_opacity);
  EXPECT_EQ(textures[2].MaskOf(0)->file, "m");
  EXPECT_EQ(textures[2].MaskOf(0)->channel, MaskChannel::kRed);
  EXPECT_FALSE(textures[2].MaskOf(0)->invert || textures[2].key);
  EXPECT_EQ(textures[3].MaskOf(0)->channel, MaskChannel::kAlpha);
  EXPECT_TRUE(textures[3].MaskOf(0)->invert);
  EXPECT_FALSE(textures[3].alpha_is_opacity);
  EXPECT_EQ(textures[4].MaskOf(1)->file, "n");
  EXPECT_EQ(*textures[4].key, ColorKey());
  EXPECT_EQ(textures[5].MaskOf(1)->file, "m");
  EXPECT_EQ(textures[6].MaskOf(0), nullptr);
  EXPECT_THAT(textures[6].key->color, ElementsAre(1, 0.5, 0));
  EXPECT_EQ(textures[6].key->tolerance, 0);
  EXPECT_EQ(textures[6].key->edge, 64);
}

TEST(ReadGraph, ReportsMistakesOfMasksAndKeys) {
  auto texture = [](std::string_view body) {
    return With(fmt::format("\"textures\": {{\n\"t\": {{\"file\": \"a\",\n{}}}}}", body));
  };
  ExpectMistakes({
      {texture(R"("mask": "")"), {"4:9 bad-value"}, "the file's name is empty"},
      {texture(R"("mask": "a\nb")"), {"4:9 bad-value"}, "control characters"},
      {texture(R"("mask": 3)"), {"4:9 graph-shape"}, "must be text"},
      {texture(R"("mask": null)"), {"4:9 graph-shape"}, "must be text"},
      {texture(R"("mask": {})"),
       {"4:1 missing-key"},
       "the mask of texture 't' needs the key 'file'"},
      {texture(R"("mask": {"file": "m", "chanel": "red"})"),
       {"4:23 unknown-key"},
       "did you mean 'channel'?"},
      {texture(R"("mask": {"file": "m", "channel": "r"})"),
       {"4:34 bad-value"},
       "is 'red', 'green', 'blue' or 'alpha', not 'r'"},
      {texture(R"("mask": {"file": "m", "invert": 1})"), {"4:33 graph-shape"}, "must be a bool"},
      {texture(R"("mask": ["m"])"),
       {"4:9 bad-value"},
       "a list of masks belongs to 'layers'; a texture of one file has one mask"},
      {With("\"textures\": {\n\"t\": {\"layers\": [\"a\", \"b\"], \"mask\": [\"m\"]}}"),
       {"3:37 bad-value"},
       "there are 1 masks for 2 layers; give one for each, or one without a list for all of them"},
      {texture(R"("key": true)"), {"4:8 graph-shape"}, "must be an object"},
      {texture(R"("key": {"colour": [0, 0, 0]})"),
       {"4:9 unknown-key"},
       "the key of texture 't' has no key 'colour'; did you mean 'color'?"},
      {texture(R"("key": {"color": [0, 0]})"),
       {"4:18 bad-value"},
       "a key's 'color' is red, green and blue, each from 0 to 1"},
      {texture(R"("key": {"color": [0, 0, 255]})"), {"4:18 bad-value"}, "each from 0 to 1"},
      {texture(R"("key": {"color": [0, "0", 0]})"), {"4:18 bad-value"}, "each from 0 to 1"},
      {texture(R"("key": {"color": [0, 0, 0, 0]})"), {"4:18 bad-value"}, "each from 0 to 1"},
      {texture(R"("key": {"color": 0})"), {"4:18 graph-shape"}, "must be an array"},
      {texture(R"("key": {"tolerance": 1})"), {"4:22 bad-value"}, "from 0 up to, but not, 1"},
      {texture(R"("key": {"tolerance": -0.1})"), {"4:22 bad-value"}, "from 0 up to"},
      {texture(R"("key": {"edge": 65})"),
       {"4:17 bad-value"},
       "'edge' is a whole number of texels from 0 to 64"},
      {texture(R"("key": {"edge": 1.5})"), {"4:17 bad-value"}, "a whole number"},
  });
}

TEST(ReadGraph, ReportsMistakesOfParameters) {
  auto parameter = [](std::string_view body) {
    return With(fmt::format("\"parameters\": {{\n\"p\": {{{}}}}}", body));
  };
  ExpectMistakes({
      {parameter(""), {"3:1 missing-key", "3:1 missing-key"}, "parameter 'p' needs the key 'type'"},
      {parameter(R"("type": "int", "value": null)"), {"3:31 bad-value"}, "null is no value"},
      {parameter(R"("type": "int", "value": {})"), {"3:31 bad-value"}, "an object is no value"},
      {parameter(R"("type": "vec2", "value": [])"), {"3:32 bad-value"}, "an empty array"},
      {parameter(R"("type": "vec2", "value": [1, "a"])"),
       {"3:36 bad-value"},
       "a vector has numbers only, got text"},
      {parameter(R"("type": "mat2", "value": [[1, 2], [3]])"),
       {"3:41 bad-value"},
       "this row has 1 numbers, the first has 2"},
      {parameter(R"("type": "mat2", "value": [[1, 2], 3])"), {"3:41 bad-value"}, "a row"},
      {parameter(R"("type": "int", "value": 1, "range": 3)"),
       {"3:43 graph-shape"},
       "must be an array"},
      {parameter(R"("type": "int", "value": 1, "range": [3])"), {"3:43 bad-value"}, "two numbers"},
      {parameter(R"("type": "int", "value": 1, "range": [3, 1])"),
       {"3:43 bad-value"},
       "is the smaller one"},
      {parameter(R"("type": "int", "value": 1, "binding": "unifrom")"),
       {"3:45 bad-value"},
       "did you mean 'uniform'?"},
      {parameter(R"("type": 1, "value": 1, "min": 0)"),
       {"3:30 unknown-key", "3:15 graph-shape"},
       "no key 'min'"},
  });
}

TEST(ReadGraph, ReportsMistakesOfNodesAndFunctions) {
  ExpectMistakes({
      {With(R"("nodes": {"n": {}})"), {"2:11 missing-key"}, "node 'n' needs the key 'block'"},
      {With(R"("nodes": {"n": {"blok": "x"}})"),
       {"2:17 unknown-key", "2:11 missing-key"},
       "node 'n' has no key 'blok'; did you mean 'block'?"},
      {With(R"("nodes": {"n": {"block": 3}})"), {"2:26 graph-shape"}, "'block' of node 'n'"},
      {With(R"("nodes": {"n": "x"})"), {"2:16 graph-shape"}, "node 'n' must be an object"},
      {With(R"("nodes": {"n": {"block": "x", "in": []}})"),
       {"2:37 graph-shape"},
       "'in' of node 'n' must be an object, not an array"},
      {With(R"("nodes": {"n": {"block": "x", "in": {"a": null}}})"),
       {"2:43 bad-value"},
       "leave the key out"},
      {With(R"("functions": {"f": {"outputs": {}}})"), {"2:32 graph-shape"}, "function 'f' has"},
      {With(R"("functions": {"f": {}})"), {"2:15 missing-key"}, "function 'f' needs"},
      {With(R"("functions": {"f": {"inputs": {"a": {}}, "outputs": {"b": 1}}})"),
       {"2:32 missing-key"},
       "input 'a' needs the key 'type'"},
      {With(R"("functions": {"f": {"inputs": {"a": 3}, "outputs": {"b": 1}}})"),
       {"2:37 graph-shape"},
       "input 'a' must be an object"},
      {With(R"("functions": {"f": {"outputs": {"a b": 1}}})"), {"2:33 bad-name"}, "'a b'"},
  });
}

TEST(ReadGraph, NamesThatProgramsBindAreWhatGlslTakes) {
  const std::vector<std::pair<std::string, std::string>> bad = {
      {"", "a name must not be empty"},
      {"1abc", "'1abc' is no name"},
      {"_a", "begin with a letter"},
      {"a-b", "'a-b' is no name"},
      {"a.b", "'a.b' is no name"},
      {"a b", "'a b' is no name"},
      {"a__b", "'a__b' has '__'"},
      {"main",
       "'main' is a word of GLSL, and programs bind this by its name; take another, "
       "'my_main' say"},
      {"sample", "'sample' is a word of GLSL"},
      {"vec3", "'vec3' is a word of GLSL"},
      {"gl_FragColor", "'gl_FragColor' is a word of GLSL"},
      {"\\\"; discard; //", "is no name"},
      {"a\\u0000", "is no name"},
      {"\xd0\xb0", "is no name"},  // Cyrillic a
      {"a\\u202eb", "is no name"},
      {"\\u001b]0;x\\u0007", "is no name"},
      {std::string(65, 'a'), "the name has 65 characters, the limit is 64"},
      {std::string(100'000, 'a'), "the name has 100000 characters, the limit is 64"},
  };
  for (const auto& [name, message] : bad) {
    ReadGraphText read{With(fmt::format(R"("parameters": {{
"{}": {{"type": "int", "value": 1}}}})",
                                        name))};
    EXPECT_FALSE(read.graph);
    EXPECT_THAT(read.Places(), ElementsAre("3:1 bad-name"));
    EXPECT_THAT(read.Messages(), HasSubstr(message));
    EXPECT_EQ(read.Messages().find('\x1b'), std::string::npos);
    EXPECT_LT(read.Messages().size(), 300u);
    // What the graph alone knows may be called as GLSL calls things, but with a name.
    ReadGraphText node{With(fmt::format("\"nodes\": {{\"{}\": {{\"block\": \"x\"}}}}", name))};
    const bool is_name = IsIdentifier(name) && name.size() <= kMaxNameLength && name[0] != '_';
    EXPECT_EQ(node.graph.has_value(), is_name) << name;
  }
  std::string longest(64, 'a');
  EXPECT_TRUE(
      ReadGraphText{With(fmt::format("\"nodes\": {{\"{}\": {{\"block\": \"x\"}}}}", longest))}
          .graph);
}

TEST(ReadGraph, NamesShareOneNamespace) {
  ExpectMistakes({
      {With("\"parameters\": {\"a\": {\"type\": \"int\", \"value\": 1}},\n"
            "\"textures\": {\"a\": {\"file\": \"x\"}},\n"
            "\"functions\": {\"a\": {\"outputs\": {\"x\": 1}}},\n"
            "\"nodes\": {\"a\": {\"block\": \"x\"}, \"uv\": {\"block\": \"x\"}}"),
       {"3:14 duplicate-name (2:16)", "4:15 duplicate-name (2:16)", "5:11 duplicate-name (2:16)",
        "5:32 duplicate-name"},
       "node 'uv' has the name of a built-in input"},
      {With("\"parameters\": {\"p\": {\"type\": \"int\", \"value\": 1}},\n"
            "\"functions\": {\"f\": {\"inputs\": {\"p\": \"int\", \"q\": \"int\"},\n"
            "\"nodes\": {\"q\": {\"block\": \"x\"}, \"f\": {\"block\": \"x\"}},\n"
            "\"outputs\": {\"x\": 1}}}"),
       {"3:32 duplicate-name (2:16)", "4:11 duplicate-name (3:44)", "4:32 duplicate-name (3:15)"},
       "function input 'p' has the name of a parameter"},
      // Equal names in one object are equal keys and reported once.
      {With("\"nodes\": {\"n\": {\"block\": \"x\"}, \"n\": {\"block\": \"x\"}}"),
       {"2:32 duplicate-key (2:11)"},
       "stands twice"},
  });
  // Functions are scopes of their own, and their inputs may replace built-in ones.
  ReadGraphText read{
      With("\"functions\": {\"f\": {\"inputs\": {\"uv\": \"vec2\"}, \"nodes\": {\"n\": {\"block\": "
           "\"x\"}},\n"
           "\"outputs\": {\"n\": \"n\"}}, \"g\": {\"nodes\": {\"n\": {\"block\": \"x\"}}, "
           "\"outputs\": {\"n\": 1}}},\n"
           "\"nodes\": {\"n\": {\"block\": \"x\"}}")};
  EXPECT_TRUE(read.graph) << read.Messages();
}

TEST(ReadGraph, ReportsAllMistakesAtOnce) {
  ReadGraphText read{
      "{\"texgraph\": 2,\n"
      " \"textures\": {\"t\": {}},\n"
      " \"parameters\": {\"p\": {\"type\": \"int\"}},\n"
      " \"nodes\": {\"a-b\": {\"block\": \"x\"}, \"n\": {\"in\": {\"x\": null}}},\n"
      " \"outputs\": {}, \"more\": 1, \"more\": 2}"};
  EXPECT_THAT(read.Places(), ElementsAre("5:28 duplicate-key (5:17)", "5:17 unknown-key",
                                         "5:28 unknown-key", "1:14 graph-version",
                                         "2:15 missing-key", "3:17 missing-key", "4:12 bad-name",
                                         "4:35 missing-key", "4:53 bad-value", "5:13 graph-shape"));
}

TEST(ReadGraph, TooManyNodesAreRefused) {
  std::string text = "{\"texgraph\": 1, \"outputs\": {\"height\": 1}, \"nodes\": {";
  for (int i = 0; i <= 1'000'000; ++i) text += fmt::format("\"n{}\":1,", i);
  text.back() = '}';
  ReadGraphText read{text + "}"};
  EXPECT_FALSE(read.graph);
  EXPECT_THAT(read.Places(), ElementsAre("1:43 size-limit"));
  EXPECT_THAT(read.Messages(), HasSubstr("more than 1000000 nodes"));
  EXPECT_EQ(read.diagnostics.exit_code(), ExitCode::kLimit);
}

TEST(ReadGraph, EqualTexturesAreFound) {
  ReadGraphText read{With(R"("textures": {
      "a": {"file": "x.png"}, "b": {"file": "y.png"}, "c": {"file": "x.png", "wrap": "repeat"},
      "d": {"file": "x.png", "wrap_v": "clamp"}, "e": {"layers": ["x.png"]},
      "f": {"file": "x.png", "mask": "m"}, "g": {"file": "x.png", "mask": {"file": "m"}},
      "h": {"file": "x.png", "mask": {"file": "m", "invert": true}},
      "i": {"file": "x.png", "key": {}}, "j": {"file": "x.png", "key": {"edge": 3}},
      "k": {"file": "x.png", "key": {"tolerance": 0.05}}, "l": {"file": "x.png", "alpha": "data"}})")};
  ASSERT_TRUE(read.graph) << read.Messages();
  std::vector<uint32_t> first;
  for (uint32_t i = 0; i < 12; ++i) first.push_back(FirstEqualTexture(*read.graph, i));
  EXPECT_THAT(first, ElementsAre(0, 1, 0, 3, 4, 5, 5, 7, 8, 9, 8, 11));
}

}  // namespace
}  // namespace texgraph::graph
