// SPDX-License-Identifier: Apache-2.0
// The derivatives that Differentiate makes, against central differences of the undifferentiated
// value.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <random>

#include "compiler/ir/builder.h"
#include "compiler/ir/evaluate.h"
#include "compiler/ir/print.h"
#include "compiler/ir/verify.h"
#include "compiler/passes/passes.h"

namespace texgraph::passes {
namespace {

using ir::Op;
using ir::ValueId;

// A value made from the coordinate uv.
using Make = std::function<ValueId(ir::Builder&, ValueId uv)>;

ir::Module ModuleOf(const Make& make, bool differentiated) {
  ir::Module module;
  ir::GlobalId uv = module.AddGlobal({ir::GlobalKind::kInput, "uv", ir::kVec2, {}, true});
  ir::Function main;
  main.name = main.display_name = "main";
  ir::Builder builder(module, main);
  ValueId value = make(builder, builder.Global(uv));
  if (differentiated) {
    ValueId dx = builder.Op1(Op::kDx, value), dy = builder.Op1(Op::kDy, value);
    builder.Return({{dx, dy}});
    main.results[0].name = "dx";
    main.results[1].name = "dy";
  } else {
    builder.Return({{value}});
    main.results[0].name = "value";
  }
  module.functions.push_back(std::move(main));
  module.main = ir::FunctionId(module.functions.size() - 1);
  if (differentiated) Differentiate(module, true);
  EXPECT_EQ(ir::Verify(module), "") << ir::Print(module);
  return module;
}

// Results of main, component c of result r at lane 0, with uv at (u, v) and its quad neighbours
// `step` away.
std::vector<std::vector<float>> RunAt(const ir::Module& module, float u, float v, float step) {
  ir::EvaluateInputs inputs;
  inputs.lanes = 4;
  inputs.globals.resize(module.globals.size());
  inputs.textures.resize(module.globals.size());
  for (size_t g = 0; g < module.globals.size(); ++g) {
    if (module.globals[g].name != "uv") continue;
    for (float word : {u, u + step, u, u + step, v, v, v + step, v + step}) {
      inputs.globals[g].push_back(std::bit_cast<uint32_t>(word));
    }
  }
  std::vector<std::vector<float>> values;
  for (const std::vector<uint32_t>& words : ir::Evaluate(module, module.main, inputs)) {
    values.emplace_back();
    for (size_t w = 0; w < words.size(); w += 4)
      values.back().push_back(std::bit_cast<float>(words[w]));
  }
  return values;
}

// Compares both derivatives of every component at random places.
void ExpectDerivative(const Make& make, float low = -2.0f, float high = 2.0f,
                      double tolerance = 0.01) {
  ir::Module plain = ModuleOf(make, false);
  ir::Module derived = ModuleOf(make, true);
  std::mt19937 random(7);
  const float step = 1.0f / 4096, h = 1.0f / 256;
  for (int i = 0; i < 50; ++i) {
    float u = low + (high - low) * static_cast<float>(random() % 4096) / 4096;
    float v = low + (high - low) * static_cast<float>(random() % 4096) / 4096;
    std::vector<std::vector<float>> found = RunAt(derived, u, v, step);
    for (int axis : {0, 1}) {
      float du = axis ? 0 : h, dv = axis ? h : 0;
      std::vector<float> ahead = RunAt(plain, u + du, v + dv, step)[0];
      std::vector<float> behind = RunAt(plain, u - du, v - dv, step)[0];
      for (size_t c = 0; c < ahead.size(); ++c) {
        double expected = (double(ahead[c]) - behind[c]) / (2.0 * h);
        double actual = found[axis][c] / step;
        EXPECT_NEAR(actual, expected, tolerance * (1 + std::abs(expected)))
            << "at " << u << ", " << v << ", axis " << axis << ", component " << c << "\n"
            << ir::Print(derived);
      }
    }
    if (testing::Test::HasFailure()) return;
  }
}

ValueId X(ir::Builder& b, ValueId uv) { return b.Extract(uv, 0); }
ValueId Y(ir::Builder& b, ValueId uv) { return b.Extract(uv, 1); }

TEST(DifferentiateTest, ArithmeticFollowsTheChainRule) {
  ExpectDerivative(
      [](ir::Builder& b, ValueId uv) { return b.Op2(Op::kAdd, b.Op2(Op::kMul, uv, uv), uv); });
  ExpectDerivative([](ir::Builder& b, ValueId uv) {
    return b.Op2(Op::kSub, b.Op1(Op::kNeg, X(b, uv)), Y(b, uv));
  });
  ExpectDerivative([](ir::Builder& b, ValueId uv) { return b.Op2(Op::kDiv, X(b, uv), Y(b, uv)); },
                   0.5f, 2.0f);
  ExpectDerivative([](ir::Builder& b, ValueId uv) {
    return b.Op3(Op::kMix, X(b, uv), b.Float(3), b.Op2(Op::kMul, X(b, uv), Y(b, uv)));
  });
}

// 6 t^5 - 15 t^4 + 10 t^3, with t = 0.7 uv + 0.2.
ValueId Fade(ir::Builder& b, ValueId uv) {
  ValueId t =
      b.Op2(Op::kAdd, b.Op2(Op::kMul, uv, b.Splat(ir::kVec2, 0.7)), b.Splat(ir::kVec2, 0.2));
  ValueId inner =
      b.Op2(Op::kSub, b.Op2(Op::kMul, t, b.Splat(ir::kVec2, 6)), b.Splat(ir::kVec2, 15));
  ValueId factor = b.Op2(Op::kAdd, b.Op2(Op::kMul, t, inner), b.Splat(ir::kVec2, 10));
  return b.Op2(Op::kMul, b.Op2(Op::kMul, b.Op2(Op::kMul, t, t), t), factor);
}

// Between the corners of a cell: bilinear in the fades.
ValueId Surface(ir::Builder& b, ValueId fade) {
  ValueId low = b.Op3(Op::kMix, b.Float(0.3f), b.Float(0.9f), X(b, fade));
  ValueId high = b.Op3(Op::kMix, b.Float(0.5f), b.Float(-0.2f), X(b, fade));
  return b.Op3(Op::kMix, low, high, Y(b, fade));
}

TEST(DifferentiateTest, PolynomialsFollowTheChainRule) {
  ExpectDerivative(Fade, -0.5f, 1.5f);
  ExpectDerivative([](ir::Builder& b, ValueId uv) { return Surface(b, Fade(b, uv)); }, -0.5f, 1.5f);
  ExpectDerivative([](ir::Builder& b, ValueId uv) {
    ValueId square = b.Op2(Op::kMul, X(b, uv), X(b, uv));
    return b.Op3(Op::kFma, square, Y(b, uv), b.Op1(Op::kNeg, b.Op2(Op::kSub, square, Y(b, uv))));
  });
}

// The slope of the polynomial is made once; it is multiplied with the change in x and with that in
// y.
TEST(DifferentiateTest, AxesShareTheSlopeOfAPolynomial) {
  ir::Module module = ModuleOf(Fade, true);
  Simplify(module);
  const ir::Function& main = module[module.main];
  auto counts = [&](Op op) {
    return std::ranges::count_if(main.insts, [&](const ir::Inst& inst) { return inst.op == op; });
  };
  // 0.7 dx and 0.7 dy, six products of the polynomial and its slope, the products with both
  // changes.
  EXPECT_LE(counts(Op::kMul), 2 + 1 + 7 + 2) << ir::Print(module);
}

TEST(DifferentiateTest, SlopesGoIntoBranchesAndLoops) {
  ExpectDerivative(
      [](ir::Builder& b, ValueId uv) {
        ValueId fade = Fade(b, uv), other = b.Op2(Op::kMul, fade, fade);
        ir::RegionId then_region = b.BeginRegion();
        ValueId inside = b.Op2(Op::kMul, X(b, fade), X(b, other));
        b.EndRegion({{inside}});
        ir::RegionId else_region = b.BeginRegion();
        b.EndRegion({{b.Op2(Op::kMul, Y(b, other), Y(b, other))}});
        ValueId branch = b.If(b.Op2(Op::kLt, X(b, uv), b.Float(5)), then_region, else_region);
        ir::ForLoop loop{0, 3, 1, b.BeginRegion()};
        b.AddRegionParameter(ir::kInt);
        ValueId sum = b.AddRegionParameter(ir::kFloat);
        b.EndRegion({{b.Op2(Op::kAdd, b.Op2(Op::kMul, sum, sum), X(b, other))}});
        ValueId looped = b.For(loop, {{branch}});
        return b.Op2(Op::kAdd, b.Op2(Op::kMul, looped, Y(b, fade)), Y(b, other));
      },
      0.1f, 0.9f);
}

TEST(DifferentiateTest, FunctionsOfOneValue) {
  for (Op op : {Op::kSin, Op::kCos, Op::kTan, Op::kSinh, Op::kCosh, Op::kTanh, Op::kAsinh, Op::kExp,
                Op::kExp2, Op::kAtan}) {
    SCOPED_TRACE(ir::Info(op).name);
    ExpectDerivative(
        [op](ir::Builder& b, ValueId uv) { return b.Op1(op, b.Op2(Op::kMul, uv, b.Float(0.6f))); });
  }
  for (Op op : {Op::kAsin, Op::kAcos, Op::kAtanh}) {
    SCOPED_TRACE(ir::Info(op).name);
    ExpectDerivative(
        [op](ir::Builder& b, ValueId uv) { return b.Op1(op, b.Op2(Op::kMul, uv, b.Float(0.4f))); });
  }
  for (Op op : {Op::kSqrt, Op::kInverseSqrt, Op::kLog, Op::kLog2}) {
    SCOPED_TRACE(ir::Info(op).name);
    ExpectDerivative([op](ir::Builder& b, ValueId uv) { return b.Op1(op, uv); }, 0.5f, 3.0f);
  }
  ExpectDerivative([](ir::Builder& b, ValueId uv) { return b.Op1(Op::kAcosh, uv); }, 1.5f, 3.0f);
}

TEST(DifferentiateTest, FunctionsOfTwoValues) {
  ExpectDerivative([](ir::Builder& b, ValueId uv) { return b.Op2(Op::kPow, X(b, uv), Y(b, uv)); },
                   0.5f, 2.0f);
  ExpectDerivative([](ir::Builder& b, ValueId uv) { return b.Op2(Op::kAtan2, Y(b, uv), X(b, uv)); },
                   0.5f, 2.0f);
  ExpectDerivative([](ir::Builder& b, ValueId uv) {
    return b.Op3(Op::kFma, X(b, uv), Y(b, uv), b.Op1(Op::kSin, X(b, uv)));
  });
  ExpectDerivative([](ir::Builder& b, ValueId uv) {
    return b.Op3(Op::kSmoothstep, b.Op2(Op::kSub, Y(b, uv), b.Float(1.5f)),
                 b.Op2(Op::kAdd, Y(b, uv), b.Float(2)), X(b, uv));
  });
}

TEST(DifferentiateTest, VectorsAndMatrices) {
  auto vector = [](ir::Builder& b, ValueId uv) {
    ValueId parts[] = {X(b, uv), b.Op2(Op::kMul, X(b, uv), Y(b, uv)),
                       b.Op2(Op::kAdd, Y(b, uv), b.Float(5))};
    return b.Construct(ir::kVec3, parts);
  };
  const uint8_t zyx[] = {2, 1, 0};
  ExpectDerivative([&](ir::Builder& b, ValueId uv) { return b.Op1(Op::kLength, vector(b, uv)); });
  ExpectDerivative(
      [&](ir::Builder& b, ValueId uv) { return b.Op1(Op::kNormalize, vector(b, uv)); });
  ExpectDerivative([&](ir::Builder& b, ValueId uv) {
    return b.Op2(Op::kDot, vector(b, uv), b.Swizzle(vector(b, uv), zyx));
  });
  ExpectDerivative([&](ir::Builder& b, ValueId uv) {
    return b.Op2(Op::kCross, vector(b, uv), b.Swizzle(vector(b, uv), zyx));
  });
  ExpectDerivative([&](ir::Builder& b, ValueId uv) {
    return b.Op2(Op::kDistance, vector(b, uv), b.Splat(ir::kVec3, -2));
  });
  ExpectDerivative([&](ir::Builder& b, ValueId uv) {
    return b.Op2(Op::kReflect, vector(b, uv), b.Op1(Op::kNormalize, b.Swizzle(vector(b, uv), zyx)));
  });
  ExpectDerivative([&](ir::Builder& b, ValueId uv) {
    ValueId columns[] = {uv, b.Op2(Op::kMul, uv, b.Float(0.5f))};
    ValueId matrix = b.Construct(ir::kMat2, columns);
    return b.Op2(Op::kMatMul, b.Op1(Op::kTranspose, matrix), uv);
  });
}

TEST(DifferentiateTest, JumpsHaveTheDerivativeBetweenThem) {
  // Away from the jumps, which central differences do not see either.
  auto scaled = [](ir::Builder& b, ValueId uv) { return b.Op2(Op::kMul, uv, b.Float(0.9f)); };
  for (Op op : {Op::kFloor, Op::kCeil, Op::kTrunc, Op::kRound, Op::kSign, Op::kFract}) {
    SCOPED_TRACE(ir::Info(op).name);
    ExpectDerivative([&](ir::Builder& b, ValueId uv) { return b.Op1(op, scaled(b, uv)); }, 0.15f,
                     0.45f);
  }
  ExpectDerivative(
      [](ir::Builder& b, ValueId uv) { return b.Op2(Op::kFmod, X(b, uv), b.Float(5)); }, 0.1f,
      2.0f);
  ExpectDerivative([](ir::Builder& b, ValueId uv) { return b.Op2(Op::kFmod, X(b, uv), Y(b, uv)); },
                   3.1f, 3.9f, 2.0);
  ExpectDerivative(
      [](ir::Builder& b, ValueId uv) { return b.Op2(Op::kMin, X(b, uv), b.Float(7)); });
  ExpectDerivative(
      [](ir::Builder& b, ValueId uv) { return b.Op2(Op::kMax, Y(b, uv), b.Float(7)); });
  ExpectDerivative(
      [](ir::Builder& b, ValueId uv) { return b.Op3(Op::kClamp, uv, b.Float(-9), b.Float(9)); });
  // It is the upper limit where the lower one is above it.
  ExpectDerivative([](ir::Builder& b, ValueId uv) {
    ValueId high = b.Op2(Op::kSub, b.Op2(Op::kMul, Y(b, uv), b.Float(2)), b.Float(9));
    return b.Op3(Op::kClamp, X(b, uv), Y(b, uv), high);
  });
  ExpectDerivative(
      [](ir::Builder& b, ValueId uv) { return b.Op1(Op::kAbs, b.Op2(Op::kSub, uv, b.Float(4))); });
}

TEST(DifferentiateTest, BranchesFollowTheSideThatIsTaken) {
  ExpectDerivative(
      [](ir::Builder& b, ValueId uv) {
        ir::RegionId then_region = b.BeginRegion();
        ValueId on_true[] = {b.Op1(Op::kSin, X(b, uv)), Y(b, uv)};
        b.EndRegion(on_true);
        ir::RegionId else_region = b.BeginRegion();
        ValueId on_false[] = {b.Op1(Op::kExp, X(b, uv)), b.Op2(Op::kMul, Y(b, uv), Y(b, uv))};
        b.EndRegion(on_false);
        ValueId branch = b.If(b.Op2(Op::kLt, X(b, uv), b.Float(0.5f)), then_region, else_region);
        return b.Op2(Op::kMul, b.Result(branch, 0, 2), b.Result(branch, 1, 2));
      },
      0.6f, 2.0f);
}

TEST(DifferentiateTest, LoopsCarryDerivatives) {
  ExpectDerivative([](ir::Builder& b, ValueId uv) {
    ir::ForLoop loop{0, 5, 1, b.BeginRegion()};
    ValueId i = b.AddRegionParameter(ir::kInt);
    ValueId sum = b.AddRegionParameter(ir::kFloat), p = b.AddRegionParameter(ir::kVec2);
    ValueId weight = b.Op2(Op::kAdd, b.Convert(i, ir::kFloat), b.Float(1));
    ValueId next[] = {b.Op2(Op::kAdd, sum, b.Op2(Op::kDiv, b.Op1(Op::kSin, X(b, p)), weight)),
                      b.Op2(Op::kMul, p, b.Float(1.5f))};
    b.EndRegion(next);
    ValueId initial[] = {b.Float(0), uv};
    return b.Result(b.For(loop, initial), 0, 2);
  });
}

// A function f(p) = fract(p) * p.yx, called with a value that jumps.
ir::FunctionId AddCallee(ir::Module& module) {
  ir::Function function;
  function.name = function.display_name = "f";
  {
    ir::Builder b(module, function);
    ValueId p = b.AddParameter({"p", ir::kVec2});
    const uint8_t yx[] = {1, 0};
    b.Return({{b.Op2(Op::kMul, b.Op1(Op::kFract, p), b.Swizzle(p, yx))}});
  }
  module.functions.push_back(std::move(function));
  return ir::FunctionId(module.functions.size() - 1);
}

TEST(DifferentiateTest, CallsReturnDerivativesThatTheCallerNeeds) {
  ExpectDerivative(
      [](ir::Builder& b, ValueId uv) {
        ir::FunctionId callee = AddCallee(b.module());
        ValueId inner = b.Call(callee, {{b.Op2(Op::kMul, uv, b.Float(0.9f))}});
        return b.Call(callee, {{inner}});
      },
      0.15f, 0.9f);
}

TEST(DifferentiateTest, RulesAreFiniteAtSingularPoints) {
  const Op kUnary[] = {Op::kSqrt,  Op::kInverseSqrt, Op::kLog, Op::kLog2, Op::kAsin,     Op::kAcos,
                       Op::kAcosh, Op::kAtanh,       Op::kAbs, Op::kSign, Op::kNormalize};
  for (Op op : kUnary) {
    SCOPED_TRACE(ir::Info(op).name);
    ir::Module module = ModuleOf([op](ir::Builder& b, ValueId uv) { return b.Op1(op, uv); }, true);
    for (float at : {0.0f, 1.0f, -1.0f, -0.0f}) {
      for (const std::vector<float>& result : RunAt(module, at, at, 0.001f)) {
        for (float value : result) EXPECT_TRUE(std::isfinite(value)) << at;
      }
    }
  }
  for (Op op : {Op::kDiv, Op::kPow, Op::kAtan2, Op::kFmod}) {
    SCOPED_TRACE(ir::Info(op).name);
    ir::Module module =
        ModuleOf([op](ir::Builder& b, ValueId uv) { return b.Op2(op, X(b, uv), Y(b, uv)); }, true);
    for (const std::vector<float>& result : RunAt(module, 0, 0, 0.001f)) {
      for (float value : result) EXPECT_TRUE(std::isfinite(value));
    }
  }
}

// --- Which samples get what
// --------------------------------------------------------------------------------------

// The operations of all functions, by name, in order.
std::vector<std::string> SamplesOf(const Make& coordinate, bool smooth = true) {
  ir::Module module;
  ir::GlobalId uv = module.AddGlobal({ir::GlobalKind::kInput, "uv", ir::kVec2, {}, true});
  module.AddGlobal({ir::GlobalKind::kTexture, "picture", ir::kSampler2D, {}, smooth});
  ir::Function main;
  main.name = main.display_name = "main";
  ir::Builder b(module, main);
  ValueId p = coordinate(b, b.Global(uv));
  ValueId color = b.Emit(Op::kSample, ir::kVec4, {b.Global(ir::GlobalId(1)), p});
  b.Return({{color}});
  main.results[0].name = "color";
  module.functions.push_back(std::move(main));
  module.main = ir::FunctionId(module.functions.size() - 1);
  Differentiate(module, true);
  EXPECT_EQ(ir::Verify(module), "");
  std::vector<std::string> names;
  for (const ir::Function& function : module.functions) {
    for (const ir::Inst& inst : function.insts) {
      if (Info(inst.op).shape == ir::OpShape::kSampling) names.emplace_back(Info(inst.op).name);
    }
  }
  return names;
}

using testing::ElementsAre;

TEST(DifferentiateTest, PlainCoordinatesKeepTheImplicitSample) {
  EXPECT_THAT(SamplesOf([](ir::Builder&, ValueId uv) { return uv; }), ElementsAre("sample"));
  EXPECT_THAT(SamplesOf([](ir::Builder& b, ValueId uv) {
                return b.Op1(Op::kSin, b.Op2(Op::kMul, uv, b.Float(3)));
              }),
              ElementsAre("sample"));
  EXPECT_THAT(SamplesOf([](ir::Builder& b, ValueId) { return b.Splat(ir::kVec2, 0.5); }),
              ElementsAre("sample"));
}

TEST(DifferentiateTest, RoughCoordinatesGetGradients) {
  EXPECT_THAT(SamplesOf([](ir::Builder& b, ValueId uv) { return b.Op1(Op::kFract, uv); }),
              ElementsAre("sample_grad"));
  EXPECT_THAT(SamplesOf([](ir::Builder& b, ValueId uv) {
                return b.Op2(Op::kAdd, uv, b.Op1(Op::kFloor, uv));
              }),
              ElementsAre("sample_grad"));
  EXPECT_THAT(SamplesOf([](ir::Builder& b, ValueId uv) {
                ValueId angle = b.Op2(Op::kAtan2, Y(b, uv), X(b, uv));
                return b.SplatTo(angle, ir::kVec2);
              }),
              ElementsAre("sample_grad"));
}

TEST(DifferentiateTest, SteppedCoordinatesHaveNoFootprint) {
  EXPECT_THAT(SamplesOf([](ir::Builder& b, ValueId uv) { return b.Op1(Op::kFloor, uv); }),
              ElementsAre("sample_lod"));
}

// A layer has no footprint: only the place in it has.
TEST(DifferentiateTest, LayersMayJump) {
  auto samples = [](bool jumps) {
    ir::Module module;
    module.AddGlobal({ir::GlobalKind::kInput, "uv", ir::kVec2, {}});
    module.AddGlobal({ir::GlobalKind::kTexture, "patterns", ir::kSampler2DArray, {}});
    ir::Function main;
    main.name = "main";
    main.results = {{"color", ir::kVec4}};
    {
      ir::Builder b(module, main, {true, nullptr});
      ValueId uv = b.Global(ir::GlobalId(0));
      ValueId layer = b.Op1(Op::kFloor, X(b, uv));
      ValueId place = jumps ? b.Op1(Op::kFract, uv) : uv;
      ValueId at = b.Construct(ir::kVec3, {{place, layer}});
      b.Return({{b.Emit(Op::kSample, ir::kVec4, {b.Global(ir::GlobalId(1)), at})}});
    }
    module.functions.push_back(std::move(main));
    module.main = ir::FunctionId(0);
    Differentiate(module, true);
    EXPECT_EQ(ir::Verify(module), "");
    const std::string text = ir::Print(module);
    return std::pair(text.find("sample @") != text.npos, text.find("sample_grad") != text.npos);
  };
  EXPECT_EQ(samples(false), std::pair(true, false));
  EXPECT_EQ(samples(true), std::pair(false, true));
}

Make WarpedBy(Op jump) {
  return [jump](ir::Builder& b, ValueId uv) {
    ValueId p = jump == Op::kConst ? uv : b.Op1(jump, uv);
    ValueId color = b.Emit(Op::kSample, ir::kVec4, {b.Global(ir::GlobalId(1)), p});
    const uint8_t xy[] = {0, 1};
    return b.Op2(Op::kAdd, p, b.Swizzle(color, xy));
  };
}

TEST(DifferentiateTest, WarpingBySmoothPicturesIsPlainInPlainPlaces) {
  EXPECT_THAT(SamplesOf(WarpedBy(Op::kConst)), ElementsAre("sample", "sample"));
}

TEST(DifferentiateTest, WarpingElsewhereTakesDifferencesOfSamples) {
  // The warping sample, its two neighbours, and the warped one.
  EXPECT_THAT(SamplesOf(WarpedBy(Op::kFract)),
              ElementsAre("sample_grad", "sample_grad", "sample_grad", "sample_grad"));
  EXPECT_THAT(SamplesOf(WarpedBy(Op::kConst), false),
              ElementsAre("sample", "sample_grad", "sample_grad", "sample_grad"));
}

TEST(DifferentiateTest, LoopsAndVaryingBranchesGetGradients) {
  auto in_branch = [](bool varying) {
    return [varying](ir::Builder& b, ValueId uv) {
      ValueId condition = varying ? b.Op2(Op::kLt, X(b, uv), b.Float(0.5f))
                                  : b.Op2(Op::kLt, b.Float(1), b.Float(0.5f));
      ir::RegionId then_region = b.BeginRegion();
      ValueId color = b.Emit(Op::kSample, ir::kVec4, {b.Global(ir::GlobalId(1)), uv});
      b.EndRegion({{X(b, color)}});
      ir::RegionId else_region = b.BeginRegion();
      b.EndRegion({{b.Float(0)}});
      ValueId chosen = b.If(condition, then_region, else_region);
      return b.Op2(Op::kMul, uv, b.Op2(Op::kMin, b.Op1(Op::kFloor, chosen), b.Float(1)));
    };
  };
  EXPECT_EQ(SamplesOf(in_branch(true))[0], "sample_grad");
  EXPECT_EQ(SamplesOf([](ir::Builder& b, ValueId uv) {
              ir::ForLoop loop{0, 3, 1, b.BeginRegion()};
              b.AddRegionParameter(ir::kInt);
              ValueId sum = b.AddRegionParameter(ir::kFloat);
              ValueId color = b.Emit(Op::kSample, ir::kVec4, {b.Global(ir::GlobalId(1)), uv});
              b.EndRegion({{b.Op2(Op::kAdd, sum, X(b, color))}});
              ValueId total = b.For(loop, {{b.Float(0)}});
              return b.Op2(Op::kMul, uv, b.Op1(Op::kFloor, total));
            })[0],
            "sample_grad");
}

}  // namespace
}  // namespace texgraph::passes
