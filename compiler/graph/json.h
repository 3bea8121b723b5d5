// SPDX-License-Identifier: Apache-2.0
// Reads JSON (RFC 8259), to the letter or with comments and trailing commas. Stops at the first
// mistake. Needs no recursion and copies only strings that have escapes.
#pragma once

#include <cstdint>
#include <string_view>

#include "compiler/graph/document.h"

namespace texgraph::graph {

struct JsonText {
  SourceId source;
  std::string_view text;  // of the whole source: valid UTF-8
  uint32_t begin = 0;     // where the document begins in it
  bool extended = false;  // JSONC
};

// Fills `document`. False on an error, which is reported. Duplicate keys are left to the caller.
bool ReadJson(const JsonText& json, Document& document, Diagnostics& diagnostics);

}  // namespace texgraph::graph
