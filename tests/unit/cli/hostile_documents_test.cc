// SPDX-License-Identifier: Apache-2.0
// HOSTILE.md, "Documents", through the whole program. Which number means what is tested in
// tests/unit/graph.
#include <string>

#include "tests/unit/cli/hostile_run.h"
#include "tests/unit/cli/sample_graphs.h"

namespace texgraph {
namespace {

// A graph whose only literal is `literal`.
std::string WithLiteral(const std::string& literal) {
  return "{ \"texgraph\": 1, \"nodes\": { \"a\": { \"block\": \"add\", \"in\": { \"a\": " +
         literal + " } } }, \"outputs\": { \"height\": \"a\" } }";
}

TEST_F(Hostile, EmptyAndBlank) {
  for (const char* name : {"g.json", "g.jsonc", "g.yaml"}) {
    ExpectRefused("", 1, "empty-document", name);
    ExpectRefused(" \n ", 1, "empty-document", name);
    ExpectRefused("\t\n \t", 1, "empty-document", name);
  }
}

TEST_F(Hostile, TruncatedEverywhere) {
  std::string whole(kProceduralGraph);
  whole.erase(whole.find_last_of('}') + 1);
  for (size_t length = 1; length < whole.size(); ++length) {
    Result result = Run(whole.substr(0, length));
    EXPECT_EQ(result.outcome.exit_code, 1) << length;
  }
  ExpectAccepted(whole);
}

TEST_F(Hostile, TextThatIsNotJson) {
  std::string good(kProceduralGraph);
  ExpectRefused(good + "{}", 1, "syntax");
  ExpectRefused(good + "x", 1, "syntax");
  ExpectRefused(good + std::string(1, '\0'), 1, "encoding");
  ExpectRefused("{ 'texgraph': 1 }", 1, "syntax");
  ExpectRefused("{ texgraph: 1 }", 1, "syntax");
  ExpectRefused("// comment\n" + good, 1, "syntax");
  ExpectAccepted("// comment\n" + good, "g.jsonc");
  ExpectAccepted("\xef\xbb\xbf" + good);
}

TEST_F(Hostile, Nesting) {
  for (size_t depth : {size_t{65}, size_t{100'000}, size_t{1'000'000}}) {
    ExpectRefused(std::string(depth, '['), 4, "nesting-limit");
    ExpectRefused(std::string(depth, '[') + std::string(depth, ']'), 4, "nesting-limit");
    std::string objects;
    for (size_t i = 0; i < depth; ++i) objects += "{\"a\":";
    ExpectRefused(objects, 4, "nesting-limit");
  }
}

TEST_F(Hostile, NestingInYaml) {
  std::string block, dashes, flow(100'000, '[');
  for (int i = 0; i < 2000; ++i) block += std::string(static_cast<size_t>(i), ' ') + "a:\n";
  for (int i = 0; i < 10'000; ++i) dashes += "- ";
  ExpectRefused(block, 4, "nesting-limit", "g.yaml");
  ExpectRefused(dashes + "x", 4, "nesting-limit", "g.yaml");
  ExpectRefused(flow, 4, "nesting-limit", "g.yaml");
}

TEST_F(Hostile, AliasesOfYaml) {
  std::string bomb = "a0: &a0 [x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 9; ++i) {
    std::string name = "a" + std::to_string(i), before = "*a" + std::to_string(i - 1);
    bomb += name + ": &" + name + " [";
    for (int k = 0; k < 9; ++k) bomb += (k == 0 ? "" : ", ") + before;
    bomb += "]\n";
  }
  ExpectRefused(bomb, 4, "alias-limit", "g.yaml");
  ExpectRefused("a: &a [*a]\n", 1, "yaml-feature", "g.yaml");
  ExpectRefused("a: *a\n", 1, "syntax", "g.yaml");
  ExpectRefused("a: &a {}\nb: { <<: *a }\n", 1, "yaml-feature", "g.yaml");
  ExpectRefused("a: !!python/object:os.system x\n", 1, "yaml-feature", "g.yaml");
  ExpectRefused("a: 1\n---\nb: 2\n", 1, "yaml-feature", "g.yaml");
}

TEST_F(Hostile, Numbers) {
  for (const char* literal :
       {"NaN", "Infinity", "-Infinity", "0x10", "010", "1_000", "+1", ".5", "1."}) {
    ExpectRefused(WithLiteral(literal), 1, "syntax");
  }
  for (const char* literal : {"1e999", "-1e999", "1e39"})
    ExpectRefused(WithLiteral(literal), 1, "number-range");
  ExpectAccepted(WithLiteral("1e-999"));
  ExpectAccepted(WithLiteral("-0"));
  ExpectAccepted(WithLiteral("0.0000074836628E-2147483636"));
  ExpectAccepted(WithLiteral("0." + std::string(1'000'000, '0') + "1"));
  ExpectAccepted(WithLiteral("128." + std::string(1'000, '7') + "e-336"));
}

TEST_F(Hostile, YamlWordsAreNoNumbers) {
  for (const char* literal : {"010", "0x10", "1_000", "yes", "no", "on", "~", ".nan", ".inf"}) {
    std::string text = std::string("texgraph: 1\nnodes: { a: { block: add, in: { a: ") + literal +
                       " } } }\noutputs: { height: a }\n";
    EXPECT_EQ(Run(text, "g.yaml").outcome.exit_code, 1) << literal;
  }
}

TEST_F(Hostile, Encodings) {
  for (const char* bytes : {"\xff\xfe", "\xc0\xaf", "\xed\xa0\x80", "\xf5\x80\x80\x80"}) {
    ExpectRefused("{ \"texgraph\": 1, \"description\": \"" + std::string(bytes) + "\" }", 1,
                  "encoding");
    ExpectRefused("description: \"" + std::string(bytes) + "\"\n", 1, "encoding", "g.yaml");
  }
  std::string start(kProceduralGraph.substr(0, kProceduralGraph.rfind('}')));
  ExpectAccepted(start + ", \"description\": \"\\ud83d\\ude00\" }");
  EXPECT_EQ(Run(start + ", \"description\": \"\\ud800\" }").outcome.exit_code, 1);
  ExpectRefused("{ \"texgraph\": 1, \"name\": \"a\\u0000b\" }", 1, "bad-name");
  EXPECT_EQ(Run(std::string("\xff\xfe{\0}\0", 6)).outcome.exit_code, 1);
}

TEST_F(Hostile, AMillionLinesAndALongLine) {
  ExpectRefused(std::string(1'000'000, '\n') + "x", 1, "syntax");
  ExpectRefused("{ \"" + std::string(10'000'000, 'k') + "\": ", 1, "syntax");
}

}  // namespace
}  // namespace texgraph
