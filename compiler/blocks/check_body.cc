// SPDX-License-Identifier: Apache-2.0
// What all parts of the checker use: making typed expressions, conversions, scopes.
#include "compiler/blocks/check_body.h"

#include <bit>

#include "compiler/base/text.h"
#include "compiler/blocks/lower.h"

namespace texgraph::blocks {

using ir::Op;
using ir::TypeId;

BodyChecker::BodyChecker(Program& program, TypedFunction& function, bool anywhere)
    : program_(program),
      file_(*function.file),
      types_(program.module.types),
      function_(function),
      anywhere_(anywhere) {}

Diagnostic& BodyChecker::Error(DiagnosticKind kind, SourceRange range, std::string message) {
  failed_ = true;
  return program_.diagnostics.Error(kind, range, std::move(message));
}

SourceRange BodyChecker::RangeOf(TypedId id) const {
  const TypedExpr& expr = function_.exprs[id.index];
  return {file_.source, expr.begin, expr.end};
}

// --- Typed expressions
// -------------------------------------------------------------------------------------------

TypedId BodyChecker::Add(TypedExpr expr, std::span<const TypedId> children, SourceRange range) {
  for (TypedId child : children) {
    if (!child) return {};
  }
  expr.begin = range.begin;
  expr.end = range.end;
  expr.first_child = static_cast<uint32_t>(function_.children.size());
  expr.child_count = static_cast<uint32_t>(children.size());
  function_.children.insert(function_.children.end(), children.begin(), children.end());
  function_.exprs.push_back(expr);
  return TypedId(function_.exprs.size() - 1);
}

TypedId BodyChecker::AddOp(Op op, TypeId type, std::initializer_list<TypedId> children,
                           SourceRange range, uint32_t aux) {
  TypedExpr expr;
  expr.kind = TypedKind::kOp;
  expr.op = op;
  expr.type = type;
  expr.aux = aux;
  return Add(expr, {children.begin(), children.size()}, range);
}

TypedId BodyChecker::AddComposite(Composite composite, TypeId type,
                                  std::span<const TypedId> children, SourceRange range, Op op) {
  TypedExpr expr;
  expr.kind = TypedKind::kComposite;
  expr.composite = composite;
  expr.op = op;
  expr.type = type;
  return Add(expr, children, range);
}

TypedId BodyChecker::AddConstant(TypeId type, std::span<const uint32_t> words, SourceRange range) {
  TypedExpr expr;
  expr.kind = TypedKind::kConstant;
  expr.type = type;
  expr.aux = program_.module.Intern(type, words).index;
  return Add(expr, {}, range);
}

TypedId BodyChecker::AddScalar(TypeId type, uint32_t word, SourceRange range) {
  return AddConstant(type, {&word, 1}, range);
}

TypedId BodyChecker::AddConstruct(TypeId type, std::span<const TypedId> parts, SourceRange range) {
  TypedExpr expr;
  expr.kind = TypedKind::kConstruct;
  expr.type = type;
  return Add(expr, parts, range);
}

TypedId BodyChecker::ElementOf(TypedId aggregate, uint32_t index) {
  TypeId type = TypeOf(aggregate);
  if (ir::IsScalar(type)) return aggregate;
  return AddOp(Op::kExtract, types_.ElementType(type, index), {aggregate}, RangeOf(aggregate),
               index);
}

TypedId BodyChecker::Prefix(TypedId vector, uint32_t width) {
  if (ir::Width(TypeOf(vector)) == width) return vector;
  if (width == 1) return ElementOf(vector, 0);
  TypedExpr expr;
  expr.kind = TypedKind::kSwizzle;
  expr.type = ir::WithWidth(TypeOf(vector), width);
  expr.aux = 0b11100100;  // xyzw
  return Add(expr, {{vector}}, RangeOf(vector));
}

TypedId BodyChecker::SplatTo(TypedId scalar, TypeId vector) {
  if (!scalar || TypeOf(scalar) == vector) return scalar;
  return AddOp(Op::kSplat, vector, {scalar}, RangeOf(scalar));
}

// --- Conversions
// -------------------------------------------------------------------------------------------------

bool ConvertsTo(const ir::Types& types, TypeId from, TypeId to) {
  if (from == to) return true;
  if (IsUnsized(types, to)) {
    return types.Kind(from) == ir::TypeKind::kArray &&
           types.ElementType(from, 0) == types.ElementType(to, 0);
  }
  if (!ir::IsVector(from) || !ir::IsVector(to) || ir::Width(from) != ir::Width(to)) return false;
  ir::Scalar a = ir::ScalarOf(from), b = ir::ScalarOf(to);
  return (a == ir::Scalar::kInt && (b == ir::Scalar::kUint || b == ir::Scalar::kFloat)) ||
         (a == ir::Scalar::kUint && b == ir::Scalar::kFloat);
}

TypedId BodyChecker::ConvertTo(TypedId value, TypeId type) {
  if (!value || TypeOf(value) == type || IsUnsized(types_, type)) return value;
  const TypedExpr expr = function_.exprs[value.index];
  // A literal is written in the type that it is used as.
  if (expr.kind == TypedKind::kConstant && ir::IsScalar(type) && !ir::IsBool(expr.type)) {
    uint32_t word = program_.module.Words(ir::ConstId(expr.aux))[0];
    if (type == ir::kUint && expr.type == ir::kInt) return AddScalar(type, word, RangeOf(value));
    if (type == ir::kFloat) {
      float real = expr.type == ir::kInt ? static_cast<float>(static_cast<int32_t>(word))
                                         : static_cast<float>(word);
      return AddScalar(type, std::bit_cast<uint32_t>(real), RangeOf(value));
    }
  }
  return AddOp(Op::kConvert, type, {value}, RangeOf(value));
}

TypedId BodyChecker::Coerce(TypedId value, TypeId type, std::string_view what) {
  if (!value || !type || !TypeOf(value)) return {};
  if (ConvertsTo(types_, TypeOf(value), type)) return ConvertTo(value, type);
  Error(DiagnosticKind::kBlockType, RangeOf(value),
        std::string(what) + " must be " + Text(type) + ", got " + Text(TypeOf(value)));
  return {};
}

TypedId BodyChecker::CheckAs(const Expr& expr, TypeId type, std::string_view what) {
  return Coerce(Check(expr), type, what);
}

// --- Scopes
// ------------------------------------------------------------------------------------------------------

uint32_t BodyChecker::FindSlot(std::string_view name) const {
  auto found = names_.find(name);
  return found == names_.end() ? kNoSlot : found->second;
}

uint32_t BodyChecker::AddSlot(std::string_view name, TypeId type, SourceRange range,
                              bool is_fixed) {
  uint32_t slot = static_cast<uint32_t>(function_.slots.size());
  function_.slots.push_back({name, type, range, is_fixed, false});
  slot_scopes_.push_back(static_cast<uint32_t>(scopes_.size()));
  if (slot == kMaxLocals) {
    Error(DiagnosticKind::kSizeLimit, range,
          "this function has more than 4096 variables; make functions of its parts");
  }
  if (name.empty()) return slot;
  if (!blocks::CheckName(program_.diagnostics, name, range, false)) failed_ = true;
  uint32_t before = FindSlot(name);
  if (before != kNoSlot && slot_scopes_[before] == scopes_.size()) {
    Error(DiagnosticKind::kBlockName, range, "'" + std::string(name) + "' is declared twice")
        .AddNote(function_.slots[before].range, "the first time is here");
  }
  hidden_.push_back({name, before});
  names_[name] = slot;
  return slot;
}

void BodyChecker::CloseScope() {
  for (size_t mark = scopes_.back(); hidden_.size() > mark; hidden_.pop_back()) {
    const Hidden& hidden = hidden_.back();
    if (hidden.slot == kNoSlot) {
      names_.erase(hidden.name);
    } else {
      names_[hidden.name] = hidden.slot;
    }
  }
  scopes_.pop_back();
}

// --- A function
// --------------------------------------------------------------------------------------------------

void BodyChecker::CheckFunction(const FunctionInfo& info, const Signature& signature) {
  signature_ = &signature;
  for (const SignatureParameter& parameter : signature.parameters) {
    AddSlot(parameter.name, parameter.type, parameter.range, parameter.is_template);
  }
  list_ = &function_.body;
  for (const Stmt* stmt : info.ast->body->body) CheckInto(*stmt, function_.body);
  bool ends = false;
  for (const TypedStmt& stmt : function_.body) ends = ends || stmt.ends;
  if (!ends && signature.result != ir::kVoid && !failed_) {
    Error(DiagnosticKind::kBlockType, info.ast->range,
          "'" + std::string(info.ast->name) + "' may end without returning a value");
  }
  for (size_t i = 0; i < signature.parameters.size(); ++i) {
    const SignatureParameter& parameter = signature.parameters[i];
    if (parameter.is_in || function_.slots[i].is_assigned || failed_) continue;
    Error(DiagnosticKind::kBlockType, parameter.range,
          "'" + std::string(parameter.name) + "' is never given a value");
  }
  function_.valid = !failed_;
}

const TypedFunction* CheckBody(Program& program, File& file, uint32_t function, TypeId gen_type) {
  FunctionInfo& info = file.functions[function];
  if (!info.needs_gen_type) gen_type = {};
  std::unique_ptr<TypedFunction>& body = info.bodies[Variant(gen_type)];
  if (!body) {
    body = std::make_unique<TypedFunction>();
    body->file = &file;
    body->function = function;
    body->gen_type = gen_type;
    const Signature& signature = info.signatures[info.is_generic ? Variant(gen_type) : 0];
    if (signature.valid) BodyChecker(program, *body).CheckFunction(info, signature);
  }
  return body->valid ? body.get() : nullptr;
}

ir::ConstId CheckConstant(Program& program, File& file, const Expr& expr, TypeId type, bool splat,
                          DiagnosticKind kind) {
  TypedFunction function;
  function.file = &file;
  Diagnostics found;
  std::swap(found, program.diagnostics);
  BodyChecker checker(program, function, kind == DiagnosticKind::kBlockDoc);
  TypedId value = checker.Check(expr);
  TypeId scalar = ir::IsVector(type) ? ir::ScalarType(type) : type;
  bool splats = splat && value && scalar != type &&
                ConvertsTo(program.module.types, checker.TypeOf(value), scalar);
  value = checker.Coerce(value, splats ? scalar : type, "the value");
  if (splats) value = checker.SplatTo(value, type);
  std::swap(found, program.diagnostics);
  if (value) {
    ir::ConstId constant = EvaluateConstant(program.module, function, value);
    if (!constant) {
      program.diagnostics.Error(kind, expr.range, "this is not a constant, or has no finite value");
    }
    return constant;
  }
  // Mistakes in documentation are all of one kind. Where nothing was found, it was reported before.
  if (kind != DiagnosticKind::kBlockDoc) {
    program.diagnostics.Append(std::move(found));
  } else if (found.HasErrors()) {
    program.diagnostics.Error(kind, expr.range, found.all().front().message);
  }
  return {};
}

bool CheckName(Diagnostics& diagnostics, std::string_view name, SourceRange range,
               bool is_function) {
  const auto refuse = [&](std::string_view why) {
    diagnostics.Error(DiagnosticKind::kBlockName, range,
                      "'" + Printable(name, 60) + "' " + std::string(why));
    return false;
  };
  if (name.starts_with("gl_") || name.find("__") != std::string_view::npos) {
    return refuse("is reserved: GLSL keeps 'gl_' and '__' for itself");
  }
  if (name.size() > 255) {
    diagnostics.Error(DiagnosticKind::kBlockName, range, "this name is longer than 255 letters");
    return false;
  }
  if (FindBuiltin(name) != nullptr) {
    return is_function ? refuse("is the name of a built-in function") : true;
  }
  return IsReservedInGlsl(name) ? refuse("is a reserved word of GLSL") : true;
}

}  // namespace texgraph::blocks
