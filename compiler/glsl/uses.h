// SPDX-License-Identifier: Apache-2.0
// How a function's values are used where they are written down: how often, in which region, and
// whether the place is one that may be skipped. Dead values, and components that are written as a
// swizzle of their vector, have no uses.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "compiler/ir/module.h"
#include "compiler/ir/rebuild.h"

namespace texgraph::glsl {

using ir::FunctionId;
using ir::GlobalId;
using ir::Inst;
using ir::NameId;
using ir::Op;
using ir::RegionId;
using ir::TypeId;
using ir::ValueId;

// An argument of a vector constructor: a value, or a swizzle of one.
struct Part {
  ValueId value;
  uint32_t mask = 0;   // as the aux of kSwizzle
  uint32_t width = 0;  // 0: the value itself
};
struct Parts {
  std::array<Part, 4> list;
  uint32_t count = 0;
};
// The arguments of a kConstruct of a vector, neighbouring components of one vector taken together.
Parts ConstructParts(const ir::Function& function, const Inst& construct);

struct RegionInfo {
  RegionId parent;  // invalid: the function's own
  bool is_loop = false;
};

enum UseFlag : uint8_t {
  kLazyUse = 1,     // a place that is perhaps not evaluated: the sides of ?:, the right of &&
  kResultUse = 2,   // a region's result
  kIndexedUse = 4,  // the array of a kIndex
  kOutUse = 8,      // a function's result that is an out parameter
};

class Uses {
 public:
  Uses(const ir::Module& module, const ir::Function& function);

  uint32_t Count(ValueId v) const { return counts_[v.index]; }
  // Whether the instruction appears in the text at all.
  bool IsWritten(ValueId v) const { return Count(v) > 0 || FirstSlot(v) != kNoSlot; }
  // Of a value with one use: where it is, and what of UseFlag.
  RegionId Place(ValueId v) const { return places_[v.index]; }
  uint8_t Flags(ValueId v) const { return flags_[v.index]; }
  // The region that a value stands in; a parameter's own. Invalid for constants.
  RegionId RegionOf(ValueId v) const { return region_of_[v.index]; }
  const RegionInfo& Info(RegionId r) const { return regions_[r.index]; }
  // Whether `inner` is `outer` or inside it.
  bool IsInside(RegionId inner, RegionId outer) const;

  // Instructions with several results, and all ifs and loops, have a slot for each result.
  static constexpr uint32_t kNoSlot = 0xffffffffu;
  uint32_t FirstSlot(ValueId v) const { return first_slot_[v.index]; }
  uint32_t slot_count() const { return static_cast<uint32_t>(slot_live_.size()); }
  bool SlotLive(uint32_t slot) const { return slot_live_[slot]; }
  uint32_t ResultCount(ValueId v) const { return live_.ResultCount(v); }
  bool IsLive(ValueId v) const { return live_.Live(v); }
  bool IsTuple(ValueId v) const;

 private:
  void FindRegions();
  void FindSlots();
  void CountUses();
  void CountOperands(ValueId v);
  void Use(ValueId v, RegionId place, uint8_t flags = 0);

  const ir::Module& module_;
  const ir::Function& function_;
  ir::Liveness live_;
  std::vector<RegionInfo> regions_;
  std::vector<RegionId> region_of_;
  std::vector<uint32_t> counts_;
  std::vector<RegionId> places_;
  std::vector<uint8_t> flags_;
  std::vector<uint32_t> first_slot_;
  std::vector<bool> slot_live_;
};

}  // namespace texgraph::glsl
