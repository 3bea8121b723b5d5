// SPDX-License-Identifier: Apache-2.0
// Pictures of a renderer that lives on, against those of Render with the same values from the
// beginning: to the bit.
#include "runtime/live.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <functional>
#include <random>

#include "compiler/textures/maps.h"
#include "tests/render/render_testing.h"

namespace texgraph::runtime {
namespace {

using test::AddTexture;
using test::FirstMessage;
using test::FirstName;
using test::ShaderRequest;
using testing::HasSubstr;
using textures::TexelFormat;
using textures::TextureData;

// A texture of 8 x 4 with two levels, of 3 layers or slices if it has any; random bytes that are no
// NaN in any format.
TextureData RandomTexture(TexelFormat format, bool is_array, bool is_3d, uint32_t seed) {
  TextureData data;
  data.format = format;
  data.is_array = is_array;
  data.is_3d = is_3d;
  data.layers = is_array ? 3 : 1;
  data.sampler.filter = ir::Filter::kNearest;
  data.sampler.mip_filter = ir::MipFilter::kNearest;
  std::mt19937 random(seed);
  for (uint32_t level = 0; level < 2; ++level) {
    textures::TexelLevel& to = data.levels.emplace_back();
    to.width = 8 >> level;
    to.height = 4 >> level;
    to.depth = is_3d ? 4 >> level : 1;
    to.bytes.resize(size_t{to.width} * to.height * to.depth * data.layers * TexelBytes(format));
    for (uint8_t& byte : to.bytes) byte = static_cast<uint8_t>(random() % 0x70);
  }
  return data;
}

// The same change where no GPU is concerned.
void Apply(const TexelUpdate& update, TextureData& data) {
  textures::TexelLevel& level = data.levels[update.level];
  const size_t texel = TexelBytes(data.format);
  const size_t row = update.width * texel;
  for (uint32_t y = 0; y < update.height; ++y) {
    const size_t to =
        ((size_t{update.layer} * level.height + update.y + y) * level.width) + update.x;
    std::memcpy(level.bytes.data() + to * texel, update.texels.data() + y * row, row);
  }
}

TexelUpdate RandomUpdate(const TextureData& data, uint32_t level, std::mt19937& random) {
  TexelUpdate update;
  update.texture = "image";
  update.level = level;
  const textures::TexelLevel& from = data.levels[level];
  update.x = random() % from.width;
  update.y = random() % from.height;
  update.layer = random() % (data.is_3d ? from.depth : data.layers);
  update.width = 1 + random() % (from.width - update.x);
  update.height = 1 + random() % (from.height - update.y);
  update.texels.resize(size_t{update.width} * update.height * TexelBytes(data.format));
  for (uint8_t& byte : update.texels) byte = static_cast<uint8_t>(random() % 0x70);
  return update;
}

// Draws all texels of both levels beside each other.
RenderRequest TexelsOf(const TextureData& data) {
  const bool is_deep = data.is_array || data.is_3d;
  const std::string sampler = data.is_3d      ? "sampler3D"
                              : data.is_array ? "sampler2DArray"
                                              : "sampler2D";
  RenderRequest request =
      ShaderRequest("uniform " + sampler + " image;",
                    "ivec2 p = ivec2(gl_FragCoord.xy); int level = p.x / 8; int slice = p.y / 4;\n"
                    "ivec2 at = ivec2(p.x % 8, p.y % 4) >> level;\n"
                    "out_color = texelFetch(image, " +
                        std::string(data.is_3d      ? "ivec3(at, slice >> level)"
                                    : data.is_array ? "ivec3(at, min(slice, 2))"
                                                    : "at") +
                        ", level); out_height = time;",
                    16, is_deep ? 16 : 4);
  AddTexture(request, "image", data);
  request.outputs = {"color", "height"};
  return request;
}

void ExpectSame(const RenderResult& a, const RenderResult& b) {
  ASSERT_TRUE(a.ok()) << FirstMessage(a.diagnostics);
  ASSERT_TRUE(b.ok()) << FirstMessage(b.diagnostics);
  ASSERT_EQ(a.outputs.size(), b.outputs.size());
  for (size_t i = 0; i < a.outputs.size(); ++i) EXPECT_EQ(a.outputs[i].floats, b.outputs[i].floats);
}

std::unique_ptr<LiveRenderer> Open(const RenderRequest& request) {
  Diagnostics diagnostics;
  auto renderer = LiveRenderer::Open(request, diagnostics);
  EXPECT_TRUE(renderer) << FirstMessage(diagnostics);
  return renderer;
}

class LiveTest : public testing::TestWithParam<test::NamedContext> {};
INSTANTIATE_TEST_SUITE_P(Contexts, LiveTest, testing::ValuesIn(test::AllContexts()),
                         [](const auto& info) { return info.param.name; });

TEST_P(LiveTest, ChangedTexelsAreThoseOfTheBeginning) {
  std::mt19937 random(5);
  for (TexelFormat format :
       {TexelFormat::kRgba8, TexelFormat::kSrgb8Alpha8, TexelFormat::kRgba16, TexelFormat::kRgba16F,
        TexelFormat::kRgba32F, TexelFormat::kR16F, TexelFormat::kR32F}) {
    for (int shape = 0; shape < 3; ++shape) {
      TextureData data = RandomTexture(format, shape == 1, shape == 2, 7);
      RenderRequest request = TexelsOf(data);
      request.context.choice = GetParam().choice;
      const auto renderer = Open(request);
      ASSERT_TRUE(renderer);
      RenderResult before = renderer->Draw(0);
      ExpectSame(before, Render(request));
      for (int picture = 1; picture < 3; ++picture) {
        for (int i = 0; i < 6; ++i) {  // they overlap: the last one counts
          Diagnostics diagnostics;
          const TexelUpdate update = RandomUpdate(data, i % 2, random);
          Apply(update, data);
          ASSERT_TRUE(renderer->UpdateTexels(update, diagnostics)) << FirstMessage(diagnostics);
        }
        RenderRequest changed = TexelsOf(data);
        changed.context.choice = GetParam().choice;
        changed.time = picture;
        const RenderResult now = renderer->Draw(picture);
        ExpectSame(now, Render(changed));
        EXPECT_NE(now.outputs[0].floats, before.outputs[0].floats);
      }
    }
  }
}

TEST(LiveRendererTest, ParametersStayUntilTheyAreSetAgain) {
  RenderRequest request = ShaderRequest("uniform vec3 tint; uniform int count; uniform bool on;",
                                        "out_color = vec4(tint, on ? float(count) : -1.0);\n"
                                        "out_height = time;",
                                        2, 2);
  test::AddUniform(request, "tint", ir::kVec3, {1, 2, 3});
  test::AddUniform(request, "count", ir::kInt, {4});
  test::AddUniform(request, "on", ir::kBool, {1});
  request.manifest.parameters[0].range = {{0, 10}};
  request.outputs = {"color", "height"};
  const auto renderer = Open(request);
  ASSERT_TRUE(renderer);
  using Pixel = std::vector<float>;
  const auto draw = [&](double time) {
    const RenderResult result = renderer->Draw(time);
    EXPECT_TRUE(result.ok()) << FirstMessage(result.diagnostics);
    const auto& color = result.outputs[0].floats;
    return Pixel{color[0], color[1], color[2], color[3], result.outputs[1].floats[0]};
  };
  const auto set = [&](std::string_view name, std::vector<double> numbers) {
    Diagnostics diagnostics;
    renderer->SetParameter(name, numbers, diagnostics);
    return FirstName(diagnostics);
  };
  EXPECT_EQ(draw(0.5), (Pixel{1, 2, 3, 4, 0.5}));
  EXPECT_EQ(set("tint", {5, 6, 7}), "");
  EXPECT_EQ(draw(1), (Pixel{5, 6, 7, 4, 1}));
  EXPECT_EQ(set("count", {-9}), "");
  EXPECT_EQ(draw(1), (Pixel{5, 6, 7, -9, 1}));
  EXPECT_EQ(set("tint", {8}), "");
  EXPECT_EQ(set("on", {0}), "");
  EXPECT_EQ(draw(2), (Pixel{8, 8, 8, -1, 2}));
  // What is refused changes nothing.
  EXPECT_EQ(set("tinge", {1}), "unknown-parameter");
  EXPECT_EQ(set("tint", {1, 2}), "port-type");
  EXPECT_EQ(set("tint", {1, 2, 11}), "value-range");
  EXPECT_EQ(set("tint", {1, 2, NAN}), "value-range");
  EXPECT_EQ(set("count", {0.5}), "port-type");
  EXPECT_EQ(set("count", {1e10}), "value-range");
  EXPECT_EQ(draw(2), (Pixel{8, 8, 8, -1, 2}));
  EXPECT_EQ(FirstName(renderer->Draw(INFINITY).diagnostics), "usage");
  EXPECT_EQ(draw(3), (Pixel{8, 8, 8, -1, 3}));
}

TEST(LiveRendererTest, TexelsThatAreNotThere) {
  const TextureData data = RandomTexture(TexelFormat::kR32F, true, false, 1);
  RenderRequest request = TexelsOf(data);
  ManifestTexture idle;
  idle.name = "idle";
  idle.is_used = false;
  request.manifest.textures.push_back(idle);
  const auto renderer = Open(request);
  ASSERT_TRUE(renderer);
  const auto refusal = [&](const std::function<void(TexelUpdate&)>& spoil) {
    TexelUpdate update;
    update.texture = "image";
    update.x = 6;
    update.y = 2;
    update.layer = 2;
    update.width = 2;
    update.height = 2;
    update.texels.resize(16);
    spoil(update);
    Diagnostics diagnostics;
    const bool ok = renderer->UpdateTexels(update, diagnostics);
    EXPECT_NE(ok, diagnostics.HasErrors());
    return FirstName(diagnostics) + ": " + FirstMessage(diagnostics);
  };
  EXPECT_THAT(
      refusal([](TexelUpdate& update) { update.texture = "imago"; }),
      HasSubstr("unknown-reference: the shader has no texture 'imago'; did you mean 'image'"));
  EXPECT_THAT(refusal([](TexelUpdate& update) { update.level = 2; }),
              HasSubstr("has 2 levels; there is no level 2"));
  for (const auto& spoil : std::vector<std::function<void(TexelUpdate&)>>{
           [](TexelUpdate& update) { update.x = 7; }, [](TexelUpdate& update) { update.y = 3; },
           [](TexelUpdate& update) { update.layer = 3; },
           [](TexelUpdate& update) { update.level = 1; },
           [](TexelUpdate& update) { update.width = 0; },
           [](TexelUpdate& update) { update.height = 0; },
           [](TexelUpdate& update) { update.x = 0xffffffff; },
           [](TexelUpdate& update) { update.width = 0xffffffff; }}) {
    EXPECT_THAT(refusal(spoil), testing::AllOf(HasSubstr("value-range: texture 'image' has"),
                                               HasSubstr("not all among them")));
  }
  EXPECT_THAT(refusal([](TexelUpdate& update) { update.texels.pop_back(); }),
              HasSubstr("needs 16 bytes for 2 x 2 texels, not 15"));
  EXPECT_EQ(refusal([](TexelUpdate& update) { update.texture = "idle"; }), ": ");
  ExpectSame(renderer->Draw(0), Render(request));
}

TEST(LiveRendererTest, MapsTakeWholeNumbers) {
  for (int32_t largest : {40, 5000}) {  // halves, floats
    NumberMap map{4, 2, {0, 1, 2, 3, -1, 5, 6, largest}};
    const auto request_for = [&] {
      RenderRequest request = ShaderRequest(
          "uniform sampler2D map;",
          "out_color = texelFetch(map, ivec2(gl_FragCoord.xy), 0); out_height = 0.0;", 4, 2);
      AddTexture(request, "map", textures::MapTexture(map));
      request.manifest.textures[0].map = {MapContents::kLists, 5001};
      return request;
    };
    const RenderRequest before = request_for();
    ASSERT_EQ(before.textures[0].data->format,
              largest == 40 ? TexelFormat::kR16F : TexelFormat::kR32F);
    const auto renderer = Open(before);
    ASSERT_TRUE(renderer);
    TexelUpdate update;
    update.texture = "map";
    update.x = 1;
    update.width = 2;
    update.height = 2;
    const auto set = [&](std::vector<int32_t> numbers) {
      Diagnostics diagnostics;
      renderer->UpdateMap(update, numbers, diagnostics);
      return FirstName(diagnostics) + ": " + FirstMessage(diagnostics);
    };
    EXPECT_EQ(set({30, -1, 7, 8}), ": ");
    map.numbers = {0, 30, -1, 3, -1, 7, 8, largest};
    EXPECT_THAT(set({0, 0, 0, -2}), HasSubstr("value-range: texture 'map' takes numbers from -1"));
    EXPECT_THAT(set({0, 0, 0, 5001}), HasSubstr("not 5001"));
    EXPECT_EQ(set({0, 0, 0, 2049}) == ": ", largest == 5000);
    EXPECT_THAT(set({0, 0, 0}), HasSubstr("value-range"));
    EXPECT_EQ(set({30, -1, 7, 8}), ": ");
    ExpectSame(renderer->Draw(0), Render(request_for()));
  }
}

TEST(LiveRendererTest, WhatIsNoMap) {
  RenderRequest request = TexelsOf(RandomTexture(TexelFormat::kRgba8, false, false, 1));
  ManifestTexture folded;
  folded.name = "folded";
  folded.is_used = false;
  folded.is_folded = true;
  request.manifest.textures.push_back(folded);
  const auto renderer = Open(request);
  ASSERT_TRUE(renderer);
  Diagnostics picture, constant;
  TexelUpdate update;
  update.texture = "image";
  EXPECT_FALSE(renderer->UpdateMap(update, std::array{1}, picture));
  EXPECT_EQ(FirstName(picture), "port-type");
  update.texture = "folded";
  EXPECT_FALSE(renderer->UpdateMap(update, std::array{1}, constant));
  EXPECT_EQ(FirstName(constant), "not-renderable");
}

// More than a pipe holds, both ways.
TEST(LiveRendererTest, WholeTexturesCanBeChanged) {
  TextureData data;
  data.format = TexelFormat::kRgba8;
  textures::TexelLevel& level = data.levels.emplace_back();
  level.width = level.height = 1024;
  level.bytes.resize(size_t{4} << 20, 1);
  RenderRequest request = ShaderRequest(
      "uniform sampler2D image;",
      "out_color = texelFetch(image, ivec2(gl_FragCoord.xy), 0); out_height = 0.0;", 1024, 1024);
  request.format = PixelFormat::kImage16;
  AddTexture(request, "image", data);
  const auto renderer = Open(request);
  ASSERT_TRUE(renderer);
  for (uint8_t value : {uint8_t{0}, uint8_t{255}}) {
    TexelUpdate update;
    update.texture = "image";
    update.width = update.height = 1024;
    update.texels.assign(size_t{4} << 20, value);
    Diagnostics diagnostics;
    ASSERT_TRUE(renderer->UpdateTexels(update, diagnostics));
    const RenderResult result = renderer->Draw(0);
    ASSERT_TRUE(result.ok());
    for (uint8_t byte : result.outputs[0].image.pixels) ASSERT_EQ(byte, value);
  }
}

TEST(LiveRendererTest, NanIsCountedForEachPicture) {
  const auto renderer = Open(ShaderRequest(
      "", "out_color = vec4(time < 1.0 ? time / time : 1.0); out_height = 0.0;", 4, 4));
  ASSERT_TRUE(renderer);
  EXPECT_EQ(renderer->Draw(0).outputs[0].nan_pixels, 16u);
  EXPECT_EQ(renderer->Draw(2).outputs[0].nan_pixels, 0u);
  EXPECT_EQ(renderer->Draw(0).outputs[0].nan_pixels, 16u);
}

TEST(LiveRendererTest, TheCameraMoves) {
  RenderRequest request;
  request.manifest.is_function = true;
  request.manifest.entry_point = "made";
  request.manifest.inputs = {{"position", "", ir::kVec3, {}}};
  request.manifest.outputs = {{"color", "", ir::kVec4}};
  request.shader =
      "uniform float size;\n"
      "vec4 made(vec3 position) { return vec4(fract(position * size), 1.0); }\n";
  test::AddUniform(request, "size", ir::kFloat, {3});
  request.width = request.height = 48;
  request.format = PixelFormat::kFloat;
  request.scene.emplace().mesh = std::make_shared<Mesh>(*MakeShape("cube"));
  const auto renderer = Open(request);
  ASSERT_TRUE(renderer);
  Diagnostics diagnostics;
  for (double yaw : {0.0, 40.0, -20.0}) {
    request.scene->camera.yaw = yaw;
    request.scene->camera.pitch = yaw / 2;
    request.manifest.parameters[0].value = {3 + yaw};
    ASSERT_TRUE(renderer->SetCamera(request.scene->camera, diagnostics));
    ASSERT_TRUE(renderer->SetParameter("size", request.manifest.parameters[0].value, diagnostics));
    ExpectSame(renderer->Draw(0), Render(request));
  }
  Camera below = request.scene->camera;
  below.pitch = -91;
  EXPECT_FALSE(renderer->SetCamera(below, diagnostics));
  EXPECT_EQ(FirstName(diagnostics), "usage");
  ExpectSame(renderer->Draw(0), Render(request));
}

TEST(LiveRendererTest, RefusalsAreThoseOfRender) {
  const auto refusal = [](const RenderRequest& request) {
    Diagnostics diagnostics;
    EXPECT_EQ(LiveRenderer::Open(request, diagnostics), nullptr);
    EXPECT_EQ(FirstMessage(diagnostics), FirstMessage(Render(request).diagnostics));
    return FirstName(diagnostics);
  };
  EXPECT_EQ(refusal(ShaderRequest("", "out_color = ;", 4, 4)), "driver-compile");
  EXPECT_EQ(refusal(ShaderRequest("", "", 0, 4)), "size-limit");
  Camera camera;
  Diagnostics diagnostics;
  const auto flat = Open(ShaderRequest("", "out_color = vec4(1); out_height = 0.0;", 4, 4));
  ASSERT_TRUE(flat);
  EXPECT_FALSE(flat->SetCamera(camera, diagnostics));
  EXPECT_EQ(FirstName(diagnostics), "usage");
}

}  // namespace
}  // namespace texgraph::runtime
