// SPDX-License-Identifier: Apache-2.0
// Files as the KTX 2.0 specification has them, by a reader of the test's own that knows nothing of
// the program's; and damaged files, which are diagnostics.
#include "compiler/textures/ktx2.h"

#include <gtest/gtest.h>
#include <string.h>

#include <map>
#include <numeric>
#include <random>

#include "tests/unit/base/scratch_folder.h"
#include "tests/unit/textures/texture_testing.h"

namespace texgraph::textures {
namespace {

// The header, field by field as section 2 of the specification lists them.
struct Header {
  uint8_t identifier[12];
  uint32_t vk_format, type_size, width, height, depth, layers, faces, levels, scheme;
  uint32_t dfd_offset, dfd_length, kvd_offset, kvd_length;
  uint64_t sgd_offset, sgd_length;
};
static_assert(sizeof(Header) == 80);
struct LevelEntry {
  uint64_t offset, length, uncompressed;
};
// Khronos Data Format Specification 1.3, sections 5.1 to 5.12.
struct Sample {
  uint16_t bit_offset;
  uint8_t bit_length;
  uint8_t channel_and_qualifiers;
  uint32_t position;
  uint32_t lower, upper;
};
struct BasicBlock {
  uint32_t total_size;
  uint32_t vendor_and_type;
  uint16_t version, block_size;
  uint8_t model, primaries, transfer, flags;
  uint8_t block_dimensions[4];
  uint8_t plane_bytes[8];
};
static_assert(sizeof(BasicBlock) == 28 && sizeof(Sample) == 16);

template <class T>
T Take(const std::string& file, uint64_t offset) {
  T value{};
  EXPECT_LE(offset + sizeof value, file.size());
  memcpy(&value, file.data() + offset, sizeof value);
  return value;
}

struct Expected {
  TexelFormat format;
  uint32_t vk_format, type_size;
  std::vector<std::array<uint32_t, 5>> samples;  // offset, bits - 1, channel, lower, upper
  uint8_t transfer;
};

std::vector<Expected> Formats() {
  constexpr uint32_t kMinusOne = 0xbf800000, kOne = 0x3f800000;  // as floats
  // Qualifiers: 0x10 linear, 0x40 signed, 0x80 float. Channels: 0 red, 1 green, 2 blue, 15 alpha.
  std::vector<Expected> all = {
      {TexelFormat::kRgba8, 37, 1, {}, 1},  {TexelFormat::kSrgb8Alpha8, 43, 1, {}, 2},
      {TexelFormat::kRgba16, 91, 2, {}, 1}, {TexelFormat::kRgba32F, 109, 4, {}, 1},
      {TexelFormat::kR16F, 76, 2, {}, 1},   {TexelFormat::kR32F, 100, 4, {}, 1},
      {TexelFormat::kRgba16F, 97, 2, {}, 1}};
  const uint32_t channels[4] = {0, 1, 2, 15};
  for (uint32_t i = 0; i < 4; ++i) {
    all[0].samples.push_back({8 * i, 7, channels[i], 0, 255});
    all[1].samples.push_back({8 * i, 7, i == 3 ? 0x1fu : i, 0, 255});
    all[2].samples.push_back({16 * i, 15, channels[i], 0, 65535});
    all[3].samples.push_back({32 * i, 31, channels[i] | 0xc0, kMinusOne, kOne});
    all[6].samples.push_back({16 * i, 15, channels[i] | 0xc0, kMinusOne, kOne});
  }
  all[4].samples.push_back({0, 15, 0xc0, kMinusOne, kOne});
  all[5].samples.push_back({0, 31, 0xc0, kMinusOne, kOne});
  return all;
}

enum class Shape { kFlat, kArray, kVolume };

TextureData RandomTexture(TexelFormat format, Shape shape, uint32_t width, uint32_t height,
                          uint32_t planes, size_t levels) {
  TextureData data;
  data.format = format;
  data.is_3d = shape == Shape::kVolume;
  data.is_array = shape == Shape::kArray;
  data.layers = data.is_array ? planes : 1;
  std::mt19937 random(static_cast<uint32_t>(format) * 100 + static_cast<uint32_t>(shape));
  for (size_t i = 0; i < levels; ++i) {
    TexelLevel& level = data.levels.emplace_back();
    level.width = std::max(width >> i, 1u);
    level.height = std::max(height >> i, 1u);
    level.depth = data.is_3d ? std::max(planes >> i, 1u) : 1;
    level.bytes.resize(size_t{level.width} * level.height * level.depth * data.layers *
                       TexelBytes(format));
    for (uint8_t& byte : level.bytes) byte = static_cast<uint8_t>(random());
  }
  return data;
}

std::map<std::string, std::string> PairsOf(const std::string& file, const Header& header) {
  std::map<std::string, std::string> pairs;
  std::string last;
  uint64_t at = header.kvd_offset;
  while (at < header.kvd_offset + header.kvd_length) {
    const auto length = Take<uint32_t>(file, at);
    const std::string pair = file.substr(at + 4, length);
    const std::string key = pair.c_str();
    EXPECT_LT(last, key);  // sorted, none twice
    last = key;
    pairs[key] = pair.substr(key.size() + 1);
    at += 4 + (length + 3) / 4 * 4;
  }
  EXPECT_EQ(at, header.kvd_offset + header.kvd_length);
  return pairs;
}

void CheckDescriptor(const std::string& file, const Header& header, const Expected& expected) {
  const auto block = Take<BasicBlock>(file, header.dfd_offset);
  EXPECT_EQ(block.total_size, header.dfd_length);
  EXPECT_EQ(block.vendor_and_type, 0u);
  EXPECT_EQ(block.version, 2);
  EXPECT_EQ(block.block_size, 24 + 16 * expected.samples.size());
  EXPECT_EQ(block.total_size, block.block_size + 4u);
  EXPECT_EQ(block.model, 1);      // RGBSDA
  EXPECT_EQ(block.primaries, 1);  // BT.709
  EXPECT_EQ(block.transfer, expected.transfer);
  EXPECT_EQ(block.flags, 0);  // straight alpha
  for (uint8_t dimension : block.block_dimensions) EXPECT_EQ(dimension, 0);
  EXPECT_EQ(block.plane_bytes[0], expected.type_size * expected.samples.size());
  for (size_t i = 1; i < 8; ++i) EXPECT_EQ(block.plane_bytes[i], 0);
  for (size_t i = 0; i < expected.samples.size(); ++i) {
    const auto sample = Take<Sample>(file, header.dfd_offset + sizeof(BasicBlock) + 16 * i);
    EXPECT_EQ(sample.bit_offset, expected.samples[i][0]);
    EXPECT_EQ(sample.bit_length, expected.samples[i][1]);
    EXPECT_EQ(sample.channel_and_qualifiers, expected.samples[i][2]);
    EXPECT_EQ(sample.position, 0u);
    EXPECT_EQ(sample.lower, expected.samples[i][3]);
    EXPECT_EQ(sample.upper, expected.samples[i][4]);
  }
}

void CheckFile(const std::string& file, const TextureData& data, const Expected& expected) {
  const auto header = Take<Header>(file, 0);
  const uint8_t identifier[12] = {0xab, 'K', 'T', 'X', ' ', '2', '0', 0xbb, '\r', '\n', 0x1a, '\n'};
  EXPECT_EQ(memcmp(header.identifier, identifier, 12), 0);
  EXPECT_EQ(header.vk_format, expected.vk_format);
  EXPECT_EQ(header.type_size, expected.type_size);
  EXPECT_EQ(header.width, data.levels[0].width);
  EXPECT_EQ(header.height, data.levels[0].height);
  EXPECT_EQ(header.depth, data.is_3d ? data.levels[0].depth : 0);
  EXPECT_EQ(header.layers, data.is_array ? data.layers : 0);
  EXPECT_EQ(header.faces, 1u);
  EXPECT_EQ(header.levels, data.levels.size());
  EXPECT_EQ(header.scheme, 0u);
  EXPECT_EQ(header.sgd_offset, 0u);
  EXPECT_EQ(header.sgd_length, 0u);
  EXPECT_EQ(header.dfd_offset, 80 + 24 * data.levels.size());
  EXPECT_EQ(header.kvd_offset, header.dfd_offset + header.dfd_length);
  CheckDescriptor(file, header, expected);
  const auto pairs = PairsOf(file, header);
  EXPECT_EQ(pairs.at("KTXorientation"), std::string(data.is_3d ? "ruo" : "ru") + '\0');
  EXPECT_EQ(pairs.at("KTXwriter"), std::string("texgraph") + '\0');
  // The smallest level first, each at the next multiple of lcm(texel size, 4), zeros between.
  const uint64_t alignment =
      std::lcm(expected.type_size * static_cast<uint32_t>(expected.samples.size()), 4u);
  uint64_t end = header.kvd_offset + header.kvd_length;
  for (size_t i = data.levels.size(); i-- > 0;) {
    const auto entry = Take<LevelEntry>(file, 80 + 24 * i);
    EXPECT_EQ(entry.offset % alignment, 0u);
    ASSERT_GE(entry.offset, end);
    ASSERT_LT(entry.offset - end, alignment);
    for (; end < entry.offset; ++end) EXPECT_EQ(file[end], 0);
    EXPECT_EQ(entry.length, data.levels[i].bytes.size());
    EXPECT_EQ(entry.uncompressed, entry.length);
    ASSERT_LE(entry.offset + entry.length, file.size());
    EXPECT_EQ(memcmp(file.data() + entry.offset, data.levels[i].bytes.data(), entry.length), 0);
    end = entry.offset + entry.length;
  }
  EXPECT_EQ(end, file.size());
}

void ExpectSame(const TextureData& a, const TextureData& b) {
  EXPECT_EQ(a.format, b.format);
  EXPECT_EQ(a.layers, b.layers);
  EXPECT_EQ(a.is_array, b.is_array);
  EXPECT_EQ(a.is_3d, b.is_3d);
  ASSERT_EQ(a.levels.size(), b.levels.size());
  for (size_t i = 0; i < a.levels.size(); ++i) {
    EXPECT_EQ(a.levels[i].width, b.levels[i].width);
    EXPECT_EQ(a.levels[i].height, b.levels[i].height);
    EXPECT_EQ(a.levels[i].depth, b.levels[i].depth);
    EXPECT_EQ(a.levels[i].bytes, b.levels[i].bytes);
  }
}

TEST(Ktx2Test, EveryFormatAndShapeIsAsSpecifiedAndComesBack) {
  for (const Expected& expected : Formats()) {
    for (Shape shape : {Shape::kFlat, Shape::kArray, Shape::kVolume}) {
      for (size_t levels : {1u, 3u, 4u}) {
        const TextureData data = RandomTexture(expected.format, shape, 13, 6, 5, levels);
        const std::string file = EncodeKtx2(data);
        CheckFile(file, data, expected);
        Diagnostics diagnostics;
        const auto back = DecodeKtx2(file, "t", {}, diagnostics);
        ASSERT_TRUE(back) << diagnostics.all().front().message;
        ExpectSame(*back, data);
        EXPECT_EQ(back->sampler.mip_filter,
                  levels == 1 ? ir::MipFilter::kNone : ir::MipFilter::kLinear);
      }
    }
  }
}

TEST(Ktx2Test, AnArrayOfOneLayerIsAnArray) {
  const TextureData data = RandomTexture(TexelFormat::kRgba8, Shape::kArray, 2, 2, 1, 2);
  Diagnostics diagnostics;
  const auto back = DecodeKtx2(EncodeKtx2(data), "t", {}, diagnostics);
  ASSERT_TRUE(back);
  EXPECT_TRUE(back->is_array);
}

// Replaces the value of KTXorientation: "ru" stands at one place in the file.
std::string WithOrientation(std::string file, std::string_view orientation) {
  const size_t at = file.find("KTXorientation") + 15;
  file.replace(at, orientation.size(), orientation);
  return file;
}

TEST(Ktx2Test, RowsThatGoDownAreTurned) {
  for (Shape shape : {Shape::kFlat, Shape::kArray, Shape::kVolume}) {
    const TextureData data = RandomTexture(TexelFormat::kR16F, shape, 4, 7, 2, 3);
    const std::string file = EncodeKtx2(data);
    Diagnostics diagnostics;
    const auto turned = DecodeKtx2(WithOrientation(file, "rd"), "t", {}, diagnostics);
    ASSERT_TRUE(turned);
    for (size_t i = 0; i < data.levels.size(); ++i) {
      const TexelLevel& level = data.levels[i];
      for (size_t plane = 0; plane < level.depth * data.layers; ++plane) {
        for (size_t y = 0; y < level.height; ++y) {
          for (size_t x = 0; x < level.width * 2; ++x) {
            const size_t row = plane * level.height + y;
            const size_t other = plane * level.height + level.height - 1 - y;
            ASSERT_EQ(turned->levels[i].bytes[row * level.width * 2 + x],
                      level.bytes[other * level.width * 2 + x]);
          }
        }
      }
    }
    EXPECT_FALSE(DecodeKtx2(WithOrientation(file, "lu"), "t", {}, diagnostics));
    EXPECT_FALSE(DecodeKtx2(WithOrientation(file, "rx"), "t", {}, diagnostics));
  }
  // Without the key rows go down, too: the specification's default.
  const TextureData data = RandomTexture(TexelFormat::kRgba8, Shape::kFlat, 2, 2, 1, 1);
  std::string file = EncodeKtx2(data);
  file.replace(file.find("KTXorientation"), 3, "Xtr");
  Diagnostics diagnostics;
  const auto turned = DecodeKtx2(file, "t", {}, diagnostics);
  ASSERT_TRUE(turned);
  EXPECT_EQ(memcmp(turned->levels[0].bytes.data(), data.levels[0].bytes.data() + 8, 8), 0);
}

std::string Reason(std::string file, DiagnosticKind kind = DiagnosticKind::kBadImage) {
  Diagnostics diagnostics;
  EXPECT_FALSE(DecodeKtx2(file, "t", {}, diagnostics));
  EXPECT_EQ(diagnostics.all().size(), 1u);
  if (diagnostics.all().size() != 1) return "";
  EXPECT_EQ(diagnostics.all()[0].kind, kind);
  const std::string& message = diagnostics.all()[0].message;
  const std::string start = "cannot use texture 't': ";
  EXPECT_EQ(message.substr(0, start.size()), start);
  return message.substr(start.size());
}

// The file with a number of its header replaced.
std::string With(std::string file, size_t offset, uint32_t value) {
  memcpy(&file[offset], &value, 4);
  return file;
}

TEST(Ktx2Test, SaysWhatItDoesNotRead) {
  const std::string file =
      EncodeKtx2(RandomTexture(TexelFormat::kRgba8, Shape::kFlat, 16, 8, 1, 3));
  const size_t descriptor = 80 + 3 * 24;
  EXPECT_EQ(Reason(""), "it is not a KTX 2.0 file");
  EXPECT_EQ(Reason(With(file, 4, 0x31312031)), "it is not a KTX 2.0 file");
  EXPECT_EQ(Reason(file.substr(0, 79)), "it ends in its header");
  EXPECT_EQ(Reason(With(file, 12, 131)),
            "its format, number 131 of Vulkan's, is not one that texgraph reads");
  EXPECT_EQ(Reason(With(file, 16, 4)), "its type size is wrong");
  EXPECT_EQ(Reason(With(file, 24, 0)), "it has no pixels, or only one axis");
  EXPECT_EQ(Reason(With(With(file, 28, 2), 32, 2)), "it is an array of 3D textures");
  EXPECT_EQ(Reason(With(file, 36, 6)), "it is not flat: cube maps are not read");
  EXPECT_EQ(Reason(With(file, 40, 6)), "it has 6 levels, more than its size allows");
  EXPECT_EQ(Reason(With(file, 44, 2)), "it is compressed");
  EXPECT_EQ(Reason(With(file, 48, 0xfffffff0)), "its data format descriptor is damaged");
  EXPECT_EQ(Reason(With(file, 52, 24)), "its data format descriptor is damaged");
  EXPECT_EQ(Reason(With(file, descriptor + 4, 1)), "its data format descriptor is not a basic one");
  EXPECT_EQ(Reason(With(file, descriptor + 12, 0x01010101)), "its colours are multiplied by alpha");
  EXPECT_EQ(Reason(With(file, descriptor + 12, 0x00020101)),
            "its data format descriptor and its format differ in their transfer function");
  EXPECT_EQ(Reason(With(file, 60, 0xffffffff)), "its key/value data are outside of the file");
  EXPECT_EQ(Reason(With(file, Take<Header>(file, 0).kvd_offset, 0xffffffff)),
            "its key/value data are damaged");
  EXPECT_EQ(Reason(With(file, 80, 0xfffffff0)), "level 0 is damaged or outside of the file");
  EXPECT_EQ(Reason(With(file, 80 + 24 + 8, 1)), "level 1 is damaged or outside of the file");
  // Offsets whose sum with the length is beyond 64 bits.
  EXPECT_EQ(Reason(With(With(file, 80, 0xffffffff), 84, 0xffffffff)),
            "level 0 is damaged or outside of the file");
}

TEST(Ktx2Test, LargeSizesAreALimitBeforeAnythingIsAllocated) {
  const std::string file =
      EncodeKtx2(RandomTexture(TexelFormat::kRgba8, Shape::kFlat, 16, 8, 1, 1));
  EXPECT_EQ(Reason(With(With(file, 20, 0xffffffff), 24, 0xffffffff), DiagnosticKind::kSizeLimit),
            "it has 4294967295 x 4294967295 x 1 pixels; the limit is 67108864 in all");
  EXPECT_EQ(Reason(With(file, 32, 0xffffffff), DiagnosticKind::kSizeLimit),
            "it has 16 x 8 x 4294967295 pixels; the limit is 67108864 in all");
  EXPECT_EQ(Reason(With(file, 28, 1u << 20), DiagnosticKind::kSizeLimit),
            "it has 16 x 8 x 1048576 pixels; the limit is 67108864 in all");
  EXPECT_EQ(Reason(With(With(file, 20, 1u << 13), 24, 1u << 13)),
            "level 0 is damaged or outside of the file");
}

// What was read despite the damage has all its bytes; what was not is one diagnostic.
void ExpectSane(const std::string& file) {
  Diagnostics diagnostics;
  const auto data = DecodeKtx2(file, "t", {}, diagnostics);
  if (!data) {
    ASSERT_EQ(diagnostics.all().size(), 1u);
    ASSERT_TRUE(diagnostics.all()[0].kind == DiagnosticKind::kBadImage ||
                diagnostics.all()[0].kind == DiagnosticKind::kSizeLimit);
    return;
  }
  ASSERT_FALSE(diagnostics.HasErrors());
  ASSERT_FALSE(data->levels.empty());
  for (const TexelLevel& level : data->levels) {
    ASSERT_EQ(level.bytes.size(), size_t{level.width} * level.height * level.depth * data->layers *
                                      TexelBytes(data->format));
  }
}

TEST(Ktx2Test, EveryTruncationIsADiagnostic) {
  for (Shape shape : {Shape::kFlat, Shape::kArray, Shape::kVolume}) {
    const std::string file = EncodeKtx2(RandomTexture(TexelFormat::kR16F, shape, 5, 6, 3, 3));
    for (size_t length = 0; length < file.size(); ++length) {
      const std::string part = file.substr(0, length);  // with an end of its own, for sanitizers
      Reason(part);
    }
  }
}

TEST(Ktx2Test, FlippedBitsAreNoDisaster) {
  for (Shape shape : {Shape::kFlat, Shape::kArray, Shape::kVolume}) {
    const std::string file =
        EncodeKtx2(RandomTexture(TexelFormat::kSrgb8Alpha8, shape, 8, 6, 3, 3));
    for (size_t bit = 0; bit < 8 * file.size(); ++bit) {
      std::string damaged = file;
      damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << bit % 8));
      ExpectSane(damaged);
    }
    std::mt19937 random(3);
    for (int i = 0; i < 20000; ++i) {  // several numbers of the header and the index at once
      std::string damaged = file;
      for (uint32_t k = static_cast<uint32_t>(random()) % 4 + 1; k > 0; --k) {
        const uint32_t values[] = {
            0, 1, 2, 3, 0x7fffffff, 0xffffffff, 0x10000, static_cast<uint32_t>(random())};
        damaged = With(damaged, 12 + static_cast<size_t>(random()) % 70 * 4,
                       values[static_cast<size_t>(random()) % 8]);
      }
      ExpectSane(damaged);
    }
  }
}

TEST(Ktx2FileTest, IsReadFromDisk) {
  const ScratchFolder folder;
  const TextureData data = RandomTexture(TexelFormat::kRgba16, Shape::kFlat, 300, 200, 1, 9);
  const std::string path = folder / "a.ktx2";
  folder.Write("a.ktx2", EncodeKtx2(data));
  Diagnostics diagnostics;
  const auto back = ReadKtx2(path, {}, diagnostics);
  ASSERT_TRUE(back);
  ExpectSame(*back, data);
  EXPECT_FALSE(ReadKtx2(folder / "b.ktx2", {}, diagnostics));
  EXPECT_EQ(diagnostics.all().back().kind, DiagnosticKind::kMissingFile);
  EXPECT_FALSE(ReadKtx2(folder.path(), {}, diagnostics));
  EXPECT_EQ(diagnostics.all().back().kind, DiagnosticKind::kCannotRead);
  EXPECT_FALSE(ReadKtx2(path, {}, diagnostics, Roots({"/usr"}, diagnostics)));
  EXPECT_EQ(diagnostics.all().back().kind, DiagnosticKind::kOutsideRoot);
}

}  // namespace
}  // namespace texgraph::textures
