// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <string.h>

#include <new>

#include "compiler/textures/codec.h"
#include "compiler/textures/ktx2.h"
#include "compiler/textures/ktx2_layout.h"
#include "compiler/textures/texel_chain.h"

namespace texgraph::textures {
namespace {

constexpr uint32_t kFlagPremultiplied = 1;
constexpr size_t kLeastDescriptorBytes = 28;  // the total size, and a basic block without samples

// Reads a file whose every number may be a lie: nothing is used before it is checked.
class Ktx2Reader {
 public:
  explicit Ktx2Reader(std::string_view bytes) : bytes_(bytes) {}

  // False with a reason in `why`, and `kind` if that is another than kBadImage.
  bool Read(TextureData& data) {
    return ReadHeader(data) && ReadDescriptor(data) && ReadPairs(data) && ReadLevels(data);
  }

  std::string why;
  DiagnosticKind kind = DiagnosticKind::kBadImage;

 private:
  struct Section {
    uint64_t offset;
    uint64_t length;
  };

  // Only for places that were checked.
  uint64_t Number(uint64_t offset, int count) const {
    uint64_t value = 0;
    for (int i = count; i-- > 0;)
      value = value << 8 | static_cast<uint8_t>(bytes_[static_cast<size_t>(offset) + i]);
    return value;
  }
  uint32_t Get32(uint64_t offset) const { return static_cast<uint32_t>(Number(offset, 4)); }

  bool Fail(std::string reason) {
    why = std::move(reason);
    return false;
  }
  bool IsInside(const Section& section) const {
    return section.offset <= bytes_.size() && section.length <= bytes_.size() - section.offset;
  }

  bool ReadHeader(TextureData& data) {
    if (bytes_.substr(0, ktx2::kIdentifier.size()) != ktx2::kIdentifier) {
      return Fail("it is not a KTX 2.0 file");
    }
    if (bytes_.size() < ktx2::kHeaderBytes) return Fail("it ends in its header");
    const uint32_t vulkan = Get32(12);
    const auto format = std::ranges::find(ktx2::kFormats, vulkan, &ktx2::Format::vulkan);
    if (format == ktx2::kFormats.end()) {
      return Fail(
          fmt::format("its format, number {} of Vulkan's, is not one that texgraph reads", vulkan));
    }
    format_ = &*format;
    if (Get32(44) != 0) return Fail("it is compressed");
    if (Get32(36) != 1) return Fail("it is not flat: cube maps are not read");
    if (Get32(16) != ktx2::ChannelBytes(*format_)) return Fail("its type size is wrong");
    return ReadSize(data);
  }

  bool ReadSize(TextureData& data) {
    width_ = Get32(20);
    height_ = Get32(24);
    const uint32_t depth = Get32(28);
    const uint32_t layers = Get32(32);
    if (width_ == 0 || height_ == 0) return Fail("it has no pixels, or only one axis");
    if (depth > 0 && layers > 0) return Fail("it is an array of 3D textures");
    data.format = format_->format;
    data.is_3d = depth > 0;
    data.is_array = layers > 0;
    data.layers = std::max(layers, 1u);
    depth_ = std::max(depth, 1u);
    uint64_t pixels = uint64_t{width_} * height_;  // at most 2^64 - 2^33 + 1
    const uint64_t planes = std::max(depth_, data.layers);
    if (pixels > kMaxImagePixels || planes > kMaxImagePixels / pixels) {
      kind = DiagnosticKind::kSizeLimit;
      return Fail(fmt::format("it has {} x {} x {} pixels; the limit is {} in all", width_, height_,
                              planes, kMaxImagePixels));
    }
    level_count_ = std::max(Get32(40), 1u);
    if (level_count_ > static_cast<uint32_t>(std::bit_width(std::max({width_, height_, depth_})))) {
      return Fail(fmt::format("it has {} levels, more than its size allows", level_count_));
    }
    if (bytes_.size() < ktx2::kHeaderBytes + ktx2::kLevelIndexBytes * level_count_) {
      return Fail("it ends in the index of its levels");
    }
    return true;
  }

  // The format is known already; here it is only told whether colours are multiplied by alpha.
  bool ReadDescriptor(const TextureData& data) {
    const Section section{Get32(48), Get32(52)};
    if (!IsInside(section) || section.length < kLeastDescriptorBytes ||
        Get32(section.offset) != section.length) {
      return Fail("its data format descriptor is damaged");
    }
    if (Get32(section.offset + 4) != 0)
      return Fail("its data format descriptor is not a basic one");
    const uint32_t model = Get32(section.offset + 12);
    if ((model >> 24 & kFlagPremultiplied) != 0) {
      return Fail("its colours are multiplied by alpha");
    }
    const bool srgb = (model >> 16 & 255) == 2;
    if (srgb != (data.format == TexelFormat::kSrgb8Alpha8)) {
      return Fail("its data format descriptor and its format differ in their transfer function");
    }
    return true;
  }

  bool ReadPairs(const TextureData& data) {
    const Section section{Get32(56), Get32(60)};
    if (!IsInside(section)) return Fail("its key/value data are outside of the file");
    const uint64_t end = section.offset + section.length;
    for (uint64_t at = section.offset; at < end;) {
      if (end - at < 4) return Fail("its key/value data are damaged");
      const uint64_t length = Get32(at);
      at += 4;
      if (length < 2 || length > end - at) return Fail("its key/value data are damaged");
      const std::string_view pair = bytes_.substr(static_cast<size_t>(at), length);
      const size_t zero = pair.find('\0');
      if (zero == std::string_view::npos) return Fail("a key of its key/value data has no end");
      if (pair.substr(0, zero) == ktx2::kOrientation &&
          !ReadOrientation(data, pair.substr(zero + 1))) {
        return false;
      }
      at += (length + 3) / 4 * 4;  // at most 3 beyond the end, which ends the loop
    }
    return true;
  }

  bool ReadOrientation(const TextureData& data, std::string_view value) {
    if (!value.empty() && value.back() == '\0') value.remove_suffix(1);
    if (value.size() != (data.is_3d ? 3u : 2u) || value[0] != 'r' ||
        (value[1] != 'u' && value[1] != 'd')) {
      return Fail("its pictures are mirrored, or their orientation is not known");
    }
    rows_go_down_ = value[1] == 'd';
    return true;
  }

  bool ReadLevels(TextureData& data) {
    const uint32_t size = TexelBytes(data.format);
    for (uint32_t i = 0; i < level_count_; ++i) {
      const uint64_t entry = ktx2::kHeaderBytes + ktx2::kLevelIndexBytes * i;
      const Section section{Number(entry, 8), Number(entry + 8, 8)};
      TexelLevel& level = data.levels.emplace_back();
      level.width = std::max(width_ >> i, 1u);
      level.height = std::max(height_ >> i, 1u);
      level.depth = std::max(depth_ >> i, 1u);
      const uint64_t rows = uint64_t{level.height} * level.depth * data.layers;
      if (section.length != rows * level.width * size || !IsInside(section)) {
        return Fail(fmt::format("level {} is damaged or outside of the file", i));
      }
      CopyLevel(section, data.layers * level.depth, size, level);
    }
    data.sampler.wrap_w = data.is_3d ? ir::Wrap::kRepeat : ir::Wrap::kClamp;
    if (level_count_ == 1) data.sampler.mip_filter = ir::MipFilter::kNone;
    return true;
  }

  void CopyLevel(const Section& section, uint32_t planes, uint32_t size, TexelLevel& level) const {
    const char* from = bytes_.data() + section.offset;
    level.bytes.assign(from, from + section.length);
    ktx2::SwapOnBigEndian(level.bytes.data(), level.bytes.size(), ktx2::ChannelBytes(*format_));
    if (!rows_go_down_) return;
    const size_t row = size_t{level.width} * size;
    for (uint32_t plane = 0; plane < planes; ++plane) {
      uint8_t* low = level.bytes.data() + row * level.height * plane;
      uint8_t* high = low + row * (level.height - 1);
      for (; low < high; low += row, high -= row) std::swap_ranges(low, low + row, high);
    }
  }

  std::string_view bytes_;
  const ktx2::Format* format_ = nullptr;
  uint32_t width_ = 0, height_ = 0, depth_ = 0, level_count_ = 0;
  bool rows_go_down_ = true;  // the default of the format
};

std::optional<std::string> ReadAll(FILE* file) {
  std::string bytes;
  char part[65536];
  for (size_t count; (count = fread(part, 1, sizeof part, file)) > 0;) {
    if (bytes.size() > kMaxImageFileBytes) return std::nullopt;  // it grew since it was opened
    bytes.append(part, count);
  }
  if (ferror(file)) return std::nullopt;
  return bytes;
}

}  // namespace

std::optional<TextureData> DecodeKtx2(std::string_view bytes, std::string_view name,
                                      SourceRange range, Diagnostics& diagnostics) {
  try {
    Ktx2Reader reader(bytes);
    TextureData data;
    if (reader.Read(data)) return data;
    diagnostics.Error(reader.kind, range,
                      fmt::format("cannot use texture '{}': {}", Printable(name), reader.why));
  } catch (const std::bad_alloc&) {
    ReportNoMemory(name, range, diagnostics);
  }
  return std::nullopt;
}

std::optional<TextureData> ReadKtx2(const std::string& path, SourceRange range,
                                    Diagnostics& diagnostics, const Roots& roots) {
  const File file = OpenImage(path, range, roots, diagnostics);
  if (!file) return std::nullopt;
  try {
    const std::optional<std::string> bytes = ReadAll(file.get());
    if (bytes) return DecodeKtx2(*bytes, path, range, diagnostics);
    diagnostics.Error(DiagnosticKind::kCannotRead, range,
                      fmt::format("cannot read image '{}'", Printable(path)));
  } catch (const std::bad_alloc&) {
    ReportNoMemory(path, range, diagnostics);
  }
  return std::nullopt;
}

}  // namespace texgraph::textures
