// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "compiler/base/diagnostics.h"
#include "compiler/base/format_text.h"
#include "compiler/base/text.h"

namespace texgraph {
namespace {

// Characters that move the cursor, reverse, hide or glue what a terminal shows around them.
bool IsDeceptive(uint32_t c) {
  return c < 0x20 || (c >= 0x7f && c < 0xa0) || c == 0xad || c == 0x34f || c == 0x61c ||
         c == 0x115f || c == 0x1160 || c == 0x17b4 || c == 0x17b5 || (c >= 0x180b && c <= 0x180f) ||
         (c >= 0x200b && c <= 0x200f) || (c >= 0x2028 && c <= 0x202e) ||
         (c >= 0x2060 && c <= 0x206f) || c == 0x3164 || (c >= 0xfe00 && c <= 0xfe0f) ||
         c == 0xfeff || c == 0xffa0 || (c >= 0xfff0 && c <= 0xfffb) ||
         (c >= 0xe0000 && c <= 0xe0fff) || (c & 0xfffe) == 0xfffe;
}

bool IsCombining(uint32_t c) {
  return (c >= 0x300 && c <= 0x36f) || (c >= 0x483 && c <= 0x489) || (c >= 0x591 && c <= 0x5bd) ||
         (c >= 0x610 && c <= 0x61a) || (c >= 0x64b && c <= 0x65f) || (c >= 0x1ab0 && c <= 0x1aff) ||
         (c >= 0x1dc0 && c <= 0x1dff) || (c >= 0x20d0 && c <= 0x20ff) ||
         (c >= 0xfe20 && c <= 0xfe2f);
}

// East Asian wide characters and emoji take two columns.
bool IsWide(uint32_t c) {
  return (c >= 0x1100 && c <= 0x115f) || (c >= 0x2e80 && c <= 0x303e) ||
         (c >= 0x3041 && c <= 0xa4cf) || (c >= 0xac00 && c <= 0xd7a3) ||
         (c >= 0xf900 && c <= 0xfaff) || (c >= 0xfe30 && c <= 0xfe6f) ||
         (c >= 0xff00 && c <= 0xff60) || (c >= 0xffe0 && c <= 0xffe6) ||
         (c >= 0x1f300 && c <= 0x1f64f) || (c >= 0x1f900 && c <= 0x1f9ff) ||
         (c >= 0x20000 && c <= 0x3fffd);
}

std::string Escape(uint32_t c) {
  switch (c) {
    case '\n':
      return "\\n";
    case '\r':
      return "\\r";
    case '\t':
      return "\\t";
    default:
      break;
  }
  if (c < 0x80) return fmt::format("\\x{:02x}", c);
  return c < 0x10000 ? fmt::format("\\u{:04x}", c) : fmt::format("\\U{:08x}", c);
}

}  // namespace

ShownCharacter ShowCharacter(std::string_view text, size_t at) {
  CodePoint c = DecodeUtf8(text, at);
  if (c.length == 0) return {fmt::format("\\x{:02x}", static_cast<uint8_t>(text[at])), 4, 1};
  if (IsDeceptive(c.value)) {
    std::string escape = Escape(c.value);
    uint32_t columns = static_cast<uint32_t>(escape.size());
    return {std::move(escape), columns, c.length};
  }
  uint32_t columns = IsCombining(c.value) ? 0 : IsWide(c.value) ? 2 : 1;
  return {std::string(text.substr(at, c.length)), columns, c.length};
}

std::string Printable(std::string_view text, size_t limit) {
  constexpr std::string_view kEllipsis = "...";
  std::string out;
  size_t fits = 0;  // the longest beginning that leaves room for the ellipsis
  for (size_t at = 0; at < text.size();) {
    ShownCharacter shown = ShowCharacter(text, at);
    if (out.size() + shown.text.size() > limit) {
      out.resize(fits);
      return out.append(kEllipsis);
    }
    out += shown.text;
    at += shown.bytes;
    if (out.size() + kEllipsis.size() <= limit) fits = out.size();
  }
  return out;
}

}  // namespace texgraph
