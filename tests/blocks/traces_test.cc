// SPDX-License-Identifier: Apache-2.0
// What blocks that work on colours leave in the shader: of a blend the functions of its own mode,
// and nothing of the other nineteen, of the choice between them, or of the other form of alpha; of
// a change of hue, saturation and value those of the three that change.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "compiler/base/diagnostics.h"
#include "compiler/base/source.h"
#include "compiler/compile.h"
#include "tests/blocks/blend_reference.h"

namespace texgraph::blocks {
namespace {

using Names = std::set<std::string>;

std::string ShaderOf(const std::string& nodes) {
  std::string text = R"({"texgraph": 1, "parameters": {
      "front": {"type": "vec4", "value": 1, "binding": "uniform"},
      "back": {"type": "vec4", "value": 1, "binding": "uniform"},
      "turn": {"type": "float", "value": 0, "binding": "uniform"}},
    "nodes": {)" + nodes +
                     R"(}, "outputs": {"color": "both"}})";
  Sources sources;
  Diagnostics diagnostics;
  SourceId source = sources.Add("traces.json", text);
  std::optional<Compiled> compiled =
      Compile(source, graph::DocumentFormat::kJson, {}, sources, diagnostics);
  EXPECT_TRUE(compiled.has_value()) << FormatDiagnostics(diagnostics, sources, false);
  return compiled.has_value() ? compiled->glsl : "";
}

// The code without comments and preprocessor lines.
std::string CodeOf(const std::string& shader) {
  std::string code;
  for (size_t at = 0; at < shader.size();) {
    size_t end = std::min(shader.find('\n', at), shader.size());
    std::string line = shader.substr(at, end - at);
    line = line.substr(0, line.find("//"));
    if (!line.starts_with("#")) {
      code += line + "\n";
    }
    at = end + 1;
  }
  return code;
}

std::string BlendCode(const std::string& ports, const std::string& background = "\"back\"") {
  return CodeOf(ShaderOf(R"("both": {"block": "blend", "in": {"foreground": "front", )" + ports +
                         R"(, "background": )" + background + "}}"));
}

// All names before a parenthesis, but for what every shader has: types, main and the block itself.
Names Calls(const std::string& code) {
  Names names;
  for (size_t at = code.find('('); at != std::string::npos; at = code.find('(', at + 1)) {
    size_t start = at;
    while (start > 0 &&
           (std::isalnum(static_cast<unsigned char>(code[start - 1])) || code[start - 1] == '_')) {
      --start;
    }
    names.insert(code.substr(start, at - start));
  }
  for (const char* common : {"", "vec2", "vec3", "vec4", "layout", "main", "blend"}) {
    names.erase(common);
  }
  return names;
}

// What B(Cb, Cs) takes beyond sums and products.
const std::map<std::string, Names> kOfMode = {
    {"mix", {}},
    {"add", {}},
    {"subtract", {"max"}},
    {"multiply", {}},
    {"screen", {}},
    {"overlay", {"hard_light", "mix", "step"}},
    {"darken", {"min"}},
    {"lighten", {"max"}},
    {"difference", {"abs"}},
    {"exclusion", {}},
    {"soft_light", {"soft_light", "min", "max", "sqrt", "mix", "step"}},
    {"hard_light", {"hard_light", "mix", "step"}},
    {"color_dodge", {"quotient_color", "min", "max"}},
    {"color_burn", {"quotient_color", "min", "max", "clamp"}},
    {"linear_burn", {"max"}},
    {"divide", {"quotient_color", "min", "max"}},
    {"linear_light", {"light_color", "max", "clamp"}},
    {"vivid_light", {"light_color", "quotient_color", "min", "max", "clamp", "mix", "step"}},
    {"pin_light", {"light_color", "min", "max", "mix", "step"}},
    {"darker_color", {"dot", "mix", "step"}},
    {"lighter_color", {"dot", "mix", "step"}},
    {"hue", {"set_saturation", "set_luminosity", "dot", "min", "max", "clamp"}},
    {"saturation", {"set_saturation", "set_luminosity", "dot", "min", "max", "clamp"}},
    {"color", {"set_luminosity", "dot", "min", "max", "clamp"}},
    {"luminosity", {"set_luminosity", "dot", "min", "max", "clamp"}},
};

// Functions may be written out where they are called, so the block's own are allowed, not wanted.
void ExpectCalls(const std::string& ports, const Names& wanted, const Names& own) {
  std::string code = BlendCode(ports);
  Names calls = Calls(code), expected = wanted;
  for (const std::string& name : own) {
    if (calls.contains(name)) {
      expected.insert(name);
    } else {
      expected.erase(name);
    }
  }
  EXPECT_EQ(calls, expected) << ports << "\n" << code;
  for (const char* trace : {"if (", "else", "?", "mode", "alpha", "int ", "opacity", "mask"}) {
    EXPECT_EQ(code.find(trace), std::string::npos) << ports << ": " << trace << "\n" << code;
  }
}

TEST(BlendTracesTest, StraightAlphaHasItsModeAlone) {
  for (const auto& [mode, reference] : reference::kBlendModes) {
    Names own, wanted = {"mix", "max"};  // of compositing, and of dividing by alpha
    for (const std::string& name : kOfMode.at(mode)) {
      wanted.insert(name);
      if (name.find('_') != std::string::npos) own.insert(name);
    }
    ExpectCalls("\"mode\": \"" + std::string(mode) + "\"", wanted, own);
  }
}

TEST(BlendTracesTest, PremultipliedAlphaHasItsModeAlone) {
  const Names undivided = {"mix", "add", "multiply", "screen"};
  for (const auto& [mode, reference] : reference::kBlendModes) {
    Names own = {"premultiplied_color"}, wanted = {"mix"};
    if (!undivided.contains(mode)) wanted.insert("max");
    for (const std::string& name : kOfMode.at(mode)) {
      wanted.insert(name);
      if (name.find('_') != std::string::npos) own.insert(name);
    }
    ExpectCalls("\"alpha\": \"premultiplied\", \"mode\": \"" + std::string(mode) + "\"", wanted,
                own);
  }
}

// What the decision for straight alpha costs, and premultiplied alpha saves.
TEST(BlendTracesTest, FourPremultipliedModesDontDivide) {
  for (const char* mode : {"mix", "add", "multiply", "screen"}) {
    std::string ports = "\"mode\": \"" + std::string(mode) + "\"";
    EXPECT_NE(BlendCode(ports).find('/'), std::string::npos) << mode;
    std::string premultiplied = BlendCode(ports + ", \"alpha\": \"premultiplied\"");
    EXPECT_EQ(premultiplied.find('/'), std::string::npos) << mode << premultiplied;
  }
}

TEST(BlendTracesTest, OverAnOpaqueBackgroundNothingIsDivided) {
  std::string code = BlendCode("\"mode\": \"multiply\"", "[0.5, 0.5, 0.5, 1]");
  EXPECT_EQ(code.find('/'), std::string::npos) << code;
  EXPECT_EQ(Calls(code), Names{"mix"}) << code;
}

// A foreground that is not seen is not there: the background goes straight to the output.
TEST(BlendTracesTest, WithoutOpacityOrMaskTheBackgroundIsLeft) {
  for (const auto& [mode, reference] : reference::kBlendModes) {
    for (const char* alpha : {"straight", "premultiplied"}) {
      for (const char* nothing : {"\"opacity\": 0", "\"mask\": 0"}) {
        std::string code = BlendCode("\"mode\": \"" + std::string(mode) + "\", \"alpha\": \"" +
                                     alpha + "\", " + nothing);
        EXPECT_EQ(Calls(code), Names{}) << code;
        EXPECT_EQ(code.find_first_of("+-*/"), std::string::npos) << code;
        EXPECT_EQ(code.find("front"), std::string::npos) << code;
      }
    }
  }
}

// The code of hsv_adjust with these ports.
std::string AdjustCode(const std::string& ports) {
  return CodeOf(
      ShaderOf(R"("both": {"block": "hsv_adjust", "in": {"color": "front", )" + ports + "}}"));
}

TEST(HsvTracesTest, ValueAloneIsAFactor) {
  std::string code = AdjustCode(R"("value": 2)");
  EXPECT_EQ(Calls(code), Names{}) << code;
}

TEST(HsvTracesTest, SaturationAloneAsksForNoHue) {
  std::string code = AdjustCode(R"("saturation": 0.5)");
  Names calls = Calls(code);
  calls.erase("hsv_adjust");
  EXPECT_EQ(calls, (Names{"max", "min", "mix"})) << code;
}

TEST(HsvTracesTest, NoChangeIsNothing) {
  std::string code = AdjustCode(R"("value": 1, "saturation": 1, "hue": 0)");
  EXPECT_EQ(Calls(code), Names{}) << code;
  EXPECT_EQ(code.find_first_of("+-*/"), std::string::npos) << code;
}

TEST(HsvTracesTest, HueGoesRoundTheCircle) {
  Names calls = Calls(AdjustCode(R"("hue": "turn")"));
  EXPECT_TRUE(calls.contains("fract"));
}

TEST(HsvTracesTest, LimitsThatAreEqualDrawNoNumber) {
  std::string code = CodeOf(ShaderOf(R"("grid": {"block": "brick_grid"},
      "both": {"block": "tile_random_hsv",
               "in": {"tile": "grid", "color": "front", "value": 0.5}})"));
  EXPECT_EQ(Calls(code), Names{}) << code;
}

}  // namespace
}  // namespace texgraph::blocks
