// SPDX-License-Identifier: Apache-2.0
#include "compiler/passes/continuity.h"

#include <algorithm>
#include <span>

namespace texgraph::passes {

using ir::Op;
using ir::ValueId;
using enum Continuity;

namespace {

// Of a continuous operation on two values.
Continuity Join(Continuity a, Continuity b) {
  if (a == b || b == kUniform) return a;
  if (a == kUniform) return b;
  return kRough;
}

// Of an operation that is constant between jumps.
Continuity Step(Continuity a) { return a == kUniform ? kUniform : kStepped; }

// Of an operation that jumps and has a derivative between.
Continuity Jump(Continuity a) { return a == kPlain ? kRough : a; }

// One of two values, as something says that may itself jump.
Continuity Choose(Continuity choice, Continuity a, Continuity b) {
  if (choice == kUniform) return Join(a, b);
  bool flat = (a == kUniform || a == kStepped) && (b == kUniform || b == kStepped);
  return flat ? kStepped : kRough;
}

}  // namespace

// Fills one FunctionContinuity.
class ContinuityScan {
 public:
  ContinuityScan(ContinuityTable& table, FunctionContinuity& out)
      : table_(table),
        module_(table.module_),
        leaves_(table.leaves_),
        function_(table.functions_[out.function.index]),
        out_(out) {}

  void Run(const std::vector<Continuity>& parameters, bool uniform_flow);

 private:
  std::span<Continuity> States(ValueId v) {
    return {out_.states.data() + out_.first[v.index], leaves_.Count(function_[v].type)};
  }
  Continuity JoinOperands(ValueId v);
  void Region(ir::RegionId region, bool uniform_flow);
  void Visit(ValueId v, bool uniform_flow);
  void VisitStructure(ValueId v);
  void VisitIf(ValueId v, bool uniform_flow);
  void VisitFor(ValueId v);
  void VisitCall(ValueId v, bool uniform_flow);
  Continuity OfSample(ValueId v);
  Continuity OfGlobal(const ir::Inst& inst) const;

  ContinuityTable& table_;
  const ir::Module& module_;
  Leaves& leaves_;
  const ir::Function& function_;
  FunctionContinuity& out_;
  std::vector<Continuity> arguments_;  // of one call at a time
};

void ContinuityScan::Run(const std::vector<Continuity>& parameters, bool uniform_flow) {
  uint32_t total = 0;
  for (const ir::Inst& inst : function_.insts) {
    out_.first.push_back(total);
    total += leaves_.Count(inst.type);
  }
  out_.states.assign(total, kUniform);
  out_.uniform_flow.assign(function_.insts.size(), false);
  size_t next = 0;
  for (ValueId param : function_.Body().params) {
    for (Continuity& state : States(param)) state = parameters[next++];
  }
  Region(function_.body, uniform_flow);
  for (ValueId result : function_.Body().results) {
    std::span<Continuity> states = States(result);
    out_.results.insert(out_.results.end(), states.begin(), states.end());
  }
}

void ContinuityScan::Region(ir::RegionId region, bool uniform_flow) {
  for (ValueId v : function_.regions[region.index].body) Visit(v, uniform_flow);
}

Continuity ContinuityScan::JoinOperands(ValueId v) {
  Continuity state = kUniform;
  for (ValueId operand : function_.Operands(v)) {
    for (Continuity leaf : States(operand)) state = Join(state, leaf);
  }
  return state;
}

Continuity ContinuityScan::OfGlobal(const ir::Inst& inst) const {
  return module_.globals[inst.aux].kind == ir::GlobalKind::kInput ? kPlain : kUniform;
}

Continuity ContinuityScan::OfSample(ValueId v) {
  Continuity state = JoinOperands(v);
  const ir::Inst& sampler = function_[function_.Operands(v)[0]];
  bool is_smooth = sampler.op == Op::kGlobal && module_.globals[sampler.aux].is_smooth;
  return is_smooth ? state : Jump(state);
}

void ContinuityScan::Visit(ValueId v, bool uniform_flow) {
  const ir::Inst& inst = function_[v];
  out_.uniform_flow[v.index] = uniform_flow;
  std::span<const ValueId> operands = function_.Operands(inst);
  Continuity state = kUniform;
  switch (inst.op) {
    case Op::kGlobal:
      state = OfGlobal(inst);
      break;
    case Op::kFloor:
    case Op::kCeil:
    case Op::kTrunc:
    case Op::kRound:
    case Op::kStep:
    case Op::kSign:
    case Op::kBitcast:
    case Op::kFetch:
    case Op::kDx:
    case Op::kDy:
    case Op::kDfdx:
    case Op::kDfdy:
      state = Step(JoinOperands(v));
      break;
    case Op::kFract:
    case Op::kFmod:
    case Op::kAtan2:
      state = Jump(JoinOperands(v));
      break;  // atan jumps where the angle comes round
    case Op::kConvert:
      state = ir::IsFloat(inst.type) ? JoinOperands(v) : Step(JoinOperands(v));
      break;
    case Op::kSelect:
      for (size_t l = 0; l < States(v).size(); ++l) {
        States(v)[l] =
            Choose(States(operands[0])[0], States(operands[1])[l], States(operands[2])[l]);
      }
      return;
    case Op::kIndex:
      state = Choose(States(operands[1])[0], States(operands[0])[0], kUniform);
      break;
    case Op::kSample:
    case Op::kSampleGrad:
    case Op::kSampleLod:
      state = OfSample(v);
      break;
    case Op::kConstruct:
    case Op::kExtract:
      return VisitStructure(v);
    case Op::kIf:
      return VisitIf(v, uniform_flow);
    case Op::kFor:
      return VisitFor(v);
    case Op::kCall:
      return VisitCall(v, uniform_flow);
    default: {
      state = JoinOperands(v);
      bool is_float = ir::IsFloat(inst.type);
      if (!is_float) state = Step(state);
    }
  }
  for (Continuity& leaf : States(v)) leaf = state;
}

void ContinuityScan::VisitStructure(ValueId v) {
  const ir::Inst& inst = function_[v];
  std::span<Continuity> states = States(v);
  if (inst.op == Op::kExtract) {
    ValueId from = function_.Operands(inst)[0];
    uint32_t offset = leaves_.Offset(function_[from].type, inst.aux);
    std::copy_n(States(from).begin() + offset, states.size(), states.begin());
    return;
  }
  ir::TypeKind kind = module_.types.Kind(inst.type);
  if (kind != ir::TypeKind::kStruct && kind != ir::TypeKind::kTuple) {
    states[0] = JoinOperands(v);
    return;
  }
  size_t next = 0;
  for (ValueId operand : function_.Operands(inst)) {
    for (Continuity leaf : States(operand)) states[next++] = leaf;
  }
}

void ContinuityScan::VisitIf(ValueId v, bool uniform_flow) {
  const ir::Branch& branch = function_.branches[function_[v].aux];
  Continuity condition = States(function_.Operands(v)[0])[0];
  bool inner = uniform_flow && condition == kUniform;
  Region(branch.then_region, inner);
  Region(branch.else_region, inner);
  const std::vector<ValueId>& on_true = function_.regions[branch.then_region.index].results;
  const std::vector<ValueId>& on_false = function_.regions[branch.else_region.index].results;
  size_t next = 0;
  for (size_t i = 0; i < on_true.size(); ++i) {
    for (size_t l = 0; l < States(on_true[i]).size(); ++l) {
      States(v)[next++] = Choose(condition, States(on_true[i])[l], States(on_false[i])[l]);
    }
  }
}

void ContinuityScan::VisitFor(ValueId v) {
  const ir::Region& body = function_.regions[function_.loops[function_[v].aux].body.index];
  std::span<const ValueId> initial = function_.Operands(v);
  for (size_t i = 0; i < initial.size(); ++i) {
    std::ranges::copy(States(initial[i]), States(body.params[i + 1]).begin());
  }
  // States only rise, so this ends after few rounds.
  for (bool changed = true; changed;) {
    changed = false;
    Region(function_.loops[function_[v].aux].body, false);
    for (size_t i = 0; i < initial.size(); ++i) {
      for (size_t l = 0; l < States(initial[i]).size(); ++l) {
        Continuity& carried = States(body.params[i + 1])[l];
        Continuity joined = Join(carried, States(body.results[i])[l]);
        changed = changed || joined != carried;
        carried = joined;
      }
    }
  }
  size_t next = 0;
  for (size_t i = 0; i < initial.size(); ++i) {
    for (Continuity leaf : States(body.params[i + 1])) States(v)[next++] = leaf;
  }
}

void ContinuityScan::VisitCall(ValueId v, bool uniform_flow) {
  arguments_.clear();
  for (ValueId operand : function_.Operands(v)) {
    for (Continuity leaf : States(operand)) arguments_.push_back(leaf);
  }
  const FunctionContinuity& callee =
      table_.Of(ir::FunctionId(function_[v].aux), arguments_, uniform_flow);
  if (out_.calls.empty()) out_.calls.resize(function_.insts.size());
  out_.calls[v.index] = &callee;
  std::ranges::copy(callee.results, States(v).begin());
}

const FunctionContinuity& ContinuityTable::Of(ir::FunctionId function,
                                              const std::vector<Continuity>& parameters,
                                              bool uniform_flow) {
  key_.clear();
  for (int shift = 0; shift < 32; shift += 8)
    key_.push_back(static_cast<uint8_t>(function.index >> shift));
  key_.push_back(uniform_flow);
  for (Continuity state : parameters) key_.push_back(static_cast<uint8_t>(state));
  std::unique_ptr<FunctionContinuity>& known = known_[key_];
  if (!known) {
    known = std::make_unique<FunctionContinuity>();
    FunctionContinuity* made = known.get();  // the map may grow below; the object stays
    made->function = function;
    ContinuityScan(*this, *made).Run(parameters, uniform_flow);
    return *made;
  }
  return *known;
}

}  // namespace texgraph::passes
