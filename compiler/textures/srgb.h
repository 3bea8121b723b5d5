// SPDX-License-Identifier: Apache-2.0
// The sRGB transfer function (IEC 61966-2-1), as OpenGL words it (sections 8.24 and 17.3.7 of
// the 4.6 core specification). Every 8-bit code decodes to a number that encodes to the same code
// again.
#pragma once

#include <cstdint>

namespace texgraph::textures {

double SrgbDecode(double encoded);  // 0..1 to linear 0..1
double SrgbEncode(double linear);   // not clamped; NaN stays NaN
float SrgbDecode8(uint8_t encoded);
uint8_t SrgbEncode8(float linear);  // clamped and rounded to nearest; NaN gives 0
uint16_t SrgbEncode16(float linear);

// Linear 0..1 as an integer of 8 or 16 bits: clamped and rounded to nearest; NaN gives 0.
uint8_t Unorm8(float value);
uint16_t Unorm16(float value);

}  // namespace texgraph::textures
