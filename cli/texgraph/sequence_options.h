// SPDX-License-Identifier: Apache-2.0
// The options that say what kind of file is written, and of how many pictures: --format, --bits,
// --time, --sweep, --frames and --contact-sheet.
#pragma once

#include <string>

#include "cli/texgraph/render_options.h"

namespace texgraph::cli {

// Their texts; "" where one was not given.
struct SequenceTexts {
  std::string format;
  std::string bits;
  std::string time;
  std::string sweep;
  std::string frames;
};

// Needs options.output, options.contact_sheet and options.mesh.turntable.
void ReadSequenceOptions(const SequenceTexts& texts, RenderOptions& options,
                         Diagnostics& diagnostics);

}  // namespace texgraph::cli
