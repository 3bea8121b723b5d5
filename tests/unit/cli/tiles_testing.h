// SPDX-License-Identifier: Apache-2.0
// A folder with maps of a material, and texgraph tiles run in it.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "compiler/textures/image.h"
#include "tests/unit/base/scratch_folder.h"
#include "tests/unit/cli/program.h"
#include "tests/unit/textures/tile_testing.h"

namespace texgraph {

class TilesCommand : public testing::Test {
 protected:
  TilesCommand()
      : color_(textures::test::StrokesImage(44, 40, 3, 8, 1)),
        height_(textures::test::StrokesImage(44, 40, 1, 16, 2)) {
    folder.Write("grass.png", *textures::EncodePng(color_));
    folder.Write("height.png", *textures::EncodePng(height_));
  }

  Program Make(std::vector<std::string> arguments) const {
    Program program;
    program.path = TEXGRAPH_PROGRAM;
    program.arguments = {"tiles"};
    program.arguments.insert(program.arguments.end(), arguments.begin(), arguments.end());
    program.folder = folder.path();
    return program;
  }

  textures::Image Picture(const std::string& name) const {
    Diagnostics diagnostics;
    auto image = textures::ReadImage(folder / name, {}, diagnostics);
    EXPECT_TRUE(image) << name;
    return image ? *image : textures::Image();
  }

  void ExpectPicture(const std::string& name, const textures::Image& expected) const {
    const textures::Image image = Picture(name);
    EXPECT_EQ(image.width, expected.width) << name;
    EXPECT_EQ(image.height, expected.height) << name;
    EXPECT_EQ(image.channels, expected.channels) << name;
    EXPECT_EQ(image.bits, expected.bits) << name;
    EXPECT_EQ(image.pixels, expected.pixels) << name;
  }

  textures::Image color_;
  textures::Image height_;
  ScratchFolder folder;
};

}  // namespace texgraph
