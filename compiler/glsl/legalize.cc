// SPDX-License-Identifier: Apache-2.0
#include "compiler/glsl/legalize.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>

#include "compiler/glsl/limits.h"
#include "compiler/ir/rebuild.h"

namespace texgraph::glsl {
namespace {

using ir::Builder;
using ir::FunctionId;
using ir::GlobalId;
using ir::Inst;
using ir::Op;
using ir::TypeId;
using ir::ValueId;

// Whole numbers from `low` to `high`.
struct Interval {
  int64_t low;
  int64_t high;
};
constexpr Interval kAllInts{INT32_MIN, INT32_MAX};

bool HasArray(const ir::Types& types, TypeId type) {
  const ir::Type& t = types[type];
  if (t.kind == ir::TypeKind::kArray) return true;
  return t.kind == ir::TypeKind::kStruct &&
         std::ranges::any_of(t.fields,
                             [&](const ir::StructField& f) { return HasArray(types, f.type); });
}

bool IsWide(TypeId type) { return ir::IsVector(type) && !ir::IsScalar(type); }

// Which inputs each function but main names, itself or through what it calls: its further
// parameters.
using InputUse = std::vector<std::vector<GlobalId>>;  // by FunctionId, sorted

InputUse FindInputUse(const ir::Module& module) {
  InputUse use(module.functions.size());
  for (size_t f = 0; f < module.functions.size(); ++f) {
    if (FunctionId(f) == module.main) continue;
    for (const Inst& inst : module.functions[f].insts) {
      if (inst.op == Op::kGlobal && module.globals[inst.aux].kind == ir::GlobalKind::kInput) {
        use[f].push_back(GlobalId(inst.aux));
      } else if (inst.op == Op::kCall) {
        use[f].insert(use[f].end(), use[inst.aux].begin(), use[inst.aux].end());
      }
    }
    std::ranges::sort(use[f]);
    use[f].erase(std::ranges::unique(use[f]).begin(), use[f].end());
  }
  return use;
}

// Whether GLSL of the dialect has this operation, as it is.
bool IsLegal(const ir::Module& module, const ir::Function& function, const Inst& inst,
             Dialect dialect, const InputUse& inputs) {
  switch (inst.op) {
    case Op::kLogicalAnd:
    case Op::kLogicalOr:
      return !IsWide(inst.type);
    case Op::kFma:
      return dialect == Dialect::k450;
    case Op::kSelect: {
      if (HasArray(module.types, inst.type)) return false;
      bool by_component = IsWide(function[function.Operands(inst)[0]].type);
      return !by_component || ir::IsFloat(inst.type) || dialect == Dialect::k450;
    }
    case Op::kIndex:
      return false;
    case Op::kCall:
      return inputs[inst.aux].empty();
    default:
      return true;
  }
}

class Legalizer : public ir::Rebuilder {
 public:
  Legalizer(ir::Module& module, const ir::Function& from, const ir::Liveness& live, Builder& to,
            Dialect dialect, const InputUse& inputs)
      : Rebuilder(module, from, live, to), dialect_(dialect), inputs_(inputs) {
    for (size_t l = 0; l < from.loops.size(); ++l) {
      loops_.emplace(from.regions[from.loops[l].body.index].params[0], l);
    }
  }

  void AddInputs(const std::vector<GlobalId>& inputs) {
    for (GlobalId id : inputs) {
      const ir::Global& global = module_.globals[id.index];
      parameters_.emplace_back(id, to_.AddParameter({global.name, global.type}));
    }
  }

 protected:
  ValueId Copy(ValueId old) override;
  void CopyCall(ValueId old, std::span<ValueId> results) override;

 private:
  ValueId Input(GlobalId id);
  ValueId ByComponent(ValueId old);
  ValueId SelectWhole(ValueId old);
  ValueId Index(ValueId old);
  Interval IntervalOf(ValueId value, int depth) const;
  Interval IntervalOf(const ir::ForLoop& loop) const;
  bool IsInRange(ValueId index, uint32_t count) const;

  const Dialect dialect_;
  const InputUse& inputs_;
  std::vector<std::pair<GlobalId, ValueId>> parameters_;
  std::unordered_map<ValueId, size_t> loops_;  // by their index: which of from_.loops
};

ValueId Legalizer::Input(GlobalId id) {
  for (auto [global, parameter] : parameters_) {
    if (global == id) return parameter;
  }
  return to_.Global(id);
}

ValueId Legalizer::Copy(ValueId old) {
  const Inst& inst = from_[old];
  if (inst.op == Op::kGlobal) return Input(GlobalId(inst.aux));
  if (inst.op == Op::kIndex) return Index(old);
  if (IsLegal(module_, from_, inst, dialect_, inputs_)) return Rebuilder::Copy(old);
  if (inst.op == Op::kFma) {
    std::vector<ValueId> x = GetAll(from_.Operands(inst));
    ValueId product = to_.Emit(Op::kMul, inst.type, {x[0], x[1]});
    return to_.Emit(Op::kAdd, inst.type, {product, x[2]});
  }
  return HasArray(module_.types, inst.type) ? SelectWhole(old) : ByComponent(old);
}

// A vector operation that GLSL has for scalars only.
ValueId Legalizer::ByComponent(ValueId old) {
  const Inst& inst = from_[old];
  std::vector<ValueId> x = GetAll(from_.Operands(inst));
  std::vector<ValueId> parts;
  for (uint32_t i = 0; i < ir::Width(inst.type); ++i) {
    std::vector<ValueId> components;
    for (ValueId v : x) {
      bool constant = to_.IsConst(v);
      components.push_back(constant
                               ? to_.Const(ir::ScalarType(to_.TypeOf(v)), {{to_.ConstWords(v)[i]}})
                               : to_.Extract(v, i));
    }
    parts.push_back(to_.Emit(inst.op, ir::ScalarType(inst.type), components));
  }
  return to_.Construct(inst.type, parts);
}

// ?: takes no arrays.
ValueId Legalizer::SelectWhole(ValueId old) {
  std::vector<ValueId> x = GetAll(from_.Operands(old));
  ir::RegionId then_region = to_.BeginRegion();
  to_.EndRegion({{x[1]}});
  ir::RegionId else_region = to_.BeginRegion();
  to_.EndRegion({{x[2]}});
  return to_.If(x[0], then_region, else_region);
}

// The numbers that `value` of the old function can be, whatever its inputs are. Of integers alone:
// what a float that is not finite turns into, nobody knows.
Interval Legalizer::IntervalOf(ValueId value, int depth) const {
  const Inst& inst = from_[value];
  const Interval all = inst.type == ir::kUint ? Interval{0, 0xffffffff} : kAllInts;
  if (inst.op == Op::kConst) {
    const uint32_t word = module_.Words(ir::ConstId(inst.aux))[0];
    const int64_t number = inst.type == ir::kUint ? int64_t(word) : int64_t(int32_t(word));
    return {number, number};
  }
  if (inst.op == Op::kParam) {
    auto found = loops_.find(value);
    return found != loops_.end() ? IntervalOf(from_.loops[found->second]) : all;
  }
  if (depth == 0 || (inst.type != ir::kInt && inst.type != ir::kUint)) return all;
  std::span<const ValueId> operands = from_.Operands(inst);
  auto of = [&](size_t i) { return IntervalOf(operands[i], depth - 1); };
  auto fitting = [&](Interval x) { return x.low < all.low || x.high > all.high ? all : x; };
  switch (inst.op) {
    case Op::kAnd: {
      const Interval a = of(0), b = of(1);
      if (a.low < 0 && b.low < 0) return all;
      return {0, a.low < 0 ? b.high : b.low < 0 ? a.high : std::min(a.high, b.high)};
    }
    case Op::kMod: {
      const Interval a = of(0), b = of(1);
      return a.low >= 0 && b.low > 0 ? Interval{0, std::min(a.high, b.high - 1)} : all;
    }
    case Op::kClamp: {
      const Interval low = of(1), high = of(2);
      return low.low == low.high && high.low == high.high && low.low <= high.low
                 ? Interval{low.low, high.low}
                 : all;
    }
    case Op::kAdd: {
      const Interval a = of(0), b = of(1);
      return fitting({a.low + b.low, a.high + b.high});
    }
    case Op::kMul: {
      const Interval a = of(0), b = of(1);
      // Not more than 64 bits: both are below 2^32.
      if (a.low < 0 || b.low < 0 || a.high > INT32_MAX || b.high > INT32_MAX) return all;
      return fitting({a.low * b.low, a.high * b.high});
    }
    case Op::kShr: {
      const Interval a = of(0), b = of(1);
      if (b.low != b.high || b.low < 0 || b.low > 31) return all;
      return {a.low >> b.low, a.high >> b.low};
    }
    case Op::kConvert: {
      const TypeId from = from_[operands[0]].type;
      return from == ir::kInt || from == ir::kUint ? fitting(of(0)) : all;
    }
    default:
      return all;
  }
}

// What a loop's index is in its body.
Interval Legalizer::IntervalOf(const ir::ForLoop& loop) const {
  const int64_t trips = std::max<int64_t>(loop.Trips(), 1);
  const int64_t last = loop.first + (trips - 1) * loop.step;
  return {std::min<int64_t>(loop.first, last), std::max<int64_t>(loop.first, last)};
}

// Whether `index` of the old function is known to be at least 0 and less than `count`.
bool Legalizer::IsInRange(ValueId index, uint32_t count) const {
  constexpr int kDepth = 8;
  const Interval interval = IntervalOf(index, kDepth);
  return interval.low >= 0 && interval.high < count;
}

// Outside its array, the index is the nearest one inside.
ValueId Legalizer::Index(ValueId old) {
  std::span<const ValueId> operands = from_.Operands(old);
  uint32_t count = module_.types.ElementCount(from_[operands[0]].type);
  ValueId index = Get(operands[1]);
  if (!IsInRange(operands[1], count)) {
    if (to_.TypeOf(index) == ir::kUint) {
      index = to_.Emit(Op::kMin, ir::kUint, {index, to_.Uint(count - 1)});
    } else {
      index = to_.Emit(Op::kClamp, ir::kInt,
                       {index, to_.Int(0), to_.Int(static_cast<int32_t>(count) - 1)});
    }
  }
  return to_.Emit(Op::kIndex, from_[old].type, {Get(operands[0]), index});
}

void Legalizer::CopyCall(ValueId old, std::span<ValueId> results) {
  const Inst& inst = from_[old];
  std::vector<ValueId> arguments = GetAll(from_.Operands(inst));
  for (GlobalId input : inputs_[inst.aux]) arguments.push_back(Input(input));
  TakeResults(old, to_.Call(FunctionId(inst.aux), arguments), results);
}

void LegalizeFunction(ir::Module& module, FunctionId id, Dialect dialect, const InputUse& inputs) {
  const ir::Function& function = module[id];
  bool legal =
      inputs[id.index].empty() && std::ranges::all_of(function.insts, [&](const Inst& inst) {
        return IsLegal(module, function, inst, dialect, inputs);
      });
  if (legal) return;
  ir::Function old = ir::TakeFunction(module, id);
  ir::Liveness live(module, old, id);
  Builder builder(module, module[id], {.fold = false});
  Legalizer legalizer(module, old, live, builder, dialect, inputs);
  legalizer.CopyParameters();
  legalizer.AddInputs(inputs[id.index]);
  legalizer.CopyRegion(old.body);
  module[id].results = old.results;
  builder.Return(legalizer.GetAll(old.Body().results));
}

}  // namespace

bool Legalize(ir::Module& module, Dialect dialect, Diagnostics& diagnostics, SourceRange where) {
  if (!CheckLimits(module, where, diagnostics)) return false;
  InputUse inputs = FindInputUse(module);
  for (size_t f = 0; f < module.functions.size(); ++f) {
    FunctionId id(f);
    LegalizeFunction(module, id, dialect, inputs);
    std::vector<ir::Result>& results = module[id].results;
    if (id != module.main && results.size() == 1) results[0].name.clear();
  }
  return true;
}

}  // namespace texgraph::glsl
