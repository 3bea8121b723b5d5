// SPDX-License-Identifier: Apache-2.0
#include "compiler/passes/rules.h"

#include <algorithm>
#include <array>
#include <deque>

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
size_t FirstNode(const std::vector<PatternNode>& nodes, size_t root) {
  size_t wanted = 1, at = root + 1;
  while (wanted > 0) {
    --at;
    wanted += nodes[at].operand_count;
    --wanted;
  }
  return at;
}

Pattern Commuted(const Pattern& pattern, size_t at) {
  Pattern swapped = pattern;
  auto begin = swapped.nodes.begin();
  size_t second = FirstNode(pattern.nodes, at - 1);
  size_t first = FirstNode(pattern.nodes, second - 1);
  std::rotate(begin + first, begin + second, begin + at);
  return swapped;
}

// Whether two patterns match the same operations: equal but for the names of variables.
bool SameShape(const Pattern& a, const Pattern& b) {
  std::array<int, kMaxVariables> a_names, b_names;
  a_names.fill(-1);
  b_names.fill(-1);
  for (size_t i = 0; i < a.nodes.size(); ++i) {
    const PatternNode &p = a.nodes[i], &q = b.nodes[i];
    if (p.kind != q.kind || p.op != q.op || p.scalar != q.scalar || p.test != q.test ||
        p.all_ones != q.all_ones || p.literal != q.literal) {
      return false;
    }
    if (p.kind != PatternNode::Kind::kVariable) continue;
    int &p_name = a_names[p.variable], &q_name = b_names[q.variable];
    if (p_name != q_name) return false;
    if (p_name < 0) p_name = q_name = static_cast<int>(i);
  }
  return true;
}

std::vector<Pattern> OperandOrders(const Pattern& pattern) {
  std::vector<Pattern> orders{pattern};
  for (size_t at = 0; at < pattern.nodes.size(); ++at) {
    if (pattern.nodes[at].kind != PatternNode::Kind::kOp || !IsCommutative(pattern.nodes[at].op))
      continue;
    // Swapping the operands of a node moves nodes before it only, so `at` names it in every order;
    // nodes inside of it are done already.
    for (size_t i = 0, count = orders.size(); i < count; ++i) {
      Pattern swapped = Commuted(orders[i], at);
      bool known =
          std::ranges::any_of(orders, [&](const Pattern& p) { return SameShape(p, swapped); });
      if (!known) orders.push_back(std::move(swapped));
    }
  }
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
    case ValueTest::kPowerOfTwo:
    case ValueTest::kShift:
      return true;
    default:
      return node.kind == PatternNode::Kind::kLiteral;
  }
}

Shape ShapeOf(const Pattern& pattern) {
  Shape shape;
  size_t at = pattern.nodes.size() - 1;
  for (uint32_t i = pattern.root().operand_count; i-- > 0;) {
    const PatternNode& operand = pattern.nodes[--at];
    bool is_op = operand.kind == PatternNode::Kind::kOp;
    if (is_op || IsConstant(operand)) {
      shape.wanted |= static_cast<uint32_t>(is_op ? operand.op : Op::kConst) << (8 * i);
      shape.mask |= 0xffu << (8 * i);
    }
    at = FirstNode(pattern.nodes, at);
  }
  return shape;
}

struct Index {
  std::deque<Pattern> replacements;
  std::vector<RuleVariant> variants;  // by operation, then in the order of the tables
  std::vector<Shape> shapes;
  std::array<uint32_t, ir::kOpCount + 1> first{};

  Index() {
    for (const Rule& rule : kRules) {
      replacements.push_back(ParsePattern(rule.replacement));
      for (Pattern& order : OperandOrders(ParsePattern(rule.pattern))) {
        variants.push_back({&rule, std::move(order), &replacements.back()});
      }
    }
    auto op_of = [](const RuleVariant& v) { return static_cast<size_t>(v.pattern.root().op); };
    std::ranges::stable_sort(variants, {}, op_of);
    for (const RuleVariant& variant : variants) {
      ++first[op_of(variant) + 1];
      shapes.push_back(ShapeOf(variant.pattern));
    }
    for (int i = 0; i < ir::kOpCount; ++i) first[i + 1] += first[i];
  }
};

const Index& TheIndex() {
  static const Index& index = *new Index;
  return index;
}

}  // namespace

std::span<const Rule> AllRules() { return kRules; }

std::span<const RuleVariant> AllVariants() { return TheIndex().variants; }

const RuleVariant* FirstMatch(const Builder& builder, Op op, TypeId type,
                              std::span<const ValueId> operands, RuleFlags allowed,
                              Bindings& bindings) {
  const Index& index = TheIndex();
  uint32_t i = index.first[static_cast<size_t>(op)];
  const uint32_t end = index.first[static_cast<size_t>(op) + 1];
  if (i == end || operands.size() > kMaxOperands) return nullptr;
  uint32_t actual = 0;
  for (size_t k = 0; k < operands.size(); ++k) {
    actual |= static_cast<uint32_t>(builder[operands[k]].op) << (8 * k);
  }
  const TypeId subject = builder.TypeOf(operands[op == Op::kSelect ? 1 : 0]);
  for (; i < end; ++i) {
    if (((actual ^ index.shapes[i].wanted) & index.shapes[i].mask) != 0) continue;
    const RuleVariant& variant = index.variants[i];
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
                             std::span<const ValueId> operands, uint32_t) const {
  if (depth_ >= kMaxDepth || operands.empty() || operands.size() > kMaxOperands) return ValueId();
  // The operands may lie in the function, which grows while a replacement is made.
  std::array<ValueId, kMaxOperands> held;
  std::ranges::copy(operands, held.begin());
  operands = {held.data(), operands.size()};
  ++depth_;
  ValueId simpler;
  Bindings bindings;
  if (const RuleVariant* found = FirstMatch(builder, op, type, operands, allowed_, bindings)) {
    simpler = Instantiate(*found->replacement, builder, bindings, type);
  }
  for (std::span<const CodeRule> rules : {StructureRules(), RangeRules()}) {
    for (const CodeRule& rule : rules) {
      if (simpler) break;
      if ((rule.flags & ~allowed_) == 0) simpler = rule.apply(builder, op, type, operands);
    }
  }
  --depth_;
  return simpler;
}

}  // namespace texgraph::passes
