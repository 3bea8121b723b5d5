// SPDX-License-Identifier: Apache-2.0
// Everything that texgraph tells a user about a mistake. Each kind is registered in diagnostics.def
// with a stable name and the class of its exit code; a test fails when a kind has no test. Wording:
// lower case, one sentence, no full stop; names of the user's in single quotes; say what was seen
// and what would do; a note for the second place.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/base/source.h"

namespace texgraph {

// Exit codes of both programs.
enum class ExitCode {
  kOk = 0,
  kInvalid = 1,   // the graph, a block or an image is wrong
  kUsage = 2,     // the command line is wrong
  kIo = 3,        // something could not be read or written
  kLimit = 4,     // a stated limit was reached
  kRuntime = 5,   // no rendering context, or the driver failed
  kInternal = 70  // a mistake of texgraph's own
};

enum class DiagnosticKind : uint16_t {
#define DIAGNOSTIC(id, name, exit) id,
#include "compiler/base/diagnostics.def"
#undef DIAGNOSTIC
};

std::string_view DiagnosticName(DiagnosticKind kind);  // "unknown-block"
ExitCode DiagnosticExit(DiagnosticKind kind);
size_t DiagnosticKindCount();

enum class Severity : uint8_t { kError, kWarning };

struct Diagnostic {
  struct Note {
    SourceRange range;
    std::string message;
  };
  DiagnosticKind kind;
  Severity severity = Severity::kError;
  SourceRange range;
  std::string message;
  std::deque<Note> notes;

  // Adds a second place or a piece of advice; returns itself for chaining.
  Diagnostic& AddNote(SourceRange where, std::string text) {
    notes.push_back({where, std::move(text)});
    return *this;
  }
};

// Collects diagnostics in the order in which they were found. Phases go on after an error where
// they can, so that all mistakes of a file are reported at once; after kMaxErrors (kMaxWarnings)
// only the count goes on.
class Diagnostics {
 public:
  static constexpr size_t kMaxErrors = 100;
  static constexpr size_t kMaxWarnings = 100;

  Diagnostic& Error(DiagnosticKind kind, SourceRange range, std::string message);
  Diagnostic& Warn(DiagnosticKind kind, SourceRange range, std::string message);

  bool HasErrors() const { return error_count_ > 0; }
  size_t error_count() const { return error_count_; }
  size_t warning_count() const { return warning_count_; }
  // Further errors are only counted: the search for a near name, say, is not worth its time any
  // more.
  bool full() const { return error_count_ >= kMaxErrors; }
  const std::deque<Diagnostic>& all() const { return all_; }
  // The class of the first error, kOk if there is none.
  ExitCode exit_code() const;
  void Append(Diagnostics other);
  void DropWarnings();     // -w
  void PromoteWarnings();  // -Werror: each becomes an error in its place

 private:
  Diagnostic& Add(Diagnostic diagnostic);

  std::deque<Diagnostic> all_;
  Diagnostic overflow_{};
  DiagnosticKind first_error_{};
  size_t error_count_ = 0;
  size_t warning_count_ = 0;
};

// The text for a terminal or a file:
//   brick.json:14:9: error: port 'height' of node 'warp' takes float, got vec3 [port-type]
//        14 |   "height": "noise.gradient",
//           |             ^~~~~~~~~~~~~~~~
//   warp.glsl:3:21: note: the port is declared here
// Control characters, invalid UTF-8 and characters that reverse or hide text are escaped, also in
// names and lines. Long lines are shown in part, around the place. A count of what was left out
// comes last.
std::string FormatDiagnostics(const Diagnostics& diagnostics, const Sources& sources, bool color);

// The name among `candidates` that is nearest to `seen`, if it is near enough to be meant; else "".
// Nearness is edits (insert, remove, replace, swap neighbours), small and capital letters being
// equal; the first of equals.
std::string_view NearestName(std::string_view seen,
                             const std::vector<std::string_view>& candidates);
// "; did you mean 'row_offset'?" or "".
std::string DidYouMean(std::string_view seen, const std::vector<std::string_view>& candidates);
// `text` with control characters, invalid UTF-8 and bidirectional controls escaped, cut to `limit`
// bytes with an ellipsis.
std::string Printable(std::string_view text, size_t limit = 200);

}  // namespace texgraph
