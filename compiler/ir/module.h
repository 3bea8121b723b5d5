// SPDX-License-Identifier: Apache-2.0
// The intermediate form: typed values in single assignment, with regions instead of a control-flow
// graph.
//
// A module owns types, constants, globals and functions. A function owns its instructions; an
// instruction is at most one value. Every instruction but constants and parameters stands in the
// body of exactly one region, and its operands come before it in that body or in an enclosing
// region's. All operations are pure: the order of a body is free but for operands, and what nothing
// uses is not there. Vectors only grow: a pass reads one function and builds another through
// Builder (builder.h).
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "compiler/base/ids.h"
#include "compiler/base/name_map.h"
#include "compiler/ir/op.h"
#include "compiler/ir/type.h"

namespace texgraph::ir {

using ValueId = Id<struct ValueTag>;        // an instruction of one function
using ConstId = Id<struct ConstTag>;        // of the module
using GlobalId = Id<struct GlobalTag>;      // of the module
using FunctionId = Id<struct FunctionTag>;  // of the module
using RegionId = Id<struct RegionTag>;      // of one function
using LoopId = Id<struct LoopTag>;          // of one function
using BranchId = Id<struct BranchTag>;      // of one function
using NameId = Id<struct NameTag>;          // an interned string of the module
using OriginId = Id<struct OriginTag>;      // of the module

struct Inst {
  Op op;
  uint16_t operand_count = 0;
  TypeId type;
  uint32_t first_operand = 0;  // into Function::operands
  uint32_t aux = 0;  // kConst: ConstId. kParam: index. kGlobal: GlobalId. kExtract: index.
                     // kSwizzle: mask. kIf: BranchId. kFor: LoopId. kCall, kFieldRef: FunctionId
};

struct Region {
  std::vector<ValueId> params;   // of a loop's body: the index, then the carried values. Of a
                                 // function: all parameters
  std::vector<ValueId> body;     // in order; constants and parameters are in no body
  std::vector<ValueId> results;  // what the region yields or the function returns
};

// The two sides of a kIf; their results have equal types.
struct Branch {
  RegionId then_region;
  RegionId else_region;
};

// for (int i = first; i < last; i += step): the trip count is known when the loop is made, so every
// loop ends.
struct ForLoop {
  int32_t first = 0;
  int32_t last = 0;
  int32_t step = 1;  // never 0; if negative, counts down while i > last
  RegionId body;     // its results are the carried values of the next round
  uint32_t Trips() const;
};

struct Parameter {
  std::string name;
  TypeId type;
  // Template parameters ("const" in a block). Specialize leaves none.
  bool is_template = false;
  bool repeats = false;  // textures: all that are passed repeat, as Global::repeats says
};

struct Result {
  std::string name;  // empty: the return value; else an out parameter
  TypeId type;
};

struct Function {
  std::string name;          // unique in the module
  std::string display_name;  // the name that the printer would like: the block's or the node's
  OriginId origin;           // the block or node it came from
  std::vector<Parameter> parameters;
  std::vector<Result> results;
  RegionId body;
  // Of a field of one argument, before Specialize: the last two parameters are an argument and the
  // result for it, so that nothing has to be computed for that.
  bool knows_home = false;

  std::vector<Inst> insts;
  std::vector<ValueId> operands;
  std::vector<Region> regions;
  std::vector<Branch> branches;
  std::vector<ForLoop> loops;
  // Side tables, as long as `insts` or shorter.
  std::vector<NameId> names;
  std::vector<OriginId> origins;

  const Inst& operator[](ValueId v) const { return insts[v.index]; }
  std::span<const ValueId> Operands(const Inst& inst) const {
    return {operands.data() + inst.first_operand, inst.operand_count};
  }
  std::span<const ValueId> Operands(ValueId v) const { return Operands(insts[v.index]); }
  const Region& Body() const { return regions[body.index]; }
  NameId NameOf(ValueId v) const { return v.index < names.size() ? names[v.index] : NameId(); }
  OriginId OriginOf(ValueId v) const {
    return v.index < origins.size() ? origins[v.index] : OriginId();
  }
};

struct Constant {
  TypeId type;
  uint32_t first_word =
      0;  // into Module::words; Types::Words(type) of them, floats as their bits, bools as 0 or 1
};

enum class GlobalKind : uint8_t { kInput, kUniform, kSpecialization, kTexture };

// What is known of a texture that holds whole numbers ("map", "lists" or "sprites" in a graph) when
// the shader is made. It has one mip level; a fetch of any other, or outside of it, gives zeros.
struct MapFacts {
  uint32_t width = 1;
  uint32_t height = 1;
  uint32_t layers = 1;  // of an array; else 1
  // Of a map whose numbers never change ("binding": "constant"): red of each texel, x fastest, row
  // 0 at v = 0. Its green and blue are 0, its alpha is 1. Empty for all others.
  std::vector<int32_t> values;
};

struct Global {
  GlobalKind kind;
  std::string name;
  TypeId type;
  ConstId value;          // the default of uniforms and specialisation constants
  bool is_smooth = true;  // textures: filtered linearly, so that what is sampled is continuous
  bool repeats = false;   // textures: in every direction, so that whole numbers may be added
  std::optional<MapFacts> map = std::nullopt;  // textures
};

// Where a value came from, for comments and diagnostics. The module keeps the texts.
struct Origin {
  std::string_view node;    // "face"; empty inside a block
  std::string_view block;   // "layer"
  std::string_view source;  // "layers/layer.glsl"
};

class Module {
 public:
  Module() = default;
  Module(Module&&) = default;
  Module& operator=(Module&&) = default;

  Types types;
  std::deque<Function> functions;  // callees before callers
  std::vector<Global> globals;
  std::vector<Origin> origins;
  // What authors called their constant arrays, which shaders write once and name.
  std::unordered_map<ConstId, NameId> constant_names;
  FunctionId main;

  ConstId Intern(TypeId type, std::span<const uint32_t> words);
  const Constant& constant(ConstId id) const { return constants_[id.index]; }
  size_t constant_count() const { return constants_.size(); }
  std::span<const uint32_t> Words(ConstId id) const {
    const Constant& c = constants_[id.index];
    return {words_.data() + c.first_word, types.Words(c.type)};
  }

  NameId InternName(std::string_view name);
  std::string_view Name(NameId id) const { return names_[id.index]; }

  OriginId AddOrigin(const Origin& origin);
  GlobalId AddGlobal(Global global);
  Function& operator[](FunctionId id) { return functions[id.index]; }
  const Function& operator[](FunctionId id) const { return functions[id.index]; }
  // The type of a call: the only result's, or a tuple of all.
  TypeId CallType(const Function& function);

 private:
  std::vector<Constant> constants_;
  std::vector<uint32_t> words_;
  // Open addressing by what a constant is, a power of two of slots.
  std::vector<ConstId> constant_slots_;
  ConstId& ConstantSlot(TypeId type, std::span<const uint32_t> words);
  std::deque<std::string> names_;
  NameMap<NameId> name_index_;
};

}  // namespace texgraph::ir
