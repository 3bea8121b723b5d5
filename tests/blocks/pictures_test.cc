// SPDX-License-Identifier: Apache-2.0
// The committed pictures are those that the generator draws, pixel by pixel, and fit for their use.
#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>

#include "graphs/pictures/picture.h"

namespace texgraph::pictures {
namespace {

std::string PathOf(const NamedPicture& picture) {
  return std::string(TEXGRAPH_SOURCE_DIR) + "/graphs/" + picture.path;
}

Picture ReadPng(const std::string& path) {
  png_image image;
  std::memset(&image, 0, sizeof image);
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, path.c_str()) == 0) {
    return {};
  }
  Picture picture;
  picture.width = static_cast<int>(image.width);
  picture.height = static_cast<int>(image.height);
  picture.has_alpha = (image.format & PNG_FORMAT_FLAG_ALPHA) != 0;
  image.format = picture.has_alpha ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
  picture.pixels.resize(PNG_IMAGE_SIZE(image));
  if (png_image_finish_read(&image, nullptr, picture.pixels.data(), 0, nullptr) == 0) {
    return {};
  }
  return picture;
}

// A test for each, so that they are drawn side by side.
class PictureTest : public testing::TestWithParam<NamedPicture> {};

TEST_P(PictureTest, GeneratorDrawsTheCommittedPixels) {
  const Picture drawn = GetParam().make();
  const Picture committed = ReadPng(PathOf(GetParam()));
  ASSERT_EQ(drawn.width, committed.width);
  ASSERT_EQ(drawn.height, committed.height);
  ASSERT_EQ(drawn.has_alpha, committed.has_alpha);
  EXPECT_TRUE(drawn.pixels == committed.pixels);
}

INSTANTIATE_TEST_SUITE_P(All, PictureTest, testing::ValuesIn(Pictures()), [](const auto& info) {
  std::string name = info.param.path.substr(0, info.param.path.find('.'));
  std::ranges::replace(name, '/', '_');
  return name;
});

// A sheet of many tiles of grass is noise, which PNG stores almost as it is: 20 KiB for each tile
// of 128 x 128 that is more than fits in 300 KiB.
TEST(PicturesTest, FilesAreSmall) {
  for (const NamedPicture& named : Pictures()) {
    const Picture picture = ReadPng(PathOf(named));
    const uintmax_t tiles = static_cast<uintmax_t>(picture.width) * picture.height / (128 * 128);
    const uintmax_t limit = std::max<uintmax_t>(300, 20 * tiles) * 1024;
    EXPECT_LT(std::filesystem::file_size(PathOf(named)), limit) << named.path;
  }
}

// The step from the last row or column to the first is like the steps inside.
TEST(PicturesTest, PicturesToTileWithRepeatWithoutASeam) {
  for (const char* name :
       {"brick_wall/mortar.png", "first_wall/mortar.png", "hallway/plaster.png",
        "hallway/plaster_relief.png", "painted_wood/wood.png", "grass_tiles/grass.png",
        "plain/dry_grass.png", "plain/earth.png", "pebbles/pebbles.png", "hex_tiling/lawn.png",
        "hex_tiling/gravel.png", "hex_tiling/gravel_height.png", "hex_tiling/gravel_relief.png"}) {
    SCOPED_TRACE(name);
    Picture picture = ReadPng(std::string(TEXGRAPH_SOURCE_DIR) + "/graphs/" + name);
    ASSERT_FALSE(picture.has_alpha);
    auto at = [&](int x, int y) {
      return static_cast<double>(
          picture.pixels[3 * (static_cast<size_t>(y % picture.height) * picture.width +
                              x % picture.width)]);
    };
    double inside_x = 0, inside_y = 0, border_x = 0, border_y = 0;
    for (int y = 0; y < picture.height; ++y) {
      for (int x = 0; x < picture.width; ++x) {
        double step_x = std::abs(at(x + 1, y) - at(x, y));
        double step_y = std::abs(at(x, y + 1) - at(x, y));
        (x + 1 == picture.width ? border_x : inside_x) += step_x;
        (y + 1 == picture.height ? border_y : inside_y) += step_y;
      }
    }
    inside_x /= picture.height * (picture.width - 1.0);
    inside_y /= picture.width * (picture.height - 1.0);
    EXPECT_LT(border_x / picture.height, 1.25 * inside_x);
    EXPECT_LT(border_y / picture.width, 1.25 * inside_y);
  }
}

// The normals of a relief have a length of 1, but for rounding, and look out of the surface.
TEST(PicturesTest, ReliefsHaveNormals) {
  int reliefs = 0;
  for (const NamedPicture& named : Pictures()) {
    if (named.path.find("_relief") == std::string::npos) {
      continue;
    }
    ++reliefs;
    Picture picture = ReadPng(PathOf(named));
    const size_t size = picture.has_alpha ? 4 : 3;
    for (size_t i = 0; i < picture.pixels.size(); i += size) {
      double square = 0;
      for (size_t k = 0; k < 3; ++k) {
        double component = picture.pixels[i + k] / 127.5 - 1;
        square += component * component;
      }
      ASSERT_NEAR(square, 1, 0.02) << named.path;
      ASSERT_GT(picture.pixels[i + 2], 127) << named.path;
    }
  }
  EXPECT_GE(reliefs, 6);
}

// A picture with alpha ends before its border does, so that nothing is cut off or repeated.
TEST(PicturesTest, BordersOfLayersAreTransparent) {
  for (const NamedPicture& named : Pictures()) {
    Picture picture = ReadPng(PathOf(named));
    if (!picture.has_alpha) {
      continue;
    }
    int opaque = 0;
    auto alpha = [&](int x, int y) {
      return picture.pixels[4 * (static_cast<size_t>(y) * picture.width + x) + 3];
    };
    for (int x = 0; x < picture.width; ++x) {
      opaque += alpha(x, 0) > 0 || alpha(x, picture.height - 1) > 0;
    }
    for (int y = 0; y < picture.height; ++y) {
      opaque += alpha(0, y) > 0 || alpha(picture.width - 1, y) > 0;
    }
    EXPECT_EQ(opaque, 0) << named.path;
  }
}

// What a colour key takes away is there to be taken: black all around, and no hole in the leaf.
TEST(PicturesTest, TheLeafLiesOnBlack) {
  Picture picture =
      ReadPng(std::string(TEXGRAPH_SOURCE_DIR) + "/graphs/first_wall/leaf_on_black.png");
  ASSERT_FALSE(picture.has_alpha);
  auto brightest = [&](int x, int y) {
    const uint8_t* p = &picture.pixels[3 * (static_cast<size_t>(y) * picture.width + x)];
    return std::max({p[0], p[1], p[2]});
  };
  for (int y = picture.height / 2; y < picture.height / 2 + 8; ++y) {
    int changes = 0;  // from black to the leaf, and back
    for (int x = 1; x < picture.width; ++x)
      changes += (brightest(x, y) > 13) != (brightest(x - 1, y) > 13);
    EXPECT_EQ(changes, 2) << y;
  }
  for (int i = 0; i < picture.width; ++i) {
    EXPECT_EQ(brightest(i, 0) | brightest(i, picture.height - 1), 0) << i;
    EXPECT_EQ(brightest(0, i) | brightest(picture.width - 1, i), 0) << i;
  }
}

}  // namespace
}  // namespace texgraph::pictures
