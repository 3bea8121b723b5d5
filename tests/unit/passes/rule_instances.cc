// SPDX-License-Identifier: Apache-2.0
#include "tests/unit/passes/rule_instances.h"

#include <bit>
#include <cmath>
#include <limits>

#include "compiler/ir/evaluate_op.h"

namespace texgraph::passes {
namespace {

using ir::Builder;
using ir::Op;
using ir::OpShape;
using ir::Scalar;
using ir::TypeId;
using ir::ValueId;
using Kind = PatternNode::Kind;

// The type of an operation on operands of these types; nothing if they don't go together. `choice`
// is the type that the result has where the operands don't say.
std::optional<TypeId> ResultType(Op op, const std::vector<TypeId>& x, TypeId choice) {
  const OpShape shape = ir::Info(op).shape;
  auto all_equal = [&](size_t from) {
    for (size_t i = from; i < x.size(); ++i) {
      if (x[i] != x[from]) return false;
    }
    return true;
  };
  if (shape == OpShape::kMatrixUnary)
    return ir::IsMatrix(x[0]) ? std::optional(x[0]) : std::nullopt;
  if (shape == OpShape::kMatrixProduct) {
    bool left = x[0] == ir::kMat2, right = x[1] == ir::kMat2;
    if (left && (right || x[1] == ir::kVec2)) return x[1];
    return right && x[0] == ir::kVec2 ? std::optional(x[0]) : std::nullopt;
  }
  for (TypeId type : x) {
    if (!ir::IsVector(type)) return std::nullopt;
  }
  const Scalar scalar = ir::ScalarOf(x[0]);
  const TypeId bools = ir::Vector(Scalar::kBool, ir::Width(x[0]));
  auto if_true = [](bool ok, TypeId type) { return ok ? std::optional(type) : std::nullopt; };
  switch (shape) {
    case OpShape::kNumeric:
      return if_true(all_equal(0) && scalar != Scalar::kBool, x[0]);
    case OpShape::kInteger:
      return if_true(all_equal(0) && (scalar == Scalar::kInt || scalar == Scalar::kUint), x[0]);
    case OpShape::kFloating:
      if (op == Op::kCross && ir::Width(x[0]) != 3) return std::nullopt;
      return if_true(all_equal(0) && scalar == Scalar::kFloat, x[0]);
    case OpShape::kDotLike:
    case OpShape::kLengthLike:
      return if_true(all_equal(0) && scalar == Scalar::kFloat, ir::kFloat);
    case OpShape::kComparison: {
      bool ordered = op == Op::kLt || op == Op::kLe;
      return if_true(all_equal(0) && !(ordered && scalar == Scalar::kBool), bools);
    }
    case OpShape::kLogic:
      return if_true(all_equal(0) && scalar == Scalar::kBool, x[0]);
    case OpShape::kReduceBool:
      return if_true(scalar == Scalar::kBool && !ir::IsScalar(x[0]), ir::kBool);
    case OpShape::kTestFloat:
      return if_true(scalar == Scalar::kFloat, bools);
    case OpShape::kSelection: {
      bool fits = ir::Width(x[0]) == 1 || ir::Width(x[0]) == ir::Width(x[1]);
      return if_true(scalar == Scalar::kBool && fits && all_equal(1), x[1]);
    }
    case OpShape::kConversion: {
      TypeId to = ir::WithWidth(choice, ir::Width(x[0]));
      bool bits = op == Op::kConvert || (!ir::IsBool(to) && scalar != Scalar::kBool);
      return if_true(choice == to && to != x[0] && bits, to);
    }
    case OpShape::kSplatting:
      return if_true(ir::IsScalar(x[0]) && !ir::IsScalar(choice) && ir::ScalarType(choice) == x[0],
                     choice);
    default:
      return std::nullopt;
  }
}

// Walks a pattern bottom up with types in place of values; with a builder, makes the values too.
class Walk {
 public:
  Walk(Pattern pattern, const Typing& typing, const Bindings* bindings, Builder* builder)
      : pattern_(pattern), typing_(typing), bindings_(bindings), builder_(builder) {}

  // The operands of the root, and its type; nothing if the types don't fit.
  std::optional<TypeId> Run() {
    for (size_t i = 0; i < pattern_.size(); ++i) {
      const PatternNode& node = pattern_[i];
      if (node.kind == Kind::kVariable) {
        ValueId value = bindings_ ? bindings_->values[node.variable] : ValueId();
        items_.push_back({typing_.variables[node.variable], value, nullptr});
      } else if (node.kind == Kind::kLiteral) {
        items_.push_back({TypeId(), ValueId(), &node});
      } else if (!Operation(i)) {
        return std::nullopt;
      }
    }
    return items_.back().type;
  }

  std::vector<ValueId> operands_of_root;
  TypeId root_type;

 private:
  struct Item {
    TypeId type;  // invalid: a literal whose place has given it none yet
    ValueId value;
    const PatternNode* literal;
  };

  bool Operation(size_t index) {
    const PatternNode& node = pattern_[index];
    std::vector<Item> x(items_.end() - node.operand_count, items_.end());
    items_.resize(items_.size() - node.operand_count);
    const TypeId choice = typing_.nodes[index];
    const size_t first = node.op == Op::kSelect ? 1 : 0;
    TypeId settled = choice;
    for (size_t i = x.size(); i-- > first;) {
      if (x[i].type) settled = x[i].type;
    }
    std::vector<TypeId> types;
    for (Item& item : x) {
      if (!item.type) item.type = settled;
      if (!item.type) return false;
      types.push_back(item.type);
    }
    std::optional<TypeId> result = ResultType(node.op, types, choice);
    if (!result) return false;
    if (node.scalar != PatternNode::kAnyScalar &&
        static_cast<uint8_t>(ir::ScalarOf(*result)) != node.scalar) {
      return false;
    }
    ValueId value;
    if (builder_) {
      std::vector<ValueId> operands;
      for (Item& item : x) operands.push_back(item.value ? item.value : Literal(item));
      if (index + 1 == pattern_.size()) {
        operands_of_root = operands;
        root_type = *result;
      } else {
        value = builder_->Emit(node.op, *result, operands);
      }
    }
    items_.push_back({*result, value, nullptr});
    return true;
  }

  ValueId Literal(const Item& item) {
    return builder_->Splat(item.type, item.literal->all_ones ? -1 : item.literal->literal);
  }

  Pattern pattern_;
  const Typing& typing_;
  const Bindings* bindings_;
  Builder* builder_;
  std::vector<Item> items_;
};

bool HasMatrices(Pattern pattern) {
  for (const PatternNode& node : pattern) {
    if (node.kind == Kind::kOp && (node.op == Op::kMatMul || node.op == Op::kTranspose))
      return true;
  }
  return false;
}

// What a node's type may be, as far as the node alone tells.
std::vector<TypeId> Choices(const PatternNode& node, const std::vector<TypeId>& all) {
  std::vector<TypeId> fitting;
  for (TypeId type : all) {
    bool fits = node.scalar == PatternNode::kAnyScalar ||
                (ir::IsVector(type) && static_cast<uint8_t>(ir::ScalarOf(type)) == node.scalar);
    if (fits) fitting.push_back(type);
  }
  return fitting;
}

bool NeedsChoice(Pattern pattern, size_t index) {
  const PatternNode& node = pattern[index];
  if (node.kind != Kind::kOp) return false;
  if (node.op == Op::kConvert || node.op == Op::kBitcast || node.op == Op::kSplat) return true;
  // A select between two literals, or anything on literals alone.
  bool literals = node.operand_count > 0;
  for (size_t i = node.op == Op::kSelect ? 2 : node.operand_count, at = index; i-- > 0;) {
    literals = literals && pattern[--at].kind == Kind::kLiteral;
    if (!literals) break;
  }
  return literals;
}

}  // namespace

std::vector<Typing> TypingsOf(Pattern pattern) {
  std::vector<TypeId> all = {ir::kBool,  ir::kInt,   ir::kUint,  ir::kFloat,
                             ir::kBvec3, ir::kIvec3, ir::kUvec3, ir::kVec3};
  if (HasMatrices(pattern)) all = {ir::kVec2, ir::kMat2};
  // Places to choose a type for: variables, then nodes.
  std::vector<std::vector<TypeId>> domains;
  std::vector<int> places;
  std::array<bool, kMaxVariables> seen{};
  for (size_t i = 0; i < pattern.size(); ++i) {
    const PatternNode& node = pattern[i];
    if (node.kind == Kind::kVariable && !seen[node.variable]) {
      seen[node.variable] = true;
      places.push_back(node.variable);
      domains.push_back(Choices(node, all));
    } else if (NeedsChoice(pattern, i)) {
      places.push_back(static_cast<int>(kMaxVariables + i));
      domains.push_back(Choices(node, all));
    }
  }
  std::vector<Typing> typings;
  std::vector<size_t> digits(places.size(), 0);
  while (true) {
    Typing typing;
    typing.nodes.resize(pattern.size());
    for (size_t i = 0; i < places.size(); ++i) {
      size_t place = static_cast<size_t>(places[i]);
      (place < kMaxVariables ? typing.variables[place] : typing.nodes[place - kMaxVariables]) =
          domains[i][digits[i]];
    }
    if (std::optional<TypeId> root = Walk(pattern, typing, nullptr, nullptr).Run()) {
      typing.root = *root;
      typings.push_back(typing);
    }
    size_t i = 0;
    while (i < digits.size() && ++digits[i] == domains[i].size()) digits[i++] = 0;
    if (i == digits.size()) return typings;
  }
}

std::vector<ValueId> BuildOperands(Pattern pattern, const Typing& typing, const Bindings& bindings,
                                   Builder& builder) {
  Walk walk(pattern, typing, &bindings, &builder);
  walk.Run();
  return walk.operands_of_root;
}

ValueId Build(Pattern pattern, const Typing& typing, const Bindings& bindings, Builder& builder) {
  return builder.Emit(pattern.back().op, typing.root,
                      BuildOperands(pattern, typing, bindings, builder));
}

uint32_t AwkwardWord(TypeId scalar, std::mt19937& random) {
  constexpr float kInf = std::numeric_limits<float>::infinity();
  constexpr float kMax = std::numeric_limits<float>::max();
  static const float kFloats[] = {
      0.0f,           -0.0f,        1.0f,        -1.0f,           0.5f,        -0.5f,
      1.5f,           -1.5f,        2.0f,        -2.0f,           3.0f,        0.25f,
      1e-40f,         -1e-40f,      1e-45f,      1.17549435e-38f, kMax,        -kMax,
      kInf,           -kInf,        NAN,         1e-9f,           -1e-9f,      1e20f,
      -1e20f,         8388608.5f,   16777216.0f, 100.0f,          0.99999994f, 1.0000001f,
      -2147483648.0f, 4294967040.0f};
  static const uint32_t kIntegers[] = {
      0,  1,  2,  3,  0xffffffffu, 0xfffffffeu, 0x80000000u, 0x7fffffffu, 0x80000001u,
      31, 32, 33, 15, 16,          255,         0xffff,      1u << 24,    (1u << 24) + 1};
  std::uniform_int_distribution<uint32_t> any;
  const bool listed = any(random) % 2 == 0;
  if (scalar == ir::kBool) return any(random) & 1;
  if (scalar == ir::kFloat) {
    // Often equal, and often zeros of both signs.
    if (any(random) % 4 == 0) return std::bit_cast<uint32_t>(kFloats[any(random) % 4]);
    if (listed) return std::bit_cast<uint32_t>(kFloats[any(random) % std::size(kFloats)]);
    std::uniform_real_distribution<float> mantissa(-1, 1);
    return std::bit_cast<uint32_t>(
        std::ldexp(mantissa(random), static_cast<int>(any(random) % 40) - 20));
  }
  if (listed) return kIntegers[any(random) % std::size(kIntegers)];
  return any(random) >> (any(random) % 32);
}

uint32_t ModerateWord(TypeId scalar, std::mt19937& random) {
  if (scalar != ir::kFloat) return AwkwardWord(scalar, random);
  std::uniform_real_distribution<float> exponent(-2, 1);
  float value = std::pow(10.0f, exponent(random));
  return std::bit_cast<uint32_t>(random() % 2 ? value : -value);
}

Bindings MakeVariables(Pattern pattern, const Typing& typing, Builder& builder,
                       std::mt19937& random) {
  Bindings bindings;
  for (const PatternNode& node : pattern) {
    if (node.kind != Kind::kVariable || bindings.values[node.variable]) continue;
    const TypeId type = typing.variables[node.variable];
    ValueId value =
        builder.AddParameter({std::string(1, static_cast<char>('a' + node.variable)), type, false});
    switch (node.test) {
      case ValueTest::kAny:
        break;
      case ValueTest::kNonnegative:
        if (ir::IsFloat(type)) value = builder.Op1(Op::kAbs, value);
        if (ir::IsInteger(type))
          value = builder.Op2(Op::kAnd, value, builder.Splat(type, 0x7fffffff));
        break;
      case ValueTest::kIntegral:
        value = builder.Op1(Op::kFloor, value);
        break;
      case ValueTest::kFloatInteger:
        value = builder.Op2(Op::kAnd, value, builder.Splat(type, 0xffff));
        break;
      default: {
        std::vector<uint32_t> words(builder.module().types.Words(type));
        TypeId scalar = ir::IsVector(type) ? ir::ScalarType(type) : ir::kFloat;
        for (int attempt = 0; attempt < 10000; ++attempt) {
          for (uint32_t& word : words) word = AwkwardWord(scalar, random);
          value = builder.Const(type, words);
          if (Passes(node.test, builder, value)) break;
        }
      }
    }
    bindings.values[node.variable] = value;
  }
  return bindings;
}

std::vector<std::vector<uint32_t>> EvaluateAll(const ir::Module& module,
                                               const ir::Function& function,
                                               const std::vector<std::vector<uint32_t>>& parameters,
                                               uint32_t lanes) {
  std::vector<std::vector<uint32_t>> values(function.insts.size());
  for (size_t i = 0; i < function.insts.size(); ++i) {
    const ir::Inst& inst = function.insts[i];
    if (inst.op == Op::kParam) {
      values[i] = parameters[inst.aux];
    } else if (inst.op == Op::kConst) {
      for (uint32_t word : module.Words(ir::ConstId(inst.aux)))
        values[i].insert(values[i].end(), lanes, word);
    } else {
      std::vector<TypeId> types;
      std::vector<const uint32_t*> operands;
      for (ValueId v : function.Operands(inst)) {
        types.push_back(function[v].type);
        operands.push_back(values[v.index].data());
      }
      values[i].resize(module.types.Words(inst.type) * lanes);
      ir::EvaluateOp(module.types, {inst.op, inst.type, types, operands, inst.aux, lanes},
                     values[i].data());
    }
  }
  return values;
}

}  // namespace texgraph::passes
