// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "compiler/base/text.h"
#include "compiler/blocks/check_body.h"

namespace texgraph::blocks {

using ir::TypeId;

namespace {

std::string Quoted(std::string_view name) { return "'" + Printable(name, 60) + "'"; }

}  // namespace

TypedId BodyChecker::CheckCall(const Expr& expr, bool whole) {
  if (expr.type) {
    uint32_t length = static_cast<uint32_t>(expr.args.size());
    return CheckConstructor(expr,
                            ResolveType(program_, file_, *expr.type, function_.gen_type, length));
  }
  if (uint32_t slot = FindSlot(expr.name); slot != kNoSlot) {
    Error(DiagnosticKind::kBlockName, expr.name_range,
          Quoted(expr.name) + " is a variable here, not a function")
        .AddNote(function_.slots[slot].range, "it is declared here");
    return {};
  }
  const File* shared = program_.SharedFile();
  bool is_basic = types_.Find(expr.name) && types_.Find(expr.name).index < ir::kBasicTypeCount;
  bool is_type = is_basic || expr.name == "genType" || file_.structs.contains(expr.name) ||
                 (shared && shared->structs.contains(expr.name));
  if (is_type) {
    TypeName name;
    name.name = expr.name;
    name.range = expr.name_range;
    return CheckConstructor(expr, ResolveType(program_, file_, name, function_.gen_type));
  }
  for (uint32_t i = 0; i < file_.fields.size(); ++i) {
    if (file_.fields[i].ast->name == expr.name) return CheckFieldCall(expr, i);
  }
  if (const Builtin* builtin = FindBuiltin(expr.name)) return CheckBuiltin(expr, *builtin);
  if (IsReservedInGlsl(expr.name)) {
    std::string_view advice = BuiltinAdvice(expr.name);
    Error(
        DiagnosticKind::kBlockSubset, expr.name_range,
        "blocks have no " + Quoted(expr.name) + (advice.empty() ? "" : "; " + std::string(advice)));
    return {};
  }
  return CheckFunctionCall(expr, whole);
}

TypedId BodyChecker::CheckFieldCall(const Expr& expr, uint32_t index) {
  const FieldInfo& field = file_.fields[index];
  if (!list_) {
    Error(DiagnosticKind::kBlockConstant, expr.range, "a constant cannot depend on a field");
    return {};
  }
  const Signature& signature = field.signatures[field.is_generic ? Variant(function_.gen_type) : 0];
  if (!signature.valid) return {};
  if (field.ast->whole.begin > expr.range.begin) {
    Error(DiagnosticKind::kBlockName, expr.name_range,
          Quoted(expr.name) + " is declared below; move it up");
    return {};
  }
  std::vector<TypedId> args;
  if (!CheckArguments(expr, args)) return {};
  if (args.size() != signature.parameters.size()) {
    Error(DiagnosticKind::kBlockType, expr.range,
          Quoted(expr.name) + " takes " + std::to_string(signature.parameters.size()) +
              " arguments, got " + std::to_string(args.size()))
        .AddNote(field.ast->range, "it is declared here");
    return {};
  }
  for (size_t i = 0; i < args.size(); ++i) {
    args[i] = Coerce(args[i], signature.parameters[i].type,
                     "'" + std::string(signature.parameters[i].name) + "' of " + Quoted(expr.name));
  }
  TypedExpr result;
  result.kind = TypedKind::kCallField;
  result.type = signature.result;
  result.aux = index;
  return Add(result, args, expr.range);
}

TypedId BodyChecker::CheckFunctionCall(const Expr& expr, bool whole) {
  std::vector<TypedId> args;
  bool sound = CheckArguments(expr, args);
  if (!list_) {
    Error(DiagnosticKind::kBlockConstant, expr.range,
          "a constant cannot call a function that is not built in");
    return {};
  }
  std::vector<Candidate> candidates = FindCandidates(expr);
  if (!sound || candidates.empty()) return {};
  const Candidate* candidate = Choose(expr, candidates, args);
  if (!candidate || !CheckFieldsOf(expr, *candidate)) return {};
  return MakeCall(expr, *candidate, args, whole);
}

// --- Which function
// ----------------------------------------------------------------------------------------------

std::vector<BodyChecker::Candidate> BodyChecker::FindCandidates(const Expr& expr) {
  std::vector<Candidate> candidates;
  if (auto own = file_.functions_by_name.find(expr.name); own != file_.functions_by_name.end()) {
    bool declared = false;
    for (uint32_t function : own->second) {
      if (file_.functions[function].declared_at > expr.range.begin) continue;
      declared = true;
      AddCandidates(file_, function, candidates);
    }
    if (!declared) {
      Error(DiagnosticKind::kBlockName, expr.name_range,
            Quoted(expr.name) + " is declared below; move it up");
    }
    return candidates;
  }
  if (!program_.HasFile(expr.name)) {
    std::vector<std::string_view> known = BuiltinNames();
    for (std::string_view name : program_.FileNames()) known.push_back(name);
    for (const auto& [name, functions] : file_.functions_by_name) known.push_back(name);
    for (const FieldInfo& field : file_.fields) known.push_back(field.ast->name);
    Error(DiagnosticKind::kBlockName, expr.name_range,
          "there is no function or block " + Quoted(expr.name) + DidYouMean(expr.name, known));
    return candidates;
  }
  File* file = program_.FindFile(expr.name);
  failed_ = failed_ || !file;
  for (uint32_t i = 0; file && i < file->functions.size(); ++i) {
    if (file->functions[i].is_block) AddCandidates(*file, i, candidates);
  }
  return candidates;
}

void BodyChecker::AddCandidates(File& file, uint32_t function, std::vector<Candidate>& candidates) {
  const FunctionInfo& info = file.functions[function];
  auto add = [&](TypeId gen_type) {
    const Signature& signature = info.signatures[info.is_generic ? Variant(gen_type) : 0];
    if (signature.valid) candidates.push_back({&file, function, gen_type, &signature});
  };
  if (!info.needs_gen_type) return add({});
  // The fields of one call of the block have one type throughout.
  bool shares_fields = std::ranges::any_of(
      info.fields, [&](uint32_t field) { return file.fields[field].is_generic; });
  if (shares_fields && function_.gen_type) return add(function_.gen_type);
  size_t before = candidates.size();
  for (uint32_t width = 1; width <= 4; ++width) {
    TypeId gen_type = ir::Vector(ir::Scalar::kFloat, width);
    if (!shares_fields || !MissingField(file, info, gen_type)) add(gen_type);
  }
  // None has the fields: the first stands for all in what is reported then.
  if (candidates.size() == before) add(ir::kFloat);
}

// The one that needs the fewest conversions.
const BodyChecker::Candidate* BodyChecker::Choose(const Expr& expr,
                                                  std::span<const Candidate> candidates,
                                                  std::span<const TypedId> args) {
  const Candidate* best = nullptr;
  const Candidate* second = nullptr;
  size_t best_cost = 0;
  for (const Candidate& candidate : candidates) {
    const std::vector<SignatureParameter>& parameters = candidate.signature->parameters;
    if (parameters.size() != args.size()) continue;
    size_t cost = 0;
    bool fits = true;
    for (size_t i = 0; fits && i < args.size(); ++i) {
      TypeId from = TypeOf(args[i]), to = parameters[i].type;
      fits = parameters[i].is_out ? from == to : ConvertsTo(types_, from, to);
      cost += from == to ? 0 : 1;
    }
    if (!fits) continue;
    // Where nothing else decides, genType is the same in both.
    bool same = function_.gen_type && candidate.gen_type == function_.gen_type;
    cost = 2 * cost + (same ? 0 : 1);
    if (!best || cost < best_cost) {
      best = &candidate;
      second = nullptr;
      best_cost = cost;
    } else if (cost == best_cost) {
      second = &candidate;
    }
  }
  if (!best) {
    NoCandidate(expr, candidates, args);
  } else if (second) {
    Error(DiagnosticKind::kBlockType, expr.range,
          "several functions " + Quoted(expr.name) + " fit equally well; convert the arguments")
        .AddNote(best->file->functions[best->function].ast->range, "this one does")
        .AddNote(second->file->functions[second->function].ast->range, "and so does this one");
    return nullptr;
  }
  return best;
}

void BodyChecker::NoCandidate(const Expr& expr, std::span<const Candidate> candidates,
                              std::span<const TypedId> args) {
  const FunctionInfo& first = candidates[0].file->functions[candidates[0].function];
  const std::vector<SignatureParameter>& parameters = candidates[0].signature->parameters;
  if (candidates.size() == 1 && parameters.size() == args.size()) {
    for (size_t i = 0; i < args.size(); ++i) {
      TypeId from = TypeOf(args[i]), to = parameters[i].type;
      if (parameters[i].is_out ? from == to : ConvertsTo(types_, from, to)) continue;
      Error(DiagnosticKind::kBlockType, RangeOf(args[i]),
            "'" + std::string(parameters[i].name) + "' of " + Quoted(expr.name) + " must be " +
                Text(to) + ", got " + Text(from))
          .AddNote(parameters[i].range, "it is declared here");
      return;
    }
  }
  std::string types;
  for (TypedId arg : args) types += (types.empty() ? "" : ", ") + Text(TypeOf(arg));
  Diagnostic& error = Error(DiagnosticKind::kBlockType, expr.range,
                            "no function " + Quoted(expr.name) + " takes (" + types + ")");
  error.AddNote(first.ast->range, "it is declared here");
}

// The first field of another block's function that this file does not have; null if it has them
// all.
const FieldInfo* BodyChecker::MissingField(const File& other, const FunctionInfo& info,
                                           TypeId gen_type) const {
  for (uint32_t index : info.fields) {
    const FieldInfo& wanted = other.fields[index];
    auto own = std::ranges::find(file_.fields, wanted.ast->name,
                                 [](const FieldInfo& field) { return field.ast->name; });
    bool same = own != file_.fields.end() &&
                own->Type(types_, function_.gen_type) == wanted.Type(types_, gen_type);
    if (!same) return &wanted;
  }
  return nullptr;
}

// The fields of another block are the fields of the same names here.
bool BodyChecker::CheckFieldsOf(const Expr& expr, const Candidate& candidate) {
  const File& other = *candidate.file;
  if (&other == &file_) return true;
  const FunctionInfo& info = other.functions[candidate.function];
  const FieldInfo* missing = MissingField(other, info, candidate.gen_type);
  if (!missing) return true;
  Error(DiagnosticKind::kBlockType, expr.range,
        "block " + Quoted(expr.name) + " needs the field " + Quoted(missing->ast->name) + ", " +
            Text(missing->Type(types_, candidate.gen_type)) +
            "; declare the same prototype here to hand it on")
      .AddNote(missing->ast->range, "the field is declared here");
  return false;
}

// --- The call
// ----------------------------------------------------------------------------------------------------

TypedId BodyChecker::MakeCall(const Expr& expr, const Candidate& candidate,
                              std::span<const TypedId> args, bool whole) {
  const Signature& signature = *candidate.signature;
  Callee callee{candidate.file, candidate.function, candidate.gen_type, {}};
  std::vector<TypedId> children;
  std::vector<Place> outs;
  for (size_t i = 0; i < args.size(); ++i) {
    const SignatureParameter& parameter = signature.parameters[i];
    if (parameter.is_out) {
      TypeId type;
      std::optional<Place> place = CheckPlace(*expr.args[i], type);
      if (!place) return {};
      outs.push_back(std::move(*place));
    }
    if (!parameter.is_in) continue;
    TypedId value = ConvertTo(args[i], parameter.type);
    (parameter.is_template ? callee.template_arguments : children).push_back(value);
  }
  TypedExpr call;
  call.kind = TypedKind::kCall;
  call.type = signature.result;
  call.aux = static_cast<uint32_t>(function_.callees.size());
  function_.callees.push_back(std::move(callee));
  TypedId id = Add(call, children, expr.range);
  if (outs.empty()) return id;
  if (!whole) {
    Error(DiagnosticKind::kBlockSubset, expr.range,
          Quoted(expr.name) + " has out parameters, so call it in a statement of its own");
    return {};
  }
  TypedStmt stmt;
  stmt.kind = TypedStmtKind::kCall;
  stmt.value = id;
  stmt.range = expr.range;
  uint32_t result = kNoSlot;
  if (signature.result != ir::kVoid) {
    result = AddSlot("", signature.result, expr.range, true);
    stmt.places.push_back({result, {}});
  }
  for (Place& place : outs) {
    function_.slots[place.slot].is_assigned = true;
    assigned_.push_back(place.slot);
    stmt.places.push_back(std::move(place));
  }
  list_->push_back(std::move(stmt));
  if (result == kNoSlot) return id;
  TypedExpr value;
  value.kind = TypedKind::kSlot;
  value.type = signature.result;
  value.aux = result;
  return Add(value, {}, expr.range);
}

}  // namespace texgraph::blocks
