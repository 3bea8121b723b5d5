// SPDX-License-Identifier: Apache-2.0
#include "cli/texgraph/contact_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>

namespace texgraph::cli {
namespace {

using runtime::RenderedOutput;

// Samples of a cell or of the sheet: pixels of `stride` samples, `channels` of them with a meaning.
template <class T>
struct Samples {
  T* first;
  uint32_t stride;
  uint32_t channels;
};

bool IsFloat(const RenderedOutput& output) { return !output.floats.empty(); }

// Of the picture that a cell makes; two channels are red and green.
uint32_t Channels(const RenderedOutput& output) {
  if (!IsFloat(output)) return output.image.channels;
  return output.channels == 2 ? 3 : output.channels;
}

template <class T>
void CopyPixel(const T* from, uint32_t from_channels, T* to, uint32_t to_channels, T one) {
  for (uint32_t c = 0; c < to_channels; ++c) {
    if (c == 3) {
      to[c] = from_channels == 4 ? from[3] : one;
    } else {
      to[c] = from_channels == 1 ? from[0] : c < from_channels ? from[c] : T(0);
    }
  }
}

// Floats have their first row at the bottom, images at the top.
template <class T>
void CopyCell(const SheetLayout& layout, uint32_t index, bool from_bottom,
              const Samples<const T>& cell, const Samples<T>& sheet, T one) {
  const uint32_t grid_row = index / layout.columns;
  const uint32_t row = from_bottom ? layout.rows - 1 - grid_row : grid_row;
  const size_t left = size_t{index % layout.columns} * (layout.cell_width + kSheetGap);
  const size_t first_row = size_t{row} * (layout.cell_height + kSheetGap);
  for (uint32_t y = 0; y < layout.cell_height; ++y) {
    const T* from = cell.first + size_t{y} * layout.cell_width * cell.stride;
    T* to = sheet.first + ((first_row + y) * layout.width + left) * sheet.stride;
    for (uint32_t x = 0; x < layout.cell_width; ++x) {
      CopyPixel(from, cell.channels, to, sheet.channels, one);
      from += cell.stride;
      to += sheet.stride;
    }
  }
}

template <class T>
void Fill(const SheetLayout& layout, const Samples<T>& sheet, T one) {
  const size_t pixels = size_t{layout.width} * layout.height;
  for (size_t i = 0; i < pixels; ++i) {
    for (uint32_t c = 0; c < sheet.channels; ++c)
      sheet.first[i * sheet.stride + c] = c == 3 ? one : T(0);
  }
}

template <class T>
void DrawImages(const SheetLayout& layout, std::span<const RenderedOutput> cells, T one,
                RenderedOutput& sheet) {
  const uint32_t channels = sheet.image.channels;
  const Samples<T> to{reinterpret_cast<T*>(sheet.image.pixels.data()), channels, channels};
  Fill(layout, to, one);
  for (uint32_t i = 0; i < cells.size(); ++i) {
    const textures::Image& image = cells[i].image;
    const Samples<const T> from{reinterpret_cast<const T*>(image.pixels.data()), image.channels,
                                image.channels};
    CopyCell(layout, i, false, from, to, one);
  }
}

void DrawFloats(const SheetLayout& layout, std::span<const RenderedOutput> cells,
                RenderedOutput& sheet) {
  const Samples<float> to{sheet.floats.data(), 4, sheet.channels};
  Fill(layout, to, 1.0f);
  for (uint32_t i = 0; i < cells.size(); ++i) {
    CopyCell(layout, i, true, {cells[i].floats.data(), 4, cells[i].channels}, to, 1.0f);
  }
}

}  // namespace

std::optional<SheetLayout> LayOutSheet(uint32_t cells, uint32_t width, uint32_t height,
                                       runtime::PixelFormat format, Diagnostics& diagnostics) {
  SheetLayout layout;
  layout.cells = cells;
  while (layout.columns * layout.columns < cells) ++layout.columns;
  layout.rows = (cells + layout.columns - 1) / layout.columns;
  layout.cell_width = width;
  layout.cell_height = height;
  const uint64_t all_width = uint64_t{layout.columns} * (width + kSheetGap) - kSheetGap;
  const uint64_t all_height = uint64_t{layout.rows} * (height + kSheetGap) - kSheetGap;
  const uint64_t pixel = format == runtime::PixelFormat::kFloat     ? 16
                         : format == runtime::PixelFormat::kImage16 ? 8
                                                                    : 4;
  if (std::max(all_width, all_height) > runtime::kMaxPictureSide ||
      all_width * all_height > runtime::kMaxPictureBytes / pixel) {
    diagnostics.Error(
        DiagnosticKind::kSizeLimit, {},
        fmt::format(
            "a contact sheet of {} x {} pictures of {} x {} pixels is larger than a picture "
            "may be ({} pixels each way, {} bytes); --size sets the size of one",
            layout.columns, layout.rows, width, height, runtime::kMaxPictureSide,
            runtime::kMaxPictureBytes));
    return std::nullopt;
  }
  layout.width = static_cast<uint32_t>(all_width);
  layout.height = static_cast<uint32_t>(all_height);
  return layout;
}

bool DrawSheet(const SheetLayout& layout, std::span<const RenderedOutput> cells,
               RenderedOutput& sheet) {
  uint32_t channels = 1;
  for (const RenderedOutput& cell : cells) channels = std::max(channels, Channels(cell));
  const size_t pixels = size_t{layout.width} * layout.height;
  sheet.channels = channels;
  try {
    if (IsFloat(cells[0])) {
      sheet.floats.resize(pixels * 4);
      DrawFloats(layout, cells, sheet);
      return true;
    }
    sheet.image.width = layout.width;
    sheet.image.height = layout.height;
    sheet.image.bits = cells[0].image.bits;
    sheet.image.channels = static_cast<uint8_t>(channels);
    sheet.image.pixels.resize(pixels * channels * (sheet.image.bits / 8));
  } catch (const std::bad_alloc&) {
    return false;
  }
  if (sheet.image.bits == 16) {
    DrawImages<uint16_t>(layout, cells, 65535, sheet);
  } else {
    DrawImages<uint8_t>(layout, cells, 255, sheet);
  }
  return true;
}

}  // namespace texgraph::cli
