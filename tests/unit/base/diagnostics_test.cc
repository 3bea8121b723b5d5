// SPDX-License-Identifier: Apache-2.0
#include "compiler/base/diagnostics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace texgraph {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

SourceRange RangeOf(const Sources& sources, SourceId id, std::string_view part) {
  size_t at = sources.Text(id).find(part);
  return {id, static_cast<uint32_t>(at), static_cast<uint32_t>(at + part.size())};
}

TEST(Diagnostics, NamesAreUniqueAndKebabCase) {
  std::set<std::string_view> names;
  for (size_t i = 0; i < DiagnosticKindCount(); ++i) {
    std::string_view name = DiagnosticName(static_cast<DiagnosticKind>(i));
    EXPECT_TRUE(names.insert(name).second) << name;
    bool kebab = std::all_of(name.begin(), name.end(),
                             [](char c) { return (c >= 'a' && c <= 'z') || c == '-'; });
    EXPECT_TRUE(kebab) << name;
  }
}

TEST(Diagnostics, FirstErrorGivesTheExitCode) {
  Diagnostics diagnostics;
  EXPECT_EQ(diagnostics.exit_code(), ExitCode::kOk);
  diagnostics.Warn(DiagnosticKind::kCannotRead, {}, "careful");
  EXPECT_EQ(diagnostics.exit_code(), ExitCode::kOk);
  EXPECT_FALSE(diagnostics.HasErrors());
  diagnostics.Error(DiagnosticKind::kNestingLimit, {}, "too deep");
  diagnostics.Error(DiagnosticKind::kSyntax, {}, "wrong");
  EXPECT_EQ(diagnostics.exit_code(), ExitCode::kLimit);
  EXPECT_EQ(diagnostics.error_count(), 2u);
  EXPECT_EQ(diagnostics.warning_count(), 1u);
}

TEST(Diagnostics, CountsOnAfterTheLimit) {
  Diagnostics diagnostics;
  for (int i = 0; i < 250; ++i) {
    diagnostics.Error(DiagnosticKind::kSyntax, {}, "e" + std::to_string(i))
        .AddNote({}, "n" + std::to_string(i));
    EXPECT_EQ(diagnostics.full(), i + 1 >= 100);
  }
  EXPECT_EQ(diagnostics.all().size(), Diagnostics::kMaxErrors);
  EXPECT_EQ(diagnostics.error_count(), 250u);
  std::string text = FormatDiagnostics(diagnostics, Sources(), false);
  EXPECT_THAT(text, HasSubstr("error: e99 [syntax]\nnote: n99\n150 more errors not shown\n"));
  EXPECT_THAT(text, Not(HasSubstr("e100")));
}

TEST(Diagnostics, AppendKeepsOrderCountsAndTheFirstError) {
  Diagnostics first, second;
  first.Warn(DiagnosticKind::kSyntax, {}, "w");
  for (int i = 0; i < 150; ++i) second.Error(DiagnosticKind::kCannotRead, {}, "e");
  first.Append(std::move(second));
  EXPECT_EQ(first.error_count(), 150u);
  EXPECT_EQ(first.all().size(), 101u);
  EXPECT_EQ(first.exit_code(), ExitCode::kIo);
}

TEST(Diagnostics, WarningsAreDroppedOrBecomeErrors) {
  auto make = [] {
    Diagnostics diagnostics;
    for (int i = 0; i < 60; ++i) {
      diagnostics.Warn(DiagnosticKind::kCannotRead, {}, "w");
      diagnostics.Error(DiagnosticKind::kSyntax, {}, "e");
    }
    return diagnostics;
  };
  Diagnostics dropped = make();
  dropped.DropWarnings();
  EXPECT_EQ(dropped.all().size(), 60u);
  EXPECT_EQ(dropped.warning_count(), 0u);
  EXPECT_EQ(dropped.exit_code(), ExitCode::kInvalid);
  Diagnostics promoted = make();
  promoted.PromoteWarnings();
  EXPECT_EQ(promoted.error_count(), 120u);
  EXPECT_EQ(promoted.exit_code(), ExitCode::kIo);
  std::string text = FormatDiagnostics(promoted, Sources(), false);
  EXPECT_THAT(text, Not(HasSubstr("warning")));
  EXPECT_THAT(text, Not(HasSubstr("not shown")));
}

TEST(FormatDiagnostics, PlaceLineCaretsAndNote) {
  Sources sources;
  SourceId graph =
      sources.Add("brick.json", "{\n  \"height\": \"noise.gradient\",\r\n  \"b\": 2\n}\n");
  SourceId block = sources.Add("warp.glsl", "vec2 warp(vec2 uv, float height);");
  Diagnostics diagnostics;
  diagnostics
      .Error(DiagnosticKind::kPortType, RangeOf(sources, graph, "\"noise.gradient\""),
             "port takes float, got vec3")
      .AddNote(RangeOf(sources, block, "height"), "the port is declared here");
  EXPECT_EQ(FormatDiagnostics(diagnostics, sources, false),
            "brick.json:2:13: error: port takes float, got vec3 [port-type]\n"
            "    2 |   \"height\": \"noise.gradient\",\n"
            "      |             ^~~~~~~~~~~~~~~~\n"
            "warp.glsl:1:26: note: the port is declared here\n"
            "    1 | vec2 warp(vec2 uv, float height);\n"
            "      |                          ^~~~~~\n");
}

TEST(FormatDiagnostics, RangesWithoutPlaceAtTheEndAndOverLines) {
  Sources sources;
  SourceId id = sources.Add("a.json", "{\n  \"x\": [1,\n2]");
  Diagnostics diagnostics;
  diagnostics.Error(DiagnosticKind::kUsage, {}, "no graph given");
  diagnostics.Error(DiagnosticKind::kSyntax, {id, 15, 15}, "expected '}'");
  diagnostics.Warn(DiagnosticKind::kBadValue, {id, 9, 14}, "two lines");
  diagnostics.Error(DiagnosticKind::kSyntax, {id, 5000, 6000}, "beyond");
  EXPECT_EQ(FormatDiagnostics(diagnostics, sources, false),
            "error: no graph given [usage]\n"
            "a.json:3:3: error: expected '}' [syntax]\n"
            "    3 | 2]\n"
            "      |   ^\n"
            "a.json:2:8: warning: two lines [bad-value]\n"
            "    2 |   \"x\": [1,\n"
            "      |        ^~~\n"
            "a.json:3:3: error: beyond [syntax]\n"
            "    3 | 2]\n"
            "      |   ^\n");
}

TEST(FormatDiagnostics, EmptySource) {
  Sources sources;
  SourceId id = sources.Add("a.json", "");
  Diagnostics diagnostics;
  diagnostics.Error(DiagnosticKind::kEmptyDocument, {id, 0, 0}, "empty");
  EXPECT_EQ(FormatDiagnostics(diagnostics, sources, false),
            "a.json:1:1: error: empty [empty-document]\n    1 |\n      | ^\n");
}

TEST(FormatDiagnostics, TabsAndWideCharactersKeepCaretsAligned) {
  Sources sources;
  SourceId id = sources.Add("a.json", "\t\"\xe7\x80\x93\xc3\xa9\":\tX;");
  Diagnostics diagnostics;
  diagnostics.Error(DiagnosticKind::kSyntax, RangeOf(sources, id, "X"), "here");
  // Columns: tab to 4, quote, wide 2, narrow 1, quote, colon = 10, tab to 12.
  EXPECT_EQ(FormatDiagnostics(diagnostics, sources, false),
            "a.json:1:11: error: here [syntax]\n"
            "    1 |     \"\xe7\x80\x93\xc3\xa9\":  X;\n"
            "      |             ^\n");
}

TEST(FormatDiagnostics, LongLinesAreShownAroundThePlace) {
  Sources sources;
  std::string line(1'000'000, 'a');
  line[500'000] = 'X';
  SourceId id = sources.Add("long.json", line);
  Diagnostics diagnostics;
  diagnostics.Error(DiagnosticKind::kSyntax, {id, 500'000, 500'001}, "here");
  std::string text = FormatDiagnostics(diagnostics, sources, false);
  EXPECT_LT(text.size(), 600u);
  size_t first = text.find('\n') + 1, second = text.find('\n', first) + 1;
  std::string shown = text.substr(first, second - first), carets = text.substr(second);
  EXPECT_THAT(shown.substr(8), StartsWith("...aaa"));
  EXPECT_THAT(shown, HasSubstr("aaa...\n"));
  EXPECT_EQ(shown.find('X'), carets.find('^'));
}

TEST(FormatDiagnostics, CaretsStayWithinTheWindow) {
  Sources sources;
  SourceId id = sources.Add("long.json", std::string(1000, 'a'));
  Diagnostics diagnostics;
  diagnostics.Error(DiagnosticKind::kSyntax, {id, 10, 990}, "here");
  std::string text = FormatDiagnostics(diagnostics, sources, false);
  EXPECT_LE(std::count(text.begin(), text.end(), '~'), 170);
  EXPECT_GE(std::count(text.begin(), text.end(), '~'), 100);
}

TEST(FormatDiagnostics, EscapesWhatATerminalWouldObey) {
  Sources sources;
  SourceId id =
      sources.Add("\x1b]0;evil\x07.json", "\"\x1b[2J\xe2\x80\xae\xff\xc2\x9b\xe2\x80\x8b\x7f\"");
  Diagnostics diagnostics;
  diagnostics.Error(DiagnosticKind::kBadName, {id, 0, 4}, "bad \x1b]0;pwn\x07 \n[fake-name]")
      .AddNote({}, "\r\x08");
  std::string text = FormatDiagnostics(diagnostics, sources, false);
  for (char c : text) EXPECT_TRUE(c == '\n' || static_cast<unsigned char>(c) >= 0x20) << int(c);
  EXPECT_THAT(text, Not(HasSubstr("\xe2\x80\xae")));
  EXPECT_THAT(text, Not(HasSubstr("\xff")));
  EXPECT_THAT(text, HasSubstr("\\u202e\\xff\\u009b\\u200b\\x7f"));
  EXPECT_THAT(text, HasSubstr("bad \\x1b]0;pwn\\x07 \\n[fake-name] [bad-name]"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 4);
}

TEST(FormatDiagnostics, ColorsAreEscapesAroundTheSameText) {
  Sources sources;
  SourceId id = sources.Add("a.json", "x y");
  Diagnostics diagnostics;
  diagnostics.Error(DiagnosticKind::kSyntax, {id, 2, 3}, "here").AddNote({id, 0, 1}, "there");
  std::string plain = FormatDiagnostics(diagnostics, sources, false);
  std::string color = FormatDiagnostics(diagnostics, sources, true), stripped;
  EXPECT_THAT(plain, Not(HasSubstr("\x1b")));
  for (size_t i = 0; i < color.size(); ++i) {
    if (color[i] == '\x1b') {
      i = color.find('m', i);
      continue;
    }
    stripped += color[i];
  }
  EXPECT_NE(color, plain);
  EXPECT_EQ(stripped, plain);
}

TEST(Printable, CutsAtWholeCharacters) {
  EXPECT_EQ(Printable("short"), "short");
  EXPECT_EQ(Printable("abcdefghij", 8), "abcde...");
  EXPECT_EQ(Printable("abcdefgh", 8), "abcdefgh");
  EXPECT_EQ(Printable("abc\xc3\xa9\xc3\xa9\xc3\xa9", 8), "abc\xc3\xa9...");
  EXPECT_EQ(Printable("a\x1b\x1b\x1b", 8), "a\\x1b...");
  EXPECT_LE(Printable(std::string(100'000, 'x')).size(), 200u);
}

}  // namespace
}  // namespace texgraph
