// SPDX-License-Identifier: Apache-2.0
// A function's body after checking: every name is a slot, a constant or a callee, every type is
// known, every conversion is explicit, loops have their shape. What is left open are the values of
// template parameters, and with them the bounds of loops.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "compiler/base/ids.h"
#include "compiler/base/source.h"
#include "compiler/ir/module.h"
#include "compiler/ir/op.h"

namespace texgraph::blocks {

struct File;

using TypedId = Id<struct TypedTag>;  // an expression of one typed function

enum class TypedKind : uint8_t {
  kConstant,   // aux: ConstId
  kSlot,       // aux: slot
  kOp,         // op, with aux as in ir::Inst; the types of the children are the operation's
  kConstruct,  // a vector from scalars and vectors, a struct or an array from its elements
  kSwizzle,    // aux: mask
  kComposite,  // a function or operator that is several operations
  kLength,     // of an array whose type does not tell
  kChoose,     // condition, value if true, value if false
  kCall,  // aux: callee; children: the arguments that go in, without those of template parameters
          // and fields
  kCallField,  // aux: the file's field
};

enum class Composite : uint8_t {
  kNone,
  kByColumn,      // op on matrices, or on a matrix and a scalar
  kMatrix,        // a matrix from scalars and vectors, column after column
  kDiagonal,      // a matrix from one scalar
  kResizeMatrix,  // a matrix from a larger or a smaller one, rest from the identity
  kAllEqual,      // == of anything
  kRefract,
  kFaceforward,
  kOuterProduct,
  kDeterminant,
  kInverse,
  kFootprint,
};

struct TypedExpr {
  TypedKind kind = TypedKind::kConstant;
  Composite composite = Composite::kNone;
  ir::Op op = ir::Op::kConst;
  ir::TypeId type;              // kCall: the return value's; kVoid if there is none
  uint32_t begin = 0, end = 0;  // in the file's source
  uint32_t first_child = 0, child_count = 0;
  uint32_t aux = 0;
};

// A function that is called: of this file or of another.
struct Callee {
  File* file = nullptr;
  uint32_t function = 0;
  ir::TypeId gen_type;
  std::vector<TypedId> template_arguments;  // in the order of its template parameters
};

// A variable or a part of it. Each step goes one deeper.
struct Place {
  struct Step {
    enum class Kind : uint8_t { kElement, kComputed, kSwizzle } kind;
    uint32_t aux = 0;  // the element's index, the swizzle's mask
    TypedId index;     // kComputed
    ir::TypeId type;   // of the part
  };
  uint32_t slot = 0;
  std::vector<Step> steps;
};

enum class TypedStmtKind : uint8_t {
  kAssign,  // place = value; without a value: zero
  kCall,    // value is the call; places take the return value (if any) and the out parameters
  kIf,      // value, first, second
  kFor,
  kReturn,  // value or none
};

struct TypedStmt {
  TypedStmtKind kind = TypedStmtKind::kAssign;
  bool returns = false;  // a return stands in it somewhere
  bool ends = false;     // it returns whatever happens
  TypedId value;
  std::vector<Place> places;
  std::vector<TypedStmt> first, second;
  // kFor: for (int slot = value; slot < last; slot += step)
  uint32_t slot = 0;
  TypedId last, step;
  bool inclusive = false;         // <= or >=
  bool downward = false;          // > or >=
  bool negated = false;           // -= or --
  std::vector<uint32_t> carried;  // slots from outside that the body assigns, ascending
  SourceRange range;
};

struct Slot {
  std::string_view name;  // empty for what has no name in the file
  ir::TypeId type;
  SourceRange range;
  bool is_fixed = false;     // a constant, a loop's index, a parameter that is const
  bool is_assigned = false;  // in the body
};

struct TypedFunction {
  File* file = nullptr;
  uint32_t function = 0;
  ir::TypeId gen_type;
  bool valid = false;
  std::vector<Slot> slots;  // the function's parameters first, in order
  std::vector<TypedExpr> exprs;
  std::vector<TypedId> children;
  std::vector<Callee> callees;
  std::vector<TypedStmt> body;

  const TypedExpr& operator[](TypedId id) const { return exprs[id.index]; }
  TypedId Child(TypedId id, uint32_t i) const { return children[exprs[id.index].first_child + i]; }
};

}  // namespace texgraph::blocks
