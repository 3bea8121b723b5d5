// SPDX-License-Identifier: Apache-2.0
#define SPV_ENABLE_UTILITY_CODE
#include "tests/scan/implicit_samples.h"

#include <map>
#include <set>

#include <spirv-tools/libspirv.hpp>
#include <spirv-tools/optimizer.hpp>
#include <spirv/unified1/GLSL.std.450.h>
#include <spirv/unified1/spirv.hpp11>

namespace texgraph::scan {
namespace {

struct Instruction {
  spv::Op op;
  uint32_t type = 0, result = 0;
  std::vector<uint32_t> operands;  // behind type and result
  uint32_t block = 0;              // label of the block that it stands in
};

// One shader after inlining: its only function that matters is the entry point.
struct Shader {
  std::vector<Instruction> instructions;
  std::map<uint32_t, size_t> by_result;
  std::map<uint32_t, std::vector<uint32_t>> successors;  // of blocks
  std::map<uint32_t, uint32_t> conditions;               // of the branches that meet in a block, by that block
  std::map<uint32_t, std::string> names;
  std::set<uint32_t> inputs;  // variables
  uint32_t entry_function = 0, entry_block = 0;
};

bool HasType(spv::Op op) {
  bool has_result = false, has_type = false;
  spv::HasResultAndType(op, &has_result, &has_type);
  return has_type;
}

bool HasResult(spv::Op op) {
  bool has_result = false, has_type = false;
  spv::HasResultAndType(op, &has_result, &has_type);
  return has_result;
}

std::optional<std::vector<uint32_t>> Inline(const std::vector<uint32_t>& words) {
  spvtools::Optimizer optimizer(SPV_ENV_OPENGL_4_5);
  optimizer.RegisterPass(spvtools::CreateInlineExhaustivePass())
      .RegisterPass(spvtools::CreateEliminateDeadFunctionsPass())
      .RegisterPass(spvtools::CreateScalarReplacementPass(0))
      .RegisterPass(spvtools::CreateLocalAccessChainConvertPass())
      // The pointers that this leaves would keep their variables from being rewritten.
      .RegisterPass(spvtools::CreateAggressiveDCEPass())
      .RegisterPass(spvtools::CreateSSARewritePass())
      .RegisterPass(spvtools::CreateAggressiveDCEPass());
  std::vector<uint32_t> inlined;
  if (!optimizer.Run(words.data(), words.size(), &inlined)) return std::nullopt;
  return inlined;
}

Shader Read(const std::vector<uint32_t>& words) {
  Shader shader;
  uint32_t function = 0, block = 0, merge = 0;
  for (size_t at = 5; at < words.size();) {
    const uint32_t count = words[at] >> 16;
    Instruction inst;
    inst.op = static_cast<spv::Op>(words[at] & 0xffff);
    size_t next = at + 1;
    if (HasType(inst.op)) inst.type = words[next++];
    if (HasResult(inst.op)) inst.result = words[next++];
    inst.operands.assign(words.begin() + static_cast<long>(next), words.begin() + static_cast<long>(at + count));
    at += count;
    switch (inst.op) {
      case spv::Op::OpEntryPoint: shader.entry_function = inst.operands[1]; break;
      case spv::Op::OpName:
        shader.names[inst.operands[0]] = reinterpret_cast<const char*>(&inst.operands[1]);
        break;
      case spv::Op::OpVariable:
        if (inst.operands[0] == static_cast<uint32_t>(spv::StorageClass::Input)) shader.inputs.insert(inst.result);
        break;
      case spv::Op::OpFunction: function = inst.result; break;
      case spv::Op::OpLabel:
        block = inst.result;
        if (function == shader.entry_function && !shader.entry_block) shader.entry_block = block;
        break;
      case spv::Op::OpBranch: shader.successors[block] = {inst.operands[0]}; break;
      case spv::Op::OpSelectionMerge: merge = inst.operands[0]; break;
      case spv::Op::OpBranchConditional:
        shader.successors[block] = {inst.operands[1], inst.operands[2]};
        if (merge) shader.conditions[merge] = inst.operands[0];
        merge = 0;
        break;
      default: break;
    }
    inst.block = block;
    if (inst.result) shader.by_result[inst.result] = shader.instructions.size();
    shader.instructions.push_back(std::move(inst));
  }
  return shader;
}

// Whether the end of the shader can be reached without `avoided`.
bool CanAvoid(const Shader& shader, uint32_t avoided) {
  std::set<uint32_t> seen;
  std::vector<uint32_t> work{shader.entry_block};
  while (!work.empty()) {
    uint32_t block = work.back();
    work.pop_back();
    if (block == avoided || !seen.insert(block).second) continue;
    auto next = shader.successors.find(block);
    if (next == shader.successors.end()) return true;
    work.insert(work.end(), next->second.begin(), next->second.end());
  }
  return false;
}

bool CanComeBack(const Shader& shader, uint32_t block) {
  std::set<uint32_t> seen;
  std::vector<uint32_t> work;
  if (auto next = shader.successors.find(block); next != shader.successors.end()) work = next->second;
  while (!work.empty()) {
    uint32_t at = work.back();
    work.pop_back();
    if (at == block) return true;
    if (!seen.insert(at).second) continue;
    if (auto next = shader.successors.find(at); next != shader.successors.end()) {
      work.insert(work.end(), next->second.begin(), next->second.end());
    }
  }
  return false;
}

// Whether the operation's value may jump where its operands do not, or where an integer steps.
bool Jumps(const Instruction& inst) {
  switch (inst.op) {
    case spv::Op::OpFMod:
    case spv::Op::OpFRem:
    case spv::Op::OpSelect:
    case spv::Op::OpPhi:
    case spv::Op::OpConvertFToS:
    case spv::Op::OpConvertFToU:
    case spv::Op::OpConvertSToF:
    case spv::Op::OpConvertUToF:
    case spv::Op::OpBitcast:
    case spv::Op::OpVectorExtractDynamic:
    case spv::Op::OpFOrdLessThan:
    case spv::Op::OpFOrdGreaterThan: return true;
    case spv::Op::OpExtInst:
      switch (inst.operands[1]) {
        case GLSLstd450Round:
        case GLSLstd450RoundEven:
        case GLSLstd450Trunc:
        case GLSLstd450Floor:
        case GLSLstd450Ceil:
        case GLSLstd450Fract:
        case GLSLstd450FSign:
        case GLSLstd450Step:
        case GLSLstd450Atan2: return true;
        default: return false;
      }
    default: return false;
  }
}

// How many operands, from the first on, are ids; behind them stand literals, which are small numbers that may look like ids.
size_t IdCount(const Instruction& inst) {
  switch (inst.op) {
    case spv::Op::OpConstant:
    case spv::Op::OpSpecConstant:
    case spv::Op::OpVariable: return 0;
    case spv::Op::OpLoad:
    case spv::Op::OpCompositeExtract: return 1;
    case spv::Op::OpCompositeInsert:
    case spv::Op::OpVectorShuffle: return 2;
    default: return inst.operands.size();
  }
}

// The ids that an instruction computes from.
std::vector<uint32_t> IdsOf(const Shader& shader, const Instruction& inst) {
  std::vector<uint32_t> ids;
  const bool samples = inst.op == spv::Op::OpImageSampleImplicitLod || inst.op == spv::Op::OpImageSampleExplicitLod ||
                       inst.op == spv::Op::OpImageFetch;
  const size_t first = inst.op == spv::Op::OpExtInst ? 2 : 0;
  for (size_t i = first; i < IdCount(inst); ++i) {
    if (inst.op == spv::Op::OpPhi && i % 2 == 1) continue;
    if (samples && i == 2) continue;  // which operands follow
    if (shader.by_result.count(inst.operands[i])) ids.push_back(inst.operands[i]);
  }
  return ids;
}

// What a member of a struct is computed from, where the struct was just put together: that member alone.
uint32_t MemberOf(const Shader& shader, const Instruction& extract) {
  const Instruction& whole = shader.instructions[shader.by_result.at(extract.operands[0])];
  const auto type = shader.by_result.find(whole.type);
  const bool made = whole.op == spv::Op::OpCompositeConstruct && type != shader.by_result.end() &&
                    shader.instructions[type->second].op == spv::Op::OpTypeStruct;
  return made ? whole.operands[extract.operands[1]] : extract.operands[0];
}

// Everything that a value is computed from.
std::set<uint32_t> SliceOf(const Shader& shader, uint32_t id) {
  std::set<uint32_t> slice;
  std::vector<uint32_t> work{id};
  while (!work.empty()) {
    uint32_t at = work.back();
    work.pop_back();
    if (!slice.insert(at).second) continue;
    const Instruction& inst = shader.instructions[shader.by_result.at(at)];
    if (inst.op == spv::Op::OpCompositeExtract) {
      work.push_back(MemberOf(shader, inst));
      continue;
    }
    for (uint32_t next : IdsOf(shader, inst)) work.push_back(next);
  }
  return slice;
}

bool Varies(const Shader& shader, uint32_t id) {
  for (uint32_t at : SliceOf(shader, id)) {
    if (shader.inputs.count(at)) return true;
  }
  return false;
}

// What makes the value jump if it varies: of a choice, what decides it.
std::vector<uint32_t> Deciding(const Shader& shader, const Instruction& step) {
  if (step.op == spv::Op::OpSelect) return {step.operands[0]};
  const auto condition = shader.conditions.find(step.block);
  if (step.op == spv::Op::OpPhi && condition != shader.conditions.end()) return {condition->second};
  return IdsOf(shader, step);
}

bool IsOfArray(const Shader& shader, const Instruction& sample) {
  const uint32_t type = shader.instructions[shader.by_result.at(sample.operands[0])].type;
  const auto sampled = shader.by_result.find(type);
  if (sampled == shader.by_result.end() ||
      shader.instructions[sampled->second].op != spv::Op::OpTypeSampledImage) {
    return false;
  }
  // What is sampled, the dimension, depth, arrayed.
  const auto image = shader.by_result.find(shader.instructions[sampled->second].operands[0]);
  return image != shader.by_result.end() && shader.instructions[image->second].operands[3] == 1;
}

// What the footprint of a sample is computed from: of an array all but the layer, which comes last.
std::set<uint32_t> SliceOfPlace(const Shader& shader, const Instruction& sample) {
  const Instruction& coordinate = shader.instructions[shader.by_result.at(sample.operands[1])];
  if (coordinate.op != spv::Op::OpCompositeConstruct || !IsOfArray(shader, sample)) {
    return SliceOf(shader, sample.operands[1]);
  }
  std::set<uint32_t> slice;
  for (size_t i = 0; i + 1 < coordinate.operands.size(); ++i) {
    slice.merge(SliceOf(shader, coordinate.operands[i]));
  }
  return slice;
}

std::string Describe(const Shader& shader, const Instruction& sample) {
  for (uint32_t id : SliceOf(shader, sample.operands[0])) {
    auto name = shader.names.find(id);
    if (name != shader.names.end()) return "a sample of '" + name->second + "'";
  }
  return "a sample";
}

}  // namespace

std::optional<ImplicitSamples> FindImplicitSamples(const std::vector<uint32_t>& words) {
  std::optional<std::vector<uint32_t>> inlined = Inline(words);
  if (!inlined) return std::nullopt;
  Shader shader = Read(*inlined);
  ImplicitSamples found;
  for (const Instruction& inst : shader.instructions) {
    if (inst.op == spv::Op::OpImageSampleExplicitLod) ++found.explicit_;
    if (inst.op != spv::Op::OpImageSampleImplicitLod) continue;
    ++found.implicit;
    if (CanAvoid(shader, inst.block) || CanComeBack(shader, inst.block)) {
      found.mistakes.push_back(Describe(shader, inst) + " stands in a branch or a loop");
    }
    for (uint32_t id : SliceOfPlace(shader, inst)) {
      const Instruction& step = shader.instructions[shader.by_result.at(id)];
      if (!Jumps(step)) continue;
      bool varies = false;
      for (uint32_t operand : Deciding(shader, step)) varies = varies || Varies(shader, operand);
      if (!varies) continue;
      found.mistakes.push_back(Describe(shader, inst) + " has a coordinate that jumps");
      break;
    }
  }
  return found;
}

}  // namespace texgraph::scan
