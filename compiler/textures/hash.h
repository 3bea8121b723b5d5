// SPDX-License-Identifier: Apache-2.0
// The random numbers of prepared textures: PCG's output permutation of 32 bits, nested as in the
// blocks (docs/decisions/0003-hash.md), so that they are the same on every machine.
#pragma once

#include <cstdint>

namespace texgraph::textures {

inline uint32_t Pcg(uint32_t value) {
  const uint32_t state = value * 747796405u + 2891336453u;
  const uint32_t word = ((state >> (state >> 28 & 15)) >> 4 ^ state) * 277803737u;
  return word >> 22 ^ word;
}

// Of texel (x, y): every stream of every seed has its own.
inline uint32_t TexelHash(uint32_t seed, uint32_t stream, uint32_t x, uint32_t y) {
  return Pcg(x + Pcg(y + Pcg(stream + Pcg(seed))));
}

}  // namespace texgraph::textures
