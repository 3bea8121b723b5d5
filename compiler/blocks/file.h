// SPDX-License-Identifier: Apache-2.0
// A block file after its declarations were checked: structs, constants, fields, the functions'
// signatures, the block's ports. The bodies are checked when they are asked for.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/blocks/ast.h"
#include "compiler/blocks/block.h"
#include "compiler/blocks/typed.h"

namespace texgraph::blocks {

struct SignatureParameter {
  std::string_view name;
  ir::TypeId type;
  bool is_template = false;
  bool is_in = true;
  bool is_out = false;
  SourceRange range;
};

struct Signature {
  ir::TypeId result;
  std::vector<SignatureParameter> parameters;
  bool valid = false;
};

// What genType stands for counts the variants of a function: 0 if it stands for nothing, else the
// width.
inline uint32_t Variant(ir::TypeId gen_type) { return gen_type ? ir::Width(gen_type) : 0; }
inline constexpr uint32_t kVariants = 5;

// A prototype without a body.
struct FieldInfo {
  const FunctionAst* ast = nullptr;
  bool is_generic = false;
  std::array<Signature, kVariants> signatures;
  ir::TypeId Type(ir::Types& types, ir::TypeId gen_type) const;
};

struct FunctionInfo {
  const FunctionAst* ast = nullptr;
  uint32_t declared_at = 0;      // where its first declaration begins
  bool is_block = false;         // has the file's name: others may call it
  bool is_generic = false;       // genType stands in its signature
  bool needs_gen_type = false;   // is generic, or calls a field that is
  std::vector<uint32_t> fields;  // those that it is given, ascending
  std::array<Signature, kVariants> signatures;
  std::array<std::unique_ptr<TypedFunction>, kVariants> bodies;
};

struct StructInfo {
  ir::TypeId type;
  uint32_t depth = 1;
  uint32_t position = 0;  // where it is declared
  SourceRange range;
};

struct ConstantInfo {
  ir::ConstId value;
  uint32_t position = 0;
  SourceRange range;
};

struct File {
  std::string name;
  std::string family;
  std::string path;
  SourceId source;
  bool valid = false;  // the declarations are right
  // The documentation was read, which gives ports their defaults and ranges: of blocks that graphs
  // use. What other blocks call needs none.
  bool is_described = false;
  bool is_described_well = false;
  std::unique_ptr<FileAst> ast;
  std::map<std::string_view, StructInfo> structs;
  std::map<std::string_view, ConstantInfo> constants;
  std::vector<FieldInfo> fields;
  std::vector<FunctionInfo> functions;  // those with a body
  std::map<std::string_view, std::vector<uint32_t>> functions_by_name;
  Block block;
};

// What checking and lowering need to know of the rest of the program.
class Program {
 public:
  Program(ir::Module& module, Sources& sources, Diagnostics& diagnostics)
      : module(module), sources(sources), diagnostics(diagnostics) {}
  virtual ~Program() = default;

  // The file of a block, with its declarations checked. Null if there is none, or if it is wrong
  // (reported).
  virtual File* FindFile(std::string_view name) = 0;
  virtual bool HasFile(std::string_view name) const = 0;
  virtual std::vector<std::string_view> FileNames() const = 0;
  // types.glsl; null while it is itself being checked.
  virtual const File* SharedFile() = 0;

  ir::Module& module;
  Sources& sources;
  Diagnostics& diagnostics;
};

}  // namespace texgraph::blocks
