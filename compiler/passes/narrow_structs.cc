// SPDX-License-Identifier: Apache-2.0
#include "compiler/passes/narrow_structs.h"

#include <algorithm>
#include <map>
#include <utility>

namespace texgraph::passes {
namespace {

using ir::ConstId;
using ir::Op;
using ir::TypeId;
using ir::TypeKind;
using ir::ValueId;

class Narrower {
 public:
  explicit Narrower(ir::Module& module) : module_(module), read_(module.types.size()) {}

  bool Run(std::vector<bool>& changed);

 private:
  void FindStructs();
  void FindReached();
  void FindAllReads();
  void FindReads(const ir::Function& function);
  void Mark(ValueId v);
  void Visit(const ir::Function& function, ValueId v);
  void KeepOneMember();
  void DecideWhatStays();
  bool IsDropped(const ir::Function& function, const ir::Inst& inst) const;
  // The values that were only read for members that are gone.
  void DropUnread(ir::Function& function);
  // Whether the function makes values of a narrowed type.
  bool Rewrite(ir::Function& function);
  void NarrowConstruct(ir::Function& function, ir::Inst& inst);
  // The words of a constant that stay.
  void KeepWords(TypeId type, std::span<const uint32_t> words, std::vector<uint32_t>& kept) const;
  bool IsNarrowed(TypeId type) const { return !new_index_[type.index].empty(); }

  static constexpr uint32_t kDropped = 0xffffffffu;

  ir::Module& module_;
  std::vector<TypeId> structs_;
  std::vector<bool> reached_;                     // by function
  std::vector<std::vector<bool>> read_;           // by type: which members are read; structs only
  bool grown_ = true;                             // a member was found to be read
  std::vector<std::vector<uint32_t>> new_index_;  // by type, by member; empty: all of them stay
  std::vector<uint8_t> live_;                     // by value of one function
  std::vector<ValueId> work_;                     // live, not yet visited
  std::vector<bool> holds_;                       // by type: is or holds a narrowed one
  std::map<uint32_t, std::pair<TypeId, std::vector<uint32_t>>> constants_;  // what they will be
};

// From main down: callers come after callees.
void Narrower::FindReached() {
  reached_.assign(module_.functions.size(), false);
  reached_[module_.main.index] = true;
  for (size_t f = module_.functions.size(); f-- > 0;) {
    if (!reached_[f]) continue;
    for (const ir::Inst& inst : module_.functions[f].insts) {
      if (inst.op == Op::kCall || inst.op == Op::kFieldRef) reached_[inst.aux] = true;
    }
  }
}

// Those that there are values of; the library declares others.
void Narrower::FindStructs() {
  for (size_t f = 0; f < module_.functions.size(); ++f) {
    if (!reached_[f]) continue;
    for (const ir::Inst& inst : module_.functions[f].insts) {
      const ir::Type& type = module_.types[inst.type];
      if (type.kind != TypeKind::kStruct || !read_[inst.type.index].empty()) continue;
      structs_.push_back(inst.type);
      read_[inst.type.index].resize(type.fields.size());
    }
  }
}

void Narrower::Mark(ValueId v) {
  if (std::exchange(live_[v.index], 1)) return;
  work_.push_back(v);
}

// What the operation needs, less what goes into members that nothing reads.
void Narrower::Visit(const ir::Function& function, ValueId v) {
  const ir::Inst& inst = function[v];
  std::span<const ValueId> operands = function.Operands(inst);
  const std::vector<bool>& made = read_[inst.type.index];
  for (size_t i = 0; i < operands.size(); ++i) {
    if (inst.op == Op::kConstruct && !made.empty() && !made[i]) continue;
    Mark(operands[i]);
  }
  auto mark_results = [&](ir::RegionId region) {
    for (ValueId result : function.regions[region.index].results) Mark(result);
  };
  if (inst.op == Op::kIf) {
    mark_results(function.branches[inst.aux].then_region);
    mark_results(function.branches[inst.aux].else_region);
  } else if (inst.op == Op::kFor) {
    mark_results(function.loops[inst.aux].body);
  } else if (inst.op == Op::kExtract) {
    std::vector<bool>& read = read_[function[operands[0]].type.index];
    if (!read.empty() && !read[inst.aux]) read[inst.aux] = grown_ = true;
  }
}

// A member that only goes into the same or another member that nothing reads is not read itself.
void Narrower::FindReads(const ir::Function& function) {
  live_.assign(function.insts.size(), 0);
  for (ValueId result : function.Body().results) Mark(result);
  while (!work_.empty()) {
    ValueId v = work_.back();
    work_.pop_back();
    Visit(function, v);
  }
}

void Narrower::FindAllReads() {
  while (std::exchange(grown_, false)) {
    for (size_t f = 0; f < module_.functions.size(); ++f) {
      if (reached_[f]) FindReads(module_.functions[f]);
    }
  }
}

// One member stays in each struct, and what goes into that one is read then.
void Narrower::KeepOneMember() {
  for (TypeId type : structs_) {
    std::vector<bool>& read = read_[type.index];
    if (std::ranges::find(read, true) == read.end()) read[0] = grown_ = true;
  }
}

void Narrower::DecideWhatStays() {
  const size_t count = module_.types.size();
  new_index_.resize(count);
  holds_.resize(count);
  for (TypeId type : structs_) {
    std::vector<bool>& read = read_[type.index];
    if (std::ranges::find(read, false) == read.end()) continue;
    uint32_t next = 0;
    for (bool stays : read) new_index_[type.index].push_back(stays ? next++ : kDropped);
  }
  // A type comes after those that it holds.
  for (uint32_t i = ir::kBasicTypeCount; i < count; ++i) {
    const ir::Type& type = module_.types[TypeId(i)];
    holds_[i] = IsNarrowed(TypeId(i));
    for (const ir::StructField& field : type.fields) {
      holds_[i] = holds_[i] || holds_[field.type.index];
    }
    for (TypeId element : type.elements) holds_[i] = holds_[i] || holds_[element.index];
  }
}

void Narrower::KeepWords(TypeId type, std::span<const uint32_t> words,
                         std::vector<uint32_t>& kept) const {
  if (!holds_[type.index]) {
    kept.insert(kept.end(), words.begin(), words.end());
    return;
  }
  for (uint32_t i = 0; i < module_.types.ElementCount(type); ++i) {
    TypeId element = module_.types.ElementType(type, i);
    std::span<const uint32_t> part = words.first(module_.types.Words(element));
    words = words.subspan(part.size());
    if (IsNarrowed(type) && new_index_[type.index][i] == kDropped) continue;
    KeepWords(element, part, kept);
  }
}

void Narrower::NarrowConstruct(ir::Function& function, ir::Inst& inst) {
  const std::vector<uint32_t>& index = new_index_[inst.type.index];
  ValueId* operands = function.operands.data() + inst.first_operand;
  uint16_t stays = 0;
  for (uint16_t i = 0; i < inst.operand_count; ++i) {
    if (index[i] != kDropped) operands[stays++] = operands[i];
  }
  inst.operand_count = stays;
}

bool Narrower::IsDropped(const ir::Function& function, const ir::Inst& inst) const {
  if (inst.op != Op::kExtract) return false;
  const TypeId whole = function[function.Operands(inst)[0]].type;
  return IsNarrowed(whole) && new_index_[whole.index][inst.aux] == kDropped;
}

void Narrower::DropUnread(ir::Function& function) {
  if (std::ranges::none_of(function.insts, [&](auto& inst) { return IsDropped(function, inst); })) {
    return;
  }
  FindReads(function);
  for (ir::Region& region : function.regions) {
    std::erase_if(region.body, [&](ValueId v) { return live_[v.index] == 0; });
  }
}

bool Narrower::Rewrite(ir::Function& function) {
  DropUnread(function);
  bool makes = false;
  for (ir::Inst& inst : function.insts) {
    if (inst.op == Op::kConst && holds_[inst.type.index]) {
      auto& [type, words] = constants_[inst.aux];
      type = inst.type;
      words.clear();
      KeepWords(type, module_.Words(ConstId(inst.aux)), words);
    } else if (inst.op == Op::kConstruct && IsNarrowed(inst.type)) {
      NarrowConstruct(function, inst);
      makes = true;
    } else if (inst.op == Op::kExtract) {
      TypeId whole = function[function.Operands(inst)[0]].type;
      if (IsNarrowed(whole)) inst.aux = new_index_[whole.index][inst.aux];
    }
  }
  return makes;
}

bool Narrower::Run(std::vector<bool>& changed) {
  FindReached();
  FindStructs();
  if (structs_.empty()) return false;
  FindAllReads();
  KeepOneMember();
  FindAllReads();
  DecideWhatStays();
  if (std::ranges::none_of(structs_, [&](TypeId type) { return IsNarrowed(type); })) return false;
  for (size_t f = 0; f < module_.functions.size(); ++f) {
    // The others may read what is dropped; nobody runs them.
    if (reached_[f] && Rewrite(module_.functions[f])) changed[f] = true;
  }
  for (TypeId type : structs_) {
    if (IsNarrowed(type)) module_.types.KeepFields(type, read_[type.index]);
  }
  std::map<uint32_t, ConstId> narrowed;
  for (const auto& [id, value] : constants_)
    narrowed[id] = module_.Intern(value.first, value.second);
  for (ir::Function& function : module_.functions) {
    for (ir::Inst& inst : function.insts) {
      if (inst.op != Op::kConst) continue;
      if (auto now = narrowed.find(inst.aux); now != narrowed.end()) {
        inst.aux = now->second.index;
      }
    }
  }
  return true;
}

}  // namespace

bool NarrowStructs(ir::Module& module, std::vector<bool>& changed) {
  return Narrower(module).Run(changed);
}

}  // namespace texgraph::passes
