// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/srgb.h"

#include <array>
#include <cmath>

namespace texgraph::textures {
namespace {

struct Tables {
  static constexpr int kSteps = 4096;
  std::array<float, 256> linear;          // of each code
  std::array<float, 256> upper;           // below it, a number encodes to this code or a lower one
  std::array<uint8_t, kSteps + 1> first;  // the code of i / kSteps

  Tables() {
    for (int i = 0; i < 256; ++i) linear[i] = static_cast<float>(SrgbDecode(i / 255.0));
    for (int i = 0; i < 255; ++i) upper[i] = static_cast<float>(SrgbDecode((i + 0.5) / 255.0));
    upper[255] = INFINITY;
    int code = 0;
    for (int i = 0; i <= kSteps; ++i) {
      while (static_cast<float>(i) / kSteps >= upper[code]) ++code;
      first[i] = static_cast<uint8_t>(code);
    }
  }
};

const Tables& SrgbTables() {
  static const Tables tables;
  return tables;
}

// 0..1, NaN to 0.
float Saturate(float value) { return value > 0.0f ? (value < 1.0f ? value : 1.0f) : 0.0f; }

}  // namespace

double SrgbDecode(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

double SrgbEncode(double linear) {
  return linear < 0.0031308 ? linear * 12.92 : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

float SrgbDecode8(uint8_t encoded) { return SrgbTables().linear[encoded]; }

uint8_t SrgbEncode8(float linear) {
  const Tables& tables = SrgbTables();
  const float value = Saturate(linear);
  uint32_t code = tables.first[static_cast<uint32_t>(value * Tables::kSteps)];
  while (value >= tables.upper[code]) ++code;
  return static_cast<uint8_t>(code);
}

uint16_t SrgbEncode16(float linear) {
  return static_cast<uint16_t>(
      std::lround(SrgbEncode(static_cast<double>(Saturate(linear))) * 65535.0));
}

uint8_t Unorm8(float value) { return static_cast<uint8_t>(std::lround(Saturate(value) * 255.0)); }

uint16_t Unorm16(float value) {
  return static_cast<uint16_t>(std::lround(Saturate(value) * 65535.0));
}

}  // namespace texgraph::textures
