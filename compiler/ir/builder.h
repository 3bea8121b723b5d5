// SPDX-License-Identifier: Apache-2.0
// Builder is the only way to make instructions. It folds constants and takes apart what was just put together, applies the
// algebraic rules it is given, and returns the known value when an equal one is in scope (hash-consing). So common
// subexpressions are not a pass, and a value that comes back may be older than the call that asked for it.
#pragma once

#include <initializer_list>
#include <span>
#include <string_view>
#include <vector>

#include "compiler/ir/module.h"

namespace texgraph::ir {

class Builder;

// Algebraic rules (passes/simplify.h gives the project's). Returns the simpler value, or an invalid id to keep the operation.
class Rules {
 public:
  virtual ~Rules() = default;
  virtual ValueId Apply(Builder& builder, Op op, TypeId type, std::span<const ValueId> operands,
                        uint32_t aux) const = 0;
};

struct BuilderOptions {
  bool fold = true;  // constants, and construct against extract; off for the unoptimised leg of the tests
  const Rules* rules = nullptr;
};

class Builder {
 public:
  // Appends to `function`, which has no body yet, or to the region that is open in it.
  Builder(Module& module, Function& function, BuilderOptions options = {});

  Module& module() { return module_; }
  const Module& module() const { return module_; }
  bool folds() const { return options_.fold; }
  Function& function() { return function_; }
  const Function& function() const { return function_; }
  const Inst& operator[](ValueId v) const { return function_.insts[v.index]; }
  TypeId TypeOf(ValueId v) const { return function_.insts[v.index].type; }

  // --- Constants -------------------------------------------------------------------------------------------------
  ValueId Const(ConstId id);
  ValueId Const(TypeId type, std::span<const uint32_t> words);
  ValueId Float(float value);
  ValueId Int(int32_t value);
  ValueId Uint(uint32_t value);
  ValueId Bool(bool value);
  // `value` in every component of a vector type or scalar (converted to its scalar), zero in every word of any other type.
  ValueId Splat(TypeId type, double value);
  ValueId Zero(TypeId type);
  bool IsConst(ValueId v) const { return (*this)[v].op == Op::kConst; }
  std::span<const uint32_t> ConstWords(ValueId v) const;

  // --- Operations ------------------------------------------------------------------------------------------------
  // The general form. The types must be as op.h says; the verifier checks them, Emit does not.
  ValueId Emit(Op op, TypeId type, std::span<const ValueId> operands, uint32_t aux = 0);
  ValueId Emit(Op op, TypeId type, std::initializer_list<ValueId> operands, uint32_t aux = 0) {
    return Emit(op, type, std::span<const ValueId>(operands.begin(), operands.size()), aux);
  }
  // The result type is computed from the operands'. For the shapes from kNumeric to kTestFloat, and kSelection, kMatrixProduct.
  // A scalar operand beside vector operands is splat first.
  ValueId Op1(Op op, ValueId a);
  ValueId Op2(Op op, ValueId a, ValueId b);
  ValueId Op3(Op op, ValueId a, ValueId b, ValueId c);
  ValueId Convert(ValueId v, TypeId type);    // to another scalar kind, the same width
  ValueId SplatTo(ValueId scalar, TypeId vector);  // the same value if the type is a scalar
  // A vector from scalars and vectors, a matrix from columns, a struct or an array from its elements.
  ValueId Construct(TypeId type, std::span<const ValueId> parts);
  ValueId Extract(ValueId aggregate, uint32_t index);
  ValueId Swizzle(ValueId vector, std::span<const uint8_t> components);
  ValueId Insert(ValueId aggregate, uint32_t index, ValueId element);  // the aggregate with one element replaced
  ValueId Global(GlobalId id);
  ValueId Call(FunctionId callee, std::span<const ValueId> arguments);
  // The i-th result of a call, an if or a loop: the value itself if there is just one.
  ValueId Result(ValueId value, uint32_t index, uint32_t result_count);

  // --- Structure -------------------------------------------------------------------------------------------------
  // Declares the function's next parameter; only while the function's own region is the open one.
  ValueId AddParameter(Parameter parameter);
  // Opens a region inside the open one; what is emitted goes there until EndRegion.
  RegionId BeginRegion();
  ValueId AddRegionParameter(TypeId type);
  void EndRegion(std::span<const ValueId> results);
  // Two closed regions begun at this level, with results of equal types, at least one. A region is used once.
  ValueId If(ValueId condition, RegionId then_region, RegionId else_region);
  // loop.body's parameters are the index (int) and the carried values; `initial` are the carried values' first ones, at least one.
  ValueId For(ForLoop loop, std::span<const ValueId> initial);
  // Sets the function's results. `values` match function().results, which this fills with types if it is empty.
  void Return(std::span<const ValueId> values);

  // --- Names and origins -----------------------------------------------------------------------------------------
  // Gives a value the name that the printer will use, unless it has one.
  void Name(ValueId v, std::string_view name);
  void Name(ValueId v, NameId name);
  // The origin of every instruction made from now on.
  void SetOrigin(OriginId origin) { origin_ = origin; }
  OriginId origin() const { return origin_; }

 private:
  struct Key {
    Op op;
    TypeId type;
    uint32_t aux;
  };
  ValueId Append(Op op, TypeId type, std::span<const ValueId> operands, uint32_t aux, bool in_body);
  ValueId Lookup(uint64_t hash, Op op, TypeId type, std::span<const ValueId> operands, uint32_t aux) const;
  ValueId FoldStructure(Op op, TypeId type, std::span<const ValueId> operands, uint32_t aux);
  ValueId FoldExtract(ValueId aggregate, uint32_t index);
  ValueId FoldSwizzle(TypeId type, ValueId vector, uint32_t mask);
  ValueId FoldConstruct(TypeId type, std::span<const ValueId> parts);
  ValueId FoldConstants(Op op, TypeId type, std::span<const ValueId> operands, uint32_t aux);
  ValueId ConstElement(ValueId aggregate, uint32_t index);

  Module& module_;
  Function& function_;
  BuilderOptions options_;
  OriginId origin_;
  std::vector<RegionId> open_;              // innermost last
  std::vector<size_t> scope_marks_;         // into scope_log_, one per open region
  std::vector<uint32_t> scope_log_;         // buckets that entries were added to
  // The function's constants: open addressing by ConstId, a power of two of slots.
  std::vector<ValueId> constant_slots_;
  size_t constant_count_ = 0;
  ValueId& ConstantSlot(ConstId id);
  // A chained hash table whose entries are undone when their region closes.
  struct Entry {
    uint64_t hash;
    ValueId value;
    uint32_t next;
  };
  std::vector<Entry> entries_;
  std::vector<uint32_t> buckets_;
  void Remember(uint64_t hash, ValueId value);
  void Grow();
};

// The components of a swizzle's aux, as many as the result is wide.
constexpr uint32_t SwizzleComponent(uint32_t mask, uint32_t i) { return (mask >> (2 * i)) & 3; }

}  // namespace texgraph::ir
