// SPDX-License-Identifier: Apache-2.0
// What is not seen is not in the shader: of a layer without opacity, or with a chance of 0, neither
// its picture nor its parameters nor its functions; of a channel that no output needs neither.
// And a layer that is seen, and stays in its cell, takes one sample.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>

#include "compiler/base/diagnostics.h"
#include "compiler/base/source.h"
#include "compiler/blocks/block.h"
#include "compiler/compile.h"
#include "compiler/graph/checked_graph.h"
#include "compiler/graph/graph.h"
#include "compiler/ir/module.h"
#include "tests/blocks/blend_reference.h"
#include "tests/blocks/run_block.h"

namespace texgraph::blocks {
namespace {

// What a shader consists of.
struct Shader {
  std::set<std::string> textures, uniforms;
  std::multiset<std::string> functions;
  int samples = 0;     // with those of the functions that main calls, each time
  int operations = 0;  // in all functions
};

Shader ShaderOf(const std::string& nodes, const std::string& output) {
  const std::string text = R"({"texgraph": 1,
    "textures": {"brick": {"file": "brick.png"}, "soot": {"file": "soot.png"}},
    "parameters": {
      "tint": {"type": "vec3", "value": 1, "binding": "uniform"},
      "strength": {"type": "float", "value": 1, "binding": "uniform"}},
    "functions": {"splash": {"inputs": {"uv": "vec2"}, "nodes": {
        "clouds": {"block": "value_noise", "in": {"uv": "uv", "seed": 7}},
        "disc": {"block": "circle", "in": {"uv": "uv", "radius": 0.4}},
        "rgb": {"block": "combine3", "in": {"x": "clouds", "y": "clouds", "z": "clouds"}},
        "lime": {"block": "rgba", "in": {"color": "rgb", "alpha": "disc"}}},
      "outputs": {"color": "lime"}}},
    "nodes": {"grid": {"block": "brick_grid"},
      "bricks": {"block": "layer", "in": {"tile": "grid", "image": "brick", "scale": [0.8, 0.9]}},)" +
                           nodes + R"(}, "outputs": {)" + output + "}}";
  Sources sources;
  Diagnostics diagnostics;
  SourceId source = sources.Add(PictureFolder() + "traces.json", text);
  std::optional<Lowered> lowered =
      Lower(source, graph::DocumentFormat::kJson, {}, sources, diagnostics);
  Shader shader;
  if (!lowered.has_value()) {
    ADD_FAILURE() << FormatDiagnostics(diagnostics, sources, false);
    return shader;
  }
  for (const ir::Global& global : lowered->module->globals) {
    if (global.kind == ir::GlobalKind::kTexture) shader.textures.insert(global.name);
    if (global.kind == ir::GlobalKind::kUniform) shader.uniforms.insert(global.name);
  }
  // Callees come before callers.
  std::vector<int> samples;
  for (const ir::Function& function : lowered->module->functions) {
    shader.functions.insert(function.display_name);
    samples.push_back(0);
    for (const ir::Inst& inst : function.insts) {
      samples.back() += inst.op == ir::Op::kSample || inst.op == ir::Op::kSampleGrad ||
                        inst.op == ir::Op::kSampleLod;
      if (inst.op == ir::Op::kCall) samples.back() += samples[inst.aux];
      shader.operations += ir::Info(inst.op).cost > 0;
    }
  }
  shader.samples = samples.empty() ? 0 : samples.back();
  return shader;
}

// `mixed` is the layer on the bricks, by `ports` of the block that does it.
std::string LayerOnBricks(const std::string& image, const std::string& ranges,
                          const std::string& block, const std::string& ports) {
  return R"("top": {"block": "layer", "in": {"tile": "bricks.inner", "image": ")" + image +
         R"(", "tint": "tint", "scale": [0.3, 0.4], "rotation": [-20, 20], "stream": 1, )" +
         ranges + R"(}}, "mixed": {"block": ")" + block +
         R"(", "in": {"foreground": "top.color", "background": "bricks.color")" + ports + "}}";
}

void ExpectNoTrace(const std::string& block, const std::string& ports) {
  const Shader bare = ShaderOf(R"("none": {"block": "brick_grid"})", R"("color": "bricks.color")");
  for (const char* image : {"soot", "splash"}) {
    for (const char* ranges :
         {R"("opacity": [0, 0])", R"("chance": 0)", R"("chance": 0, "opacity": [0.2, 0.7])",
          R"("chance": 0.5, "opacity": 0, "turn": "quarters")"}) {
      Shader shader = ShaderOf(LayerOnBricks(image, ranges, block, ports), R"("color": "mixed")");
      const std::string what = std::string(image) + " " + ranges + " " + block + ports;
      EXPECT_EQ(shader.textures, bare.textures) << what;
      EXPECT_EQ(shader.uniforms, bare.uniforms) << what;
      EXPECT_EQ(shader.functions.size(), bare.functions.size()) << what;
      EXPECT_EQ(shader.samples, 1) << what;
      EXPECT_EQ(shader.operations, bare.operations) << what;
    }
  }
}

TEST(LayerTracesTest, AnUnseenLayerIsNotThereOver) { ExpectNoTrace("over", ""); }

TEST(LayerTracesTest, AnUnseenLayerIsNotThereBlended) {
  for (const auto& [mode, reference] : reference::kBlendModes) {
    ExpectNoTrace("blend", R"(, "opacity": "strength", "mode": ")" + std::string(mode) + '"');
  }
}

// The same layers leave traces as soon as anything of them is seen: the test above can fail.
TEST(LayerTracesTest, ASeenLayerIsThere) {
  for (const char* ranges : {R"("opacity": [0, 0.01])", R"("chance": 0.01)"}) {
    Shader shader = ShaderOf(LayerOnBricks("soot", ranges, "over", ""), R"("color": "mixed")");
    EXPECT_TRUE(shader.textures.contains("soot"));
    EXPECT_TRUE(shader.uniforms.contains("tint"));
    EXPECT_EQ(shader.samples, 2);
  }
}

// Of a layer of which only the alpha is used, what makes its colour is gone.
TEST(LayerTracesTest, AnUnusedColourIsNotThere) {
  const std::string layer =
      LayerOnBricks("splash", R"("opacity": [0.5, 1])", "over", "") +
      R"(, "mask": {"block": "channel", "in": {"color": "top.color", "name": "a"}})";
  Shader shader = ShaderOf(layer, R"("height": "mask")");
  EXPECT_TRUE(shader.textures.empty());
  EXPECT_TRUE(shader.uniforms.empty());
  EXPECT_EQ(shader.functions.count("value_noise"), 0u);
  Shader all = ShaderOf(layer, R"("height": "mask", "color": "mixed")");
  EXPECT_EQ(all.uniforms, (std::set<std::string>{"tint"}));
  EXPECT_EQ(all.functions.count("value_noise"), 1u);
}

// One sample for each layer that is seen, whatever varies, as long as elements stay in their cells.
TEST(LayerTracesTest, OneSampleForEachVisibleLayer) {
  std::string nodes, last = "bricks.color";
  for (int layers = 1; layers <= 4; ++layers) {
    Shader shader = ShaderOf(nodes.empty() ? R"("none": {"block": "brick_grid"})" : nodes,
                             R"("color": ")" + last + '"');
    EXPECT_EQ(shader.samples, layers);
    const std::string number = std::to_string(layers);
    nodes += (nodes.empty() ? "" : ", ") + std::string(R"("top)") + number +
             R"(": {"block": "layer", "in": {"tile": "bricks.inner", "image": "soot",
               "position_min": 0.4, "position_max": 0.6, "scale": [0.3, 0.4], "rotation": [-20, 20],
               "opacity": [0.2, 0.8], "chance": 0.7, "turn": "halves", "flip": "both",
               "fade_size": 4, "stream": )" +
             number + R"(}}, "mixed)" + number +
             R"(": {"block": "over", "in": {"foreground": "top)" + number +
             R"(.color", "background": ")" + last + R"("}})";
    last = "mixed" + number;
  }
}

}  // namespace
}  // namespace texgraph::blocks
