// SPDX-License-Identifier: Apache-2.0
// Differentiate: forward derivatives of coordinates, made only where a sample or a footprint asks
// for them (demand.h). Each wanted value gets two companions, its change over one pixel in x and in
// y; they start as dFdx and dFdy of main's inputs and follow the rules of ir/ops.def, through
// branches, loops and calls. A function whose samples need derivatives takes them as further
// parameters; one whose results' derivatives are needed returns them as further results.
//
// A coordinate that is moved by a sampled value: the derivative of a sample is the difference of
// two samples one pixel apart, texture(s, c + dc/dx) - texture(s, c), filtered alike. It costs two
// samples, is right in branches and loops, and is what a GPU's own differences would see.
#include <algorithm>
#include <bit>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compiler/ir/rebuild.h"
#include "compiler/passes/demand.h"
#include "compiler/passes/passes.h"
#include "compiler/passes/pattern.h"
#include "compiler/passes/slopes.h"

namespace texgraph::passes {
namespace {

using ir::FunctionId;
using ir::Op;
using ir::ValueId;

class Differentiator {
 public:
  Differentiator(ir::Module& module, bool fold)
      : module_(module), fold_(fold), leaves_(module.types) {}
  std::vector<bool> Run();
  // The new function for this demand on an old one, made once for each distinct code.
  FunctionId Variant(const Demand& demand);

  Leaves& leaves() { return leaves_; }
  const ir::Function& old(FunctionId id) const { return old_[id.index]; }

 private:
  std::vector<uint32_t> CodeKey(const Demand& demand);
  bool StaysAsItIs(const Demand& demand) const;
  ir::Function Retarget(const Demand& demand);

  ir::Module& module_;
  const bool fold_;
  Leaves leaves_;
  std::deque<ir::Function> old_;
  std::map<const Demand*, FunctionId> by_demand_;
  std::map<std::vector<uint32_t>, FunctionId> by_code_;
  std::vector<bool> changed_;  // by new function
};

class DerivativeRebuilder : public ir::Rebuilder {
 public:
  DerivativeRebuilder(Differentiator& pass, ir::Module& module, const ir::Function& from,
                      const ir::Liveness& live, const Demand& demand, ir::Builder& to)
      : Rebuilder(module, from, live, to),
        pass_(pass),
        demand_(demand),
        continuity_(*demand.continuity),
        changes_(continuity_.states.size()),
        uses_(from.insts.size()) {}

  void Run();

 protected:
  ValueId Copy(ValueId old) override;
  void CopyCall(ValueId old, std::span<ValueId> results) override;
  std::vector<ValueId> CopyIf(ValueId old) override;
  std::vector<ValueId> CopyFor(ValueId old) override;
  void TookResult(ValueId old) override {
    DeriveStructure(old);
    NameChanges(old);
  }

 private:
  uint32_t LeafCount(ValueId v) { return pass_.leaves().Count(from_[v].type); }
  const Leaf& LeafOf(ValueId v, uint32_t leaf) { return pass_.leaves().Of(from_[v].type)[leaf]; }
  Change& ChangeOf(ValueId old, uint32_t leaf = 0) {
    const uint32_t index = continuity_.first[old.index] + leaf;
    if (!slopes_.empty()) MultiplySlopes(index);
    return changes_[index];
  }
  bool Wanted(ValueId old) {
    for (uint32_t l = 0; l < LeafCount(old); ++l) {
      if (demand_.Wanted(old, l)) return true;
    }
    return false;
  }
  ValueId OrZero(ValueId change, ir::TypeId type) { return change ? change : to_.Zero(type); }
  void NameChanges(ValueId old);
  void DifferentiateInputs();
  void AddParameterChanges();
  void Return();

  ValueId CopySample(ValueId old);
  // Gradients as textureGrad takes them: an array's has two components.
  ValueId Gradient(ValueId change, ir::TypeId coordinate, ir::TypeId sampler);
  void DeriveSample(ValueId old, ValueId now);
  void Derive(ValueId old, ValueId now);
  void DeriveByRule(ValueId old, ValueId now);
  bool DeriveBySlopes(ValueId old, ValueId now);
  Slopes SlopesOf(ValueId old);
  void CountUses();
  void NameSlope(ValueId old, ValueId slope);
  void MultiplySlopes(uint32_t index);
  void MultiplyAllSlopes();
  void DeriveStructure(ValueId old);
  void DeriveSelect(ValueId old);
  ValueId DeriveSmoothstep(ValueId old, int axis);

  // The wanted leaves of all results of a branch or loop, behind the live results: (result, leaf)
  // pairs.
  std::vector<std::pair<uint32_t, uint32_t>> WantedResults(ValueId old,
                                                           std::span<const ValueId> results);
  void AppendChanges(std::span<const ValueId> results,
                     std::span<const std::pair<uint32_t, uint32_t>> wanted,
                     std::vector<ValueId>& out);
  std::vector<ValueId> TakeResults(ValueId old, ValueId merged, std::span<const uint32_t> kept,
                                   std::span<const ValueId> results,
                                   std::span<const std::pair<uint32_t, uint32_t>> wanted);
  uint32_t FirstLeaf(std::span<const ValueId> elements, uint32_t index);
  std::vector<uint32_t> KeptResults(ValueId old);

  Differentiator& pass_;
  const Demand& demand_;
  const FunctionContinuity& continuity_;
  std::vector<Change> changes_;  // by leaf of old values
  // Those of the present region whose products are not made, by leaf; they are before a region is
  // entered.
  std::map<uint32_t, std::pair<ValueId, Slopes>> slopes_;
  std::vector<uint32_t> uses_;  // of old values, by sums and products whose changes are wanted
};

// --- Signature
// ---------------------------------------------------------------------------------------------------

void DerivativeRebuilder::DifferentiateInputs() {
  // All of them stand at the top, in uniform flow.
  for (size_t i = 0; i < from_.insts.size(); ++i) {
    ValueId old(i);
    const ir::Inst& inst = from_.insts[i];
    if (inst.op != Op::kGlobal || !demand_.Wanted(old)) continue;
    ValueId input = to_.Global(ir::GlobalId(inst.aux));
    Set(old, input);
    ChangeOf(old) = {to_.Emit(Op::kDfdx, inst.type, {input}),
                     to_.Emit(Op::kDfdy, inst.type, {input})};
    const std::string& name = module_.globals[inst.aux].name;
    to_.Name(ChangeOf(old).dx, name + "_dx");
    to_.Name(ChangeOf(old).dy, name + "_dy");
  }
}

void DerivativeRebuilder::AddParameterChanges() {
  uint32_t leaf = 0;
  for (size_t p = 0; p < from_.parameters.size(); ++p) {
    ValueId param = from_.Body().params[p];
    for (uint32_t l = 0; l < LeafCount(param); ++l, ++leaf) {
      if (!demand_.parameters[leaf]) continue;
      const Leaf& info = LeafOf(param, l);
      std::string name = from_.parameters[p].name + info.suffix;
      ChangeOf(param, l) = {to_.AddParameter({name + "_dx", info.type}),
                            to_.AddParameter({name + "_dy", info.type})};
    }
  }
}

void DerivativeRebuilder::Return() {
  std::vector<ValueId> values = GetAll(from_.Body().results);
  ir::Function& function = to_.function();
  function.results = from_.results;
  uint32_t leaf = 0;
  for (size_t r = 0; r < from_.results.size(); ++r) {
    ValueId result = from_.Body().results[r];
    for (uint32_t l = 0; l < LeafCount(result); ++l, ++leaf) {
      if (!demand_.requested[leaf]) continue;
      const Leaf& info = LeafOf(result, l);
      std::string name =
          (from_.results[r].name.empty() ? "result" : from_.results[r].name) + info.suffix;
      for (int axis : {0, 1}) {
        values.push_back(OrZero(ChangeOf(result, l)[axis], info.type));
        function.results.push_back({name + (axis ? "_dy" : "_dx"), info.type});
      }
    }
  }
  to_.Return(values);
}

void DerivativeRebuilder::Run() {
  CopyParameters();
  CountUses();
  AddParameterChanges();
  DifferentiateInputs();
  CopyRegion(from_.body);
  Return();
}

// --- Values
// ------------------------------------------------------------------------------------------------------

ValueId DerivativeRebuilder::Copy(ValueId old) {
  const ir::Inst& inst = from_[old];
  if (inst.op == Op::kDx || inst.op == Op::kDy) {
    return OrZero(ChangeOf(from_.Operands(inst)[0])[inst.op == Op::kDy], inst.type);
  }
  ValueId now = inst.op == Op::kSample ? CopySample(old) : Rebuilder::Copy(old);
  if (inst.op != Op::kGlobal && Wanted(old)) {
    Derive(old, now);
    if (!slopes_.contains(continuity_.first[old.index])) NameChanges(old);
  }
  return now;
}

void DerivativeRebuilder::NameChanges(ValueId old) {
  ir::NameId name = from_.NameOf(old);
  if (!name) return;
  for (uint32_t l = 0; l < LeafCount(old); ++l) {
    std::string text = std::string(module_.Name(name)) + LeafOf(old, l).suffix;
    if (ChangeOf(old, l).dx) to_.Name(ChangeOf(old, l).dx, text + "_dx");
    if (ChangeOf(old, l).dy) to_.Name(ChangeOf(old, l).dy, text + "_dy");
  }
}

ValueId DerivativeRebuilder::Gradient(ValueId change, ir::TypeId coordinate, ir::TypeId sampler) {
  change = OrZero(change, coordinate);
  const uint8_t xy[] = {0, 1};
  return sampler == ir::kSampler2DArray ? to_.Swizzle(change, xy) : change;
}

ValueId DerivativeRebuilder::CopySample(ValueId old) {
  const ir::Inst& inst = from_[old];
  std::span<const ValueId> operands = from_.Operands(inst);
  SampleMode mode = ModeOfSample(from_, continuity_, old);
  if (mode == SampleMode::kImplicit) return Rebuilder::Copy(old);
  ValueId sampler = Get(operands[0]), coordinate = Get(operands[1]);
  ValueId bias = operands.size() > 2 ? Get(operands[2]) : ValueId();
  const Change change = ChangeOf(operands[1]);
  if (mode == SampleMode::kBase || (!change.dx && !change.dy)) {
    return to_.Emit(Op::kSampleLod, inst.type, {sampler, coordinate, bias ? bias : to_.Float(0)});
  }
  std::vector<ValueId> gradients;
  for (int axis : {0, 1}) {
    ValueId gradient = Gradient(change[axis], to_.TypeOf(coordinate), to_.TypeOf(sampler));
    // A bias of b levels is a footprint 2^b times as large.
    if (bias) gradient = to_.Op2(Op::kMul, gradient, to_.Op1(Op::kExp2, bias));
    gradients.push_back(gradient);
  }
  return to_.Emit(Op::kSampleGrad, inst.type, {sampler, coordinate, gradients[0], gradients[1]});
}

void DerivativeRebuilder::DeriveSample(ValueId old, ValueId now) {
  const ir::Inst& inst = from_[old];
  std::span<const ValueId> operands = from_.Operands(inst);
  const Change change = ChangeOf(operands[1]);
  ValueId sampler = Get(operands[0]), coordinate = Get(operands[1]);
  ir::TypeId type = to_.TypeOf(coordinate);
  for (int axis : {0, 1}) {
    if (!change[axis]) continue;
    ValueId beside = to_.Op2(Op::kAdd, coordinate, change[axis]);
    ValueId neighbour;
    if (inst.op == Op::kSampleLod) {
      neighbour = to_.Emit(Op::kSampleLod, inst.type, {sampler, beside, Get(operands[2])});
    } else {
      // With the very gradients of the sample itself, where it has some.
      const ir::Inst written = to_[now];
      std::span<const ValueId> used = to_.function().Operands(written);
      ValueId dx =
          written.op == Op::kSampleGrad ? used[2] : Gradient(change.dx, type, to_.TypeOf(sampler));
      ValueId dy = written.op == Op::kSampleGrad ? to_.function().Operands(written)[3]
                                                 : Gradient(change.dy, type, to_.TypeOf(sampler));
      neighbour = to_.Emit(Op::kSampleGrad, inst.type, {sampler, beside, dx, dy});
    }
    ChangeOf(old)[axis] = to_.Op2(Op::kSub, neighbour, now);
  }
}

void DerivativeRebuilder::Derive(ValueId old, ValueId now) {
  switch (from_[old].op) {
    case Op::kConstruct:
    case Op::kExtract:
    case Op::kSwizzle:
    case Op::kIndex:
    case Op::kConvert:
      return DeriveStructure(old);
    case Op::kSelect:
      return DeriveSelect(old);
    case Op::kSample:
    case Op::kSampleGrad:
    case Op::kSampleLod:
      return DeriveSample(old, now);
    case Op::kSmoothstep:
      for (int axis : {0, 1}) ChangeOf(old)[axis] = DeriveSmoothstep(old, axis);
      return;
    default:
      return DeriveByRule(old, now);
  }
}

void DerivativeRebuilder::MultiplySlopes(uint32_t index) {
  auto found = slopes_.find(index);
  if (found == slopes_.end()) return;
  const auto [old, slopes] = std::move(found->second);
  slopes_.erase(found);
  for (int axis : {0, 1}) changes_[index][axis] = Multiply(to_, slopes, axis);
  NameChanges(old);
}

void DerivativeRebuilder::MultiplyAllSlopes() {
  while (!slopes_.empty()) MultiplySlopes(slopes_.begin()->first);
}

Slopes DerivativeRebuilder::SlopesOf(ValueId old) {
  const uint32_t index = continuity_.first[old.index];
  if (auto found = slopes_.find(index); found != slopes_.end()) return found->second.second;
  const Change change = changes_[index];
  if (!change.dx && !change.dy) return {};
  return {{{to_.Splat(from_[old].type, 1), change}}};
}

bool DerivativeRebuilder::DeriveBySlopes(ValueId old, ValueId now) {
  const ir::Inst& inst = from_[old];
  if (!IsPolynomial(inst.op) || module_.types.Kind(inst.type) == ir::TypeKind::kMatrix)
    return false;
  std::vector<Slopes> operands;
  for (ValueId operand : from_.Operands(inst)) operands.push_back(SlopesOf(operand));
  std::optional<Slopes> slopes =
      DeriveSlopes(to_, inst.op, GetAll(from_.Operands(inst)), operands, now);
  if (!slopes) return false;
  if (slopes->terms.empty()) return true;
  const uint32_t index = continuity_.first[old.index];
  if (slopes->terms.size() == 1 && slopes->terms[0].slope == to_.Splat(inst.type, 1)) {
    changes_[index] = slopes->terms[0].from;
    return true;
  }
  NameSlope(old, slopes->terms[0].slope);
  // A scaled coordinate that much comes from: its own change is what the others are made of.
  const bool is_source = slopes->linear && slopes->terms.size() == 1 && uses_[old.index] > 1;
  slopes_.emplace(index, std::pair(old, std::move(*slopes)));
  if (is_source) MultiplySlopes(index);
  return true;
}

void DerivativeRebuilder::NameSlope(ValueId old, ValueId slope) {
  const Op op = to_[slope].op;
  const bool made_here =
      op != Op::kConst && op != Op::kParam && op != Op::kGlobal && !to_.function().NameOf(slope);
  if (ir::NameId name = from_.NameOf(old); name && made_here) {
    to_.Name(slope, std::string(module_.Name(name)) + "_slope");
  }
}

void DerivativeRebuilder::CountUses() {
  for (size_t i = 0; i < from_.insts.size(); ++i) {
    if (!IsPolynomial(from_.insts[i].op) || !demand_.Wanted(ValueId(i), 0)) continue;
    for (ValueId operand : from_.Operands(from_.insts[i])) ++uses_[operand.index];
  }
}

void DerivativeRebuilder::DeriveByRule(ValueId old, ValueId now) {
  if (DeriveBySlopes(old, now)) return;
  std::span<const ValueId> operands = from_.Operands(old);
  std::vector<ValueId> x = GetAll(operands);
  for (int axis : {0, 1}) {
    std::vector<ValueId> d;
    for (ValueId operand : operands) d.push_back(ChangeOf(operand)[axis]);
    std::optional<ValueId> change = InstantiateDerivative(from_[old].op, to_, x, d, now);
    ChangeOf(old)[axis] = change.value_or(ValueId());
  }
}

void DerivativeRebuilder::DeriveSelect(ValueId old) {
  std::span<const ValueId> operands = from_.Operands(old);
  for (uint32_t l = 0; l < LeafCount(old); ++l) {
    for (int axis : {0, 1}) {
      ValueId a = ChangeOf(operands[1], l)[axis], b = ChangeOf(operands[2], l)[axis];
      if (!a && !b) continue;
      ir::TypeId type = LeafOf(old, l).type;
      ChangeOf(old, l)[axis] =
          to_.Emit(Op::kSelect, type, {Get(operands[0]), OrZero(a, type), OrZero(b, type)});
    }
  }
}

// t = clamp((x - a) / (b - a), 0, 1); r = t t (3 - 2 t); dr = 6 t (1 - t) (dx - da - t (db - da)) /
// (b - a).
ValueId DerivativeRebuilder::DeriveSmoothstep(ValueId old, int axis) {
  std::span<const ValueId> operands = from_.Operands(old);
  ValueId a = Get(operands[0]), b = Get(operands[1]), x = Get(operands[2]);
  ValueId da = ChangeOf(operands[0])[axis], db = ChangeOf(operands[1])[axis],
          dx = ChangeOf(operands[2])[axis];
  if (!da && !db && !dx) return ValueId();
  ir::TypeId type = to_.TypeOf(x);
  ValueId zero = to_.Zero(type), one = to_.Splat(type, 1);
  ValueId width = to_.Op2(Op::kSub, b, a);
  ValueId t = to_.Op3(Op::kClamp, to_.Op2(Op::kDiv, to_.Op2(Op::kSub, x, a), width), zero, one);
  ValueId top = OrZero(dx, type);
  if (da) top = to_.Op2(Op::kSub, top, da);
  if (da || db) {
    ValueId widening = to_.Op2(Op::kSub, OrZero(db, type), OrZero(da, type));
    top = to_.Op2(Op::kSub, top, to_.Op2(Op::kMul, t, widening));
  }
  ValueId slope =
      to_.Op2(Op::kMul, to_.Splat(type, 6), to_.Op2(Op::kMul, t, to_.Op2(Op::kSub, one, t)));
  ValueId quotient = to_.Op2(Op::kDiv, to_.Op2(Op::kMul, slope, top), width);
  return to_.Op3(Op::kSelect, to_.Op2(Op::kNe, width, zero), quotient, zero);
}

void DerivativeRebuilder::DeriveStructure(ValueId old) {
  const ir::Inst& inst = from_[old];
  std::span<const ValueId> operands = from_.Operands(inst);
  if (inst.op == Op::kConstruct && module_.types.Kind(inst.type) == ir::TypeKind::kStruct) {
    uint32_t leaf = 0;
    for (ValueId operand : operands) {
      for (uint32_t l = 0; l < LeafCount(operand); ++l)
        ChangeOf(old, leaf++) = ChangeOf(operand, l);
    }
    return;
  }
  ir::TypeKind from_kind = module_.types.Kind(from_[operands[0]].type);
  bool takes_leaves = from_kind == ir::TypeKind::kStruct || from_kind == ir::TypeKind::kTuple;
  if (inst.op == Op::kExtract && takes_leaves) {
    uint32_t offset = pass_.leaves().Offset(from_[operands[0]].type, inst.aux);
    for (uint32_t l = 0; l < LeafCount(old); ++l)
      ChangeOf(old, l) = ChangeOf(operands[0], offset + l);
    return;
  }
  for (int axis : {0, 1}) {
    std::vector<ValueId> parts;
    bool any = false;
    for (ValueId operand : operands) {
      ValueId change =
          inst.op == Op::kIndex && parts.size() == 1 ? Get(operand) : ChangeOf(operand)[axis];
      any = any || (change && !(inst.op == Op::kIndex && parts.size() == 1));
      parts.push_back(OrZero(change, from_[operand].type));
    }
    // Taking apart and putting together are linear: the same operation on the derivatives.
    if (any) ChangeOf(old)[axis] = to_.Emit(inst.op, inst.type, parts, inst.aux);
  }
}

// --- Calls, branches, loops
// --------------------------------------------------------------------------------------

void DerivativeRebuilder::CopyCall(ValueId old, std::span<ValueId> results) {
  const Demand& callee = *demand_.calls[old.index];
  const ir::Function& old_callee = pass_.old(callee.continuity->function);
  std::span<const ValueId> operands = from_.Operands(old);
  std::vector<ValueId> arguments = GetAll(operands);
  uint32_t leaf = 0;
  for (ValueId operand : operands) {
    for (uint32_t l = 0; l < LeafCount(operand); ++l, ++leaf) {
      if (!callee.parameters[leaf]) continue;
      for (int axis : {0, 1}) {
        arguments.push_back(OrZero(ChangeOf(operand, l)[axis], LeafOf(operand, l).type));
      }
    }
  }
  ValueId call = to_.Call(pass_.Variant(callee), arguments);
  const uint32_t own = static_cast<uint32_t>(old_callee.results.size());
  uint32_t total = own;
  for (bool requested : callee.requested) total += requested ? 2 : 0;
  for (uint32_t i = 0; i < own; ++i) {
    if (live_.LiveResult(old, i)) results[i] = to_.Result(call, i, total);
  }
  uint32_t next = own;
  for (uint32_t l = 0; l < callee.requested.size(); ++l) {
    if (!callee.requested[l]) continue;
    ChangeOf(old, l) = {to_.Extract(call, next), to_.Extract(call, next + 1)};
    next += 2;
  }
  NameChanges(old);
}

std::vector<uint32_t> DerivativeRebuilder::KeptResults(ValueId old) {
  std::vector<uint32_t> kept;
  for (uint32_t i = 0; i < live_.ResultCount(old); ++i) {
    if (live_.LiveResult(old, i)) kept.push_back(i);
  }
  return kept;
}

uint32_t DerivativeRebuilder::FirstLeaf(std::span<const ValueId> elements, uint32_t index) {
  uint32_t leaf = 0;
  for (uint32_t i = 0; i < index; ++i) leaf += LeafCount(elements[i]);
  return leaf;
}

std::vector<std::pair<uint32_t, uint32_t>> DerivativeRebuilder::WantedResults(
    ValueId old, std::span<const ValueId> results) {
  std::vector<std::pair<uint32_t, uint32_t>> wanted;
  uint32_t leaf = 0;
  for (uint32_t i = 0; i < results.size(); ++i) {
    for (uint32_t l = 0; l < LeafCount(results[i]); ++l, ++leaf) {
      if (demand_.Wanted(old, leaf)) wanted.emplace_back(i, l);
    }
  }
  return wanted;
}

void DerivativeRebuilder::AppendChanges(std::span<const ValueId> results,
                                        std::span<const std::pair<uint32_t, uint32_t>> wanted,
                                        std::vector<ValueId>& out) {
  for (auto [i, l] : wanted) {
    for (int axis : {0, 1}) {
      out.push_back(OrZero(ChangeOf(results[i], l)[axis], LeafOf(results[i], l).type));
    }
  }
}

std::vector<ValueId> DerivativeRebuilder::TakeResults(
    ValueId old, ValueId merged, std::span<const uint32_t> kept, std::span<const ValueId> results,
    std::span<const std::pair<uint32_t, uint32_t>> wanted) {
  const uint32_t total = static_cast<uint32_t>(kept.size() + 2 * wanted.size());
  std::vector<ValueId> values(results.size());
  for (uint32_t i = 0; i < kept.size(); ++i) values[kept[i]] = to_.Result(merged, i, total);
  uint32_t next = static_cast<uint32_t>(kept.size());
  for (auto [i, l] : wanted) {
    Change& change = ChangeOf(old, FirstLeaf(results, i) + l);
    change = {to_.Result(merged, next, total), to_.Result(merged, next + 1, total)};
    next += 2;
  }
  NameChanges(old);
  return values;
}

std::vector<ValueId> DerivativeRebuilder::CopyIf(ValueId old) {
  const ir::Branch branch = from_.branches[from_[old].aux];
  const std::vector<uint32_t> kept = KeptResults(old);
  const std::vector<ValueId>& shape = from_.regions[branch.then_region.index].results;
  const auto wanted = WantedResults(old, shape);
  MultiplyAllSlopes();
  ir::RegionId sides[2];
  for (int side : {0, 1}) {
    ir::RegionId region = side ? branch.else_region : branch.then_region;
    const std::vector<ValueId>& results = from_.regions[region.index].results;
    sides[side] = to_.BeginRegion();
    CopyRegion(region);
    std::vector<ValueId> yields;
    for (uint32_t i : kept) yields.push_back(Get(results[i]));
    AppendChanges(results, wanted, yields);
    to_.EndRegion(yields);
    slopes_.clear();
  }
  to_.SetOrigin(from_.OriginOf(old));
  ValueId merged = to_.If(Get(from_.Operands(old)[0]), sides[0], sides[1]);
  return TakeResults(old, merged, kept, shape, wanted);
}

std::vector<ValueId> DerivativeRebuilder::CopyFor(ValueId old) {
  const ir::Inst& inst = from_[old];
  ir::ForLoop loop = from_.loops[inst.aux];
  const ir::Region& body = from_.regions[loop.body.index];
  std::span<const ValueId> carried = std::span(body.params).subspan(1);
  const std::vector<uint32_t> kept = KeptResults(old);
  const auto wanted = WantedResults(old, carried);
  std::vector<ValueId> initial;
  for (uint32_t i : kept) initial.push_back(Get(from_.Operands(inst)[i]));
  AppendChanges(from_.Operands(inst), wanted, initial);

  MultiplyAllSlopes();
  loop.body = to_.BeginRegion();
  Set(body.params[0], to_.AddRegionParameter(ir::kInt));
  to_.Name(Get(body.params[0]), from_.NameOf(body.params[0]));
  for (uint32_t i : kept) {
    Set(carried[i], to_.AddRegionParameter(from_[carried[i]].type));
    to_.Name(Get(carried[i]), from_.NameOf(carried[i]));
  }
  for (auto [i, l] : wanted) {
    ir::TypeId type = LeafOf(carried[i], l).type;
    ValueId dx = to_.AddRegionParameter(type);
    ChangeOf(carried[i], l) = {dx, to_.AddRegionParameter(type)};
    NameChanges(carried[i]);
  }
  CopyRegion(from_.loops[inst.aux].body);
  std::vector<ValueId> next;
  for (uint32_t i : kept) next.push_back(Get(body.results[i]));
  AppendChanges(body.results, wanted, next);
  to_.EndRegion(next);
  slopes_.clear();
  to_.SetOrigin(from_.OriginOf(old));
  ValueId merged = to_.For(loop, initial);
  return TakeResults(old, merged, kept, carried, wanted);
}

// --- Differentiator
// ----------------------------------------------------------------------------------------------

// What the code of a variant depends on: which derivatives it makes, how it samples, and the
// variants that it calls.
std::vector<uint32_t> Differentiator::CodeKey(const Demand& demand) {
  const FunctionContinuity& continuity = *demand.continuity;
  const ir::Function& function = old(continuity.function);
  std::vector<uint32_t> key{continuity.function.index};
  for (bool requested : demand.requested) key.push_back(requested);
  for (size_t i = 0; i < demand.wanted.size(); ++i) {
    if (demand.wanted[i]) key.push_back(static_cast<uint32_t>(i));
  }
  for (const ir::Region& region : function.regions) {
    for (ValueId v : region.body) {
      if (function[v].op == Op::kSample) {
        key.push_back(0xfffffff0u + static_cast<uint32_t>(ModeOfSample(function, continuity, v)));
      } else if (function[v].op == Op::kCall) {
        key.push_back(Variant(*demand.calls[v.index]).index);
      }
    }
  }
  return key;
}

// Whether the demand asks for no derivative anywhere in the function, and every sample stays
// implicit.
bool Differentiator::StaysAsItIs(const Demand& demand) const {
  auto none = [](const std::vector<bool>& flags) {
    return std::ranges::find(flags, true) == flags.end();
  };
  if (!none(demand.wanted) || !none(demand.parameters) || !none(demand.requested)) return false;
  for (const Demand* callee : demand.calls) {
    if (callee && (!none(callee->parameters) || !none(callee->requested))) return false;
  }
  const ir::Function& function = old(demand.continuity->function);
  for (size_t i = 0; i < function.insts.size(); ++i) {
    const Op op = function.insts[i].op;
    if (op == Op::kDx || op == Op::kDy) return false;
    if (op == Op::kSample &&
        ModeOfSample(function, *demand.continuity, ValueId(i)) != SampleMode::kImplicit) {
      return false;
    }
  }
  return true;
}

// The function with its calls turned to the new ones.
ir::Function Differentiator::Retarget(const Demand& demand) {
  ir::Function made = old(demand.continuity->function);
  for (size_t i = 0; i < demand.calls.size(); ++i) {
    if (demand.calls[i]) made.insts[i].aux = Variant(*demand.calls[i]).index;
  }
  return made;
}

FunctionId Differentiator::Variant(const Demand& demand) {
  if (auto known = by_demand_.find(&demand); known != by_demand_.end()) return known->second;
  std::vector<uint32_t> key = CodeKey(demand);
  auto [same, added] = by_code_.try_emplace(std::move(key));
  if (added) {
    const ir::Function& from = old(demand.continuity->function);
    ir::Function made;
    const std::string suffix = by_code_.size() > 1 ? ".d" + std::to_string(by_code_.size()) : "";
    const bool stays = StaysAsItIs(demand);
    if (stays) {
      made = Retarget(demand);
      made.name = from.name + suffix;
    } else {
      made.name = from.name + suffix;
      made.display_name = from.display_name;
      made.origin = from.origin;
      ir::Builder builder(module_, made, {fold_, nullptr});
      ir::Liveness live(module_, from);
      DerivativeRebuilder(*this, module_, from, live, demand, builder).Run();
    }
    module_.functions.push_back(std::move(made));
    changed_.push_back(!stays);
    same->second = FunctionId(module_.functions.size() - 1);
  }
  return by_demand_[&demand] = same->second;
}

std::vector<bool> Differentiator::Run() {
  old_ = std::move(module_.functions);
  module_.functions.clear();
  ContinuityTable continuity(module_, old_, leaves_);
  DemandTable demands(old_, leaves_);
  const FunctionContinuity& states = continuity.Of(module_.main, {}, true);
  module_.main = Variant(demands.Of(states, std::vector<bool>(states.results.size())));
  return changed_;
}

}  // namespace

std::vector<bool> Differentiate(ir::Module& module, bool fold) {
  return Differentiator(module, fold).Run();
}

}  // namespace texgraph::passes
