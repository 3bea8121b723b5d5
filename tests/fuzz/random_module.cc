// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/random_module.h"

#include <algorithm>
#include <bit>
#include <string>
#include <vector>

#include "tests/fuzz/random_values.h"

namespace texgraph::fuzz {
namespace {

using ir::GlobalKind;
using ir::Op;
using ir::Scalar;
using ir::TypeId;
using ir::ValueId;

class Generator {
 public:
  Generator(uint32_t seed, const RandomModuleOptions& options) : options_(options), random_(seed) {}

  ir::Module Run() {
    AddGlobals();
    for (uint32_t i = 0; i < options_.functions; ++i) AddFunction(i, false);
    AddFunction(0, true);
    module_.main = ir::FunctionId(module_.functions.size() - 1);
    return std::move(module_);
  }

 private:
  uint32_t Below(uint32_t n) { return static_cast<uint32_t>(random_() % n); }

  void AddGlobals() {
    module_.AddGlobal({GlobalKind::kInput, "uv", ir::kVec2, {}});
    module_.AddGlobal({GlobalKind::kInput, "position", ir::kVec3, {}});
    constexpr TypeId kTypes[] = {ir::kFloat, ir::kInt,   ir::kUint,
                                 ir::kVec4,  ir::kIvec2, ir::kFloat};
    for (size_t i = 0; i < std::size(kTypes); ++i) {
      module_.AddGlobal({GlobalKind::kUniform, "u" + std::to_string(i), kTypes[i], {}});
    }
    if (!options_.textures) return;
    module_.AddGlobal({GlobalKind::kTexture, "brick", ir::kSampler2D, {}});
    module_.AddGlobal({GlobalKind::kTexture, "layers", ir::kSampler2DArray, {}});
  }

  void AddFunction(uint32_t number, bool is_main) {
    ir::Function function;
    function.name = is_main ? "main" : "f" + std::to_string(number);
    function.display_name = function.name;
    {
      ir::Builder builder(module_, function, {.fold = false});
      RandomValues values(builder, options_, random_);
      builder_ = &builder;
      values_ = &values;
      if (!is_main) {
        for (uint32_t i = 0, n = 1 + Below(4); i < n; ++i) {
          values.Add(builder.AddParameter({"p" + std::to_string(i), values.AnyType(), false}));
        }
      }
      // Inputs are for main, most of the time.
      for (size_t g = 0; g < module_.globals.size(); ++g) {
        bool is_texture = module_.globals[g].kind == GlobalKind::kTexture;
        if (!is_texture && (is_main || Below(8) == 0)) values.Add(builder.Global(ir::GlobalId(g)));
      }
      Body(options_.values, options_.depth, true);
      std::vector<ValueId> results = is_main ? values.Newest(8) : std::vector<ValueId>();
      while (results.empty() || (!is_main && results.size() < 2 && Below(2) == 0)) {
        results.push_back(values.Pick(is_main ? values.AnyNumericType() : values.AnyType()));
      }
      builder.Return(results);
      for (size_t i = 0; is_main && i < results.size(); ++i) {
        function.results[i].name = "out" + std::to_string(i);
      }
    }
    module_.functions.push_back(std::move(function));
  }

  // Operations into the open region. `uniform`: every pixel comes here.
  void Body(uint32_t count, uint32_t depth, bool uniform) {
    for (uint32_t i = 0; i < count; ++i) {
      uint32_t kind = Below(14);
      if (kind == 0 && depth > 0) {
        If(count / 3 + 1, depth - 1);
      } else if (kind == 1 && depth > 0) {
        For(count / 3 + 1, depth - 1);
      } else if (kind == 2 && !module_.functions.empty()) {
        Call();
      } else if (kind == 3 && uniform && options_.derivatives) {
        values_->Add(
            builder_->Op1(Below(2) ? Op::kDx : Op::kDy, values_->Pick(values_->AnyFloatType())));
      } else {
        values_->AddOperation();
      }
    }
  }

  void AddResults(ValueId whole, const std::vector<TypeId>& types) {
    for (uint32_t i = 0; i < types.size(); ++i) {
      values_->Add(builder_->Result(whole, i, static_cast<uint32_t>(types.size())));
    }
  }

  std::vector<TypeId> SomeTypes() {
    std::vector<TypeId> types;
    for (uint32_t i = 0, n = 1 + Below(3); i < n; ++i) types.push_back(values_->AnyType());
    return types;
  }

  std::vector<ValueId> PickAll(const std::vector<TypeId>& types) {
    std::vector<ValueId> values;
    for (TypeId type : types) values.push_back(values_->Pick(type));
    return values;
  }

  ir::RegionId Side(const std::vector<TypeId>& types, uint32_t count, uint32_t depth) {
    size_t mark = values_->Mark();
    ir::RegionId region = builder_->BeginRegion();
    Body(Below(count + 1), depth, false);
    builder_->EndRegion(PickAll(types));
    values_->Release(mark);
    return region;
  }

  void If(uint32_t count, uint32_t depth) {
    ValueId condition = values_->Pick(ir::kBool);
    std::vector<TypeId> types = SomeTypes();
    ir::RegionId then_region = Side(types, count, depth), else_region = Side(types, count, depth);
    AddResults(builder_->If(condition, then_region, else_region), types);
  }

  void For(uint32_t count, uint32_t depth) {
    std::vector<TypeId> types = SomeTypes();
    std::vector<ValueId> initial = PickAll(types);
    constexpr ir::ForLoop kLoops[] = {
        {0, 4, 1, {}}, {0, 0, 1, {}}, {3, 4, 1, {}}, {5, 0, -2, {}}, {0, 3, 1, {}}};
    ir::ForLoop loop = kLoops[Below(std::size(kLoops))];
    size_t mark = values_->Mark();
    loop.body = builder_->BeginRegion();
    values_->Add(builder_->AddRegionParameter(ir::kInt));
    std::vector<ValueId> carried;
    for (TypeId type : types) {
      carried.push_back(builder_->AddRegionParameter(type));
      values_->Add(carried.back());
    }
    Body(Below(count + 1), depth, false);
    std::vector<ValueId> next = PickAll(types);
    for (size_t i = 0; i < next.size(); ++i) {
      if (Below(6) == 0) next[i] = carried[i];
    }
    builder_->EndRegion(next);
    values_->Release(mark);
    AddResults(builder_->For(loop, initial), types);
  }

  void Call() {
    ir::FunctionId callee(Below(static_cast<uint32_t>(module_.functions.size())));
    std::vector<TypeId> types, results;
    for (const ir::Parameter& parameter : module_[callee].parameters)
      types.push_back(parameter.type);
    for (const ir::Result& result : module_[callee].results) results.push_back(result.type);
    AddResults(builder_->Call(callee, PickAll(types)), results);
  }

  const RandomModuleOptions& options_;
  std::mt19937 random_;
  ir::Module module_;
  ir::Builder* builder_ = nullptr;
  RandomValues* values_ = nullptr;
};

uint32_t RandomWord(TypeId scalar, bool tame, std::mt19937& random) {
  constexpr float kWild[] = {0.0f, -0.0f, 1.0f, -1.0f, 0.5f, 1e-40f, 1e30f, -1e30f};
  const uint32_t any = static_cast<uint32_t>(random());
  if (ir::IsBool(scalar)) return any & 1;
  if (!ir::IsFloat(scalar)) return tame ? any % 1000 : any >> (any % 32);
  if (!tame && any % 4 == 0) return std::bit_cast<uint32_t>(kWild[(any >> 8) % std::size(kWild)]);
  // Multiples of 2^-20 from -4 to 4, zero and small whole numbers more often than by chance.
  float value = static_cast<float>(static_cast<int32_t>(any % (1u << 23)) - (1 << 22)) * 0x1p-20f;
  if (any % 5 == 0) value = static_cast<float>(static_cast<int32_t>((any >> 8) % 9) - 4);
  return std::bit_cast<uint32_t>(value);
}

uint32_t HashName(std::string_view name, uint32_t seed) {
  uint32_t hash = seed * 0x9e3779b9u + 1;
  for (char c : name) hash = (hash ^ static_cast<uint8_t>(c)) * 0x01000193u;
  return hash;
}

uint64_t CostOfRegion(const ir::Module& module, const ir::Function& function, ir::RegionId region,
                      const std::vector<uint64_t>& callees) {
  uint64_t cost = 0;
  for (ValueId v : function.regions[region.index].body) {
    const ir::Inst& inst = function[v];
    cost += uint64_t{ir::Info(inst.op).cost} * (ir::IsVector(inst.type) ? ir::Width(inst.type) : 1);
    if (inst.op == Op::kCall) cost += callees[inst.aux];
    if (inst.op == Op::kIf) {
      const ir::Branch& branch = function.branches[inst.aux];
      cost += CostOfRegion(module, function, branch.then_region, callees) +
              CostOfRegion(module, function, branch.else_region, callees);
    }
    if (inst.op == Op::kFor) {
      const ir::ForLoop& loop = function.loops[inst.aux];
      cost += loop.Trips() * CostOfRegion(module, function, loop.body, callees);
    }
  }
  return cost;
}

}  // namespace

ir::Module RandomModule(uint32_t seed, const RandomModuleOptions& options) {
  return Generator(seed, options).Run();
}

ir::EvaluateInputs RandomInputs(const ir::Module& module, uint32_t seed, uint32_t lanes,
                                bool tame) {
  ir::EvaluateInputs inputs;
  inputs.lanes = lanes;
  for (const ir::Global& global : module.globals) {
    std::mt19937 random(HashName(global.name, seed));
    std::vector<uint32_t> words;
    if (global.kind != GlobalKind::kTexture) {
      words.resize(module.types.Words(global.type) *
                   (global.kind == GlobalKind::kInput ? lanes : 1));
      for (uint32_t& word : words) word = RandomWord(ir::ScalarType(global.type), tame, random);
    }
    inputs.globals.push_back(std::move(words));
    inputs.textures.push_back(nullptr);
  }
  return inputs;
}

uint64_t CostOfMain(const ir::Module& module) {
  std::vector<uint64_t> costs;
  for (const ir::Function& function : module.functions) {
    costs.push_back(CostOfRegion(module, function, function.body, costs));
  }
  return costs[module.main.index];
}

}  // namespace texgraph::fuzz
