// SPDX-License-Identifier: Apache-2.0
// A graph as its document says it: names, literals and references with their ranges. It knows no
// blocks. docs/graph-format.md is the user's description, docs/graph.schema.json the formal one.
#pragma once

#include <array>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/base/builtin_input.h"
#include "compiler/base/diagnostics.h"
#include "compiler/base/source.h"
#include "compiler/graph/document.h"
#include "compiler/graph/texture.h"

namespace texgraph::graph {

// What stands at a port: a literal or, as a string, the name of a thing.
// The numbers of one value: one for a scalar, the components of a vector, a matrix row by row. Few
// need no memory of their own.
class Numbers {
 public:
  using value_type = double;
  using const_iterator = const double*;

  Numbers() = default;
  Numbers(std::initializer_list<double> numbers) {
    for (double number : numbers) push_back(number);
  }
  Numbers(const Numbers& other) { *this = other; }
  Numbers& operator=(const Numbers& other) {
    few_ = other.few_;
    many_ = other.many_ ? std::make_unique<std::vector<double>>(*other.many_) : nullptr;
    size_ = other.size_;
    return *this;
  }
  Numbers(Numbers&&) = default;
  Numbers& operator=(Numbers&&) = default;

  void push_back(double number) {
    if (size_ < few_.size()) {
      few_[size_] = number;
    } else {
      if (!many_) many_ = std::make_unique<std::vector<double>>(few_.begin(), few_.end());
      many_->push_back(number);
    }
    ++size_;
  }
  const double* begin() const { return many_ ? many_->data() : few_.data(); }
  const double* end() const { return begin() + size_; }
  size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  double operator[](size_t i) const { return begin()[i]; }

 private:
  std::array<double, 2> few_{};
  std::unique_ptr<std::vector<double>> many_;  // all of them, if they are more
  uint32_t size_ = 0;
};

struct Argument {
  enum class Kind : uint8_t { kNumber, kBool, kVector, kString };
  Kind kind = Kind::kNumber;
  bool boolean = false;
  bool is_integer = false;  // all numbers were written without '.' and exponent
  uint32_t columns = 0;     // kVector: the numbers in each row, 0 if there are no rows
  Numbers numbers;          // kNumber: one; kVector: all components
  std::string_view text;    // kString
  SourceRange range;
};

struct Input {  // "port": argument
  std::string_view port;
  SourceRange port_range;
  Argument argument;
};

struct Node {
  std::string_view name;
  SourceRange range;  // of the name
  std::string_view block;
  SourceRange block_range;
  std::vector<Input> inputs;
};

struct Output {  // "color": "face"
  std::string_view name;
  SourceRange range;
  Argument argument;
};

enum class Binding : uint8_t { kConstant, kSpecialization, kUniform };

struct Parameter {
  std::string_view name;
  SourceRange range;
  std::string_view type;  // "int", "vec3", ...
  SourceRange type_range;
  Argument value;
  std::optional<double> minimum, maximum;  // "range"
  Binding binding = Binding::kConstant;
  std::string_view label, help, unit;
};

struct FunctionInput {  // of a graph function: "scale": { "type": "float", "value": 1 } or "scale":
                        // "float"
  std::string_view name;
  SourceRange range;
  std::string_view type;
  SourceRange type_range;
  std::optional<Argument> value;
};

// A graph function ("functions"), or the graph itself (no inputs).
struct Subgraph {
  std::string_view name;
  SourceRange range;
  std::vector<FunctionInput> inputs;
  std::vector<Node> nodes;
  std::vector<Output>
      outputs;  // a function's may be any name; the graph's are color, normal, roughness, ...
};

struct Graph {
  std::string name;  // "name", else the file's name without extensions, made an identifier
  SourceRange range;
  std::string_view description;
  std::vector<Texture> textures;
  std::vector<Parameter> parameters;
  std::vector<Subgraph> functions;
  Subgraph main;
  Document document;  // owns what the views point into, beside the source text
};

using texgraph::BuiltinInput;
using texgraph::kBuiltinInputs;

// The outputs that a graph may have, and the types that they take.
struct BuiltinOutput {
  std::string_view name;
  std::string_view type;
};
inline constexpr BuiltinOutput kBuiltinOutputs[] = {
    {"color", "vec4"},   {"normal", "vec3"},   {"roughness", "float"}, {"metallic", "float"},
    {"height", "float"}, {"emission", "vec3"}, {"opacity", "float"},
};

// The first texture of the graph with the same texels and sampler state as texture `index`, perhaps
// itself. Equal textures share one sampler in the shader.
uint32_t FirstEqualTexture(const Graph& graph, uint32_t index);

// The texture with the patterns that the numbers of texture `index` lead to: itself if it has
// patterns, else by way of "of" and "means"; nothing if they lead to none.
std::optional<uint32_t> PatternsOf(const Graph& graph, uint32_t index);

// What a map's, lists' or sprites' numbers may be: 0 to count - 1, or -1. Nothing if it has no
// "of".
struct Reach {
  std::string_view things;  // "patterns", "lists"
  std::string_view name;    // of the texture that has them
  SourceRange range;
  uint32_t count = 0;
};
std::optional<Reach> ReachOf(const Graph& graph, const Texture& texture);
// "'mix' has 2 lists, 0 to 1; 7 is none of them"
std::string BeyondReach(const Reach& reach, int64_t number);

// Reads a document as a graph. Shape mistakes (unknown, missing and wrong keys, bad names, bad
// literals) are all reported; nothing is returned if there was any.
std::optional<Graph> ReadGraph(SourceId source, DocumentFormat format, const Sources& sources,
                               Diagnostics& diagnostics);

}  // namespace texgraph::graph
