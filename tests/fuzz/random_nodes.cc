// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/random_nodes.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace texgraph::fuzz {
namespace {

using blocks::Overload;
using blocks::Port;
using blocks::PortKind;
using graph::Argument;

constexpr int kAttempts = 100;  // to find a block whose ports can all be bound
// Where a range goes beyond: what pictures have, and what loops within loops can go round.
constexpr double kMost = 64, kMostWhole = 5;
constexpr uint32_t kDeep = 6;         // deeper is no better
constexpr uint32_t kDynamicInt = 12;  // one in so many whole numbers with limits is connected

bool IsWhole(ir::TypeId type) { return ir::IsVector(type) && ir::IsInteger(type); }

}  // namespace

void RandomNodes::AddOutputs(const std::string& node, const std::vector<Port>& outputs,
                             const Thing& like) {
  for (size_t i = 0; i < outputs.size(); ++i) {
    Thing thing = like;
    thing.reference = node;
    // A plain name means the only output, or the return value.
    const bool plain = outputs.size() == 1 || (i == 0 && outputs[0].name == "result");
    if (!plain || OneIn(6)) thing.reference += "." + outputs[i].name;
    thing.type = outputs[i].type;
    AddThing(std::move(thing));
  }
}

// A number near the default, or within the range; multiples of 1/64 more often than not.
double RandomNodes::Number(const Port& port, ir::Scalar scalar, size_t component) {
  double low = -1, high = 2;
  if (port.minimum && port.maximum) {
    low = *port.minimum;
    const double most = scalar == ir::Scalar::kFloat ? kMost : kMostWhole;
    high = std::min(*port.maximum, std::max(low + 1, most));
  } else if (port.default_value.valid()) {
    const auto words = catalog_.Words(port.default_value);
    const double value = scalar == ir::Scalar::kFloat
                             ? std::bit_cast<float>(words[component % words.size()])
                             : static_cast<int32_t>(words[component % words.size()]);
    low = value == 0 ? 0 : value / 2;
    high = value == 0 ? 1 : value * 2;
    if (low > high) std::swap(low, high);
  }
  if (scalar == ir::Scalar::kFloat) {
    if (OneIn(6)) return OneIn(2) ? low : high;
    const double share = Below(1 << 16) / 65536.0;
    const double value = low + (high - low) * share * share;
    if (OneIn(4)) return static_cast<float>(value);
    return std::clamp(std::round(value * 64) / 64, low, high);
  }
  if (scalar == ir::Scalar::kUint) low = std::max(low, 0.0);
  const double first = std::ceil(low), last = std::max(first, std::floor(high));
  // More often a small one: several counts of a block multiply.
  const uint32_t count = static_cast<uint32_t>(last - first) + 1;
  return first + std::min(Below(count), Below(count));
}

std::optional<Argument> RandomNodes::Literal(const Port& port) {
  const ir::TypeId type = port.kind == PortKind::kField ? catalog_.FieldResult(port) : port.type;
  Argument literal;
  if (!port.words.empty()) {
    const blocks::EnumWord& word = port.words[Below(static_cast<uint32_t>(port.words.size()))];
    literal.kind = Argument::Kind::kString;
    literal.text = word.word;
    if (OneIn(8)) {
      literal.kind = Argument::Kind::kNumber;
      literal.numbers = {static_cast<double>(word.value)};
      literal.is_integer = true;
    }
    return literal;
  }
  if (port.max_length > 0) {
    const uint32_t most = std::min(port.max_length, OneIn(16) ? 100u : 12u);
    return List(port,
                port.min_length + Below(std::max(most, port.min_length) - port.min_length + 1));
  }
  const bool vector = ir::IsVector(type);
  if (!vector && !ir::IsMatrix(type)) return std::nullopt;
  if (ir::IsBool(type)) {
    literal.kind = Argument::Kind::kBool;
    literal.boolean = OneIn(2);
    return literal;
  }
  const ir::Scalar scalar = vector ? ir::ScalarOf(type) : ir::Scalar::kFloat;
  const bool splat = vector && (ir::IsScalar(type) || OneIn(4));
  const size_t count = splat ? 1 : catalog_.types().Words(type);
  literal.kind = splat ? Argument::Kind::kNumber : Argument::Kind::kVector;
  std::vector<double> numbers;
  for (size_t i = 0; i < count; ++i) numbers.push_back(Number(port, scalar, i));
  if (port.ordered) std::ranges::sort(numbers);
  if (port.multiple_of) {
    for (double& number : numbers) number *= kMapMultiple;
  }
  for (double number : numbers) literal.numbers.push_back(number);
  // Whole numbers stand for floats, too; then all are written without a point.
  const bool all_whole = std::ranges::all_of(
      literal.numbers, [](double number) { return number == std::floor(number); });
  literal.is_integer = scalar != ir::Scalar::kFloat || (all_whole && OneIn(2));
  return literal;
}

// Few elements more often than as many as it may have. Whole numbers are what a path's points tell
// themselves apart by.
Argument RandomNodes::List(const Port& port, uint32_t length) {
  const ir::TypeId element = catalog_.types().ElementType(port.type, 0);
  const bool whole = OneIn(4);
  Argument list;
  list.kind = Argument::Kind::kVector;
  list.columns = ir::IsScalar(element) ? 0 : ir::Width(element);
  for (uint32_t i = 0; i < length * ir::Width(element); ++i) {
    const double number = Number(port, ir::ScalarOf(element), i);
    const bool kind = list.columns == 3 && i % 3 == 2;
    list.numbers.push_back(kind ? Below(3) : whole ? std::floor(number) : number);
  }
  list.is_integer = ir::ScalarOf(element) != ir::Scalar::kFloat || whole;
  return list;
}

// A pattern for all corners, of as many families as there are.
std::optional<Argument> RandomNodes::Transitions(const Port& families,
                                                 std::span<const PortArgument> arguments) {
  const size_t count = catalog_.FamilyCount(families, arguments);
  if (count == 0) return std::nullopt;
  Argument list;
  list.kind = Argument::Kind::kVector;
  list.is_integer = true;
  for (size_t i = 0; i < count * count * count * count; ++i) list.numbers.push_back(Below(32));
  return list;
}

std::optional<Argument> RandomNodes::Following(const Overload& overload, const Port& port,
                                               std::span<const PortArgument> arguments) {
  if (port.transitions_of) return Transitions(overload.inputs[*port.transitions_of], arguments);
  if (!port.as_long_as) return std::nullopt;
  const uint32_t length = catalog_.ListLength(overload.inputs[*port.as_long_as], arguments);
  if (length == 0) return std::nullopt;
  return List(port, length);
}

Tree RandomNodes::TreeOf(const Argument& literal, bool is_list) {
  const auto number = [&](double value) {
    if (literal.is_integer) return Tree::Raw(fmt::format("{:.0f}", value));
    std::string text = fmt::format("{}", value);
    return Tree::Raw(text.find_first_of(".e") == std::string::npos ? text + ".0" : text);
  };
  switch (literal.kind) {
    case Argument::Kind::kBool:
      return Tree::Bool(literal.boolean);
    case Argument::Kind::kString:
      return Tree::String(literal.text);
    case Argument::Kind::kNumber:
      return number(literal.numbers[0]);
    case Argument::Kind::kVector:
      break;
  }
  Tree array = Tree::Array();
  const size_t count = literal.numbers.size();
  // Matrices, row by row; lists of vectors.
  size_t side = literal.columns;
  if (side == 0 && !is_list) side = count == 9 ? 3 : count == 16 ? 4 : 0;
  Tree* row = &array;
  for (size_t i = 0; i < count; ++i) {
    if (side > 0 && i % side == 0) row = &array.Add(Tree::Array());
    row->Add(number(literal.numbers[i]));
  }
  return array;
}

// Documented limits hold for what is connected as far as that is known. A whole number with limits
// is what divides and counts.
bool RandomNodes::MayStand(const Port& port, const Thing& thing) {
  if (!catalog_.Cost(port, thing)) return false;
  if (thing.kind == Thing::Kind::kConstant) return catalog_.WithinLimits(port, thing.literal);
  if (thing.kind != Thing::Kind::kValue || !port.minimum || !port.maximum) return true;
  if (thing.bounded) return thing.minimum >= *port.minimum && thing.maximum <= *port.maximum;
  return !IsWhole(port.type) || OneIn(kDynamicInt);
}

// What varies and is deep rather than what is plain, so that graphs are not folded away.
const Thing* RandomNodes::Pick(const Port& port) {
  std::vector<const Thing*> fitting;
  std::vector<uint32_t> weights;
  uint32_t total = 0;
  for (const Thing& thing : things_) {
    if (!MayStand(port, thing)) continue;
    const bool picture =
        thing.kind == Thing::Kind::kTexture || thing.kind == Thing::Kind::kFunction;
    uint32_t weight = picture ? 12 : thing.varies ? 4 : 1;
    weight *= 1 + std::min(thing.depth, kDeep) * std::min(thing.depth, kDeep);
    fitting.push_back(&thing);
    weights.push_back(weight);
    total += weight;
  }
  if (fitting.empty()) return nullptr;
  uint32_t at = Below(total);
  size_t i = 0;
  while (at >= weights[i]) at -= weights[i++];
  return fitting[i];
}

std::optional<Tree> RandomNodes::MakeArgument(const Port& port, uint32_t connected,
                                              PortArgument& argument) {
  argument.port = port.name;
  if (Below(10) < connected || port.kind == PortKind::kTexture) argument.thing = Pick(port);
  if (!argument.thing) {
    if (std::optional<Argument> literal = Literal(port)) {
      argument.literal = *literal;
      return TreeOf(argument.literal, port.max_length > 0);
    }
    argument.thing = Pick(port);
  }
  if (!argument.thing) return std::nullopt;
  return Tree::String(argument.thing->reference);
}

std::optional<Tree> RandomNodes::Bind(std::span<const Overload> overloads, const Overload& meant,
                                      const Overload** chosen, Thing& result) {
  Tree in = Tree::Object();
  std::vector<PortArgument> arguments;
  for (const Port& port : meant.inputs) {
    if (!IsRequired(port) && OneIn(2)) {
      result.varies = result.varies || !port.default_input.empty();
      continue;
    }
    PortArgument argument;
    const bool is_template = port.kind == PortKind::kTemplate;
    const std::optional<Argument> following = Following(meant, port, arguments);
    std::optional<Tree> tree;
    if (following) {
      argument.port = port.name;
      argument.literal = *following;
      tree = TreeOf(argument.literal, true);
    } else {
      tree = MakeArgument(port, is_template ? 3 : 8, argument);
    }
    if (!tree && IsRequired(port)) return std::nullopt;
    if (!tree) continue;
    in.Set(port.name, std::move(*tree));
    if (argument.thing) {
      result.varies = result.varies || argument.thing->varies;
      result.depth = std::max(result.depth, argument.thing->depth);
    }
    arguments.push_back(std::move(argument));
  }
  ++result.depth;
  *chosen = catalog_.Choose(overloads, arguments);
  if (!*chosen) return std::nullopt;
  // The overload that is chosen may have other limits than the one that was meant.
  for (const PortArgument& argument : arguments) {
    auto port = std::ranges::find((*chosen)->inputs, argument.port, &Port::name);
    const Argument* known = !argument.thing ? &argument.literal
                            : argument.thing->kind == Thing::Kind::kConstant
                                ? &argument.thing->literal
                                : nullptr;
    if (known && !catalog_.WithinLimits(*port, *known)) return std::nullopt;
  }
  if (!catalog_.KeepsOrder(**chosen, arguments)) return std::nullopt;
  std::shuffle(in.children.begin(), in.children.end(), random_);
  return in;
}

bool RandomNodes::Fulfils(const Overload& overload, Wish wish) const {
  const auto is_struct = [&](const Port& port) {
    return catalog_.types().Kind(port.type) == ir::TypeKind::kStruct;
  };
  const auto is_picture = [&](const Port& port) {
    return port.kind == PortKind::kTexture || port.kind == PortKind::kField;
  };
  if (wish == Wish::kAny) return true;
  if (wish == Wish::kPictures) return std::ranges::any_of(overload.inputs, is_picture);
  return std::ranges::any_of(overload.inputs, is_struct) ||
         std::ranges::any_of(overload.outputs, is_struct);
}

std::optional<Tree> RandomNodes::Attempt(const std::string& name, Wish wish) {
  const Overload* chosen = nullptr;
  std::string block_name;
  std::optional<Tree> in;
  Thing result;
  if (!functions_.empty() && OneIn(6)) {
    const GraphFunction& function = functions_[Below(static_cast<uint32_t>(functions_.size()))];
    block_name = function.name;
    in = Bind({&function.signature, 1}, function.signature, &chosen, result);
  } else {
    const auto& blocks = catalog_.blocks();
    const blocks::Block& block = *blocks[Below(static_cast<uint32_t>(blocks.size()))];
    const Overload& meant = block.overloads[Below(static_cast<uint32_t>(block.overloads.size()))];
    if (!catalog_.Usable(meant) || !Fulfils(meant, wish) || shadowed_.contains(block.name)) {
      return std::nullopt;
    }
    block_name = block.name;
    in = Bind(block.overloads, meant, &chosen, result);
  }
  // Most of what is the same everywhere would be folded away, and the rest is soon tested.
  if (!in || (!result.varies && !OneIn(8))) return std::nullopt;
  Tree node = Tree::Object();
  node.Set("block", Tree::String(block_name));
  if (!in->empty() || OneIn(2)) node.Set("in", std::move(*in));
  if (!shadowed_.contains(block_name)) used_blocks_.insert(block_name);
  AddOutputs(name, chosen->outputs, result);
  return node;
}

std::optional<Tree> RandomNodes::MakeNode(const std::string& name) {
  const uint32_t kind = Below(6);
  const Wish wish = kind == 0 ? Wish::kStructs : kind == 1 ? Wish::kPictures : Wish::kAny;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    if (std::optional<Tree> node = Attempt(name, wish)) return node;
  }
  return std::nullopt;
}

}  // namespace texgraph::fuzz
