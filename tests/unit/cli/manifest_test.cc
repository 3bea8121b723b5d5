// SPDX-License-Identifier: Apache-2.0
// What the manifest says of a graph, against the graph itself.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/unit/base/scratch_folder.h"
#include "tests/unit/cli/program.h"

namespace texgraph {
namespace {

using nlohmann::json;

// Two colours of one texel each, as PNG.
constexpr unsigned char kPixel[] = {
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48,
    0x44, 0x52, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x06, 0x00, 0x00,
    0x00, 0x1f, 0x15, 0xc4, 0x89, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x44, 0x41, 0x54, 0x78,
    0xda, 0x63, 0xfc, 0xcf, 0xc0, 0x50, 0x0f, 0x00, 0x04, 0x85, 0x01, 0x80, 0x84, 0xa9,
    0x8c, 0x21, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};

constexpr std::string_view kGraph = R"({
  "texgraph": 1,
  "description": "All kinds of things.",
  "textures": {
    "first": { "file": "pictures/a.png", "color_space": "linear", "wrap": "clamp", "filter": "nearest", "mipmaps": false },
    "alike": { "file": "pictures/a.png", "color_space": "linear", "wrap": "clamp", "filter": "nearest", "mipmaps": false },
    "spare": { "file": "pictures/b.png", "max_level": 3 },
    "other": { "file": "/ABSOLUTE/b.png" }
  },
  "parameters": {
    "rows": { "type": "int", "value": 7, "range": [1, 64], "label": "Rows", "help": "How many.", "unit": "bricks" },
    "idle": { "type": "float", "value": 0.5 },
    "dropped": { "type": "float", "value": 0.5, "binding": "uniform" },
    "tint": { "type": "vec4", "value": [1, 0.5, 0.25, 1], "binding": "uniform" },
    "in_function": { "type": "float", "value": 2 },
    "wave": { "type": "float", "value": 3, "binding": "specialization" },
    "wet": { "type": "bool", "value": true }
  },
  "functions": {
    "shine": {
      "inputs": { "x": "float" },
      "nodes": { "m": { "block": "multiply", "in": { "a": "x", "b": "in_function" } } },
      "outputs": { "value": "m" }
    },
    "dull": { "nodes": { "m": { "block": "sine", "in": { "angle": "idle" } } }, "outputs": { "v": "m" } }
  },
  "nodes": {
    "grid": { "block": "brick_grid", "in": { "rows": "rows", "toroidal": "wet" } },
    "shade": { "block": "tile_random", "in": { "tile": "grid" } },
    "shiny": { "block": "shine", "in": { "x": "shade" } },
    "moved": { "block": "sine", "in": { "angle": "phase" } },
    "phase": { "block": "multiply", "in": { "a": "time", "b": "wave" } },
    "a": { "block": "image", "in": { "picture": "first" } },
    "b": { "block": "image", "in": { "picture": "alike", "uv": [0.5, 0.5] } },
    "c": { "block": "image", "in": { "picture": "other" } },
    "ab": { "block": "add", "in": { "a": "a", "b": "b" } },
    "abc": { "block": "add", "in": { "a": "ab", "b": "c" } },
    "color": { "block": "multiply", "in": { "a": "abc", "b": "tint" } },
    "nothing": { "block": "multiply", "in": { "a": "dropped", "b": "idle" } },
    "height": { "block": "multiply", "in": { "a": "shiny", "b": "moved" } }
  },
  "outputs": { "height": "height", "color": "color" }
})";

class Manifest : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : {"graph", "graph/pictures", "build"})
      std::filesystem::create_directory(folder / name);
    for (const char* name : {"graph/pictures/a.png", "graph/pictures/b.png", "b.png"}) {
      folder.Write(name, std::string(reinterpret_cast<const char*>(kPixel), sizeof kPixel));
    }
    std::string graph(kGraph);
    graph.replace(graph.find("/ABSOLUTE"), 9, folder.path());
    folder.Write("graph/wall.json", graph);
  }

  json Make(std::vector<std::string> options) {
    options.insert(options.begin(), "graph/wall.json");
    Outcome outcome = Texgraphc(options, folder.path()).Run();
    EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
    return json::parse(folder.Read("build/x.json"));
  }

  static json Named(const json& list, const std::string& name) {
    for (const json& item : list) {
      if (item["name"] == name) return item;
    }
    ADD_FAILURE() << "no " << name << " in " << list;
    return {};
  }

  ScratchFolder folder;
};

std::vector<std::string> NamesOf(const json& list) {
  std::vector<std::string> names;
  for (const json& item : list) names.push_back(item["name"]);
  return names;
}

TEST_F(Manifest, ListsEverythingInTheOrderOfTheGraph) {
  json manifest = Make({"-o", "build/x.frag"});
  EXPECT_EQ(manifest["name"], "wall");
  EXPECT_EQ(manifest["description"], "All kinds of things.");
  EXPECT_EQ(manifest["shader"], "x.frag");
  EXPECT_EQ(manifest["dialect"], "glsl330");
  EXPECT_EQ(manifest["entry_point"], "main");
  EXPECT_THAT(
      NamesOf(manifest["parameters"]),
      testing::ElementsAre("rows", "idle", "dropped", "tint", "in_function", "wave", "wet"));
  EXPECT_THAT(NamesOf(manifest["textures"]),
              testing::ElementsAre("first", "alike", "spare", "other"));
  EXPECT_THAT(NamesOf(manifest["outputs"]), testing::ElementsAre("height", "color"));
  EXPECT_THAT(NamesOf(manifest["inputs"]), testing::ElementsAre("uv", "time"));
}

TEST_F(Manifest, SaysWhatBecameOfEachParameter) {
  json parameters = Make({"-o", "build/x.frag"})["parameters"];
  EXPECT_EQ(
      Named(parameters, "rows"),
      json::parse(R"({ "name": "rows", "type": "int", "binding": "constant", "status": "folded",
      "value": 7, "range": [1, 64], "label": "Rows", "help": "How many.", "unit": "bricks" })"));
  EXPECT_EQ(Named(parameters, "idle")["status"], "unused");
  EXPECT_EQ(Named(parameters, "dropped")["status"], "unused");
  EXPECT_EQ(Named(parameters, "dropped")["binding"], "uniform");
  EXPECT_EQ(Named(parameters, "tint")["status"], "uniform");
  EXPECT_EQ(Named(parameters, "tint")["value"], json::parse("[1, 0.5, 0.25, 1]"));
  EXPECT_EQ(Named(parameters, "in_function")["status"], "folded");
  EXPECT_EQ(Named(parameters, "wet")["value"], true);
  EXPECT_EQ(Named(parameters, "wet")["status"], "folded");
}

TEST_F(Manifest, ValuesAreThoseOfTheCommandLine) {
  json parameters =
      Make({"-o", "build/x.frag", "--set", "rows=9", "--set", "tint=[0, 0, 0, 1]"})["parameters"];
  EXPECT_EQ(Named(parameters, "rows")["value"], 9);
  EXPECT_EQ(Named(parameters, "tint")["value"], json::parse("[0, 0, 0, 1]"));
}

TEST_F(Manifest, TexturesWithFilesFromTheManifestsFolder) {
  json textures = Make({"-o", "build/x.frag"})["textures"];
  EXPECT_EQ(
      Named(textures, "first"),
      json::parse(R"({ "name": "first", "type": "sampler2D", "status": "used", "variable": "first",
      "files": ["../graph/pictures/a.png"], "alpha": "data", "color_space": "linear", "filter": "nearest",
      "wrap": ["clamp", "clamp"], "mipmaps": false })"));
  EXPECT_EQ(Named(textures, "alike")["variable"], "first");
  EXPECT_EQ(Named(textures, "alike")["status"], "used");
  EXPECT_EQ(Named(textures, "spare")["status"], "unused");
  EXPECT_EQ(Named(textures, "spare")["max_level"], 3);
  EXPECT_EQ(Named(textures, "other")["files"][0], folder / "b.png");
  json elsewhere = Make({"-o", "graph/x.frag", "--manifest", "build/x.json"});
  EXPECT_EQ(elsewhere["shader"], "../graph/x.frag");
  EXPECT_EQ(elsewhere["textures"][0]["files"][0], "../graph/pictures/a.png");
}

// White with a white mask: what texgraphc prepares, and what it leaves to whoever needs it.
TEST_F(Manifest, PreparedPicturesStandBesideIt) {
  folder.Write("graph/wall.json", R"({ "texgraph": 1,
    "textures": {
      "cut": { "file": "pictures/a.png", "mask": { "file": "pictures/b.png", "invert": true }, "key": { "tolerance": 0.25 } },
      "alike": { "file": "pictures/a.png", "mask": { "file": "pictures/b.png", "invert": true }, "key": { "tolerance": 0.25 } },
      "stack": { "layers": ["pictures/a.png", "pictures/b.png"], "mask": "pictures/a.png" },
      "idle": { "file": "pictures/a.png", "mask": "pictures/b.png" } },
    "nodes": {
      "a": { "block": "image", "in": { "picture": "cut" } },
      "b": { "block": "image", "in": { "picture": "alike" } },
      "c": { "block": "image", "in": { "picture": "stack" } },
      "ab": { "block": "add", "in": { "a": "a", "b": "b" } },
      "abc": { "block": "add", "in": { "a": "ab", "b": "c" } } },
    "outputs": { "color": "abc" } })");
  json textures = Make({"-o", "graph/x.frag", "--manifest", "build/x.json", "-MD"})["textures"];
  EXPECT_EQ(Named(textures, "cut"), json::parse(R"({
    "name": "cut", "type": "sampler2D", "status": "used", "variable": "cut", "files": ["wall.cut.png"],
    "prepared_from": { "files": ["../graph/pictures/a.png"],
      "masks": [{ "file": "../graph/pictures/b.png", "channel": "red", "invert": true }],
      "key": { "color": [0, 0, 0], "tolerance": 0.25, "edge": 2 } },
    "alpha": "opacity", "color_space": "srgb", "filter": "linear", "wrap": ["repeat", "repeat"], "mipmaps": true })"));
  EXPECT_EQ(Named(textures, "alike")["files"][0], "wall.cut.png");
  EXPECT_EQ(Named(textures, "stack")["files"],
            json::parse(R"(["wall.stack.0.png", "wall.stack.1.png"])"));
  EXPECT_EQ(Named(textures, "idle")["files"][0], "../graph/pictures/a.png");
  EXPECT_EQ(Named(textures, "idle")["masks"][0]["file"], "../graph/pictures/b.png");
  EXPECT_FALSE(Named(textures, "idle").contains("prepared_from"));
  std::vector<std::string> written;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "build"))
    written.push_back(entry.path().filename());
  EXPECT_THAT(written, testing::UnorderedElementsAre("x.json", "wall.cut.png", "wall.stack.0.png",
                                                     "wall.stack.1.png"));
  EXPECT_EQ(folder.Read("graph/x.frag.d"),
            "graph/x.frag: \\\n  graph/wall.json \\\n  graph/pictures/a.png \\\n"
            "  graph/pictures/b.png\n");
  // The same bytes again, and none over a picture that is read.
  const std::string before = folder.Read("build/wall.stack.1.png");
  Make({"-o", "build/x.frag"});
  EXPECT_EQ(folder.Read("build/wall.stack.1.png"), before);
  std::filesystem::copy_file(folder / "b.png", folder / "graph/pictures/wall.idle.png");
  folder.Write("graph/wall.json", R"({ "texgraph": 1,
    "textures": { "idle": { "file": "pictures/wall.idle.png", "mask": "pictures/a.png" } },
    "nodes": { "a": { "block": "image", "in": { "picture": "idle" } } }, "outputs": { "color": "a" } })");
  Outcome outcome =
      Texgraphc({"graph/wall.json", "-o", "graph/pictures/x.frag"}, folder.path()).Run();
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.error,
              testing::HasSubstr("wall.idle.png': it is one of the files that are read"));
}

TEST_F(Manifest, NumbersAreThoseOfTheShader) {
  json manifest = Make({"-o", "build/x.frag", "--target", "glsl450"});
  std::string shader = folder.Read("build/x.frag");
  auto declares = [&](const std::string& text) {
    EXPECT_NE(shader.find(text), std::string::npos) << text << "\n" << shader;
  };
  auto number = [](const json& item, const char* key) {
    return std::to_string(item[key].get<int>());
  };
  for (const json& input : manifest["inputs"]) {
    std::string qualifier = input["binding"] == "input" ? "in" : "uniform";
    declares("layout(location = " + number(input, "location") + ") " + qualifier + " " +
             std::string(input["type"]) + " " + std::string(input["name"]) + ";");
  }
  json tint = Named(manifest["parameters"], "tint");
  declares("layout(location = " + number(tint, "location") + ") uniform vec4 tint;");
  for (const char* name : {"first", "other"}) {
    json texture = Named(manifest["textures"], name);
    declares("layout(location = " + number(texture, "location") +
             ", binding = " + number(texture, "binding") + ") uniform sampler2D " + name + ";");
  }
  for (const json& output : manifest["outputs"]) {
    declares("layout(location = " + number(output, "location") + ") out " +
             std::string(output["type"]) + " " + std::string(output["variable"]) + ";");
  }
}

TEST_F(Manifest, SpecializationConstants) {
  json plain = Named(Make({"-o", "build/x.frag"})["parameters"], "wave");
  EXPECT_EQ(plain["status"], "specialization");
  EXPECT_FALSE(plain.contains("constant_id"));
  EXPECT_NE(folder.Read("build/x.frag").find("const float wave = 3.0;"), std::string::npos);
  json spirv = Named(Make({"-o", "build/x.spv", "--target", "spirv"})["parameters"], "wave");
  EXPECT_EQ(spirv["constant_id"], 0);
  // OpDecorate <id> SpecId 0
  std::string bytes = folder.Read("build/x.spv");
  std::vector<uint32_t> words(bytes.size() / 4);
  std::memcpy(words.data(), bytes.data(), words.size() * 4);
  bool found = false;
  for (size_t i = 5; i + 3 < words.size(); ++i) {
    found |= words[i] == 0x00040047u && words[i + 2] == 1 && words[i + 3] == 0;
  }
  EXPECT_TRUE(found);
}

TEST_F(Manifest, FunctionsHaveNoLocations) {
  json manifest = Make({"-o", "build/x.glsl", "--emit", "function", "--target", "glsl450"});
  EXPECT_EQ(manifest["entry_point"], "wall");
  EXPECT_EQ(manifest["emit"], "function");
  EXPECT_EQ(manifest.dump().find("\"location\""), std::string::npos);
  EXPECT_EQ(manifest["outputs"][0]["variable"], "height");
  EXPECT_FALSE(manifest["inputs"][0].contains("variable"));  // uv is a parameter
  EXPECT_EQ(manifest["inputs"][1]["variable"], "time");
  EXPECT_EQ(manifest.dump().find("\"binding\":0"), std::string::npos);
  EXPECT_NE(folder.Read("build/x.glsl").find(" wall("), std::string::npos);
}

}  // namespace
}  // namespace texgraph
