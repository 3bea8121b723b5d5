// SPDX-License-Identifier: Apache-2.0
#include "compiler/glsl/function_printer.h"

#include <algorithm>

namespace texgraph::glsl {

using Kind = Statement::Kind;

FunctionPrinter::FunctionPrinter(const ir::Module& module, const ir::Function& function,
                                 const FunctionPlan& plan, const ModuleNames& names,
                                 LineWriter& out)
    : module_(module),
      function_(function),
      plan_(plan),
      schedule_(plan.schedule),
      names_(names),
      out_(out),
      expressions_(module, function, plan.forms, plan.variables, names),
      merged_(function.branches.size()) {
  locals_.Avoid([this](std::string_view name) {
    return (!claiming_named_ && wished_.contains(name)) || names_.Hides(name, plan_.globals);
  });
}

// --- Names -------------------------------------------------------------------------------------

std::string_view FunctionPrinter::Claim(std::string_view wish, bool is_named) {
  claiming_named_ = is_named;
  if (!is_named && !has_wishes_) {
    has_wishes_ = true;
    for (size_t i = 0; i < plan_.variables.size(); ++i) {
      VariableId v(i);
      if (!plan_.variables.IsRoot(v) || !plan_.variables[v].name) continue;
      wished_.insert(module_.Name(plan_.variables[v].name));
    }
  }
  return locals_.Claim(wish);
}

std::string FunctionPrinter::WishFor(const Variable& variable) const {
  if (plan_.reuse && !variable.is_index) return std::string(TypeWord(module_.types, variable.type));
  if (variable.name) return std::string(module_.Name(variable.name));
  const Inst& inst = function_[variable.example];
  if (inst.op == Op::kCall) {
    const ir::Function& callee = module_[FunctionId(inst.aux)];
    if (const std::string& result = callee.results[variable.result].name; !result.empty()) {
      NameId call = function_.NameOf(variable.example);
      return call ? std::string(module_.Name(call)) + "_" + result : result;
    }
  }
  return DescriptiveName(module_, function_, variable.example);
}

std::string_view FunctionPrinter::NameVariable(VariableId v) {
  const Variable& variable = plan_.variables[v];
  std::string_view name = Claim(WishFor(variable), variable.name.valid());
  expressions_.SetName(v, name);
  return name;
}

std::string_view FunctionPrinter::ClaimIndex(const Variable& variable) {
  if (variable.name) return Claim(module_.Name(variable.name), true);
  for (std::string_view name : {"i", "j"}) {
    if (!wished_.contains(name) && locals_.IsFree(name)) return Claim(name, false);
  }
  return Claim("k", false);
}

void FunctionPrinter::ClaimParameters() {
  for (size_t i = 0; i < function_.parameters.size(); ++i) {
    const std::string& wish = function_.parameters[i].name;
    expressions_.SetParameterName(i, Claim(wish.empty() ? "value" : wish, true));
  }
}

// --- Whole functions -----------------------------------------------------------------------------

// "vec4 layer(Tile tile, out float coverage) {"; the targets of the results are set on the way.
std::string FunctionPrinter::Signature(std::string_view name, std::vector<std::string> parameters) {
  std::string type = "void";
  const std::vector<ir::Result>& results = function_.results;
  for (size_t i = 0; i < results.size(); ++i) {
    bool returned = results.size() == 1 || (i == 0 && results[0].name.empty());
    if (returned) {
      type = names_.Type(results[i].type);
      targets_.emplace_back();
      continue;
    }
    targets_.emplace_back(Claim(results[i].name.empty() ? "result" : results[i].name, true));
    parameters.push_back("out " + names_.Declaration(results[i].type, targets_.back()));
  }
  std::string text = type + " ";
  text += name;
  text += '(';
  for (size_t i = 0; i < parameters.size(); ++i) text += (i > 0 ? ", " : "") + parameters[i];
  return text + ") {";
}

void FunctionPrinter::PrintBlock(std::string_view name) {
  if (ir::OriginId id = function_.origin) {
    const ir::Origin& origin = module_.origins[id.index];
    line_ = "// ";
    std::string_view own = function_.display_name;
    if (!origin.block.empty() && !own.starts_with(origin.block)) {
      AppendComment(own, line_);
      line_ += ", of ";
    }
    AppendComment(origin.block.empty() ? origin.node : origin.block, line_);
    if (!origin.source.empty()) {
      line_ += " (";
      AppendComment(origin.source, line_);
      line_ += ')';
    }
    out_.Line(line_);
  }
  ClaimParameters();
  std::vector<std::string> parameters;
  for (size_t i = 0; i < function_.parameters.size(); ++i) {
    parameters.push_back(
        names_.Declaration(function_.parameters[i].type, expressions_.ParameterName(i)));
  }
  out_.Line(Signature(name, std::move(parameters)));
  PrintStatements();
}

void FunctionPrinter::PrintMain() {
  for (size_t i = 0; i < function_.results.size(); ++i) {
    targets_.push_back(names_.Output(i));
    locals_.Block(targets_.back());
  }
  out_.Line("void main() {");
  PrintStatements();
}

void FunctionPrinter::PrintShaderFunction(const std::vector<GlobalId>& inputs) {
  std::vector<std::string> parameters;
  for (GlobalId input : inputs) {
    locals_.Block(names_.Global(input));
    parameters.push_back(
        names_.Declaration(module_.globals[input.index].type, names_.Global(input)));
  }
  out_.Line(Signature(names_.Shader(), std::move(parameters)));
  PrintStatements();
}

// --- Statements ----------------------------------------------------------------------------------

void FunctionPrinter::OpenScope() {
  locals_.Open();
  out_.Indent();
}

void FunctionPrinter::CloseScope() {
  locals_.Close();
  out_.Outdent();
}

void FunctionPrinter::PrintStatements() {
  out_.Indent();
  for (size_t position = 0; position < schedule_.size();) position = PrintStatement(position);
  out_.Outdent();
  out_.Line("}");
}

// Prints the statement at `position`; returns the next one's.
size_t FunctionPrinter::PrintStatement(size_t position) {
  const Statement& statement = schedule_[position];
  if (!plan_.reuse) PrintOrigin(statement);
  DeclareBefore(position);
  if (plan_.reuse) PrintOrigin(statement);
  switch (statement.kind) {
    case Kind::kDefine:
      return PrintDefinition(position);
    case Kind::kCall:
      PrintCall(statement, position);
      break;
    case Kind::kIfInit:
    case Kind::kThenEnd:
    case Kind::kElseEnd:
    case Kind::kLoopInit:
    case Kind::kLoopNext:
      PrintAssignments(position);
      break;
    case Kind::kIf:
      if (schedule_.StyleOf(statement.value) == IfStyle::kLoopCondition) break;
      out_.Line(IfLine(statement.value));
      OpenScope();
      break;
    case Kind::kElse:
      return PrintElse(position);
    case Kind::kIfEnd:
      if (merged_[function_[statement.value].aux]) break;
      if (schedule_.StyleOf(statement.value) == IfStyle::kLoopCondition) break;
      CloseScope();
      out_.Line("}");
      break;
    case Kind::kLoop:
      PrintLoop(statement);
      break;
    case Kind::kLoopEnd:
      CloseScope();
      out_.Line("}");
      break;
    case Kind::kReturn:
      PrintReturn();
      break;
  }
  return position + 1;
}

// "// face: layer (layers/layer.glsl)" ahead of the first statement of a node.
void FunctionPrinter::PrintOrigin(const Statement& statement) {
  bool starts = statement.kind == Kind::kDefine || statement.kind == Kind::kCall ||
                statement.kind == Kind::kIfInit || statement.kind == Kind::kIf ||
                statement.kind == Kind::kLoopInit;
  if (!starts) return;
  ir::OriginId id = function_.OriginOf(statement.value);
  if (!id) return;
  const ir::Origin& origin = module_.origins[id.index];
  if (origin.node.empty() || origin.node == node_) return;
  node_ = origin.node;
  line_ = "// ";
  AppendComment(origin.node, line_);
  if (!origin.block.empty()) {
    line_ += ": ";
    AppendComment(origin.block, line_);
  }
  if (!origin.source.empty()) {
    line_ += " (";
    AppendComment(origin.source, line_);
    line_ += ')';
  }
  out_.Line(line_);
}

bool FunctionPrinter::Declares(VariableId v, size_t position) const {
  const Variable& variable = plan_.variables[v];
  return variable.declared_at == position && !variable.declared_before;
}

bool FunctionPrinter::HasDeclarationsBefore(size_t position) const {
  const std::vector<VariableId>& all = plan_.variables.DeclaredBefore();
  return next_declared_ < all.size() &&
         plan_.variables[all[next_declared_]].declared_at <= position;
}

void FunctionPrinter::DeclareBefore(size_t position) {
  const std::vector<VariableId>& all = plan_.variables.DeclaredBefore();
  std::vector<VariableId> here;
  for (; HasDeclarationsBefore(position); ++next_declared_) here.push_back(all[next_declared_]);
  DeclareTogether(here);
}

// Variables without a value; those of one type share a declaration.
void FunctionPrinter::DeclareTogether(const std::vector<VariableId>& variables) {
  std::vector<std::pair<TypeId, std::string>> lines;
  for (VariableId v : variables) {
    TypeId type = plan_.variables[v].type;
    std::string_view name = NameVariable(v);
    auto line = std::ranges::find(lines, type, [](const auto& l) { return l.first; });
    if (line == lines.end() || module_.types.Kind(type) == ir::TypeKind::kArray) {
      lines.emplace_back(type, names_.Declaration(type, name));
    } else {
      line->second += ", ";
      line->second += name;
    }
  }
  for (const auto& [type, line] : lines) out_.Line(line + ";");
}

size_t FunctionPrinter::PrintDefinition(size_t position) {
  ValueId v = schedule_[position].value;
  VariableId variable = plan_.variables.Of(v);
  line_.clear();
  if (!Declares(variable, position)) {
    expressions_.AppendAssignment(variable, v, true, line_);
    line_ += ';';
    out_.Line(line_);
    return position + 1;
  }
  names_.AppendDeclaration(function_[v].type, NameVariable(variable), line_);
  line_ += " = ";
  expressions_.AppendDefinition(v, line_);
  // Both derivatives of one value stand together.
  const Statement& next = schedule_[position + 1];
  if (function_[v].op == Op::kDfdx && next.kind == Kind::kDefine &&
      function_[next.value].op == Op::kDfdy &&
      function_.Operands(next.value)[0] == function_.Operands(v)[0] &&
      Declares(plan_.variables.Of(next.value), position + 1) &&
      !HasDeclarationsBefore(position + 1)) {
    line_ += ", ";
    line_ += NameVariable(plan_.variables.Of(next.value));
    line_ += " = ";
    expressions_.AppendDefinition(next.value, line_);
    ++position;
  }
  line_ += ';';
  out_.Line(line_);
  return position + 1;
}

void FunctionPrinter::PrintCall(const Statement& statement, size_t position) {
  ValueId v = statement.value;
  const Inst& inst = function_[v];
  const ir::Function& callee = module_[FunctionId(inst.aux)];
  std::string line, arguments;
  for (ValueId operand : function_.Operands(inst)) {
    if (!arguments.empty()) arguments += ", ";
    expressions_.Append(operand, Precedence::kConditional, arguments);
  }
  const bool has_return = callee.results[0].name.empty();
  std::vector<VariableId> declared;
  for (uint32_t r = has_return; r < callee.results.size(); ++r) {
    VariableId variable = plan_.variables.OfResult(v, r);
    if (Declares(variable, position)) declared.push_back(variable);
  }
  DeclareTogether(declared);
  for (uint32_t r = has_return; r < callee.results.size(); ++r) {
    if (!arguments.empty()) arguments += ", ";
    arguments += expressions_.NameOf(plan_.variables.OfResult(v, r));
  }
  if (VariableId returned = has_return ? plan_.variables.OfResult(v, 0) : VariableId()) {
    bool declares = Declares(returned, position);
    std::string_view name = declares ? NameVariable(returned) : expressions_.NameOf(returned);
    line = declares ? names_.Declaration(callee.results[0].type, name) : std::string(name);
    line += " = ";
  }
  out_.Line(line + names_.Function(FunctionId(inst.aux)) + "(" + arguments + ");");
}

std::string FunctionPrinter::IfLine(ValueId branch) const {
  std::string line = "if (";
  ValueId condition = function_.Operands(branch)[0];
  if (schedule_.StyleOf(branch) == IfStyle::kElseOnly) {
    expressions_.AppendNegation(condition, line);
  } else {
    expressions_.Append(condition, Precedence::kAnything, line);
  }
  return line + ") {";
}

// "} else {", or "} else if (...) {" where the second side is just another if.
size_t FunctionPrinter::PrintElse(size_t position) {
  CloseScope();
  size_t inner = position + 1;
  if (schedule_[inner].kind == Kind::kIfInit && AssignmentsAt(inner).empty()) ++inner;
  bool merges = schedule_[inner].kind == Kind::kIf && !HasDeclarationsBefore(inner);
  if (merges) {
    size_t end = schedule_.IfEnd(schedule_[inner].value);
    merges = schedule_[end + 1].kind == Kind::kElseEnd &&
             schedule_[end + 1].value == schedule_[position].value &&
             AssignmentsAt(end + 1).empty();
  }
  if (merges) {
    ValueId branch = schedule_[inner].value;
    merged_[function_[branch].aux] = true;
    out_.Line("} else " + IfLine(branch));
  } else {
    out_.Line("} else {");
  }
  OpenScope();
  return merges ? inner + 1 : position + 1;
}

void FunctionPrinter::PrintLoop(const Statement& statement) {
  const ir::ForLoop& loop = function_.loops[function_[statement.value].aux];
  VariableId index = plan_.variables.OfIndex(statement.value);
  locals_.Open();
  std::string_view claimed = ClaimIndex(plan_.variables[index]);
  expressions_.SetName(index, claimed);
  const std::string name(claimed);
  std::string also;
  if (ValueId branch = schedule_.ConditionOf(loop.body)) {
    also = " && ";
    expressions_.Append(function_.Operands(branch)[0], Precedence::kAnd, also);
  }
  const int64_t after = int64_t(loop.first) + int64_t(loop.Trips()) * loop.step;
  if (after > INT32_MAX || after < INT32_MIN) {
    // The index would wrap before it reaches the end, so the rounds are counted.
    std::string round(Claim("turn", false));
    out_.Line("for (int " + round + " = 0; " + round + " < " + std::to_string(loop.Trips()) + also +
              "; ++" + round + ") {");
    out_.Indent();
    out_.Line("int " + name + " = " + std::to_string(loop.first) + " + " + round + " * " +
              (loop.step < 0 ? "(" + std::to_string(loop.step) + ")" : std::to_string(loop.step)) +
              ";");
    return;
  }
  std::string step = loop.step == 1    ? "++" + name
                     : loop.step == -1 ? "--" + name
                     : loop.step > 0   ? name + " += " + std::to_string(loop.step)
                                       : name + " -= " + std::to_string(-int64_t(loop.step));
  out_.Line("for (int " + name + " = " + std::to_string(loop.first) + "; " + name +
            (loop.step > 0 ? " < " : " > ") + std::to_string(loop.last) + also + "; " + step +
            ") {");
  out_.Indent();
}

void FunctionPrinter::PrintReturn() {
  const std::vector<ValueId>& results = function_.Body().results;
  std::string returned;
  for (size_t i = 0; i < results.size(); ++i) {
    std::string line = targets_[i].empty() ? "return " : targets_[i] + " = ";
    expressions_.Append(results[i], Precedence::kAnything, line);
    line += ';';
    if (targets_[i].empty()) {
      returned = line;
    } else {
      out_.Line(line);
    }
  }
  if (!returned.empty()) out_.Line(returned);
}

}  // namespace texgraph::glsl
