// SPDX-License-Identifier: Apache-2.0
// Blocks for tests, from texts: their files stand in a folder of their own that is gone with the
// object.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/base/source.h"
#include "compiler/blocks/block.h"
#include "compiler/ir/module.h"

namespace texgraph::blocks {

// A folder under the system's for temporary files.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::string& path() const { return path_; }
  // Writes `text` to `name`, with the folders on the way.
  std::string Write(std::string_view name, std::string_view text) const;

 private:
  std::string path_;
};

// Pairs of a path ("math/half.glsl") and a text.
using Files = std::vector<std::pair<std::string, std::string>>;

// A library over blocks that a test wrote.
struct TestLibrary {
  explicit TestLibrary(const Files& files, bool fold = true);

  // The function for the given template values, which may be fewer bits than types: ints, floats as
  // their bits. Invalid if anything is wrong.
  ir::FunctionId Function(std::string_view block, size_t overload = 0,
                          const std::vector<uint32_t>& template_words = {});
  // What was reported, one per line: "half.glsl:1:7: error: text [kind]", notes indented by two.
  std::string Report() const;

  TemporaryFolder folder;
  ir::Module module;
  Sources sources;
  Diagnostics diagnostics;
  Library library;
};

// The type of a template port's values: an array gets two elements, or as many as it must have.
ir::TypeId ValueType(ir::Module& module, const Port& port);

// The report about a single file x.glsl, whose block and all its overloads are asked for with
// template values of 2 or true; with
// "^" for every line that the report would have, as in `expected`:
//   "1:7: text [kind]"
std::string ReportOf(std::string_view text);

// The bits of floats and back.
uint32_t Bits(float value);
std::vector<uint32_t> Bits(const std::vector<float>& values);

// Runs a function on values: arguments[i] holds the words of the i-th parameter for one lane. The
// results, words for one lane. Fails the test if the module is not well formed.
std::vector<std::vector<uint32_t>> RunFunction(const ir::Module& module, ir::FunctionId function,
                                               const std::vector<std::vector<uint32_t>>& arguments);

}  // namespace texgraph::blocks
