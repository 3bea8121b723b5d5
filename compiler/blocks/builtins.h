// SPDX-License-Identifier: Apache-2.0
// The functions that every block may call without declaring them: GLSL's, as far as the block
// language has them, and the footprint.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "compiler/ir/op.h"

namespace texgraph::blocks {

// How a function's arguments and its result belong together.
enum class BuiltinFamily : uint8_t {
  kFloats,   // genType... -> genType
  kNumbers,  // the same for float, int and uint
  kSigned,   // the same for float and int
  kToFloat,  // genType... -> float
  kCross,    // vec3, vec3 -> vec3
  kMix,
  kAtan,
  kScale,      // radians, degrees
  kTestFloat,  // genType -> bvec
  kLess,       // the comparisons of vectors; kGreater: operands exchanged
  kGreater,
  kEqual,   // of boolean vectors, too
  kReduce,  // bvec -> bool
  kNot,
  kBits,  // reinterpretation
  kTexture,
  kTextureLod,
  kTextureGrad,
  kTexelFetch,
  kTextureSize,
  kRefract,
  kFaceforward,
  kMatrixCompMult,
  kOuterProduct,
  kTranspose,
  kDeterminant,
  kInverse,
  kFootprint,
};

struct Builtin {
  std::string_view name;
  BuiltinFamily family;
  ir::Op op;
  uint8_t least, most;  // arguments
  uint8_t scalars =
      0;  // bit i: argument i may be a scalar where the others are vectors; all of them or none
};

const Builtin* FindBuiltin(std::string_view name);
std::vector<std::string_view> BuiltinNames();
// What to do instead of a GLSL function that blocks don't have; "" if there is nothing special to
// say.
std::string_view BuiltinAdvice(std::string_view name);

}  // namespace texgraph::blocks
