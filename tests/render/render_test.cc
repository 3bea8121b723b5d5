// SPDX-License-Identifier: Apache-2.0
#include "runtime/render.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "compiler/textures/srgb.h"
#include "tests/render/render_testing.h"

namespace texgraph::runtime {
namespace {

using test::AddUniform;
using test::FirstMessage;
using test::FirstName;
using test::FloatAt;
using test::ShaderRequest;
using testing::HasSubstr;

// Every test of this kind runs through each kind of context.
class ContextTest : public testing::TestWithParam<test::NamedContext> {
 protected:
  RenderResult Draw(RenderRequest request) {
    request.context.choice = GetParam().choice;
    RenderResult result = Render(request);
    EXPECT_TRUE(result.ok()) << FirstMessage(result.diagnostics) << result.driver_log;
    return result;
  }
};

INSTANTIATE_TEST_SUITE_P(Contexts, ContextTest, testing::ValuesIn(test::AllContexts()),
                         [](const auto& info) { return info.param.name; });

TEST_P(ContextTest, SaysWhichContextWasUsed) {
  const RenderResult result =
      Draw(ShaderRequest("", "out_color = vec4(1.0); out_height = 0.0;", 4, 4));
  EXPECT_THAT(result.context, HasSubstr(GetParam().name == "egl" ? "EGL" : "OSMesa"));
  EXPECT_THAT(result.context, HasSubstr("OpenGL 4.5"));
  EXPECT_EQ(result.context_note, "");
}

// With powers of two everywhere, the centre of every pixel is exact.
TEST_P(ContextTest, GivesUvAtPixelCentres) {
  RenderRequest request =
      ShaderRequest("", "out_color = vec4(uv, dFdx(uv.x), dFdy(uv.y)); out_height = 0.0;", 64, 32);
  request.window = {-1, 2, 3, 6};
  const RenderResult result = Draw(request);
  ASSERT_EQ(result.outputs.size(), 1u);
  for (uint32_t y = 0; y < 32; ++y) {
    for (uint32_t x = 0; x < 64; ++x) {
      const auto& color = result.outputs[0];
      ASSERT_EQ(FloatAt(color, 64, x, y, 0), -1 + 4 * (x + 0.5f) / 64);
      ASSERT_EQ(FloatAt(color, 64, x, y, 1), 2 + 4 * (y + 0.5f) / 32);
      ASSERT_EQ(FloatAt(color, 64, x, y, 2), 4.0f / 64);
      ASSERT_EQ(FloatAt(color, 64, x, y, 3), 4.0f / 32);
    }
  }
}

TEST_P(ContextTest, GivesSurfaceAndTime) {
  RenderRequest request = ShaderRequest("",
                                        "out_color = vec4(position.xy - uv, position.z, time); "
                                        "out_height = dot(normal, vec3(1, 2, 4));",
                                        8, 8);
  request.outputs = {"height", "color"};
  request.time = 2.5;
  const RenderResult result = Draw(request);
  ASSERT_EQ(result.outputs.size(), 2u);
  EXPECT_EQ(result.outputs[0].name, "height");
  EXPECT_EQ(result.outputs[0].channels, 1u);
  for (uint32_t c = 0; c < 3; ++c) EXPECT_EQ(FloatAt(result.outputs[1], 8, 3, 5, c), 0.0f);
  EXPECT_EQ(FloatAt(result.outputs[1], 8, 3, 5, 3), 2.5f);
  EXPECT_EQ(FloatAt(result.outputs[0], 8, 3, 5, 0), 4.0f);
}

TEST_P(ContextTest, SetsUniformsOfEveryType) {
  RenderRequest request = ShaderRequest(
      "uniform float a; uniform vec3 b; uniform int c; uniform uvec2 d; uniform bool e; uniform "
      "mat2 f;\n"
      "uniform ivec4 g; uniform bvec2 h; uniform mat3 i; uniform float unused;",
      "out_color = vec4(a + b.x + 2.0 * b.y + 3.0 * b.z, float(c) + float(d.x & 15u) + "
      "float(d.y),\n"
      "                 e && !h.x && h.y ? 1.0 : 0.0, f[1].x * 10.0 + f[0].y + i[2].x * 100.0);\n"
      "out_height = float(g.w);",
      2, 2);
  AddUniform(request, "a", ir::kFloat, {0.5});
  AddUniform(request, "b", ir::kVec3, {1, 2, 3});
  AddUniform(request, "c", ir::kInt, {-7});
  AddUniform(request, "d", ir::kUvec2, {4294967295.0, 3});
  AddUniform(request, "e", ir::kBool, {1});
  AddUniform(request, "f", ir::kMat2, {1, 2, 3, 4});
  AddUniform(request, "g", ir::kIvec4, {1, 2, 3, -2147483648.0});
  AddUniform(request, "h", ir::kBvec2, {0, 1});
  AddUniform(request, "i", ir::kMat3, {1, 2, 3, 4, 5, 6, 7, 8, 9});
  AddUniform(request, "unused", ir::kFloat, {1});
  request.outputs = {"color", "height"};
  const RenderResult result = Draw(request);
  EXPECT_EQ(FloatAt(result.outputs[0], 2, 0, 0, 0), 0.5f + 1 + 4 + 9);
  EXPECT_EQ(FloatAt(result.outputs[0], 2, 0, 0, 1), -7.0f + 15 + 3);
  EXPECT_EQ(FloatAt(result.outputs[0], 2, 0, 0, 2), 1.0f);
  EXPECT_EQ(FloatAt(result.outputs[0], 2, 0, 0, 3), 732.0f);
  EXPECT_EQ(FloatAt(result.outputs[1], 2, 0, 0, 0), -2147483648.0f);
}

// The top row of a picture is v = 1; colours are sRGB, other numbers are as they are.
TEST_P(ContextTest, MakesPictures) {
  RenderRequest request =
      ShaderRequest("", "out_color = vec4(uv, 0.25, 0.5); out_height = uv.y * 2.0 - 0.5;", 16, 16);
  request.format = PixelFormat::kImage8;
  request.outputs = {"color", "height"};
  RenderResult result = Draw(request);
  const textures::Image& color = result.outputs[0].image;
  const textures::Image& height = result.outputs[1].image;
  ASSERT_EQ(color.channels, 4);
  ASSERT_EQ(height.channels, 1);
  for (uint32_t i = 0; i < 16; ++i) {
    const double linear = (i + 0.5) / 16;
    EXPECT_EQ(color.At(i, 3, 0), std::lround(255 * textures::SrgbEncode(linear)));
    EXPECT_EQ(color.At(3, 15 - i, 1), std::lround(255 * textures::SrgbEncode(linear)));
    EXPECT_EQ(height.At(3, 15 - i, 0), std::lround(255 * std::clamp(linear * 2 - 0.5, 0.0, 1.0)));
  }
  EXPECT_EQ(color.At(0, 0, 2), 137u);  // 0.25 in sRGB is 0.5371
  EXPECT_EQ(color.At(0, 0, 3), 128u);
  request.format = PixelFormat::kImage16;
  result = Draw(request);
  EXPECT_EQ(result.outputs[0].image.bits, 16);
  EXPECT_EQ(result.outputs[0].image.At(0, 0, 2), std::lround(65535 * textures::SrgbEncode(0.25)));
  EXPECT_EQ(result.outputs[0].image.At(0, 0, 3), 32768u);
}

TEST_P(ContextTest, PacksNormals) {
  RenderRequest request =
      ShaderRequest("", "out_color = vec4(-1.0, 0.0, 1.0, 0.0); out_height = 0.0;", 2, 2);
  request.manifest.outputs[1].name = "normal";
  request.outputs = {"normal"};
  request.format = PixelFormat::kImage8;
  const RenderResult result = Draw(request);
  EXPECT_EQ(result.outputs[0].image.At(0, 0, 0), 0u);
  EXPECT_EQ(result.outputs[0].image.At(0, 0, 1), 128u);
  EXPECT_EQ(result.outputs[0].image.At(0, 0, 2), 255u);
}

TEST_P(ContextTest, CountsNanPixels) {
  RenderRequest request = ShaderRequest(
      "uniform float zero;",
      "out_color = vec4(uv.x < 0.5 ? zero / zero : 1.0, 1.0, 1.0, 1.0); out_height = 0.0;", 8, 4);
  AddUniform(request, "zero", ir::kFloat, {0});
  request.format = PixelFormat::kImage8;
  const RenderResult result = Draw(request);
  EXPECT_EQ(result.outputs[0].nan_pixels, 16u);
  EXPECT_EQ(FirstName(result.diagnostics), "nan-pixels");
  EXPECT_THAT(FirstMessage(result.diagnostics),
              HasSubstr("16 of 32 pixels of output 'color' are NaN"));
  EXPECT_EQ(result.outputs[0].image.At(0, 0, 0), 0u);
  EXPECT_EQ(result.outputs[0].image.At(7, 0, 0), 255u);
}

const char* const kTileBody =
    "vec2 p = uv * 37.0;\n"
    "float wave = sin(p.x) * cos(p.y) + fract(p.x * p.y);\n"
    "out_color = vec4(uv, dFdx(wave), dFdy(wave)); out_height = wave;";

// Tiles change nothing, neither values nor derivatives, where uv is exact.
TEST_P(ContextTest, TilesEqualTheWholeToTheBit) {
  RenderRequest request = ShaderRequest("", kTileBody, 256, 128);
  request.window = {-0.5, 1, 3.5, 3};
  request.outputs = {"color", "height"};
  const RenderResult whole = Draw(request);
  for (uint32_t tile : {16u, 62u, 128u}) {
    request.tile = tile;
    const RenderResult tiled = Draw(request);
    EXPECT_EQ(tiled.outputs[0].floats, whole.outputs[0].floats) << tile;
    for (uint32_t i = 0; i < 256 * 128; ++i) {
      ASSERT_EQ(tiled.outputs[1].floats[4 * i], whole.outputs[1].floats[4 * i]) << tile;
    }
  }
}

// Elsewhere uv differs by rounding, also in the last, incomplete tiles.
TEST_P(ContextTest, TilesOfAnySizeAreContinuous) {
  RenderRequest request = ShaderRequest(
      "", "out_color = vec4(uv, dFdx(uv.x), dFdy(uv.y)); out_height = 0.0;", 301, 187);
  request.window = {0.1, 0.3, 0.8, 0.7};
  request.tile = 100;
  const RenderResult result = Draw(request);
  for (uint32_t y = 0; y < 187; ++y) {
    for (uint32_t x = 0; x < 301; ++x) {
      ASSERT_NEAR(FloatAt(result.outputs[0], 301, x, y, 0), 0.1 + 0.7 * (x + 0.5) / 301, 1.2e-7);
      ASSERT_NEAR(FloatAt(result.outputs[0], 301, x, y, 1), 0.3 + 0.4 * (y + 0.5) / 187, 1.2e-7);
      ASSERT_NEAR(FloatAt(result.outputs[0], 301, x, y, 2), 0.7 / 301, 1.2e-7);
      ASSERT_NEAR(FloatAt(result.outputs[0], 301, x, y, 3), 0.4 / 187, 1.2e-7);
    }
  }
}

// Nothing but one plane: every row has one v, every column one u, whatever the window.
TEST_P(ContextTest, RowsAndColumnsAreStraight) {
  for (uint32_t side : {63u, 300u, 512u}) {
    RenderRequest request =
        ShaderRequest("", "out_color = vec4(uv, 0.0, 1.0); out_height = 0.0;", side, side);
    request.window = {-1.3, 0.2, 4.1, 3.9};
    const RenderResult result = Draw(request);
    for (uint32_t y = 0; y < side; ++y) {
      for (uint32_t x = 0; x < side; ++x) {
        ASSERT_EQ(FloatAt(result.outputs[0], side, x, y, 0),
                  FloatAt(result.outputs[0], side, x, 0, 0));
        ASSERT_EQ(FloatAt(result.outputs[0], side, x, y, 1),
                  FloatAt(result.outputs[0], side, 0, y, 1));
      }
    }
  }
}

TEST_P(ContextTest, DrawsBeyondTheLargestTexture) {
  RenderRequest request =
      ShaderRequest("", "out_color = vec4(uv, 0.0, 1.0); out_height = 0.0;", 40000, 3);
  const RenderResult result = Draw(request);
  for (uint32_t x = 0; x < 40000; x += 7) {
    ASSERT_NEAR(FloatAt(result.outputs[0], 40000, x, 2, 0), (x + 0.5) / 40000, 1.2e-7);
  }
}

TEST_P(ContextTest, TimesFrames) {
  RenderRequest request = ShaderRequest("", kTileBody, 64, 64);
  request.timed_frames = 3;
  const RenderResult result = Draw(request);
  ASSERT_EQ(result.frame_seconds.size(), 3u);
  EXPECT_GT(result.compile_seconds, 0);
  for (double seconds : result.frame_seconds) EXPECT_GT(seconds, 0);
}

TEST_P(ContextTest, GoesOnAfterAFailedRequest) {
  std::vector<RenderRequest> requests(
      3, ShaderRequest("", "out_color = vec4(time); out_height = 0.0;", 4, 4));
  for (size_t i = 0; i < 3; ++i) {
    requests[i].context.choice = GetParam().choice;
    requests[i].time = static_cast<double>(i);
  }
  requests[1].shader += "error";
  const std::vector<RenderResult> results = RenderAll(requests);
  EXPECT_EQ(FirstName(results[1].diagnostics), "driver-compile");
  ASSERT_TRUE(results[0].ok() && results[2].ok());
  EXPECT_EQ(FloatAt(results[0].outputs[0], 4, 0, 0, 0), 0.0f);
  EXPECT_EQ(FloatAt(results[2].outputs[0], 4, 0, 0, 0), 2.0f);
}

TEST_P(ContextTest, ReadsGlsl450WithLocations) {
  RenderRequest request = ShaderRequest("", "", 4, 4);
  request.shader =
      "#version 450 core\n"
      "layout(location = 2) in vec2 uv_of_surface;\n"
      "layout(location = 3) out vec4 out_color;\n"
      "void main() { out_color = vec4(uv_of_surface, 0.0, 1.0); }\n";
  request.manifest.dialect = ShaderDialect::kGlsl450;
  request.manifest.inputs = {{"uv", "", ir::kVec2, 2}};
  const RenderResult result = Draw(request);
  EXPECT_EQ(FloatAt(result.outputs[0], 4, 1, 2, 0), 0.375f);
  EXPECT_EQ(FloatAt(result.outputs[0], 4, 1, 2, 1), 0.625f);
}

TEST_P(ContextTest, FollowsOtherNames) {
  RenderRequest request = ShaderRequest("", "", 4, 4);
  request.shader =
      "#version 330 core\n"
      "in vec2 st; uniform float clock; uniform float amount_2; out vec4 c;\n"
      "void main() { c = vec4(st, clock, amount_2); }\n";
  request.manifest.inputs = {{"uv", "st", ir::kVec2, {}}, {"time", "clock", ir::kFloat, {}}};
  request.manifest.outputs = {{"color", "c", ir::kVec4}};
  AddUniform(request, "amount", ir::kFloat, {5});
  request.manifest.parameters[0].variable = "amount_2";
  request.time = 3;
  const RenderResult result = Draw(request);
  const float expected[] = {0.375f, 0.625f, 3.0f, 5.0f};
  for (uint32_t c = 0; c < 4; ++c) EXPECT_EQ(FloatAt(result.outputs[0], 4, 1, 2, c), expected[c]);
}

TEST_P(ContextTest, ReportsWhatTheDriverSays) {
  RenderRequest request = ShaderRequest("", "out_color = vec3(1.0); out_height = 0.0;", 4, 4);
  request.context.choice = GetParam().choice;
  const RenderResult result = Render(request);
  EXPECT_EQ(result.diagnostics.exit_code(), ExitCode::kRuntime);
  EXPECT_EQ(FirstName(result.diagnostics), "driver-compile");
  EXPECT_THAT(result.driver_log, HasSubstr("error"));
  EXPECT_FALSE(result.diagnostics.all().front().notes.empty());
}

// --- Refused before any driver is touched
// -------------------------------------------------------------------------

struct Refusal {
  std::string name;
  std::string expected;
  void (*change)(RenderRequest& request);
};

class RefusalTest : public testing::TestWithParam<Refusal> {};

TEST_P(RefusalTest, IsADiagnostic) {
  RenderRequest request = ShaderRequest("", "out_color = vec4(1.0); out_height = 0.0;", 4, 4);
  GetParam().change(request);
  const RenderResult result = Render(request);
  EXPECT_EQ(FirstName(result.diagnostics), GetParam().expected) << FirstMessage(result.diagnostics);
  EXPECT_EQ(result.context, "");
  EXPECT_TRUE(result.outputs.empty());
}

const Refusal kRefusals[] = {
    {"NoWidth", "size-limit", [](RenderRequest& r) { r.width = 0; }},
    {"NoHeight", "size-limit", [](RenderRequest& r) { r.height = 0; }},
    {"Width65536", "size-limit", [](RenderRequest& r) { r.width = 65536; }},
    {"Square65535", "size-limit", [](RenderRequest& r) { r.width = r.height = 65535; }},
    {"Floats10240", "size-limit", [](RenderRequest& r) { r.width = r.height = 10240; }},
    {"EmptyWindow", "usage",
     [](RenderRequest& r) {
       r.window = {0, 0, 0, 1};
     }},
    {"NanWindow", "usage", [](RenderRequest& r) { r.window[1] = NAN; }},
    {"HugeWindow", "usage", [](RenderRequest& r) { r.window[2] = 1e30; }},
    {"InfiniteTime", "usage",
     [](RenderRequest& r) { r.time = std::numeric_limits<double>::infinity(); }},
    {"NoTimeout", "usage", [](RenderRequest& r) { r.timeout = 0; }},
    {"OddTile", "usage", [](RenderRequest& r) { r.tile = 33; }},
    {"UnknownOutput", "unknown-output", [](RenderRequest& r) { r.outputs = {"colour"}; }},
    {"Function", "not-renderable", [](RenderRequest& r) { r.manifest.is_function = true; }},
    {"Spirv", "not-renderable",
     [](RenderRequest& r) { r.manifest.dialect = ShaderDialect::kSpirv; }},
    {"NoImage", "not-renderable",
     [](RenderRequest& r) { r.manifest.textures.emplace_back().variable = "brick"; }},
};

INSTANTIATE_TEST_SUITE_P(All, RefusalTest, testing::ValuesIn(kRefusals),
                         [](const auto& info) { return info.param.name; });

TEST(RenderTest, RefusesWhatTheShaderHasNot) {
  RenderRequest request = ShaderRequest("", "out_color = vec4(1.0); out_height = 0.0;", 4, 4);
  request.manifest.outputs[1].variable = "out_other";
  EXPECT_EQ(FirstName(Render(request).diagnostics), "not-renderable");
  request.manifest.outputs[1].variable = "out_color";
  request.outputs = {"color", "color"};
  EXPECT_EQ(FirstName(Render(request).diagnostics), "usage");
}

}  // namespace
}  // namespace texgraph::runtime
