// SPDX-License-Identifier: Apache-2.0
#include "compiler/ir/interpreter.h"

#include <algorithm>
#include <bit>
#include <cstdio>
#include <cstdlib>

#include "compiler/ir/evaluate.h"
#include "compiler/ir/evaluate_op.h"
#include "compiler/ir/evaluate_quads.h"

namespace texgraph::ir {
namespace {

constexpr size_t kChunkWords = 1 << 16;

// Every lane of a quad that has one lane in `mask`.
uint64_t WholeQuads(uint64_t mask) {
  mask |= mask >> 1;
  mask |= mask >> 2;
  return (mask & 0x1111111111111111u) * 15;
}

}  // namespace

uint32_t* WordArena::Allocate(size_t words) {
  while (chunk_ < chunks_.size() && used_ + words > chunks_[chunk_].size) {
    ++chunk_;
    used_ = 0;
  }
  if (chunk_ == chunks_.size()) {
    const size_t size = std::max(words, kChunkWords);
    chunks_.push_back({std::make_unique<uint32_t[]>(size), size});
  }
  uint32_t* memory = chunks_[chunk_].words.get() + used_;
  used_ += words;
  return memory;
}

Interpreter::Interpreter(const Module& module, uint32_t lanes,
                         std::span<const Texture* const> textures)
    : module_(module),
      lanes_(lanes),
      textures_(textures),
      globals_(module.globals.size()),
      constants_(module.constant_count()) {}

void Interpreter::Run(FunctionId function, std::span<const uint32_t* const> arguments,
                      uint64_t active, uint32_t* results) {
  std::vector<Slot> slots;
  for (const uint32_t* words : arguments) slots.push_back({words, nullptr});
  Call(function, slots, WholeQuads(active), results);
}

// --- Values --------------------------------------------------------------------------------------

const uint32_t* Interpreter::ConstantWords(ConstId id) {
  std::vector<uint32_t>& splat = constants_[id.index];
  if (splat.empty()) {
    splat.reserve(SizeOf(module_.constant(id).type));
    for (uint32_t word : module_.Words(id)) splat.insert(splat.end(), lanes_, word);
  }
  return splat.data();
}

const Interpreter::Slot& Interpreter::Get(Frame& frame, ValueId v) {
  Slot& slot = frame.slots[v.index];
  if (slot.words == nullptr && frame.f[v].op == Op::kConst) {
    slot.words = ConstantWords(ConstId(frame.f[v].aux));
  }
  return slot;
}

uint32_t* Interpreter::Storage(Frame& frame, ValueId v) {
  uint32_t*& storage = frame.storage[v.index];
  if (storage == nullptr) storage = arena_.Allocate(SizeOf(frame.f[v].type));
  frame.slots[v.index].words = storage;
  return storage;
}

void Interpreter::CopyResults(Frame& frame, RegionId region, uint32_t* to) {
  for (ValueId v : frame.f.regions[region.index].results) {
    to = std::copy_n(Words(frame, v), SizeOf(frame.f[v].type), to);
  }
}

// --- Instructions --------------------------------------------------------------------------------

void Interpreter::Call(FunctionId function, std::span<const Slot> arguments, uint64_t active,
                       uint32_t* results) {
  if (++depth_ > kMaxCallDepth) {
    std::fprintf(stderr, "texgraph: evaluate: calls nest deeper than %u\n", kMaxCallDepth);
    std::abort();
  }
  const WordArena::Mark mark = arena_.Now();
  const Function& f = module_[function];
  Frame frame{f, std::vector<Slot>(f.insts.size()), std::vector<uint32_t*>(f.insts.size()), {}};
  for (size_t i = 0; i < arguments.size(); ++i) {
    frame.slots[f.Body().params[i].index] = arguments[i];
  }
  RunRegion(frame, f.body, active);
  CopyResults(frame, f.body, results);
  arena_.Release(mark);
  --depth_;
}

void Interpreter::RunRegion(Frame& frame, RegionId region, uint64_t active) {
  for (ValueId v : frame.f.regions[region.index].body) RunInst(frame, v, active);
}

void Interpreter::RunInst(Frame& frame, ValueId v, uint64_t active) {
  const Inst& inst = frame.f[v];
  switch (inst.op) {
    case Op::kGlobal:
      frame.slots[v.index].words = globals_[inst.aux];
      return;
    case Op::kIf:
      return RunIf(frame, v, active);
    case Op::kFor:
      return RunFor(frame, v, active);
    case Op::kCall:
    case Op::kCallField:
      return RunCall(frame, v, active);
    case Op::kFieldRef:
      return MakeField(frame, v);
    case Op::kSample:
    case Op::kSampleGrad:
    case Op::kSampleLod:
    case Op::kFetch:
    case Op::kTextureSize:
      return RunSample(frame, v, active);
    case Op::kDx:
    case Op::kDy:
    case Op::kDfdx:
    case Op::kDfdy: {
      const bool along_y = inst.op == Op::kDy || inst.op == Op::kDfdy;
      const uint32_t* x = Words(frame, frame.f.Operands(inst)[0]);
      return quads::Difference(along_y, x, module_.types.Words(inst.type), lanes_,
                               Storage(frame, v));
    }
    case Op::kExtract: {
      // A part of the whole, where it lies.
      const ValueId whole = frame.f.Operands(inst)[0];
      const size_t offset = module_.types.ElementOffset(frame.f[whole].type, inst.aux);
      frame.slots[v.index].words = Words(frame, whole) + offset * lanes_;
      return;
    }
    default:
      return RunPlain(frame, v, active);
  }
}

void Interpreter::RunPlain(Frame& frame, ValueId v, uint64_t active) {
  const Inst& inst = frame.f[v];
  operands_.clear();
  operand_types_.clear();
  for (ValueId operand : frame.f.Operands(inst)) {
    operands_.push_back(Words(frame, operand));
    operand_types_.push_back(frame.f[operand].type);
  }
  const OpArguments arguments{inst.op, inst.type, operand_types_, operands_, inst.aux, lanes_};
  uint32_t* to = Storage(frame, v);
  if (EvaluateOp(module_.types, arguments, to)) return Observe(frame, v, active, to);
  std::fprintf(stderr, "texgraph: evaluate: cannot run %s\n", Info(inst.op).name.data());
  std::abort();
}

void Interpreter::RunIf(Frame& frame, ValueId v, uint64_t active) {
  const Inst& inst = frame.f[v];
  const Branch& branch = frame.f.branches[inst.aux];
  const uint32_t* condition = Words(frame, frame.f.Operands(inst)[0]);
  uint64_t taken = 0;
  for (uint32_t lane = 0; lane < lanes_; ++lane) taken |= uint64_t{condition[lane] != 0} << lane;
  const uint64_t then_active = WholeQuads(active & taken);
  const uint64_t else_active = WholeQuads(active & ~taken);
  if (then_active) RunRegion(frame, branch.then_region, then_active);
  if (else_active) RunRegion(frame, branch.else_region, else_active);
  uint32_t* to = Storage(frame, v);
  if (then_active == 0 || else_active == 0) {
    return CopyResults(frame, then_active ? branch.then_region : branch.else_region, to);
  }
  const std::vector<ValueId>& on_true = frame.f.regions[branch.then_region.index].results;
  const std::vector<ValueId>& on_false = frame.f.regions[branch.else_region.index].results;
  for (size_t i = 0; i < on_true.size(); ++i) {
    const uint32_t* a = Words(frame, on_true[i]);
    const uint32_t* b = Words(frame, on_false[i]);
    const uint32_t words = module_.types.Words(frame.f[on_true[i]].type);
    for (uint32_t word = 0; word < words; ++word, a += lanes_, b += lanes_, to += lanes_) {
      for (uint32_t lane = 0; lane < lanes_; ++lane) to[lane] = condition[lane] ? a[lane] : b[lane];
    }
  }
}

void Interpreter::RunFor(Frame& frame, ValueId v, uint64_t active) {
  const Inst& inst = frame.f[v];
  const ForLoop& loop = frame.f.loops[inst.aux];
  const std::vector<ValueId>& params = frame.f.regions[loop.body.index].params;
  const std::span<const ValueId> initial = frame.f.Operands(inst);
  for (size_t i = 0; i < initial.size(); ++i) {
    std::copy_n(Words(frame, initial[i]), SizeOf(frame.f[initial[i]].type),
                Storage(frame, params[i + 1]));
  }
  uint32_t* index = Storage(frame, params[0]);
  // A round's results may be another's parameters: all of them are read before one is written.
  uint32_t* results = Storage(frame, v);
  const uint32_t trips = loop.Trips();
  for (uint32_t trip = 0; trip < trips; ++trip) {
    const uint32_t value =
        static_cast<uint32_t>(loop.first) + trip * static_cast<uint32_t>(loop.step);
    std::fill_n(index, lanes_, value);
    RunRegion(frame, loop.body, active);
    CopyResults(frame, loop.body, results);
    const uint32_t* from = results;
    for (size_t i = 1; i < params.size(); ++i) {
      const size_t size = SizeOf(frame.f[params[i]].type);
      std::copy_n(from, size, Storage(frame, params[i]));
      from += size;
    }
  }
  if (trips > 0) return;
  for (ValueId first : initial) {
    results = std::copy_n(Words(frame, first), SizeOf(frame.f[first].type), results);
  }
}

void Interpreter::MakeField(Frame& frame, ValueId v) {
  const Inst& inst = frame.f[v];
  FieldValue& field = frame.fields[v];
  field.function = FunctionId(inst.aux);
  field.captured.clear();
  for (ValueId operand : frame.f.Operands(inst)) field.captured.push_back(Get(frame, operand));
  frame.slots[v.index].field = &field;
}

void Interpreter::RunCall(Frame& frame, ValueId v, uint64_t active) {
  const Inst& inst = frame.f[v];
  std::span<const ValueId> operands = frame.f.Operands(inst);
  FunctionId callee(inst.aux);
  std::span<const Slot> captured;
  if (inst.op == Op::kCallField) {
    const FieldValue& field = *Get(frame, operands[0]).field;
    callee = field.function;
    captured = field.captured;
    operands = operands.subspan(1);
  }
  std::vector<Slot> arguments;
  arguments.reserve(operands.size() + captured.size());
  for (ValueId operand : operands) arguments.push_back(Get(frame, operand));
  arguments.insert(arguments.end(), captured.begin(), captured.end());
  Call(callee, arguments, active, Storage(frame, v));
}

void Interpreter::RunSample(Frame& frame, ValueId v, uint64_t active) {
  const Inst& inst = frame.f[v];
  const std::span<const ValueId> operands = frame.f.Operands(inst);
  const TypeId sampler = frame.f[operands[0]].type;
  // All lanes have the same texture.
  const uint32_t global = Words(frame, operands[0])[0];
  const Texture* texture = global < textures_.size() ? textures_[global] : nullptr;
  operands_.clear();
  for (ValueId operand : operands.subspan(1)) operands_.push_back(Words(frame, operand));
  uint32_t* to = Storage(frame, v);
  if (inst.op == Op::kTextureSize) return quads::Size(sampler, texture, operands_[0], lanes_, to);
  quads::Sample({inst.op, sampler, texture, operands_, lanes_, active}, to);
  Observe(frame, v, active, to);
}

// `operands_` are still the operation's.
void Interpreter::Observe(Frame& frame, ValueId v, uint64_t active, uint32_t* words) {
  if (observer_) observer_->OnValue(frame.f, v, operands_, first_lane_, lanes_, active, words);
}

}  // namespace texgraph::ir
