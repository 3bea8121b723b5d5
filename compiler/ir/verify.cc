// SPDX-License-Identifier: Apache-2.0
#include "compiler/ir/verify.h"

#include <algorithm>
#include <string_view>
#include <unordered_set>

#include "compiler/ir/value_names.h"
#include "compiler/ir/verify_op.h"

namespace texgraph::ir {
namespace {

std::string Quoted(const std::string& name) { return "'" + name + "'"; }

// Each check returns false after it has set `message_`, and `value_` where it is about one.
class FunctionVerifier {
 public:
  FunctionVerifier(const Module& module, FunctionId id)
      : module_(module), types_(module.types), id_(id), f_(module[id]) {}

  std::optional<Violation> Find() {
    if (IdsInRange() && ConstantsFit() && ParametersFit() && RegionFits(f_.body, 1) &&
        ResultsFit()) {
      return std::nullopt;
    }
    return Violation{id_, value_, "function " + f_.name + ": " + Place() + message_};
  }

 private:
  bool Fail(std::string message) {
    message_ = std::move(message);
    return false;
  }
  bool FailAt(ValueId v, std::string message) {
    value_ = v;
    return Fail(std::move(message));
  }
  // The names that Print gives: it declares values in the order in which they are checked here.
  std::string NameOf(ValueId v) {
    ValueNames names(module_, f_);
    for (ValueId declared : declared_) names.Declare(declared);
    return std::string(names(v));
  }
  std::string Place() {
    if (!value_) return "";
    if (std::ranges::find(declared_, value_) == declared_.end()) declared_.push_back(value_);
    return NameOf(value_) + ": ";
  }
  void Declare(ValueId v) {
    Op op = f_[v].op;
    if (op != Op::kConst && op != Op::kGlobal) declared_.push_back(v);
  }

  bool IdsInRange();
  bool ConstantsFit();
  bool ConstantFits(ValueId v);
  bool ParametersFit();
  bool ResultsFit();
  bool RegionFits(RegionId region, uint32_t depth);
  bool InstFits(ValueId v, uint32_t depth);
  bool OperandsInScope(ValueId v);
  bool IfFits(ValueId v, uint32_t depth);
  bool ForFits(ValueId v, uint32_t depth);
  bool Yields(ValueId v, RegionId region, std::string_view which);
  bool DeclareParameter(RegionId region, size_t index, TypeId type, std::string_view what);
  void Show(ValueId v) {
    in_scope_[v.index] = true;
    scope_.push_back(v);
  }
  // The type of the i-th of several results of an if or a loop, and their number.
  size_t ResultCount(TypeId type) const {
    return types_.Kind(type) == TypeKind::kTuple ? types_.ElementCount(type) : 1;
  }
  TypeId ResultType(TypeId type, size_t i) const {
    return types_.Kind(type) == TypeKind::kTuple
               ? types_.ElementType(type, static_cast<uint32_t>(i))
               : type;
  }

  const Module& module_;
  const Types& types_;
  FunctionId id_;
  const Function& f_;
  std::vector<bool> in_scope_;
  std::vector<bool> placed_;  // stands in a body, or is a region's parameter
  std::vector<bool> region_used_;
  std::vector<ValueId> scope_;  // what is in scope, innermost last
  std::vector<ValueId> declared_;
  ValueId value_;
  std::string message_;
};

bool FunctionVerifier::IdsInRange() {
  auto values = [&](const std::vector<ValueId>& ids) {
    return std::ranges::all_of(ids, [&](ValueId v) { return v.index < f_.insts.size(); });
  };
  auto region = [&](RegionId r) { return r.index < f_.regions.size(); };
  bool ok = region(f_.body) && values(f_.operands);
  for (const Region& r : f_.regions) {
    ok = ok && values(r.params) && values(r.body) && values(r.results);
  }
  for (const Branch& branch : f_.branches) {
    ok = ok && region(branch.then_region) && region(branch.else_region);
  }
  for (const ForLoop& loop : f_.loops) ok = ok && region(loop.body);
  for (const Inst& inst : f_.insts) {
    ok = ok && inst.type.index < types_.size() &&
         size_t(inst.first_operand) + inst.operand_count <= f_.operands.size();
    if (inst.op == Op::kIf) ok = ok && inst.aux < f_.branches.size();
    if (inst.op == Op::kFor) ok = ok && inst.aux < f_.loops.size();
  }
  for (const Parameter& parameter : f_.parameters) ok = ok && parameter.type.index < types_.size();
  for (const Result& result : f_.results) ok = ok && result.type.index < types_.size();
  if (!ok) return Fail("an id is out of range");
  in_scope_.assign(f_.insts.size(), false);
  placed_.assign(f_.insts.size(), false);
  region_used_.assign(f_.regions.size(), false);
  return true;
}

bool FunctionVerifier::ConstantsFit() {
  for (size_t i = 0; i < f_.insts.size(); ++i) {
    if (f_.insts[i].op != Op::kConst) continue;
    ValueId v(i);
    if (f_.insts[i].aux >= module_.constant_count()) return FailAt(v, "no such constant");
    if (!ConstantFits(v)) return FailAt(v, "a constant of another type");
    in_scope_[i] = true;
  }
  return true;
}

bool FunctionVerifier::ConstantFits(ValueId v) {
  const Inst& inst = f_[v];
  ConstId id(inst.aux);
  if (module_.constant(id).type != inst.type || !IsPlainType(types_, inst.type)) return false;
  if (!IsVector(inst.type) || !IsBool(inst.type)) return true;
  return std::ranges::all_of(module_.Words(id), [](uint32_t word) { return word <= 1; });
}

bool FunctionVerifier::ParametersFit() {
  const Region& body = f_.regions[f_.body.index];
  if (body.params.size() != f_.parameters.size()) {
    return Fail("its region has " + std::to_string(body.params.size()) + " parameters, not " +
                std::to_string(f_.parameters.size()));
  }
  for (size_t i = 0; i < body.params.size(); ++i) {
    const Parameter& parameter = f_.parameters[i];
    TypeKind kind = types_.Kind(parameter.type);
    bool passable = IsPlainType(types_, parameter.type) || kind == TypeKind::kSampler ||
                    kind == TypeKind::kField;
    if (!passable) {
      return Fail("parameter " + Quoted(parameter.name) + " of type " +
                  types_.Text(parameter.type));
    }
    if (!DeclareParameter(f_.body, i, parameter.type, "parameter")) return false;
  }
  return true;
}

bool FunctionVerifier::DeclareParameter(RegionId region, size_t index, TypeId type,
                                        std::string_view what) {
  ValueId v = f_.regions[region.index].params[index];
  const Inst& inst = f_[v];
  declared_.push_back(v);
  if (inst.op != Op::kParam || inst.operand_count != 0 || inst.aux != index || placed_[v.index]) {
    return FailAt(v, std::string(what) + " " + std::to_string(index) + " is another value");
  }
  if (inst.type != type) {
    return FailAt(
        v, std::string(what) + " of type " + types_.Text(inst.type) + ", not " + types_.Text(type));
  }
  placed_[v.index] = true;
  return true;
}

bool FunctionVerifier::ResultsFit() {
  const Region& body = f_.regions[f_.body.index];
  if (body.results.size() != f_.results.size()) {
    return Fail("returns " + std::to_string(body.results.size()) + " values, not " +
                std::to_string(f_.results.size()));
  }
  for (size_t i = 0; i < f_.results.size(); ++i) {
    TypeId type = f_.results[i].type;
    if (!IsPlainType(types_, type)) return Fail("result of type " + types_.Text(type));
    if (f_[body.results[i]].type != type) {
      return Fail("returns " + types_.Text(f_[body.results[i]].type) + ", not " +
                  types_.Text(type));
    }
  }
  return true;
}

bool FunctionVerifier::RegionFits(RegionId region, uint32_t depth) {
  if (depth > kMaxRegionDepth) {
    return Fail("regions nest deeper than " + std::to_string(kMaxRegionDepth));
  }
  if (region_used_[region.index]) return Fail("a region is used twice");
  region_used_[region.index] = true;
  const size_t outer = scope_.size();
  const Region& r = f_.regions[region.index];
  for (ValueId v : r.params) Show(v);
  for (ValueId v : r.body) {
    if (!InstFits(v, depth)) return false;
    Show(v);
  }
  for (ValueId v : r.results) {
    if (!in_scope_[v.index])
      return Fail("a region yields " + NameOf(v) + ", which is not in scope");
  }
  for (; scope_.size() > outer; scope_.pop_back()) in_scope_[scope_.back().index] = false;
  return true;
}

bool FunctionVerifier::InstFits(ValueId v, uint32_t depth) {
  const Inst& inst = f_[v];
  if (placed_[v.index]) return FailAt(v, "stands in two places");
  if (inst.op == Op::kConst || inst.op == Op::kParam) {
    return FailAt(v, "a constant or a parameter in a body");
  }
  placed_[v.index] = true;
  Declare(v);
  if (!OperandsInScope(v)) return false;
  if (std::string why = CheckInst(module_, id_, inst); !why.empty()) return FailAt(v, why);
  if (inst.op == Op::kIf) return IfFits(v, depth);
  if (inst.op == Op::kFor) return ForFits(v, depth);
  return true;
}

bool FunctionVerifier::OperandsInScope(ValueId v) {
  for (ValueId operand : f_.Operands(v)) {
    if (!in_scope_[operand.index]) {
      return FailAt(v, "uses " + NameOf(operand) + ", which is not in scope");
    }
  }
  return true;
}

// Whether the region's results are what the instruction gives.
bool FunctionVerifier::Yields(ValueId v, RegionId region, std::string_view which) {
  const std::vector<ValueId>& results = f_.regions[region.index].results;
  const TypeId type = f_[v].type;
  bool same = results.size() == ResultCount(type);
  for (size_t i = 0; same && i < results.size(); ++i) {
    TypeId element = ResultType(type, i);
    same = f_[results[i]].type == element && IsPlainType(types_, element);
  }
  return same || FailAt(v, std::string(which) + " does not yield " + types_.Text(type));
}

bool FunctionVerifier::IfFits(ValueId v, uint32_t depth) {
  const Branch& branch = f_.branches[f_[v].aux];
  for (RegionId region : {branch.then_region, branch.else_region}) {
    if (!f_.regions[region.index].params.empty()) return FailAt(v, "a side has parameters");
    if (!RegionFits(region, depth + 1)) return false;
    if (!Yields(v, region, region == branch.then_region ? "then" : "else")) return false;
  }
  return true;
}

bool FunctionVerifier::ForFits(ValueId v, uint32_t depth) {
  const ForLoop& loop = f_.loops[f_[v].aux];
  const Region& body = f_.regions[loop.body.index];
  std::span<const ValueId> initial = f_.Operands(v);
  if (loop.step == 0) return FailAt(v, "a step of 0");
  if (body.params.size() != initial.size() + 1) {
    return FailAt(v, std::to_string(initial.size()) + " first values for " +
                         std::to_string(body.params.size()) + " parameters");
  }
  if (!DeclareParameter(loop.body, 0, kInt, "index")) return false;
  for (size_t i = 0; i < initial.size(); ++i) {
    if (!DeclareParameter(loop.body, i + 1, f_[initial[i]].type, "carried value")) return false;
  }
  if (!RegionFits(loop.body, depth + 1) || !Yields(v, loop.body, "the body")) return false;
  bool same = ResultCount(f_[v].type) == initial.size();
  for (size_t i = 0; same && i < initial.size(); ++i) {
    same = f_[initial[i]].type == ResultType(f_[v].type, i);
  }
  return same || FailAt(v, "first values of another type than " + types_.Text(f_[v].type));
}

// --- The module ----------------------------------------------------------------------------------

std::string GlobalProblem(const Module& module, const Global& global) {
  if (global.type.index >= module.types.size()) return "no such type";
  if (global.value) {
    if (global.value.index >= module.constant_count()) return "no such constant";
    if (module.constant(global.value).type != global.type) return "its default is of another type";
  }
  const std::string text = module.types.Text(global.type);
  switch (global.kind) {
    case GlobalKind::kTexture:
      return IsSampler(global.type) ? "" : "a texture of type " + text;
    case GlobalKind::kSpecialization:
      if (!IsScalar(global.type)) return "a specialization constant of type " + text;
      return global.value ? "" : "a specialization constant without a default";
    default:
      return IsPlainType(module.types, global.type) ? "" : "an input of type " + text;
  }
}

std::optional<Violation> FindInGlobals(const Module& module) {
  std::unordered_set<std::string_view> names;
  for (const Global& global : module.globals) {
    std::string problem = GlobalProblem(module, global);
    if (global.name.empty()) problem = "has no name";
    if (!names.insert(global.name).second) problem = "a second one of that name";
    if (!problem.empty()) return Violation{{}, {}, "global " + global.name + ": " + problem};
  }
  return std::nullopt;
}

}  // namespace

std::optional<Violation> FindViolation(const Module& module) {
  if (auto violation = FindInGlobals(module)) return violation;
  std::unordered_set<std::string_view> names;
  for (size_t i = 0; i < module.functions.size(); ++i) {
    FunctionId id(i);
    const std::string& name = module[id].name;
    if (name.empty()) return Violation{id, {}, "function " + std::to_string(i) + ": has no name"};
    if (!names.insert(name).second) {
      return Violation{id, {}, "function " + name + ": a second one of that name"};
    }
    if (auto violation = FunctionVerifier(module, id).Find()) return violation;
  }
  if (!module.main) return std::nullopt;
  if (module.main.index >= module.functions.size())
    return Violation{{}, {}, "main: no such function"};
  if (!module[module.main].parameters.empty()) {
    return Violation{
        module.main, {}, "function " + module[module.main].name + ": main has parameters"};
  }
  return std::nullopt;
}

std::string Verify(const Module& module) {
  std::optional<Violation> violation = FindViolation(module);
  return violation ? violation->message : "";
}

}  // namespace texgraph::ir
