// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/spirv_weight.h"

#include <algorithm>
#include <iterator>
#include <spirv-tools/optimizer.hpp>

namespace texgraph::bench {
namespace {

// SPIR-V opcodes by number, so that no header of another version is needed.
constexpr uint32_t kOpFunction = 54, kOpFunctionEnd = 56, kOpVariable = 59, kOpLabel = 248;
constexpr uint32_t kOpImageSampleFirst = 87, kOpImageSampleLast = 94, kOpImageFetch = 95;

constexpr uint32_t kMoves[] = {
    55,             // OpFunctionParameter
    61,  62,        // OpLoad, OpStore
    65,  66,        // OpAccessChain, OpInBoundsAccessChain
    77,  78,  79,   // OpVectorExtractDynamic, OpVectorInsertDynamic, OpVectorShuffle
    80,  81,  82,   // OpCompositeConstruct, OpCompositeExtract, OpCompositeInsert
    83,             // OpCopyObject
    86,  100,       // OpSampledImage, OpImage
    124,            // OpBitcast
    245, 246, 247,  // OpPhi, OpLoopMerge, OpSelectionMerge
    249, 253, 254,  // OpBranch, OpReturn, OpReturnValue
};

}  // namespace

std::optional<Weight> WeightOf(const std::vector<uint32_t>& spirv) {
  spvtools::Optimizer optimizer(SPV_ENV_OPENGL_4_5);
  optimizer.RegisterPerformancePasses();
  std::vector<uint32_t> optimized;
  if (!optimizer.Run(spirv.data(), spirv.size(), &optimized)) return std::nullopt;
  Weight weight;
  bool in_function = false;
  for (size_t at = 5; at < optimized.size(); at += optimized[at] >> 16) {
    const uint32_t op = optimized[at] & 0xffff;
    if (op == kOpFunction) in_function = true;
    if (in_function && op != kOpFunction && op != kOpFunctionEnd && op != kOpLabel &&
        op != kOpVariable) {
      ++weight.instructions;
      weight.computing += std::ranges::find(kMoves, op) == std::end(kMoves);
    }
    if ((op >= kOpImageSampleFirst && op <= kOpImageSampleLast) || op == kOpImageFetch)
      ++weight.samples;
  }
  return weight;
}

}  // namespace texgraph::bench
