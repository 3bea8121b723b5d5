// SPDX-License-Identifier: Apache-2.0
#include "compiler/blocks/lower_function.h"

#include <algorithm>
#include <limits>

namespace texgraph::blocks {

using ir::ConstId;
using ir::Op;
using ir::TypeId;
using ir::ValueId;

FunctionLowering::FunctionLowering(Lowering& lowering, const TypedFunction& function,
                                   ir::Function& result, ir::Builder& builder)
    : ExpressionLowering(builder, function, lowering.depth),
      lowering_(lowering),
      result_(result),
      info_(function.file->functions[function.function]),
      signature_(info_.signatures[info_.is_generic ? Variant(function.gen_type) : 0]) {}

void FunctionLowering::Error(DiagnosticKind kind, SourceRange range, std::string message) {
  failed_ = true;
  lowering_.program.diagnostics.Error(kind, range, std::move(message));
}

bool FunctionLowering::Enter(SourceRange range, uint32_t units) {
  if (depth_ + units <= kMaxLoweringDepth) {
    depth_ += units;
    return true;
  }
  failed_ = true;
  if (!lowering_.too_deep) {
    lowering_.program.diagnostics.Error(
        DiagnosticKind::kNestingLimit, range,
        "statements and the functions that are called here nest too deeply");
  }
  lowering_.too_deep = true;
  return false;
}

void FunctionLowering::TooDeep(const TypedExpr& expr) { Enter(RangeOf(expr), kMaxLoweringDepth); }

void FunctionLowering::OutOfRange(const TypedExpr& expr, TypeId aggregate) {
  const ir::Types& types = builder_.module().types;
  SourceRange index = RangeOf(function_[function_.children[expr.first_child + 1]]);
  Error(DiagnosticKind::kBlockType, index,
        "the index is outside of " + types.Text(aggregate) + ", whose last one is " +
            std::to_string(types.ElementCount(aggregate) - 1));
}

// --- The function
// ------------------------------------------------------------------------------------------------

std::optional<Lowered> FunctionLowering::Run(std::span<const ConstId> values) {
  AddParameters(values);
  Values results = LowerToEnd({&function_.body, 0, nullptr});
  for (ValueId value : results) failed_ = failed_ || !value;
  if (failed_) return std::nullopt;
  builder_.Return(results);
  Lowered lowered;
  lowered.rounds = most_rounds_;
  for (ValueId value : results) lowered.results.push_back(Known(value));
  return lowered;
}

// Fields, then what goes in; template parameters are constants.
void FunctionLowering::AddParameters(std::span<const ConstId> values) {
  const File& file = *function_.file;
  slots_.resize(function_.slots.size() + 2);
  fields_.resize(file.fields.size());
  for (uint32_t field : info_.fields) {
    const FieldInfo& info = file.fields[field];
    TypeId type = info.Type(builder_.module().types, function_.gen_type);
    fields_[field] = builder_.AddParameter({std::string(info.ast->name), type, false});
  }
  if (signature_.result != ir::kVoid) result_.results.push_back({"", signature_.result});
  size_t next_value = 0;
  for (uint32_t slot = 0; slot < signature_.parameters.size(); ++slot) {
    const SignatureParameter& parameter = signature_.parameters[slot];
    std::string name(parameter.name);
    if (parameter.is_template) {
      ConstId value = values[next_value++];
      slots_[slot] = builder_.Const(value);
      ir::Module& module = builder_.module();
      if (module.types.Kind(module.constant(value).type) == ir::TypeKind::kArray) {
        module.constant_names.try_emplace(value, module.InternName(name));
      }
    } else if (parameter.is_in) {
      slots_[slot] = builder_.AddParameter({name, parameter.type, false});
    } else {
      slots_[slot] = builder_.Zero(parameter.type);
    }
    // What goes in and out is two things here.
    if (parameter.is_out)
      result_.results.push_back({parameter.is_in ? name + "_out" : name, parameter.type});
  }
}

// --- Slots
// -------------------------------------------------------------------------------------------------------

ValueId FunctionLowering::Slot(uint32_t slot) { return Get(slot); }

ValueId FunctionLowering::Get(uint32_t slot) { return slots_[slot]; }

void FunctionLowering::Set(uint32_t slot, ValueId value) {
  log_.emplace_back(slot, slots_[slot]);
  slots_[slot] = value;
  if (value && slot < function_.slots.size()) builder_.Name(value, function_.slots[slot].name);
}

void FunctionLowering::RollBack(size_t mark) {
  for (; log_.size() > mark; log_.pop_back()) slots_[log_.back().first] = log_.back().second;
}

void FunctionLowering::StorePlace(const Place& place, ValueId value) {
  if (!place.steps.empty()) value = Store(Get(place.slot), place.steps, value);
  if (!value) failed_ = true;
  Set(place.slot, value);
}

ValueId FunctionLowering::Load(ValueId whole, const Place::Step& step) {
  switch (step.kind) {
    case Place::Step::Kind::kElement:
      return builder_.Extract(whole, step.aux);
    case Place::Step::Kind::kComputed:
      return builder_.Emit(Op::kIndex, step.type,
                           {whole, builder_.Convert(Lower(step.index), ir::kInt)});
    case Place::Step::Kind::kSwizzle:
      break;
  }
  uint8_t components[4];
  uint32_t width = ir::Width(step.type);
  for (uint32_t i = 0; i < width; ++i) {
    components[i] = static_cast<uint8_t>(ir::SwizzleComponent(step.aux, i));
  }
  return builder_.Swizzle(whole, {components, width});
}

// `whole` with the part that the steps lead to replaced.
ValueId FunctionLowering::Store(ValueId whole, std::span<const Place::Step> steps, ValueId value) {
  if (steps.empty() || !whole || !value) return whole ? value : ValueId();
  const Place::Step& step = steps[0];
  if (step.kind == Place::Step::Kind::kComputed && !Lower(step.index)) return {};
  if (steps.size() > 1) value = Store(Load(whole, step), steps.subspan(1), value);
  if (!value) return {};
  if (step.kind == Place::Step::Kind::kElement) return builder_.Insert(whole, step.aux, value);
  TypeId type = builder_.TypeOf(whole);
  std::vector<ValueId> parts;
  for (uint32_t i = 0; i < builder_.module().types.ElementCount(type); ++i) {
    parts.push_back(builder_.Extract(whole, i));
  }
  if (step.kind == Place::Step::Kind::kSwizzle) {
    for (uint32_t i = 0; i < ir::Width(step.type); ++i) {
      parts[ir::SwizzleComponent(step.aux, i)] = builder_.Extract(value, i);
    }
  } else {
    ValueId index = builder_.Convert(Lower(step.index), ir::kInt);
    for (uint32_t i = 0; i < parts.size(); ++i) {
      ValueId here = builder_.Op2(Op::kEq, index, builder_.Int(static_cast<int32_t>(i)));
      parts[i] = builder_.Emit(Op::kSelect, step.type, {here, value, parts[i]});
    }
  }
  return builder_.Construct(type, parts);
}

// --- Calls
// -------------------------------------------------------------------------------------------------------

ValueId FunctionLowering::CallField(const TypedExpr& expr, std::span<const ValueId> arguments) {
  std::vector<ValueId> operands{fields_[expr.aux]};
  operands.insert(operands.end(), arguments.begin(), arguments.end());
  return builder_.Emit(Op::kCallField, expr.type, operands);
}

ValueId FunctionLowering::Call(const TypedExpr& expr, std::span<const ValueId> arguments) {
  std::optional<Values> results = MakeCall(expr, arguments);
  return results && !results->empty() ? results->front() : ValueId();
}

// The results of a call, the returned value first.
std::optional<FunctionLowering::Values> FunctionLowering::MakeCall(
    const TypedExpr& expr, std::span<const ValueId> arguments) {
  const Callee& callee = function_.callees[expr.aux];
  const FunctionInfo& info = callee.file->functions[callee.function];
  std::vector<ConstId> values;
  for (TypedId argument : callee.template_arguments) {
    values.push_back(Known(Lower(argument)));
    if (values.back()) continue;
    if (failed_) return std::nullopt;
    Error(DiagnosticKind::kBlockConstant, RangeOf(function_[argument]),
          "'" + std::string(info.ast->name) +
              "' needs a value here that is known when the shader is made");
    return std::nullopt;
  }
  std::vector<ValueId> operands;
  for (uint32_t field : info.fields) {
    std::string_view name = callee.file->fields[field].ast->name;
    auto own = std::ranges::find(function_.file->fields, name,
                                 [](const FieldInfo& f) { return f.ast->name; });
    operands.push_back(fields_[static_cast<size_t>(own - function_.file->fields.begin())]);
  }
  operands.insert(operands.end(), arguments.begin(), arguments.end());
  if (!Enter(RangeOf(expr), kCallDepth)) return std::nullopt;
  const Lowered& lowered =
      lowering_.Function(*callee.file, callee.function, callee.gen_type, values, RangeOf(expr));
  Leave(kCallDepth);
  if (!lowered.id) {
    failed_ = true;
    return std::nullopt;
  }
  if (rounds_ * lowered.rounds > kMaxTrips) {
    Error(DiagnosticKind::kLoopLimit, RangeOf(expr),
          "the loops around and in this call make " + std::to_string(rounds_ * lowered.rounds) +
              " rounds; llvmpipe ends all loops after 65535");
  }
  most_rounds_ = std::max(most_rounds_, rounds_ * lowered.rounds);
  Values results;
  ValueId call;
  uint32_t count = static_cast<uint32_t>(lowered.results.size());
  for (uint32_t i = 0; i < count; ++i) {
    if (lowered.results[i] && builder_.folds()) {
      results.push_back(builder_.Const(lowered.results[i]));
      continue;
    }
    if (!call) call = builder_.Call(lowered.id, operands);
    results.push_back(builder_.Result(call, i, count));
    if (lowered.results[i]) SetKnown(results.back(), lowered.results[i]);
  }
  return results;
}

void FunctionLowering::LowerCallStmt(const TypedStmt& stmt) {
  const TypedExpr& expr = function_[stmt.value];
  std::vector<ValueId> arguments;
  for (uint32_t i = 0; i < expr.child_count; ++i) {
    arguments.push_back(Lower(function_.Child(stmt.value, i)));
    if (!arguments.back()) failed_ = true;
  }
  if (failed_) return;
  std::optional<Values> results = MakeCall(expr, arguments);
  if (!results) return;
  for (size_t i = 0; i < stmt.places.size(); ++i) StorePlace(stmt.places[i], (*results)[i]);
}

// --- Statements
// --------------------------------------------------------------------------------------------------

void FunctionLowering::LowerList(const List& list) {
  for (const TypedStmt& stmt : list) LowerStmt(stmt);
}

// A statement without a return in it.
void FunctionLowering::LowerStmt(const TypedStmt& stmt) {
  if (failed_ || !Enter(stmt.range)) return;
  switch (stmt.kind) {
    case TypedStmtKind::kAssign:
      LowerAssign(stmt);
      break;
    case TypedStmtKind::kCall:
      LowerCallStmt(stmt);
      break;
    case TypedStmtKind::kFor:
      LowerFor(stmt);
      break;
    case TypedStmtKind::kIf: {
      ValueId condition = Lower(stmt.value);
      if (!condition) {
        failed_ = true;
      } else if (std::optional<bool> known = KnownBool(condition)) {
        LowerList(*known ? stmt.first : stmt.second);
      } else {
        Branch(
            condition, [&] { LowerList(stmt.first); }, [&] { LowerList(stmt.second); });
      }
      break;
    }
    case TypedStmtKind::kReturn:
      break;
  }
  Leave();
}

void FunctionLowering::LowerAssign(const TypedStmt& stmt) {
  const Place& place = stmt.places[0];
  ValueId value = stmt.value ? Lower(stmt.value) : builder_.Zero(function_.slots[place.slot].type);
  if (!value) {
    failed_ = true;
    return;
  }
  StorePlace(place, value);
}

void FunctionLowering::Branch(ValueId condition, const std::function<void()>& on_true,
                              const std::function<void()>& on_false) {
  // What each side leaves in the slots that it changed.
  std::vector<std::pair<uint32_t, ValueId>> changed[2];
  ir::RegionId regions[2];
  for (int side = 0; side < 2; ++side) {
    size_t mark = log_.size();
    regions[side] = builder_.BeginRegion();
    (side == 0 ? on_true : on_false)();
    for (size_t i = mark; i < log_.size(); ++i) {
      changed[side].emplace_back(log_[i].first, slots_[log_[i].first]);
    }
    builder_.EndRegion({});
    RollBack(mark);
    std::ranges::sort(changed[side], {}, &std::pair<uint32_t, ValueId>::first);
    auto repeated = std::ranges::unique(changed[side], {}, &std::pair<uint32_t, ValueId>::first);
    changed[side].erase(repeated.begin(), repeated.end());
  }
  if (failed_) return;
  // Slots that were empty before are variables of one side.
  std::vector<uint32_t> yielded;
  for (const auto& side : changed) {
    for (const auto& [slot, value] : side) {
      if (slots_[slot]) yielded.push_back(slot);
    }
  }
  std::ranges::sort(yielded);
  auto repeated = std::ranges::unique(yielded);
  yielded.erase(repeated.begin(), repeated.end());
  Values values[2];
  for (int side = 0; side < 2; ++side) {
    auto at = changed[side].begin();
    for (uint32_t slot : yielded) {
      while (at != changed[side].end() && at->first < slot) ++at;
      bool here = at != changed[side].end() && at->first == slot;
      values[side].push_back(here ? at->second : slots_[slot]);
    }
  }
  if (yielded.empty()) return;
  std::vector<ir::Region>& all = builder_.function().regions;
  all[regions[0].index].results = values[0];
  all[regions[1].index].results = values[1];
  ValueId result = builder_.If(condition, regions[0], regions[1]);
  uint32_t count = static_cast<uint32_t>(yielded.size());
  for (uint32_t i = 0; i < count; ++i) Set(yielded[i], builder_.Result(result, i, count));
}

// --- Loops
// -------------------------------------------------------------------------------------------------------

std::optional<int32_t> FunctionLowering::KnownInt(TypedId id, std::string_view what) {
  ValueId value = Lower(id);
  if (ConstId constant = Known(value)) {
    return static_cast<int32_t>(builder_.module().Words(constant)[0]);
  }
  if (failed_) return std::nullopt;
  Error(DiagnosticKind::kBlockConstant, RangeOf(function_[id]),
        "the loop's " + std::string(what) +
            " must be known when the shader is made; use constants and 'const' parameters");
  return std::nullopt;
}

std::optional<ir::ForLoop> FunctionLowering::Bounds(const TypedStmt& stmt) {
  std::optional<int32_t> first = KnownInt(stmt.value, "first value");
  std::optional<int32_t> last = KnownInt(stmt.last, "bound");
  std::optional<int32_t> step = KnownInt(stmt.step, "step");
  if (!first || !last || !step) return std::nullopt;
  int64_t stride = stmt.negated ? -int64_t{*step} : int64_t{*step};
  int64_t end = int64_t{*last} + (stmt.inclusive ? (stmt.downward ? -1 : 1) : 0);
  int64_t distance = stmt.downward ? *first - end : end - *first;
  int64_t forward = stmt.downward ? -stride : stride;
  ir::ForLoop loop;
  loop.first = loop.last = *first;
  if (distance <= 0) return loop;
  int64_t rounds = forward > 0 ? (distance + forward - 1) / forward : 0;
  int64_t behind = *first + rounds * stride;
  // Counting beyond the last int would begin again at the first.
  bool ends = forward > 0 && behind >= std::numeric_limits<int32_t>::min() &&
              behind <= std::numeric_limits<int32_t>::max();
  if (!ends || rounds_ * static_cast<uint64_t>(rounds) > kMaxTrips) {
    std::string text = !ends ? "this loop does not end"
                             : "this loop makes " + std::to_string(rounds) + " rounds" +
                                   (rounds_ > 1 ? " in each of " + std::to_string(rounds_) : "") +
                                   "; llvmpipe ends all loops after 65535";
    Error(DiagnosticKind::kLoopLimit, stmt.range, text);
    return std::nullopt;
  }
  // `behind` ends the loop as `end` does, and is always an int.
  loop.last = static_cast<int32_t>(behind);
  loop.step = static_cast<int32_t>(stride);
  return loop;
}

void FunctionLowering::LowerFor(const TypedStmt& stmt) {
  std::optional<ir::ForLoop> loop = Bounds(stmt);
  if (!loop) failed_ = true;
  // Without carried slots nothing comes out of the loop.
  if (!loop || loop->Trips() == 0 || stmt.carried.empty()) return;
  uint64_t outer = rounds_;
  rounds_ *= loop->Trips();
  most_rounds_ = std::max(most_rounds_, rounds_);
  Values initial, results;
  for (uint32_t slot : stmt.carried) initial.push_back(Get(slot));
  size_t mark = log_.size();
  loop->body = builder_.BeginRegion();
  Set(stmt.slot, builder_.AddRegionParameter(ir::kInt));
  for (uint32_t slot : stmt.carried) {
    Set(slot, builder_.AddRegionParameter(function_.slots[slot].type));
  }
  LowerList(stmt.first);
  for (uint32_t slot : stmt.carried) results.push_back(Get(slot));
  builder_.EndRegion(results);
  RollBack(mark);
  rounds_ = outer;
  if (failed_) return;
  ValueId value = builder_.For(*loop, initial);
  uint32_t count = static_cast<uint32_t>(stmt.carried.size());
  for (uint32_t i = 0; i < count; ++i) Set(stmt.carried[i], builder_.Result(value, i, count));
}

}  // namespace texgraph::blocks
