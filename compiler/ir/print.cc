// SPDX-License-Identifier: Apache-2.0
#include "compiler/ir/print.h"

#include <bit>
#include <charconv>
#include <cmath>

#include "compiler/base/text.h"
#include "compiler/ir/value_names.h"

namespace texgraph::ir {
namespace {

std::string NameText(std::string_view name) {
  return IsIdentifier(name) ? std::string(name) : JsonQuoted(name);
}

std::string FloatLiteral(uint32_t word) {
  float value = std::bit_cast<float>(word);
  if (std::isfinite(value)) return FloatText(value);
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  if (word == 0x7fc00000u) return "nan";
  char digits[8];
  auto end = std::to_chars(digits, digits + sizeof digits, word, 16).ptr;
  return "bits(0x" + std::string(digits, end) + ")";
}

std::string ScalarLiteral(Scalar scalar, uint32_t word) {
  switch (scalar) {
    case Scalar::kBool:
      return word ? "true" : "false";
    case Scalar::kInt:
      return std::to_string(std::bit_cast<int32_t>(word));
    case Scalar::kUint:
      return std::to_string(word) + "u";
    case Scalar::kFloat:
      return FloatLiteral(word);
  }
  return "";
}

// Advances `words` past the value.
void AppendLiteral(const Types& types, TypeId type, const uint32_t*& words, std::string& out) {
  if (IsScalar(type)) {
    out += ScalarLiteral(ScalarOf(type), *words++);
    return;
  }
  out += types.Text(type) + "(";
  // The components of a matrix stand in one list.
  uint32_t count = IsMatrix(type) ? types.Words(type) : types.ElementCount(type);
  for (uint32_t i = 0; i < count; ++i) {
    if (i) out += ", ";
    AppendLiteral(types, IsMatrix(type) ? kFloat : types.ElementType(type, i), words, out);
  }
  out += ")";
}

std::string Literal(const Module& module, ConstId id) {
  std::string out;
  const uint32_t* words = module.Words(id).data();
  AppendLiteral(module.types, module.constant(id).type, words, out);
  return out;
}

class FunctionPrinter {
 public:
  FunctionPrinter(const Module& module, const Function& function, std::string& out)
      : module_(module), f_(function), names_(module, function), out_(out) {}

  void Print();

 private:
  void PrintHeader();
  void PrintRegion(RegionId region, int indent, std::string_view end);
  void PrintInst(ValueId v, int indent);
  void PrintIf(const Inst& inst, int indent);
  void PrintFor(const Inst& inst, int indent);
  // After the name of an operation that is no control: its aux and its operands.
  void PrintPlain(const Inst& inst);
  void PrintList(std::span<const ValueId> values);
  std::string Operand(ValueId v) const;
  std::string TypeText(TypeId type) const { return module_.types.Text(type); }
  void Indent(int indent) { out_.append(static_cast<size_t>(indent) * 2, ' '); }
  void PrintOrigin(OriginId origin) {
    if (origin) out_ += " #" + std::to_string(origin.index);
  }

  const Module& module_;
  const Function& f_;
  ValueNames names_;
  std::string& out_;
};

void FunctionPrinter::Print() {
  PrintHeader();
  out_ += " {\n";
  PrintRegion(f_.body, 1, "return");
  out_ += "}\n";
}

void FunctionPrinter::PrintHeader() {
  out_ += "function " + NameText(f_.name);
  bool differs = !f_.display_name.empty() && f_.display_name != f_.name;
  if (differs) out_ += " as " + NameText(f_.display_name);
  out_ += "(";
  for (size_t i = 0; i < f_.parameters.size(); ++i) {
    ValueId v = f_.Body().params[i];
    names_.Declare(v);
    if (i) out_ += ", ";
    if (f_.parameters[i].is_template) out_ += "const ";
    out_.append(names_(v)).append(": ").append(TypeText(f_.parameters[i].type));
    if (f_.parameters[i].repeats) out_ += " repeats";
  }
  out_ += ") -> ";
  bool bare = f_.results.size() == 1 && f_.results[0].name.empty();
  if (!bare) out_ += "(";
  for (size_t i = 0; i < f_.results.size(); ++i) {
    if (i) out_ += ", ";
    if (!f_.results[i].name.empty()) out_ += NameText(f_.results[i].name) + ": ";
    out_ += TypeText(f_.results[i].type);
  }
  if (!bare) out_ += ")";
  PrintOrigin(f_.origin);
}

void FunctionPrinter::PrintRegion(RegionId region, int indent, std::string_view end) {
  const Region& r = f_.regions[region.index];
  for (ValueId v : r.body) PrintInst(v, indent);
  Indent(indent);
  out_ += end;
  if (!r.results.empty()) out_ += " ";
  PrintList(r.results);
  out_ += "\n";
}

void FunctionPrinter::PrintInst(ValueId v, int indent) {
  const Inst& inst = f_[v];
  if (inst.op == Op::kGlobal) return;
  names_.Declare(v);
  Indent(indent);
  out_.append(names_(v)).append(" = ").append(Info(inst.op).name);
  if (inst.op == Op::kIf) {
    PrintIf(inst, indent);
  } else if (inst.op == Op::kFor) {
    PrintFor(inst, indent);
  } else {
    PrintPlain(inst);
    out_ += " : " + TypeText(inst.type);
  }
  OriginId origin = f_.OriginOf(v);
  if (origin != f_.origin) PrintOrigin(origin);
  out_ += "\n";
}

void FunctionPrinter::PrintIf(const Inst& inst, int indent) {
  const Branch& branch = f_.branches[inst.aux];
  out_ += " " + Operand(f_.Operands(inst)[0]) + " : " + TypeText(inst.type) + " {\n";
  PrintRegion(branch.then_region, indent + 1, "yield");
  Indent(indent);
  out_ += "} else {\n";
  PrintRegion(branch.else_region, indent + 1, "yield");
  Indent(indent);
  out_ += "}";
}

void FunctionPrinter::PrintFor(const Inst& inst, int indent) {
  const ForLoop& loop = f_.loops[inst.aux];
  const std::vector<ValueId>& params = f_.regions[loop.body.index].params;
  for (ValueId param : params) names_.Declare(param);
  out_.append(" ").append(names_(params[0])).append(" = ").append(std::to_string(loop.first));
  out_ += " to " + std::to_string(loop.last) + " step " + std::to_string(loop.step) + " (";
  std::span<const ValueId> initial = f_.Operands(inst);
  for (size_t i = 0; i < initial.size(); ++i) {
    if (i) out_ += ", ";
    out_.append(names_(params[i + 1])).append(" = ").append(Operand(initial[i]));
  }
  out_ += ") : " + TypeText(inst.type) + " {\n";
  PrintRegion(loop.body, indent + 1, "yield");
  Indent(indent);
  out_ += "}";
}

void FunctionPrinter::PrintPlain(const Inst& inst) {
  std::span<const ValueId> operands = f_.Operands(inst);
  switch (inst.op) {
    case Op::kCall:
    case Op::kFieldRef:
      out_ += " " + NameText(module_.functions[inst.aux].name) + "(";
      PrintList(operands);
      out_ += ")";
      return;
    case Op::kCallField:
      out_ += " " + Operand(operands[0]) + "(";
      PrintList(operands.subspan(1));
      out_ += ")";
      return;
    case Op::kExtract:
      out_ += "." + std::to_string(inst.aux);
      break;
    case Op::kSwizzle:
      out_ += ".";
      for (uint32_t i = 0; i < Width(inst.type); ++i) out_ += "xyzw"[(inst.aux >> (2 * i)) & 3];
      break;
    default:
      break;
  }
  if (!operands.empty()) out_ += " ";
  PrintList(operands);
}

void FunctionPrinter::PrintList(std::span<const ValueId> values) {
  for (size_t i = 0; i < values.size(); ++i) {
    if (i) out_ += ", ";
    out_ += Operand(values[i]);
  }
}

std::string FunctionPrinter::Operand(ValueId v) const {
  const Inst& inst = f_[v];
  if (inst.op == Op::kConst) return Literal(module_, ConstId(inst.aux));
  if (inst.op == Op::kGlobal) return "@" + NameText(module_.globals[inst.aux].name);
  return std::string(names_(v));
}

void PrintStruct(const Types& types, const Type& type, std::string& out) {
  out += "struct " + type.name + " { ";
  for (size_t i = 0; i < type.fields.size(); ++i) {
    if (i) out += ", ";
    out += NameText(type.fields[i].name) + ": " + types.Text(type.fields[i].type);
  }
  out += " }\n";
}

void PrintMap(const MapFacts& map, std::string& out) {
  out += " map " + std::to_string(map.width) + " x " + std::to_string(map.height) + " x " +
         std::to_string(map.layers);
  for (size_t i = 0; i < map.values.size(); ++i) {
    out += (i == 0 ? " (" : ", ") + std::to_string(map.values[i]);
  }
  if (!map.values.empty()) out += ")";
}

void PrintGlobal(const Module& module, const Global& global, std::string& out) {
  constexpr std::string_view kKinds[] = {"input", "uniform", "specialization", "texture"};
  out += kKinds[static_cast<size_t>(global.kind)];
  out += " " + NameText(global.name) + ": " + module.types.Text(global.type);
  if (!global.is_smooth) out += " not smooth";
  if (global.repeats) out += " repeats";
  if (global.map) PrintMap(*global.map, out);
  if (global.value) out += " = " + Literal(module, global.value);
  out += "\n";
}

}  // namespace

std::string Print(const Module& module, const Function& function) {
  std::string out;
  FunctionPrinter(module, function, out).Print();
  return out;
}

std::string Print(const Module& module) {
  std::string out;
  for (uint32_t i = kBasicTypeCount; i < module.types.size(); ++i) {
    const Type& type = module.types[TypeId(i)];
    if (type.kind == TypeKind::kStruct) PrintStruct(module.types, type, out);
  }
  for (size_t i = 0; i < module.origins.size(); ++i) {
    const Origin& origin = module.origins[i];
    out += "origin #" + std::to_string(i) + " = " + JsonQuoted(origin.node) + " " +
           JsonQuoted(origin.block) + " " + JsonQuoted(origin.source) + "\n";
  }
  for (const Global& global : module.globals) PrintGlobal(module, global, out);
  for (const Function& function : module.functions) {
    FunctionPrinter(module, function, out).Print();
  }
  if (module.main) out += "main " + NameText(module[module.main].name) + "\n";
  return out;
}

}  // namespace texgraph::ir
