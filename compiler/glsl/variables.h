// SPDX-License-Identifier: Apache-2.0
// Out of single assignment: which values share a variable, and where each variable is declared. The
// values that an if or a loop passes on share the variable of their result where no other value is
// lost by it, and so do values to which the author gave one name. With `reuse`, variables of one
// type are used again as soon as they are free, whatever their names: for functions with thousands
// of them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "compiler/glsl/live_ranges.h"
#include "compiler/glsl/schedule.h"

namespace texgraph::glsl {

using VariableId = Id<struct VariableTag>;

struct Variable {
  TypeId type;
  NameId name;                   // that the author or the graph gave; may be none
  ValueId example;               // for a descriptive name: the value, or the instruction
  uint32_t result;               // of the instruction, where it has several
  RegionId home;                 // the region whose scope it belongs to
  uint32_t declared_at;          // the position of the first write, or of the statement around it
  bool declared_before = false;  // declared without a value ahead of that statement
  bool is_index = false;         // of a loop
};

class Variables {
 public:
  Variables(const ir::Module& module, const ir::Function& function, const Uses& uses,
            const Forms& forms, const Schedule& schedule, bool reuse);

  const Variable& operator[](VariableId v) const { return list_[v.index]; }
  // The variable that holds a value; invalid for leaves and inline expressions.
  VariableId Of(ValueId v) const { return Find(of_value_[v.index]); }
  // That of a result of an if, a loop or a call; invalid if nothing needs the result.
  VariableId OfResult(ValueId v, uint32_t result) const {
    return Find(of_slot_[uses_.FirstSlot(v) + result]);
  }
  VariableId OfIndex(ValueId loop) const;
  // Variables that are declared without a value, in the order of the statements they go before.
  const std::vector<VariableId>& DeclaredBefore() const { return declared_before_; }
  size_t size() const { return list_.size(); }
  // Whether two values of the function may have been put into one variable.
  bool IsRoot(VariableId v) const { return parents_[v.index] == v.index; }

 private:
  struct Pair {
    uint32_t a, b;
    bool by_name;
  };

  VariableId Find(VariableId v) const { return v ? VariableId(FindRoot(v.index)) : v; }
  uint32_t FindRoot(uint32_t v) const;
  void NameResults();
  void Create();
  VariableId Add(TypeId type, NameId name, ValueId example, uint32_t result, RegionId home,
                 size_t position);
  void CreateResults(ValueId v, const Statement& statement, size_t position);
  NameId NameOfResult(ValueId v, uint32_t result) const;
  void Pairs();
  void PairResults(ValueId v);
  void PairNames();
  void AddPair(VariableId a, ValueId b);

  void FindRanges();
  void Read(ValueId v, uint32_t position, RegionId place);
  void ReadAt(size_t position);
  void RangeOf(size_t position);
  void AddWrite(VariableId v, size_t position, ValueId source = {});
  void Coalesce();
  bool Interfere(uint32_t a, uint32_t b) const;
  void Join(uint32_t a, uint32_t b);
  RegionId CommonRegion(RegionId a, RegionId b) const;
  void PlaceDeclarations();
  void Reuse();

  const ir::Module& module_;
  const ir::Function& function_;
  const Uses& uses_;
  const Forms& forms_;
  const Schedule& schedule_;
  const bool reuse_;
  std::vector<Variable> list_;
  mutable std::vector<uint32_t> parents_;
  std::vector<VariableId> of_value_;
  std::vector<VariableId> of_slot_;
  std::vector<NameId> slot_names_;
  std::vector<Pair> pairs_;
  // Of variables that stand in a pair, or, for reuse, of all.
  std::vector<uint32_t> range_of_;  // by variable; kNoRange
  std::vector<LiveRange> ranges_;
  std::vector<uint32_t> last_read_;        // by range
  std::vector<uint32_t> last_param_read_;  // by range: of a loop's carried value, inside the loop
  std::vector<VariableId> declared_before_;
};

}  // namespace texgraph::glsl
