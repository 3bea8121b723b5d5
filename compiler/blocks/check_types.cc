// SPDX-License-Identifier: Apache-2.0
#include "compiler/base/text.h"
#include "compiler/blocks/check.h"
#include "compiler/blocks/limits.h"

namespace texgraph::blocks {
namespace {

using ir::TypeId;

std::string Quoted(std::string_view name) { return "'" + Printable(name, 60) + "'"; }

TypeId ResolveName(Program& program, File& file, const TypeName& name, TypeId gen_type) {
  ir::Types& types = program.module.types;
  if (name.name == "genType") {
    if (gen_type) return gen_type;
    program.diagnostics.Error(
        DiagnosticKind::kBlockType, name.range,
        "'genType' stands for nothing here: no parameter of the function is one");
    return {};
  }
  // Types knows the structs of all files, so only the basic types are taken from it.
  TypeId basic = types.Find(name.name);
  if (basic && basic.index < ir::kBasicTypeCount) return basic;
  const File* shared = program.SharedFile();
  if (auto own = file.structs.find(name.name); own != file.structs.end()) {
    if (own->second.position < name.range.begin) return own->second.type;
    program.diagnostics.Error(DiagnosticKind::kBlockName, name.range,
                              Quoted(name.name) + " is declared below; move it up");
    return {};
  }
  if (shared) {
    auto found = shared->structs.find(name.name);
    if (found != shared->structs.end()) return found->second.type;
  }
  if (IsReservedInGlsl(name.name)) {
    program.diagnostics.Error(DiagnosticKind::kBlockSubset, name.range,
                              "blocks have no " + Quoted(name.name));
    return {};
  }
  std::vector<std::string_view> known;
  for (uint32_t i = 0; i < ir::kBasicTypeCount; ++i) known.push_back(types[TypeId(i)].name);
  for (const auto& [own, info] : file.structs) known.push_back(own);
  if (shared) {
    for (const auto& [other, info] : shared->structs) known.push_back(other);
  }
  program.diagnostics.Error(DiagnosticKind::kBlockName, name.range,
                            "there is no type " + Quoted(name.name) + DidYouMean(name.name, known));
  return {};
}

}  // namespace

TypeId ResolveType(Program& program, File& file, const TypeName& name, TypeId gen_type,
                   uint32_t unsized_length) {
  ir::Types& types = program.module.types;
  TypeId element = ResolveName(program, file, name, gen_type);
  if (!element || !name.is_array) return element;
  if (ir::IsSampler(element) || element == ir::kVoid) {
    program.diagnostics.Error(DiagnosticKind::kBlockType, name.range,
                              "there are no arrays of " + types.Text(element));
    return {};
  }
  if (!name.length && unsized_length == kAnyLength) return types.Array(element, 0);
  uint32_t length = unsized_length;
  SourceRange range = name.range;
  if (name.length) {
    range = name.length->range;
    ir::ConstId constant =
        CheckConstant(program, file, *name.length, ir::kInt, false, DiagnosticKind::kBlockConstant);
    if (!constant) return {};
    length = program.module.Words(constant)[0];
  }
  if (auto number = static_cast<int32_t>(length); number < 1) {
    program.diagnostics.Error(DiagnosticKind::kBlockConstant, range,
                              "an array has at least one element, and its length is written");
    return {};
  }
  if (length > kMaxArrayLength) {
    program.diagnostics.Error(DiagnosticKind::kSizeLimit, range,
                              "an array has at most 1024 elements");
    return {};
  }
  if (uint64_t{length} * types.Words(element) > kMaxTypeWords) {
    program.diagnostics.Error(DiagnosticKind::kSizeLimit, range,
                              "this array has more than 4096 numbers");
    return {};
  }
  return types.Array(element, length);
}

}  // namespace texgraph::blocks
