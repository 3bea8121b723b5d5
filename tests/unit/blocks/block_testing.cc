// SPDX-License-Identifier: Apache-2.0
#include "tests/unit/blocks/block_testing.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <bit>
#include <filesystem>
#include <fstream>

#include "compiler/ir/evaluate.h"
#include "compiler/ir/verify.h"

namespace texgraph::blocks {

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "texgraph_blocks_XXXXXX").string();
  path_ = mkdtemp(name.data()) ? name : "";
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
}

std::string TemporaryFolder::Write(std::string_view name, std::string_view text) const {
  std::filesystem::path path = std::filesystem::path(path_) / name;
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
  return path.string();
}

namespace {

std::string WriteAll(const TemporaryFolder& folder, const Files& files) {
  for (const auto& [name, text] : files) folder.Write(name, text);
  return folder.path();
}

}  // namespace

TestLibrary::TestLibrary(const Files& files, bool fold)
    : library(module, sources, diagnostics, {WriteAll(folder, files)}, fold) {}

ir::FunctionId TestLibrary::Function(std::string_view name, size_t overload,
                                     const std::vector<uint32_t>& template_words) {
  const Block* block = library.Find(name);
  if (!block || overload >= block->overloads.size()) return {};
  std::vector<ir::ConstId> values;
  size_t next = 0;
  for (const Port& port : block->overloads[overload].inputs) {
    if (port.kind != PortKind::kTemplate) continue;
    ir::TypeId type = ValueType(module, port);
    std::vector<uint32_t> words(module.types.Words(type));
    for (uint32_t& word : words) word = next < template_words.size() ? template_words[next++] : 0;
    values.push_back(module.Intern(type, words));
  }
  return library.Function(*block, block->overloads[overload], values);
}

ir::TypeId ValueType(ir::Module& module, const Port& port) {
  if (port.max_length == 0) return port.type;
  uint32_t length = std::clamp(2u, port.min_length, port.max_length);
  return module.types.Array(module.types.ElementType(port.type, 0), length);
}

std::string TestLibrary::Report() const {
  std::string report;
  auto place = [&](SourceRange range) {
    if (!range.source.valid()) return std::string();
    LineColumn at = sources.Locate(range.source, range.begin);
    std::string name = std::filesystem::path(sources.Name(range.source)).filename().string();
    return name + ":" + std::to_string(at.line) + ":" + std::to_string(at.column) + ": ";
  };
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    report += place(diagnostic.range) + diagnostic.message + " [" +
              std::string(DiagnosticName(diagnostic.kind)) + "]\n";
    for (const Diagnostic::Note& note : diagnostic.notes) {
      report += "  " + place(note.range) + note.message + "\n";
    }
  }
  return report;
}

std::string ReportOf(std::string_view text) {
  TestLibrary test({{"x.glsl", std::string(text)}});
  if (const Block* block = test.library.Find("x")) {
    for (size_t i = 0; i < block->overloads.size(); ++i) test.Function("x", i);
  }
  std::string report = test.Report(), shorter;
  // The file's name is always the same.
  for (size_t at = 0; at < report.size();) {
    size_t end = report.find('\n', at) + 1;
    std::string line = report.substr(at, end - at);
    size_t name = line.find("x.glsl:");
    if (name != std::string::npos && name <= 2) line.erase(name, 7);
    shorter += line;
    at = end;
  }
  return shorter;
}

uint32_t Bits(float value) { return std::bit_cast<uint32_t>(value); }

std::vector<uint32_t> Bits(const std::vector<float>& values) {
  std::vector<uint32_t> bits;
  for (float value : values) bits.push_back(Bits(value));
  return bits;
}

std::vector<std::vector<uint32_t>> RunFunction(
    const ir::Module& module, ir::FunctionId function,
    const std::vector<std::vector<uint32_t>>& arguments) {
  EXPECT_EQ(ir::Verify(module), "");
  ir::EvaluateInputs inputs;
  std::vector<std::vector<uint32_t>> lanes;
  for (const std::vector<uint32_t>& argument : arguments) {
    std::vector<uint32_t>& words = lanes.emplace_back();
    for (uint32_t word : argument) words.insert(words.end(), inputs.lanes, word);
  }
  std::vector<std::vector<uint32_t>> results = ir::Evaluate(module, function, inputs, lanes);
  for (std::vector<uint32_t>& result : results) {
    std::vector<uint32_t> first;
    for (size_t i = 0; i < result.size(); i += inputs.lanes) first.push_back(result[i]);
    result = first;
  }
  return results;
}

}  // namespace texgraph::blocks
