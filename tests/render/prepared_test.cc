// SPDX-License-Identifier: Apache-2.0
// A picture with a colour key, near and far, laid over another colour: wherever it is drawn, a
// pixel is a mixture of that colour and the picture's own, with nothing of the background.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compiler/textures/image.h"
#include "compiler/textures/srgb.h"
#include "tests/unit/base/scratch_folder.h"
#include "tests/unit/cli/program.h"

namespace texgraph {
namespace {

using textures::Image;

constexpr double kFull[3] = {0.8, 0.6, 0.05}, kBelow[3] = {0.1, 0.1, 0.7};
constexpr double kRadius = 0.3;
constexpr uint32_t kSize = 256;

// A disc with a rim of two texels before black.
Image Disc() {
  Image image;
  image.width = image.height = kSize;
  image.channels = 3;
  for (uint32_t y = 0; y < kSize; ++y) {
    for (uint32_t x = 0; x < kSize; ++x) {
      const double distance = std::hypot(x + 0.5 - kSize / 2, y + 0.5 - kSize / 2);
      const double alpha = std::clamp((kRadius * kSize - distance) / 2 + 0.5, 0.0, 1.0);
      for (double c : kFull)
        image.pixels.push_back(textures::SrgbEncode8(static_cast<float>(alpha * c)));
    }
  }
  return image;
}

std::string Graph(const std::string& texture) {
  return R"({ "texgraph": 1, "name": "disc",
    "textures": { "picture": { )" +
         texture + R"( } },
    "parameters": { "size": { "type": "float", "value": 1, "binding": "uniform" } },
    "nodes": {
      "place": { "block": "uv_transform", "in": { "scale": "size", "pivot": [0, 0] } },
      "disc": { "block": "image", "in": { "picture": "picture", "uv": "place" } },
      "laid": { "block": "over", "in": { "foreground": "disc", "background": [0.1, 0.1, 0.7, 1] } } },
    "outputs": { "color": "laid" } })";
}

class Prepared : public testing::Test {
 protected:
  Prepared() { folder.Write("disc.png", *textures::EncodePng(Disc())); }

  Image Render(const std::string& input, const std::string& size) {
    Program program;
    program.path = TEXGRAPH_PROGRAM;
    program.folder = folder.path();
    program.arguments = {"render", input, "--set", "size=" + size, "--size", "128", "-o", "o.png"};
    const Outcome outcome = program.Run();
    EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
    Diagnostics diagnostics;
    auto image = textures::ReadImage(folder / "o.png", {}, diagnostics);
    return image ? *image : Image();
  }

  // How much of the disc a picture shows, and how far its pixels are from the mixtures of the two.
  static void Judge(const Image& image, double& share, double& furthest) {
    share = furthest = 0;
    for (uint32_t y = 0; y < image.height; ++y) {
      for (uint32_t x = 0; x < image.width; ++x) {
        double along = 0, length = 0, color[3];
        for (uint32_t c = 0; c < 3; ++c) {
          color[c] = textures::SrgbDecode(image.At(x, y, c) / 255.0);
          along += (color[c] - kBelow[c]) * (kFull[c] - kBelow[c]);
          length += (kFull[c] - kBelow[c]) * (kFull[c] - kBelow[c]);
        }
        const double part = along / length;
        share += part / (image.width * image.height);
        for (uint32_t c = 0; c < 3; ++c) {
          const double mixed = kBelow[c] + part * (kFull[c] - kBelow[c]);
          furthest = std::max(furthest, std::fabs(color[c] - mixed));
        }
      }
    }
  }

  ScratchFolder folder;
};

TEST_F(Prepared, NoFringeAtAnySize) {
  folder.Write("keyed.json", Graph(R"("file": "disc.png", "key": { "tolerance": 0.04 })"));
  folder.Write("plain.json", Graph(R"("file": "disc.png")"));
  for (const char* size : {"1", "0.5", "0.125", "0.03125", "0.0078125"}) {
    double share = 0, furthest = 0;
    Judge(Render("keyed.json", size), share, furthest);
    // Pixels have 8 bits, and so have the texels' alpha and colour.
    EXPECT_LT(furthest, 0.02) << size;
    EXPECT_NEAR(share, M_PI * kRadius * kRadius, 0.005) << size;
    Judge(Render("plain.json", size), share, furthest);
    EXPECT_GT(furthest, 0.1) << size;
  }
}

TEST_F(Prepared, TheWrittenPictureIsTheOneThatIsDrawn) {
  folder.Write("keyed.json", Graph(R"("file": "disc.png", "key": { "edge": 3 })"));
  std::filesystem::create_directory(folder / "out");
  ASSERT_EQ(Texgraphc({"keyed.json", "-o", "out/disc.frag"}, folder.path()).Run().exit_code, 0);
  EXPECT_EQ(Render("keyed.json", "0.3").pixels, Render("out/disc.json", "0.3").pixels);
}

}  // namespace
}  // namespace texgraph
