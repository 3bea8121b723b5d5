// SPDX-License-Identifier: Apache-2.0
// Random modules on the CPU and the GPU: plain and simplified, in both dialects. Where all
// operations are of the exact class, the two agree to the bit. TEXGRAPH_FUZZ_SEEDS=1000 runs
// longer.
#include <gtest/gtest.h>

#include <cstdlib>

#include "compiler/ir/print.h"
#include "compiler/ir/verify.h"
#include "compiler/passes/simplify.h"
#include "tests/fuzz/random_module.h"
#include "tests/render/render_check.h"

namespace texgraph::test {
namespace {

constexpr uint32_t kModules = 12;  // for each kind

uint32_t Seeds() {
  const char* text = std::getenv("TEXGRAPH_FUZZ_SEEDS");
  return text ? static_cast<uint32_t>(std::strtoul(text, nullptr, 10)) : kModules;
}

// A framebuffer of floats holds floats only: main's other results are converted.
void MakeResultsFloats(ir::Module& module) {
  ir::Function& main = module[module.main];
  ir::Region& body = main.regions[main.body.index];
  for (size_t i = 0; i < main.results.size(); ++i) {
    const ir::TypeId type = main.results[i].type;
    if (ir::IsFloat(type)) continue;
    ir::Inst convert;
    convert.op = ir::Op::kConvert;
    convert.operand_count = 1;
    convert.type = ir::Vector(ir::Scalar::kFloat, ir::Width(type));
    convert.first_operand = static_cast<uint32_t>(main.operands.size());
    main.operands.push_back(body.results[i]);
    const ir::ValueId value(main.insts.size());
    main.insts.push_back(convert);
    body.body.push_back(value);
    body.results[i] = value;
    main.results[i].type = convert.type;
  }
}

std::shared_ptr<const textures::TextureData> SomeTexture(bool is_array) {
  textures::TextureOptions options;
  options.as_float = true;
  options.is_array = is_array;
  std::vector<textures::Image> layers(is_array ? 3 : 1);
  for (size_t i = 0; i < layers.size(); ++i) {
    layers[i].width = 8;
    layers[i].height = 16;
    layers[i].channels = 4;
    for (uint32_t k = 0; k < 8 * 16 * 4; ++k) {
      layers[i].pixels.push_back(static_cast<uint8_t>((k * 37 + i * 101) % 251));
    }
  }
  Diagnostics diagnostics;
  return std::make_shared<textures::TextureData>(
      *MakeTexture(layers, options, "t", {}, diagnostics));
}

CheckOptions OptionsFor(const ir::Module& module, uint32_t seed,
                        const fuzz::RandomModuleOptions& random) {
  CheckOptions options;
  options.width = options.height = 32;
  options.window = {-3.1, -2.7, 3.3, 2.9};
  options.dialect = seed % 2 == 0 ? glsl::Dialect::k330 : glsl::Dialect::k450;
  const ir::EvaluateInputs inputs = fuzz::RandomInputs(module, seed, 4, random.tame);
  for (size_t i = 0; i < module.globals.size(); ++i) {
    const ir::Global& global = module.globals[i];
    if (global.kind == ir::GlobalKind::kUniform) options.uniforms[global.name] = inputs.globals[i];
    if (global.kind == ir::GlobalKind::kTexture) {
      options.textures[global.name] = SomeTexture(global.type == ir::kSampler2DArray);
    }
  }
  return options;
}

struct Kind {
  const char* name;
  fuzz::RandomModuleOptions options;
  bool simplify;
};

class RandomModules : public testing::TestWithParam<Kind> {};

TEST_P(RandomModules, CpuAndGpuAgreeToTheBit) {
  const Kind& kind = GetParam();
  std::vector<ir::Module> modules;
  std::vector<CheckCase> cases;
  modules.reserve(Seeds());
  for (uint32_t seed = 1; seed <= Seeds(); ++seed) {
    ir::Module& module = modules.emplace_back(fuzz::RandomModule(seed, kind.options));
    MakeResultsFloats(module);
    ASSERT_EQ(ir::Verify(module), "") << seed;
    const CheckOptions options = OptionsFor(module, seed, kind.options);
    if (kind.simplify) passes::Simplify(module);
    cases.push_back({&module, options});
  }
  const std::vector<CheckReport> reports = CompareCpuAndGpu(cases);
  for (size_t i = 0; i < reports.size(); ++i) {
    ASSERT_EQ(reports[i].error, "") << "seed " << i + 1;
    EXPECT_EQ(reports[i].max_ulp(), 0u) << "seed " << i + 1 << "\n"
                                        << reports[i].Text() << reports[i].glsl;
  }
}

fuzz::RandomModuleOptions Tame() { return {}; }
fuzz::RandomModuleOptions Small() {
  fuzz::RandomModuleOptions options;
  options.functions = 1;
  options.values = 10;
  return options;
}

INSTANTIATE_TEST_SUITE_P(Kinds, RandomModules,
                         testing::Values(Kind{"Plain", Tame(), false},
                                         Kind{"Simplified", Tame(), true},
                                         Kind{"SmallPlain", Small(), false},
                                         Kind{"SmallSimplified", Small(), true}),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace texgraph::test
