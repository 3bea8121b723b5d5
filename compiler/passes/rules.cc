// SPDX-License-Identifier: Apache-2.0
#include "compiler/passes/rules.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <mutex>
#include <utility>

namespace texgraph::passes {
namespace {

using ir::Builder;
using ir::Op;
using ir::TypeId;
using ir::ValueId;

// A replacement is made of simplified operands, so rules set off few others. The bound only keeps a
// mistake in the tables from running on.
constexpr int kMaxDepth = 32;
// Operations with more operands have no rules.
constexpr size_t kMaxOperands = 3;

constexpr Rule kRules[] = {
#define RULE(name, pattern, replacement, flags, types) \
  {#name, pattern, replacement, flags, RuleTypes::types},
#include "compiler/passes/rules_arithmetic.def"
#include "compiler/passes/rules_comparison.def"
#include "compiler/passes/rules_convert.def"
#include "compiler/passes/rules_float.def"
#include "compiler/passes/rules_integer.def"
#include "compiler/passes/rules_logic.def"
#include "compiler/passes/rules_order.def"
#include "compiler/passes/rules_select.def"
#include "compiler/passes/rules_vector.def"
#undef RULE
};

// --- Commuted forms ---

bool IsCommutative(Op op) {
  switch (op) {
    case Op::kAdd:
    case Op::kMul:
    case Op::kMin:
    case Op::kMax:
    case Op::kAnd:
    case Op::kOr:
    case Op::kXor:
    case Op::kDot:
    case Op::kEq:
    case Op::kNe:
    case Op::kLogicalAnd:
    case Op::kLogicalOr:
    case Op::kLogicalXor:
      return true;
    default:
      return false;
  }
}

// The first node of the subtree whose last is `root`.
size_t FirstNode(Pattern nodes, size_t root) {
  size_t wanted = 1, at = root + 1;
  while (wanted > 0) {
    --at;
    wanted += nodes[at].operand_count;
    --wanted;
  }
  return at;
}

using Nodes = std::vector<PatternNode>;

Nodes Commuted(const Nodes& nodes, size_t at) {
  Nodes swapped = nodes;
  const size_t second = FirstNode(nodes, at - 1), first = FirstNode(nodes, second - 1);
  auto begin = swapped.begin();
  std::rotate(begin + static_cast<ptrdiff_t>(first), begin + static_cast<ptrdiff_t>(second),
              begin + static_cast<ptrdiff_t>(at));
  return swapped;
}

// Whether two patterns match the same operations: equal but for the names of variables.
bool SameShape(const Nodes& a, const Nodes& b) {
  std::array<uint8_t, kMaxVariables> a_names{}, b_names{};
  for (size_t i = 0; i < a.size(); ++i) {
    const PatternNode &p = a[i], &q = b[i];
    if (p.kind != q.kind || p.op != q.op || p.operand_count != q.operand_count ||
        p.scalar != q.scalar || p.test != q.test || p.all_ones != q.all_ones ||
        p.literal != q.literal) {
      return false;
    }
    if (p.kind != PatternNode::Kind::kVariable) continue;
    uint8_t &p_name = a_names[p.variable], &q_name = b_names[q.variable];
    if (p_name != q_name) return false;
    if (p_name == 0) p_name = q_name = static_cast<uint8_t>(i + 1);
  }
  return true;
}

// The pattern with the operands of its commutative operations in every order but the one it has.
std::vector<Nodes> OtherOrders(Pattern pattern) {
  std::vector<Nodes> orders;
  for (size_t at = 0; at < pattern.size(); ++at) {
    if (pattern[at].kind != PatternNode::Kind::kOp || !IsCommutative(pattern[at].op)) continue;
    if (orders.empty()) orders.emplace_back(pattern.begin(), pattern.end());
    // Swapping the operands of a node moves nodes before it only, so `at` names it in every order;
    // nodes inside of it are done already.
    for (size_t i = 0, count = orders.size(); i < count; ++i) {
      Nodes swapped = Commuted(orders[i], at);
      bool known =
          std::ranges::any_of(orders, [&](const Nodes& p) { return SameShape(p, swapped); });
      if (!known) orders.push_back(std::move(swapped));
    }
  }
  if (!orders.empty()) orders.erase(orders.begin());
  return orders;
}

// --- The index ---

// What the operands must be, one byte each: an operation, kConst, or anything. Almost every rule
// that does not apply is ruled out by this alone.
struct Shape {
  uint32_t wanted = 0;
  uint32_t mask = 0;
};

bool IsConstant(const PatternNode& node) {
  switch (node.test) {
    case ValueTest::kConst:
    case ValueTest::kReciprocal:
    case ValueTest::kNegative:
    case ValueTest::kWrapping:
    case ValueTest::kPowerOfTwo:
    case ValueTest::kShift:
      return true;
    default:
      return node.kind == PatternNode::Kind::kLiteral;
  }
}

Shape ShapeOf(Pattern pattern) {
  Shape shape;
  size_t at = pattern.size() - 1;
  for (uint32_t i = pattern.back().operand_count; i-- > 0;) {
    const PatternNode& operand = pattern[--at];
    bool is_op = operand.kind == PatternNode::Kind::kOp;
    if (is_op || IsConstant(operand)) {
      shape.wanted |= static_cast<uint32_t>(is_op ? operand.op : Op::kConst) << (8 * i);
      shape.mask |= 0xffu << (8 * i);
    }
    at = FirstNode(pattern, at);
  }
  return shape;
}

// The rules of one operation, parsed when it is first made: most graphs use few operations.
class OpRules {
 public:
  static const OpRules& Of(Op op) {
    static auto& all = *new std::array<OpRules, ir::kOpCount>;
    OpRules& rules = all[static_cast<size_t>(op)];
    std::call_once(rules.once_, [&] { rules.Parse(op); });
    return rules;
  }

  const std::vector<RuleVariant>& variants() const { return variants_; }
  const std::vector<Shape>& shapes() const { return shapes_; }

 private:
  void Parse(Op op) {
    static const auto& roots = *[] {
      auto* made = new std::array<Op, std::size(kRules)>;
      for (size_t i = 0; i < std::size(kRules); ++i) (*made)[i] = RootOf(kRules[i].pattern);
      return made;
    }();
    // The pool moves while it grows: ends of patterns first, then the patterns.
    std::vector<size_t> ends;
    std::vector<std::pair<const Rule*, bool>> what;  // the rule, and whether it is its replacement
    for (size_t i = 0; i < std::size(kRules); ++i) {
      if (roots[i] != op) continue;
      ParsePattern(kRules[i].replacement, pool_);
      ends.push_back(pool_.size());
      what.emplace_back(&kRules[i], true);
      const size_t first = pool_.size();
      ParsePattern(kRules[i].pattern, pool_);
      ends.push_back(pool_.size());
      what.emplace_back(&kRules[i], false);
      for (const Nodes& order : OtherOrders(Pattern(pool_).subspan(first))) {
        pool_.insert(pool_.end(), order.begin(), order.end());
        ends.push_back(pool_.size());
        what.emplace_back(&kRules[i], false);
      }
    }
    Pattern replacement;
    size_t begin = 0;
    for (size_t i = 0; i < ends.size(); ++i) {
      const Pattern pattern(pool_.data() + begin, ends[i] - begin);
      begin = ends[i];
      if (what[i].second) {
        replacement = pattern;
        continue;
      }
      variants_.push_back({what[i].first, pattern, replacement});
      shapes_.push_back(ShapeOf(pattern));
    }
  }

  std::once_flag once_;
  std::vector<PatternNode> pool_;
  std::vector<RuleVariant> variants_;  // in the order of the tables
  std::vector<Shape> shapes_;
};

// --- What calls give ---

// Part `index` of `aggregate`, where that is what a call gives and its function always gives the
// same constant there. So what a layer without opacity covers is known where it is blended.
ValueId ConstantOfCall(Builder& builder, ValueId aggregate, uint32_t index) {
  const ir::Module& module = builder.module();
  // From the part to the call: at most a component, of a member, of a result.
  constexpr size_t kMaxSteps = 8;
  std::array<uint32_t, kMaxSteps> steps;
  size_t count = 0;
  steps[count++] = index;
  while (builder[aggregate].op == Op::kExtract && count < kMaxSteps) {
    steps[count++] = builder[aggregate].aux;
    aggregate = builder.function().Operands(aggregate)[0];
  }
  if (builder[aggregate].op != Op::kCall) return ValueId();
  const ir::Function& callee = module[ir::FunctionId(builder[aggregate].aux)];
  const uint32_t result = callee.results.size() == 1 ? 0 : steps[--count];
  if (!callee.body.valid() || result >= callee.Body().results.size()) return ValueId();
  ValueId at = callee.Body().results[result];
  while (count > 0) {
    const ir::Inst& inst = callee[at];
    if (inst.op == Op::kConst) break;
    if (inst.op != Op::kConstruct && !(inst.op == Op::kSplat && ir::IsVector(inst.type))) {
      return ValueId();
    }
    const uint32_t step = steps[--count];
    at = callee.Operands(inst)[inst.op == Op::kSplat ? 0 : step];
  }
  if (callee[at].op != Op::kConst) return ValueId();
  ValueId part = builder.Const(ir::ConstId(callee[at].aux));
  while (count > 0) part = builder.Extract(part, steps[--count]);
  return part;
}

}  // namespace

std::span<const Rule> AllRules() { return kRules; }

std::vector<const RuleVariant*> AllVariants() {
  std::vector<const RuleVariant*> all;
  for (int op = 0; op < ir::kOpCount; ++op) {
    for (const RuleVariant& variant : OpRules::Of(static_cast<Op>(op)).variants()) {
      all.push_back(&variant);
    }
  }
  return all;
}

const RuleVariant* FirstMatch(const Builder& builder, Op op, TypeId type,
                              std::span<const ValueId> operands, RuleFlags allowed,
                              Bindings& bindings) {
  const OpRules& rules = OpRules::Of(op);
  if (rules.variants().empty() || operands.size() > kMaxOperands) return nullptr;
  uint32_t actual = 0;
  for (size_t k = 0; k < operands.size(); ++k) {
    actual |= static_cast<uint32_t>(builder[operands[k]].op) << (8 * k);
  }
  const TypeId subject = builder.TypeOf(operands[op == Op::kSelect ? 1 : 0]);
  for (size_t i = 0; i < rules.shapes().size(); ++i) {
    const Shape& shape = rules.shapes()[i];
    if (((actual ^ shape.wanted) & shape.mask) != 0) continue;
    const RuleVariant& variant = rules.variants()[i];
    const Rule& rule = *variant.rule;
    if ((rule.flags & ~allowed) != 0 || !Fits(rule.types, subject)) continue;
    bindings = {};
    bool signed_zero = (rule.flags & kUnsignedZero) == 0;
    if (Match(variant.pattern, builder, op, type, operands, signed_zero, bindings)) return &variant;
  }
  return nullptr;
}

bool Fits(RuleTypes types, TypeId type) {
  if (types == RuleTypes::kAny) return true;
  if (!ir::IsVector(type)) return false;
  const ir::Scalar scalar = ir::ScalarOf(type);
  switch (types) {
    case RuleTypes::kNumeric:
      return scalar != ir::Scalar::kBool;
    case RuleTypes::kSigned:
      return scalar == ir::Scalar::kFloat || scalar == ir::Scalar::kInt;
    case RuleTypes::kFloat:
      return scalar == ir::Scalar::kFloat;
    case RuleTypes::kScalarFloat:
      return type == ir::kFloat;
    case RuleTypes::kInteger:
      return scalar == ir::Scalar::kInt || scalar == ir::Scalar::kUint;
    case RuleTypes::kInt:
      return scalar == ir::Scalar::kInt;
    case RuleTypes::kUint:
      return scalar == ir::Scalar::kUint;
    case RuleTypes::kBool:
      return scalar == ir::Scalar::kBool;
    default:
      return true;
  }
}

ValueId SimplifyRules::Apply(Builder& builder, Op op, TypeId type,
                             std::span<const ValueId> operands, uint32_t aux) const {
  if (op == Op::kExtract) return ConstantOfCall(builder, operands[0], aux);
  if (depth_ >= kMaxDepth || operands.empty() || operands.size() > kMaxOperands) return ValueId();
  // The operands may lie in the function, which grows while a replacement is made.
  std::array<ValueId, kMaxOperands> held;
  std::ranges::copy(operands, held.begin());
  operands = {held.data(), operands.size()};
  ++depth_;
  ValueId simpler;
  Bindings bindings;
  if (const RuleVariant* found = FirstMatch(builder, op, type, operands, allowed_, bindings)) {
    simpler = Instantiate(found->replacement, builder, bindings, type);
  }
  for (std::span<const CodeRule> rules : {StructureRules(), RangeRules(), BitRules()}) {
    for (const CodeRule& rule : rules) {
      if (simpler) break;
      if ((rule.flags & ~allowed_) == 0) simpler = rule.apply(builder, op, type, operands);
    }
  }
  --depth_;
  return simpler;
}

}  // namespace texgraph::passes
