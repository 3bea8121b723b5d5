// SPDX-License-Identifier: Apache-2.0
#include "compiler/ir/known_words.h"

#include <algorithm>

#include "compiler/ir/evaluate_op.h"
#include "compiler/ir/rebuild.h"

namespace texgraph::ir {
namespace {

constexpr uint32_t kMostCalls = 64;  // in one another

// Of a kIf both sides of which were run: what they agree on.
void Agree(KnownWords& a, const KnownWords& b) {
  for (size_t i = 0; i < a.words.size(); ++i) {
    if (a.known[i] && b.known[i] && a.words[i] == b.words[i]) continue;
    a.known[i] = false;
    a.words[i] = 0;
  }
}

class KnownEvaluator {
 public:
  explicit KnownEvaluator(const Module& module) : module_(module) {}

  // Only what the results of `use` need is run.
  std::vector<KnownWords> Call(FunctionId id, std::vector<KnownWords> arguments,
                               const SignatureUse* use = nullptr);

 private:
  struct Frame {
    const Function& f;
    const Liveness& live;
    std::vector<std::vector<KnownWords>> values;  // by ValueId: one for each result
  };

  uint32_t Words(TypeId type) const {
    // What is known of a field is known of its results.
    return module_.types.Words(module_.types.ValueOf(type));
  }
  std::vector<KnownWords> NothingOf(const Function& f, std::span<const ValueId> values) const;
  const KnownWords& Get(Frame& frame, ValueId v);
  std::vector<KnownWords> GetAll(Frame& frame, std::span<const ValueId> values);
  void RunRegion(Frame& frame, RegionId region);
  std::vector<KnownWords> Run(Frame& frame, ValueId v);
  std::vector<KnownWords> RunIf(Frame& frame, const Inst& inst);
  std::vector<KnownWords> RunFor(Frame& frame, const Inst& inst);
  KnownWords Extract(Frame& frame, const Inst& inst);
  KnownWords Compute(Frame& frame, const Inst& inst);

  const Module& module_;
  uint32_t steps_ = 0;
  uint32_t depth_ = 0;
};

std::vector<KnownWords> KnownEvaluator::NothingOf(const Function& f,
                                                  std::span<const ValueId> values) const {
  std::vector<KnownWords> nothing;
  for (ValueId v : values) nothing.push_back(KnownWords::Nothing(Words(f[v].type)));
  return nothing;
}

const KnownWords& KnownEvaluator::Get(Frame& frame, ValueId v) {
  std::vector<KnownWords>& value = frame.values[v.index];
  const Inst& inst = frame.f[v];
  if (inst.op == Op::kConst) value = {KnownWords::All(module_.Words(ConstId(inst.aux)))};
  if (value.empty()) value = {KnownWords::Nothing(Words(inst.type))};
  return value[0];
}

std::vector<KnownWords> KnownEvaluator::GetAll(Frame& frame, std::span<const ValueId> values) {
  std::vector<KnownWords> known;
  for (ValueId v : values) known.push_back(Get(frame, v));
  return known;
}

std::vector<KnownWords> KnownEvaluator::Call(FunctionId id, std::vector<KnownWords> arguments,
                                             const SignatureUse* use) {
  const Function& f = module_[id];
  if (depth_ >= kMostCalls) return NothingOf(f, f.Body().results);
  ++depth_;
  const Liveness live(module_, f, id, use);
  Frame frame{f, live, std::vector<std::vector<KnownWords>>(f.insts.size())};
  for (size_t i = 0; i < arguments.size(); ++i) {
    frame.values[f.Body().params[i].index] = {std::move(arguments[i])};
  }
  RunRegion(frame, f.body);
  --depth_;
  return GetAll(frame, f.Body().results);
}

void KnownEvaluator::RunRegion(Frame& frame, RegionId region) {
  for (ValueId v : frame.f.regions[region.index].body) {
    if (frame.live.Live(v)) frame.values[v.index] = Run(frame, v);
  }
}

// Nothing, that is nothing known, for what cannot be run or is not run any more.
std::vector<KnownWords> KnownEvaluator::Run(Frame& frame, ValueId v) {
  const Inst& inst = frame.f[v];
  if (++steps_ > kMostSteps) return {};
  std::span<const ValueId> operands = frame.f.Operands(inst);
  switch (inst.op) {
    case Op::kIf:
      return RunIf(frame, inst);
    case Op::kFor:
      return RunFor(frame, inst);
    case Op::kCall:
      return Call(FunctionId(inst.aux), GetAll(frame, operands));
    case Op::kCallField:
      return {Get(frame, operands[0])};
    case Op::kExtract:
      return {Extract(frame, inst)};
    default:
      return {Compute(frame, inst)};
  }
}

std::vector<KnownWords> KnownEvaluator::RunIf(Frame& frame, const Inst& inst) {
  const Branch& branch = frame.f.branches[inst.aux];
  const KnownWords condition = Get(frame, frame.f.Operands(inst)[0]);
  auto side = [&](RegionId region) {
    RunRegion(frame, region);
    return GetAll(frame, frame.f.regions[region.index].results);
  };
  if (condition.known[0]) return side(condition.words[0] ? branch.then_region : branch.else_region);
  std::vector<KnownWords> results = side(branch.then_region);
  const std::vector<KnownWords> others = side(branch.else_region);
  for (size_t i = 0; i < results.size(); ++i) Agree(results[i], others[i]);
  return results;
}

std::vector<KnownWords> KnownEvaluator::RunFor(Frame& frame, const Inst& inst) {
  const ForLoop& loop = frame.f.loops[inst.aux];
  const Region& body = frame.f.regions[loop.body.index];
  std::vector<KnownWords> carried = GetAll(frame, frame.f.Operands(inst));
  const uint32_t trips = loop.Trips();
  for (uint32_t trip = 0; trip < trips; ++trip) {
    if (steps_ > kMostSteps) return NothingOf(frame.f, body.results);
    const uint32_t index =
        static_cast<uint32_t>(loop.first) + trip * static_cast<uint32_t>(loop.step);
    frame.values[body.params[0].index] = {KnownWords::All({&index, 1})};
    for (size_t i = 0; i < carried.size(); ++i) {
      frame.values[body.params[i + 1].index] = {std::move(carried[i])};
    }
    RunRegion(frame, loop.body);
    carried = GetAll(frame, body.results);
  }
  return carried;
}

KnownWords KnownEvaluator::Extract(Frame& frame, const Inst& inst) {
  const ValueId whole = frame.f.Operands(inst)[0];
  const TypeId type = frame.f[whole].type;
  // The results of calls, ifs and loops lie apart.
  if (module_.types.Kind(type) == TypeKind::kTuple) {
    std::vector<KnownWords>& parts = frame.values[whole.index];
    return inst.aux < parts.size() ? parts[inst.aux] : KnownWords::Nothing(Words(inst.type));
  }
  const KnownWords& from = Get(frame, whole);
  const uint32_t first = module_.types.ElementOffset(type, inst.aux);
  KnownWords part;
  const uint32_t count = Words(inst.type);
  part.words.assign(from.words.begin() + first, from.words.begin() + first + count);
  part.known.assign(from.known.begin() + first, from.known.begin() + first + count);
  return part;
}

KnownWords KnownEvaluator::Compute(Frame& frame, const Inst& inst) {
  const KnownWords nothing = KnownWords::Nothing(Words(inst.type));
  std::vector<KnownWords> operands = GetAll(frame, frame.f.Operands(inst));
  std::vector<TypeId> types;
  std::vector<const uint32_t*> words;
  bool all = true;
  for (size_t i = 0; i < operands.size(); ++i) {
    types.push_back(frame.f[frame.f.Operands(inst)[i]].type);
    words.push_back(operands[i].words.data());
    all = all && operands[i].IsWhole();
  }
  if (inst.op == Op::kSelect && operands[0].known[0] && IsScalar(types[0])) {
    return operands[operands[0].words[0] ? 1 : 2];
  }
  KnownWords result = nothing;
  const OpArguments arguments{inst.op, inst.type, types, words, inst.aux, 1};
  if (all) {
    if (!EvaluateOp(module_.types, arguments, result.words.data())) return nothing;
    result.known.assign(result.known.size(), true);
    return result;
  }
  const bool moves = inst.op == Op::kConstruct || inst.op == Op::kSplat || inst.op == Op::kSwizzle;
  if (!moves || !EvaluateOp(module_.types, arguments, result.words.data())) return nothing;
  // What moves words moves what is known of them.
  std::vector<std::vector<uint32_t>> flags;
  for (size_t i = 0; i < operands.size(); ++i) {
    flags.emplace_back(operands[i].known.begin(), operands[i].known.end());
    words[i] = flags[i].data();
  }
  std::vector<uint32_t> known(result.words.size());
  EvaluateOp(module_.types, arguments, known.data());
  for (size_t i = 0; i < known.size(); ++i) result.known[i] = known[i] != 0;
  return result;
}

}  // namespace

bool KnownWords::IsWhole() const { return std::ranges::find(known, false) == known.end(); }

KnownWords FindKnownResult(const Module& module, FunctionId function,
                           std::vector<KnownWords> arguments, uint32_t result) {
  SignatureUse use;
  use.results.resize(function.index + 1);
  use.results[function.index].assign(module[function].results.size(), false);
  use.results[function.index][result] = true;
  return KnownEvaluator(module).Call(function, std::move(arguments), &use)[result];
}

}  // namespace texgraph::ir
