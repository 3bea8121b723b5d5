// SPDX-License-Identifier: Apache-2.0
#include "runtime/manifest.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace texgraph::runtime {
namespace {

using testing::HasSubstr;

struct Outcome {
  std::optional<Manifest> manifest;
  Diagnostics diagnostics;
  std::string text;  // of all diagnostics
};

Outcome Read(const std::string& text) {
  Outcome outcome;
  Sources sources;
  const SourceId source = sources.Add("m.json", text);
  const auto document =
      graph::ReadDocument(source, graph::DocumentFormat::kJson, sources, outcome.diagnostics);
  if (document) outcome.manifest = ReadManifest(*document, outcome.diagnostics);
  outcome.text = FormatDiagnostics(outcome.diagnostics, sources, false);
  return outcome;
}

const char* const kWhole = R"({
  "texgraph_manifest": 1, "name": "wall", "shader": "wall.frag", "dialect": "glsl450", "emit": "shader",
  "entry_point": "main", "something_new": [1],
  "inputs": [{"name": "uv", "type": "vec2", "location": 3}, {"name": "time", "type": "float"}],
  "outputs": [{"name": "color", "variable": "out_color", "type": "vec4", "location": 0},
              {"name": "height", "variable": "out_height", "type": "float", "location": 1}],
  "parameters": [
    {"name": "tint", "type": "vec3", "binding": "uniform", "status": "uniform", "value": [1, 0.5, 0]},
    {"name": "count", "type": "int", "binding": "uniform", "status": "uniform", "value": 3, "range": [1, 10]},
    {"name": "wet", "type": "bool", "binding": "uniform", "status": "uniform", "value": true},
    {"name": "seed", "type": "uint", "binding": "uniform", "status": "uniform", "value": 7},
    {"name": "spare", "type": "float", "binding": "uniform", "status": "unused", "value": 7},
    {"name": "rows", "type": "int", "binding": "constant", "status": "folded", "value": 12}],
  "textures": [
    {"name": "brick", "type": "sampler2D", "status": "used", "variable": "wall", "files": ["a/brick.png"], "color_space": "srgb",
     "filter": "nearest", "wrap": ["clamp", "mirror"], "mipmaps": false, "max_level": 4},
    {"name": "stains", "type": "sampler2DArray", "status": "unused", "files": ["1.png", "2.png"],
     "color_space": "linear", "masks": [{"file": "m.png", "channel": "green", "invert": true}],
     "key": {"color": [1, 0.5, 0], "tolerance": 0.25, "edge": 7}, "alpha": "opacity",
     "map": {"holds": "lists", "of": "brick", "count": 12}}]
})";

TEST(ManifestTest, ReadsDerivedTextures) {
  const Outcome outcome = Read(R"({
  "texgraph_manifest": 1, "shader": "g.frag", "dialect": "glsl330",
  "outputs": [{"name": "height", "variable": "out_height", "type": "float"}],
  "textures": [
    {"name": "tree", "type": "sampler3D", "status": "used", "variable": "tree", "files": ["g.tree.ktx2"],
     "color_space": "srgb", "wrap": ["clamp", "repeat", "mirror"], "format": "srgb8_alpha8"},
    {"name": "idle", "type": "sampler2D", "status": "unused", "files": [], "color_space": "linear"}]
})");
  ASSERT_TRUE(outcome.manifest) << outcome.text;
  const ManifestTexture& tree = outcome.manifest->textures[0];
  EXPECT_TRUE(tree.has_levels);
  EXPECT_TRUE(tree.options.is_3d);
  EXPECT_FALSE(tree.options.is_array);
  EXPECT_EQ(tree.options.wrap_w, ir::Wrap::kMirror);
  EXPECT_FALSE(outcome.manifest->textures[1].has_levels);
}

TEST(ManifestTest, ReadsEverything) {
  const Outcome outcome = Read(kWhole);
  ASSERT_TRUE(outcome.manifest) << outcome.text;
  const Manifest& manifest = *outcome.manifest;
  EXPECT_EQ(manifest.name, "wall");
  EXPECT_EQ(manifest.shader, "wall.frag");
  EXPECT_EQ(manifest.dialect, ShaderDialect::kGlsl450);
  EXPECT_FALSE(manifest.is_function);
  ASSERT_EQ(manifest.inputs.size(), 2u);
  EXPECT_EQ(manifest.inputs[0].location, 3u);
  EXPECT_EQ(manifest.inputs[1].location, std::nullopt);
  ASSERT_EQ(manifest.outputs.size(), 2u);
  EXPECT_EQ(manifest.outputs[1].variable, "out_height");
  EXPECT_EQ(manifest.outputs[0].type, ir::kVec4);
  ASSERT_EQ(manifest.parameters.size(), 6u);
  EXPECT_EQ(manifest.parameters[0].value, (std::vector<double>{1, 0.5, 0}));
  EXPECT_TRUE(manifest.parameters[0].is_uniform);
  EXPECT_EQ(manifest.parameters[1].range, (std::array<double, 2>{1, 10}));
  EXPECT_EQ(manifest.parameters[2].value, (std::vector<double>{1}));
  EXPECT_FALSE(manifest.parameters[4].is_uniform);
  EXPECT_FALSE(manifest.parameters[5].is_uniform);
  ASSERT_EQ(manifest.textures.size(), 2u);
  const textures::TextureOptions& brick = manifest.textures[0].options;
  EXPECT_TRUE(brick.srgb);
  EXPECT_FALSE(brick.mipmaps);
  EXPECT_EQ(brick.max_level, 4u);
  EXPECT_EQ(brick.filter, ir::Filter::kNearest);
  EXPECT_EQ(brick.wrap_u, ir::Wrap::kClamp);
  EXPECT_EQ(brick.wrap_v, ir::Wrap::kMirror);
  EXPECT_EQ(manifest.textures[0].variable, "wall");
  EXPECT_EQ(manifest.textures[1].files.size(), 2u);
  EXPECT_TRUE(manifest.textures[1].options.is_array);
  EXPECT_FALSE(manifest.textures[1].options.srgb);
  EXPECT_FALSE(manifest.textures[1].is_used);
  // Where a manifest says nothing of alpha, the colour space does.
  EXPECT_TRUE(brick.alpha_is_opacity);
  EXPECT_TRUE(manifest.textures[1].options.alpha_is_opacity);
  EXPECT_FALSE(manifest.textures[0].key || !manifest.textures[0].masks.empty());
  ASSERT_EQ(manifest.textures[1].masks.size(), 1u);
  EXPECT_EQ(manifest.textures[1].masks[0].file, "m.png");
  EXPECT_EQ(manifest.textures[1].masks[0].channel, textures::MaskChannel::kGreen);
  EXPECT_TRUE(manifest.textures[1].masks[0].invert);
  EXPECT_EQ(manifest.textures[1].key->color, (std::array<float, 3>{1, 0.5f, 0}));
  EXPECT_EQ(manifest.textures[1].key->tolerance, 0.25f);
  EXPECT_EQ(manifest.textures[1].key->edge, 7u);
  EXPECT_FALSE(manifest.textures[0].map || manifest.textures[0].is_folded);
  ASSERT_TRUE(manifest.textures[1].map);
  EXPECT_EQ(manifest.textures[1].map->holds, MapContents::kLists);
  EXPECT_EQ(manifest.textures[1].map->count, 12u);
}

TEST(ManifestTest, TellsAManifestFromAGraph) {
  for (const auto& [text, expected] :
       {std::pair{"{\"texgraph_manifest\": 1}", true}, std::pair{"{\"texgraph\": 1}", false},
        std::pair{"[1]", false}}) {
    Sources sources;
    Diagnostics diagnostics;
    const auto document = graph::ReadDocument(sources.Add("m.json", text),
                                              graph::DocumentFormat::kJson, sources, diagnostics);
    ASSERT_TRUE(document);
    EXPECT_EQ(IsManifest(*document), expected) << text;
  }
}

// The whole manifest with one text replaced, and what is said of it.
struct Mistake {
  const char* from;
  const char* to;
  const char* message;
};

TEST(ManifestTest, ReportsMistakesAtTheirPlaces) {
  const Mistake mistakes[] = {
      {"\"texgraph_manifest\": 1", "\"texgraph_manifest\": 2",
       "m.json:2:24: error: only manifests of version 1"},
      {"\"glsl450\"", "\"hlsl\"", "'hlsl' is no dialect"},
      {"\"emit\": \"shader\"", "\"emit\": 4", "'emit' of the manifest is of the wrong kind"},
      {"\"name\": \"uv\"", "\"name\": \"st\"", "m.json:4:14: error: there is no input 'st'"},
      {"\"name\": \"uv\", \"type\": \"vec2\"", "\"name\": \"uv\", \"type\": \"vec3\"",
       "input 'uv' is a vec2"},
      {"\"name\": \"uv\"", "\"name\": \"uv\", \"variable\": \"a;b\"", "an input is an identifier"},
      {"\"location\": 3", "\"location\": -1", "'location' must be an integer from 0 to 255"},
      {"\"location\": 3", "\"location\": 1.5", "'location' must be an integer"},
      {"\"out_height\", \"type\": \"float\"", "\"out_height\", \"type\": \"mat2\"",
       "an output is a float, a vec2"},
      {"\"variable\": \"out_color\", ", "", "the manifest has no 'variable' here"},
      {"[1, 0.5, 0]", "[1, 0.5]", "a value of type vec3 has 3 numbers"},
      {"\"value\": 3", "\"value\": \"three\"", "a value of type int has 1 numbers"},
      {"\"status\": \"uniform\", \"value\": 7", "\"status\": \"uniform\"", "a uniform has a value"},
      {"[1, 10]", "[1]", "a range has two numbers"},
      {"\"type\": \"sampler2D\"", "\"type\": \"samplerCube\"", "'samplerCube' is no type"},
      {"[\"a/brick.png\"]", "[]", "a texture has one file"},
      {"[\"a/brick.png\"]", "[\"a\", \"b\"]", "a texture has one file"},
      {"[\"a/brick.png\"]", "[1]", "'files' holds names of files"},
      {"[\"clamp\", \"mirror\"]", "[\"clamp\"]", "'wrap' holds two names"},
      {"[\"clamp\", \"mirror\"]", "[\"clamp\", \"mirror\", \"repeat\"]", "'wrap' holds two names"},
      {"[\"clamp\", \"mirror\"]", "[\"clamp\", \"border\"]", "'border' is no wrap"},
      {"\"max_level\": 4", "\"max_level\": 1000", "'max_level' must be an integer from 0 to 31"},
      {"\"alpha\": \"opacity\"", "\"alpha\": \"straight\"", "'straight' is no alpha"},
      {"\"masks\": [", "\"masks\": [{\"file\": \"a\"}, {\"file\": \"b\"}, ",
       "one mask, or one for each"},
      {"\"file\": \"m.png\", ", "", "the manifest has no 'file' here"},
      {"\"green\"", "\"luma\"", "'luma' is no channel"},
      {"[1, 0.5, 0], \"tol", "[1, 0.5], \"tol", "three numbers from 0 to 1"},
      {"[1, 0.5, 0], \"tol", "[1, 0.5, 2], \"tol", "three numbers from 0 to 1"},
      {"[1, 0.5, 0], \"tol", "[1, 0.5, 0, 0], \"tol", "three numbers from 0 to 1"},
      {"\"tolerance\": 0.25", "\"tolerance\": 1e300", "a number from 0 up to, but not, 1"},
      {"\"edge\": 7", "\"edge\": 65", "'edge' must be an integer from 0 to 64"},
      {"\"holds\": \"lists\", ", "", "the manifest has no 'holds' here"},
      {"\"lists\"", "\"heights\"", "'heights' is no holds"},
      {"\"count\": 12", "\"count\": -1", "'count' must be an integer from 0 to 16777216"},
      {"\"something_new\": [1]", "\"outputs\": []", "outputs"},
  };
  for (const Mistake& mistake : mistakes) {
    std::string text = kWhole;
    const size_t at = text.find(mistake.from);
    ASSERT_NE(at, std::string::npos) << mistake.from;
    text.replace(at, std::string(mistake.from).size(), mistake.to);
    const Outcome outcome = Read(text);
    EXPECT_FALSE(outcome.manifest) << mistake.to;
    EXPECT_THAT(outcome.text, HasSubstr(mistake.message));
    EXPECT_EQ(outcome.diagnostics.exit_code(), ExitCode::kInvalid);
  }
}

TEST(ManifestTest, NeedsAnObjectWithOutputs) {
  EXPECT_THAT(Read("[]").text, HasSubstr("a manifest is an object"));
  EXPECT_THAT(Read("{\"texgraph_manifest\": 1, \"dialect\": \"glsl330\"}").text,
              HasSubstr("no outputs"));
}

}  // namespace
}  // namespace texgraph::runtime
