// SPDX-License-Identifier: Apache-2.0
// The harness itself: it agrees where CPU and GPU must, and sees where they don't.
#include "tests/render/render_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>

#include "tests/render/render_testing.h"
#include "tests/unit/ir/module_text.h"

namespace texgraph::test {
namespace {

using ir::ModuleFrom;
using testing::HasSubstr;

std::shared_ptr<const textures::TextureData> RandomTexture(bool as_float) {
  textures::Image image;
  image.width = 32;
  image.height = 16;
  image.channels = 4;
  image.pixels.resize(image.RowBytes() * image.height);
  std::mt19937 random(7);
  for (uint8_t& byte : image.pixels) byte = static_cast<uint8_t>(random());
  textures::TextureOptions options;
  options.as_float = as_float;
  Diagnostics diagnostics;
  return std::make_shared<textures::TextureData>(*textures::MakeTexture(
      std::span<const textures::Image>(&image, 1), options, "image", {}, diagnostics));
}

TEST(UlpDistanceTest, CountsFloats) {
  EXPECT_EQ(UlpDistance(1.0f, 1.0f), 0u);
  EXPECT_EQ(UlpDistance(0.0f, -0.0f), 0u);
  EXPECT_EQ(UlpDistance(1.0f, std::nextafter(1.0f, 2.0f)), 1u);
  EXPECT_EQ(UlpDistance(-1e-45f, 1e-45f), 2u);
  EXPECT_EQ(UlpDistance(NAN, -NAN), 0u);
  EXPECT_EQ(UlpDistance(NAN, 1.0f), uint64_t{1} << 32);
}

TEST(PixelOfLaneTest, QuadsGoRowByRow) {
  using Pixel = std::array<uint32_t, 2>;
  EXPECT_EQ(PixelOfLane(0, 8), (Pixel{0, 0}));
  EXPECT_EQ(PixelOfLane(1, 8), (Pixel{1, 0}));
  EXPECT_EQ(PixelOfLane(2, 8), (Pixel{0, 1}));
  EXPECT_EQ(PixelOfLane(3, 8), (Pixel{1, 1}));
  EXPECT_EQ(PixelOfLane(15, 8), (Pixel{7, 1}));
  EXPECT_EQ(PixelOfLane(16, 8), (Pixel{0, 2}));
}

TEST(MakePreciseTest, MarksWhatComputesFloats) {
  const std::string outputs[] = {"out_color"};
  EXPECT_EQ(
      MakePrecise("// x\n#version 330\nstruct S {\n  float a;\n};\nfloat f(float x) {\n  float y = "
                  "x;\n  int i = 1;\n"
                  "  return y;\n}\nvoid main() {\n  out_color = vec4(f(1.0));\n}\n",
                  outputs),
      "// x\n#version 330\n#extension GL_ARB_gpu_shader5 : require\nstruct S {\n  float a;\n};\n"
      "float f(float x) {\n  precise float y = x;\n  int i = 1;\n  return y;\n}\nprecise "
      "out_color;\nvoid main() {\n"
      "  out_color = vec4(f(1.0));\n}\n");
}

class CheckTest : public testing::TestWithParam<std::tuple<NamedContext, glsl::Dialect>> {
 protected:
  CheckOptions Options() const {
    CheckOptions options;
    options.context.choice = std::get<0>(GetParam()).choice;
    options.dialect = std::get<1>(GetParam());
    options.window = {-1.3, 0.2, 4.1, 3.9};
    return options;
  }
};
INSTANTIATE_TEST_SUITE_P(All, CheckTest,
                         testing::Combine(testing::ValuesIn(AllContexts()),
                                          testing::Values(glsl::Dialect::k330,
                                                          glsl::Dialect::k450)),
                         [](const auto& info) {
                           return std::get<0>(info.param).name +
                                  (std::get<1>(info.param) == glsl::Dialect::k330 ? "_330"
                                                                                  : "_450");
                         });

// Operations that must agree to the bit, with inputs, uniforms of several types, several outputs
// and an integer hash.
TEST_P(CheckTest, ExactOperationsAgreeToTheBit) {
  ir::Module module = ModuleFrom(R"(input uv: vec2
input position: vec3
input normal: vec3
uniform time: float = 0.0
uniform scale: vec2 = vec2(3.25, 1.7)
uniform seed: uint = 2654435769u
uniform shift: int = -3
function main() -> (color: vec4, height: float) {
  %p = mul @uv, @scale : vec2
  %q = fract %p : vec2
  %f = floor %p : vec2
  %i = convert %f : ivec2
  %x = extract.0 %i : int
  %y = extract.1 %i : int
  %z = mul %x, 374761393 : int
  %w = add %z, %y : int
  %s = add %w, @shift : int
  %u = convert %s : uint
  %h = xor %u, @seed : uint
  %h2 = shr %h, 13u : uint
  %h3 = xor %h, %h2 : uint
  %h4 = mul %h3, 1274126177u : uint
  %h5 = shr %h4, 8u : uint
  %r = convert %h5 : float
  %n = mul %r, 0.000000059604645 : float
  %q0 = extract.0 %q : float
  %q1 = extract.1 %q : float
  %d = div %q0, 0.37 : float
  %m = sub %q0, %q1 : float
  %pz = extract.1 @position : float
  %nz = extract.2 @normal : float
  %t = add @time, %pz : float
  %c = construct %d, %m, %t, %nz : vec4
  return %c, %n
}
main main)");
  CheckOptions options = Options();
  options.time = 1.5;
  options.uniforms["shift"] = {static_cast<uint32_t>(-11)};
  options.uniforms["scale"] = {std::bit_cast<uint32_t>(2.125f), std::bit_cast<uint32_t>(7.5f)};
  const CheckReport report = CompareCpuAndGpu(module, options);
  ASSERT_EQ(report.error, "");
  ASSERT_EQ(report.outputs.size(), 2u);
  EXPECT_EQ(report.max_ulp(), 0u) << report.Text() << report.glsl;
  EXPECT_EQ(report.outputs[0].cpu.size(), 64u * 64 * 4);
  EXPECT_EQ(report.outputs[0].identical, 64u * 64 * 4);
  EXPECT_EQ(report.outputs[1].width, 1u);
  // The comparison is of something: the hash varies.
  EXPECT_NE(report.outputs[1].cpu[0], report.outputs[1].cpu[32 * 64 + 32]);
}

// Mesa computes this mix another way unless it must not.
TEST_P(CheckTest, PreciseMakesMixExact) {
  const char* const text = R"(input uv: vec2
function main() -> (height: float) {
  %q = fract @uv : vec2
  %q0 = extract.0 %q : float
  %q1 = extract.1 %q : float
  %d = div %q0, 0.37 : float
  %m = mix %q0, %q1, %d : float
  return %m
}
main main)";
  ir::Module module = ModuleFrom(text);
  const CheckReport report = CompareCpuAndGpu(module, Options());
  ASSERT_EQ(report.error, "");
  EXPECT_EQ(report.max_ulp(), 0u) << report.Text() << report.glsl;
  ir::Module plain = ModuleFrom(text);
  CheckOptions options = Options();
  options.precise = false;
  const CheckReport loose = CompareCpuAndGpu(plain, options);
  ASSERT_EQ(loose.error, "");
  EXPECT_EQ(loose.glsl.find("precise"), std::string::npos);
  EXPECT_LE(loose.max_abs(), 1e-6);
}

TEST_P(CheckTest, HardwareDerivativesAgree) {
  ir::Module module = ModuleFrom(R"(input uv: vec2
function main() -> (color: vec4) {
  %x = dfdx @uv : vec2
  %y = dfdy @uv : vec2
  %x0 = extract.0 %x : float
  %x1 = extract.1 %x : float
  %y0 = extract.0 %y : float
  %y1 = extract.1 %y : float
  %c = construct %x0, %x1, %y0, %y1 : vec4
  return %c
}
main main)");
  const CheckReport report = CompareCpuAndGpu(module, Options());
  ASSERT_EQ(report.error, "");
  EXPECT_EQ(report.max_ulp(), 0u) << report.Text();
}

TEST_P(CheckTest, TexturesAgree) {
  const char* const text = R"(input uv: vec2
texture image: sampler2D
function main() -> (color: vec4, emission: vec3) {
  %a = sample_lod @image, @uv, 1.0 : vec4
  %b = sample_grad @image, @uv, vec2(0.125, 0.0), vec2(0.0, 0.0625) : vec4
  %c = swizzle.xyz %b : vec3
  return %a, %c
}
main main)";
  for (bool as_float : {false, true}) {
    ir::Module module = ModuleFrom(text);
    CheckOptions options = Options();
    options.textures["image"] = RandomTexture(as_float);
    const CheckReport report = CompareCpuAndGpu(module, options);
    ASSERT_EQ(report.error, "");
    EXPECT_LE(report.max_abs(), as_float ? 1e-5 : 1.0 / 255) << report.Text();
  }
}

// fract(sin(x) * 43758.5) is what nobody may build on: it must be seen to differ.
TEST_P(CheckTest, SeesDifferences) {
  ir::Module module = ModuleFrom(R"(input uv: vec2
function main() -> (height: float) {
  %x = extract.0 @uv : float
  %y = mul %x, 127.1 : float
  %s = sin %y : float
  %m = mul %s, 43758.547 : float
  %f = fract %m : float
  return %f
}
main main)");
  const CheckReport report = CompareCpuAndGpu(module, Options());
  ASSERT_EQ(report.error, "");
  EXPECT_GT(report.max_abs(), 1e-3);
  EXPECT_GT(report.outputs[0].CountBeyond(1e-3), 20u);
  EXPECT_THAT(report.Text(), HasSubstr("worst at pixel"));
}

TEST_P(CheckTest, SeesAnotherTexture) {
  const char* const text = R"(input uv: vec2
texture image: sampler2D
function main() -> (color: vec4) {
  %a = sample_lod @image, @uv, 0.0 : vec4
  return %a
}
main main)";
  ir::Module module = ModuleFrom(text);
  const CheckReport report = CompareCpuAndGpu(module, Options());
  EXPECT_THAT(report.error, HasSubstr("texture 'image' has no image"));
}

TEST_P(CheckTest, ManyCasesKeepTheirOrder) {
  std::vector<ir::Module> modules;
  for (int i = 0; i < 5; ++i) {
    modules.push_back(ModuleFrom(
        "input uv: vec2\nfunction main() -> (height: float) {\n  %x = extract.0 @uv : float\n"
        "  %y = add %x, " +
        std::to_string(i) + ".0 : float\n  return %y\n}\nmain main"));
  }
  std::vector<CheckCase> cases;
  for (ir::Module& module : modules) cases.push_back({&module, Options()});
  cases[2].options.width = 3;  // refused
  const std::vector<CheckReport> reports = CompareCpuAndGpu(cases);
  for (size_t i = 0; i < reports.size(); ++i) {
    if (i == 2) {
      EXPECT_THAT(reports[i].error, HasSubstr("even sides"));
      continue;
    }
    ASSERT_EQ(reports[i].error, "");
    EXPECT_EQ(reports[i].max_ulp(), 0u);
    EXPECT_NEAR(reports[i].outputs[0].gpu[0], -1.3 + 5.4 / 128 + static_cast<double>(i), 1e-5);
  }
}

}  // namespace
}  // namespace texgraph::test
