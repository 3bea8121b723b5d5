// SPDX-License-Identifier: Apache-2.0
// OpenEXR's C++ library, which shares no code with the C library that texgraph writes with.
#pragma once

#include <ImfPixelType.h>

#include <string>
#include <vector>

namespace texgraph::runtime {

struct ExrFile {
  int width = 0;
  int height = 0;
  std::string channels;  // "ABGR": the order in the file
  Imf::PixelType type = Imf::NUM_PIXELTYPES;
  std::vector<std::vector<float>> planes;  // in that order, from the top
};

// Throws what the library throws.
ExrFile ReadExr(const std::string& bytes);

}  // namespace texgraph::runtime
