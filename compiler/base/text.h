// SPDX-License-Identifier: Apache-2.0
// Small pieces of text that depend on no locale.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>

namespace texgraph {

// The shortest decimal text that reads back as exactly `value`, always with a '.' or an exponent,
// so that GLSL and JSON take it as a float: "1.0", "0.1", "1e-45", "-0.0". Whole numbers below 1e9
// are written out: "16777216.0". `value` must be finite.
std::string FloatText(float value);
// The same for a double.
std::string DoubleText(double value);

// [A-Za-z_][A-Za-z0-9_]*
bool IsIdentifier(std::string_view text);
// A keyword, a reserved word or a built-in name of any GLSL dialect that is emitted, or a name with
// "__" or "gl_".
bool IsReservedInGlsl(std::string_view name);

// The code point that begins at `at` (< text.size()) and its length in bytes; length 0 if the bytes
// there are not valid UTF-8 (overlong forms, surrogates and values above U+10FFFF are not).
struct CodePoint {
  uint32_t value;
  uint32_t length;
};
CodePoint DecodeUtf8(std::string_view text, size_t at);

// "a, b or c": the texts of some things, with `last` (" or ", " and ") before the last one.
template <class Things, class TextOf>
std::string Listed(const Things& things, std::string_view last, TextOf text_of) {
  std::string list;
  size_t left = std::size(things);
  for (const auto& thing : things) {
    list += list.empty() ? "" : left == 1 ? last : ", ";
    list += text_of(thing);
    --left;
  }
  return list;
}
// "'a', 'b' or 'c'"
template <class Words>
std::string ListedQuoted(const Words& words, std::string_view last) {
  return Listed(words, last, [](std::string_view word) { return "'" + std::string(word) + "'"; });
}

// `text` as a JSON string with its quotes; bytes that are not valid UTF-8 become U+FFFD.
std::string JsonQuoted(std::string_view text);

}  // namespace texgraph
