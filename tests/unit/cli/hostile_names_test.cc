// SPDX-License-Identifier: Apache-2.0
// HOSTILE.md, "Names and strings": what a stranger calls things never reaches the shader but as an
// identifier.
#include <fmt/format.h>

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
      "main",    "float",     "gl_FragColor", "gl_x", "a__b",   "uniform", "discard",
      "texture", "sampler2D", "input",        "half", "sample", "goto",    "while",
      "dot",     "all",       "round",        "if",   "vec3",   "true",    "mix"};
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
  ExpectRefused(NodeCalled("__"), 1, "bad-name");
}

// A node, a function, its input, its output and a node in it with one name, all of which the shader
// has variables or functions for.
std::string AllCalled(const std::string& name) {
  return fmt::format(
      R"({{ "texgraph": 1,
            "parameters": {{ "p": {{ "type": "vec3", "value": [1, 2, 3], "binding": "uniform" }} }},
            "functions": {{
              "{0}": {{ "inputs": {{ "{0}1": "vec3" }}, "nodes": {{
                  "{0}2": {{ "block": "multiply", "in": {{ "a": "{0}1", "b": "p" }} }},
                  "{0}3": {{ "block": "multiply", "in": {{ "a": "{0}2", "b": "{0}2" }} }} }},
                "outputs": {{ "{0}": "{0}3", "{0}2": "{0}2" }} }},
              "of": {{ "inputs": {{ "{0}4": "vec3" }}, "nodes": {{
                  "{0}5": {{ "block": "multiply", "in": {{ "a": "{0}4", "b": "p" }} }},
                  "{0}6": {{ "block": "multiply", "in": {{ "a": "{0}5", "b": "{0}5" }} }} }},
                "outputs": {{ "{0}": "{0}6" }} }} }},
            "nodes": {{
              "{0}7": {{ "block": "{0}", "in": {{ "{0}1": "p" }} }},
              "{0}8": {{ "block": "of", "in": {{ "{0}4": "{0}7.{0}" }} }},
              "{0}9": {{ "block": "of", "in": {{ "{0}4": "{0}8" }} }},
              "sum": {{ "block": "add", "in": {{ "a": "{0}9", "b": "{0}7.{0}2" }} }} }},
            "outputs": {{ "emission": "sum" }} }})",
      name);
}

std::string WithoutComments(const std::string& shader) {
  std::string code;
  for (size_t begin = 0; begin < shader.size();) {
    const size_t end = std::min(shader.find('\n', begin), shader.size() - 1) + 1;
    const std::string line = shader.substr(begin, end - begin);
    code += line.substr(0, line.find("//")) + "\n";
    begin = end;
  }
  return code;
}

TEST_F(Hostile, WordsOfGlslAreNamesOfWhatNobodyBinds) {
  bool as_function = false;
  for (const std::string& word : ReservedNames()) {
    folder.Write("graph.json", AllCalled(word));
    as_function = !as_function;
    const std::string emit = as_function ? "--emit=function" : "--emit=shader";
    Outcome outcome = Texgraphc({"graph.json", "--validate", emit, "-o", "-"}, folder.path()).Run();
    EXPECT_EQ(outcome.exit_code, 0) << outcome.error << AllCalled(word);
    const std::string code = WithoutComments(outcome.out);
    EXPECT_NE(code.find("9 = "), std::string::npos) << code;
    EXPECT_EQ(code.find("gl_"), std::string::npos) << code;
    EXPECT_EQ(code.find("__"), std::string::npos) << code;
  }
}

TEST_F(Hostile, WordsOfGlslAreNoNamesOfWhatProgramsBind) {
  for (const std::string& name : ReservedNames()) {
    const std::string nodes = R"("nodes": { "a": { "block": "add", "in": { "a": 1 } } },
                                 "outputs": { "height": "a" } })";
    ExpectRefused(R"({ "texgraph": 1, "parameters": { ")" + name +
                      R"(": { "type": "float", "value": 1 } }, )" + nodes,
                  1, "bad-name");
    ExpectRefused(R"({ "texgraph": 1, "name": ")" + name + "\", " + nodes, 1, "bad-name");
  }
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
    if (name == "main") continue;
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
