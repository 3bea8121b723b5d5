// SPDX-License-Identifier: Apache-2.0
#include "compiler/graph/literal.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>
#include <vector>

#include "compiler/blocks/limits.h"
#include "compiler/graph/conversion.h"

namespace texgraph::graph {
namespace {

// From here on a number rounds to infinity as a float: the middle between the largest float and the
// next power of two.
constexpr double kFloatOverflow = 0x1.ffffffp127;
constexpr double kLargestFloat = 0x1.fffffep127;

// What the words of a type are: the scalar of vectors and matrices, or of an array of these.
std::optional<ir::Scalar> ScalarOfWords(ir::TypeId type, const ir::Types& types) {
  while (types.Kind(type) == ir::TypeKind::kArray) type = types.ElementType(type, 0);
  if (ir::IsVector(type)) return ir::ScalarOf(type);
  if (ir::IsMatrix(type)) return ir::Scalar::kFloat;
  return std::nullopt;
}

enum class Encoding : uint8_t { kFits, kUnderflow, kOutOfRange, kWrongKind };

Encoding Encode(double number, bool is_integer, ir::Scalar scalar, uint32_t& word) {
  switch (scalar) {
    case ir::Scalar::kBool:
      return Encoding::kWrongKind;
    case ir::Scalar::kInt:
      if (number < -2147483648.0 || number > 2147483647.0) return Encoding::kOutOfRange;
      if (!is_integer) return Encoding::kWrongKind;
      word = static_cast<uint32_t>(static_cast<int32_t>(number));
      return Encoding::kFits;
    case ir::Scalar::kUint:
      if (number < 0 || number > 4294967295.0) return Encoding::kOutOfRange;
      if (!is_integer) return Encoding::kWrongKind;
      word = static_cast<uint32_t>(number);
      return Encoding::kFits;
    case ir::Scalar::kFloat:
      break;
  }
  if (std::fabs(number) >= kFloatOverflow) return Encoding::kOutOfRange;
  if (std::fabs(number) > kLargestFloat) number = std::copysign(kLargestFloat, number);
  auto value = static_cast<float>(number);
  word = std::bit_cast<uint32_t>(value);
  return value == 0 && number != 0 ? Encoding::kUnderflow : Encoding::kFits;
}

// Whether there is a number for each word of the type. Vectors in an array stand in rows of their
// own.
bool HasNumbers(const Argument& argument, ir::TypeId type, const ir::Types& types) {
  size_t count = argument.numbers.size();
  if (types.Kind(type) != ir::TypeKind::kArray) return count == types.Words(type);
  ir::TypeId element = types.ElementType(type, 0);
  uint32_t columns = ir::IsVector(element) && !ir::IsScalar(element) ? ir::Width(element) : 0;
  if (argument.columns != columns) return false;
  return types[type].length == 0 || count == types.Words(type);
}

// The type with the argument's length, if it is an array of any.
ir::TypeId WithLength(const Argument& argument, ir::TypeId type, ir::Types& types) {
  if (types.Kind(type) != ir::TypeKind::kArray || types[type].length > 0) return type;
  ir::TypeId element = types.ElementType(type, 0);
  size_t length = argument.numbers.size() / types.Words(element);
  return types.Array(element, static_cast<uint32_t>(length));
}

// How the value of an array is written, for one that has other rows.
std::string RowsHint(const Argument& argument, ir::TypeId type, const ir::Types& types) {
  if (types.Kind(type) != ir::TypeKind::kArray) return {};
  ir::TypeId element = types.ElementType(type, 0);
  if (!ir::IsVector(element) || ir::IsScalar(element)) {
    return argument.columns > 0 ? "; write all numbers in one row: [1, 2, 3]" : "";
  }
  if (argument.columns == ir::Width(element)) return {};
  std::string row = "1";
  for (uint32_t i = 1; i < ir::Width(element); ++i) row += fmt::format(", {}", i + 1);
  return fmt::format("; write each {} as a row: [[{}], ...]", types.Text(element), row);
}

std::nullopt_t ReportMismatch(const Argument& argument, ir::TypeId type, const Place& place,
                              const ir::Types& types, Diagnostics& diagnostics) {
  std::string_view hint;
  if (argument.kind == Argument::Kind::kString) hint = TextHint(argument.text);
  if (argument.kind == Argument::Kind::kNumber && type == ir::kBool) hint = "; write true or false";
  place.AddNote(diagnostics.Error(
      place.mismatch, argument.range,
      fmt::format("{} takes {}, got {}{}{}", place.Text(), types.Text(type), ArgumentText(argument),
                  hint, RowsHint(argument, type, types))));
  return std::nullopt;
}

// The index of number i of a matrix, written row by row, in GLSL's order, column by column.
size_t MatrixWord(size_t i, size_t size) { return i % size * size + i / size; }

}  // namespace

std::string_view TextHint(std::string_view text) {
  for (std::string_view word : {"yes", "Yes", "YES", "on", "On", "ON", "True", "TRUE"}) {
    if (text == word) return "; write true";
  }
  for (std::string_view word : {"no", "No", "NO", "off", "Off", "OFF", "False", "FALSE"}) {
    if (text == word) return "; write false";
  }
  bool number = !text.empty() && std::string_view(".-+0123456789").find(text[0]) != text.npos &&
                text.find_first_of("0123456789") != text.npos;
  return number ? "; numbers are decimal and stand without quotes" : "";
}

std::string Place::Text() const {
  std::string text = fmt::format("{} '{}'", kind, Printable(name, 64));
  if (!owner_kind.empty()) text += fmt::format(" of {} '{}'", owner_kind, Printable(owner, 64));
  return text;
}

void Place::AddNote(Diagnostic& diagnostic) const {
  if (declared.source.valid()) {
    diagnostic.AddNote(declared, fmt::format("the {} is declared here", kind));
  }
}

std::string NumberText(double number) {
  if (std::fabs(number) < 1e15 && number == std::floor(number))
    return fmt::format("{:.0f}", number);
  return fmt::format("{}", number);
}

std::string ArgumentText(const Argument& argument) {
  switch (argument.kind) {
    case Argument::Kind::kNumber: {
      if (argument.numbers.empty()) return "nothing";
      std::string text = NumberText(argument.numbers[0]);
      bool whole = text.find_first_not_of("-0123456789") == std::string::npos;
      return whole && !argument.is_integer ? text + ".0" : text;
    }
    case Argument::Kind::kBool:
      return argument.boolean ? "true" : "false";
    case Argument::Kind::kVector:
      if (argument.columns > 0) {
        size_t rows = argument.numbers.size() / argument.columns;
        return fmt::format("{} row{} of {} number{}{}", rows, rows == 1 ? "" : "s",
                           argument.columns, argument.columns == 1 ? "" : "s",
                           argument.is_integer ? "" : " with fractions");
      }
      return fmt::format("{} number{}{}", argument.numbers.size(),
                         argument.numbers.size() == 1 ? "" : "s",
                         argument.is_integer ? "" : " with fractions");
    case Argument::Kind::kString:
      return fmt::format("the text '{}'", Printable(argument.text, 64));
  }
  return "";
}

std::optional<int> LiteralCost(const Argument& argument, ir::TypeId type, const ir::Types& types) {
  std::optional<ir::Scalar> scalar = ScalarOfWords(type, types);
  if (!scalar || argument.kind == Argument::Kind::kString) return std::nullopt;
  if (argument.kind == Argument::Kind::kBool) {
    return ConversionCost(ir::kBool, type);
  }
  if (*scalar == ir::Scalar::kBool) return std::nullopt;
  int cost = 0;
  if (*scalar == ir::Scalar::kFloat) {
    cost = argument.is_integer ? 1 : 0;
  } else if (!argument.is_integer) {
    return std::nullopt;
  } else if (*scalar == ir::Scalar::kUint) {
    // Nobody means a uint by -1 where a float can be meant.
    for (double number : argument.numbers) {
      if (number < 0) return std::nullopt;
    }
  }
  if (argument.kind == Argument::Kind::kNumber) {
    if (!ir::IsVector(type)) return std::nullopt;
    return ir::IsScalar(type) ? cost : cost + 1;
  }
  bool fits = !ir::IsScalar(type) && HasNumbers(argument, type, types);
  return fits ? std::optional<int>(cost) : std::nullopt;
}

std::optional<ir::ConstId> MakeLiteral(const Argument& argument, ir::TypeId type,
                                       const Place& place, ir::Module& module,
                                       Diagnostics& diagnostics) {
  const ir::Types& types = module.types;
  const ir::TypeId wanted = type;
  auto mismatch = [&] { return ReportMismatch(argument, wanted, place, types, diagnostics); };
  std::optional<ir::Scalar> scalar = ScalarOfWords(type, types);
  if (!scalar || argument.kind == Argument::Kind::kString) return mismatch();
  bool splat = argument.kind == Argument::Kind::kNumber && ir::IsVector(type);
  bool list = argument.kind == Argument::Kind::kVector && !ir::IsScalar(type);
  if (list && !HasNumbers(argument, type, types)) return mismatch();
  if (list) type = WithLength(argument, type, module.types);
  std::array<uint32_t, 16> few;
  std::vector<uint32_t> many(types.Words(type) > few.size() ? types.Words(type) : 0);
  const std::span<uint32_t> words(many.empty() ? few.data() : many.data(), types.Words(type));
  std::ranges::fill(words, argument.boolean ? 1 : 0);
  if (argument.kind == Argument::Kind::kBool) {
    if (!LiteralCost(argument, type, types)) return mismatch();
    return module.Intern(type, words);
  }
  if (!splat && !list) return mismatch();
  for (size_t i = 0; i < words.size(); ++i) {
    double number = argument.numbers[splat ? 0 : i];
    uint32_t& word = words[ir::IsMatrix(type) ? MatrixWord(i, ir::MatrixSize(type)) : i];
    switch (Encode(number, argument.is_integer, *scalar, word)) {
      case Encoding::kFits:
        break;
      case Encoding::kUnderflow:
        diagnostics.Warn(
            DiagnosticKind::kNumberUnderflow, argument.range,
            fmt::format("{} is too small for a float and becomes 0", NumberText(number)));
        break;
      case Encoding::kOutOfRange:
        place.AddNote(
            diagnostics.Error(DiagnosticKind::kNumberRange, argument.range,
                              fmt::format("{} takes {}; {} is out of its range", place.Text(),
                                          types.Text(wanted), NumberText(number))));
        return std::nullopt;
      case Encoding::kWrongKind:
        return mismatch();
    }
  }
  return module.Intern(type, words);
}

ir::ConstId ConvertConstant(ir::ConstId constant, ir::TypeId type, ir::Module& module) {
  ir::TypeId from = module.constant(constant).type;
  if (from == type) return constant;
  uint32_t word = module.Words(constant)[0];
  if (ir::ScalarOf(from) == ir::Scalar::kInt && ir::ScalarOf(type) == ir::Scalar::kFloat) {
    word = std::bit_cast<uint32_t>(static_cast<float>(static_cast<int32_t>(word)));
  }
  std::vector<uint32_t> words(module.types.Words(type), word);
  return module.Intern(type, words);
}

bool CheckLength(ir::ConstId constant, uint32_t minimum, uint32_t maximum, SourceRange range,
                 const Place& place, const ir::Module& module, Diagnostics& diagnostics) {
  ir::TypeId type = module.constant(constant).type;
  if (module.types.Kind(type) != ir::TypeKind::kArray) return true;
  uint32_t length = module.types.ElementCount(type);
  if (length >= minimum && length <= maximum) return true;
  DiagnosticKind kind =
      length > blocks::kMaxArrayLength ? DiagnosticKind::kSizeLimit : DiagnosticKind::kValueRange;
  place.AddNote(diagnostics.Error(
      kind, range,
      fmt::format("{} takes {} to {} elements, got {}", place.Text(), minimum, maximum, length)));
  return false;
}

bool CheckLimits(ir::ConstId constant, const ValueLimits& limits, SourceRange range,
                 const Place& place, const ir::Module& module, Diagnostics& diagnostics) {
  if (!limits.minimum && !limits.maximum) return true;
  std::optional<ir::Scalar> scalar = ScalarOfWords(module.constant(constant).type, module.types);
  if (!scalar || *scalar == ir::Scalar::kBool) return true;
  // Limits are compared as what the value is: 0.1 is not above the limit 0.1 for being a float.
  auto rounded = [&](double limit) {
    bool as_float = *scalar == ir::Scalar::kFloat && std::fabs(limit) <= kLargestFloat;
    return as_float ? static_cast<double>(static_cast<float>(limit)) : limit;
  };
  for (uint32_t word : module.Words(constant)) {
    double value = ir::NumberOf(*scalar, word);
    bool below = limits.minimum && value < rounded(*limits.minimum);
    bool above = limits.maximum && value > rounded(*limits.maximum);
    if (!below && !above) continue;
    std::string bounds =
        limits.minimum && limits.maximum
            ? fmt::format("from {} to {}", NumberText(*limits.minimum), NumberText(*limits.maximum))
        : limits.minimum ? fmt::format("from {} on", NumberText(*limits.minimum))
                         : fmt::format("up to {}", NumberText(*limits.maximum));
    std::string shown = *scalar == ir::Scalar::kFloat ? fmt::format("{}", static_cast<float>(value))
                                                      : NumberText(value);
    place.AddNote(
        diagnostics.Error(DiagnosticKind::kValueRange, range,
                          fmt::format("{} takes values {}, got {}", place.Text(), bounds, shown)));
    return false;
  }
  return true;
}

}  // namespace texgraph::graph
