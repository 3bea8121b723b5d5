// SPDX-License-Identifier: Apache-2.0
// docs/from-layers-to-shader.md: its commands run, its changes make the graphs of docs/first_wall,
// and these look like its pictures.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "compiler/textures/image.h"
#include "tests/unit/base/scratch_folder.h"
#include "tests/unit/cli/page.h"
#include "tests/unit/cli/program.h"

namespace texgraph {
namespace {

namespace fs = std::filesystem;

const fs::path kDocs = fs::path(TEXGRAPH_SOURCE_DIR) / "docs";
constexpr int kSteps = 10;

std::string ReadText(const fs::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string StepFile(int step) { return "step_" + std::to_string(step) + ".json"; }

// The page's part from one heading to the next; "" if there is none.
std::string Section(const std::string& heading) {
  const std::string page = ReadText(kDocs / "from-layers-to-shader.md");
  const size_t begin = page.find("\n## " + heading);
  return begin == std::string::npos ? ""
                                    : page.substr(begin, page.find("\n## ", begin + 1) - begin);
}

std::string SectionOfStep(int step) { return Section("Step " + std::to_string(step) + ":"); }

// Lines without the spaces and the comma around them: a comma comes and goes with the next line.
std::vector<std::string> Lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    const size_t begin = line.find_first_not_of(' ');
    if (begin == std::string::npos) continue;
    line = line.substr(begin);
    if (line.back() == ',') line.pop_back();
    lines.push_back(line);
  }
  return lines;
}

// Short code within a sentence.
std::vector<std::string> Quoted(const std::string& text) {
  std::vector<std::string> found;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```")) continue;
    for (size_t at = line.find('`'); at != std::string::npos; at = line.find('`', at)) {
      const size_t end = line.find('`', at + 1);
      if (end == std::string::npos) break;
      found.push_back(line.substr(at + 1, end - at - 1));
      at = end + 1;
    }
  }
  return found;
}

bool Contains(const std::vector<std::string>& lines, const std::vector<std::string>& part) {
  return std::search(lines.begin(), lines.end(), part.begin(), part.end()) != lines.end();
}

TEST(LayersPage, ChangesStandInTheGraphOfTheirStep) {
  for (int step = 1; step <= kSteps; ++step) {
    const std::vector<std::string> graph = Lines(ReadText(kDocs / "first_wall" / StepFile(step)));
    const std::vector<std::string> changes = Fenced(SectionOfStep(step), "json");
    EXPECT_FALSE(changes.empty()) << step;
    for (const std::string& change : changes) {
      EXPECT_TRUE(Contains(graph, Lines(change))) << StepFile(step) << " lacks\n" << change;
    }
  }
}

// Whoever does what the page says gets the next graph: each new line of it is shown or named.
TEST(LayersPage, ShowsAllThatChanges) {
  for (int step = 2; step <= kSteps; ++step) {
    const std::vector<std::string> before =
        Lines(ReadText(kDocs / "first_wall" / StepFile(step - 1)));
    std::set<std::string> known(before.begin(), before.end());
    for (const std::string& change : Fenced(SectionOfStep(step), "json")) {
      for (const std::string& line : Lines(change)) known.insert(line);
    }
    const std::vector<std::string> named = Quoted(SectionOfStep(step));
    for (const std::string& line : Lines(ReadText(kDocs / "first_wall" / StepFile(step)))) {
      const bool is_named = std::any_of(named.begin(), named.end(), [&](const std::string& code) {
        return code.starts_with('"') && line.find(code) != std::string::npos;
      });
      EXPECT_TRUE(known.contains(line) || is_named) << StepFile(step) << ": " << line;
    }
  }
}

// A folder that looks like the project after ./demo.sh.
class LayersPageProject : public testing::Test {
 protected:
  LayersPageProject() {
    fs::create_directories(folder / "build/release");
    fs::create_directory_symlink(fs::path(TEXGRAPH_PROGRAM).parent_path(),
                                 folder / "build/release/bin");
    fs::create_directory_symlink(kDocs, folder / "docs");
    fs::create_directory_symlink(kDocs.parent_path() / "graphs", folder / "graphs");
  }
  Outcome Shell(const std::string& script) const {
    Program program;
    program.path = "/bin/sh";
    program.folder = folder.path();
    program.arguments = {"-e", "-c", script};
    program.time_limit = 240;
    return program.Run();
  }

  ScratchFolder folder;
};

TEST_F(LayersPageProject, CommandsRunAsTheyArePrinted) {
  std::string script;
  const std::string page = ReadText(kDocs / "from-layers-to-shader.md");
  for (const std::string& block : Fenced(page.substr(0, page.find("\n## ")), "sh")) script += block;
  for (int step = 1; step <= kSteps; ++step) {
    script += "cp ../../docs/first_wall/" + StepFile(step) + " wall.json\n";
    for (const std::string& block : Fenced(SectionOfStep(step), "sh")) script += block;
    script += "texgraphc -Werror wall.json -o step.frag\n";
  }
  const std::vector<std::string> last = Fenced(Section("The shader"), "sh");
  ASSERT_EQ(last.size(), 1u);
  // Meshes take long at their full size.
  for (size_t at = 0; (at = script.find(" --mesh", at)) != std::string::npos; at += 17)
    script.insert(at, " --size 64");
  const Outcome outcome = Shell(script + last[0]);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error << "\n" << script;
  for (const char* file : {"wall.png", "on_a_wall.png", "on_a_sphere.png", "far.png", "other.png",
                           "growing.png", "wall.frag", "wall.manifest.json", "wall.leaf.png"}) {
    EXPECT_TRUE(fs::exists(folder.path() + "/out/my_wall/" + file)) << file;
  }
}

textures::Image Picture(const std::string& path) {
  Diagnostics diagnostics;
  auto image = textures::ReadImage(path, {}, diagnostics);
  EXPECT_TRUE(image) << path;
  return image ? *image : textures::Image();
}

// The mean difference of red, green and blue, of 255.
double Difference(const textures::Image& a, const textures::Image& b) {
  double sum = 0;
  for (uint32_t y = 0; y < a.height; ++y) {
    for (uint32_t x = 0; x < a.width; ++x) {
      for (uint32_t c = 0; c < 3; ++c)
        sum += std::abs(static_cast<double>(a.At(x, y, c)) - static_cast<double>(b.At(x, y, c)));
    }
  }
  return sum / (3.0 * a.width * a.height);
}

// The page's pictures have palettes, which costs up to 2.5 of 255; a step that lacks its change is
// further off.
TEST_F(LayersPageProject, PicturesShowTheSteps) {
  fs::create_directories(folder / "work");
  for (const auto& file : fs::directory_iterator(kDocs.parent_path() / "graphs/first_wall"))
    fs::copy_file(file.path(), folder / ("work/" + file.path().filename().string()));
  for (int step = 1; step <= 7; ++step) {
    const std::string number = std::to_string(step);
    fs::copy_file(kDocs / "first_wall" / StepFile(step), folder / ("work/" + StepFile(step)));
    const Outcome outcome = Shell("build/release/bin/texgraph render work/" + StepFile(step) +
                                  " -q --size 400 -o " + number + ".png");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
    EXPECT_EQ(outcome.error, "");
    const textures::Image drawn = Picture(folder / (number + ".png"));
    const textures::Image shown =
        Picture(kDocs / "pictures/first_wall" / ("step_" + number + ".png"));
    ASSERT_EQ(drawn.width, shown.width);
    ASSERT_EQ(drawn.height, shown.height);
    EXPECT_LT(Difference(drawn, shown), 3.5) << step;
  }
}

}  // namespace
}  // namespace texgraph
