// SPDX-License-Identifier: Apache-2.0
// Whole shaders: sections, comments, declarations, both dialects, and the graph as a function.
#include <string>

#include "compiler/glsl/legalize.h"
#include "tests/unit/glsl/shader_text.h"

namespace texgraph::glsl {
namespace {

constexpr char kWall[] = R"(struct Tile { cell: ivec2, local: vec2, seed: uint }
origin #0 = "" "brick_grid" "tiles/brick_grid.glsl"
origin #1 = "" "layer" "layers/layer.glsl"
origin #2 = "grid" "brick_grid" "tiles/brick_grid.glsl"
origin #3 = "face" "layer" "layers/layer.glsl"
input uv: vec2
input normal: vec3
uniform tint: vec3 = vec3(1.0)
uniform unused: float = 2.0
specialization gain: float = 0.5
texture brick: sampler2D
function brick_grid_1 as brick_grid(%uv: vec2, %rows: int) -> (Tile, mask: float) #0 {
  %1 = convert %rows : float
  %2 = splat %1 : vec2
  %p = mul %uv, %2 : vec2
  %3 = floor %p : vec2
  %cell = convert %3 : ivec2
  %local = fract %p : vec2
  %4 = extract.0 %cell : int
  %5 = convert %4 : uint
  %6 = mul %5, 747796405u : uint
  %7 = extract.1 %cell : int
  %8 = convert %7 : uint
  %seed = add %6, %8 : uint
  %9 = construct %cell, %local, %seed : Tile
  %10 = sub %local, vec2(0.5) : vec2
  %11 = length %10 : float
  %12 = lt 0.25, %11 : bool
  %13 = select %12, 0.0, 1.0 : float
  return %9, %13
}
function layer_3 as layer(%tile: Tile, %image: sampler2D, %tint: vec3, %dx: vec2, %dy: vec2) -> vec4 #1 {
  %local = extract.1 %tile : vec2
  %texel = sample_grad %image, %local, %dx, %dy : vec4
  %seed = extract.2 %tile : uint
  %1 = and %seed, 3u : uint
  %2 = convert %1 : int
  %weight = index float[4](0.25, 0.5, 0.75, 1.0), %2 : float
  %3 = swizzle.xyz %texel : vec3
  %4 = mul %3, %tint : vec3
  %5 = splat %weight : vec3
  %6 = mul %4, %5 : vec3
  %7 = extract.0 %6 : float
  %8 = extract.1 %6 : float
  %9 = extract.2 %6 : float
  %10 = extract.3 %texel : float
  %11 = construct %7, %8, %9, %10 : vec4
  return %11
}
function main() -> (color: vec4, height: float) {
  %1 = dfdx @uv : vec2
  %2 = dfdy @uv : vec2
  %grid = call brick_grid_1(@uv, 12) : (Tile, float) #2
  %grid_tile = extract.0 %grid : Tile #2
  %grid_mask = extract.1 %grid : float #2
  %3 = mul %1, vec2(12.0) : vec2 #3
  %4 = mul %2, vec2(12.0) : vec2 #3
  %face = call layer_3(%grid_tile, @brick, @tint, %3, %4) : vec4 #3
  %5 = splat @gain : vec4
  %6 = mul %face, %5 : vec4
  return %6, %grid_mask
}
main main
)";

constexpr char kBlocks[] = R"(// brick_grid (tiles/brick_grid.glsl)
Tile brick_grid(vec2 uv, int rows, out float mask) {
  vec2 p = uv * float(rows);
  ivec2 cell = ivec2(floor(p));
  vec2 local = fract(p);
  uint seed = uint(cell.x) * 747796405u + uint(cell.y);
  mask = length(local - 0.5) > 0.25 ? 0.0 : 1.0;
  return Tile(cell, local, seed);
}

// layer (layers/layer.glsl)
vec4 layer(Tile tile, sampler2D image, vec3 tint, vec2 dx, vec2 dy) {
  vec4 texel = textureGrad(image, tile.local, dx, dy);
  float weight = table[int(tile.seed & 3u)];
  return vec4(texel.xyz * tint * weight, texel.w);
}

)";

constexpr char kMain[] = R"(  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // grid: brick_grid (tiles/brick_grid.glsl)
  float grid_mask;
  Tile grid_tile = brick_grid(uv, 12, grid_mask);
  // face: layer (layers/layer.glsl)
  vec4 face = layer(grid_tile, brick, tint, uv_dx * 12.0, uv_dy * 12.0);
)";

TEST(Shader, OfVersion330) {
  EXPECT_EQ(Shader(kWall), std::string(R"(// test: a fragment shader, compiled by texgraphc 1.0.
#version 330

// Inputs
in vec2 uv;

// Parameters
const float gain = 0.5;
uniform vec3 tint;  // default vec3(1.0)

// Textures
uniform sampler2D brick;

// Outputs
layout(location = 0) out vec4 out_color;
layout(location = 1) out float out_height;

// Types
struct Tile {
  ivec2 cell;
  vec2 local;
  uint seed;
};

// Constants
const float table[4] = float[4](0.25, 0.5, 0.75, 1.0);

)") + kBlocks + "void main() {\n" +
                               kMain + R"(  out_color = face * gain;
  out_height = grid_mask;
}
)");
  EXPECT_TRUE(IsValid(kWall));
}

TEST(Shader, OfVersion450HasLocations) {
  std::string shader = Shader(kWall, Dialect::k450);
  EXPECT_EQ(shader.substr(0, shader.find("// Types")),
            R"(// test: a fragment shader, compiled by texgraphc 1.0.
#version 450 core

// Inputs
layout(location = 0) in vec2 uv;

// Parameters
const float gain = 0.5;
layout(location = 0) uniform vec3 tint;  // default vec3(1.0)

// Textures
layout(location = 1, binding = 0) uniform sampler2D brick;

// Outputs
layout(location = 0) out vec4 out_color;
layout(location = 1) out float out_height;

)");
}

// What stands beside other shaders in one file begins all its names with its own.
TEST(Shader, AsAFunction) {
  std::string function = Shader(kWall, Dialect::k330, true);
  EXPECT_EQ(function,
            R"(// test: a function for a shader of #version 330 or later, compiled by texgraphc 1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Parameters
const float gain = 0.5;
uniform vec3 tint;  // default vec3(1.0)

// Textures
uniform sampler2D brick;

// Types
struct test_Tile {
  ivec2 cell;
  vec2 local;
  uint seed;
};

// Constants
const float test_table[4] = float[4](0.25, 0.5, 0.75, 1.0);

// brick_grid (tiles/brick_grid.glsl)
test_Tile test_brick_grid(vec2 uv, int rows, out float mask) {
  vec2 p = uv * float(rows);
  ivec2 cell = ivec2(floor(p));
  vec2 local = fract(p);
  uint seed = uint(cell.x) * 747796405u + uint(cell.y);
  mask = length(local - 0.5) > 0.25 ? 0.0 : 1.0;
  return test_Tile(cell, local, seed);
}

// layer (layers/layer.glsl)
vec4 test_layer(test_Tile tile, sampler2D image, vec3 tint, vec2 dx, vec2 dy) {
  vec4 texel = textureGrad(image, tile.local, dx, dy);
  float weight = test_table[int(tile.seed & 3u)];
  return vec4(texel.xyz * tint * weight, texel.w);
}

void test(vec2 uv, out vec4 color, out float height) {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // grid: brick_grid (tiles/brick_grid.glsl)
  float grid_mask;
  test_Tile grid_tile = test_brick_grid(uv, 12, grid_mask);
  // face: layer (layers/layer.glsl)
  vec4 face = test_layer(grid_tile, brick, tint, uv_dx * 12.0, uv_dy * 12.0);
  color = face * gain;
  height = grid_mask;
}
)");
  std::string use = "#version 330\n" + function +
                    "in vec2 coordinate; out vec4 result;\n"
                    "void main() { float h; test(coordinate, result, h); }\n";
  EXPECT_EQ(Complaint(use), "");
}

// Nothing there takes derivatives, so it may be called anywhere.
TEST(Shader, AsAFunctionWithOneOutput) {
  std::string function = Shader(R"(input uv: vec2
input normal: vec3
function main() -> (height: float) {
  %1 = extract.0 @uv : float
  %2 = extract.2 @normal : float
  %3 = mul %1, %2 : float
  return %3
}
main main
)",
                                Dialect::k330, true);
  EXPECT_EQ(function,
            R"(// test: a function for a shader of #version 330 or later, compiled by texgraphc 1.0.

float test(vec2 uv, vec3 normal) {
  return uv.x * normal.z;
}
)");
}

TEST(Shader, TellsWhatItDeclares) {
  ir::Module module = ModuleOf(kWall);
  Diagnostics diagnostics;
  ASSERT_TRUE(Legalize(module, Dialect::k450, diagnostics));
  PrintOptions options;
  options.dialect = Dialect::k450;
  options.for_spirv = true;
  ShaderInterface interface;
  std::string shader = PrintGlsl(module, options, &interface);
  ASSERT_EQ(interface.inputs.size(), 1u);
  EXPECT_EQ(interface.inputs[0].name, "uv");
  EXPECT_EQ(interface.inputs[0].location, 0u);
  ASSERT_EQ(interface.uniforms.size(), 1u);
  EXPECT_EQ(interface.uniforms[0].name, "tint");
  EXPECT_EQ(interface.uniforms[0].location, 0u);
  EXPECT_EQ(module.globals[interface.uniforms[0].global.index].name, "tint");
  ASSERT_EQ(interface.specializations.size(), 1u);
  EXPECT_EQ(interface.specializations[0].constant_id, 0u);
  ASSERT_EQ(interface.textures.size(), 1u);
  EXPECT_EQ(interface.textures[0].location, 1u);
  EXPECT_EQ(interface.textures[0].binding, 0u);
  ASSERT_EQ(interface.outputs.size(), 2u);
  EXPECT_EQ(interface.outputs[1].name, "out_height");
  EXPECT_EQ(interface.outputs[1].location, 1u);
  EXPECT_NE(shader.find("layout(constant_id = 0) const float gain = 0.5;"), std::string::npos);
}

// The same module gives the same bytes.
TEST(Shader, IsDeterministic) { EXPECT_EQ(Shader(kWall), Shader(kWall)); }

// Dead values, dead functions and functions that only these call are not there.
TEST(Shader, HasNothingThatNothingUses) {
  EXPECT_EQ(Functions(R"(input uv: vec2
texture t: sampler2D
function f(%x: float) -> float {
  return %x
}
function g(%x: float) -> float {
  %1 = call f(%x) : float
  return %1
}
function main() -> (x: float) {
  %1 = extract.0 @uv : float
  %2 = call g(%1) : float
  %3 = for %i = 0 to 4 step 1 (%a = 0.0, %b = %2) : (float, float) {
    %4 = sin %b : float
    yield %a, %4
  }
  %5 = sample @t, @uv : vec4
  return %1
}
main main
)"),
            "void main() {\n  out_x = uv.x;\n}\n");
}

// Aggregates are carried and chosen whole; ?: takes no arrays.
TEST(Shader, ArraysAndStructs) {
  constexpr char kModule[] = R"(struct Set { weights: float[3], size: int }
input uv: vec2
function pick(%set: Set, %table: float[3], %c: bool) -> (float[3], other: Set) {
  %1 = select %c, %table, float[3](1.0, 2.0, 3.0) : float[3]
  %2 = extract.0 %set : float[3]
  %3 = extract.2 %2 : float
  %4 = construct %3, %3, %3 : float[3]
  %5 = construct %4, 3 : Set
  return %1, %5
}
function main() -> (x: float) {
  %1 = extract.0 @uv : float
  %2 = construct %1, 2.0, %1 : float[3]
  %3 = construct %2, 1 : Set
  %4 = lt %1, 0.5 : bool
  %set = for %i = 0 to 4 step 1 (%s = %3) : Set {
    %r = call pick(%s, %2, %4) : (float[3], Set)
    %5 = extract.0 %r : float[3]
    %6 = construct %5, %i : Set
    yield %6
  }
  %7 = extract.0 %set : float[3]
  %8 = extract.1 %set : int
  %9 = index %7, %8 : float
  return %9
}
main main
)";
  EXPECT_EQ(Functions(kModule), R"(float[3] pick(Set set, float table2[3], bool c, out Set other) {
  float table3[3] = table;
  if (c) {
    table3 = table2;
  }
  float table4[3] = float[3](set.weights[2], set.weights[2], set.weights[2]);
  other = Set(table4, 3);
  return table3;
}

void main() {
  float table2[3] = float[3](uv.x, 2.0, uv.x);
  bool test = uv.x < 0.5;
  Set set = Set(table2, 1);
  for (int i = 0; i < 4; ++i) {
    Set other;
    float pick_value[3] = pick(set, table2, test, other);
    set = Set(pick_value, i);
  }
  out_x = set.weights[clamp(set.size, 0, 2)];
}
)");
  EXPECT_TRUE(IsValid(kModule));
}

TEST(Shader, IntegerInputsAreFlat) {
  std::string shader = Shader(R"(input id: int
function main() -> (x: float) {
  %1 = convert @id : float
  return %1
}
main main
)");
  EXPECT_NE(shader.find("flat in int id;"), std::string::npos);
  EXPECT_EQ(Complaint(shader), "");
}

}  // namespace
}  // namespace texgraph::glsl
