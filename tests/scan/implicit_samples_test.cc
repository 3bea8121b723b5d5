// SPDX-License-Identifier: Apache-2.0
// Every example graph is scanned for samples whose implicit derivatives would be wrong; and shaders with such mistakes are found.
#include "tests/scan/implicit_samples.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "compiler/compile.h"
#include "compiler/spirv/compile_spirv.h"

namespace texgraph::scan {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> Graphs() {
  std::vector<fs::path> graphs;
  for (const auto& entry : fs::recursive_directory_iterator(TEXGRAPH_SOURCE_DIR "/graphs")) {
    std::string extension = entry.path().extension().string();
    if (extension == ".json" || extension == ".jsonc" || extension == ".yaml") graphs.push_back(entry.path());
  }
  std::ranges::sort(graphs);
  return graphs;
}

std::string TextOf(const fs::path& path) {
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

ImplicitSamples ScanText(const std::string& body) {
  Diagnostics diagnostics;
  auto words = spirv::CompileSpirv(
      "#version 450 core\n"
      "layout(location = 0) in vec2 uv;\n"
      "layout(location = 0) uniform float amount;\n"
      "layout(binding = 0) uniform sampler2D picture;\n"
      "layout(binding = 1) uniform sampler2DArray pictures;\n"
      "layout(location = 0) out vec4 color;\n" +
          body,
      diagnostics);
  EXPECT_TRUE(words) << body;
  auto found = FindImplicitSamples(words.value_or(std::vector<uint32_t>()));
  EXPECT_TRUE(found);
  return found.value_or(ImplicitSamples());
}

TEST(ImplicitSamplesTest, EveryExampleGraphIsRight) {
  int scanned = 0, samples = 0;
  for (const fs::path& path : Graphs()) {
    SCOPED_TRACE(path);
    Sources sources;
    Diagnostics diagnostics;
    std::string text = TextOf(path);
    SourceId source = sources.Add(path.string(), text);
    CompileOptions options;
    options.target = Target::kSpirv;
    auto compiled = Compile(source, graph::FormatOf(path.string(), text), options, sources, diagnostics);
    ASSERT_TRUE(compiled) << FormatDiagnostics(diagnostics, sources, false);
    auto found = FindImplicitSamples(compiled->spirv);
    ASSERT_TRUE(found);
    for (const std::string& mistake : found->mistakes) ADD_FAILURE() << mistake;
    ++scanned;
    samples += found->implicit + found->explicit_;
  }
  EXPECT_GT(scanned, 5);
  EXPECT_GT(samples, 4);
}

TEST(ImplicitSamplesTest, LayersMayJump) {
  EXPECT_TRUE(ScanText("void main() { color = texture(pictures, vec3(uv, floor(uv.x))); }").mistakes.empty());
  EXPECT_EQ(ScanText("void main() { color = texture(pictures, vec3(fract(uv), 1.0)); }").mistakes.size(), 1u);
  EXPECT_EQ(ScanText("void main() { color = texture(pictures, vec3(uv.x, floor(uv.y), 1.0)); }").mistakes.size(), 1u);
}

TEST(ImplicitSamplesTest, PlainSamplesAreFine) {
  ImplicitSamples found = ScanText("void main() { color = texture(picture, sin(uv) * amount + 0.5); }");
  EXPECT_EQ(found.implicit, 1);
  EXPECT_TRUE(found.mistakes.empty());
  EXPECT_TRUE(ScanText("void main() { color = texture(picture, uv + texture(picture, uv).xy); }").mistakes.empty());
}

// One of two coordinates, the same one for all pixels.
TEST(ImplicitSamplesTest, UniformChoicesAreFine) {
  const std::string begin = "void main() { vec2 p = uv; if (", end = ") p = uv.yx + 1.0; color = texture(picture, p); }";
  EXPECT_TRUE(ScanText(begin + "amount > 0.5" + end).mistakes.empty());
  EXPECT_EQ(ScanText(begin + "uv.x > 0.5" + end).mistakes.size(), 1u);
}

// A constant of 40 is not the value with the id 40.
TEST(ImplicitSamplesTest, NumbersAreNoIds) {
  for (int number = 1; number < 100; ++number) {
    std::string body = "void main() { color = texture(picture, uv * float(int(amount) + " + std::to_string(number) +
                       ")) + fract(uv.x); }";
    EXPECT_TRUE(ScanText(body).mistakes.empty()) << body;
  }
}

// The member that varies is not the one that is converted.
TEST(ImplicitSamplesTest, MembersOfStructsAreApart) {
  const std::string begin = "struct Tile { vec2 local; int seed; };\n"
                            "void main() { Tile tile = Tile(uv, int(amount)); color = texture(picture, ";
  EXPECT_TRUE(ScanText(begin + "tile.local * float(tile.seed)); }").mistakes.empty());
  EXPECT_FALSE(ScanText(begin + "tile.local * float(int(tile.local.x))); }").mistakes.empty());
}

TEST(ImplicitSamplesTest, JumpsAreFound) {
  for (const char* coordinate :
       {"fract(uv)", "floor(uv * 3.0)", "uv + float(int(uv.x))", "mod(uv, 2.0)", "uv.x < 0.5 ? uv : uv.yx",
        "vec2(atan(uv.y, uv.x))", "sign(uv) * uv.x", "step(0.5, uv)"}) {
    SCOPED_TRACE(coordinate);
    std::string body = std::string("void main() { color = texture(picture, ") + coordinate + "); }";
    EXPECT_EQ(ScanText(body).mistakes.size(), 1u);
  }
}

TEST(ImplicitSamplesTest, JumpsInsideFunctionsAreFound) {
  EXPECT_EQ(ScanText("vec4 at(vec2 p) { return texture(picture, p); }\n"
                     "void main() { color = at(uv) + at(fract(uv)); }")
                .mistakes.size(),
            1u);
}

TEST(ImplicitSamplesTest, BranchesAndLoopsAreFound) {
  EXPECT_FALSE(ScanText("void main() { color = vec4(0.0); if (uv.x > 0.5) color = texture(picture, uv); }")
                   .mistakes.empty());
  EXPECT_FALSE(ScanText("void main() { color = vec4(0.0);\n"
                        "  for (int i = 0; i < 3; ++i) color += texture(picture, uv * float(i) * amount); }")
                   .mistakes.empty());
}

}  // namespace
}  // namespace texgraph::scan
