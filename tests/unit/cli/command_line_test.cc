// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "cli/texgraphc/help.h"
#include "cli/texgraphc/options.h"

namespace texgraph::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::optional<CommandLine> Read(std::vector<const char*> arguments, Diagnostics& diagnostics) {
  arguments.insert(arguments.begin(), "texgraphc");
  return ReadCommandLine(static_cast<int>(arguments.size()), arguments.data(), diagnostics);
}

Options Good(std::vector<const char*> arguments) {
  Diagnostics diagnostics;
  auto line = Read(std::move(arguments), diagnostics);
  EXPECT_FALSE(diagnostics.HasErrors()) << FormatDiagnostics(diagnostics, Sources(), false);
  return line ? line->options : Options();
}

// The first message of a command line that must be refused.
std::string Refused(std::vector<const char*> arguments) {
  Diagnostics diagnostics;
  EXPECT_FALSE(Read(std::move(arguments), diagnostics).has_value());
  EXPECT_EQ(diagnostics.exit_code(), ExitCode::kUsage);
  return diagnostics.all().empty() ? "" : diagnostics.all()[0].message;
}

TEST(CommandLine, Defaults) {
  Options options = Good({"a.json"});
  EXPECT_THAT(options.graphs, ElementsAre("a.json"));
  EXPECT_EQ(options.compile.target, Target::kGlsl330);
  EXPECT_EQ(options.compile.emit, Emit::kShader);
  EXPECT_EQ(options.jobs, 1u);
  EXPECT_FALSE(options.write_dependencies || options.no_warnings || options.warnings_are_errors);
  EXPECT_TRUE(options.OutputIsFolder());
}

TEST(CommandLine, EverySpelling) {
  Options options = Good({"-o",     "x.frag",         "-Ione",        "-I",       "two",
                          "a.json", "--target=spirv", "--set",        "a=-1",     "--set=b=[1, 0]",
                          "-MD",    "-MFx.d",         "-MT",          "all",      "-j4",
                          "-w",     "-Werror",        "--dump-after", "build",    "--color",
                          "always", "--manifest",     "m.json",       "--format", "yaml"});
  EXPECT_EQ(options.output, "x.frag");
  EXPECT_FALSE(options.OutputIsFolder());
  EXPECT_THAT(options.compile.block_folders, ElementsAre("one", "two"));
  EXPECT_THAT(options.compile.settings, ElementsAre("a=-1", "b=[1, 0]"));
  EXPECT_THAT(options.compile.dump_after, ElementsAre("build"));
  EXPECT_EQ(options.compile.target, Target::kSpirv);
  EXPECT_TRUE(options.write_dependencies && options.no_warnings && options.warnings_are_errors &&
              options.color);
  EXPECT_EQ(options.dependency_file, "x.d");
  EXPECT_EQ(options.dependency_target, "all");
  EXPECT_EQ(options.jobs, 4u);
  EXPECT_EQ(options.manifest, "m.json");
  EXPECT_EQ(options.format, graph::DocumentFormat::kYaml);
  EXPECT_THAT(options.graphs, ElementsAre("a.json"));
}

TEST(CommandLine, TheLastOneCountsAndMfMeansMd) {
  EXPECT_EQ(Good({"-o", "a", "-o", "b", "g"}).output, "b");
  EXPECT_EQ(Good({"--target", "spirv", "--target", "glsl450", "g"}).compile.target,
            Target::kGlsl450);
  EXPECT_TRUE(Good({"-MF", "x.d", "g"}).write_dependencies);
  EXPECT_FALSE(Good({"--color", "never", "g"}).color);
}

TEST(CommandLine, SeveralGraphsDashAndDashDash) {
  EXPECT_THAT(Good({"a", "b", "-o", "out"}).graphs, ElementsAre("a", "b"));
  EXPECT_TRUE(Good({"a", "b", "-o", "out"}).OutputIsFolder());
  EXPECT_THAT(Good({"-"}).graphs, ElementsAre("-"));
  EXPECT_EQ(Good({"-", "-o", "-"}).output, "-");
  EXPECT_THAT(Good({"--", "-odd.json", "-MD"}).graphs, ElementsAre("-odd.json", "-MD"));
}

TEST(CommandLine, RefusalsAndHints) {
  EXPECT_EQ(Refused({}), "no graph given");
  EXPECT_EQ(Refused({"--targt", "spirv", "g"}),
            "unknown option '--targt'; did you mean '--target'?");
  EXPECT_EQ(Refused({"-Werrror", "g"}), "unknown option '-Werrror'; did you mean '-Werror'?");
  EXPECT_EQ(Refused({"-q", "g"}), "unknown option '-q'");
  EXPECT_EQ(Refused({"--target", "glsl45", "g"}),
            "--target takes glsl330, glsl450 or spirv, got 'glsl45'; did you mean 'glsl450'?");
  EXPECT_EQ(Refused({"--emit", "x", "g"}), "--emit takes shader or function, got 'x'");
  EXPECT_EQ(Refused({"--dump-after", "simplfy", "g"}),
            "--dump-after takes build, specialize, simplify, differentiate, legalize or all, got "
            "'simplfy'; did you mean "
            "'simplify'?");
  EXPECT_EQ(Refused({"g", "-o"}), "-o needs a value");
  EXPECT_EQ(Refused({"g", "-MF"}), "-MF needs a value");
  EXPECT_EQ(Refused({"g", "-o", ""}), "-o needs a value");
  EXPECT_EQ(Refused({"g", "-MD", "-MF", ""}), "-MF needs a value");
  for (const char* jobs : {"x", "-1", "257", "4x", "", "99999999999999999999"}) {
    EXPECT_THAT(Refused({"-j", jobs, "g"}), HasSubstr("-j takes a number from 0 to 256")) << jobs;
  }
  EXPECT_THAT(Refused({"--target", "\x1b[31m", "g"}), HasSubstr("'\\x1b[31m'"));
}

TEST(CommandLine, OptionsThatExcludeEachOther) {
  EXPECT_THAT(Refused({"--target", "spirv", "--emit", "function", "g"}),
              HasSubstr("--emit function"));
  EXPECT_THAT(Refused({"a", "b", "-o", "-"}), HasSubstr("standard output"));
  EXPECT_THAT(Refused({"a", "b", "--manifest", "m"}), HasSubstr("--manifest"));
  EXPECT_THAT(Refused({"a", "b", "-MF", "m"}), HasSubstr("-MF"));
  EXPECT_THAT(Refused({"a", "b", "-MT", "m"}), HasSubstr("-MT"));
  EXPECT_THAT(Refused({"a", "-MT", "m"}), HasSubstr("add -MD"));
  EXPECT_THAT(Refused({"a", "-o", "-", "-MD"}), HasSubstr("-MD needs -MF"));
  EXPECT_THAT(Refused({"-", "-"}), HasSubstr("only once"));
}

TEST(CommandLine, HelpAndVersionNeedNoGraph) {
  Diagnostics diagnostics;
  EXPECT_EQ(Read({"--help"}, diagnostics)->text, kHelp);
  EXPECT_EQ(Read({"-h", "--target", "nonsense"}, diagnostics)->text, kHelp);
  EXPECT_THAT(Read({"--version"}, diagnostics)->text, testing::StartsWith("texgraphc "));
  EXPECT_TRUE(Read({"--list-blocks"}, diagnostics)->options.list_blocks);
  EXPECT_EQ(Read({"--print-reference", "add"}, diagnostics)->options.reference, "add");
  EXPECT_FALSE(diagnostics.HasErrors());
}

// The option names at the beginnings of lines, after `prefix`.
std::set<std::string> OptionsIn(std::string_view text, const std::string& prefix,
                                const std::string& separators) {
  std::set<std::string> names;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(prefix + "-")) continue;
    for (size_t at = line.find('-'); at != std::string::npos; at = line.find(", ", at)) {
      at = line.find('-', at);
      size_t end = line.find_first_of(separators, at);
      names.insert(line.substr(at, end - at));
      if (line.compare(std::min(end, line.size()), 2, ", ") != 0 &&
          line.compare(std::min(end, line.size()), 3, "`, ") != 0)
        break;
    }
  }
  return names;
}

TEST(CommandLine, TheDocumentDescribesTheOptionsOfTheHelp) {
  std::ifstream file(TEXGRAPH_SOURCE_DIR "/docs/texgraphc.md");
  std::ostringstream document;
  document << file.rdbuf();
  std::set<std::string> help = OptionsIn(kHelp, "  ", " ,");
  EXPECT_EQ(OptionsIn(document.str(), "`", " `"), help);
  EXPECT_GE(help.size(), 20u);
}

TEST(CommandLine, EveryLineOfTheHelpFitsATerminal) {
  std::istringstream lines{std::string(kHelp)};
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 112u) << line;
}

}  // namespace
}  // namespace texgraph::cli
