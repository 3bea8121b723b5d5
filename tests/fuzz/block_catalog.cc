// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/block_catalog.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "compiler/graph/conversion.h"
#include "compiler/graph/literal.h"

namespace texgraph::fuzz {

using blocks::Overload;
using blocks::Port;
using blocks::PortKind;
using graph::ConversionCost;

BlockCatalog& BlockCatalog::Instance() {
  static BlockCatalog catalog;
  return catalog;
}

BlockCatalog::BlockCatalog() : library_(module_, sources_, diagnostics_) {
  for (std::string_view name : library_.Names()) {
    const blocks::Block* block = library_.Find(name);
    bool usable = block && std::ranges::any_of(block->overloads, [&](const Overload& overload) {
                    return Usable(overload);
                  });
    if (usable) blocks_.push_back(block);
  }
}

bool BlockCatalog::Usable(const Overload& overload) const {
  return std::ranges::none_of(overload.inputs, [](const Port& port) {
    return port.kind == PortKind::kTexture && port.type == ir::kSampler3D;
  });
}

ir::TypeId BlockCatalog::FieldResult(const Port& port) const {
  return module_.types.ValueOf(port.type);
}

std::span<const ir::TypeId> BlockCatalog::FieldParameters(const Port& port) const {
  return std::span(module_.types[port.type].elements).subspan(1);
}

std::optional<int> BlockCatalog::Cost(const Port& port, const Thing& thing) const {
  const bool field = port.kind == PortKind::kField;
  const ir::TypeId wanted = field ? FieldResult(port) : port.type;
  switch (thing.kind) {
    case Thing::Kind::kTexture: {
      if (port.kind == PortKind::kTexture) {
        return port.type == thing.type ? std::optional<int>(0) : std::nullopt;
      }
      if (!field || FieldParameters(port).empty()) return std::nullopt;
      const ir::TypeId place = thing.type == ir::kSampler2D ? ir::kVec2 : ir::kVec3;
      if (FieldParameters(port)[0] != place) return std::nullopt;
      return ConversionCost(ir::kVec4, wanted);
    }
    case Thing::Kind::kFunction:
      if (!field || !FunctionFits(port, *thing.function)) return std::nullopt;
      return ConversionCost(thing.type, wanted);
    case Thing::Kind::kConstant:
      if (port.kind == PortKind::kTexture) return std::nullopt;
      return ConversionCost(thing.type, wanted);
    case Thing::Kind::kValue:
      // The choice between overloads does not look at what stands at template ports; it is an error
      // there whatever its type.
      if (port.kind == PortKind::kTexture || port.kind == PortKind::kTemplate) return std::nullopt;
      return ConversionCost(thing.type, wanted);
  }
  return std::nullopt;
}

std::optional<int> BlockCatalog::Cost(const Port& port, const graph::Argument& literal) const {
  if (port.kind == PortKind::kTexture) return std::nullopt;
  if (literal.kind == graph::Argument::Kind::kString) {  // a word
    const bool known =
        port.kind == PortKind::kTemplate &&
        std::ranges::find(port.words, literal.text, &blocks::EnumWord::word) != port.words.end();
    return known ? std::optional<int>(0) : std::nullopt;
  }
  const ir::TypeId wanted = port.kind == PortKind::kField ? FieldResult(port) : port.type;
  return LiteralCost(literal, wanted, module_.types);
}

// Parameters of the prototype go to the function's inputs of their names, then to the first free
// ones of their types; the rest need defaults.
bool BlockCatalog::FunctionFits(const Port& port, const Overload& function) const {
  const std::span<const ir::TypeId> types = FieldParameters(port);
  std::vector<bool> given(function.inputs.size()), taken(types.size());
  for (size_t i = 0; i < function.inputs.size(); ++i) {
    for (size_t p = 0; p < types.size(); ++p) {
      if (port.field_parameters[p] != function.inputs[i].name) continue;
      if (!ConversionCost(types[p], function.inputs[i].type)) return false;
      given[i] = taken[p] = true;
    }
  }
  for (size_t p = 0; p < types.size(); ++p) {
    for (size_t i = 0; i < given.size() && !taken[p]; ++i) {
      if (given[i] || function.inputs[i].type != types[p]) continue;
      given[i] = taken[p] = true;
    }
  }
  for (size_t i = 0; i < given.size(); ++i) {
    if (!given[i] && IsRequired(function.inputs[i])) return false;
  }
  return true;
}

const Overload* BlockCatalog::Choose(std::span<const Overload> overloads,
                                     std::span<const PortArgument> arguments) const {
  const Overload* best = nullptr;
  int best_cost = 0;
  for (const Overload& overload : overloads) {
    bool fits = true;
    int total = 0;
    for (const PortArgument& argument : arguments) {
      auto port = std::ranges::find(overload.inputs, argument.port, &Port::name);
      std::optional<int> cost;
      if (port != overload.inputs.end()) {
        cost = argument.thing ? Cost(*port, *argument.thing) : Cost(*port, argument.literal);
      }
      fits = fits && cost;
      total += cost.value_or(0);
    }
    for (const Port& port : overload.inputs) {
      if (!IsRequired(port)) continue;
      auto argument = std::ranges::find(arguments, port.name, &PortArgument::port);
      fits = fits && argument != arguments.end();
    }
    if (!fits || (best && total >= best_cost)) continue;
    best = &overload;
    best_cost = total;
  }
  return best;
}

bool BlockCatalog::WithinLimits(const Port& port, const graph::Argument& literal) const {
  if (port.max_length > 0) {
    const size_t length = literal.numbers.size() / std::max(literal.columns, 1u);
    if (length < port.min_length || length > port.max_length) return false;
  }
  for (double number : literal.numbers) {
    const auto value = static_cast<float>(number);
    if (port.minimum && value < static_cast<float>(*port.minimum)) return false;
    if (port.maximum && value > static_cast<float>(*port.maximum)) return false;
    const bool known =
        port.words.empty() || std::ranges::any_of(port.words, [&](const blocks::EnumWord& word) {
          return word.value == number;
        });
    if (!known) return false;
  }
  return !port.ordered || std::ranges::is_sorted(literal.numbers);
}

// One number for each component; none if they are not known when the shader is made.
std::vector<float> BlockCatalog::Known(const Port& port,
                                       std::span<const PortArgument> arguments) const {
  std::vector<float> known;
  const ir::TypeId type = types().ValueOf(port.type);
  auto argument = std::ranges::find(arguments, port.name, &PortArgument::port);
  if (argument == arguments.end()) {
    if (!port.default_value.valid()) return known;
    for (uint32_t word : Words(port.default_value)) {
      known.push_back(ir::IsFloat(type) ? std::bit_cast<float>(word)
                                        : static_cast<float>(static_cast<int32_t>(word)));
    }
    return known;
  }
  if (argument->thing && argument->thing->kind != Thing::Kind::kConstant) return known;
  const graph::Argument& literal = argument->thing ? argument->thing->literal : argument->literal;
  const size_t width = ir::Width(type);
  for (size_t i = 0; i < width; ++i) {
    known.push_back(static_cast<float>(literal.numbers[literal.numbers.size() == width ? i : 0]));
  }
  return known;
}

size_t BlockCatalog::FamilyCount(const Port& families,
                                 std::span<const PortArgument> arguments) const {
  auto argument = std::ranges::find(arguments, families.name, &PortArgument::port);
  if (argument == arguments.end() || argument->thing) return 0;
  return static_cast<size_t>(std::ranges::max(argument->literal.numbers)) + 1;
}

uint32_t BlockCatalog::ListLength(const Port& list, std::span<const PortArgument> arguments) const {
  auto argument = std::ranges::find(arguments, list.name, &PortArgument::port);
  if (argument == arguments.end() || argument->thing) return 0;
  const size_t width = ir::Width(types().ElementType(list.type, 0));
  return static_cast<uint32_t>(argument->literal.numbers.size() / width);
}

bool BlockCatalog::KeepsOrder(const Overload& overload,
                              std::span<const PortArgument> arguments) const {
  for (const Port& port : overload.inputs) {
    if (port.multiple_of) {
      for (float number : Known(port, arguments)) {
        if (std::fmod(number, kMapMultiple) != 0) return false;
      }
    }
    if (port.as_long_as) {
      const uint32_t length = ListLength(port, arguments);
      if (length == 0 || length != ListLength(overload.inputs[*port.as_long_as], arguments)) {
        return false;
      }
    }
    if (port.transitions_of) {
      // Other lists than those that were made for these families seldom fit.
      const size_t count = FamilyCount(overload.inputs[*port.transitions_of], arguments);
      auto argument = std::ranges::find(arguments, port.name, &PortArgument::port);
      if (argument == arguments.end() || argument->thing) return false;
      const auto& numbers = argument->literal.numbers;
      if (numbers.size() != count * count * count * count) return false;
      if (std::ranges::any_of(numbers, [](double number) { return number < 0; })) return false;
    }
    if (!port.not_below) continue;
    const std::vector<float> least = Known(overload.inputs[*port.not_below], arguments);
    const std::vector<float> most = Known(port, arguments);
    for (size_t i = 0; i < std::min(least.size(), most.size()); ++i) {
      if (most[i] < least[i]) return false;
    }
  }
  return true;
}

}  // namespace texgraph::fuzz
