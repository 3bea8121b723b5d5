// SPDX-License-Identifier: Apache-2.0
// Numbers of patterns and materials that are known when the shader is made must be there
// ("@below"). They are followed from literals, lists, counts and maps through the blocks that hand
// them on
// ("@one_of"); what is computed in between is not known, and not reported.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "compiler/graph/checked_graph.h"

namespace texgraph::graph {
namespace {

struct InputOfNode {
  uint32_t node, input;
  bool operator==(const InputOfNode&) const = default;
};

// How many there are, 0 if that is not known, and of what.
struct Count {
  int64_t count = 0;
  std::string text;
};

// The greatest number that stands somewhere; -1 if there is none.
int64_t Greatest(std::span<const int32_t> numbers) {
  int64_t greatest = -1;
  for (int32_t number : numbers) greatest = std::max<int64_t>(greatest, number);
  return greatest;
}

// A number, and the input that it stands at.
struct Number {
  int64_t number = -1;
  InputOfNode origin{};
};

// Each node is looked at once, in the order in which one needs the other.
class RangeChecker {
 public:
  RangeChecker(const CheckedGraph& graph, const CheckedSubgraph& subgraph,
               const std::vector<int64_t>& of_textures, const ir::Module& module,
               Diagnostics& diagnostics)
      : graph_(graph),
        subgraph_(subgraph),
        of_textures_(of_textures),
        module_(module),
        diagnostics_(diagnostics) {}

  void Check() {
    for (uint32_t n = 0; n < subgraph_.nodes.size(); ++n) {
      const CheckedNode& node = subgraph_.nodes[n];
      if (!node.block) continue;
      for (uint32_t i = 0; i < node.inputs.size(); ++i) {
        if (node.overload->inputs[i].below) CheckPort({n, i});
      }
      const std::vector<blocks::Port>& outputs = node.overload->outputs;
      for (uint32_t o = 0; o < outputs.size(); ++o) {
        Number greatest;
        for (uint32_t input : outputs[o].one_of) {
          const Number number = GreatestAt({n, input});
          if (number.number > greatest.number) greatest = number;
        }
        if (greatest.number >= 0) of_outputs_[{n, o}] = greatest;
      }
    }
  }

 private:
  const Texture& TextureOf(const TextureRef& ref) const {
    return graph_.graph->textures[ref.texture];
  }

  Count CountOf(const CheckedNode& node, uint32_t input) const {
    const Source& source = node.inputs[input].source;
    const blocks::Port& port = node.overload->inputs[input];
    if (port.grid_of) {
      const Count patterns = CountOf(node, *port.grid_of);
      if (patterns.count > 0) return patterns;
    }
    if (const auto* ref = std::get_if<TextureRef>(&source)) {
      const Texture& texture = TextureOf(*ref);
      if (texture.HasPatterns()) {
        return {texture.PatternCount(), fmt::format("the patterns of '{}'", texture.name)};
      }
      if (texture.kind != TextureKind::kLists) return {};
      return {texture.map.height, fmt::format("the lists of '{}'", texture.name)};
    }
    const auto* constant = std::get_if<ConstantValue>(&source);
    if (!constant || !constant->value) return {};
    const std::span<const uint32_t> words = module_.Words(constant->value);
    if (port.max_length > 0) {
      return {static_cast<int64_t>(words.size()), fmt::format("the elements of '{}'", port.name)};
    }
    int64_t count = 1;
    for (uint32_t word : words) count *= static_cast<int32_t>(word);
    return {count, fmt::format("as '{}' says", port.name)};
  }

  // The greatest number that is known to come to an input.
  Number GreatestAt(InputOfNode at) const {
    const CheckedNode& node = subgraph_.nodes[at.node];
    const Source& source = node.inputs[at.input].source;
    const blocks::Port& port = node.overload->inputs[at.input];
    const auto* output = std::get_if<NodeOutput>(&source);
    if (const auto* field = std::get_if<FieldOfNode>(&source)) output = &field->source;
    if (output) {
      const auto known = of_outputs_.find({output->node, output->output});
      return known == of_outputs_.end() ? Number{} : known->second;
    }
    if (const auto* ref = std::get_if<TextureRef>(&source)) return {of_textures_[ref->texture], at};
    ir::ConstId value;
    if (const auto* constant = std::get_if<ConstantValue>(&source)) value = constant->value;
    if (const auto* constant = std::get_if<FieldOfConstant>(&source)) value = constant->value;
    if (!value) return {};
    std::vector<int32_t> numbers;
    for (uint32_t word : module_.Words(value)) numbers.push_back(static_cast<int32_t>(word));
    if (port.transitions_of) DropPlain(numbers);
    const bool is_count = port.kind == blocks::PortKind::kTemplate && port.max_length == 0;
    return {Greatest(numbers) - (is_count ? 1 : 0), at};
  }

  // Of m^4 transitions, those of four corners of one family, f (1 + m + m^2 + m^3), are not shown.
  static void DropPlain(std::vector<int32_t>& numbers) {
    size_t m = 1;
    while (m * m * m * m < numbers.size()) ++m;
    for (size_t i = 0; i < numbers.size(); i += 1 + m + m * m + m * m * m) numbers[i] = -1;
  }

  void CheckPort(InputOfNode port) {
    const CheckedNode& node = subgraph_.nodes[port.node];
    const Count limit = CountOf(node, *node.overload->inputs[port.input].below);
    const Number greatest = GreatestAt(port);
    if (limit.count > 0 && greatest.number >= limit.count) Report(port, limit, greatest);
  }

  void Report(InputOfNode port, const Count& limit, const Number& number) {
    const CheckedNode& node = subgraph_.nodes[port.node];
    const CheckedNode& from = subgraph_.nodes[number.origin.node];
    const BoundPort& bound = from.inputs[number.origin.input];
    Diagnostic& error =
        diagnostics_.Error(DiagnosticKind::kPatternRange, node.inputs[port.input].range,
                           fmt::format("port '{}' of node '{}' takes 0 to {}, {}; it gets {}",
                                       node.overload->inputs[port.input].name, node.node->name,
                                       limit.count - 1, limit.text, number.number));
    if (number.origin == port) return;
    error.AddNote(bound.range,
                  fmt::format("{} comes from port '{}' of node '{}'", number.number,
                              from.overload->inputs[number.origin.input].name, from.node->name));
  }

  const CheckedGraph& graph_;
  const CheckedSubgraph& subgraph_;
  const std::vector<int64_t>& of_textures_;
  const ir::Module& module_;
  Diagnostics& diagnostics_;
  std::map<std::pair<uint32_t, uint32_t>, Number> of_outputs_;  // by node and output
};

int64_t GreatestOf(const Texture& texture) {
  int64_t greatest = Greatest(texture.map.numbers);
  for (const Sprite& sprite : texture.sprites.sprites) {
    greatest = std::max<int64_t>(greatest, sprite.pattern);
  }
  return greatest;
}

}  // namespace

void CheckPatternRanges(const CheckedGraph& graph, const ir::Module& module,
                        Diagnostics& diagnostics) {
  std::vector<int64_t> of_textures;
  for (const Texture& texture : graph.graph->textures) of_textures.push_back(GreatestOf(texture));
  for (const CheckedSubgraph& function : graph.functions) {
    RangeChecker(graph, function, of_textures, module, diagnostics).Check();
  }
  RangeChecker(graph, graph.main, of_textures, module, diagnostics).Check();
}

}  // namespace texgraph::graph
