// SPDX-License-Identifier: Apache-2.0
// A function's statements in the order in which they are printed, regions laid out in line. The
// index of a statement is its position: what it reads, it reads before it writes.
#pragma once

#include <vector>

#include "compiler/glsl/forms.h"

namespace texgraph::glsl {

struct Statement {
  enum class Kind : uint8_t {
    kDefine,    // a variable gets a value
    kCall,      // a call with several results
    kIfInit,    // results get the values of the side that has no work
    kIf,        // "if (...) {"
    kThenEnd,   // results get the values of the first side
    kElse,      // "} else {"
    kElseEnd,   // and of the second
    kIfEnd,     // "}"
    kLoopInit,  // carried values get their first ones
    kLoop,      // "for (...) {"
    kLoopNext,  // and their next ones
    kLoopEnd,   // "}"
    kReturn,
  };
  Kind kind;
  ValueId value;    // the instruction; none for kReturn
  RegionId region;  // that the statement stands in
};

// How an if is written.
enum class IfStyle : uint8_t {
  kBoth,      // both sides have work
  kThenOnly,  // the second side's values are given first
  kElseOnly,  // the first side's values are given first, and the condition is negated
  // All that a loop does, without which its values stay as they are: when the condition is false
  // once, it is false for ever. So it is written as a condition of the loop, and the loop ends.
  kLoopCondition,
};

class Schedule {
 public:
  Schedule(const ir::Function& function, const Uses& uses, const Forms& forms);

  const std::vector<Statement>& statements() const { return statements_; }
  const Statement& operator[](size_t position) const { return statements_[position]; }
  size_t size() const { return statements_.size(); }
  IfStyle StyleOf(ValueId branch) const { return styles_[function_[branch].aux]; }
  // Whether an if gives its results the values of its idle side first.
  bool StartsIdle(ValueId branch) const {
    return StyleOf(branch) == IfStyle::kThenOnly || StyleOf(branch) == IfStyle::kElseOnly;
  }
  // The if whose condition is a condition of the loop with this body; none as a rule.
  ValueId ConditionOf(RegionId body) const { return conditions_[body.index]; }
  // The position of a loop's kLoopEnd, by its body region.
  uint32_t LoopEnd(RegionId body) const { return loop_ends_[body.index]; }
  // The position of an if's kIfEnd.
  uint32_t IfEnd(ValueId branch) const { return if_ends_[function_[branch].aux]; }
  // The first position of the if or loop that a region belongs to.
  uint32_t StartOf(RegionId r) const { return starts_[r.index]; }
  // Whether there is any if or loop.
  bool has_control() const { return has_control_; }

 private:
  void Add(Statement::Kind kind, ValueId value, RegionId region) {
    statements_.push_back({kind, value, region});
  }
  bool IsIdle(ValueId branch, RegionId side) const;
  bool ContinuesElse(ValueId v, RegionId region) const;
  bool EndsLoop(ValueId v, RegionId region) const;
  void Enter(ValueId v, RegionId region);
  void LeaveSide(ValueId v, RegionId region);

  struct Frame {
    RegionId region;
    size_t next = 0;  // into its body
    ValueId owner;    // the if or loop; none for the function
  };

  const ir::Function& function_;
  const Uses& uses_;
  const Forms& forms_;
  std::vector<Statement> statements_;
  std::vector<IfStyle> styles_;      // by BranchId
  std::vector<ValueId> conditions_;  // by RegionId
  std::vector<uint32_t> if_ends_;    // by BranchId
  std::vector<uint32_t> loop_ends_;  // by RegionId
  std::vector<uint32_t> starts_;     // by RegionId
  std::vector<Frame> frames_;
  bool has_control_ = false;
};

}  // namespace texgraph::glsl
