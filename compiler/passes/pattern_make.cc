// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <mutex>
#include <optional>

#include "compiler/passes/pattern.h"
#include "compiler/passes/pattern_stack.h"

namespace texgraph::passes {
namespace {

using ir::Builder;
using ir::Op;
using ir::OpShape;
using ir::Scalar;
using ir::TypeId;
using ir::ValueId;

// What a part of a pattern has become: a value, a literal whose type is still open, or nothing,
// which is zero.
struct Item {
  ValueId value;
  const PatternNode* literal = nullptr;
  bool IsZero() const { return !value && !literal; }
};

class Maker {
 public:
  // With `structural_zeros`, unbound variables and the literal 0 are zeros that vanish.
  Maker(Builder& builder, const Bindings& bindings, TypeId type, bool structural_zeros)
      : builder_(builder), bindings_(bindings), type_(type), structural_zeros_(structural_zeros) {}

  // Invalid: zero.
  ValueId Make(Pattern pattern) {
    PatternStack<Item> items;
    for (const PatternNode& node : pattern) {
      if (node.kind == PatternNode::Kind::kVariable) {
        items.Push({bindings_.values[node.variable]});
      } else if (node.kind == PatternNode::Kind::kLiteral) {
        bool vanishes = structural_zeros_ && node.literal == 0 && !node.all_ones;
        items.Push({ValueId(), vanishes ? nullptr : &node});
      } else {
        Item made = Operation(node, items.Top(node.operand_count));
        items.Drop(node.operand_count);
        items.Push(made);
      }
    }
    Item root = items.Pop();
    if (root.IsZero()) return ValueId();
    ValueId value = root.value ? root.value : Literal(root, type_);
    bool needs_splat = ir::IsVector(type_) && ir::IsScalar(builder_.TypeOf(value));
    return needs_splat ? builder_.SplatTo(value, type_) : value;
  }

 private:
  ValueId Literal(const Item& item, TypeId type) {
    double literal = item.literal ? item.literal->literal : 0;
    if (item.literal && item.literal->all_ones) literal = -1;
    return builder_.Splat(type, literal);
  }

  // The item as a value, of the type of the first value among its siblings if it is a literal.
  void Settle(Item& item, std::span<const Item> siblings) {
    if (item.value) return;
    TypeId type = type_;
    for (const Item& sibling : siblings) {
      if (!sibling.value) continue;
      type = builder_.TypeOf(sibling.value);
      break;
    }
    item.value = Literal(item, type);
  }

  // What the operation is when some of its operands are zero; nullopt: it must be made.
  std::optional<Item> Vanished(Op op, std::span<Item> x) {
    switch (op) {
      case Op::kAdd:
        if (x[0].IsZero()) return x[1];
        if (x[1].IsZero()) return x[0];
        return std::nullopt;
      case Op::kSub:
        if (x[1].IsZero()) return x[0];
        if (!x[0].IsZero()) return std::nullopt;
        Settle(x[1], {});
        return Item{builder_.Op1(Op::kNeg, x[1].value)};
      case Op::kMul:
      case Op::kDot:
      case Op::kCross:
      case Op::kMatMul:
        if (x[0].IsZero() || x[1].IsZero()) return Item{};
        return std::nullopt;
      case Op::kDiv:
      case Op::kNeg:
      case Op::kSplat:
      case Op::kTranspose:
        if (x[0].IsZero()) return Item{};
        return std::nullopt;
      case Op::kMix:
        if (x[0].IsZero() && x[1].IsZero()) return Item{};
        return std::nullopt;
      case Op::kSelect:
        if (x[1].IsZero() && x[2].IsZero()) return Item{};
        return std::nullopt;
      default:
        return std::nullopt;
    }
  }

  Item Operation(const PatternNode& node, std::span<Item> x) {
    if (structural_zeros_) {
      if (std::optional<Item> vanished = Vanished(node.op, x)) return *vanished;
    }
    if (node.op == Op::kSelect) {
      std::span<Item> arms = x.subspan(1);
      for (Item& arm : arms) Settle(arm, arms);
    } else {
      for (Item& item : x) Settle(item, x);
    }
    return {Emit(node, x)};
  }

  ValueId Emit(const PatternNode& node, std::span<const Item> x) {
    TypeId first = builder_.TypeOf(x[0].value);
    switch (ir::Info(node.op).shape) {
      case OpShape::kSplatting:
        return builder_.SplatTo(x[0].value, ir::WithWidth(first, ir::Width(type_)));
      case OpShape::kConversion: {
        Scalar scalar = node.scalar == PatternNode::kAnyScalar ? ir::ScalarOf(type_)
                                                               : static_cast<Scalar>(node.scalar);
        return builder_.Emit(node.op, ir::Vector(scalar, ir::Width(first)), {x[0].value});
      }
      case OpShape::kIndexing:
      case OpShape::kSampling:
      case OpShape::kTextureQuery: {
        std::array<ValueId, kMaxPending> operands;
        for (size_t i = 0; i < x.size(); ++i) operands[i] = x[i].value;
        return builder_.Emit(node.op, type_, std::span<const ValueId>(operands.data(), x.size()));
      }
      default:
        break;
    }
    if (x.size() == 1) return builder_.Op1(node.op, x[0].value);
    if (x.size() == 2) return builder_.Op2(node.op, x[0].value, x[1].value);
    return builder_.Op3(node.op, x[0].value, x[1].value, x[2].value);
  }

  Builder& builder_;
  const Bindings& bindings_;
  TypeId type_;
  bool structural_zeros_;
};

// Parsed when it is first asked for.
struct DerivativeRule {
  std::once_flag once;
  DerivativeKind kind = DerivativeKind::kRule;
  std::vector<PatternNode> pattern;
};

const DerivativeRule& RuleOf(Op op) {
  static auto& rules = *new std::array<DerivativeRule, ir::kOpCount>;
  DerivativeRule& rule = rules[static_cast<size_t>(op)];
  std::call_once(rule.once, [&] {
    const std::string_view text = ir::Info(op).derivative;
    if (text == "0") {
      rule.kind = DerivativeKind::kZero;
    } else if (text == "code") {
      rule.kind = DerivativeKind::kCode;
    } else if (text == "none") {
      rule.kind = DerivativeKind::kNone;
    } else {
      ParsePattern(text, rule.pattern);
    }
  });
  return rule;
}

}  // namespace

ValueId Instantiate(Pattern pattern, Builder& builder, const Bindings& bindings, TypeId type) {
  return Maker(builder, bindings, type, false).Make(pattern);
}

DerivativeKind DerivativeOf(Op op) { return RuleOf(op).kind; }

std::optional<ValueId> InstantiateDerivative(Op op, Builder& builder, std::span<const ValueId> x,
                                             std::span<const ValueId> d, ValueId r) {
  const DerivativeRule& rule = RuleOf(op);
  if (rule.kind != DerivativeKind::kRule) return std::nullopt;
  Bindings bindings;
  for (size_t i = 0; i < x.size(); ++i) bindings.values[i] = x[i];
  for (size_t i = 0; i < d.size(); ++i) bindings.values[4 + i] = d[i];
  bindings.values[8] = r;
  ValueId made = Maker(builder, bindings, builder.TypeOf(r), true).Make(rule.pattern);
  return made ? std::optional(made) : std::nullopt;
}

}  // namespace texgraph::passes
