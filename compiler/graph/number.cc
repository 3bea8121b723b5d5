// SPDX-License-Identifier: Apache-2.0
#include "compiler/graph/number.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>

namespace texgraph::graph {
namespace {

bool IsDigit(char c) { return c >= '0' && c <= '9'; }

size_t SkipDigits(std::string_view text, size_t at) {
  while (at < text.size() && IsDigit(text[at])) ++at;
  return at;
}

NumberSpelling Problem(const char* what) { return {0, false, what}; }

// Whether a number that no double holds is too small rather than too large: the place of its first
// digit that is not 0, moved by the exponent.
bool IsSmall(std::string_view spelled) {
  size_t e = spelled.find_first_of("eE");
  std::string_view digits = spelled.substr(0, e);
  int64_t exponent = 0;
  if (e != std::string_view::npos) {
    std::string_view text = spelled.substr(e + 1);
    bool negative = text.starts_with('-');
    if (negative || text.starts_with('+')) text.remove_prefix(1);
    for (char c : text) {
      if (exponent < 1'000'000'000'000) exponent = exponent * 10 + (c - '0');
    }
    if (negative) exponent = -exponent;
  }
  size_t first = digits.find_first_of("123456789");
  if (first == std::string_view::npos) return true;
  size_t point = digits.find('.');
  if (point == std::string_view::npos) point = digits.size();
  auto place = static_cast<int64_t>(point) - static_cast<int64_t>(first);
  return place + exponent < 0;
}

}  // namespace

NumberSpelling SpellNumber(std::string_view text) {
  size_t at = 0;
  if (text.starts_with('-')) ++at;
  if (at == text.size() || !IsDigit(text[at])) {
    if (at < text.size() && text[at] == '.') return Problem("numbers begin with a digit: 0.5");
    return at == 0 ? NumberSpelling{} : Problem("digits must follow the '-'");
  }
  size_t begin = at;
  at = SkipDigits(text, at);
  if (text[begin] == '0' && at > begin + 1) return Problem("numbers have no leading zeros");
  if (text[begin] == '0' && at < text.size() && (text[at] == 'x' || text[at] == 'X')) {
    return Problem("numbers are decimal");
  }
  NumberSpelling result;
  if (at < text.size() && text[at] == '.') {
    size_t digits = at + 1;
    at = SkipDigits(text, digits);
    if (at == digits) return Problem("digits must follow the '.'");
    result.has_fraction = true;
  }
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    ++at;
    if (at < text.size() && (text[at] == '+' || text[at] == '-')) ++at;
    size_t digits = at;
    at = SkipDigits(text, digits);
    if (at == digits) return Problem("digits must follow the exponent");
    result.has_fraction = true;
  }
  result.length = at;
  return result;
}

NumberStatus SetNumber(std::string_view spelled, DocumentNode& node) {
  node.kind = DocumentKind::kNumber;
  const char* begin = spelled.data();
  const char* end = begin + spelled.size();
  if (spelled.find_first_of(".eE") == std::string_view::npos) {
    auto [last, error] = std::from_chars(begin, end, node.integer);
    if (error == std::errc() && last == end) {
      node.is_integer = true;
      node.number = static_cast<double>(node.integer);
      if (node.integer == 0 && spelled[0] == '-') node.number = -0.0;
      return NumberStatus::kExact;
    }
    node.integer = 0;
  }
  auto [last, error] = std::from_chars(begin, end, node.number);
  if (error == std::errc() && std::isfinite(node.number)) {
    // Some libraries give 0 without an error where a number is too small.
    bool lost = node.number == 0 &&
                spelled.substr(0, spelled.find_first_of("eE")).find_first_of("123456789") !=
                    std::string_view::npos;
    return lost ? NumberStatus::kUnderflow : NumberStatus::kExact;
  }
  if (!IsSmall(spelled)) return NumberStatus::kOverflow;
  node.number = spelled[0] == '-' ? -0.0 : 0.0;
  return NumberStatus::kUnderflow;
}

bool SetNumber(std::string_view spelled, DocumentNode& node, Diagnostics& diagnostics) {
  switch (SetNumber(spelled, node)) {
    case NumberStatus::kExact:
      return true;
    case NumberStatus::kOverflow:
      diagnostics.Error(DiagnosticKind::kNumberRange, node.range,
                        fmt::format("'{}' is out of range: the largest number is {}",
                                    Printable(spelled, 40), std::numeric_limits<double>::max()));
      return false;
    case NumberStatus::kUnderflow:
      diagnostics.Warn(DiagnosticKind::kNumberUnderflow, node.range,
                       fmt::format("'{}' is too small and becomes 0", Printable(spelled, 40)));
      return true;
  }
  return true;
}

}  // namespace texgraph::graph
