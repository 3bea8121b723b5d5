// SPDX-License-Identifier: Apache-2.0
#include "compiler/blocks/plain_glsl.h"

#include <algorithm>
#include <deque>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "compiler/blocks/file.h"
#include "compiler/blocks/limits.h"

namespace texgraph::blocks {
namespace {

constexpr std::string_view kVectors[] = {"float", "vec2", "vec3", "vec4"};

bool IsGeneric(const FunctionAst& function) {
  return function.result.name == "genType" ||
         std::ranges::any_of(function.parameters, [](const ParameterAst& parameter) {
           return parameter.type.name == "genType";
         });
}

class Writer {
 public:
  Writer(Library& library, const Sources& sources, ir::TypeId gen_type)
      : library_(library), sources_(sources), gen_type_(gen_type) {}

  std::string Run(const File& file) {
    text_ = "#version 450\n";
    for (std::string_view function : {"footprint", "footprint_x", "footprint_y"}) {
      for (std::string_view type : kVectors) {
        text_ +=
            std::string(type) + " " + std::string(function) + "(" + std::string(type) + " x);\n";
      }
    }
    for (const EmbeddedFile& embedded : EmbeddedFiles()) {
      if (embedded.name == "types") text_ += embedded.text;
    }
    WriteCalled(file);
    WriteFile(file);
    return text_ + "\nvoid main() {}\n";
  }

 private:
  // The blocks that a file calls, each behind those that it calls itself. Blocks cannot call each
  // other in a circle.
  void WriteCalled(const File& file) {
    if (!written_.insert(file.name).second) return;
    for (const Expr& expr : file.ast->exprs) {
      bool own = file.functions_by_name.contains(expr.name) ||
                 std::ranges::any_of(file.fields, [&](const FieldInfo& field) {
                   return field.ast->name == expr.name;
                 });
      if (expr.kind != ExprKind::kCall || own || written_.contains(std::string(expr.name)))
        continue;
      if (!library_.Exists(expr.name)) continue;
      const Block* block = library_.Find(expr.name);
      if (!block) continue;
      WriteCalled(*block->file);
      // What is private to a file has a name of its own here.
      std::set<std::string> hidden;
      for (const StructAst& structure : block->file->ast->structs) hidden.emplace(structure.name);
      for (const ConstantAst& constant : block->file->ast->constants) {
        hidden.emplace(constant.declarator.name);
      }
      for (const auto& [name, functions] : block->file->functions_by_name) {
        if (name != block->name) hidden.emplace(name);
      }
      for (const std::string& name : hidden) {
        text_ += "#define " + name + " " + block->name + "_" + name + "\n";
      }
      WriteFile(*block->file);
      for (const std::string& name : hidden) text_ += "#undef " + name + "\n";
    }
  }

  void WriteFile(const File& file) {
    // By position: the text and whether it is there for each vector.
    std::map<uint32_t, std::pair<std::string_view, bool>> pieces;
    std::string_view source = sources_.Text(file.source);
    auto add = [&](SourceRange range, bool generic) {
      pieces[range.begin] = {source.substr(range.begin, range.end - range.begin), generic};
    };
    for (const StructAst& structure : file.ast->structs) add(structure.whole, false);
    for (const ConstantAst& constant : file.ast->constants) add(constant.whole, false);
    for (const FunctionAst& function : file.ast->functions) {
      add(function.whole, IsGeneric(function) && !IsBound(file, function));
    }
    // Where GLSL wants a length, and blocks have none.
    std::set<uint32_t> lengths;
    for (const FunctionAst& function : file.ast->functions) {
      for (const ParameterAst& parameter : function.parameters) {
        if (!parameter.type.is_array || parameter.type.length) continue;
        lengths.insert(static_cast<uint32_t>(source.find(']', parameter.type.range.begin)));
      }
    }
    std::deque<std::string> filled;
    for (auto& [position, piece] : pieces) {
      uint32_t end = position + static_cast<uint32_t>(piece.first.size());
      if (lengths.lower_bound(position) == lengths.lower_bound(end)) continue;
      std::string& text = filled.emplace_back(piece.first);
      for (auto at = lengths.lower_bound(end); at != lengths.lower_bound(position);) {
        text.insert(*--at - position, std::to_string(kMaxArrayLength));
      }
      piece.first = text;
    }
    for (const auto& [position, piece] : pieces) {
      if (piece.second) {
        for (std::string_view type : kVectors) WriteFor(type, piece.first);
      } else {
        WriteFor(gen_type_ ? kVectors[ir::Width(gen_type_) - 1] : kVectors[0], piece.first);
      }
    }
  }

  // Whether genType is the block's in a function: it is a field, or it calls one that is generic.
  static bool IsBound(const File& file, const FunctionAst& function) {
    if (!function.body && !file.functions_by_name.contains(function.name)) return true;
    for (const FunctionInfo& info : file.functions) {
      if (info.ast->name != function.name) continue;
      for (uint32_t field : info.fields) {
        if (file.fields[field].is_generic) return true;
      }
    }
    return false;
  }

  void WriteFor(std::string_view type, std::string_view piece) {
    text_ +=
        "#define genType " + std::string(type) + "\n" + std::string(piece) + "\n#undef genType\n";
  }

  Library& library_;
  const Sources& sources_;
  ir::TypeId gen_type_;
  std::set<std::string> written_;
  std::string text_;
};

}  // namespace

std::string PlainGlsl(Library& library, const Sources& sources, const Block& block,
                      const Overload& overload) {
  return Writer(library, sources, overload.gen_type).Run(*block.file);
}

}  // namespace texgraph::blocks
