// SPDX-License-Identifier: Apache-2.0
#include <string.h>

#include "compiler/textures/ktx2.h"
#include "compiler/textures/ktx2_layout.h"

namespace texgraph::textures {
namespace {

// Values of the Khronos Data Format Specification 1.3, chapters 4 and 5.
constexpr uint32_t kDescriptorVersion = 2;
constexpr uint32_t kModelRgbsda = 1;
constexpr uint32_t kPrimariesBt709 = 1;
constexpr uint32_t kTransferLinear = 1;
constexpr uint32_t kTransferSrgb = 2;
constexpr uint32_t kChannelAlpha = 15;
constexpr uint32_t kQualifierLinear = 1u << 28;
constexpr uint32_t kQualifierSigned = 1u << 30;
constexpr uint32_t kQualifierFloat = 1u << 31;

class Ktx2Writer {
 public:
  explicit Ktx2Writer(const TextureData& data)
      : data_(data), format_(ktx2::FormatOf(data.format)) {}

  std::string Write() {
    const size_t levels = data_.levels.size();
    const std::string descriptor = Descriptor();
    const std::string pairs = Pairs();
    const size_t descriptor_at = ktx2::kHeaderBytes + ktx2::kLevelIndexBytes * levels;
    const size_t pairs_at = descriptor_at + descriptor.size();
    Header();
    Put32(descriptor_at);
    Put32(descriptor.size());
    Put32(pairs_at);
    Put32(pairs.size());
    Put64(0);  // nothing is compressed
    Put64(0);
    std::vector<uint64_t> offsets(levels);
    uint64_t end = pairs_at + pairs.size();
    for (size_t i = levels; i-- > 0;) {  // the smallest first
      offsets[i] = ktx2::AlignUp(end, format_);
      end = offsets[i] + data_.levels[i].bytes.size();
    }
    out_.reserve(end);
    for (size_t i = 0; i < levels; ++i) {
      Put64(offsets[i]);
      Put64(data_.levels[i].bytes.size());
      Put64(data_.levels[i].bytes.size());
    }
    out_ += descriptor;
    out_ += pairs;
    for (size_t i = levels; i-- > 0;) {
      out_.resize(offsets[i]);
      const std::vector<uint8_t>& bytes = data_.levels[i].bytes;
      out_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
      ktx2::SwapOnBigEndian(reinterpret_cast<uint8_t*>(out_.data()) + offsets[i], bytes.size(),
                            ktx2::ChannelBytes(format_));
    }
    return std::move(out_);
  }

 private:
  static void Append(std::string& to, uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) to += static_cast<char>(value >> (8 * i) & 255);
  }
  void Put32(uint64_t value) { Append(out_, value, 4); }
  void Put64(uint64_t value) { Append(out_, value, 8); }

  void Header() {
    const TexelLevel& base = data_.levels[0];
    out_ = ktx2::kIdentifier;
    Put32(format_.vulkan);
    Put32(ktx2::ChannelBytes(format_));
    Put32(base.width);
    Put32(base.height);
    Put32(data_.is_3d ? base.depth : 0);
    Put32(data_.is_array ? data_.layers : 0);
    Put32(1);  // faces
    Put32(data_.levels.size());
    Put32(0);  // no supercompression
  }

  // One basic block, with a sample for each channel.
  std::string Descriptor() const {
    const bool srgb = data_.format == TexelFormat::kSrgb8Alpha8;
    const uint32_t block_bytes = 24 + 16 * format_.channels;
    const uint32_t transfer = srgb ? kTransferSrgb : kTransferLinear;
    std::string out;
    Append(out, block_bytes + 4, 4);
    Append(out, 0, 4);  // Khronos, basic format
    Append(out, kDescriptorVersion | block_bytes << 16, 4);
    Append(out, kModelRgbsda | kPrimariesBt709 << 8 | transfer << 16, 4);  // straight alpha
    Append(out, 0, 4);                                                     // a block is one texel
    Append(out, TexelBytes(data_.format), 8);
    const uint32_t bits = 8 * ktx2::ChannelBytes(format_);
    for (uint32_t i = 0; i < format_.channels; ++i) {
      uint32_t sample = bits * i | (bits - 1) << 16 | (i == 3 ? kChannelAlpha : i) << 24;
      if (format_.is_float) sample |= kQualifierSigned | kQualifierFloat;
      if (srgb && i == 3) sample |= kQualifierLinear;
      Append(out, sample, 4);
      Append(out, 0, 4);                                   // its position in the block
      Append(out, format_.is_float ? 0xbf800000u : 0, 4);  // -1.0
      Append(out, format_.is_float ? 0x3f800000u : (1u << bits) - 1, 4);
    }
    return out;
  }

  // Sorted by key, each padded to 4 bytes.
  std::string Pairs() const {
    std::string out;
    Pair(ktx2::kOrientation, data_.is_3d ? "ruo" : "ru", out);
    Pair("KTXwriter", "texgraph", out);
    return out;
  }
  static void Pair(std::string_view key, std::string_view value, std::string& out) {
    Append(out, key.size() + value.size() + 2, 4);
    out += key;
    out += '\0';
    out += value;
    out += '\0';
    while (out.size() % 4 != 0) out += '\0';
  }

  const TextureData& data_;
  const ktx2::Format& format_;
  std::string out_;
};

}  // namespace

std::string EncodeKtx2(const TextureData& data) { return Ktx2Writer(data).Write(); }

}  // namespace texgraph::textures
