// SPDX-License-Identifier: Apache-2.0
// Compiles every graph under graphs/ to every dialect and form and compares shader and manifest
// with the files of this folder, to the byte. TEXGRAPH_UPDATE=1 in the environment writes them
// anew. Whatever is emitted must also please glslangValidator, spirv-val and the manifest's schema.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>
#include <vector>

#include "tests/unit/base/scratch_folder.h"
#include "tests/unit/cli/program.h"

namespace texgraph {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = TEXGRAPH_SOURCE_DIR;
const fs::path kGolden = kRoot / "tests/golden";

std::string ReadText(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream out;
  out << file.rdbuf();
  return out.str();
}

bool Updating() {
  const char* update = std::getenv("TEXGRAPH_UPDATE");
  return update != nullptr && *update != '\0' && std::string_view(update) != "0";
}

// The graphs of the project, as paths from its root, in order.
std::set<fs::path> Graphs() {
  static const std::set<std::string> kExtensions = {".json", ".jsonc", ".yaml"};
  std::set<fs::path> graphs;
  for (const auto& folder : fs::directory_iterator(kRoot / "graphs")) {
    if (!folder.is_directory()) continue;
    for (const auto& file : fs::directory_iterator(folder.path())) {
      if (kExtensions.contains(file.path().extension()))
        graphs.insert(fs::relative(file.path(), kRoot));
    }
  }
  return graphs;
}

Outcome RunTool(const char* path, std::vector<std::string> arguments) {
  Program program;
  program.path = path;
  program.arguments = std::move(arguments);
  return program.Run();
}

// glslangValidator's opinion of a fragment shader.
void ExpectValidGlsl(const ScratchFolder& scratch, const std::string& text) {
  scratch.Write("check.frag", text);
  Outcome outcome = RunTool(GLSLANG_VALIDATOR, {scratch / "check.frag"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << text;
}

// The function as somebody would paste it: after a version, before a main that does not know it.
std::string Pasted(const std::string& function, const std::string& target) {
  return (target == "glsl450" ? "#version 450 core\n" : "#version 330\n") + function +
         "\nvoid main() {}\n";
}

void ExpectValidManifest(const std::string& text) {
  nlohmann::json schema_json = nlohmann::json::parse(ReadText(kRoot / "docs/manifest.schema.json"));
  nlohmann::json manifest = nlohmann::json::parse(text);
  valijson::Schema schema;
  valijson::SchemaParser parser;
  valijson::adapters::NlohmannJsonAdapter schema_adapter(schema_json), manifest_adapter(manifest);
  parser.populateSchema(schema_adapter, schema);
  valijson::Validator validator;
  valijson::ValidationResults results;
  EXPECT_TRUE(validator.validate(schema, manifest_adapter, &results));
  for (valijson::ValidationResults::Error error; results.popError(error);) {
    for (const std::string& part : error.context) ADD_FAILURE() << part;
    ADD_FAILURE() << error.description << "\n" << text;
  }
}

void ExpectGolden(const fs::path& golden, const std::string& seen) {
  if (Updating()) {
    fs::create_directories(golden.parent_path());
    std::ofstream(golden, std::ios::binary) << seen;
  }
  EXPECT_EQ(seen, ReadText(golden)) << golden;
}

// One graph, one target, one form.
class Golden : public testing::Test {
 public:
  Golden(fs::path graph, std::string target, std::string form)
      : graph_(std::move(graph)), target_(std::move(target)), form_(std::move(form)) {}

  void TestBody() override {
    ScratchFolder scratch;
    fs::create_directory_symlink(kRoot / "graphs",
                                 scratch / "graphs");  // the manifest has paths from there
    std::string extension = target_ == "spirv" ? "spv" : form_ == "function" ? "glsl" : "frag";
    std::string name = graph_.stem().string() + "." + extension;
    Outcome outcome =
        Texgraphc({graph_, "-o", name, "--target", target_, "--emit", form_}, scratch.path()).Run();
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
    EXPECT_EQ(outcome.error, "");
    std::string shader = scratch.Read(name),
                manifest = scratch.Read(graph_.stem().string() + ".json");
    ExpectValidManifest(manifest);
    fs::path folder = kGolden / graph_.parent_path().filename();
    std::string stem = graph_.stem().string() + "." + target_;
    if (target_ == "spirv") {
      Outcome valid = RunTool(SPIRV_VAL, {"--target-env", "opengl4.5", scratch / name});
      EXPECT_EQ(valid.exit_code, 0) << valid.error;
      EXPECT_EQ(shader.substr(0, 4), "\x03\x02\x23\x07");
    } else {
      ExpectValidGlsl(scratch, form_ == "function" ? Pasted(shader, target_) : shader);
      ExpectGolden(folder / (stem + "." + extension), shader);
    }
    ExpectGolden(folder / (stem + "." + form_ + ".json"), manifest);
  }

 private:
  fs::path graph_;
  std::string target_, form_;
};

bool RegisterGolden() {
  for (const fs::path& graph : Graphs()) {
    for (auto [target, form] :
         std::initializer_list<std::pair<const char*, const char*>>{{"glsl330", "shader"},
                                                                    {"glsl330", "function"},
                                                                    {"glsl450", "shader"},
                                                                    {"glsl450", "function"},
                                                                    {"spirv", "shader"}}) {
      std::string name = graph.stem().string() + "_" + target + "_" + form;
      testing::RegisterTest("Golden", name.c_str(), nullptr, nullptr, __FILE__, __LINE__,
                            [=]() -> testing::Test* { return new Golden(graph, target, form); });
    }
  }
  return true;
}

const bool registered = RegisterGolden();

// Uniforms are the user's and may be shared; everything else begins with the graph's name.
TEST(Functions, OfAllGraphsStandInOneShader) {
  std::string all;
  std::set<std::string> uniforms;
  for (const fs::path& graph : Graphs()) {
    const std::string stem = graph.stem().string() + ".glsl330.glsl";
    std::istringstream lines(ReadText(kGolden / graph.parent_path().filename() / stem));
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("uniform ") && !uniforms.insert(line.substr(0, line.find(';'))).second)
        continue;
      all += line + "\n";
    }
  }
  ASSERT_NE(all, "");
  ExpectValidGlsl(ScratchFolder(), Pasted(all, "glsl330"));
}

TEST(GoldenFiles, BelongToGraphs) {
  std::set<std::string> graphs;
  for (const fs::path& graph : Graphs()) graphs.insert(graph.parent_path().filename());
  for (const auto& entry : fs::directory_iterator(kGolden)) {
    if (entry.is_directory()) {
      EXPECT_TRUE(graphs.contains(entry.path().filename())) << entry.path() << " is left over";
    }
  }
  EXPECT_GE(graphs.size(), 5u);
}

}  // namespace
}  // namespace texgraph
