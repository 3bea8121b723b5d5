// SPDX-License-Identifier: Apache-2.0
#include "compiler/base/text.h"

#include <charconv>
#include <cmath>
#include <cstdint>

namespace texgraph {
namespace {

// to_chars writes "1e+20" and "1e-05"; people write "1e20" and "1e-5".
void AppendExponent(std::string& out, std::string_view exponent) {
  out += 'e';
  if (exponent.front() == '-') out += '-';
  if (exponent.front() == '-' || exponent.front() == '+') exponent.remove_prefix(1);
  while (exponent.size() > 1 && exponent.front() == '0') exponent.remove_prefix(1);
  out += exponent;
}

// Plain digits in [smallest, largest), an exponent outside, so that "0.0001" and "100000.0" stay
// readable.
template <class T>
std::string ShortestText(T value, T smallest, T largest) {
  T magnitude = std::fabs(value);
  bool plain = magnitude == 0 || (magnitude >= smallest && magnitude < largest);
  char buffer[64];
  auto format = plain ? std::chars_format::fixed : std::chars_format::scientific;
  auto result = std::to_chars(buffer, buffer + sizeof buffer, value, format);
  std::string_view text(buffer, static_cast<size_t>(result.ptr - buffer));
  if (plain) {
    std::string out(text);
    if (text.find('.') == std::string_view::npos) out += ".0";
    return out;
  }
  size_t e = text.find('e');
  if (e == std::string_view::npos) return std::string(text);  // inf and nan, which callers exclude
  std::string out(text.substr(0, e));
  AppendExponent(out, text.substr(e + 1));
  return out;
}

}  // namespace

std::string FloatText(float value) { return ShortestText(value, 1e-4f, 1e9f); }

std::string DoubleText(double value) { return ShortestText(value, 1e-4, 1e15); }

bool IsIdentifier(std::string_view text) {
  if (text.empty() || (text[0] >= '0' && text[0] <= '9')) return false;
  for (char c : text) {
    bool word =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    if (!word) return false;
  }
  return true;
}

CodePoint DecodeUtf8(std::string_view text, size_t at) {
  auto byte = [&](size_t i) { return static_cast<uint8_t>(text[i]); };
  uint8_t lead = byte(at);
  if (lead < 0x80) return {lead, 1};
  uint32_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || at + length > text.size()) return {0, 0};
  uint32_t value = lead & (0x7f >> length);
  for (uint32_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xc0) != 0x80) return {0, 0};
    value = value << 6 | (byte(at + i) & 0x3f);
  }
  constexpr uint32_t kSmallest[] = {0, 0, 0x80, 0x800, 0x10000};
  bool surrogate = value >= 0xd800 && value <= 0xdfff;
  if (value < kSmallest[length] || surrogate || value > 0x10ffff) return {0, 0};
  return {value, length};
}

std::string JsonQuoted(std::string_view text) {
  constexpr char kHex[] = "0123456789abcdef";
  std::string out = "\"";
  out.reserve(text.size() + 2);
  for (size_t i = 0; i < text.size();) {
    CodePoint c = DecodeUtf8(text, i);
    if (c.length == 0) {
      out += "\xef\xbf\xbd";
      ++i;
      continue;
    }
    switch (c.value) {
      case '"':
        out += "\\\"";
        break;
      case '\\':
        out += "\\\\";
        break;
      case '\b':
        out += "\\b";
        break;
      case '\f':
        out += "\\f";
        break;
      case '\n':
        out += "\\n";
        break;
      case '\r':
        out += "\\r";
        break;
      case '\t':
        out += "\\t";
        break;
      default:
        if (c.value < 0x20 || c.value == 0x7f) {
          out += "\\u00";
          out += kHex[c.value >> 4];
          out += kHex[c.value & 15];
        } else {
          out += text.substr(i, c.length);
        }
    }
    i += c.length;
  }
  out += '"';
  return out;
}

}  // namespace texgraph
