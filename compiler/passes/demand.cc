// SPDX-License-Identifier: Apache-2.0
#include "compiler/passes/demand.h"

#include <array>
#include <span>

#include "compiler/passes/pattern.h"

namespace texgraph::passes {

using ir::Op;
using ir::ValueId;

namespace {

bool HasDerivative(Continuity state) {
  return state == Continuity::kPlain || state == Continuity::kRough;
}

// Which operands' derivatives the rule of an operation names, a bit each.
uint32_t NamedDerivatives(Op op) {
  static const std::array<uint32_t, ir::kOpCount> kNamed = [] {
    std::array<uint32_t, ir::kOpCount> named{};
    for (int i = 0; i < ir::kOpCount; ++i) {
      std::string_view rule = ir::Info(static_cast<Op>(i)).derivative;
      for (char digit = '0'; digit < '4'; ++digit) {
        const char name[] = {'d', digit};
        if (rule.find(std::string_view(name, 2)) != std::string_view::npos)
          named[i] |= 1u << (digit - '0');
      }
    }
    return named;
  }();
  return kNamed[static_cast<size_t>(op)];
}

// The layer of an array has no part in the footprint: it may jump.
Continuity StateOfCoordinate(const ir::Function& function, const FunctionContinuity& continuity,
                             ValueId sample) {
  const ValueId sampler = function.Operands(sample)[0], coordinate = function.Operands(sample)[1];
  auto state_of = [&](ValueId v) { return continuity.states[continuity.first[v.index]]; };
  const ir::Inst& parts = function[coordinate];
  if (function[sampler].type != ir::kSampler2DArray || parts.op != Op::kConstruct) {
    return state_of(coordinate);
  }
  Continuity state = Continuity::kUniform;
  uint32_t width = 0;
  for (ValueId part : function.Operands(parts)) {
    if (width < 2) state = Join(state, state_of(part));
    width += ir::Width(function[part].type);
  }
  return state;
}

}  // namespace

SampleMode ModeOfSample(const ir::Function& function, const FunctionContinuity& continuity,
                        ValueId sample) {
  const Continuity state = StateOfCoordinate(function, continuity, sample);
  bool continuous = state == Continuity::kPlain || state == Continuity::kUniform;
  if (continuous && continuity.uniform_flow[sample.index]) return SampleMode::kImplicit;
  return HasDerivative(state) ? SampleMode::kGradient : SampleMode::kBase;
}

class DemandScan {
 public:
  DemandScan(DemandTable& table, Demand& out)
      : table_(table),
        leaves_(table.leaves_),
        function_(table.functions_[out.continuity->function.index]),
        continuity_(*out.continuity),
        out_(out) {}

  void Run();

 private:
  struct Item {
    ValueId value;
    uint32_t leaf;
  };
  uint32_t LeafCount(ValueId v) { return leaves_.Count(function_[v].type); }
  void Index();
  void Want(ValueId v, uint32_t leaf);
  void WantAll(ValueId v) {
    for (uint32_t l = 0; l < LeafCount(v); ++l) Want(v, l);
  }
  void Visit(Item item);
  void VisitConstruct(Item item);
  // The element (and the leaf inside it) of a value with several results that a leaf belongs to.
  Item Locate(std::span<const ValueId> elements, uint32_t leaf);
  void VisitParameter(Item item);
  void UpdateCall(ValueId call);

  DemandTable& table_;
  Leaves& leaves_;
  const ir::Function& function_;
  const FunctionContinuity& continuity_;
  Demand& out_;
  std::vector<Item> work_;
  std::vector<bool> nothing_;
  std::unordered_map<ValueId, std::pair<ValueId, uint32_t>>
      carried_;  // loop parameter: loop and index of the carried value
  std::unordered_map<ValueId, uint32_t> first_leaf_;  // function parameter: its first leaf
  std::vector<std::vector<bool>> requests_;  // by value, of calls that are asked for something
};

void DemandScan::Index() {
  uint32_t leaf = 0;
  for (ValueId param : function_.Body().params) {
    first_leaf_[param] = leaf;
    leaf += LeafCount(param);
  }
  out_.parameters.assign(leaf, false);
  out_.wanted.assign(continuity_.states.size(), false);
  for (const ir::Region& region : function_.regions) {
    for (ValueId v : region.body) {
      if (function_[v].op != Op::kFor) continue;
      const ir::Region& body = function_.regions[function_.loops[function_[v].aux].body.index];
      for (uint32_t i = 1; i < body.params.size(); ++i) carried_[body.params[i]] = {v, i - 1};
    }
  }
}

void DemandScan::Want(ValueId v, uint32_t leaf) {
  uint32_t index = continuity_.first[v.index] + leaf;
  if (out_.wanted[index] || !HasDerivative(continuity_.states[index])) return;
  if (!IsDifferentiable(leaves_.Of(function_[v].type)[leaf].type)) return;
  out_.wanted[index] = true;
  work_.push_back({v, leaf});
}

void DemandScan::Run() {
  Index();
  // Calls first: what their own samples need of the arguments.
  for (const ir::Region& region : function_.regions) {
    for (ValueId v : region.body) {
      const ir::Inst& inst = function_[v];
      if (inst.op == Op::kCall) {
        UpdateCall(v);
      } else if (inst.op == Op::kDx || inst.op == Op::kDy) {
        WantAll(function_.Operands(inst)[0]);
      } else if (inst.op == Op::kSample &&
                 ModeOfSample(function_, continuity_, v) == SampleMode::kGradient) {
        Want(function_.Operands(inst)[1], 0);
      }
    }
  }
  uint32_t leaf = 0;
  for (ValueId result : function_.Body().results) {
    for (uint32_t l = 0; l < LeafCount(result); ++l, ++leaf) {
      if (out_.requested[leaf]) Want(result, l);
    }
  }
  while (!work_.empty()) {
    Item item = work_.back();
    work_.pop_back();
    Visit(item);
  }
}

void DemandScan::UpdateCall(ValueId call) {
  const FunctionContinuity& callee = *continuity_.calls[call.index];
  const bool asked = !requests_.empty() && !requests_[call.index].empty();
  if (!asked) nothing_.assign(callee.results.size(), false);
  const Demand& demand = table_.Of(callee, asked ? requests_[call.index] : nothing_);
  if (out_.calls.empty()) out_.calls.resize(function_.insts.size());
  out_.calls[call.index] = &demand;
  uint32_t leaf = 0;
  for (ValueId argument : function_.Operands(call)) {
    for (uint32_t l = 0; l < LeafCount(argument); ++l, ++leaf) {
      if (demand.parameters[leaf]) Want(argument, l);
    }
  }
}

DemandScan::Item DemandScan::Locate(std::span<const ValueId> elements, uint32_t leaf) {
  for (ValueId element : elements) {
    uint32_t count = LeafCount(element);
    if (leaf < count) return {element, leaf};
    leaf -= count;
  }
  return {elements[0], 0};
}

void DemandScan::VisitParameter(Item item) {
  if (auto own = first_leaf_.find(item.value); own != first_leaf_.end()) {
    out_.parameters[own->second + item.leaf] = true;
    return;
  }
  auto carried = carried_.find(item.value);
  if (carried == carried_.end()) return;  // a loop's index
  auto [loop, index] = carried->second;
  const ir::Region& body = function_.regions[function_.loops[function_[loop].aux].body.index];
  Want(function_.Operands(loop)[index], item.leaf);
  Want(body.results[index], item.leaf);
  // The loop yields the derivative too.
  uint32_t leaf = item.leaf;
  for (uint32_t i = 0; i < index; ++i) leaf += LeafCount(body.params[i + 1]);
  Want(loop, leaf);
}

void DemandScan::VisitConstruct(Item item) {
  std::span<const ValueId> operands = function_.Operands(item.value);
  if (LeafCount(item.value) == 1) {
    for (ValueId operand : operands) Want(operand, 0);
    return;
  }
  Item element = Locate(operands, item.leaf);
  Want(element.value, element.leaf);
}

void DemandScan::Visit(Item item) {
  const ir::Inst& inst = function_[item.value];
  std::span<const ValueId> operands = function_.Operands(inst);
  switch (inst.op) {
    case Op::kParam:
      return VisitParameter(item);
    case Op::kGlobal:
      return;
    case Op::kConstruct:
      return VisitConstruct(item);
    case Op::kExtract:
      return Want(operands[0], leaves_.Offset(function_[operands[0]].type, inst.aux) + item.leaf);
    case Op::kSelect:
      Want(operands[1], item.leaf);
      return Want(operands[2], item.leaf);
    case Op::kSample:
    case Op::kSampleGrad:
    case Op::kSampleLod:
      return Want(operands[1], 0);
    case Op::kSmoothstep:
      for (ValueId operand : operands) Want(operand, 0);
      return;
    case Op::kSwizzle:
    case Op::kIndex:
    case Op::kConvert:
      return Want(operands[0], 0);
    case Op::kIf: {
      const ir::Branch& branch = function_.branches[inst.aux];
      Item on_true = Locate(function_.regions[branch.then_region.index].results, item.leaf);
      Item on_false = Locate(function_.regions[branch.else_region.index].results, item.leaf);
      Want(on_true.value, on_true.leaf);
      return Want(on_false.value, on_false.leaf);
    }
    case Op::kFor: {
      const ir::Region& body = function_.regions[function_.loops[inst.aux].body.index];
      Item carried = Locate(std::span(body.params).subspan(1), item.leaf);
      return Want(carried.value, carried.leaf);
    }
    case Op::kCall:
      if (requests_.empty()) requests_.resize(function_.insts.size());
      requests_[item.value.index].resize(continuity_.calls[item.value.index]->results.size());
      requests_[item.value.index][item.leaf] = true;
      return UpdateCall(item.value);
    default:
      for (size_t i = 0; i < operands.size(); ++i) {
        if (NamedDerivatives(inst.op) >> i & 1) Want(operands[i], 0);
      }
  }
}

const Demand& DemandTable::Of(const FunctionContinuity& continuity,
                              const std::vector<bool>& requested) {
  std::vector<std::unique_ptr<Demand>>& all = known_[&continuity];
  for (const std::unique_ptr<Demand>& known : all) {
    if (known->requested == requested) return *known;
  }
  Demand& made = *all.emplace_back(std::make_unique<Demand>());
  made.continuity = &continuity;
  made.requested = requested;
  DemandScan(*this, made).Run();
  return made;
}

}  // namespace texgraph::passes
