// SPDX-License-Identifier: Apache-2.0
#include <png.h>
#include <setjmp.h>
#include <string.h>

#include <bit>
#include <new>
#include <vector>

#include "compiler/textures/codec.h"

namespace texgraph::textures {
namespace {

// What the library's C functions need; it outlives every longjmp.
struct Reader {
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::vector<png_bytep> rows;
  CodecError* error = nullptr;
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

[[noreturn]] void OnError(png_structp png, png_const_charp text) {
  auto* error = static_cast<CodecError*>(png_get_error_ptr(png));
  if (error->text[0] == '\0') {
    // A read past the end is libpng's "Read Error"; say what it means.
    const bool truncated = strcmp(text, "Read Error") == 0;
    snprintf(error->text, sizeof error->text, "%s", truncated ? "the file is truncated" : text);
  }
  png_longjmp(png, 1);
}

void OnWarning(png_structp, png_const_charp) {}

bool Create(Reader& reader) {
  reader.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, reader.error, OnError, OnWarning);
  if (reader.png) reader.info = png_create_info_struct(reader.png);
  if (reader.info) return true;
  reader.error->kind = DiagnosticKind::kOutOfMemory;
  snprintf(reader.error->text, sizeof reader.error->text, "there is not enough memory to read it");
  return false;
}

bool ReadHeader(Reader& reader, FILE* file, ImageInfo& image) {
  png_structp png = reader.png;
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_init_io(png, file);
  // The size is judged by PreparePixels, before libpng allocates rows; texts and profiles, which
  // may inflate to gigabytes, are never unpacked; a wrong checksum is an error also in a chunk that
  // is skipped.
  png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
  png_set_chunk_cache_max(png, 16);
  png_set_chunk_malloc_max(png, 1 << 20);
  png_set_crc_action(png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
  png_read_info(png, reader.info);
  const png_byte color = png_get_color_type(png, reader.info);
  const bool keyed = png_get_valid(png, reader.info, PNG_INFO_tRNS) != 0;
  image.width = png_get_image_width(png, reader.info);
  image.height = png_get_image_height(png, reader.info);
  image.bits = png_get_bit_depth(png, reader.info) == 16 ? 16 : 8;
  const bool colored = (color & PNG_COLOR_MASK_COLOR) != 0;
  const bool alpha = (color & PNG_COLOR_MASK_ALPHA) != 0 || keyed;
  image.channels = static_cast<uint8_t>((colored ? 3 : 1) + (alpha ? 1 : 0));
  return true;
}

bool ReadPixels(Reader& reader, const Image& image) {
  png_structp png = reader.png;
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_expand(png);  // palettes, 1, 2 and 4 bits, and a transparent colour
  if (image.bits == 16 && std::endian::native == std::endian::little) png_set_swap(png);
  png_set_interlace_handling(png);
  png_read_update_info(png, reader.info);
  if (png_get_rowbytes(png, reader.info) != image.RowBytes()) png_error(png, "unexpected row size");
  png_read_image(png, reader.rows.data());
  png_read_end(png, nullptr);
  return true;
}

}  // namespace

bool DecodePng(FILE* file, bool header_only, Image& image, CodecError& error) {
  Reader reader;
  reader.error = &error;
  if (!Create(reader) || !ReadHeader(reader, file, image)) return false;
  if (!PreparePixels(header_only, image, error)) return false;
  if (header_only) return true;
  try {
    reader.rows.resize(image.height);
  } catch (const std::bad_alloc&) {
    error.kind = DiagnosticKind::kOutOfMemory;
    snprintf(error.text, sizeof error.text, "there is not enough memory to read it");
    return false;
  }
  for (uint32_t y = 0; y < image.height; ++y)
    reader.rows[y] = image.pixels.data() + y * image.RowBytes();
  return ReadPixels(reader, image);
}

namespace {

struct Writer {
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::string bytes;
  ~Writer() { png_destroy_write_struct(&png, &info); }
};

void OnWrite(png_structp png, png_bytep data, size_t size) {
  auto* writer = static_cast<Writer*>(png_get_io_ptr(png));
  bool written = true;
  try {
    writer->bytes.append(reinterpret_cast<const char*>(data), size);
  } catch (const std::bad_alloc&) {
    written = false;  // left outside the handler, so that no longjmp passes through it
  }
  if (!written) png_error(png, "out of memory");
}

bool Write(Writer& writer, const Image& image) {
  static constexpr int kColorTypes[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA,
                                        PNG_COLOR_TYPE_RGB, PNG_COLOR_TYPE_RGB_ALPHA};
  png_structp png = writer.png;
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_write_fn(png, &writer, OnWrite, nullptr);
  png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  // Level 3 is a third of the time of level 6 for a few per cent more bytes.
  png_set_compression_level(png, 3);
  png_set_IHDR(png, writer.info, image.width, image.height, image.bits,
               kColorTypes[image.channels - 1], PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, writer.info);
  if (image.bits == 16 && std::endian::native == std::endian::little) png_set_swap(png);
  for (uint32_t y = 0; y < image.height; ++y) {
    png_write_row(png, image.pixels.data() + y * image.RowBytes());
  }
  png_write_end(png, writer.info);
  return true;
}

}  // namespace

std::optional<std::string> EncodePng(const Image& image) {
  if (image.channels < 1 || image.channels > 4 || image.width == 0 || image.height == 0)
    return std::nullopt;
  if (image.pixels.size() < image.RowBytes() * image.height) return std::nullopt;
  Writer writer;
  CodecError error;
  writer.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &error, OnError, OnWarning);
  if (writer.png) writer.info = png_create_info_struct(writer.png);
  if (!writer.info || !Write(writer, image)) return std::nullopt;
  return std::move(writer.bytes);
}

}  // namespace texgraph::textures
