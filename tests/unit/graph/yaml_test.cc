// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "tests/unit/graph/graph_testing.h"

namespace texgraph::graph {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string Repeat(std::string_view text, size_t count) {
  std::string out;
  for (size_t i = 0; i < count; ++i) out += text;
  return out;
}

std::string Tree(const std::string& text) {
  ReadText read(text, DocumentFormat::kYaml, "graph.yaml");
  return read.document ? TreeText(*read.document) : read.Messages();
}

TEST(Yaml, ReadsBlockAndFlowStyles) {
  EXPECT_EQ(Tree("\xef\xbb\xbf# a comment\n"
                 "texgraph: 1\n"
                 "nodes:\n"
                 "  grid: {block: brick_grid, in: {uv: uv, 'rows': 3}}\n"
                 "  list:\n"
                 "  - a\n"
                 "  - [1, 2.5]\n"
                 "  - ~\n"
                 "text: |\n"
                 "  one\n"
                 "  two\n"
                 "folded: >-\n"
                 "  one\n"
                 "  two\n"
                 "quoted: 'it''s'\n"
                 "escaped: \"\\u00e9\\ud83d\\ude00\"\n"),
            R"({"texgraph": 1, "nodes": {"grid": {"block": "brick_grid", "in": {"uv": "uv", )"
            R"("rows": 3}}, "list": ["a", [1, 2.5], null]}, "text": "one\ntwo\n", )"
            R"("folded": "one two", "quoted": "it's", "escaped": ")"
            "\xc3\xa9\xf0\x9f\x98\x80\"}");
}

TEST(Yaml, ReadsJson) {
  std::string json = R"({"a": [1, -2.5e3, "x\n", true, false, null], "b": {}, "c": []})";
  EXPECT_EQ(Tree(json), R"({"a": [1, -2500.0, "x\n", true, false, null], "b": {}, "c": []})");
}

TEST(Yaml, PlainScalarsAreNumbersOnlyWhereAllLoadersAgree) {
  EXPECT_EQ(Tree("[1, -1, +1, 0, 0.5, .5, -.5, 5., 1e3, 1.5E-2, 5.e1]"),
            "[1, -1, 1, 0, 0.5, 0.5, -0.5, 5.0, 1000.0, 0.015, 50.0]");
  EXPECT_EQ(Tree("[010, 0x10, 0o7, 1_000, 1:30, ++1, +-1, --1, ., +, 1e, .e1, 01.5, 1.5.2, "
                 "2020-01-01]"),
            R"(["010", "0x10", "0o7", "1_000", "1:30", "++1", "+-1", "--1", ".", "+", "1e", )"
            R"(".e1", "01.5", "1.5.2", "2020-01-01"])");
  EXPECT_EQ(Tree("[yes, no, on, off, True, y, ~, null, Null, 'true', \"1\"]"),
            R"(["yes", "no", "on", "off", "True", "y", null, null, "Null", "true", "1"])");
}

TEST(Yaml, MinusZeroKeepsItsSign) {
  ReadText read("[-0, -0.0]", DocumentFormat::kYaml);
  ASSERT_TRUE(read.document);
  EXPECT_TRUE(std::signbit(read.document->nodes[1].number));
  EXPECT_TRUE(std::signbit(read.document->nodes[2].number));
}

TEST(Yaml, RangesAreBytesOfTheSource) {
  std::string text = "\xef\xbb\xbf\xc3\xa4: b\nkey: \"quoted\"\nsingle: 'x'\n";
  ReadText read(text, DocumentFormat::kYaml);
  ASSERT_TRUE(read.document) << read.Messages();
  auto covered = [&](SourceRange range) {
    return text.substr(range.begin, range.end - range.begin);
  };
  const auto& nodes = read.document->nodes;
  EXPECT_EQ(covered(nodes[1].key_range), "\xc3\xa4");
  EXPECT_EQ(covered(nodes[1].range), "b");
  EXPECT_EQ(covered(nodes[2].key_range), "key");
  EXPECT_EQ(covered(nodes[2].range), "\"quoted\"");
  EXPECT_EQ(covered(nodes[3].range), "'x'");
  // Nothing was copied.
  EXPECT_THAT(read.document->storage, IsEmpty());
}

TEST(Yaml, AliasesAreCopies) {
  ReadText read("base: &b {x: [1, &inner 2]}\na: *b\nc: [*inner, *b]\n", DocumentFormat::kYaml);
  ASSERT_TRUE(read.document) << read.Messages();
  EXPECT_EQ(TreeText(*read.document),
            R"({"base": {"x": [1, 2]}, "a": {"x": [1, 2]}, "c": [2, {"x": [1, 2]}]})");
  // The copy's root is shown where the alias stands.
  EXPECT_EQ(read.sources.Locate(read.source, read.document->nodes[5].range.begin).line, 2u);
}

TEST(Yaml, AliasesMayNotExplode) {
  std::string bomb = "a: &a [1,2,3,4,5,6,7,8,9]\n";
  for (char c = 'b'; c <= 'i'; ++c) {
    std::string before(1, static_cast<char>(c - 1));
    bomb += std::string(1, c) + ": &" + c + " [" + Repeat("*" + before + ",", 9) + "]\n";
  }
  double start = CpuSeconds();
  ReadText read(bomb, DocumentFormat::kYaml);
  double time = CpuSeconds() - start;
  EXPECT_FALSE(read.document);
  EXPECT_THAT(read.Places(), ElementsAre(HasSubstr("alias-limit")));
  EXPECT_THAT(read.Messages(), HasSubstr("more than 100000 values"));
  EXPECT_EQ(read.diagnostics.exit_code(), ExitCode::kLimit);
  EXPECT_LT(time, 1.0);
}

// Copies of nests within nests would be deeper than the limit on what is written.
TEST(Yaml, AliasesMayNotNestTooDeep) {
  std::string half = Repeat("[", 33) + Repeat("]", 33);
  ReadText fits("a: &a " + half + "\nb: [*a]\n", DocumentFormat::kYaml);
  EXPECT_TRUE(fits.document) << fits.Messages();
  ReadText read("a: &a " + half + "\nb: " + Repeat("[", 31) + "*a" + Repeat("]", 31) + "\n",
                DocumentFormat::kYaml);
  EXPECT_FALSE(read.document);
  EXPECT_THAT(read.Places(), ElementsAre("2:35 nesting-limit"));
}

struct Mistake {
  std::string text;
  std::string place;
  std::string message;
};

TEST(Yaml, EachMistakeHasItsMessageAndPlace) {
  const std::vector<Mistake> mistakes = {
      {"", "1:1 empty-document", "the document is empty"},
      {"# only a comment\n", "1:1 empty-document", "the document is empty"},
      {"---\n", "1:1 empty-document", "the document is empty"},
      {"a: [*a]", "1:5 syntax", "the alias 'a' has no anchor before it"},
      {"a: *b\nb: &b 1", "1:4 syntax", "the alias 'b' has no anchor before it"},
      {"a: &a [*a]", "1:8 yaml-feature", "recursive alias"},
      {"a: &a {b: {c: *a}}", "1:15 yaml-feature", "recursive alias"},
      {"a: &a {b: 1}\nc:\n  <<: *a\n", "3:3 yaml-feature", "merge keys"},
      {"a: !!python/object:os.system x", "1:4 yaml-feature", "tags"},
      {"a: !local [1]", "1:4 yaml-feature", "tags"},
      {"a: 1\n---\nb: 2\n", "2:1 yaml-feature", "one file holds one graph"},
      {"? [a]\n: 1\n", "1:3 yaml-feature", "a key must be plain text"},
      {"a: &a 1\n*a : 2\n", "2:1 yaml-feature", "alias as a key"},
      {"&k a: 1\n", "1:1 yaml-feature", "anchors on keys"},
      {"a: 1\nb: 2\na: 3\n", "3:1 duplicate-key (1:1)", "the key 'a' stands twice"},
      {"{a: 1, \"\\x61\": 3}", "1:8 duplicate-key (1:2)", "the key 'a' stands twice"},
      {"a: .inf", "1:4 number-range", "finite"},
      {"a: -.Inf", "1:4 number-range", "finite"},
      {"a: .NaN", "1:4 number-range", "finite"},
      {"a: 1e999", "1:4 number-range", "out of range"},
      {"a: b: c\n", "1:5 syntax", "nested block mapping"},
      {"a:\n\tb: 1\n", "2:1 syntax", "tab"},
      {"a: [1, 2\n", "2:1 syntax", ""},
      {"a: \"b\n", "1:5 syntax", ""},
      {"a: \"\\ud800\"", "1:5 syntax", "escape"},
      {"a: \"b\x01\"", "1:6 syntax", "control character"},
      {"a: \xff", "1:4 encoding", "byte 0xFF at byte offset 3"},
      {std::string("a: 1\n\0", 6), "2:1 encoding", "NUL byte at byte offset 5"},
  };
  for (const Mistake& mistake : mistakes) {
    ReadText read(mistake.text, DocumentFormat::kYaml);
    EXPECT_TRUE(read.diagnostics.HasErrors()) << mistake.text;
    EXPECT_THAT(read.Places(), ElementsAre(mistake.place)) << mistake.text;
    EXPECT_THAT(read.Messages(), HasSubstr(mistake.message)) << mistake.text;
  }
}

TEST(Yaml, DeepNestsAreRefusedFast) {
  std::string blocks;
  for (int i = 0; i < 2'500; ++i) blocks += std::string(static_cast<size_t>(i), ' ') + "a:\n";
  for (const std::string& text : {blocks, Repeat("- ", 50'000), Repeat("[", 1'000'000),
                                  Repeat("{a: ", 1'000'000), Repeat("[", 65)}) {
    double start = CpuSeconds();
    ReadText read(text, DocumentFormat::kYaml);
    double time = CpuSeconds() - start;
    EXPECT_FALSE(read.document);
    EXPECT_THAT(read.Places(), ElementsAre(HasSubstr("nesting-limit")));
    EXPECT_LT(time, 1.0);  // about 50 ms at most
  }
  EXPECT_TRUE(ReadText(Repeat("[", 64) + Repeat("]", 64), DocumentFormat::kYaml).document);
}

TEST(Yaml, LargeFilesAreRefused) {
  ReadText read("a: " + std::string(17u << 20, 'x'), DocumentFormat::kYaml);
  EXPECT_FALSE(read.document);
  EXPECT_THAT(read.Places(), ElementsAre("1:1 size-limit"));
  EXPECT_THAT(read.Messages(), HasSubstr("the limit is 16 MiB"));
}

TEST(Yaml, NothingGoesToStandardError) {
  ::testing::internal::CaptureStderr();
  ::testing::internal::CaptureStdout();
  for (const char* text :
       {"a: [1", "a: b: c", "!<", "\t", "a: &b *c", "%YAML 3\n---\na", "\"\\x"}) {
    ReadText read(text, DocumentFormat::kYaml);
  }
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

// Every prefix of a text, and every text with one byte replaced, is read or refused with one
// reason.
TEST(Yaml, DamagedTextsAreReadOrRefused) {
  const std::string text =
      "texgraph: 1\n"
      "nodes: # all\n"
      "  a: &x {block: noise, in: {scale: [1, -2.5e3], \"seed\": '7'}}\n"
      "  b:\n"
      "    block: >-\n"
      "      mix\n"
      "    in: *x\n"
      "outputs: {color: a}\n";
  for (size_t i = 0; i < text.size(); ++i) {
    ReadText cut(text.substr(0, i), DocumentFormat::kYaml);
    EXPECT_NE(cut.document.has_value(), cut.diagnostics.HasErrors()) << i;
    for (char c : std::string_view("\n:-[]{}*&!'\"#%@ ,?|>\\\t~0a")) {
      std::string damaged = text;
      damaged[i] = c;
      ReadText read(damaged, DocumentFormat::kYaml);
      if (!read.document) {
        EXPECT_EQ(read.diagnostics.error_count(), 1u) << damaged;
      }
    }
  }
}

}  // namespace
}  // namespace texgraph::graph
