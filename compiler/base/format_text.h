// SPDX-License-Identifier: Apache-2.0
// How single characters of strangers' texts are shown on a terminal. Private to the parts of
// diagnostics.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace texgraph {

struct ShownCharacter {
  std::string text;  // the character, or its escape
  uint32_t columns;  // that it takes in a terminal
  uint32_t bytes;    // that it took in the source
};
// The character that begins at `at`; a byte that is not valid UTF-8 stands for itself.
ShownCharacter ShowCharacter(std::string_view text, size_t at);

}  // namespace texgraph
