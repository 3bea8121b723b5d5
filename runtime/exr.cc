// SPDX-License-Identifier: Apache-2.0
#include "runtime/exr.h"

// Rounding needs no table; the table that Imath has is for the way back.
#define IMATH_HALF_NO_LOOKUP_TABLE
#include <Imath/half.h>
#include <OpenEXR/openexr.h>
#include <string.h>

#include <algorithm>
#include <new>
#include <string_view>
#include <vector>

namespace texgraph::runtime {
namespace {

// What the library's C functions write to, at any offset.
int64_t OnWrite(exr_const_context_t, void* user_data, const void* data, uint64_t size,
                uint64_t offset, exr_stream_error_func_ptr_t) {
  auto& bytes = *static_cast<std::string*>(user_data);
  try {
    if (bytes.size() < offset + size) bytes.resize(offset + size);
  } catch (const std::bad_alloc&) {
    return -1;
  }
  memcpy(bytes.data() + offset, data, size);
  return static_cast<int64_t>(size);
}

void OnError(exr_const_context_t, exr_result_t, const char*) {}

struct Picture {
  std::span<const float> pixels;
  uint32_t width;
  uint32_t height;
  uint32_t channels;
  ExrDepth depth;

  int SampleBytes() const { return depth == ExrDepth::kHalf ? 2 : 4; }
  int PixelBytes() const { return static_cast<int>(channels) * SampleBytes(); }
  size_t RowBytes() const { return size_t{width} * static_cast<size_t>(PixelBytes()); }
};

// A file in the making; what is not finished is thrown away.
class Writer {
 public:
  Writer(const Picture& picture, std::string& bytes) : picture_(picture) {
    exr_context_initializer_t start = EXR_DEFAULT_CONTEXT_INITIALIZER;
    start.error_handler_fn = OnError;
    start.user_data = &bytes;
    start.write_fn = OnWrite;
    Check(exr_start_write(&context_, "picture", EXR_WRITE_FILE_DIRECTLY, &start));
  }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer() {
    if (is_encoding_) exr_encoding_destroy(context_, &pipeline_);
    if (context_ != nullptr) exr_finish(&context_);
  }

  bool WriteHeader() {
    int part = 0;
    Check(exr_add_part(context_, "", EXR_STORAGE_SCANLINE, &part));
    Check(exr_initialize_required_attr_simple(context_, 0, static_cast<int32_t>(picture_.width),
                                              static_cast<int32_t>(picture_.height),
                                              EXR_COMPRESSION_ZIP));
    static constexpr const char* kNames[] = {"R", "G", "B", "A"};
    const auto type = picture_.depth == ExrDepth::kHalf ? EXR_PIXEL_HALF : EXR_PIXEL_FLOAT;
    for (uint32_t c = 0; c < picture_.channels; ++c) {
      Check(exr_add_channel(context_, 0, picture_.channels == 1 ? "Y" : kNames[c], type,
                            EXR_PERCEPTUALLY_LOGARITHMIC, 1, 1));
    }
    Check(exr_write_header(context_));
    Check(exr_get_scanlines_per_chunk(context_, 0, &lines_));
    if (ok_) chunk_.resize(picture_.RowBytes() * static_cast<size_t>(lines_));
    return ok_;
  }

  bool WriteRows() {
    for (uint32_t y = 0; ok_ && y < picture_.height; y += static_cast<uint32_t>(lines_)) {
      const uint32_t end = std::min(picture_.height, y + static_cast<uint32_t>(lines_));
      for (uint32_t row = y; row < end; ++row)
        ConvertRow(row, chunk_.data() + (row - y) * picture_.RowBytes());
      EncodeChunk(y);
    }
    return ok_;
  }

  bool Finish() {
    if (is_encoding_) Check(exr_encoding_destroy(context_, &pipeline_));
    is_encoding_ = false;
    Check(exr_finish(&context_));
    context_ = nullptr;
    return ok_;
  }

 private:
  void Check(exr_result_t result) { ok_ = ok_ && result == EXR_ERR_SUCCESS; }

  // Row `y` from the top.
  void ConvertRow(uint32_t y, uint8_t* to) const {
    const float* from =
        picture_.pixels.data() + size_t{picture_.height - 1 - y} * picture_.width * 4;
    for (uint32_t x = 0; x < picture_.width; ++x, from += 4) {
      if (picture_.depth == ExrDepth::kFloat) {
        memcpy(to, from, static_cast<size_t>(picture_.PixelBytes()));
      } else {
        for (uint32_t c = 0; c < picture_.channels; ++c) {
          const imath_half_bits_t half = imath_float_to_half(from[c]);
          memcpy(to + 2 * c, &half, sizeof half);
        }
      }
      to += picture_.PixelBytes();
    }
  }

  void EncodeChunk(uint32_t y) {
    exr_chunk_info_t info;
    Check(exr_write_scanline_chunk_info(context_, 0, static_cast<int>(y), &info));
    if (!ok_) return;
    Check(is_encoding_ ? exr_encoding_update(context_, 0, &info, &pipeline_)
                       : exr_encoding_initialize(context_, 0, &info, &pipeline_));
    if (!ok_) return;
    for (int i = 0; i < pipeline_.channel_count; ++i) {
      exr_coding_channel_info_t& channel = pipeline_.channels[i];
      channel.user_pixel_stride = picture_.PixelBytes();
      channel.user_line_stride = static_cast<int32_t>(picture_.RowBytes());
      channel.encode_from_ptr =
          chunk_.data() + Index(channel.channel_name) * picture_.SampleBytes();
    }
    if (!is_encoding_) Check(exr_encoding_choose_default_routines(context_, 0, &pipeline_));
    is_encoding_ = true;
    if (ok_) Check(exr_encoding_run(context_, 0, &pipeline_));
  }

  // Files keep their channels in alphabetical order.
  static int Index(const char* name) {
    const std::string_view names = "RGBA";
    return name[0] == 'Y' ? 0 : static_cast<int>(names.find(name[0]));
  }

  const Picture& picture_;
  exr_context_t context_ = nullptr;
  exr_encode_pipeline_t pipeline_ = EXR_ENCODE_PIPELINE_INITIALIZER;
  bool is_encoding_ = false;
  bool ok_ = true;
  int32_t lines_ = 1;
  std::vector<uint8_t> chunk_;
};

}  // namespace

std::optional<std::string> EncodeExr(std::span<const float> pixels, uint32_t width, uint32_t height,
                                     uint32_t channels, ExrDepth depth) {
  if (channels < 1 || channels > 4 || width == 0 || height == 0) return std::nullopt;
  if (pixels.size() / 4 / width < height) return std::nullopt;
  std::string bytes;
  try {
    const Picture picture{pixels, width, height, channels, depth};
    Writer writer(picture, bytes);
    if (!writer.WriteHeader() || !writer.WriteRows() || !writer.Finish()) return std::nullopt;
  } catch (const std::bad_alloc&) {
    return std::nullopt;
  }
  return bytes;
}

}  // namespace texgraph::runtime
