// SPDX-License-Identifier: Apache-2.0
#include "compiler/base/diagnostics.h"

#include <array>
#include <utility>

namespace texgraph {
namespace {

struct KindEntry {
  std::string_view name;
  ExitCode exit;
};

constexpr auto kKinds = std::to_array<KindEntry>({
#define DIAGNOSTIC(id, name, exit) {name, ExitCode::exit},
#include "compiler/base/diagnostics.def"
#undef DIAGNOSTIC
});

}  // namespace

std::string_view DiagnosticName(DiagnosticKind kind) {
  return kKinds[static_cast<size_t>(kind)].name;
}

ExitCode DiagnosticExit(DiagnosticKind kind) { return kKinds[static_cast<size_t>(kind)].exit; }

size_t DiagnosticKindCount() { return kKinds.size(); }

Diagnostic& Diagnostics::Add(Diagnostic diagnostic) {
  bool error = diagnostic.severity == Severity::kError;
  size_t& count = error ? error_count_ : warning_count_;
  if (error && error_count_ == 0) first_error_ = diagnostic.kind;
  if (++count > (error ? kMaxErrors : kMaxWarnings)) {
    // The caller may chain notes to it; the next one that is too many takes its place.
    overflow_ = std::move(diagnostic);
    return overflow_;
  }
  all_.push_back(std::move(diagnostic));
  return all_.back();
}

Diagnostic& Diagnostics::Error(DiagnosticKind kind, SourceRange range, std::string message) {
  return Add({kind, Severity::kError, range, std::move(message), {}});
}

Diagnostic& Diagnostics::Warn(DiagnosticKind kind, SourceRange range, std::string message) {
  return Add({kind, Severity::kWarning, range, std::move(message), {}});
}

ExitCode Diagnostics::exit_code() const {
  return error_count_ > 0 ? DiagnosticExit(first_error_) : ExitCode::kOk;
}

void Diagnostics::Append(Diagnostics other) {
  size_t errors = error_count_ + other.error_count_;
  size_t warnings = warning_count_ + other.warning_count_;
  for (Diagnostic& diagnostic : other.all_) Add(std::move(diagnostic));
  error_count_ = errors;
  warning_count_ = warnings;
}

void Diagnostics::DropWarnings() {
  std::erase_if(all_, [](const Diagnostic& d) { return d.severity == Severity::kWarning; });
  warning_count_ = 0;
}

void Diagnostics::PromoteWarnings() {
  for (Diagnostic& diagnostic : all_) diagnostic.severity = Severity::kError;
  if (!all_.empty()) first_error_ = all_.front().kind;
  error_count_ += warning_count_;
  warning_count_ = 0;
}

}  // namespace texgraph
