// SPDX-License-Identifier: Apache-2.0
// What every pass is made of: Liveness says which values of a function its results need, and
// Rebuilder copies just these into another function through a Builder, so that folding, merging and
// dead code removal come for free. With a folding builder, ifs on constants become the taken side,
// loops of no or one round become straight code, and what a loop carries unchanged leaves it. A
// pass overrides how one instruction is copied.
#pragma once

#include <span>
#include <unordered_map>
#include <vector>

#include "compiler/ir/builder.h"
#include "compiler/ir/module.h"

namespace texgraph::ir {

// Which parameters and results of each function matter, by FunctionId; missing entries mean all of
// them.
struct SignatureUse {
  std::vector<std::vector<bool>> parameters;
  std::vector<std::vector<bool>> results;
  bool Parameter(FunctionId f, size_t i) const {
    return f.index >= parameters.size() || i >= parameters[f.index].size() ||
           parameters[f.index][i];
  }
  bool Result(FunctionId f, size_t i) const {
    return f.index >= results.size() || i >= results[f.index].size() || results[f.index][i];
  }
};

class Liveness {
 public:
  // `self` is the function's own id; only results that `use` keeps are roots. Without `use`
  // everything counts.
  Liveness(const Module& module, const Function& function, FunctionId self = {},
           const SignatureUse* use = nullptr);

  bool Live(ValueId v) const { return live_[v.index]; }
  // The i-th result of a call, an if or a loop (0 for one with a single result).
  bool LiveResult(ValueId v, uint32_t i) const {
    return first_result_[v.index] == kSingle ? live_[v.index]
                                             : result_live_[first_result_[v.index] + i];
  }
  uint32_t ResultCount(ValueId v) const;

 private:
  static constexpr uint32_t kSingle = 0xffffffffu;
  void Index();
  void Mark(ValueId v);
  void MarkResult(ValueId v, uint32_t i);
  void Visit(ValueId v);
  void VisitResult(ValueId v, uint32_t i);

  const Module& module_;
  const Function& function_;
  const SignatureUse* use_;
  std::vector<uint8_t> live_;
  std::vector<uint32_t> first_result_;  // by value: into result_live_, or kSingle
  std::vector<uint8_t> result_live_;
  std::unordered_map<ValueId, std::pair<ValueId, uint32_t>>
      carried_;  // loop parameter: its loop and index
  // Values from here on were looked at: users come after what they use, but in loops.
  size_t seen_from_ = 0;
  std::vector<std::pair<ValueId, uint32_t>> work_;  // of those; kSingle as index: the value itself
  void VisitAll();
};

class Rebuilder {
 public:
  // Copies values of `from`, which must not be the builder's own function.
  Rebuilder(Module& module, const Function& from, const Liveness& live, Builder& to);
  virtual ~Rebuilder() = default;

  // Declares copies of all of from's parameters in the new function and maps them.
  void CopyParameters();
  // Declares a result signature equal to from's, copies the whole body and returns its results.
  void CopyFunction();
  // Copies the live part of a region's body to where the builder stands.
  void CopyRegion(RegionId region);
  void Set(ValueId old, ValueId now) { map_[old.index] = now; }
  // The copy of `old`; constants are copied when they are first asked for.
  ValueId Get(ValueId old);
  std::vector<ValueId> GetAll(std::span<const ValueId> old);

 protected:
  // The copy of one instruction that is no constant, parameter, if, loop or call. The default emits
  // the same operation.
  virtual ValueId Copy(ValueId old);
  // Fills in the results of a copied call, by their index in `from`; dead ones may be left invalid.
  virtual void CopyCall(ValueId old, std::span<ValueId> results);
  virtual std::vector<ValueId> CopyIf(ValueId old);
  virtual std::vector<ValueId> CopyFor(ValueId old);
  // Called around the copy of each side of an if that stays one: inside, its condition is `taken`.
  virtual void EnterSide(ValueId /*old_if*/, bool /*taken*/) {}
  virtual void LeaveSide(ValueId /*old_if*/, bool /*taken*/) {}
  // Called when `old`, which takes one result of a call, an if or a loop, got its copy.
  virtual void TookResult(ValueId /*old*/) {}

  Module& module_;
  const Function& from_;
  const Liveness& live_;
  Builder& to_;

  // The live results of a call in the new function.
  void TakeResults(ValueId old, ValueId call, std::span<ValueId> results);

 private:
  bool StaysAs(ValueId value, ValueId param, ValueId first);
  void CopyOne(ValueId old);
  void CopyCallResults(ValueId old);
  void SetResults(ValueId old, std::span<const ValueId> results);
  void SetOrigin(ValueId old);

  std::vector<ValueId> map_;
  // Several results of one call, if or loop stand one behind the other.
  std::unordered_map<ValueId, uint32_t> first_result_;
  std::vector<ValueId> results_;
};

// Copies the body of `callee`, which has neither ifs nor loops, to where the builder stands,
// without its names, and fills in its results.
void CopyInline(const Function& callee, std::span<const ValueId> arguments, Builder& to,
                std::span<ValueId> results);

// Replaces module[id] by an empty function with the same name, display name and origin, and returns
// the old one.
Function TakeFunction(Module& module, FunctionId id);

}  // namespace texgraph::ir
