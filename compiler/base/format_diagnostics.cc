// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "compiler/base/diagnostics.h"
#include "compiler/base/format_text.h"

namespace texgraph {
namespace {

constexpr uint32_t kWindowColumns = 160;  // of a line that are shown
constexpr uint32_t kLeadColumns = 80;     // of them before the place, if the line is longer
constexpr uint32_t kTabWidth = 4;
constexpr size_t kMaxMessageBytes = 4000;

struct Colors {
  std::string_view bold, error, warning, note, caret, reset;
};
constexpr Colors kPlain{};
constexpr Colors kColored{"\x1b[1m",    "\x1b[1;31m", "\x1b[1;35m",
                          "\x1b[1;36m", "\x1b[1;32m", "\x1b[0m"};

ShownCharacter ShowInLine(std::string_view line, size_t at, uint32_t column) {
  if (line[at] != '\t') return ShowCharacter(line, at);
  uint32_t columns = kTabWidth - column % kTabWidth;
  return {std::string(columns, ' '), columns, 1};
}

uint32_t ColumnsBetween(std::string_view line, size_t from, size_t to) {
  uint32_t columns = 0;
  for (size_t at = from; at < to;) {
    ShownCharacter shown = ShowInLine(line, at, columns);
    columns += shown.columns;
    at += shown.bytes;
  }
  return columns;
}

// Where to begin showing `line`, so that the byte at `place` is within the window.
size_t WindowBegin(std::string_view line, size_t place) {
  if (line.size() <= kWindowColumns && ColumnsBetween(line, 0, line.size()) <= kWindowColumns)
    return 0;
  size_t begin = place > kLeadColumns ? place - kLeadColumns : 0;
  auto inside_character = [&](size_t at) {
    return at < place && (static_cast<uint8_t>(line[at]) & 0xc0) == 0x80;
  };
  while (inside_character(begin)) ++begin;
  while (ColumnsBetween(line, begin, place) > kLeadColumns) {
    ++begin;
    while (inside_character(begin)) ++begin;
  }
  return begin;
}

// The line of the place and, below it, carets under the bytes from `place` to `place_end`.
void AppendSnippet(std::string& out, uint32_t number, std::string_view line, size_t place,
                   size_t place_end, const Colors& colors) {
  constexpr std::string_view kEllipsis = "...";
  size_t begin = WindowBegin(line, place);
  std::string text(begin > 0 ? kEllipsis : std::string_view());
  uint32_t prefix = static_cast<uint32_t>(text.size()), column = prefix;
  uint32_t first_caret = UINT32_MAX, last_caret = 0;
  size_t at = begin;
  while (at < line.size() && column < kWindowColumns) {
    ShownCharacter shown = ShowInLine(line, at, column - prefix);
    if (at + shown.bytes > place && at < place_end) {
      first_caret = std::min(first_caret, column);
      last_caret = column + std::max(shown.columns, 1u);
    }
    text += shown.text;
    column += shown.columns;
    at += shown.bytes;
  }
  if (first_caret == UINT32_MAX) {  // an empty range, or the end of the line
    first_caret = column;
    last_caret = column + 1;
    if (place < at)
      first_caret = prefix + ColumnsBetween(line, begin, place), last_caret = first_caret + 1;
  }
  if (at < line.size()) text += kEllipsis;
  while (!text.empty() && text.back() == ' ') text.pop_back();
  fmt::format_to(std::back_inserter(out), "{:5} |{}{}\n      | {:{}}{}^{:~<{}}{}\n", number,
                 text.empty() ? "" : " ", text, "", first_caret, colors.caret, "",
                 last_caret - first_caret - 1, colors.reset);
}

void AppendOne(std::string& out, const Sources& sources, SourceRange range, std::string_view label,
               std::string_view label_color, std::string_view message, std::string_view name,
               const Colors& colors) {
  bool placed = range.source.valid() && range.source.index < sources.size();
  LineColumn place;
  uint32_t begin = 0;
  if (placed) {
    begin =
        std::min<uint32_t>(range.begin, static_cast<uint32_t>(sources.Text(range.source).size()));
    place = sources.Locate(range.source, begin);
    fmt::format_to(std::back_inserter(out), "{}{}:{}:{}:{} ", colors.bold,
                   Printable(sources.Name(range.source), 1000), place.line, place.column,
                   colors.reset);
  }
  bool is_note = name.empty();
  fmt::format_to(std::back_inserter(out), "{}{}:{} {}{}{}", label_color, label, colors.reset,
                 is_note ? "" : colors.bold, Printable(message, kMaxMessageBytes),
                 is_note ? "" : colors.reset);
  if (!is_note) fmt::format_to(std::back_inserter(out), " [{}]", name);
  out += '\n';
  if (!placed) return;
  std::string_view line = sources.Line(range.source, begin);
  size_t in_line = std::min<size_t>(place.column - 1, line.size());
  size_t length = range.end > begin ? range.end - begin : 0;
  AppendSnippet(out, place.line, line, in_line, std::min(in_line + length, line.size()), colors);
}

void AppendLeftOut(std::string& out, size_t count, size_t shown, std::string_view what) {
  if (count <= shown) return;
  size_t more = count - shown;
  fmt::format_to(std::back_inserter(out), "{} more {}{} not shown\n", more, what,
                 more == 1 ? "" : "s");
}

}  // namespace

std::string FormatDiagnostics(const Diagnostics& diagnostics, const Sources& sources, bool color) {
  const Colors& colors = color ? kColored : kPlain;
  std::string out;
  size_t errors = 0;
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    bool error = diagnostic.severity == Severity::kError;
    errors += error;
    AppendOne(out, sources, diagnostic.range, error ? "error" : "warning",
              error ? colors.error : colors.warning, diagnostic.message,
              DiagnosticName(diagnostic.kind), colors);
    for (const Diagnostic::Note& note : diagnostic.notes) {
      AppendOne(out, sources, note.range, "note", colors.note, note.message, "", colors);
    }
  }
  AppendLeftOut(out, diagnostics.error_count(), errors, "error");
  AppendLeftOut(out, diagnostics.warning_count(), diagnostics.all().size() - errors, "warning");
  return out;
}

}  // namespace texgraph
