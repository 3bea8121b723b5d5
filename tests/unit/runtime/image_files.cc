// SPDX-License-Identifier: Apache-2.0
#include "tests/unit/runtime/image_files.h"

#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>
#include <zlib.h>

#include <cstdio>
#include <fstream>

extern "C" {
#include <jpeglib.h>
}

namespace texgraph::test {
namespace {

void AppendBigEndian(std::string& text, uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) text += static_cast<char>(value >> shift);
}

std::vector<jpeg_scan_info> BitByBit() {
  std::vector<jpeg_scan_info> scans;
  scans.push_back({1, {0}, 0, 0, 0, 0});
  for (int coefficient = 1; coefficient < 64; ++coefficient) {
    for (int bit = 9; bit >= 0; --bit) {
      scans.push_back({1, {0}, coefficient, coefficient, bit == 9 ? 0 : bit + 1, bit});
    }
  }
  return scans;
}

}  // namespace

std::string PngChunk(const std::string& type, const std::string& data) {
  std::string chunk;
  AppendBigEndian(chunk, static_cast<uint32_t>(data.size()));
  const std::string body = type + data;
  chunk += body;
  AppendBigEndian(chunk, static_cast<uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(body.data()),
                                                     static_cast<uInt>(body.size()))));
  return chunk;
}

std::string PngHeader(uint32_t width, uint32_t height, uint8_t bits, uint8_t color_type) {
  std::string data;
  AppendBigEndian(data, width);
  AppendBigEndian(data, height);
  data += static_cast<char>(bits);
  data += static_cast<char>(color_type);
  data += std::string(3, '\0');
  return PngChunk("IHDR", data);
}

std::string Deflate(const std::string& data) {
  uLongf size = compressBound(data.size());
  std::string out(size, '\0');
  compress2(reinterpret_cast<Bytef*>(out.data()), &size,
            reinterpret_cast<const Bytef*>(data.data()), data.size(), 1);
  out.resize(size);
  return out;
}

std::string Png(uint32_t width, uint32_t height, uint8_t bits, uint8_t color_type,
                const std::string& rows, const std::string& middle) {
  return "\x89PNG\r\n\x1a\n" + PngHeader(width, height, bits, color_type) + middle +
         PngChunk("IDAT", Deflate(rows)) + PngChunk("IEND", "");
}

std::string Jpeg(const JpegShape& shape, const std::vector<uint8_t>& pixels) {
  jpeg_compress_struct jpeg;
  jpeg_error_mgr errors;
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &bytes, &size);
  jpeg.image_width = static_cast<JDIMENSION>(shape.width);
  jpeg.image_height = static_cast<JDIMENSION>(shape.height);
  jpeg.input_components = shape.components;
  jpeg.in_color_space = shape.components == 1   ? JCS_GRAYSCALE
                        : shape.components == 3 ? JCS_RGB
                                                : JCS_CMYK;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, shape.quality, TRUE);
  if (shape.progressive) jpeg_simple_progression(&jpeg);
  const std::vector<jpeg_scan_info> scans = BitByBit();
  if (shape.bit_by_bit) {
    jpeg.scan_info = scans.data();
    jpeg.num_scans = static_cast<int>(scans.size());
  }
  jpeg_start_compress(&jpeg, TRUE);
  while (jpeg.next_scanline < jpeg.image_height) {
    const size_t offset = size_t{jpeg.next_scanline} * jpeg.image_width * jpeg.input_components;
    JSAMPROW row = const_cast<uint8_t*>(pixels.data() + offset);
    jpeg_write_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_compress(&jpeg);
  std::string result(reinterpret_cast<char*>(bytes), size);
  jpeg_destroy_compress(&jpeg);
  free(bytes);
  return result;
}

std::string WriteTemporary(const std::string& name, const std::string& bytes) {
  const std::string path = testing::TempDir() + "texgraph_" + std::to_string(getpid()) + "_" + name;
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return path;
}

}  // namespace texgraph::test
