// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/rounding_noise.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace texgraph::fuzz {
namespace {

using ir::Op;

constexpr int kRuns = 4;
constexpr double kSafety = 8;     // four runs do not see the worst
constexpr double kAlways = 1e-6;  // relative to the larger of the result and 1
constexpr float kHuge = 1e30f;    // near enough to infinity
constexpr float kTinyNormal = std::numeric_limits<float>::min();

// Operations whose float results are rounded. The others choose, move or give whole numbers.
bool IsRounded(Op op) {
  switch (op) {
    case Op::kAdd:
    case Op::kSub:
    case Op::kMul:
    case Op::kDiv:
    case Op::kFmod:
    case Op::kFract:
    case Op::kMix:
    case Op::kSmoothstep:
    case Op::kSqrt:
    case Op::kInverseSqrt:
      return true;
    default:
      return ir::Info(op).ulp > 0;
  }
}

// The size of what is rounded on the way to a result, which may be much smaller: of a term of a sum
// that cancels. For component `c`.
double SizeOfTerms(const ir::Types& types, const ir::Function& function, const ir::Inst& inst,
                   std::span<const uint32_t* const> operands, size_t lanes, size_t lane, size_t c) {
  const auto operand = [&](size_t i, size_t component) {
    return std::fabs(double{std::bit_cast<float>(operands[i][component * lanes + lane])});
  };
  const auto largest = [&](size_t i) {
    double most = 0;
    for (uint32_t w = 0; w < types.Words(function[function.Operands(inst)[i]].type); ++w) {
      most = std::max(most, operand(i, w));
    }
    return most;
  };
  const double t = inst.op == Op::kMix ? operand(2, c) : 0;
  switch (inst.op) {
    case Op::kMix:
      return std::max(operand(0, c) * (1 + t), operand(1, c) * t);
    case Op::kFma:
      return std::max(operand(0, c) * operand(1, c), operand(2, c));
    case Op::kFmod:
      return operand(0, c);
    case Op::kDistance:
      return std::max(largest(0), largest(1));
    case Op::kDot:
    case Op::kCross:
    case Op::kMatMul:
      return 4 * largest(0) * largest(1);
    case Op::kReflect:
      return 4 * largest(0) * std::max(1.0, largest(1) * largest(1));
    default:
      return 0;
  }
}

bool IsSample(Op op) {
  return op == Op::kSample || op == Op::kSampleGrad || op == Op::kSampleLod || op == Op::kFetch;
}

class Watcher : public ir::EvaluateObserver {
 public:
  Watcher(const ir::Module& module, uint32_t lanes) : undefined(lanes), types_(module.types) {}

  void OnValue(const ir::Function& function, ir::ValueId v,
               std::span<const uint32_t* const> operands, uint32_t first_lane, uint32_t lanes,
               uint64_t active, uint32_t* words) override {
    const ir::Inst& inst = function[v];
    for (uint32_t lane = 0; lane < lanes && first_lane + lane < undefined.size(); ++lane) {
      if ((active >> lane & 1) == 0) continue;
      if (IsUndefined(function, inst, operands, lanes, lane, words)) {
        undefined[first_lane + lane] = true;
      }
    }
  }

  std::vector<bool> undefined;

 private:
  bool IsUndefined(const ir::Function& function, const ir::Inst& inst,
                   std::span<const uint32_t* const> operands, uint32_t lanes, uint32_t lane,
                   const uint32_t* words) const {
    if (ir::IsFloat(inst.type)) {
      for (uint32_t word = 0; word < types_.Words(inst.type); ++word) {
        const float value = std::bit_cast<float>(words[size_t{word} * lanes + lane]);
        const bool fine =
            std::fabs(value) < kHuge && (value == 0 || std::fabs(value) >= kTinyNormal);
        if (!fine) return true;
      }
      return false;
    }
    if (!ir::IsVector(inst.type) || !ir::IsInteger(inst.type)) return false;
    const ir::Scalar scalar = ir::ScalarOf(inst.type);
    for (uint32_t c = 0; c < ir::Width(inst.type); ++c) {
      const auto operand = [&](size_t i) { return operands[i][size_t{c} * lanes + lane]; };
      if (inst.op == Op::kDiv || inst.op == Op::kMod) {
        const auto a = static_cast<int32_t>(operand(0)), b = static_cast<int32_t>(operand(1));
        const bool is_signed = scalar == ir::Scalar::kInt;
        if (b == 0 || (is_signed && b == -1 && a == std::numeric_limits<int32_t>::min()))
          return true;
        if (is_signed && inst.op == Op::kMod && (a < 0 || b < 0)) return true;
      } else if (inst.op == Op::kShl || inst.op == Op::kShr) {
        if (operand(1) >= 32) return true;
      } else if (inst.op == Op::kConvert) {
        const ir::TypeId from = function[function.Operands(inst)[0]].type;
        if (!ir::IsFloat(from)) continue;
        const float value = std::bit_cast<float>(operand(0));
        const float low = scalar == ir::Scalar::kInt ? -0x1p31f : 0.0f;
        const float high = scalar == ir::Scalar::kInt ? 0x1p31f : 0x1p32f;
        if (!(std::trunc(value) >= low && value < high)) return true;
      }
    }
    return false;
  }

  const ir::Types& types_;
};

class Noise : public ir::EvaluateObserver {
 public:
  Noise(const ir::Module& module, const NoiseOptions& options, int run)
      : types_(module.types),
        options_(options),
        run_(run),
        state_(0x9e3779b97f4a7c15u * (run + 1)) {}

  void OnValue(const ir::Function& function, ir::ValueId v,
               std::span<const uint32_t* const> operands, uint32_t, uint32_t lanes, uint64_t,
               uint32_t* words) override {
    const ir::Inst& inst = function[v];
    if (!ir::IsFloat(inst.type)) return;
    const bool sample = IsSample(inst.op);
    if (sample ? options_.texels == 0 : !IsRounded(inst.op)) return;
    const double bound = std::max<double>(ir::Info(inst.op).ulp, 1) * options_.roundings * 0x1p-24;
    const size_t count = size_t{types_.Words(inst.type)} * lanes;
    for (size_t i = 0; i < count; ++i) {
      const double value = std::bit_cast<float>(words[i]);
      double size = std::fabs(value);
      if (!sample) {
        size = std::max(size,
                        SizeOfTerms(types_, function, inst, operands, lanes, i % lanes, i / lanes));
      }
      // The bounds of ops.def are of 1 where the result is smaller, for what is not exact.
      if (ir::Info(inst.op).ulp > 0) size = std::max(size, 1.0);
      const double step = sample ? options_.texels : bound * size;
      words[i] = std::bit_cast<uint32_t>(static_cast<float>(value + step * Next()));
    }
  }

 private:
  // All up, all down, then at random one or the other, then anything between.
  double Next() {
    if (run_ == 0) return 1;
    if (run_ == 1) return -1;
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    const auto bits = static_cast<uint32_t>(state_ >> 33);
    if (run_ == 2) return (bits & 0x10000) != 0 ? 1 : -1;
    return static_cast<double>(bits) * 0x1p-30 - 1;
  }

  const ir::Types& types_;
  const NoiseOptions& options_;
  int run_;
  uint64_t state_;
};

}  // namespace

NoisyResults EvaluateWithNoise(const ir::Module& module, ir::EvaluateInputs inputs,
                               const NoiseOptions& options) {
  NoisyResults results;
  Watcher watcher(module, inputs.lanes);
  inputs.observer = &watcher;
  results.words = ir::Evaluate(module, module.main, inputs);
  results.undefined = std::move(watcher.undefined);
  for (const auto& words : results.words) {
    std::vector<double>& slack = results.slack.emplace_back(words.size());
    for (size_t i = 0; i < words.size(); ++i) {
      slack[i] = kAlways * std::max(1.0, std::fabs(double{std::bit_cast<float>(words[i])}));
    }
  }
  for (int run = 0; run < kRuns; ++run) {
    Noise noise(module, options, run);
    inputs.observer = &noise;
    const auto disturbed = ir::Evaluate(module, module.main, inputs);
    for (size_t r = 0; r < disturbed.size(); ++r) {
      for (size_t i = 0; i < disturbed[r].size(); ++i) {
        const double off = std::fabs(double{std::bit_cast<float>(disturbed[r][i])} -
                                     std::bit_cast<float>(results.words[r][i]));
        if (!(kSafety * off <= results.slack[r][i])) results.slack[r][i] = kSafety * off;
      }
    }
  }
  return results;
}

}  // namespace texgraph::fuzz
