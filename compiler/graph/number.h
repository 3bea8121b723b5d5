// SPDX-License-Identifier: Apache-2.0
// The numbers of documents, read without a locale and rounded to the nearest double.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "compiler/graph/document.h"

namespace texgraph::graph {

struct NumberSpelling {
  size_t length = 0;              // of the number at the start of the text; 0: there is none
  bool has_fraction = false;      // '.' or exponent
  const char* problem = nullptr;  // why the spelling is no JSON number, if it tries to be one
};
// Finds the JSON number (RFC 8259, section 6) that `text` begins with.
NumberSpelling SpellNumber(std::string_view text);

enum class NumberStatus : uint8_t { kExact, kOverflow, kUnderflow };
// Sets the number fields of `node`. Too small becomes zero with its sign (kUnderflow). `spelled` is
// a JSON number, or one that begins or ends with its '.'.
NumberStatus SetNumber(std::string_view spelled, DocumentNode& node);
// The same with the diagnostics: an error if it is too large, a warning if it becomes zero.
bool SetNumber(std::string_view spelled, DocumentNode& node, Diagnostics& diagnostics);

}  // namespace texgraph::graph
