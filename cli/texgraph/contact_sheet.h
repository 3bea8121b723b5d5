// SPDX-License-Identifier: Apache-2.0
// Pictures of one size in a grid, from the left top corner on, row by row: as many columns as rows
// or one more. Between them are kSheetGap pixels, opaque and black.
#pragma once

#include <optional>
#include <span>

#include "compiler/base/diagnostics.h"
#include "runtime/render.h"

namespace texgraph::cli {

inline constexpr uint32_t kSheetGap = 4;

struct SheetLayout {
  uint32_t cells = 0;
  uint32_t columns = 0;
  uint32_t rows = 0;
  uint32_t cell_width = 0;
  uint32_t cell_height = 0;
  uint32_t width = 0;
  uint32_t height = 0;
};

// Nothing, with kSizeLimit reported, if the sheet were larger than a picture may be. `cells` is at
// least 1.
std::optional<SheetLayout> LayOutSheet(uint32_t cells, uint32_t width, uint32_t height,
                                       runtime::PixelFormat format, Diagnostics& diagnostics);

// All of `cells` have the layout's size and one format. The sheet has as many channels as the cell
// with most: grey ones become RGB among coloured ones, those without alpha are opaque. False if
// memory ran out.
bool DrawSheet(const SheetLayout& layout, std::span<const runtime::RenderedOutput> cells,
               runtime::RenderedOutput& sheet);

}  // namespace texgraph::cli
