// SPDX-License-Identifier: Apache-2.0
// Specialize: every function port is bound to a function, every constant that decides something is
// built into the function it is passed to, and small functions are copied into their callers.
// Fields stay functions: a four-tap field nested d deep is d functions, not 4^d copies.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <deque>
#include <limits>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "compiler/ir/loop_end.h"
#include "compiler/ir/rebuild.h"
#include "compiler/passes/narrow_structs.h"
#include "compiler/passes/passes.h"

namespace texgraph::passes {
namespace {

using ir::ConstId;
using ir::FunctionId;
using ir::Op;
using ir::ValueId;

constexpr size_t kMaxInstances = 4096;
constexpr size_t kMaxCallDepth = 64;
// Beyond so many variants of one function by constants, constants are passed as arguments.
constexpr uint32_t kMaxVariants = 16;
// Functions of at most so many operations, and without branches, are copied into their callers.
constexpr int kMaxInlined = 5;
// Operations for one pixel, with all loops and calls run through.
constexpr uint64_t kMaxCost = 50'000'000;

// What a parameter of an instance is bound to.
struct Binding {
  enum class Kind : uint8_t { kNone, kConst, kField, kMap };
  Kind kind = Kind::kNone;
  uint32_t id = 0;        // ConstId, FunctionId among the old functions, or GlobalId of a texture
  uint32_t captures = 0;  // kField: how many parameters stand in its place
  ConstId home;           // kField that knows its home: that, if it is constant; no parameter then
};

struct FieldBinding {
  FunctionId function;  // among the old functions
  std::vector<ValueId> captured;
};

bool MakesNoWork(Op op) {
  switch (op) {
    case Op::kExtract:
    case Op::kSwizzle:
    case Op::kSplat:
    case Op::kConstruct:
    case Op::kConvert:
    case Op::kBitcast:
    case Op::kGlobal:
      return true;
    default:
      return false;
  }
}

bool IsInlined(const ir::Function& function) {
  int work = 0;
  for (ValueId v : function.Body().body) {
    Op op = function[v].op;
    if (op == Op::kIf || op == Op::kFor) return false;
    if (!MakesNoWork(op) && ++work > kMaxInlined) return false;
  }
  return true;
}

// The parameters that integers are divided by: a power of two makes a mask or a shift of it.
std::vector<bool> DividingParameters(const ir::Function& function,
                                     const std::vector<std::vector<bool>>& callees) {
  std::vector<bool> dividing(function.parameters.size());
  auto mark = [&](ValueId v) {
    const ir::Inst& inst = function[v];
    if (inst.op == Op::kParam) dividing[inst.aux] = true;
  };
  for (const ir::Inst& inst : function.insts) {
    std::span<const ValueId> operands = function.Operands(inst);
    if ((inst.op == Op::kMod || inst.op == Op::kDiv) && ir::IsInteger(inst.type)) {
      mark(operands[1]);
    } else if (inst.op == Op::kCall) {
      for (size_t i = 0; i < operands.size(); ++i) {
        if (callees[inst.aux][i]) mark(operands[i]);
      }
    }
  }
  return dividing;
}

// The parameters that decide something: they reach a comparison, a selection, a branch or an index
// through plain steps, so that a constant makes code disappear. By parameter.
std::vector<bool> DecidingParameters(const ir::Function& function,
                                     const std::vector<std::vector<bool>>& callees) {
  std::vector<ValueId> work;
  for (const ir::Inst& inst : function.insts) {
    std::span<const ValueId> operands = function.Operands(inst);
    switch (inst.op) {
      case Op::kLt:
      case Op::kLe:
      case Op::kEq:
      case Op::kNe:
        work.insert(work.end(), operands.begin(), operands.end());
        break;
      case Op::kIf:
      case Op::kSelect:
        work.push_back(operands[0]);
        break;
      case Op::kIndex:
        work.push_back(operands[1]);
        break;
      case Op::kCall:
        for (size_t i = 0; i < operands.size(); ++i) {
          if (callees[inst.aux][i]) work.push_back(operands[i]);
        }
        break;
      default:
        break;
    }
  }
  std::vector<bool> seen(function.insts.size()), deciding(function.parameters.size());
  while (!work.empty()) {
    ValueId v = work.back();
    work.pop_back();
    if (seen[v.index]) continue;
    seen[v.index] = true;
    const ir::Inst& inst = function[v];
    switch (inst.op) {
      case Op::kAdd:
      case Op::kSub:
      case Op::kNeg:
      case Op::kMin:
      case Op::kMax:
      case Op::kAbs:
      case Op::kLogicalAnd:
      case Op::kLogicalOr:
      case Op::kLogicalNot:
      case Op::kConvert:
      case Op::kExtract:
      case Op::kSwizzle:
      case Op::kConstruct:
      case Op::kSplat:
      case Op::kAny:
      case Op::kAll:
        for (ValueId operand : function.Operands(inst)) work.push_back(operand);
        break;
      default:
        break;
    }
  }
  const std::vector<ValueId>& params = function.Body().params;
  for (size_t p = 0; p < params.size(); ++p) deciding[p] = seen[params[p].index];
  return deciding;
}

class Specializer {
 public:
  Specializer(ir::Module& module, bool fold, SourceRange where, Diagnostics& diagnostics);
  bool Run();

  struct Callee {
    FunctionId id;  // among the new functions; invalid after an error
    bool inlined = false;
  };
  // `bindings` by parameter. The suffix, a node's name, tells apart functions of one name.
  Callee Instance(FunctionId old, std::span<const Binding> bindings, std::string_view suffix);
  // Whether this constant is worth a function of its own.
  bool Binds(FunctionId callee, size_t parameter, ConstId value) const;
  bool IsPowerOfTwo(ConstId value) const;
  bool MayBind(FunctionId callee) const { return fold_ && variants_[callee.index] < kMaxVariants; }
  const ir::Function& old(FunctionId id) const { return old_[id.index]; }
  bool folds() const { return fold_; }
  bool failed() const { return failed_; }

 private:
  void CountCalls();
  void NameInstances();
  bool CheckCost();
  void Refuse(const std::string& message);

  ir::Module& module_;
  const bool fold_;
  const SourceRange where_;
  Diagnostics& diagnostics_;
  std::deque<ir::Function> old_;
  std::vector<std::vector<bool>> deciding_, dividing_;
  std::vector<uint32_t> sites_;     // calls of each old function in the old module
  std::vector<uint32_t> variants_;  // instances of each old function
  struct Made {
    FunctionId old;
    std::string suffix;
    bool is_small;
  };
  std::vector<Made> made_;  // by new FunctionId
  std::map<std::vector<uint32_t>, FunctionId> instances_;
  std::vector<uint32_t> key_;       // of the instance that is asked for
  std::vector<std::string> chain_;  // display names from main to the function being made
  bool failed_ = false;
};

// Copies one old function with its parameters bound.
class InstanceRebuilder : public ir::Rebuilder {
 public:
  InstanceRebuilder(Specializer& specializer, ir::Module& module, const ir::Function& from,
                    const ir::Liveness& live, ir::Builder& to, std::string_view suffix)
      : Rebuilder(module, from, live, to), specializer_(specializer), suffix_(suffix) {}

  void BindParameters(std::span<const Binding> bindings);

 protected:
  ValueId Copy(ValueId old) override;
  void CopyCall(ValueId old, std::span<ValueId> results) override;

 private:
  // Calls an instance of `callee`, the small ones by copying them here. `old_arguments` are the old
  // function's values, then come new ones.
  void CallInstance(ValueId old, FunctionId callee, std::span<const ValueId> old_arguments,
                    std::span<const ValueId> captured, std::span<ValueId> results);

  // The texture of whole numbers that a value is; null if it is none.
  const ir::Global* MapOf(ValueId value) const;
  ValueId SizeOfMap(const ir::MapFacts& map, ir::TypeId type);
  ValueId FetchFromMap(const ir::Global& map, ValueId cell);

  Specializer& specializer_;
  const std::string_view suffix_;
  std::unordered_map<ValueId, FieldBinding> fields_;
  // Of one call at a time.
  std::vector<Binding> bindings_;
  std::vector<ValueId> arguments_;
};

void InstanceRebuilder::BindParameters(std::span<const Binding> bindings) {
  for (size_t i = 0; i < from_.parameters.size(); ++i) {
    ValueId param = from_.Body().params[i];
    const Binding& binding = bindings[i];
    if (binding.kind == Binding::Kind::kNone) {
      Set(param, to_.AddParameter(from_.parameters[i]));
    } else if (binding.kind == Binding::Kind::kConst) {
      Set(param, to_.Const(ConstId(binding.id)));
    } else if (binding.kind == Binding::Kind::kMap) {
      Set(param, to_.Global(ir::GlobalId(binding.id)));
    } else {
      const ir::Function& field = specializer_.old(FunctionId(binding.id));
      FieldBinding bound{FunctionId(binding.id), {}};
      size_t first = field.parameters.size() - binding.captures;
      for (size_t c = 0; c < binding.captures; ++c) {
        bool is_home = binding.home && c + 2 == binding.captures;
        bound.captured.push_back(is_home ? to_.Const(binding.home)
                                         : to_.AddParameter(field.parameters[first + c]));
      }
      fields_.emplace(param, std::move(bound));
    }
  }
}

ValueId InstanceRebuilder::Copy(ValueId old) {
  const ir::Inst& inst = from_[old];
  std::span<const ValueId> operands = from_.Operands(inst);
  if (inst.op == Op::kFieldRef) {
    fields_.emplace(old, FieldBinding{FunctionId(inst.aux), GetAll(operands)});
    return ValueId();
  }
  if (inst.op == Op::kCallField) {
    const FieldBinding field = fields_.at(operands[0]);
    const ir::Function& function = specializer_.old(field.function);
    const ir::Inst& result_inst = function[function.Body().results[0]];
    if (result_inst.op == Op::kConst) return to_.Const(ConstId(result_inst.aux));
    if (function.knows_home && Get(operands[1]) == field.captured.end()[-2]) {
      return field.captured.back();
    }
    ValueId result;
    CallInstance(old, field.function, operands.subspan(1), field.captured, {&result, 1});
    return result;
  }
  if ((inst.op == Op::kFetch || inst.op == Op::kTextureSize) && specializer_.folds()) {
    if (const ir::Global* map = MapOf(Get(operands[0]))) {
      if (inst.op == Op::kTextureSize) return SizeOfMap(*map->map, inst.type);
      if (!map->map->values.empty()) return FetchFromMap(*map, Get(operands[1]));
    }
  }
  return Rebuilder::Copy(old);
}

const ir::Global* InstanceRebuilder::MapOf(ValueId value) const {
  const ir::Inst& inst = to_[value];
  if (inst.op != Op::kGlobal || !module_.globals[inst.aux].map) return nullptr;
  return &module_.globals[inst.aux];
}

ValueId InstanceRebuilder::SizeOfMap(const ir::MapFacts& map, ir::TypeId type) {
  const uint32_t size[] = {map.width, map.height, map.layers};
  return to_.Const(type, std::span(size).first(ir::Width(type)));
}

// From an array that the shader has as a constant. An index keeps within its array.
ValueId InstanceRebuilder::FetchFromMap(const ir::Global& map, ValueId cell) {
  const std::vector<int32_t>& values = map.map->values;
  const std::vector<uint32_t> words(values.begin(), values.end());
  const ConstId numbers =
      module_.Intern(module_.types.Array(ir::kInt, static_cast<uint32_t>(words.size())), words);
  module_.constant_names.try_emplace(numbers, module_.InternName(map.name));
  const ValueId row =
      to_.Op2(Op::kMul, to_.Extract(cell, 1), to_.Int(static_cast<int32_t>(map.map->width)));
  const ValueId at = to_.Op2(Op::kAdd, row, to_.Extract(cell, 0));
  const ValueId number =
      to_.Convert(to_.Emit(Op::kIndex, ir::kInt, {to_.Const(numbers), at}), ir::kFloat);
  return to_.Construct(ir::kVec4, {{number, to_.Float(0), to_.Float(0), to_.Float(1)}});
}

void InstanceRebuilder::CopyCall(ValueId old, std::span<ValueId> results) {
  const ir::Inst& inst = from_[old];
  CallInstance(old, FunctionId(inst.aux), from_.Operands(inst), {}, results);
}

void InstanceRebuilder::CallInstance(ValueId old, FunctionId callee,
                                     std::span<const ValueId> old_arguments,
                                     std::span<const ValueId> captured,
                                     std::span<ValueId> results) {
  bindings_.clear();
  arguments_.clear();
  auto is_constant = [&](ValueId argument) {
    return !fields_.contains(argument) && to_.IsConst(Get(argument));
  };
  // A call with nothing but constants is most often a constant itself.
  const bool all_constant = captured.empty() && specializer_.MayBind(callee) &&
                            std::ranges::all_of(old_arguments, is_constant);
  auto pass = [&](ValueId argument) {
    size_t parameter = bindings_.size();
    if (MapOf(argument) && specializer_.MayBind(callee)) {
      bindings_.push_back({Binding::Kind::kMap, to_[argument].aux, 0, ConstId()});
    } else if (all_constant ||
               (to_.IsConst(argument) &&
                specializer_.Binds(callee, parameter, ConstId(to_[argument].aux)))) {
      bindings_.push_back({Binding::Kind::kConst, to_[argument].aux, 0, ConstId()});
    } else {
      bindings_.push_back({});
      arguments_.push_back(argument);
    }
  };
  for (ValueId argument : old_arguments) {
    auto field = fields_.find(argument);
    if (field == fields_.end()) {
      pass(Get(argument));
      continue;
    }
    const FieldBinding& bound = field->second;
    Binding binding{Binding::Kind::kField, bound.function.index,
                    static_cast<uint32_t>(bound.captured.size()), ConstId()};
    for (size_t c = 0; c < bound.captured.size(); ++c) {
      const ir::Inst& value = to_[bound.captured[c]];
      if (specializer_.old(bound.function).knows_home && c + 2 == bound.captured.size() &&
          value.op == Op::kConst) {
        binding.home = ConstId(value.aux);
      } else {
        arguments_.push_back(bound.captured[c]);
      }
    }
    bindings_.push_back(binding);
  }
  for (ValueId argument : captured) pass(argument);

  ir::OriginId origin = from_.OriginOf(old);
  bool in_node = origin && !module_.origins[origin.index].node.empty();
  Specializer::Callee made = specializer_.Instance(
      callee, bindings_, in_node ? module_.origins[origin.index].node : suffix_);
  if (specializer_.failed()) {
    // Whatever is made from now on is thrown away, but it must have its type.
    const std::vector<ir::Result>& types = specializer_.old(callee).results;
    for (size_t i = 0; i < results.size(); ++i) results[i] = to_.Zero(types[i].type);
    return;
  }
  if (made.inlined) return CopyInline(module_[made.id], arguments_, to_, results);
  TakeResults(old, to_.Call(made.id, arguments_), results);
}

// --- Specializer
// -------------------------------------------------------------------------------------------------

Specializer::Specializer(ir::Module& module, bool fold, SourceRange where, Diagnostics& diagnostics)
    : module_(module), fold_(fold), where_(where), diagnostics_(diagnostics) {
  old_ = std::move(module.functions);
  module.functions.clear();
  variants_.assign(old_.size(), 0);
  CountCalls();
}

void Specializer::CountCalls() {
  sites_.assign(old_.size(), 0);
  for (const ir::Function& function : old_) {
    for (const ir::Inst& inst : function.insts) {
      if (inst.op == Op::kCall || inst.op == Op::kFieldRef) ++sites_[inst.aux];
    }
    deciding_.push_back(DecidingParameters(function, deciding_));
    dividing_.push_back(DividingParameters(function, dividing_));
  }
}

// A vector: each component.
bool Specializer::IsPowerOfTwo(ConstId value) const {
  return std::ranges::all_of(module_.Words(value),
                             [](uint32_t word) { return std::has_single_bit(word); });
}

bool Specializer::Binds(FunctionId callee, size_t parameter, ConstId value) const {
  if (!MayBind(callee)) return false;
  if (sites_[callee.index] == 1 || deciding_[callee.index][parameter]) return true;
  ir::TypeId type = module_.constant(value).type;
  if (dividing_[callee.index][parameter] && IsPowerOfTwo(value)) return true;
  if (ir::IsBool(type)) return true;
  // A cell that is no other than this one makes fields plain values; how many cells there are, and
  // which of those around, makes most of a grid known.
  if (type == ir::kIvec2) return true;
  if (!ir::IsFloat(type)) return false;
  // All zeros or all ones: terms vanish.
  std::span<const uint32_t> words = module_.Words(value);
  uint32_t first = words[0] & 0x7fffffffu;
  if (first != 0 && words[0] != std::bit_cast<uint32_t>(1.0f)) return false;
  return std::ranges::all_of(words, [&](uint32_t word) {
    return word == words[0] || (first == 0 && (word & 0x7fffffffu) == 0);
  });
}

void Specializer::Refuse(const std::string& message) {
  if (failed_) return;
  failed_ = true;
  std::string chain;
  for (size_t i = 0; i < chain_.size(); ++i) {
    bool shown = i < 4 || i + 4 >= chain_.size();
    if (shown) chain += (i ? " -> " : "") + chain_[i];
    if (i == 4 && !shown) chain += " -> ...";
  }
  diagnostics_.Error(DiagnosticKind::kInstanceLimit, where_, message)
      .AddNote(where_, "through " + chain);
}

Specializer::Callee Specializer::Instance(FunctionId id, std::span<const Binding> bindings,
                                          std::string_view suffix) {
  if (failed_) return {};
  key_.assign(1, id.index);
  for (const Binding& binding : bindings) {
    key_.push_back(static_cast<uint32_t>(binding.kind));
    key_.push_back(binding.id);
    key_.push_back(binding.home.index);
  }
  if (auto known = instances_.find(key_); known != instances_.end()) {
    return {known->second, made_[known->second.index].is_small};
  }
  std::vector<uint32_t> key = key_;
  const ir::Function& from = old_[id.index];
  chain_.push_back(from.display_name);
  if (chain_.size() > kMaxCallDepth) {
    Refuse(fmt::format("functions call one another more than {} deep", kMaxCallDepth));
  } else if (instances_.size() >= kMaxInstances) {
    Refuse(fmt::format("the graph needs more than {} functions once its function ports are bound",
                       kMaxInstances));
  }
  if (failed_) return {};
  ++variants_[id.index];
  ir::Function made;
  made.name = from.name;
  // Not with a dot: that is how the block library tells its functions apart.
  if (variants_[id.index] > 1) made.name += fmt::format("/{}", variants_[id.index]);
  made.display_name = from.display_name;
  made.origin = from.origin;
  made.results = from.results;
  {
    ir::Builder builder(module_, made, {fold_, nullptr});
    ir::Liveness live(module_, from);
    InstanceRebuilder rebuilder(*this, module_, from, live, builder, suffix);
    rebuilder.BindParameters(bindings);
    rebuilder.CopyRegion(from.body);
    builder.Return(rebuilder.GetAll(from.Body().results));
  }
  chain_.pop_back();
  if (failed_) return {};
  made_.push_back({id, std::string(suffix), fold_ && IsInlined(made)});
  module_.functions.push_back(std::move(made));
  FunctionId result(module_.functions.size() - 1);
  instances_.emplace(std::move(key), result);
  return {result, made_.back().is_small};
}

// A function that is alone keeps its block's name, and so does each of several overloads; several
// instances of one are told apart by the node that asked first.
void Specializer::NameInstances() {
  std::map<std::string, int> alike;
  auto overload = [&](size_t i) {
    std::string key = module_.functions[i].display_name;
    for (const ir::Parameter& parameter : old_[made_[i].old.index].parameters) {
      key += ' ' + std::to_string(parameter.type.index);
    }
    return key;
  };
  for (size_t i = 0; i < made_.size(); ++i) {
    if (!made_[i].is_small) ++alike[overload(i)];
  }
  for (size_t i = 0; i < made_.size(); ++i) {
    if (made_[i].suffix.empty() || alike[overload(i)] < 2) continue;
    ir::Function& function = module_.functions[i];
    if (!function.display_name.ends_with("_" + made_[i].suffix)) {
      function.display_name += "_" + made_[i].suffix;
    }
  }
}

uint64_t SaturatingAdd(uint64_t a, uint64_t b) {
  return a > std::numeric_limits<uint64_t>::max() - b ? std::numeric_limits<uint64_t>::max()
                                                      : a + b;
}

uint64_t SaturatingMultiply(uint64_t a, uint64_t b) {
  return b && a > std::numeric_limits<uint64_t>::max() / b ? std::numeric_limits<uint64_t>::max()
                                                           : a * b;
}

uint64_t RegionCost(const ir::Function& function, ir::RegionId region,
                    const std::vector<uint64_t>& callees) {
  uint64_t cost = 0;
  for (ValueId v : function.regions[region.index].body) {
    const ir::Inst& inst = function[v];
    uint64_t one = Info(inst.op).cost;
    if (inst.op == Op::kCall) one = SaturatingAdd(one, callees[inst.aux]);
    if (inst.op == Op::kIf) {
      const ir::Branch& branch = function.branches[inst.aux];
      one = SaturatingAdd(one, RegionCost(function, branch.then_region, callees));
      one = SaturatingAdd(one, RegionCost(function, branch.else_region, callees));
    } else if (inst.op == Op::kFor) {
      const ir::ForLoop& loop = function.loops[inst.aux];
      one = SaturatingAdd(one, SaturatingMultiply(std::max(ir::TypicalRounds(function, loop), 1u),
                                                  RegionCost(function, loop.body, callees)));
    }
    cost = SaturatingAdd(cost, one);
  }
  return cost;
}

// Of every function, with all that it calls.
std::vector<uint64_t> Costs(const ir::Module& module) {
  std::vector<uint64_t> costs;
  for (const ir::Function& function : module.functions) {
    costs.push_back(RegionCost(function, function.body, costs));
  }
  return costs;
}

bool Specializer::CheckCost() {
  const std::vector<uint64_t> costs = Costs(module_);
  if (costs[module_.main.index] <= kMaxCost) return true;
  // The chain of the costliest calls.
  std::string chain = "main";
  for (FunctionId f = module_.main; f;) {
    FunctionId next;
    for (const ir::Inst& inst : module_[f].insts) {
      if (inst.op != Op::kCall || (next && costs[inst.aux] <= costs[next.index])) continue;
      next = FunctionId(inst.aux);
    }
    f = next;
    if (f) chain += " -> " + module_[f].display_name;
  }
  diagnostics_
      .Error(DiagnosticKind::kCostLimit, where_,
             fmt::format("the shader would run more than {} operations for each pixel", kMaxCost))
      .AddNote(where_, "most of them through " + Printable(chain, 1000));
  return false;
}

bool Specializer::Run() {
  FunctionId main = module_.main;
  const std::vector<Binding> none(old_[main.index].parameters.size());
  Callee made = Instance(main, none, "");
  if (failed_) return false;
  module_.main = made.id;
  NameInstances();
  return CheckCost();
}

}  // namespace

uint64_t OperationsForAPixel(const ir::Module& module) { return Costs(module)[module.main.index]; }

bool Specialize(ir::Module& module, bool fold, SourceRange where, Diagnostics& diagnostics) {
  std::vector<bool> changed(module.functions.size());
  if (fold) NarrowStructs(module, changed);
  return Specializer(module, fold, where, diagnostics).Run();
}

}  // namespace texgraph::passes
