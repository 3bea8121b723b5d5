// SPDX-License-Identifier: Apache-2.0
// Random operations on the values in scope, the part of random_module.h below ifs, loops and calls.
#pragma once

#include <random>
#include <vector>

#include "compiler/ir/builder.h"
#include "tests/fuzz/random_module.h"

namespace texgraph::fuzz {

class RandomValues {
 public:
  RandomValues(ir::Builder& builder, const RandomModuleOptions& options, std::mt19937& random)
      : builder_(builder), options_(options), random_(random) {}

  uint32_t Below(uint32_t n) { return static_cast<uint32_t>(random_() % n); }
  bool OneIn(uint32_t n) { return Below(n) == 0; }

  ir::TypeId AnyType();
  ir::TypeId AnyNumericType();
  ir::TypeId AnyFloatType();

  // A value of this type: one in scope, a constant, or one that is made from others. In tame
  // modules its floats are at most kBound from zero.
  ir::ValueId Pick(ir::TypeId type);
  ir::ValueId Constant(ir::TypeId type);
  // Brings `value` into scope; its floats are at most `bound` from zero.
  void Add(ir::ValueId value, double bound = kBound);
  // One more operation in scope.
  void AddOperation();

  // Values beyond the mark go out of scope.
  size_t Mark() const { return scope_.size(); }
  void Release(size_t mark) { scope_.resize(mark); }
  // At most `count` of the newest values of float, int or uint, for main to give: then most of what
  // was made is needed.
  std::vector<ir::ValueId> Newest(size_t count);
  // `value` within the bound, in tame modules.
  ir::ValueId Bounded(ir::ValueId value, double bound);

  static constexpr double kBound = 64;

 private:
  struct Entry {
    ir::ValueId value;
    double bound;
  };

  void Arithmetic();
  void Integers();
  void Floats();
  void Logic();
  void Conversions();
  void Vectors();
  void Shapes();
  void Aggregates();
  void Textures();

  ir::TypeId Vector(ir::Scalar scalar) { return ir::Vector(scalar, 1 + Below(4)); }
  ir::ValueId Make(ir::TypeId type);
  ir::ValueId Positive(ir::ValueId value);
  ir::ValueId Op1(ir::Op op, ir::ValueId a) { return builder_.Op1(op, a); }
  ir::ValueId Op2(ir::Op op, ir::ValueId a, ir::ValueId b) { return builder_.Op2(op, a, b); }
  ir::ValueId Op3(ir::Op op, ir::ValueId a, ir::ValueId b, ir::ValueId c) {
    return builder_.Op3(op, a, b, c);
  }

  ir::Builder& builder_;
  const RandomModuleOptions& options_;
  std::mt19937& random_;
  std::vector<Entry> scope_;
};

}  // namespace texgraph::fuzz
