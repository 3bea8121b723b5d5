// SPDX-License-Identifier: Apache-2.0
// HOSTILE.md, "Names and strings": what a stranger calls things never reaches the shader but as an
// identifier.
#include <string>
#include <vector>

#include "compiler/base/text.h"
#include "tests/unit/cli/hostile_run.h"

namespace texgraph {
namespace {

const std::vector<std::string>& EvilNames() {
  static const std::vector<std::string> kNames = {"\"; discard; //",
                                                  "x\n#error",
                                                  "*/ } void main(){",
                                                  "//\\",
                                                  "\?\?/",
                                                  "#extension GL_x : enable",
                                                  "a b",
                                                  "1abc",
                                                  "",
                                                  "a-b",
                                                  "a.b",
                                                  "\xc3\xa9t\xc3\xa9",
                                                  "\xe2\x80\xae"
                                                  "abc",
                                                  "a\xe2\x80\x8b"
                                                  "b",
                                                  "\x1b]0;title\x07",
                                                  "a\tb",
                                                  "a\\b",
                                                  "`id`",
                                                  "$(id)",
                                                  "%s%n",
                                                  "a,b",
                                                  "a;b",
                                                  std::string(100'000, '\x7f')};
  return kNames;
}

const std::vector<std::string>& ReservedNames() {
  static const std::vector<std::string> kNames = {
      "main",    "float",     "gl_FragColor", "gl_x", "a__b",   "__",   "uniform", "discard",
      "texture", "sampler2D", "input",        "half", "sample", "goto", "while"};
  return kNames;
}

std::string NodeCalled(const std::string& name) {
  std::string quoted = JsonQuoted(name);
  return "{ \"texgraph\": 1, \"nodes\": { " + quoted +
         ": { \"block\": \"add\", \"in\": { \"a\": 1 } } }, \"outputs\": { \"height\": " + quoted +
         " } }";
}

TEST_F(Hostile, NamesOfNodes) {
  for (const std::string& name : EvilNames()) ExpectRefused(NodeCalled(name), 1, "bad-name");
  for (const std::string& name : ReservedNames()) ExpectRefused(NodeCalled(name), 1, "bad-name");
}

TEST_F(Hostile, NamesOfEverythingElse) {
  for (const std::string& name : {std::string("\"; discard; //"), std::string("x\n#error"),
                                  std::string("main"), std::string()}) {
    std::string quoted = JsonQuoted(name);
    ExpectRefused("{ \"texgraph\": 1, \"parameters\": { " + quoted +
                      ": { \"type\": \"float\", \"value\": 1, \"binding\": \"uniform\" } }, "
                      "\"nodes\": { \"a\": { \"block\": \"add\", \"in\": { \"a\": " +
                      quoted + " } } }, \"outputs\": { \"height\": \"a\" } }",
                  1, "bad-name");
    ExpectRefused("{ \"texgraph\": 1, \"textures\": { " + quoted +
                      ": { \"file\": \"a.png\" } }, "
                      "\"nodes\": { \"a\": { \"block\": \"add\", \"in\": { \"a\": 1 } } }, "
                      "\"outputs\": { \"height\": \"a\" } }",
                  1, "bad-name");
    ExpectRefused("{ \"texgraph\": 1, \"functions\": { " + quoted +
                      ": { \"nodes\": { \"n\": { \"block\": \"add\", \"in\": { \"a\": 1 } } }, "
                      "\"outputs\": { \"v\": \"n\" } } }, "
                      "\"nodes\": { \"a\": { \"block\": \"add\", \"in\": { \"a\": 1 } } }, "
                      "\"outputs\": { \"height\": \"a\" } }",
                  1, "bad-name");
  }
}

// Descriptions, labels and file names are free text; none of it may come into the shader.
TEST_F(Hostile, FreeTextStaysOutOfTheShader) {
  for (const std::string& text : EvilNames()) {
    if (text.size() < 3) continue;
    std::string quoted = JsonQuoted("XYZZY" + text);
    std::string shader =
        ExpectAccepted("{ \"texgraph\": 1, \"description\": " + quoted +
                       ", \"parameters\": { \"p\": { \"type\": \"float\", \"value\": 1, "
                       "\"binding\": \"uniform\", \"label\": " +
                       quoted + ", \"help\": " + quoted + ", \"unit\": " + quoted +
                       " } }, "
                       "\"nodes\": { \"a\": { \"block\": \"add\", \"in\": { \"a\": \"p\" } } }, "
                       "\"outputs\": { \"height\": \"a\" } }");
    EXPECT_EQ(shader.find("XYZZY"), std::string::npos) << shader;
    for (unsigned char c : shader) EXPECT_TRUE(c == '\n' || (c >= 0x20 && c < 0x7f)) << int(c);
  }
}

TEST_F(Hostile, FileNamesDoNotReachTheShader) {
  folder.Write("evil *_ } void main(){ .json", NodeCalled("a"));
  Outcome outcome = Texgraphc({"evil *_ } void main(){ .json", "-o", "-"}, folder.path()).Run();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_EQ(outcome.out.find("} void"), std::string::npos);
}

TEST_F(Hostile, LongNames) {
  std::string name(5000, 'n');
  Result result = Run(NodeCalled(name));
  EXPECT_LE(result.outcome.error.size(), 2000u);
  for (size_t start = 0; start < result.shader.size();) {
    size_t end = std::min(result.shader.find('\n', start), result.shader.size());
    EXPECT_LE(end - start, 2000u);
    start = end + 1;
  }
  EXPECT_LE(Run(NodeCalled(std::string(100'000, 'n'))).outcome.error.size(), 2000u);
}

TEST_F(Hostile, NamesThatDifferByCaseOrUnderscoresOnly) {
  std::string shader = ExpectAccepted(
      "{ \"texgraph\": 1, \"parameters\": { \"A\": { \"type\": \"float\", \"value\": 1, "
      "\"binding\": \"uniform\" }, "
      "\"a\": { \"type\": \"float\", \"value\": 2, \"binding\": \"uniform\" }, \"a_\": { \"type\": "
      "\"float\", \"value\": 3, "
      "\"binding\": \"uniform\" }, \"a1\": { \"type\": \"float\", \"value\": 4, \"binding\": "
      "\"uniform\" } }, \"nodes\": { "
      "\"s\": { \"block\": \"add\", \"in\": { \"a\": \"A\", \"b\": \"a\" } }, \"S\": { \"block\": "
      "\"add\", \"in\": { \"a\": \"a_\", "
      "\"b\": \"a1\" } }, \"t\": { \"block\": \"multiply\", \"in\": { \"a\": \"s\", \"b\": \"S\" } "
      "} }, \"outputs\": { \"height\": \"t\" } }");
  for (const char* name :
       {"uniform float A", "uniform float a", "uniform float a_", "uniform float a1"}) {
    EXPECT_THAT(shader, testing::HasSubstr(name));
  }
}

}  // namespace
}  // namespace texgraph
