// SPDX-License-Identifier: Apache-2.0
// What a quad of 2 x 2 pixels computes together: differences and texture samples. Words lie as in
// evaluate_op.h.
#pragma once

#include <cstdint>
#include <span>

#include "compiler/ir/op.h"
#include "compiler/ir/texture.h"
#include "compiler/ir/type.h"

namespace texgraph::ir::quads {

// dfdx and dx: the right pixel less the left one of its row; dfdy and dy: the upper one less the
// lower one of its column.
void Difference(bool along_y, const uint32_t* x, uint32_t words, uint32_t lanes, uint32_t* result);

struct SampleArguments {
  Op op;
  TypeId sampler;                             // the sampler type
  const Texture* texture;                     // null: nothing is bound
  std::span<const uint32_t* const> operands;  // after the sampler
  uint32_t lanes;
  uint64_t active;  // lane l is needed if bit l is set; lanes that are not get zeros
};

// kSample, kSampleGrad, kSampleLod, kFetch: four words a lane.
void Sample(const SampleArguments& arguments, uint32_t* result);

// kTextureSize: `level`, one word a lane, to the size; zeros for a level that there is not.
void Size(TypeId sampler, const Texture* texture, const uint32_t* level, uint32_t lanes,
          uint32_t* result);

}  // namespace texgraph::ir::quads
