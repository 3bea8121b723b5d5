// SPDX-License-Identifier: Apache-2.0
// Floats of 16 bits (IEEE 754 binary16), converted as GPUs do: every half is a float; a float gives
// the nearest half, ties to even, infinity beyond 65,504. NaN stays NaN.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace texgraph::textures {

inline float HalfToFloat(uint16_t half) {
  const uint32_t exponent = half >> 10 & 31u;
  const uint32_t fraction = half & 1023u;
  float magnitude;
  if (exponent == 31) {
    magnitude = fraction == 0 ? INFINITY : NAN;
  } else if (exponent == 0) {
    magnitude = static_cast<float>(fraction) * 0x1p-24f;
  } else {
    magnitude = std::bit_cast<float>((exponent + 112) << 23 | fraction << 13);
  }
  return half >> 15 ? -magnitude : magnitude;
}

inline uint16_t FloatToHalf(float value) {
  const uint32_t bits = std::bit_cast<uint32_t>(value);
  const uint32_t sign = bits >> 16 & 0x8000u;
  const uint32_t magnitude = bits & 0x7fffffffu;
  uint32_t half;
  if (magnitude > 0x7f800000u) {
    half = 0x7e00;
  } else if (magnitude >= 0x477ff000u) {  // 65,520: half way to what would be the next
    half = 0x7c00;
  } else if (magnitude < 0x38800000u) {  // below 2^-14: in steps of 2^-24, rounded by the addition
    half = std::bit_cast<uint32_t>(std::bit_cast<float>(magnitude) + 0.5f) - 0x3f000000u;
  } else {
    half = (magnitude - 0x38000000u + 0xfffu + (magnitude >> 13 & 1u)) >> 13;
  }
  return static_cast<uint16_t>(sign | half);
}

}  // namespace texgraph::textures
