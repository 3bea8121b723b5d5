// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>

#include "tests/unit/runtime/image_files.h"

namespace texgraph::textures {
namespace {

using test::Jpeg;
using test::JpegShape;
using test::Png;
using test::PngChunk;
using test::PngHeader;
using test::WriteTemporary;
using testing::HasSubstr;

const std::string kSignature = "\x89PNG\r\n\x1a\n";

struct Outcome {
  std::optional<Image> image;
  std::string name;  // of the first diagnostic
  std::string message;
};

Outcome Read(const std::string& path) {
  Diagnostics diagnostics;
  Outcome outcome;
  outcome.image = ReadImage(path, {}, diagnostics);
  EXPECT_EQ(outcome.image.has_value(), !diagnostics.HasErrors());
  if (diagnostics.HasErrors()) {
    outcome.name = DiagnosticName(diagnostics.all().front().kind);
    outcome.message = diagnostics.all().front().message;
  }
  return outcome;
}

Outcome ReadBytes(const std::string& bytes) {
  const std::string path = WriteTemporary("image", bytes);
  Outcome outcome = Read(path);
  unlink(path.c_str());
  return outcome;
}

std::filesystem::path SharedData() {
  return std::filesystem::path(TEXGRAPH_SOURCE_DIR) / "../shared/data";
}

std::vector<std::filesystem::path> PngSuite() {
  std::vector<std::filesystem::path> files;
  const std::filesystem::path folder = SharedData() / "png_suite/png";
  if (!std::filesystem::is_directory(folder)) return files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".png") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(PngSuiteTest, ReadsTheValidAndRefusesTheCorrupt) {
  const auto files = PngSuite();
  if (files.empty()) GTEST_SKIP() << "PngSuite is not there";
  int valid = 0;
  for (const auto& file : files) {
    const Outcome outcome = Read(file);
    if (file.filename().string()[0] == 'x') {
      EXPECT_EQ(outcome.name, "bad-image") << file;
      continue;
    }
    ++valid;
    ASSERT_TRUE(outcome.image) << file << ": " << outcome.message;
    Diagnostics diagnostics;
    const auto info = ProbeImage(file, {}, diagnostics);
    ASSERT_TRUE(info) << file;
    EXPECT_EQ(info->width, outcome.image->width) << file;
    EXPECT_EQ(info->height, outcome.image->height) << file;
    EXPECT_EQ(info->channels, outcome.image->channels) << file;
    EXPECT_EQ(info->bits, outcome.image->bits) << file;
  }
  EXPECT_GT(valid, 100);
}

// basi* and basn* are the same pictures, interlaced and not.
TEST(PngSuiteTest, InterlacedPicturesEqualTheOthers) {
  int pairs = 0;
  for (const auto& file : PngSuite()) {
    std::string name = file.filename();
    if (!name.starts_with("basi")) continue;
    name[3] = 'n';
    const Outcome interlaced = Read(file);
    const Outcome plain = Read(file.parent_path() / name);
    ASSERT_TRUE(interlaced.image && plain.image) << name;
    EXPECT_EQ(interlaced.image->pixels, plain.image->pixels) << name;
    ++pairs;
  }
  if (pairs == 0) GTEST_SKIP() << "PngSuite is not there";
  EXPECT_EQ(pairs, 15);
}

TEST(PngTest, ExpandsEveryColorType) {
  const std::string zero(1, '\0');
  // 1 bit grey: 1 0.
  Outcome grey = ReadBytes(Png(2, 1, 1, 0, zero + "\x80"));
  ASSERT_TRUE(grey.image) << grey.message;
  EXPECT_EQ(grey.image->channels, 1);
  EXPECT_EQ(grey.image->pixels, (std::vector<uint8_t>{255, 0}));
  // 4 bits: 5 -> 0x55.
  EXPECT_EQ(ReadBytes(Png(1, 1, 4, 0, zero + "\x50")).image->pixels, (std::vector<uint8_t>{0x55}));
  // A palette, with a transparent first entry.
  const std::string palette = PngChunk("PLTE", std::string("\x01\x02\x03\x0a\x0b\x0c", 6));
  const std::string indexes = zero + std::string("\x01\x00", 2);
  EXPECT_EQ(ReadBytes(Png(2, 1, 8, 3, indexes, palette)).image->pixels,
            (std::vector<uint8_t>{10, 11, 12, 1, 2, 3}));
  EXPECT_EQ(ReadBytes(Png(2, 1, 8, 3, indexes, palette + PngChunk("tRNS", zero))).image->pixels,
            (std::vector<uint8_t>{10, 11, 12, 255, 1, 2, 3, 0}));
  // A transparent colour of an RGB image.
  const std::string key = PngChunk("tRNS", std::string("\x00\x01\x00\x02\x00\x03", 6));
  EXPECT_EQ(ReadBytes(Png(2, 1, 8, 2, zero + "\x01\x02\x03\x04\x05\x06", key)).image->pixels,
            (std::vector<uint8_t>{1, 2, 3, 0, 4, 5, 6, 255}));
  // 16 bits, grey and alpha: big-endian in the file.
  Outcome deep = ReadBytes(Png(1, 1, 16, 4, zero + std::string("\x12\x34\xab\xcd", 4)));
  ASSERT_TRUE(deep.image) << deep.message;
  EXPECT_EQ(deep.image->bits, 16);
  EXPECT_EQ(deep.image->channels, 2);
  EXPECT_EQ(deep.image->At(0, 0, 0), 0x1234u);
  EXPECT_EQ(deep.image->At(0, 0, 1), 0xabcdu);
}

TEST(PngTest, WritesWhatItReads) {
  std::mt19937 random(1);
  for (uint8_t bits : {8, 16}) {
    for (uint8_t channels = 1; channels <= 4; ++channels) {
      Image image;
      image.width = 5;
      image.height = 3;
      image.channels = channels;
      image.bits = bits;
      image.pixels.resize(image.RowBytes() * image.height);
      for (uint8_t& byte : image.pixels) byte = static_cast<uint8_t>(random());
      const auto bytes = EncodePng(image);
      ASSERT_TRUE(bytes);
      EXPECT_EQ(*bytes, *EncodePng(image));
      const Outcome back = ReadBytes(*bytes);
      ASSERT_TRUE(back.image) << back.message;
      EXPECT_EQ(back.image->bits, bits);
      EXPECT_EQ(back.image->channels, channels);
      EXPECT_EQ(back.image->pixels, image.pixels);
    }
  }
  EXPECT_FALSE(EncodePng(Image()));
}

TEST(PngTest, RefusesEveryTruncation) {
  const std::string rows(33 * (1 + 32 * 3), '\0');
  const std::string whole = Png(32, 33, 8, 2, rows);
  ASSERT_TRUE(ReadBytes(whole).image);
  for (size_t size = 0; size < whole.size(); ++size) {
    const Outcome outcome = ReadBytes(whole.substr(0, size));
    EXPECT_EQ(outcome.name, "bad-image") << size;
    EXPECT_FALSE(outcome.message.empty());
  }
  EXPECT_THAT(ReadBytes(whole.substr(0, whole.size() / 2)).message,
              HasSubstr("the file is truncated"));
  EXPECT_THAT(ReadBytes("").message, HasSubstr("the file is empty"));
}

TEST(PngTest, RefusesEveryDamagedByte) {
  const std::string whole =
      Png(2, 2, 8, 0, std::string("\0\1\2\0\3\4", 6), PngChunk("tEXt", std::string("a\0b", 3)));
  ASSERT_TRUE(ReadBytes(whole).image);
  for (size_t i = 0; i < whole.size(); ++i) {
    std::string damaged = whole;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x20);
    EXPECT_EQ(ReadBytes(damaged).name, "bad-image") << i;
  }
}

TEST(PngTest, JudgesSizesFromTheHeader) {
  const uint32_t most = 0x7fffffff;
  for (const auto& [width, height] :
       {std::pair{most, most}, {65535u, 65535u}, {30000u, 30000u}, {8193u, 8192u}}) {
    const std::string file = kSignature + PngHeader(width, height, 1, 0) + PngChunk("IDAT", "x");
    const Outcome outcome = ReadBytes(file);
    EXPECT_EQ(outcome.name, "size-limit") << width << ": " << outcome.message;
    const std::string path = WriteTemporary("probe", file);
    Diagnostics diagnostics;
    EXPECT_FALSE(ProbeImage(path, {}, diagnostics));
    EXPECT_EQ(diagnostics.exit_code(), ExitCode::kLimit);
    unlink(path.c_str());
  }
  // The largest allowed size passes the probe.
  const std::string path =
      WriteTemporary("probe", kSignature + PngHeader(8192, 8192, 16, 6) + PngChunk("IDAT", "x"));
  Diagnostics diagnostics;
  const auto info = ProbeImage(path, {}, diagnostics);
  ASSERT_TRUE(info);
  EXPECT_EQ(info->channels, 4);
  EXPECT_EQ(info->bits, 16);
  unlink(path.c_str());
  EXPECT_EQ(ReadBytes(kSignature + PngHeader(0, 5, 8, 0) + PngChunk("IDAT", "x")).name,
            "bad-image");
}

TEST(PngTest, NeverUnpacksTexts) {
  const std::string packed = test::Deflate(std::string(size_t{100} << 20, 'a'));
  const std::string bomb = Png(1, 1, 8, 0, std::string(2, '\0'),
                               PngChunk("zTXt", std::string("a\0\0", 3) + packed) +
                                   PngChunk("iCCP", std::string("a\0\0", 3) + packed));
  const std::string path = WriteTemporary("bomb", bomb);
  const pid_t child = fork();
  if (child == 0) {
    // The limit is on what the child may add to what it has: the picture needs next to nothing.
    std::ifstream statm("/proc/self/statm");
    size_t pages = 0;
    statm >> pages;
    const rlim_t bytes = pages * static_cast<size_t>(sysconf(_SC_PAGESIZE)) + (16u << 20);
    const rlimit limit{bytes, bytes};
    setrlimit(RLIMIT_AS, &limit);
    Diagnostics diagnostics;
    _exit(ReadImage(path, {}, diagnostics) ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  unlink(path.c_str());
}

TEST(JpegTest, ReadsGreyAndColor) {
  for (bool progressive : {false, true}) {
    std::vector<uint8_t> grey(64);
    for (int i = 0; i < 64; ++i) grey[i] = static_cast<uint8_t>(4 * (i % 8) + 16 * (i / 8));
    const Outcome one = ReadBytes(Jpeg({8, 8, 1, progressive}, grey));
    ASSERT_TRUE(one.image) << one.message;
    EXPECT_EQ(one.image->channels, 1);
    for (uint32_t y = 0; y < 8; ++y) {
      for (uint32_t x = 0; x < 8; ++x) EXPECT_NEAR(one.image->At(x, y, 0), grey[8 * y + x], 2);
    }
    std::vector<uint8_t> red;
    for (int i = 0; i < 256; ++i) red.insert(red.end(), {200, 30, 60});
    const Outcome three = ReadBytes(Jpeg({16, 16, 3, progressive}, red));
    ASSERT_TRUE(three.image) << three.message;
    EXPECT_EQ(three.image->channels, 3);
    EXPECT_NEAR(three.image->At(7, 9, 0), 200, 2);
    EXPECT_NEAR(three.image->At(7, 9, 1), 30, 2);
    EXPECT_NEAR(three.image->At(7, 9, 2), 60, 2);
  }
}

TEST(JpegTest, RefusesEveryTruncation) {
  std::vector<uint8_t> noise(48 * 48 * 3);
  std::mt19937 random(2);
  for (uint8_t& byte : noise) byte = static_cast<uint8_t>(random());
  for (bool progressive : {false, true}) {
    const std::string whole = Jpeg({48, 48, 3, progressive, 90}, noise);
    ASSERT_TRUE(ReadBytes(whole).image);
    for (size_t size = 0; size < whole.size(); size += 7) {
      EXPECT_EQ(ReadBytes(whole.substr(0, size)).name, "bad-image")
          << size << " of " << whole.size();
    }
    EXPECT_THAT(ReadBytes(whole.substr(0, whole.size() - 2)).message, HasSubstr("truncated"));
  }
}

TEST(JpegTest, RefusesWhatItCannotMean) {
  const Outcome cmyk = ReadBytes(Jpeg({8, 8, 4}, std::vector<uint8_t>(256, 100)));
  EXPECT_EQ(cmyk.name, "bad-image");
  EXPECT_THAT(cmyk.message, HasSubstr("CMYK"));
  const std::string tiny("\xff\xd8\xff\xc4\x00\x14\x00\x01\x02\x03\x04\x05\x06\x07\x08\x09", 16);
  EXPECT_EQ(ReadBytes(tiny).name, "bad-image");
  // 65,500 x 65,500 in the header of a small picture.
  std::string huge = Jpeg({8, 8, 3}, std::vector<uint8_t>(192, 1));
  const size_t frame = huge.find("\xff\xc0");
  ASSERT_NE(frame, std::string::npos);
  for (size_t i = frame + 5; i < frame + 9; i += 2) {
    huge[i] = static_cast<char>(0xff);
    huge[i + 1] = static_cast<char>(0xdc);
  }
  EXPECT_EQ(ReadBytes(huge).name, "size-limit");
}

TEST(JpegTest, RefusesEndlessScans) {
  const Outcome outcome =
      ReadBytes(Jpeg({16, 16, 1, true, 100, true}, std::vector<uint8_t>(256, 77)));
  EXPECT_FALSE(outcome.image);
  EXPECT_EQ(outcome.name, "size-limit") << outcome.message;
}

// Random damage: whatever comes back, nothing crashes (run under the sanitizers too).
TEST(JpegTest, SurvivesDamage) {
  std::vector<uint8_t> noise(32 * 32 * 3);
  std::mt19937 random(3);
  for (uint8_t& byte : noise) byte = static_cast<uint8_t>(random());
  for (bool progressive : {false, true}) {
    const std::string whole = Jpeg({32, 32, 3, progressive, 75}, noise);
    for (int round = 0; round < 400; ++round) {
      std::string damaged = whole;
      for (int flips = 0; flips < 3; ++flips)
        damaged[random() % damaged.size()] = static_cast<char>(random());
      const Outcome outcome = ReadBytes(damaged);
      if (!outcome.image) continue;
      EXPECT_EQ(outcome.image->pixels.size(), outcome.image->RowBytes() * outcome.image->height);
    }
  }
}

TEST(ImageFileTest, OpensRegularFilesOnly) {
  const std::string folder = testing::TempDir();
  EXPECT_EQ(Read(folder + "/texgraph-no-such-image.png").name, "missing-file");
  EXPECT_EQ(Read(folder).name, "cannot-read");
  EXPECT_EQ(Read("/dev/zero").name, "cannot-read");
  EXPECT_EQ(Read(std::string("a\0.png", 6)).name, "cannot-read");
  const std::string fifo = folder + "texgraph_fifo_" + std::to_string(getpid());
  ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
  const Outcome outcome = Read(fifo);
  EXPECT_EQ(outcome.name, "cannot-read");
  EXPECT_THAT(outcome.message, HasSubstr("not a regular file"));
  unlink(fifo.c_str());
  const std::string loop = folder + "texgraph_loop_" + std::to_string(getpid());
  ASSERT_EQ(symlink(loop.c_str(), loop.c_str()), 0);
  EXPECT_EQ(Read(loop).name, "cannot-read");
  unlink(loop.c_str());
}

TEST(ImageFileTest, GoesByContentNotByName) {
  const std::string path = WriteTemporary("picture.jpg", Png(1, 1, 8, 0, std::string("\0\7", 2)));
  EXPECT_TRUE(Read(path).image);
  unlink(path.c_str());
  const Outcome text = ReadBytes("GIF89a, or so it says");
  EXPECT_EQ(text.name, "bad-image");
  EXPECT_THAT(text.message, HasSubstr("neither a PNG nor a JPEG"));
}

TEST(ImageFileTest, ReadsPhotographs) {
  const std::filesystem::path file = SharedData() / "brick_mask.jpg";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "the photographs are not there";
  const Outcome outcome = Read(file);
  ASSERT_TRUE(outcome.image) << outcome.message;
  EXPECT_EQ(outcome.image->width, 2048u);
  EXPECT_EQ(outcome.image->height, 2048u);
}

}  // namespace
}  // namespace texgraph::textures
