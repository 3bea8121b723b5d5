// SPDX-License-Identifier: Apache-2.0
// Names: the users' own, unique in their scope, and never one that GLSL has taken.
#include "compiler/glsl/names.h"

#include <string>

#include "compiler/base/text.h"
#include "tests/unit/glsl/shader_text.h"

namespace texgraph::glsl {
namespace {

TEST(Identifier, KeepsOnlyWhatGlslAllows) {
  EXPECT_EQ(Identifier("brick_2"), "brick_2");
  EXPECT_EQ(Identifier("a__b"), "a_b");
  EXPECT_EQ(Identifier("___a"), "_a");
  EXPECT_EQ(Identifier("1abc"), "abc");
  EXPECT_EQ(Identifier("gl_FragColor"), "FragColor");
  EXPECT_EQ(Identifier("x; discard; //\n"), "x_discard_");
  EXPECT_EQ(Identifier("\xc3\xa9"), "value");
  EXPECT_EQ(Identifier(""), "value");
  EXPECT_EQ(Identifier("42"), "value");
  EXPECT_LE(Identifier(std::string(100000, 'a')).size(), 256u);
}

TEST(Comment, StaysOnItsLine) {
  std::string text;
  AppendComment("a\n#error \\\x1b]0;\xe2\x80\xae */", text);
  EXPECT_EQ(text, "a_#error __]0;___ */");
}

TEST(NameTable, NumbersOnClash) {
  NameTable names;
  EXPECT_EQ(names.Claim("uv"), "uv");
  EXPECT_EQ(names.Claim("uv"), "uv2");
  EXPECT_EQ(names.Claim("uv3"), "uv3");
  EXPECT_EQ(names.Claim("uv"), "uv4");
  EXPECT_EQ(names.Claim("v1"), "v1");
  EXPECT_EQ(names.Claim("v1"), "v1_2");
}

TEST(NameTable, GivesNoWordOfGlsl) {
  NameTable names;
  for (const char* word : {"sample", "texture", "mix", "main", "half", "void", "vec3", "input"}) {
    std::string name(names.Claim(word));
    EXPECT_FALSE(IsReservedInGlsl(name)) << name;
    EXPECT_EQ(name, std::string(word) + (word == std::string("vec3") ? "_2" : "2"));
  }
}

TEST(NameTable, ScopesGiveTheirNamesBack) {
  NameTable names;
  names.Claim("a");
  names.Open();
  EXPECT_EQ(names.Claim("a"), "a2");
  EXPECT_EQ(names.Claim("b"), "b");
  names.Open();
  EXPECT_EQ(names.Claim("a"), "a3");
  names.Close();
  EXPECT_EQ(names.Claim("a"), "a3");
  names.Close();
  EXPECT_EQ(names.Claim("a"), "a2");
  EXPECT_EQ(names.Claim("b"), "b");
}

TEST(NameTable, ManyClashesAreQuick) {
  NameTable names;
  for (int i = 0; i < 200000; ++i) names.Claim("x");
  EXPECT_EQ(names.Claim("x"), "x200001");
}

// The graph's inputs, uniforms and nodes come first, then outputs, structs and functions;
// parameters may hide globals that their function does not use.
TEST(Names, ClashesAreSettledByNumbers) {
  const std::string module = R"(struct Tile { cell: ivec2, local: vec2 }
origin #0 = "" "noise_value" "noise/noise_value.glsl"
origin #1 = "layer" "layer" "layers/layer.glsl"
origin #2 = "out_color" "noise_value" "noise/noise_value.glsl"
origin #3 = "texel" "image" "images/image.glsl"
input uv: vec2
uniform out_color: vec3 = vec3(1.0)
uniform Tile: float = 0.5
texture brick: sampler2D
function layer_0 as layer(%uv: vec2, %layer: float, %step: float, %tile: Tile) -> (vec4, layer: float) #0 {
  %uv.2 = mul %uv, vec2(2.0) : vec2
  %1 = length %uv.2 : float
  %2 = step %layer, %1 : float
  %3 = mul %2, %step : float
  %b = sample_lod @brick, %uv.2, %3 : vec4
  %local = extract.1 %tile : vec2
  %4 = extract.0 %local : float
  return %b, %4
}
function layer_1 as layer(%uv: vec2) -> float #0 {
  %1 = length %uv : float
  %2 = mul %1, @Tile : float
  return %2
}
function main() -> (color: vec4, height: float) {
  %1 = convert @uv : ivec2
  %2 = construct %1, @uv : Tile
  %layer = call layer_0(@uv, 1.0, 2.0, %2) : (vec4, float) #1
  %3 = extract.0 %layer : vec4
  %4 = extract.1 %layer : float
  %out_color = call layer_1(@uv) : float #2
  %5 = sample @brick, @uv : vec4 #3
  %6 = sample @brick, vec2(0.5) : vec4
  %texel = mul %5, %5 : vec4
  %7 = add %6, %texel : vec4
  %8 = mul %7, %6 : vec4
  %9 = mul %8, %3 : vec4
  %11 = extract.0 @out_color : float
  %12 = splat %11 : vec4
  %13 = mul %9, %12 : vec4
  %14 = add %4, %out_color : float
  return %13, %14
}
main main
)";
  EXPECT_EQ(Shader(module), R"(// test: a fragment shader, compiled by texgraphc 1.0.
#version 330

// Inputs
in vec2 uv;

// Parameters
uniform vec3 out_color;  // default vec3(1.0)
uniform float Tile;  // default 0.5

// Textures
uniform sampler2D brick;

// Outputs
layout(location = 0) out vec4 out_color2;
layout(location = 1) out float out_height;

// Types
struct Tile2 {
  ivec2 cell;
  vec2 local;
};

// layer, of noise_value (noise/noise_value.glsl)
vec4 layer_block(vec2 uv, float layer, float step2, Tile2 tile, out float layer2) {
  vec2 uv2 = uv * 2.0;
  vec4 b = textureLod(brick, uv2, step(layer, length(uv2)) * step2);
  layer2 = tile.local.x;
  return b;
}

// layer, of noise_value (noise/noise_value.glsl)
float layer_block2(vec2 uv) {
  return length(uv) * Tile;
}

void main() {
  // layer: layer (layers/layer.glsl)
  float layer_layer;
  vec4 layer = layer_block(uv, 1.0, 2.0, Tile2(ivec2(uv), uv), layer_layer);
  // out_color: noise_value (noise/noise_value.glsl)
  float out_color3 = layer_block2(uv);
  // texel: image (images/image.glsl)
  vec4 texel2 = texture(brick, uv);
  vec4 texel3 = texture(brick, vec2(0.5));
  vec4 texel = texel2 * texel2;
  out_color2 = (texel3 + texel) * texel3 * layer * out_color.x;
  out_height = layer_layer + out_color3;
}
)");
  EXPECT_TRUE(IsValid(module));
}

// GLSL takes the overload whose parameters have the arguments' types; outputs tell none apart, for
// they count as parameters.
TEST(Names, FunctionsWithOtherParametersAreOverloads) {
  const std::string module = R"(input uv: vec2
function twice_0 as twice(%a: float) -> float {
  %1 = add %a, %a : float
  return %1
}
function twice_1 as twice(%a: vec2) -> vec2 {
  %1 = add %a, %a : vec2
  return %1
}
function twice_2 as twice(%a: vec2) -> vec2 {
  %1 = mul %a, vec2(2.0) : vec2
  return %1
}
function twice_3 as twice(%a: vec2, %b: float) -> float {
  %1 = extract.0 %a : float
  %2 = mul %1, %b : float
  return %2
}
function twice_4 as twice(%a: float, %b: float) -> float {
  %1 = mul %a, %b : float
  return %1
}
function main() -> (color: vec4) {
  %1 = call twice_1(@uv) : vec2
  %2 = call twice_2(@uv) : vec2
  %3 = extract.0 %1 : float
  %4 = extract.1 %2 : float
  %5 = call twice_0(%3) : float
  %6 = call twice_3(%2, %5) : float
  %7 = call twice_4(%6, %4) : float
  %8 = construct %5, %6, %7, 1.0 : vec4
  return %8
}
main main
)";
  std::string text = Functions(module);
  for (const char* line :
       {"float twice(float a) {", "vec2 twice(vec2 a) {", "vec2 twice2(vec2 a) {",
        "float twice3(vec2 a, float b) {", "float twice2(float a, float b) {"}) {
    EXPECT_NE(text.find(line), std::string::npos) << line << "\n" << text;
  }
  EXPECT_TRUE(IsValid(module));
}

TEST(Names, BelongToTheirScopes) {
  const std::string module = R"(input uv: vec2
function main() -> (x: float) {
  %u = extract.0 @uv : float
  %1 = lt %u, 0.5 : bool
  %2 = if %1 : float {
    %d = sin %u : float
    %3 = mul %d, %d : float
    yield %3
  } else {
    %d.2 = cos %u : float
    %4 = mul %d.2, %d.2 : float
    yield %4
  }
  %d.3 = sqrt %2 : float
  %5 = mul %d.3, %d.3 : float
  %6 = for %i = 0 to 4 step 1 (%7 = %5) : float {
    %d.4 = sin %7 : float
    %8 = mul %d.4, %d.3 : float
    %9 = add %8, %d.4 : float
    yield %9
  }
  %10 = for %i.2 = 0 to 4 step 1 (%11 = %6) : float {
    %12 = mul %11, 0.5 : float
    yield %12
  }
  return %10
}
main main
)";
  EXPECT_EQ(MainBody(module), R"(  float choice;
  if (uv.x < 0.5) {
    float d = sin(uv.x);
    choice = d * d;
  } else {
    float d = cos(uv.x);
    choice = d * d;
  }
  float d = sqrt(choice);
  float total = d * d;
  for (int i = 0; i < 4; ++i) {
    float d2 = sin(total);
    total = d2 * d + d2;
  }
  for (int i = 0; i < 4; ++i) {
    total *= 0.5;
  }
  out_x = total;
)");
  EXPECT_TRUE(IsValid(module));
}

// What an author assigned to one variable stays one variable, unless its old value is still needed.
TEST(Names, OneNameIsOneVariableWhereItCan) {
  const std::string module = R"(input uv: vec2
function main() -> (x: vec2) {
  %p = mul @uv, vec2(4.0) : vec2
  %p.2 = add %p, vec2(0.5) : vec2
  %p.3 = fract %p.2 : vec2
  %p.4 = mul vec2(2.0), %p.3 : vec2
  %q = add %p.4, %p.3 : vec2
  %p.5 = sub %p.4, %q : vec2
  %old = mul %p.5, %p.5 : vec2
  %p.6 = add %p.5, vec2(-1.0) : vec2
  %7 = mul %p.6, %old : vec2
  %8 = add %p.5, %7 : vec2
  return %8
}
main main
)";
  EXPECT_EQ(MainBody(module), R"(  vec2 p = uv * 4.0;
  p += 0.5;
  p = fract(p);
  vec2 p2 = 2.0 * p;
  vec2 q = p2 + p;
  p2 -= q;
  vec2 old = p2 * p2;
  vec2 p3 = p2 - 1.0;
  out_x = p2 + p3 * old;
)");
  EXPECT_TRUE(IsValid(module));
}

}  // namespace
}  // namespace texgraph::glsl
