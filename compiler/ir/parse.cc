// SPDX-License-Identifier: Apache-2.0
#include <optional>
#include <utility>

#include "compiler/ir/parse_function.h"
#include "compiler/ir/print.h"
#include "compiler/ir/text_reader.h"
#include "compiler/ir/verify.h"

namespace texgraph::ir {
namespace {

class ModuleParser {
 public:
  ModuleParser(SourceId source, std::string_view text, Module& module, Diagnostics& diagnostics)
      : module_(module), reader_(source, text, module, diagnostics) {}

  bool Parse() {
    while (reader_.ok() && !reader_.AtEnd()) ParseItem();
    return reader_.ok() && Verified();
  }

 private:
  bool ParseItem();
  bool ParseStruct();
  bool ParseOrigin();
  bool ParseGlobal(GlobalKind kind);
  MapFacts ParseMap();
  bool ParseOneFunction();
  bool ParseMain();
  bool Verified();

  Module& module_;
  TextReader reader_;
  TextNames names_;
  std::vector<FunctionRanges> ranges_;
};

bool ModuleParser::ParseItem() {
  if (reader_.Accept("struct")) return ParseStruct();
  if (reader_.Accept("origin")) return ParseOrigin();
  if (reader_.Accept("input")) return ParseGlobal(GlobalKind::kInput);
  if (reader_.Accept("uniform")) return ParseGlobal(GlobalKind::kUniform);
  if (reader_.Accept("specialization")) return ParseGlobal(GlobalKind::kSpecialization);
  if (reader_.Accept("texture")) return ParseGlobal(GlobalKind::kTexture);
  if (reader_.Accept("function")) return ParseOneFunction();
  if (reader_.Accept("main")) return ParseMain();
  return reader_.FailHere(
      "expected struct, origin, input, uniform, specialization, texture, function or main");
}

bool ModuleParser::ParseStruct() {
  const Token name = reader_.TakeKind(TokenKind::kIdentifier, "the struct's name");
  std::vector<StructField> fields;
  if (!reader_.Expect("{")) return false;
  while (reader_.ok() && !reader_.At("}")) {
    StructField field;
    field.name = reader_.Name("a member");
    reader_.Expect(":");
    field.type = reader_.ReadType();
    fields.push_back(std::move(field));
    if (!reader_.Accept(",")) break;
  }
  if (!reader_.Expect("}")) return false;
  bool added = module_.types.Struct(name.text, std::move(fields)).valid();
  return added || reader_.Fail(name.range, "a second type '" + name.text + "'");
}

bool ModuleParser::ParseOrigin() {
  const Token id =
      reader_.TakeKind(TokenKind::kOrigin, "#" + std::to_string(module_.origins.size()));
  if (reader_.ok() && id.text != std::to_string(module_.origins.size())) {
    return reader_.Fail(id.range, "expected #" + std::to_string(module_.origins.size()));
  }
  reader_.Expect("=");
  const std::string node = reader_.TakeKind(TokenKind::kString, "the node in quotes").text;
  const std::string block = reader_.TakeKind(TokenKind::kString, "the block in quotes").text;
  const std::string file = reader_.TakeKind(TokenKind::kString, "the source in quotes").text;
  if (reader_.ok()) module_.AddOrigin({node, block, file});
  return reader_.ok();
}

// "2 x 2 x 1", and all numbers of it if they never change.
MapFacts ModuleParser::ParseMap() {
  constexpr int64_t kMostSide = 1 << 20;
  MapFacts map;
  map.width = static_cast<uint32_t>(reader_.Integer(1, kMostSide));
  reader_.Expect("x");
  map.height = static_cast<uint32_t>(reader_.Integer(1, kMostSide));
  reader_.Expect("x");
  map.layers = static_cast<uint32_t>(reader_.Integer(1, kMostSide));
  const SourceRange range = reader_.Peek().range;
  if (!reader_.Accept("(")) return map;
  do {
    map.values.push_back(static_cast<int32_t>(reader_.Integer(INT32_MIN, INT32_MAX)));
  } while (reader_.ok() && reader_.Accept(","));
  reader_.Expect(")");
  if (reader_.ok() && map.values.size() != size_t{map.width} * map.height * map.layers) {
    reader_.Fail(range, "a map with numbers has one for each texel");
  }
  return map;
}

bool ModuleParser::ParseGlobal(GlobalKind kind) {
  Global global;
  global.kind = kind;
  const SourceRange range = reader_.Peek().range;
  global.name = reader_.Name("a name");
  reader_.Expect(":");
  global.type = reader_.ReadType();
  if (reader_.Accept("not")) {
    global.is_smooth = false;
    reader_.Expect("smooth");
  }
  global.repeats = reader_.Accept("repeats");
  if (reader_.Accept("map")) global.map = ParseMap();
  if (reader_.Accept("=")) global.value = reader_.ReadConstant();
  if (!reader_.ok()) return false;
  if (!names_.globals.emplace(global.name, GlobalId(module_.globals.size())).second) {
    return reader_.Fail(range, "a second '" + global.name + "'");
  }
  module_.AddGlobal(std::move(global));
  return true;
}

bool ModuleParser::ParseOneFunction() {
  Function function;
  FunctionRanges ranges;
  if (!ParseFunction(reader_, module_, names_, function, ranges)) return false;
  if (!names_.functions.emplace(function.name, FunctionId(module_.functions.size())).second) {
    return reader_.Fail(ranges.header, "a second function '" + function.name + "'");
  }
  module_.functions.push_back(std::move(function));
  ranges_.push_back(std::move(ranges));
  return true;
}

bool ModuleParser::ParseMain() {
  const SourceRange range = reader_.Peek().range;
  std::string name = reader_.Name("a function");
  if (!reader_.ok()) return false;
  auto found = names_.functions.find(name);
  if (found == names_.functions.end()) return reader_.Fail(range, "no function '" + name + "'");
  module_.main = found->second;
  return true;
}

bool ModuleParser::Verified() {
  std::optional<Violation> violation = FindViolation(module_);
  if (!violation) return true;
  SourceRange range = reader_.Peek().range;
  if (violation->function) {
    const FunctionRanges& ranges = ranges_[violation->function.index];
    range = violation->value ? ranges.values[violation->value.index] : ranges.header;
  }
  return reader_.Fail(range, std::move(violation->message));
}

}  // namespace

std::optional<Module> Parse(SourceId source, const Sources& sources, Diagnostics& diagnostics) {
  std::optional<Module> module(std::in_place);
  if (!ModuleParser(source, sources.Text(source), *module, diagnostics).Parse())
    return std::nullopt;
  return module;
}

}  // namespace texgraph::ir
