// SPDX-License-Identifier: Apache-2.0
// The first check of every document: afterwards its bytes are UTF-8 without NUL, and no later
// reader needs to look at single bytes of a character again.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "compiler/base/diagnostics.h"

namespace texgraph::graph {

// The length of a UTF-8 byte order mark at the start of `text`: 3 or 0.
size_t ByteOrderMarkLength(std::string_view text);
// The offset of the first byte that is not part of valid UTF-8, or is NUL.
std::optional<size_t> FindBadByte(std::string_view text);
// False, with a diagnostic, if the source is not UTF-8.
bool CheckEncoding(SourceId source, std::string_view text, Diagnostics& diagnostics);
// Appends a code point, which is no surrogate, as UTF-8.
void AppendUtf8(std::string& out, uint32_t code_point);

}  // namespace texgraph::graph
