// SPDX-License-Identifier: Apache-2.0
// HOSTILE.md, "Graph semantics": cycles, blow-ups, sizes, values without a meaning.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/unit/cli/hostile_run.h"

namespace texgraph {
namespace {

struct NodeText {
  std::string name, block, inputs;
};

// A graph that gives `output` as its height; `more` goes before the nodes.
std::string GraphOf(const std::vector<NodeText>& nodes, const std::string& output,
                    const std::string& more = {}) {
  std::string text = "{ \"texgraph\": 1, " + more + "\"nodes\": {";
  for (size_t i = 0; i < nodes.size(); ++i) {
    text += fmt::format("{}\n  \"{}\": {{ \"block\": \"{}\", \"in\": {{ {} }} }}",
                        i == 0 ? "" : ",", nodes[i].name, nodes[i].block, nodes[i].inputs);
  }
  return text + "\n}, \"outputs\": { \"height\": \"" + output + "\" } }";
}

std::string Inputs(const std::string& a, const std::string& b) {
  return fmt::format("\"a\": {}, \"b\": {}", a, b);
}

// How often a character stands in the statement of a shader that has the most of it.
std::ptrdiff_t MostInAStatement(const std::string& shader, char c) {
  std::ptrdiff_t most = 0;
  for (auto at = shader.begin(); at != shader.end();) {
    auto end = std::find(at, shader.end(), ';');
    most = std::max(most, std::count(at, end, c));
    at = end == shader.end() ? end : end + 1;
  }
  return most;
}

std::string Quoted(const std::string& name) { return "\"" + name + "\""; }

TEST_F(Hostile, CyclesNameTheirNodes) {
  Result loop =
      Run(GraphOf({{"x", "add", Inputs("\"y\"", "1")}, {"y", "add", Inputs("\"x\"", "1")}}, "x"));
  EXPECT_EQ(loop.outcome.exit_code, 1);
  EXPECT_THAT(loop.outcome.error, testing::HasSubstr("[cycle]"));
  EXPECT_THAT(loop.outcome.error,
              testing::AllOf(testing::HasSubstr("'x'"), testing::HasSubstr("'y'")));
  ExpectRefused(GraphOf({{"x", "add", Inputs("\"x\"", "1")}}, "x"), 1, "cycle");
  std::vector<NodeText> ring;
  for (int i = 0; i < 10'000; ++i)
    ring.push_back(
        {fmt::format("n{}", i), "add", Inputs(fmt::format("\"n{}\"", (i + 1) % 10'000), "1")});
  Result large = Run(GraphOf(ring, "n0"));
  EXPECT_EQ(large.outcome.exit_code, 1);
  EXPECT_THAT(large.outcome.error, testing::HasSubstr("[cycle]"));
  EXPECT_LT(large.outcome.error.size(), 100'000u);
}

std::string FunctionText(const std::string& name, const std::vector<NodeText>& nodes,
                         const std::string& output) {
  std::string text =
      fmt::format("\"{}\": {{ \"inputs\": {{ \"x\": \"float\" }}, \"nodes\": {{", name);
  for (size_t i = 0; i < nodes.size(); ++i) {
    text += fmt::format("{} \"{}\": {{ \"block\": \"{}\", \"in\": {{ {} }} }}", i == 0 ? "" : ",",
                        nodes[i].name, nodes[i].block, nodes[i].inputs);
  }
  return text + fmt::format(" }}, \"outputs\": {{ \"value\": \"{}\" }} }}", output);
}

TEST_F(Hostile, FunctionsThatCallThemselves) {
  std::string self =
      "\"functions\": { " + FunctionText("f", {{"n", "f", "\"x\": \"x\""}}, "n") + " }, ";
  ExpectRefused(GraphOf({{"a", "f", "\"x\": 1"}}, "a", self), 1, "cycle");
  std::string mutual = "\"functions\": { " + FunctionText("f", {{"n", "g", "\"x\": \"x\""}}, "n") +
                       ", " + FunctionText("g", {{"n", "f", "\"x\": \"x\""}}, "n") + " }, ";
  ExpectRefused(GraphOf({{"a", "f", "\"x\": 1"}}, "a", mutual), 1, "cycle");
}

// Each function calls the next one twice: a compiler that copies has 2^40 of the last.
TEST_F(Hostile, FunctionsThatDouble) {
  std::string functions = "\"functions\": { ";
  for (int i = 0; i < 40; ++i) {
    std::string next = i == 39 ? "sine" : fmt::format("f{}", i + 1);
    std::string port = i == 39 ? "angle" : "x";
    functions += FunctionText(fmt::format("f{}", i),
                              {{"l", next, fmt::format("\"{}\": \"x\"", port)},
                               {"m", "add", Inputs("\"x\"", "1")},
                               {"r", next, fmt::format("\"{}\": \"m\"", port)},
                               {"s", "add", Inputs("\"l\"", "\"r\"")}},
                              "s") +
                 (i == 39 ? " }, " : ", ");
  }
  Result result =
      Run(GraphOf({{"noise", "value_noise", ""}, {"a", "f0", "\"x\": \"noise\""}}, "a", functions));
  EXPECT_EQ(result.outcome.exit_code, 4) << result.outcome.error;
  EXPECT_THAT(result.outcome.error, testing::AllOf(testing::HasSubstr("[cost-limit]"),
                                                   testing::HasSubstr("through main -> f0 -> ")));
}

TEST_F(Hostile, TooManyAndTooDeepFunctions) {
  std::string deep = "\"functions\": { ", wide = deep;
  for (int i = 0; i < 70; ++i) {
    deep += FunctionText(fmt::format("f{}", i),
                         {{"n", i == 69 ? "sine" : fmt::format("f{}", i + 1),
                           fmt::format("\"{}\": \"x\"", i == 69 ? "angle" : "x")}},
                         "n") +
            (i == 69 ? " }, " : ", ");
  }
  Result nested =
      Run(GraphOf({{"noise", "value_noise", ""}, {"a", "f0", "\"x\": \"noise\""}}, "a", deep));
  EXPECT_EQ(nested.outcome.exit_code, 4);
  EXPECT_THAT(nested.outcome.error,
              testing::AllOf(testing::HasSubstr("[instance-limit]"),
                             testing::HasSubstr("through main -> f0 -> f1 -> f2 -> ... -> ")));
  std::vector<NodeText> nodes = {{"s0", "add", Inputs("1", "1")}};
  for (int i = 1; i <= 4200; ++i) {
    wide += FunctionText(fmt::format("f{}", i),
                         {{"n", "value_noise", fmt::format("\"scale\": \"x\", \"seed\": {}", i)},
                          {"m", "value_noise", "\"scale\": \"n\""},
                          {"o", "add", Inputs("\"n\"", "\"m\"")}},
                         "o") +
            (i == 4200 ? " }, " : ", ");
    nodes.push_back({fmt::format("a{}", i), fmt::format("f{}", i), "\"x\": 3"});
    nodes.push_back({fmt::format("s{}", i), "add",
                     Inputs(fmt::format("\"s{}\"", i - 1), fmt::format("\"a{}\"", i))});
  }
  Result many = Run(GraphOf(nodes, "s4200", wide));
  EXPECT_EQ(many.outcome.exit_code, 4);
  EXPECT_THAT(many.outcome.error, testing::AllOf(testing::HasSubstr("[instance-limit]"),
                                                 testing::HasSubstr("4096 functions")));
}

// A switch with 3,000 cases: no chain of ifs inside one another, which parsers follow by recursion.
TEST_F(Hostile, ASwitchOf3000) {
  std::vector<NodeText> nodes = {{"s0", "value_noise", ""}};
  for (int i = 1; i <= 3000; ++i) {
    nodes.push_back(
        {fmt::format("c{}", i), "compare", fmt::format("\"a\": \"time\", \"b\": {}", i)});
    nodes.push_back({fmt::format("s{}", i), "select",
                     fmt::format("\"condition\": \"c{}\", \"if_true\": {}, \"if_false\": \"s{}\"",
                                 i, i, i - 1)});
  }
  folder.Write("graph.json", GraphOf(nodes, "s3000"));
  Program program = Texgraphc({"graph.json", "-o", "x.frag", "--validate"}, folder.path());
  Outcome outcome = program.Run();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error.substr(0, 1000);
  EXPECT_LE(MostInAStatement(folder.Read("x.frag"), '?'), 50);
}

TEST_F(Hostile, DiamondChains) {
  for (int depth : {60, 1000}) {
    std::vector<NodeText> nodes = {{"n0", "value_noise", ""}};
    for (int i = 1; i <= depth; ++i) {
      std::string before = fmt::format("\"n{}\"", i - 1);
      nodes.push_back({fmt::format("l{}", i), "add", Inputs(before, "0.1")});
      nodes.push_back({fmt::format("r{}", i), "multiply", Inputs(before, "0.5")});
      nodes.push_back({fmt::format("n{}", i), "multiply",
                       Inputs(fmt::format("\"l{}\"", i), fmt::format("\"r{}\"", i))});
    }
    std::string shader = ExpectAccepted(GraphOf(nodes, fmt::format("n{}", depth)));
    EXPECT_LT(shader.size(), static_cast<size_t>(depth) * 300 + 10'000);
  }
}

TEST_F(Hostile, AChainOf50000) {
  std::vector<NodeText> nodes = {{"n0", "value_noise", ""}};
  for (int i = 1; i < 50'000; ++i) {
    nodes.push_back({fmt::format("n{}", i), i % 2 ? "sine" : "square_root",
                     fmt::format("\"{}\": \"n{}\"", i % 2 ? "angle" : "value", i - 1)});
  }
  Result result = Run(GraphOf(nodes, "n49999"), "graph.json", 60);
  EXPECT_EQ(result.outcome.exit_code, 0) << result.outcome.error.substr(0, 2000);
}

TEST_F(Hostile, AChainBackwardsWithASmallStack) {
  std::vector<NodeText> nodes;
  for (int i = 20'000; i > 0; --i)
    nodes.push_back({fmt::format("n{}", i), "add", Inputs(fmt::format("\"n{}\"", i - 1), "0.5")});
  nodes.push_back({"n0", "value_noise", ""});
  folder.Write("graph.json", GraphOf(nodes, "n20000"));
  Program program = Texgraphc({"graph.json", "-o", "x.frag"}, folder.path());
#if !defined(__SANITIZE_ADDRESS__)
  program.prepare = [] {
    rlimit limit = {256 << 10, 256 << 10};
    setrlimit(RLIMIT_STACK, &limit);
  };
#endif
  Outcome outcome = program.Run();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error.substr(0, 1000);
}

TEST_F(Hostile, AWideSum) {
  std::vector<NodeText> nodes;
  std::vector<std::string> level;
  for (int i = 0; i < 4096; ++i) {
    nodes.push_back({fmt::format("v{}", i), "value_noise", fmt::format("\"seed\": {}", i)});
    level.push_back(fmt::format("v{}", i));
  }
  for (int depth = 0; level.size() > 1; ++depth) {
    std::vector<std::string> next;
    for (size_t i = 0; i + 1 < level.size(); i += 2) {
      std::string name = fmt::format("s{}_{}", depth, i);
      nodes.push_back({name, "add", Inputs(Quoted(level[i]), Quoted(level[i + 1]))});
      next.push_back(name);
    }
    level = next;
  }
  Result result = Run(GraphOf(nodes, level[0]), "graph.json", 60);
  EXPECT_EQ(result.outcome.exit_code, 0) << result.outcome.error.substr(0, 1000);
}

// One value of 100,000: each is added to the sum before it.
TEST_F(Hostile, ALongSum) {
  std::vector<NodeText> nodes = {{"n0", "value_noise", ""}};
  for (int i = 1; i < 100'000; ++i) {
    nodes.push_back({fmt::format("n{}", i), "add",
                     Inputs(fmt::format("\"n{}\"", i - 1), fmt::format("\"n{}\"", i / 2))});
  }
  Result result = Run(GraphOf(nodes, "n99999"), "graph.json", 60);
  EXPECT_EQ(result.outcome.exit_code, 0) << result.outcome.error.substr(0, 1000);
  EXPECT_LE(MostInAStatement(result.shader, '+'), 50) << "one long expression";
}

TEST_F(Hostile, AMillionNodes) {
  std::string text = "{ \"texgraph\": 1, \"nodes\": {";
  for (int i = 0; i < 1'000'000; ++i) {
    text += fmt::format("{}\"n{}\":{{\"block\":\"add\",\"in\":{{\"a\":{}}}}}", i == 0 ? "" : ",", i,
                        i == 0 ? "1" : fmt::format("\"n{}\"", i - 1));
  }
  text += "}, \"outputs\": { \"height\": \"n999999\" } }";
  Result result = Run(text, "graph.json", 120);
  EXPECT_TRUE(result.outcome.exit_code == 0 || result.outcome.exit_code == 4)
      << result.outcome.error.substr(0, 1000);
}

TEST_F(Hostile, ThingsThatAreNotThere) {
  ExpectRefused(GraphOf({{"a", "add", Inputs("\"nothing\"", "1")}}, "a"), 1, "unknown-reference");
  ExpectRefused(GraphOf({{"a", "add", Inputs("1", "1")}}, "b"), 1, "unknown-reference");
  ExpectRefused(GraphOf({{"a", "teapot", ""}}, "a"), 1, "unknown-block");
  ExpectRefused(GraphOf({{"a", "add", "\"c\": 1, \"a\": 1"}}, "a"), 1, "unknown-port");
  ExpectRefused(GraphOf({{"a", "add", ""}}, "a"), 1, "missing-input");
  ExpectRefused(GraphOf({{"a", "add", "\"a\": 1, \"a\": 2"}}, "a"), 1, "duplicate-key");
  ExpectRefused(GraphOf({{"a", "add", Inputs("1", "1")}, {"a", "add", Inputs("1", "1")}}, "a"), 1,
                "duplicate-key");
}

TEST_F(Hostile, EndlessLoopsAndHugeCounts) {
  std::filesystem::create_directory(folder / "blocks");
  folder.Write(
      "blocks/rounds.glsl",
      "/// Goes round.\n/// @param x start\n/// @param n rounds\n"
      "float rounds(float x, const int n) { for (int i = 0; i < n; i++) x = sin(x); return x; }\n");
  folder.Write("blocks/nested.glsl",
               "/// Goes round in rounds.\n/// @param x start\n/// @param n rounds\n"
               "float nested(float x, const int n) {\n  for (int i = 0; i < n; i++) for (int j = "
               "0; j < n; j++) x = sin(x);\n"
               "  return x;\n}\n");
  auto run = [&](const std::string& block, const std::string& n) {
    folder.Write(
        "g.json",
        GraphOf({{"v", "value_noise", ""}, {"a", block, "\"x\": \"v\", \"n\": " + n}}, "a"));
    Program program = Texgraphc({"g.json", "-I", "blocks", "-o", "-"}, folder.path());
    program.time_limit = 20;
    Outcome outcome = program.Run();
    EXPECT_FALSE(outcome.timed_out) << block << n;
    return outcome;
  };
  EXPECT_EQ(run("rounds", "0").exit_code, 0);
  EXPECT_EQ(run("rounds", "-1").exit_code, 0);
  EXPECT_EQ(run("rounds", "65535").exit_code, 0);
  for (auto [block, n] : {std::pair("rounds", "1000000000"), std::pair("rounds", "2147483647"),
                          std::pair("nested", "300")}) {
    Outcome outcome = run(block, n);
    EXPECT_EQ(outcome.exit_code, 4) << block << " " << n << outcome.error;
    EXPECT_THAT(outcome.error, testing::HasSubstr("[loop-limit]"));
    EXPECT_THAT(outcome.error, testing::HasSubstr("65535"));
  }
  EXPECT_EQ(run("rounds", "2147483648").exit_code, 1);
}

// Nothing that is folded may leave an infinity or a NaN in the text, since GLSL has no word for
// them.
TEST_F(Hostile, ConstantsWithoutAValue) {
  const std::vector<std::pair<std::string, std::string>> kCases = {
      {"divide", Inputs("1", "0")},
      {"divide", Inputs("0", "0")},
      {"divide", Inputs("-1", "0")},
      {"square_root", "\"value\": -1"},
      {"power", "\"base\": -1, \"exponent\": 0.5"},
      {"modulo", Inputs("5", "0")},
      {"multiply", Inputs("3e38", "3e38")},
      {"add", Inputs("3e38", "3e38")},
  };
  for (const auto& [block, inputs] : kCases) {
    Result result = Run(GraphOf({{"a", block, inputs}}, "a"));
    EXPECT_TRUE(result.outcome.exit_code == 0 || result.outcome.exit_code == 1)
        << block << result.outcome.error;
    for (const char* word : {"inf", "nan", "INF", "NAN", "1.#"}) {
      EXPECT_EQ(result.shader.find(word), std::string::npos) << block << inputs << result.shader;
    }
  }
}

TEST_F(Hostile, LiteralsKeepTheirValue) {
  for (auto [literal, printed] :
       {std::pair("1e-45", "1e-45"), std::pair("3.4028235e38", "3.4028235e38"),
        std::pair("16777217", "16777216.0"), std::pair("0.1", "0.1")}) {
    std::string shader = ExpectAccepted(
        GraphOf({{"v", "value_noise", ""}, {"a", "maximum", Inputs("\"v\"", literal)}}, "a"));
    EXPECT_THAT(shader, testing::HasSubstr(printed));
  }
}

}  // namespace
}  // namespace texgraph
