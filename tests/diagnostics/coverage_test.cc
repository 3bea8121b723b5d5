// SPDX-License-Identifier: Apache-2.0
// Every kind of diagnostic has a test, and a line in docs/diagnostics.md.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include "compiler/base/diagnostics.h"

namespace texgraph {
namespace {

namespace fs = std::filesystem;

const std::string kRoot = TEXGRAPH_SOURCE_DIR "/";

std::string ReadText(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream out;
  out << file.rdbuf();
  return out.str();
}

std::set<std::string> AllNames() {
  std::set<std::string> names;
  for (size_t i = 0; i < DiagnosticKindCount(); ++i)
    names.emplace(DiagnosticName(static_cast<DiagnosticKind>(i)));
  return names;
}

// tested_elsewhere.txt: a name, the file of the test, and a text that stands in it where the kind
// is expected.
struct Elsewhere {
  std::string file;
  std::string text;
};

std::map<std::string, Elsewhere> ReadElsewhere() {
  std::map<std::string, Elsewhere> entries;
  std::ifstream file(kRoot + "tests/diagnostics/tested_elsewhere.txt");
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream words(line);
    std::string name;
    Elsewhere entry;
    words >> name >> entry.file >> std::ws;
    std::getline(words, entry.text);
    entries[name] = entry;
  }
  return entries;
}

TEST(Coverage, EveryKindHasATest) {
  std::string expected;
  for (const auto& entry : fs::directory_iterator(kRoot + "tests/diagnostics")) {
    if (entry.path().extension() == ".expected") expected += ReadText(entry.path());
  }
  std::map<std::string, Elsewhere> elsewhere = ReadElsewhere();
  for (const std::string& name : AllNames()) {
    bool here = expected.find(" [" + name + "]\n") != std::string::npos;
    EXPECT_TRUE(here || elsewhere.contains(name)) << "no test expects [" << name << "]";
    EXPECT_FALSE(here && elsewhere.contains(name))
        << name << " needs no line in tested_elsewhere.txt";
  }
}

TEST(Coverage, TestsElsewhereAreThere) {
  std::set<std::string> names = AllNames();
  for (const auto& [name, entry] : ReadElsewhere()) {
    EXPECT_TRUE(names.contains(name)) << name;
    std::string text = ReadText(kRoot + entry.file);
    EXPECT_FALSE(entry.text.empty()) << name;
    EXPECT_NE(text.find(entry.text), std::string::npos)
        << entry.file << " has no '" << entry.text << "'";
  }
}

TEST(Coverage, TheDocumentListsEveryName) {
  std::string text = ReadText(kRoot + "docs/diagnostics.md");
  std::set<std::string> documented;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("| `")) continue;
    documented.insert(line.substr(3, line.find('`', 3) - 3));
  }
  std::set<std::string> names = AllNames();
  EXPECT_EQ(documented, names);
}

}  // namespace
}  // namespace texgraph
