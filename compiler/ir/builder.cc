// SPDX-License-Identifier: Apache-2.0
#include "compiler/ir/builder.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace texgraph::ir {
namespace {

constexpr uint32_t kNoEntry = 0xffffffffu;

bool IsCommutative(Op op) {
  switch (op) {
    case Op::kAdd:
    case Op::kMul:
    case Op::kMin:
    case Op::kMax:
    case Op::kAnd:
    case Op::kOr:
    case Op::kXor:
    case Op::kEq:
    case Op::kNe:
    case Op::kDot:
    case Op::kLogicalAnd:
    case Op::kLogicalOr:
    case Op::kLogicalXor:
      return true;
    default:
      return false;
  }
}

uint64_t HashInst(Op op, TypeId type, std::span<const ValueId> operands, uint32_t aux) {
  uint64_t hash = static_cast<uint64_t>(op) | uint64_t(type.index) << 8 | uint64_t(aux) << 32;
  hash *= 0x9e3779b97f4a7c15ull;
  if (IsCommutative(op)) {
    uint64_t low = std::min(operands[0].index, operands[1].index);
    uint64_t high = std::max(operands[0].index, operands[1].index);
    hash = (hash ^ (low << 32 | high)) * 0xff51afd7ed558ccdull;
  } else {
    for (ValueId v : operands) hash = (hash ^ v.index) * 0xff51afd7ed558ccdull;
  }
  return hash ^ hash >> 31;
}

}  // namespace

Builder::Builder(Module& module, Function& function, BuilderOptions options)
    : module_(module), function_(function), options_(options) {
  buckets_.assign(64, kNoEntry);
  if (!function_.body) {
    function_.body = BeginRegion();
  } else {
    open_.push_back(function_.body);
    scope_marks_.push_back(0);
  }
}

// --- Constants
// ---------------------------------------------------------------------------------------------------

ValueId Builder::Const(ConstId id) {
  if (2 * constant_count_ >= constant_slots_.size()) {
    std::vector<ValueId> old(std::max<size_t>(16, 4 * constant_slots_.size()));
    old.swap(constant_slots_);
    for (ValueId v : old) {
      if (v) ConstantSlot(ConstId((*this)[v].aux)) = v;
    }
  }
  ValueId& known = ConstantSlot(id);
  if (!known) {
    known = Append(Op::kConst, module_.constant(id).type, {}, id.index, false);
    ++constant_count_;
  }
  return known;
}

ValueId& Builder::ConstantSlot(ConstId id) {
  const size_t mask = constant_slots_.size() - 1;
  size_t slot = id.index * 0x9e3779b9u & mask;
  while (constant_slots_[slot] && (*this)[constant_slots_[slot]].aux != id.index)
    slot = (slot + 1) & mask;
  return constant_slots_[slot];
}

ValueId Builder::Const(TypeId type, std::span<const uint32_t> words) {
  return Const(module_.Intern(type, words));
}

ValueId Builder::Float(float value) {
  uint32_t word = std::bit_cast<uint32_t>(value);
  return Const(kFloat, {&word, 1});
}

ValueId Builder::Int(int32_t value) {
  uint32_t word = static_cast<uint32_t>(value);
  return Const(kInt, {&word, 1});
}

ValueId Builder::Uint(uint32_t value) { return Const(kUint, {&value, 1}); }

ValueId Builder::Bool(bool value) {
  uint32_t word = value;
  return Const(kBool, {&word, 1});
}

ValueId Builder::Splat(TypeId type, double value) {
  uint32_t word = 0;
  if (IsFloat(type)) {
    word = std::bit_cast<uint32_t>(static_cast<float>(value));
  } else if (IsInteger(type)) {
    word = static_cast<uint32_t>(static_cast<int64_t>(value));
  } else if (IsBool(type)) {
    word = value != 0;
  }
  std::vector<uint32_t> words(module_.types.Words(type), word);
  return Const(type, words);
}

ValueId Builder::Zero(TypeId type) { return Splat(type, 0); }

std::span<const uint32_t> Builder::ConstWords(ValueId v) const {
  return module_.Words(ConstId((*this)[v].aux));
}

// --- Emission
// ----------------------------------------------------------------------------------------------------

ValueId Builder::Append(Op op, TypeId type, std::span<const ValueId> operands, uint32_t aux,
                        bool in_body) {
  Inst inst;
  inst.op = op;
  inst.operand_count = static_cast<uint16_t>(operands.size());
  inst.type = type;
  inst.first_operand = static_cast<uint32_t>(function_.operands.size());
  inst.aux = aux;
  // `operands` may point into function_.operands itself, which may move.
  std::vector<ValueId>& all = function_.operands;
  const bool inside = !operands.empty() && operands.data() >= all.data() &&
                      operands.data() < all.data() + all.size();
  const size_t first = inside ? static_cast<size_t>(operands.data() - all.data()) : 0;
  for (size_t i = 0; i < operands.size(); ++i) {
    const ValueId operand = inside ? all[first + i] : operands[i];
    all.push_back(operand);
  }
  ValueId v(function_.insts.size());
  function_.insts.push_back(inst);
  if (function_.origins.size() != v.index)
    function_.origins.resize(v.index);  // parsed functions have none
  function_.origins.push_back(origin_);
  if (in_body) function_.regions[open_.back().index].body.push_back(v);
  return v;
}

ValueId Builder::Lookup(uint64_t hash, Op op, TypeId type, std::span<const ValueId> operands,
                        uint32_t aux) const {
  for (uint32_t e = buckets_[hash & (buckets_.size() - 1)]; e != kNoEntry; e = entries_[e].next) {
    if (entries_[e].hash != hash) continue;
    const Inst& inst = function_.insts[entries_[e].value.index];
    if (inst.op != op || inst.type != type || inst.aux != aux) continue;
    std::span<const ValueId> known = function_.Operands(inst);
    if (std::ranges::equal(known, operands)) return entries_[e].value;
    if (IsCommutative(op) && known[0] == operands[1] && known[1] == operands[0]) {
      return entries_[e].value;
    }
  }
  return ValueId();
}

void Builder::Remember(uint64_t hash, ValueId value) {
  if (entries_.size() >= buckets_.size()) Grow();
  uint32_t& bucket = buckets_[hash & (buckets_.size() - 1)];
  entries_.push_back({hash, value, bucket});
  bucket = static_cast<uint32_t>(entries_.size() - 1);
}

void Builder::Grow() {
  buckets_.assign(buckets_.size() * 4, kNoEntry);
  for (uint32_t e = 0; e < entries_.size(); ++e) {
    uint32_t& bucket = buckets_[entries_[e].hash & (buckets_.size() - 1)];
    entries_[e].next = bucket;
    bucket = e;
  }
}

ValueId Builder::Emit(Op op, TypeId type, std::span<const ValueId> operands, uint32_t aux) {
  if (options_.fold) {
    if (ValueId v = FoldStructure(op, type, operands, aux)) return v;
    if (ValueId v = FoldConstants(op, type, operands, aux)) return v;
  }
  if (options_.rules) {
    if (ValueId v = options_.rules->Apply(*this, op, type, operands, aux)) return v;
  }
  uint64_t hash = HashInst(op, type, operands, aux);
  if (ValueId v = Lookup(hash, op, type, operands, aux)) return v;
  ValueId v = Append(op, type, operands, aux, true);
  Remember(hash, v);
  return v;
}

ValueId Builder::Op1(Op op, ValueId a) {
  TypeId type = TypeOf(a);
  switch (Info(op).shape) {
    case OpShape::kLengthLike:
      return Emit(op, kFloat, {a});
    case OpShape::kReduceBool:
      return Emit(op, kBool, {a});
    case OpShape::kTestFloat:
      return Emit(op, Vector(Scalar::kBool, Width(type)), {a});
    default:
      return Emit(op, type, {a});
  }
}

ValueId Builder::Op2(Op op, ValueId a, ValueId b) {
  if (Info(op).shape == OpShape::kMatrixProduct) {
    // matrix * matrix, matrix * column: the left one's column type; row * matrix: a row.
    TypeId type = IsMatrix(TypeOf(a)) ? TypeOf(b) : TypeOf(a);
    return Emit(op, type, {a, b});
  }
  if (IsVector(TypeOf(a)) && IsVector(TypeOf(b))) {
    uint32_t width = std::max(Width(TypeOf(a)), Width(TypeOf(b)));
    a = SplatTo(a, WithWidth(TypeOf(a), width));
    b = SplatTo(b, WithWidth(TypeOf(b), width));
  } else if (IsMatrix(TypeOf(a)) != IsMatrix(TypeOf(b))) {
    ValueId& scalar = IsMatrix(TypeOf(a)) ? b : a;
    scalar = SplatTo(scalar, IsMatrix(TypeOf(a)) ? TypeOf(a) : TypeOf(b));
  }
  TypeId type = TypeOf(a);
  switch (Info(op).shape) {
    case OpShape::kDotLike:
      return Emit(op, kFloat, {a, b});
    case OpShape::kComparison:
      return Emit(op, Vector(Scalar::kBool, Width(type)), {a, b});
    default:
      return Emit(op, type, {a, b});
  }
}

ValueId Builder::Op3(Op op, ValueId a, ValueId b, ValueId c) {
  if (op == Op::kSelect) {
    if (IsVector(TypeOf(b)) && IsVector(TypeOf(c))) {
      uint32_t width = std::max({Width(TypeOf(b)), Width(TypeOf(c)), Width(TypeOf(a))});
      b = SplatTo(b, WithWidth(TypeOf(b), width));
      c = SplatTo(c, WithWidth(TypeOf(c), width));
    }
    return Emit(op, TypeOf(b), {a, b, c});
  }
  uint32_t width = std::max({Width(TypeOf(a)), Width(TypeOf(b)), Width(TypeOf(c))});
  a = SplatTo(a, WithWidth(TypeOf(a), width));
  b = SplatTo(b, WithWidth(TypeOf(b), width));
  c = SplatTo(c, WithWidth(TypeOf(c), width));
  return Emit(op, TypeOf(a), {a, b, c});
}

ValueId Builder::Convert(ValueId v, TypeId type) {
  return TypeOf(v) == type ? v : Emit(Op::kConvert, type, {v});
}

ValueId Builder::SplatTo(ValueId scalar, TypeId vector) {
  return TypeOf(scalar) == vector ? scalar : Emit(Op::kSplat, vector, {scalar});
}

ValueId Builder::Construct(TypeId type, std::span<const ValueId> parts) {
  if (!IsVector(type)) return Emit(Op::kConstruct, type, parts);
  std::vector<ValueId> components;
  for (ValueId part : parts) {
    uint32_t width = Width(TypeOf(part));
    for (uint32_t i = 0; i < width; ++i) {
      components.push_back(width == 1 ? part : Extract(part, i));
    }
  }
  return components.size() == 1 ? components[0] : Emit(Op::kConstruct, type, components);
}

ValueId Builder::Extract(ValueId aggregate, uint32_t index) {
  TypeId type = TypeOf(aggregate);
  if (IsScalar(type)) return aggregate;
  return Emit(Op::kExtract, module_.types.ElementType(type, index), {aggregate}, index);
}

ValueId Builder::Swizzle(ValueId vector, std::span<const uint8_t> components) {
  TypeId type = TypeOf(vector);
  uint32_t mask = 0;
  bool identity = components.size() == Width(type);
  for (size_t i = 0; i < components.size(); ++i) {
    mask |= static_cast<uint32_t>(components[i]) << (2 * i);
    identity = identity && components[i] == i;
  }
  if (identity) return vector;
  if (components.size() == 1) return Extract(vector, components[0]);
  TypeId result = WithWidth(type, static_cast<uint32_t>(components.size()));
  if (IsScalar(type)) return SplatTo(vector, result);
  return Emit(Op::kSwizzle, result, {vector}, mask);
}

ValueId Builder::Insert(ValueId aggregate, uint32_t index, ValueId element) {
  TypeId type = TypeOf(aggregate);
  std::vector<ValueId> parts;
  for (uint32_t i = 0; i < module_.types.ElementCount(type); ++i) {
    parts.push_back(i == index ? element : Extract(aggregate, i));
  }
  return parts.size() == 1 ? parts[0] : Emit(Op::kConstruct, type, parts);
}

ValueId Builder::Global(GlobalId id) {
  return Emit(Op::kGlobal, module_.globals[id.index].type, {}, id.index);
}

ValueId Builder::Call(FunctionId callee, std::span<const ValueId> arguments) {
  return Emit(Op::kCall, module_.CallType(module_[callee]), arguments, callee.index);
}

ValueId Builder::Result(ValueId value, uint32_t index, uint32_t result_count) {
  return result_count == 1 ? value : Extract(value, index);
}

// --- Structure
// ---------------------------------------------------------------------------------------------------

ValueId Builder::AddParameter(Parameter parameter) {
  uint32_t index = static_cast<uint32_t>(function_.parameters.size());
  ValueId v = Append(Op::kParam, parameter.type, {}, index, false);
  Name(v, parameter.name);
  function_.parameters.push_back(std::move(parameter));
  function_.regions[function_.body.index].params.push_back(v);
  return v;
}

RegionId Builder::BeginRegion() {
  function_.regions.emplace_back();
  RegionId id(function_.regions.size() - 1);
  open_.push_back(id);
  scope_marks_.push_back(entries_.size());
  return id;
}

ValueId Builder::AddRegionParameter(TypeId type) {
  Region& region = function_.regions[open_.back().index];
  uint32_t index = static_cast<uint32_t>(region.params.size());
  ValueId v = Append(Op::kParam, type, {}, index, false);
  function_.regions[open_.back().index].params.push_back(v);
  return v;
}

void Builder::EndRegion(std::span<const ValueId> results) {
  function_.regions[open_.back().index].results.assign(results.begin(), results.end());
  open_.pop_back();
  // Values of the closed region are out of scope: newest first, so each entry is the head of its
  // chain.
  for (size_t mark = scope_marks_.back(); entries_.size() > mark; entries_.pop_back()) {
    buckets_[entries_.back().hash & (buckets_.size() - 1)] = entries_.back().next;
  }
  scope_marks_.pop_back();
}

ValueId Builder::If(ValueId condition, RegionId then_region, RegionId else_region) {
  // Copies: emission below may move the vectors.
  std::vector<ValueId> on_true = function_.regions[then_region.index].results;
  std::vector<ValueId> on_false = function_.regions[else_region.index].results;
  std::vector<TypeId> types;
  for (ValueId v : on_true) types.push_back(TypeOf(v));
  TypeId type = types.size() == 1 ? types[0] : module_.types.Tuple(types);
  auto whole = [&](std::span<const ValueId> values) {
    return values.size() == 1 ? values[0] : Emit(Op::kConstruct, type, values);
  };
  if (options_.fold) {
    std::vector<ValueId>& outer = function_.regions[open_.back().index].body;
    std::vector<ValueId>& then_body = function_.regions[then_region.index].body;
    std::vector<ValueId>& else_body = function_.regions[else_region.index].body;
    if (IsConst(condition)) {
      bool taken = ConstWords(condition)[0] != 0;
      std::vector<ValueId>& body = taken ? then_body : else_body;
      outer.insert(outer.end(), body.begin(), body.end());
      body.clear();
      return whole(taken ? on_true : on_false);
    }
    if (then_body.empty() && else_body.empty()) {
      std::vector<ValueId> chosen;
      for (size_t i = 0; i < on_true.size(); ++i) {
        chosen.push_back(Emit(Op::kSelect, types[i], {condition, on_true[i], on_false[i]}));
      }
      return whole(chosen);
    }
    // What both sides yield alike needs no branch.
    std::vector<ValueId> all = on_true;
    std::vector<size_t> differing;
    for (size_t i = 0; i < on_true.size(); ++i) {
      if (on_true[i] != on_false[i]) differing.push_back(i);
    }
    if (differing.size() < all.size()) {
      if (differing.empty()) return whole(all);
      Region& then_side = function_.regions[then_region.index];
      Region& else_side = function_.regions[else_region.index];
      then_side.results.clear();
      else_side.results.clear();
      for (size_t i : differing) {
        then_side.results.push_back(on_true[i]);
        else_side.results.push_back(on_false[i]);
      }
      ValueId branch = If(condition, then_region, else_region);
      for (size_t i = 0; i < differing.size(); ++i) {
        all[differing[i]] =
            Result(branch, static_cast<uint32_t>(i), static_cast<uint32_t>(differing.size()));
      }
      return whole(all);
    }
  }
  function_.branches.push_back({then_region, else_region});
  return Append(Op::kIf, type, {{condition}}, static_cast<uint32_t>(function_.branches.size() - 1),
                true);
}

ValueId Builder::For(ForLoop loop, std::span<const ValueId> initial) {
  std::vector<TypeId> types;
  for (ValueId v : initial) types.push_back(TypeOf(v));
  TypeId type = types.size() == 1 ? types[0] : module_.types.Tuple(types);
  if (options_.fold && loop.Trips() == 0) {
    return initial.size() == 1 ? initial[0] : Emit(Op::kConstruct, type, initial);
  }
  function_.loops.push_back(loop);
  return Append(Op::kFor, type, initial, static_cast<uint32_t>(function_.loops.size() - 1), true);
}

void Builder::Return(std::span<const ValueId> values) {
  if (function_.results.empty()) {
    for (ValueId v : values) function_.results.push_back({"", TypeOf(v)});
  }
  function_.regions[function_.body.index].results.assign(values.begin(), values.end());
}

// --- Names
// -------------------------------------------------------------------------------------------------------

void Builder::Name(ValueId v, std::string_view name) {
  if (!name.empty()) Name(v, module_.InternName(name));
}

void Builder::Name(ValueId v, NameId name) {
  if (!name || IsConst(v)) return;
  if (function_.names.size() <= v.index) function_.names.resize(function_.insts.size());
  if (!function_.names[v.index]) function_.names[v.index] = name;
}

}  // namespace texgraph::ir
