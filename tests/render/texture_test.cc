// SPDX-License-Identifier: Apache-2.0
// Textures as the GPU samples them against ir::SampleLod and ir::SampleGrad: the same texels in
// every format, the same wrap modes, filters and levels.
#include "compiler/ir/texture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "runtime/render.h"
#include "tests/render/render_testing.h"

namespace texgraph::runtime {
namespace {

using test::AddTexture;
using test::FirstMessage;
using test::FirstName;
using test::FloatAt;
using test::ShaderRequest;
using textures::TextureData;
using textures::TextureOptions;

textures::Image RandomImage(uint32_t width, uint32_t height, uint8_t channels, uint8_t bits,
                            uint32_t seed) {
  textures::Image image;
  image.width = width;
  image.height = height;
  image.channels = channels;
  image.bits = bits;
  image.pixels.resize(image.RowBytes() * height);
  std::mt19937 random(seed);
  for (uint8_t& byte : image.pixels) byte = static_cast<uint8_t>(random());
  return image;
}

TextureData Make(const std::vector<textures::Image>& layers, const TextureOptions& options) {
  Diagnostics diagnostics;
  auto data = textures::MakeTexture(layers, options, "image", {}, diagnostics);
  EXPECT_TRUE(data);
  return data ? std::move(*data) : TextureData();
}

// The largest difference between `output` and reference(uv) over all pixels; powers of two keep uv
// exact.
template <class Function>
double LargestDifference(const RenderedOutput& output, const RenderRequest& request,
                         Function reference) {
  double largest = 0;
  for (uint32_t y = 0; y < request.height; ++y) {
    for (uint32_t x = 0; x < request.width; ++x) {
      const float uv[2] = {
          static_cast<float>(request.window[0] +
                             (request.window[2] - request.window[0]) * (x + 0.5) / request.width),
          static_cast<float>(request.window[1] +
                             (request.window[3] - request.window[1]) * (y + 0.5) / request.height)};
      const ir::Texel expected = reference(uv);
      for (uint32_t c = 0; c < 4; ++c) {
        largest = std::max(largest, std::abs(static_cast<double>(expected[c]) -
                                             FloatAt(output, request.width, x, y, c)));
      }
    }
  }
  return largest;
}

RenderResult Draw(RenderRequest& request, ContextChoice choice) {
  request.context.choice = choice;
  RenderResult result = Render(request);
  EXPECT_TRUE(result.ok()) << FirstMessage(result.diagnostics) << result.driver_log;
  return result;
}

class TextureTest : public testing::TestWithParam<test::NamedContext> {};
INSTANTIATE_TEST_SUITE_P(Contexts, TextureTest, testing::ValuesIn(test::AllContexts()),
                         [](const auto& info) { return info.param.name; });

constexpr double kByte = 1.0 / 255;

// Every texel of every level, fetched: decoding and upload, with no filter.
TEST_P(TextureTest, EveryTexelOfEveryLevelArrives) {
  struct Case {
    uint8_t bits;
    bool srgb, as_float;
    double tolerance;
  };
  // Mesa decodes sRGB by a polynomial that is up to 0.0012 off (0.35 of a step of the code).
  for (const Case& c :
       {Case{8, false, false, 1e-7}, Case{8, true, false, 0.0012}, Case{16, false, false, 1e-7},
        Case{16, true, false, 1e-7}, Case{8, true, true, 0}}) {
    TextureOptions options;
    options.srgb = c.srgb;
    options.as_float = c.as_float;
    const TextureData data = Make({RandomImage(16, 8, 4, c.bits, 1)}, options);
    const ir::Texture texture = ToTexture(data);
    ASSERT_EQ(texture.levels.size(), 5u);
    for (int level = 0; level < 5; ++level) {
      RenderRequest request =
          ShaderRequest("uniform sampler2D image;",
                        "out_color = texelFetch(image, ivec2(gl_FragCoord.xy), " +
                            std::to_string(level) + "); out_height = 0.0;",
                        std::max(16 >> level, 1), std::max(8 >> level, 1));
      AddTexture(request, "image", data);
      const RenderResult result = Draw(request, GetParam().choice);
      const auto& from = texture.levels[static_cast<size_t>(level)];
      for (uint32_t i = 0; i < from.width * from.height; ++i) {
        for (uint32_t channel = 0; channel < 4; ++channel) {
          ASSERT_NEAR(result.outputs[0].floats[4 * i + channel], from.texels[i][channel],
                      c.tolerance)
              << "level " << level << " texel " << i << " bits " << int{c.bits} << " srgb "
              << c.srgb;
        }
      }
    }
  }
}

TEST_P(TextureTest, WrapsAndFiltersAsTheSpecificationSays) {
  for (ir::Wrap wrap : {ir::Wrap::kRepeat, ir::Wrap::kClamp, ir::Wrap::kMirror}) {
    for (ir::Filter filter : {ir::Filter::kNearest, ir::Filter::kLinear}) {
      for (bool as_float : {false, true}) {
        TextureOptions options;
        options.wrap_u = wrap;
        options.wrap_v = wrap == ir::Wrap::kClamp ? ir::Wrap::kRepeat : ir::Wrap::kClamp;
        options.filter = filter;
        options.as_float = as_float;
        const TextureData data = Make({RandomImage(16, 8, 3, 8, 2)}, options);
        const ir::Texture texture = ToTexture(data);
        std::vector<RenderRequest> requests;
        const float levels[] = {0.0f, 1.0f, 1.25f, 2.75f};
        for (float level : levels) {
          RenderRequest& request = requests.emplace_back(ShaderRequest(
              "uniform sampler2D image; uniform float level;",
              "out_color = textureLod(image, uv, level); out_height = 0.0;", 128, 128));
          request.context.choice = GetParam().choice;
          request.window = {-1.53125, -1.28125, 2.46875, 2.71875};
          AddTexture(request, "image", data);
          test::AddUniform(request, "level", ir::kFloat, {level});
        }
        const std::vector<RenderResult> results = RenderAll(requests);
        for (size_t i = 0; i < requests.size(); ++i) {
          ASSERT_TRUE(results[i].ok()) << FirstMessage(results[i].diagnostics);
          const double difference = LargestDifference(
              results[i].outputs[0], requests[i],
              [&](const float* uv) { return ir::SampleLod(texture, uv, levels[i]); });
          // Mesa's filter weights have 8 bits where the texels have.
          EXPECT_LE(difference, as_float ? 1e-5 : kByte)
              << "wrap " << int(wrap) << " filter " << int(filter) << " level " << levels[i];
        }
      }
    }
  }
}

// A texture whose level l is l everywhere, so that what is sampled is the level.
TextureData LevelNumbers(uint32_t side) {
  TextureData data;
  data.format = textures::TexelFormat::kRgba32F;
  for (float level = 0; side > 0; side /= 2, ++level) {
    textures::TexelLevel& to = data.levels.emplace_back();
    to.width = to.height = side;
    const std::vector<float> values(size_t{4} * side * side, level);
    const auto* bytes = reinterpret_cast<const uint8_t*>(values.data());
    to.bytes.assign(bytes, bytes + 4 * values.size());
  }
  return data;
}

TEST_P(TextureTest, GradientsChooseTheLevel) {
  const TextureData data = LevelNumbers(64);
  const ir::Texture texture = ToTexture(data);
  const float gradients[][4] = {{0, 0, 0, 0},
                                {0.01f, 0, 0, 0.01f},
                                {0.02f, 0, 0, 0},
                                {0, 0.02f, 0, 0},
                                {0, 0, 0.025f, 0},
                                {0, 0, 0, 0.03125f},
                                {0.05f, 0.02f, -0.01f, 0.03f},
                                {0.03f, 0.03f, 0, 0},
                                {-0.03f, 0.03f, 0.1f, 0.02f},
                                {0, 0.2f, 0.001f, 0},
                                {3, 0, 0, 3}};
  std::vector<RenderRequest> requests;
  for (const auto& g : gradients) {
    RenderRequest& request = requests.emplace_back(
        ShaderRequest("uniform sampler2D image; uniform vec4 g;",
                      "out_color = textureGrad(image, uv, g.xy, g.zw); out_height = 0.0;", 4, 4));
    request.context.choice = GetParam().choice;
    AddTexture(request, "image", data);
    test::AddUniform(request, "g", ir::kVec4, {g[0], g[1], g[2], g[3]});
  }
  const std::vector<RenderResult> results = RenderAll(requests);
  for (size_t i = 0; i < requests.size(); ++i) {
    ASSERT_TRUE(results[i].ok()) << FirstMessage(results[i].diagnostics);
    const float uv[2] = {0.375f, 0.375f};
    const float cpu = ir::SampleGrad(texture, uv, gradients[i], gradients[i] + 2)[0];
    const float gpu = FloatAt(results[i].outputs[0], 4, 1, 1, 0);
    // Mesa takes log2(1 + m) for m: half the logarithm of the square is up to 0.0431 too small.
    EXPECT_LE(gpu, cpu + 1e-5f) << i;
    EXPECT_GE(gpu, cpu - 0.0432f) << i;
  }
}

// Where the footprint is a power of two, the level is exact.
TEST_P(TextureTest, GradientsFilterTheRightTexels) {
  TextureOptions options;
  options.as_float = true;
  const TextureData data = Make({RandomImage(64, 64, 3, 8, 3)}, options);
  const ir::Texture texture = ToTexture(data);
  for (float footprint : {0.5f, 1.0f, 2.0f, 8.0f}) {
    const float g[4] = {footprint / 64, 0, 0, 0.001f};
    RenderRequest request = ShaderRequest(
        "uniform sampler2D image; uniform vec4 g;",
        "out_color = textureGrad(image, uv, g.xy, g.zw); out_height = 0.0;", 128, 128);
    request.window = {0.125, 0.25, 1.125, 1.25};
    AddTexture(request, "image", data);
    test::AddUniform(request, "g", ir::kVec4, {g[0], g[1], g[2], g[3]});
    const RenderResult result = Draw(request, GetParam().choice);
    const double difference = LargestDifference(result.outputs[0], request, [&](const float* uv) {
      return ir::SampleGrad(texture, uv, g, g + 2);
    });
    EXPECT_LE(difference, 1e-5) << footprint;
  }
}

TEST_P(TextureTest, MaxLevelHolds) {
  TextureOptions options;
  options.max_level = 2;
  const TextureData data = Make({RandomImage(16, 16, 3, 8, 4)}, options);
  const ir::Texture texture = ToTexture(data);
  RenderRequest request =
      ShaderRequest("uniform sampler2D image;",
                    "out_color = textureLod(image, uv, 9.0); out_height = 0.0;", 32, 32);
  AddTexture(request, "image", data);
  const RenderResult result = Draw(request, GetParam().choice);
  EXPECT_LE(LargestDifference(result.outputs[0], request,
                              [&](const float* uv) { return ir::SampleLod(texture, uv, 2.0f); }),
            kByte);
}

TEST_P(TextureTest, ArraysHaveLayers) {
  TextureOptions options;
  options.is_array = true;
  const TextureData data =
      Make({RandomImage(8, 8, 3, 8, 5), RandomImage(8, 8, 3, 8, 6), RandomImage(8, 8, 3, 8, 7)},
           options);
  const ir::Texture texture = ToTexture(data);
  RenderRequest request = ShaderRequest(
      "uniform sampler2DArray image;",
      "out_color = textureLod(image, vec3(uv, 4.0 * uv.x - 0.7), 1.0); out_height = 0.0;", 64, 64);
  AddTexture(request, "image", data);
  const RenderResult result = Draw(request, GetParam().choice);
  const double difference = LargestDifference(result.outputs[0], request, [&](const float* uv) {
    const float coordinate[3] = {uv[0], uv[1], 4.0f * uv[0] - 0.7f};
    return ir::SampleLod(texture, coordinate, 1.0f);
  });
  EXPECT_LE(difference, kByte);
}

TEST_P(TextureTest, VolumesHaveThreeAxes) {
  for (ir::Wrap wrap : {ir::Wrap::kRepeat, ir::Wrap::kClamp, ir::Wrap::kMirror}) {
    TextureOptions options;
    options.is_3d = true;
    options.as_float = true;
    options.wrap_v = ir::Wrap::kClamp;
    options.wrap_w = wrap;
    std::vector<textures::Image> slices;
    for (uint32_t z = 0; z < 8; ++z) slices.push_back(RandomImage(8, 4, 3, 8, 20 + z));
    const ir::Texture texture = ToTexture(Make(slices, options));
    for (float level : {0.0f, 0.75f, 2.0f}) {
      RenderRequest request =
          ShaderRequest("uniform sampler3D image; uniform float level;",
                        "out_color = textureLod(image, vec3(uv, 2.0 * uv.x - 0.5 * uv.y), level);"
                        "out_height = 0.0;",
                        64, 64);
      request.window = {-0.78125, -0.53125, 1.21875, 1.46875};
      AddTexture(request, "image", Make(slices, options));
      test::AddUniform(request, "level", ir::kFloat, {level});
      const RenderResult result = Draw(request, GetParam().choice);
      const double difference = LargestDifference(result.outputs[0], request, [&](const float* uv) {
        const float coordinate[3] = {uv[0], uv[1], 2.0f * uv[0] - 0.5f * uv[1]};
        return ir::SampleLod(texture, coordinate, level);
      });
      EXPECT_LE(difference, 1e-5) << "wrap " << int(wrap) << " level " << level;
    }
  }
}

// Maps of numbers: read as they are, one channel, the rest as OpenGL fills it up.
TEST_P(TextureTest, NumbersArrive) {
  for (auto format : {textures::TexelFormat::kR16F, textures::TexelFormat::kR32F}) {
    const bool half = format == textures::TexelFormat::kR16F;
    TextureData data;
    data.format = format;
    data.sampler.filter = ir::Filter::kNearest;
    data.sampler.mip_filter = ir::MipFilter::kNone;
    textures::TexelLevel& level = data.levels.emplace_back();
    level.width = 3;  // an odd number of bytes in a row for halves: no row is padded
    level.height = 2;
    const std::vector<float> numbers = {-1, 0, 1, 7, 2047, half ? 2048.0f : 16777215.0f};
    const uint16_t halves[] = {0xbc00, 0, 0x3c00, 0x4700, 0x67ff, 0x6800};
    const auto* bytes = half ? reinterpret_cast<const uint8_t*>(halves)
                             : reinterpret_cast<const uint8_t*>(numbers.data());
    level.bytes.assign(bytes, bytes + numbers.size() * (half ? 2 : 4));
    RenderRequest request = ShaderRequest(
        "uniform sampler2D image;",
        "out_color = texelFetch(image, ivec2(gl_FragCoord.xy), 0); out_height = 0.0;", 3, 2);
    AddTexture(request, "image", data);
    const RenderResult result = Draw(request, GetParam().choice);
    const ir::Texture texture = ToTexture(data);
    for (uint32_t i = 0; i < 6; ++i) {
      EXPECT_EQ(texture.levels[0].texels[i], (ir::Texel{numbers[i], 0, 0, 1})) << i;
      for (uint32_t channel = 0; channel < 4; ++channel) {
        EXPECT_EQ(FloatAt(result.outputs[0], 3, i % 3, i / 3, channel),
                  texture.levels[0].texels[i][channel])
            << i;
      }
    }
  }
}

TEST_P(TextureTest, ManyTexturesKeepTheirNames) {
  const int count = 16;
  std::string declarations;
  std::string sum = "0.0";
  for (int i = 0; i < count; ++i) {
    declarations += "uniform sampler2D image_" + std::to_string(i) + ";";
    sum +=
        " + textureLod(image_" + std::to_string(i) + ", uv, 0.0).r * " + std::to_string(i) + ".0";
  }
  RenderRequest request =
      ShaderRequest(declarations, "out_color = vec4(" + sum + "); out_height = 0.0;", 2, 2);
  double expected = 0;
  for (int i = 0; i < count; ++i) {
    textures::Image image = RandomImage(1, 1, 1, 8, 100u + static_cast<uint32_t>(i));
    expected += i * image.At(0, 0, 0) / 255.0;
    TextureOptions options;
    options.srgb = false;
    AddTexture(request, "image_" + std::to_string(i), Make({image}, options));
  }
  EXPECT_NEAR(FloatAt(Draw(request, GetParam().choice).outputs[0], 2, 0, 0, 0), expected, 1e-4);
}

TEST_P(TextureTest, TooManyTexturesAreALimit) {
  RenderRequest request = ShaderRequest("", "out_color = vec4(1.0); out_height = 0.0;", 2, 2);
  request.context.choice = GetParam().choice;
  for (int i = 0; i < 300; ++i) {
    AddTexture(request, "image_" + std::to_string(i), Make({RandomImage(1, 1, 1, 8, 1)}, {}));
  }
  const RenderResult result = Render(request);
  EXPECT_EQ(FirstName(result.diagnostics), "target-limit");
  EXPECT_EQ(result.diagnostics.exit_code(), ExitCode::kLimit);
}

TEST_P(TextureTest, TooDeepTexturesAreALimit) {
  TextureOptions options;
  options.is_3d = true;
  options.mipmaps = false;
  RenderRequest request =
      ShaderRequest("uniform sampler3D image;",
                    "out_color = texture(image, vec3(uv, 0.0)); out_height = 0.0;", 2, 2);
  request.context.choice = GetParam().choice;
  AddTexture(request, "image",
             Make(std::vector<textures::Image>(70000, RandomImage(1, 1, 1, 8, 1)), options));
  const RenderResult result = Render(request);
  EXPECT_EQ(FirstName(result.diagnostics), "target-limit") << FirstMessage(result.diagnostics);
}

TEST_P(TextureTest, TooLargeTexturesAreALimit) {
  // 16,385 texels in a row: one more than Mesa takes.
  TextureOptions options;
  options.mipmaps = false;
  RenderRequest request = ShaderRequest("uniform sampler2D image;",
                                        "out_color = texture(image, uv); out_height = 0.0;", 2, 2);
  request.context.choice = GetParam().choice;
  AddTexture(request, "image", Make({RandomImage(70000, 1, 1, 8, 1)}, options));
  const RenderResult result = Render(request);
  EXPECT_EQ(FirstName(result.diagnostics), "target-limit") << FirstMessage(result.diagnostics);
}

}  // namespace
}  // namespace texgraph::runtime
