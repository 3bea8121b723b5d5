// SPDX-License-Identifier: Apache-2.0
// What --dump-after prints of every example graph, after every phase, is IR that reads back as it
// was: all names are told apart, and the verifier is content.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "compiler/compile.h"
#include "compiler/ir/module.h"
#include "compiler/ir/print.h"

namespace texgraph {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMark = "// after ";

// Each phase's text.
std::vector<std::string> Phases(const std::string& dump) {
  std::vector<std::string> phases;
  for (size_t at = 0; at < dump.size();) {
    size_t end = std::min(dump.find(std::string("\n") + std::string(kMark), at), dump.size());
    phases.push_back(dump.substr(at, end - at));
    at = end + 1;
  }
  return phases;
}

void ExpectReadsBack(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(file)), {});
  Sources sources;
  Diagnostics diagnostics;
  graph::DocumentFormat format = graph::FormatOf(path.string(), text);
  CompileOptions options;
  options.dump_after = {"all"};
  SourceId source = sources.Add(path.string(), std::move(text));
  auto lowered = Lower(source, format, options, sources, diagnostics);
  ASSERT_TRUE(lowered) << FormatDiagnostics(diagnostics, sources, false);
  std::vector<std::string> phases = Phases(lowered->dump);
  EXPECT_EQ(phases.size(), 5u) << path;
  for (const std::string& phase : phases) {
    std::string name = path.filename().string() + ", " + phase.substr(0, phase.find('\n'));
    std::string body = phase.substr(phase.find('\n') + 1);
    auto module = ir::Parse(sources.Add("dump", body), sources, diagnostics);
    ASSERT_TRUE(module) << name << "\n" << FormatDiagnostics(diagnostics, sources, false);
    EXPECT_EQ(ir::Print(*module), body.substr(0, body.find_last_not_of('\n') + 1) + "\n") << name;
    std::set<std::string> names;
    for (const ir::Function& function : module->functions)
      EXPECT_TRUE(names.insert(function.name).second) << name << ": two are " << function.name;
  }
}

TEST(Dump, OfEveryGraphAndPhaseReadsBack) {
  size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(TEXGRAPH_SOURCE_DIR "/graphs")) {
    const std::string extension = entry.path().extension();
    if (extension != ".json" && extension != ".jsonc" && extension != ".yaml") continue;
    ++count;
    ExpectReadsBack(entry.path());
  }
  EXPECT_GE(count, 5u);
}

}  // namespace
}  // namespace texgraph
