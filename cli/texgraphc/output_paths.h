// SPDX-License-Identifier: Apache-2.0
// Where the outputs of a graph go. No output is ever written over a file that the compilation read,
// nor two to one path.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cli/texgraphc/options.h"

namespace texgraph::cli {

struct OutputPaths {
  std::string shader;        // "-" is standard output
  std::string manifest;      // "": none
  std::string dependencies;  // "": none
  std::vector<std::string>
      files;  // beside the manifest, one for each of Compiled; none without it
};

// What the manifest says about places, before the graph's name is known: see compile.h.
void SetManifestPlace(const Options& options, CompileOptions& compile);

class OutputPlanner {
 public:
  explicit OutputPlanner(const Options& options);

  // The paths for a graph, which was made from its dependencies beside its own file. Reports
  // kUsage where an output would replace a graph of the command line, a file that was read for this
  // graph or one before, or another output. The manifest is shader.json beside shader.frag or,
  // where that is an input (shader.frag made from shader.json), shader.manifest.json.
  std::optional<OutputPaths> Plan(const Compiled& compiled, Diagnostics& diagnostics);

 private:
  void AddInputs(const std::vector<std::string>& paths);
  bool IsInput(const std::string& path) const;
  std::string ManifestBeside(const std::string& shader) const;
  bool Take(const std::string& path);

  const Options& options_;
  std::set<std::string> inputs_;                         // as absolute paths
  std::set<std::pair<uint64_t, uint64_t>> input_files_;  // device and number, to see through links
  std::set<std::string> taken_;
};

}  // namespace texgraph::cli
