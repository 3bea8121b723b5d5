// SPDX-License-Identifier: Apache-2.0
// Makes IR of checked functions: one IR function for each function, meaning of genType, and
// combination of template values that is called, and the functions that it calls before it. Here
// loops get their bounds, and recursion comes to light.
#pragma once

#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "compiler/blocks/file.h"
#include "compiler/ir/module.h"

namespace texgraph::blocks {

// A function that was lowered.
struct Lowered {
  ir::FunctionId id;  // invalid: something is wrong with it, which was reported
  std::vector<ir::ConstId>
      results;          // of each result its value, if it is the same for all arguments
  uint64_t rounds = 1;  // that its loops make at most, nested ones multiplied
};

class Lowering {
 public:
  Lowering(Program& program, bool fold) : program(program), fold(fold) {}

  // `values`: one for each template parameter. `caller` is where the call stands, if it is one.
  const Lowered& Function(File& file, uint32_t function, ir::TypeId gen_type,
                          std::span<const ir::ConstId> values, SourceRange caller);
  // Checks the bodies of the function and of all that it may call.
  void CheckReachable(File& file, uint32_t function, ir::TypeId gen_type);

  Program& program;
  const bool fold;
  uint32_t depth = 0;     // of the recursion through statements, expressions and calls
  bool too_deep = false;  // was reported

 private:
  struct Key {
    const File* file;
    uint32_t function;
    uint32_t variant;
    std::vector<ir::ConstId> values;
    auto operator<=>(const Key&) const = default;
  };
  bool Enter(const Key& key, SourceRange caller);
  Lowered Make(const TypedFunction& typed, std::span<const ir::ConstId> values);
  std::string UniqueName(const File& file, const FunctionInfo& info);

  std::map<Key, Lowered> lowered_;
  struct Open {
    const File* file;
    uint32_t function;
    uint32_t variant;
    std::string Name() const;
    auto operator<=>(const Open&) const = default;
  };
  std::set<Open> checked_;
  std::vector<Open> open_;                 // being lowered, innermost last
  std::map<std::string, uint32_t> names_;  // how often each was given
  std::map<const File*, ir::OriginId> origins_;
};

// The value of an expression that no slot and no call stands in. Invalid if one does, or if folding
// it is not safe.
ir::ConstId EvaluateConstant(ir::Module& module, const TypedFunction& function, TypedId expr);

}  // namespace texgraph::blocks
