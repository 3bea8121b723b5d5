// SPDX-License-Identifier: Apache-2.0
#include "compiler/graph/encoding.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <string>

#include "compiler/base/text.h"

namespace texgraph::graph {
namespace {

constexpr uint64_t kLowBits = 0x0101010101010101ull;
constexpr uint64_t kHighBits = 0x8080808080808080ull;

// UTF-16 and UTF-32, with their marks or without: every second byte of plain letters is NUL.
bool LooksLikeUtf16(std::string_view text) {
  if (text.size() < 2) return false;
  std::string_view mark = text.substr(0, 2);
  if (mark == "\xff\xfe" || mark == "\xfe\xff") return true;
  return (text[0] == '\0') != (text[1] == '\0');
}

}  // namespace

size_t ByteOrderMarkLength(std::string_view text) {
  return text.starts_with("\xef\xbb\xbf") ? 3 : 0;
}

std::optional<size_t> FindBadByte(std::string_view text) {
  size_t at = 0;
  while (at < text.size()) {
    // Eight plain characters at once: no high bit, no zero byte.
    uint64_t word;
    if (at + sizeof word <= text.size()) {
      std::memcpy(&word, text.data() + at, sizeof word);
      if ((word & kHighBits) == 0 && ((word - kLowBits) & ~word & kHighBits) == 0) {
        at += sizeof word;
        continue;
      }
    }
    CodePoint c = DecodeUtf8(text, at);
    if (c.length == 0 || c.value == 0) return at;
    at += c.length;
  }
  return std::nullopt;
}

bool CheckEncoding(SourceId source, std::string_view text, Diagnostics& diagnostics) {
  std::optional<size_t> bad = FindBadByte(text);
  if (!bad) return true;
  auto offset = static_cast<uint32_t>(*bad);
  SourceRange range{source, offset, offset + 1};
  auto byte = static_cast<uint8_t>(text[*bad]);
  if (LooksLikeUtf16(text)) {
    diagnostics.Error(DiagnosticKind::kEncoding, range,
                      "the document is not UTF-8 but looks like UTF-16; save it as UTF-8");
  } else if (byte == 0) {
    diagnostics.Error(DiagnosticKind::kEncoding, range,
                      fmt::format("NUL byte at byte offset {}", offset));
  } else {
    diagnostics.Error(DiagnosticKind::kEncoding, range,
                      fmt::format("invalid UTF-8: byte 0x{:02X} at byte offset {}", byte, offset));
  }
  return false;
}

void AppendUtf8(std::string& out, uint32_t code_point) {
  auto put = [&](uint32_t byte) { out += static_cast<char>(byte); };
  if (code_point < 0x80) {
    put(code_point);
  } else if (code_point < 0x800) {
    put(0xc0 | code_point >> 6);
    put(0x80 | (code_point & 0x3f));
  } else if (code_point < 0x10000) {
    put(0xe0 | code_point >> 12);
    put(0x80 | (code_point >> 6 & 0x3f));
    put(0x80 | (code_point & 0x3f));
  } else {
    put(0xf0 | code_point >> 18);
    put(0x80 | (code_point >> 12 & 0x3f));
    put(0x80 | (code_point >> 6 & 0x3f));
    put(0x80 | (code_point & 0x3f));
  }
}

}  // namespace texgraph::graph
