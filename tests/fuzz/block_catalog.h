// SPDX-License-Identifier: Apache-2.0
// The signatures of the whole library, read once, and the rules of docs/graph-format.md for what
// may stand at a port.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compiler/blocks/block.h"
#include "compiler/graph/graph.h"
#include "compiler/ir/module.h"

namespace texgraph::fuzz {

// What can be connected to a port.
struct Thing {
  enum class Kind { kValue, kConstant, kTexture, kFunction };  // kConstant: a constant parameter
  Kind kind = Kind::kValue;
  std::string reference;            // "uv", "grid.tile"
  ir::TypeId type;                  // of the value; of a function's output; kTexture: the sampler's
  graph::Argument literal;          // kConstant: its value
  double minimum = 0, maximum = 0;  // kValue: limits, if bounded
  bool bounded = false;
  uint32_t depth = 0;                          // of nodes that it depends on
  bool varies = false;                         // from pixel to pixel
  const blocks::Overload* function = nullptr;  // kFunction: its inputs
};

// A multiple of the columns and rows of every map that random graphs have, 1 to 4.
inline constexpr double kMapMultiple = 12;

// What stands at a port: one of the two.
struct PortArgument {
  std::string port;
  const Thing* thing = nullptr;
  graph::Argument literal;
};

class BlockCatalog {
 public:
  static BlockCatalog& Instance();

  const std::vector<const blocks::Block*>& blocks() const { return blocks_; }
  const ir::Types& types() const { return module_.types; }
  std::span<const uint32_t> Words(ir::ConstId id) const { return module_.Words(id); }
  // Whether a graph can have a node of this overload: nothing of its ports is beyond graphs.
  bool Usable(const blocks::Overload& overload) const;

  // How many conversions it takes; nothing if it cannot stand there.
  std::optional<int> Cost(const blocks::Port& port, const Thing& thing) const;
  std::optional<int> Cost(const blocks::Port& port, const graph::Argument& literal) const;
  // The overload that a node with these arguments means; null if none.
  const blocks::Overload* Choose(std::span<const blocks::Overload> overloads,
                                 std::span<const PortArgument> arguments) const;
  // Whether a value that is known lies within the port's limits and words.
  bool WithinLimits(const blocks::Port& port, const graph::Argument& literal) const;
  // One more than the greatest of a list of whole numbers that stands at the port; 0 if none does.
  size_t FamilyCount(const blocks::Port& families, std::span<const PortArgument> arguments) const;
  // How many elements the list at the port has; 0 if it is none that is written there.
  uint32_t ListLength(const blocks::Port& list, std::span<const PortArgument> arguments) const;
  // Whether no greatest value that is known lies below its least, and what goes by another port's
  // value does.
  bool KeepsOrder(const blocks::Overload& overload, std::span<const PortArgument> arguments) const;

  ir::TypeId FieldResult(const blocks::Port& port) const;
  std::span<const ir::TypeId> FieldParameters(const blocks::Port& port) const;

 private:
  BlockCatalog();
  std::vector<float> Known(const blocks::Port& port, std::span<const PortArgument> arguments) const;
  bool FunctionFits(const blocks::Port& port, const blocks::Overload& function) const;

  ir::Module module_;
  Sources sources_;
  Diagnostics diagnostics_;
  blocks::Library library_;
  std::vector<const blocks::Block*> blocks_;
};

inline bool IsRequired(const blocks::Port& port) {
  return !port.default_value.valid() && port.default_input.empty() && port.default_block.empty();
}

}  // namespace texgraph::fuzz
