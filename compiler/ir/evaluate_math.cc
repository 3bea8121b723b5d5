// SPDX-License-Identifier: Apache-2.0
// Transcendental functions. Each is computed in double precision and rounded once: that is the
// correctly rounded float but for a few arguments in a billion, so a folded constant does not
// depend on which C library folded it.
#include <cmath>
#include <limits>

#include "compiler/ir/evaluate_families.h"

namespace texgraph::ir::families {
namespace {

template <double (*kFunction)(double)>
void MapDouble(const uint32_t* x, uint32_t n, uint32_t* r) {
  Map<float>(x, n, r, [](float a) { return static_cast<float>(kFunction(a)); });
}

// Undefined in GLSL for x < 0, where GPUs, which compute exp2(y * log2(x)), give NaN.
float Pow(float x, float y) {
  if (x < 0.0f) return std::numeric_limits<float>::quiet_NaN();
  return static_cast<float>(std::pow(static_cast<double>(x), static_cast<double>(y)));
}
// The angle of (x, y); GLSL's atan(y, x). At the origin, where GLSL leaves it undefined, C's value.
float Atan2(float y, float x) {
  return static_cast<float>(std::atan2(static_cast<double>(y), static_cast<double>(x)));
}

}  // namespace

bool Math(Op op, Operands x, uint32_t n, uint32_t* r) {
  switch (op) {
    case Op::kPow:
      Map<float>(x[0], x[1], n, r, Pow);
      return true;
    case Op::kExp:
      MapDouble<std::exp>(x[0], n, r);
      return true;
    case Op::kLog:
      MapDouble<std::log>(x[0], n, r);
      return true;
    case Op::kExp2:
      MapDouble<std::exp2>(x[0], n, r);
      return true;
    case Op::kLog2:
      MapDouble<std::log2>(x[0], n, r);
      return true;
    case Op::kSin:
      MapDouble<std::sin>(x[0], n, r);
      return true;
    case Op::kCos:
      MapDouble<std::cos>(x[0], n, r);
      return true;
    case Op::kTan:
      MapDouble<std::tan>(x[0], n, r);
      return true;
    case Op::kAsin:
      MapDouble<std::asin>(x[0], n, r);
      return true;
    case Op::kAcos:
      MapDouble<std::acos>(x[0], n, r);
      return true;
    case Op::kAtan:
      MapDouble<std::atan>(x[0], n, r);
      return true;
    case Op::kAtan2:
      Map<float>(x[0], x[1], n, r, Atan2);
      return true;
    case Op::kSinh:
      MapDouble<std::sinh>(x[0], n, r);
      return true;
    case Op::kCosh:
      MapDouble<std::cosh>(x[0], n, r);
      return true;
    case Op::kTanh:
      MapDouble<std::tanh>(x[0], n, r);
      return true;
    case Op::kAsinh:
      MapDouble<std::asinh>(x[0], n, r);
      return true;
    case Op::kAcosh:
      MapDouble<std::acosh>(x[0], n, r);
      return true;
    case Op::kAtanh:
      MapDouble<std::atanh>(x[0], n, r);
      return true;
    default:
      return false;
  }
}

}  // namespace texgraph::ir::families
