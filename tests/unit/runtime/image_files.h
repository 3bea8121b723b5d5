// SPDX-License-Identifier: Apache-2.0
// Makes image files for tests, byte by byte where a library would refuse to write what is wrong
// with them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace texgraph::test {

// A PNG chunk with its length and checksum.
std::string PngChunk(const std::string& type, const std::string& data);
// width, height, bits, colour type (0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGBA), no
// interlacing.
std::string PngHeader(uint32_t width, uint32_t height, uint8_t bits, uint8_t color_type);
std::string Deflate(const std::string& data);
// Signature, header, `middle` (whole chunks), the rows (each with its filter byte) and the end.
std::string Png(uint32_t width, uint32_t height, uint8_t bits, uint8_t color_type,
                const std::string& rows, const std::string& middle = "");

struct JpegShape {
  int width = 8;
  int height = 8;
  int components = 3;  // 1, 3 or 4 (CMYK)
  bool progressive = false;
  int quality = 100;
  bool bit_by_bit =
      false;  // one component only: one scan for each bit of each coefficient, 631 in all
};
// `pixels`: components a pixel, row by row.
std::string Jpeg(const JpegShape& shape, const std::vector<uint8_t>& pixels);

// A file in the test's temporary folder.
std::string WriteTemporary(const std::string& name, const std::string& bytes);

}  // namespace texgraph::test
