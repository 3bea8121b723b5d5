// SPDX-License-Identifier: Apache-2.0
// docs/graph.schema.json and ReadGraph say the same of every graph, but for what a schema cannot
// say.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>
#include <vector>

#include "tests/unit/graph/graph_testing.h"

namespace texgraph::graph {
namespace {

std::string FileText(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

const nlohmann::json& SchemaText() {
  static const auto text =
      nlohmann::json::parse(FileText(TEXGRAPH_SOURCE_DIR "/docs/graph.schema.json"));
  return text;
}

bool Validates(const nlohmann::json& json) {
  static valijson::Schema schema;
  static const bool parsed = [] {
    valijson::SchemaParser parser(valijson::SchemaParser::kDraft7);
    parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(SchemaText()), schema);
    return true;
  }();
  EXPECT_TRUE(parsed);
  valijson::Validator validator;
  return validator.validate(schema, valijson::adapters::NlohmannJsonAdapter(json), nullptr);
}

// The text of any format as the schema sees it.
bool Validates(const ReadText& read) {
  return Validates(nlohmann::json::parse(TreeText(*read.document)));
}

TEST(GraphSchema, AcceptsEveryExample) {
  std::vector<std::filesystem::path> files;
  for (const char* folder : {TEXGRAPH_SOURCE_DIR "/graphs", TEXGRAPH_SOURCE_DIR "/tests/graphs"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
      files.push_back(entry.path());
  }
  size_t count = 0;
  for (const std::filesystem::path& path : files) {
    std::string name = path.string();
    std::set<std::string> extensions = {".json", ".jsonc", ".yaml", ".yml"};
    if (!extensions.contains(path.extension().string())) continue;
    ++count;
    std::string text = FileText(name);
    ReadText read(text, FormatOf(name, text), name);
    ASSERT_TRUE(read.document) << name << read.Messages();
    EXPECT_TRUE(Validates(read)) << name;
    ReadGraphText graph(text, FormatOf(name, text), name);
    EXPECT_TRUE(graph.graph) << name << graph.Messages();
  }
  EXPECT_GT(count, 0u);
}

// Every fenced graph of docs/graph-format.md.
TEST(GraphSchema, AcceptsTheGraphsOfTheManual) {
  std::string manual = FileText(TEXGRAPH_SOURCE_DIR "/docs/graph-format.md");
  size_t count = 0;
  constexpr std::string_view kFence = "```json\n";
  for (size_t at = manual.find(kFence); at != std::string::npos; at = manual.find(kFence, at)) {
    at += kFence.size();
    std::string text = manual.substr(at, manual.find("```", at) - at);
    // Parts of a graph stand alone.
    if (text.starts_with("\"functions\""))
      text = "{\"texgraph\": 1, \"outputs\": {\"height\": 1}, " + text + "}";
    if (!text.starts_with("{")) continue;
    ++count;
    ReadText read(text);
    ASSERT_TRUE(read.document) << text << read.Messages();
    EXPECT_TRUE(Validates(read)) << text;
    EXPECT_TRUE(ReadGraphText(text).graph) << text;
  }
  EXPECT_GE(count, 2u);
}

std::string With(const std::string& part) {
  return "{\"texgraph\": 1, \"outputs\": {\"height\": 1}, " + part + "}";
}

const std::vector<std::string> kGood = {
    R"({"texgraph": 1, "outputs": {"color": [1, 0, 0, 1], "normal": "n", "height": 0.5}})",
    R"({"$schema": "x", "texgraph": 1, "name": "a_b", "outputs": {"opacity": true}})",
    With(R"("textures": {"t": {"file": "a", "color_space": "data", "filter": "nearest"}})"),
    With(R"("textures": {"t": {"layers": ["a", "b"], "wrap": "clamp", "wrap_u": "mirror"}})"),
    With(R"("textures": {"t": {"file": "a", "mipmaps": false, "max_level": 0}})"),
    With(R"("textures": {"t": {"file": "a", "mask": "m", "key": {}, "alpha": "opacity"}})"),
    With(R"("textures": {"t": {"layers": ["a"], "mask": [{"file": "m", "channel": "blue"}]}})"),
    With(R"("textures": {"t": {"file": "a", "key": {"color": [0, 1, 0.5], "edge": 64}}})"),
    With(R"("textures": {"t": {"layers": ["a", "b"], "edges": "match", "weights": [1, 0.5]}})"),
    With(R"("textures": {"t": {"layers": ["a"], "edges": "l"}, "l": {"lists": [[0]], "of": "t"}})"),
    With(R"("textures": {"t": {"sheet": "a", "grid": [4, 2], "pack": "atlas", "wrap": "clamp"}})"),
    With(R"("textures": {"t": {"layers": ["a"], "pack": "volume", "mipmaps": false}})"),
    With(R"("textures": {"t": {"map": [[0, -1], [2, 3]], "binding": "constant"}})"),
    With(R"("textures": {"t": {"map": "a.png", "legend": ["#00ff7F", "#123456"]}})"),
    With(R"("textures": {"t": {"lists": [[0, 1], [1]], "of": "u"}, "u": {"layers": ["a", "b"]}})"),
    With(R"("textures": {"t": {"sprites": [{"pattern": 0, "at": [0.5, 1]}], "cells": [2, 2]}})"),
    With(R"("textures": {"t": {"sprites": [], "cells": [2, 2], "layers": 64}})"),
    With(R"("textures": {"t": {"noise": {"band": 8, "spread": 5}, "second": [{"lobes": [3, -4.5]}],
                         "size": 64, "seed": 3}})"),
    With(R"("textures": {"t": {"noise": [{"power_law": 2, "lowest": 2, "highest": 9, "share": 2},
                         {"painted": "a.png"}, {"band": 8, "bandwidth": 2, "direction": -90,
                         "stretch": 3}]}})"),
    With(R"("textures": {"t": {"gaussian": "a", "color_space": "data"}, "u": {"table": "t"}})"),
    With(R"("textures": {"t": {"color_map": "a", "alpha": "data", "deviations": 8}})"),
    With(R"("textures": {"t": {"means": "m", "dithered": true}, "m": {"map": [[0]], "of": "u"},
                         "u": {"layers": ["a"]}})"),
    With(R"("parameters": {"p": {"type": "int", "value": 1, "range": [0, 2], "unit": "m"}})"),
    With(R"("parameters": {"p": {"type": "vec2", "value": [1, 2], "binding": "uniform"}})"),
    With(R"("functions": {"f": {"inputs": {"a": "float", "t": "Tile"}, "outputs": {"o": "a"}}})"),
    With(
        R"("functions": {"f": {"inputs": {"a": {"type": "int", "value": 2}}, "outputs": {"o": 1}}})"),
    With(R"("nodes": {"a__b": {"block": "x"}, "float": {"block": "x"}})"),
    With(R"("nodes": {"n_": {"block": "b", "in": {"m": [[1, 2], [3, 4]], "w": "add"}}})"),
};

const std::vector<std::string> kBad = {
    "[]",
    "3",
    R"({"outputs": {"height": 1}})",
    R"({"texgraph": 2, "outputs": {"height": 1}})",
    R"({"texgraph": "1", "outputs": {"height": 1}})",
    R"({"texgraph": 1})",
    R"({"texgraph": 1, "outputs": {}})",
    R"({"texgraph": 1, "outputs": {"height": null}})",
    R"({"texgraph": 1, "outputs": {"height": {}}})",
    R"({"texgraph": 1, "outputs": {"height": []}})",
    With(R"("node": {})"),
    With(R"("nodes": [])"),
    With(R"("name": "a b")"),
    With(R"("name": 3)"),
    With(R"("description": 3)"),
    With(R"("nodes": {"a-b": {"block": "x"}})"),
    With(R"("parameters": {"a__b": {"type": "int", "value": 1}})"),
    With(R"("nodes": {"_a": {"block": "x"}})"),
    With(R"("nodes": {"": {"block": "x"}})"),
    With("\"nodes\": {\"" + std::string(65, 'a') + "\": {\"block\": \"x\"}}"),
    With(R"("nodes": {"n": {}})"),
    With(R"("nodes": {"n": {"block": 3}})"),
    With(R"("nodes": {"n": {"block": "b", "inputs": {}}})"),
    With(R"("nodes": {"n": {"block": "b", "in": []}})"),
    With(R"("nodes": {"n": {"block": "b", "in": {"a": null}}})"),
    With(R"("nodes": {"n": {"block": "b", "in": {"a": [1, "b"]}}})"),
    With(R"("nodes": {"n": {"block": "b", "in": {"a": [[1], 2]}}})"),
    With(R"("textures": {"t": "a.png"})"),
    With(R"("textures": {"t": {}})"),
    With(R"("textures": {"t": {"file": ""}})"),
    With(R"("textures": {"t": {"file": "a", "map": [[1]]}})"),
    With(R"("textures": {"t": {"sheet": "a"}})"),
    With(R"("textures": {"t": {"sheet": "a", "grid": [2, 2, 2]}})"),
    With(R"("textures": {"t": {"layers": ["a"], "pack": "cube"}})"),
    With(R"("textures": {"t": {"layers": ["a"], "edges": true}})"),
    With(R"("textures": {"t": {"layers": ["a"], "weights": [-1]}})"),
    With(R"("textures": {"t": {"layers": 3}})"),
    With(R"("textures": {"t": {"map": []}})"),
    With(R"("textures": {"t": {"map": [[]]}})"),
    With(R"("textures": {"t": {"map": [1, 2]}})"),
    With(R"("textures": {"t": {"map": [[0.5]]}})"),
    With(R"("textures": {"t": {"map": [[-2]]}})"),
    With(R"("textures": {"t": {"map": "a", "legend": ["red"]}})"),
    With(R"("textures": {"t": {"map": [[1]], "binding": "uniform"}})"),
    With(R"("textures": {"t": {"lists": [[]]}})"),
    With(R"("textures": {"t": {"sprites": [], "cells": [2, 2], "layers": 65}})"),
    With(R"("textures": {"t": {"sprites": [{"pattern": 0}], "cells": [2, 2]}})"),
    With(R"("textures": {"t": {"sprites": []}})"),
    With(R"("textures": {"t": {"means": 3}})"),
    With(R"("textures": {"t": {"noise": []}})"),
    With(R"("textures": {"t": {"noise": {"share": 1}}})"),
    With(R"("textures": {"t": {"noise": {"band": 4, "lobes": [1, 2]}}})"),
    With(R"("textures": {"t": {"noise": {"band": -1}}})"),
    With(R"("textures": {"t": {"noise": {"lobes": [1]}}})"),
    With(R"("textures": {"t": {"noise": {"band": 4}, "size": 15}})"),
    With(R"("textures": {"t": {"color_map": "a", "deviations": 9}})"),
    With(R"("textures": {"t": {"table": 3}})"),
    With(R"("textures": {"t": {"file": "a", "layers": ["b"]}})"),
    With(R"("textures": {"t": {"layers": []}})"),
    With(R"("textures": {"t": {"file": "a", "color_space": "sRGB"}})"),
    With(R"("textures": {"t": {"file": "a", "wrap": "edge"}})"),
    With(R"("textures": {"t": {"file": "a", "mipmaps": 1}})"),
    With(R"("textures": {"t": {"file": "a", "max_level": 31}})"),
    With(R"("textures": {"t": {"file": "a", "max_level": 1.5}})"),
    With(R"("textures": {"t": {"file": "a", "alpha": "straight"}})"),
    With(R"("textures": {"t": {"file": "a", "mask": ""}})"),
    With(R"("textures": {"t": {"layers": ["a"], "mask": []}})"),
    With(R"("textures": {"t": {"file": "a", "mask": {"channel": "red"}}})"),
    With(R"("textures": {"t": {"file": "a", "mask": {"file": "m", "channel": "luma"}}})"),
    With(R"("textures": {"t": {"file": "a", "key": [0, 0, 0]}})"),
    With(R"("textures": {"t": {"file": "a", "key": {"color": [0, 0]}}})"),
    With(R"("textures": {"t": {"file": "a", "key": {"tolerance": 1}}})"),
    With(R"("textures": {"t": {"file": "a", "key": {"edge": 65}}})"),
    With(R"("parameters": {"p": {"type": "int"}})"),
    With(R"("parameters": {"p": {"value": 1}})"),
    With(R"("parameters": {"p": {"type": "int", "value": 1, "range": [1]}})"),
    With(R"("parameters": {"p": {"type": "int", "value": 1, "binding": "const"}})"),
    With(R"("parameters": {"p": {"type": "int", "value": 1, "min": 0}})"),
    With(R"("functions": {"f": {}})"),
    With(R"("functions": {"f": {"outputs": {}}})"),
    With(R"("functions": {"f": {"outputs": {"a b": 1}}})"),
    With(R"("functions": {"f": {"inputs": {"a": 3}, "outputs": {"o": 1}}})"),
    With(R"("functions": {"f": {"inputs": {"a": {}}, "outputs": {"o": 1}}})"),
    With(R"("functions": {"f": {"in": {}, "outputs": {"o": 1}}})"),
};

TEST(GraphSchema, AgreesWithTheReader) {
  for (const std::string& text : kGood) {
    EXPECT_TRUE(Validates(nlohmann::json::parse(text))) << text;
    ReadGraphText read(text);
    EXPECT_TRUE(read.graph) << text << read.Messages();
  }
  for (const std::string& text : kBad) {
    EXPECT_FALSE(Validates(nlohmann::json::parse(text))) << text;
    EXPECT_FALSE(ReadGraphText(text).graph) << text;
  }
}

// Types are checked behind the reader, so these are wrong for the schema alone.
TEST(GraphSchema, KnowsTypesAndOutputs) {
  for (const std::string& text :
       {With(R"("parameters": {"p": {"type": "flot", "value": 1}})"),
        With(R"("parameters": {"p": {"type": "int", "value": "one"}})"),
        With(R"("functions": {"f": {"inputs": {"a": "sampler2D"}, "outputs": {"o": 1}}})"),
        std::string(R"({"texgraph": 1, "outputs": {"colour": 1}})")}) {
    EXPECT_FALSE(Validates(nlohmann::json::parse(text))) << text;
  }
}

// What an editor shows: every key of every object has a title or a description.
void ExpectTexts(const nlohmann::json& schema, const std::string& path) {
  if (schema.is_object() && schema.contains("properties")) {
    for (const auto& [key, value] : schema["properties"].items()) {
      const nlohmann::json* shown = &value;
      if (value.contains("$ref")) {
        std::string target = value["$ref"];
        shown = &SchemaText().at(nlohmann::json::json_pointer(target.substr(1)));
      }
      EXPECT_TRUE(shown->contains("title") || shown->contains("description")) << path << "/" << key;
    }
  }
  if (!schema.is_structured()) return;
  for (const auto& [key, value] : schema.items()) ExpectTexts(value, path + "/" + key);
}

TEST(GraphSchema, HasTextsForEditors) { ExpectTexts(SchemaText(), ""); }

}  // namespace
}  // namespace texgraph::graph
