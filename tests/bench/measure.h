// SPDX-License-Identifier: Apache-2.0
// The measurements behind docs/benchmarks.md.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace texgraph::bench {

struct ProcessFigures {
  double fastest_ms = 0, median_ms = 0;
  long peak_kib = 0;  // the largest of all runs
  bool ok = false;
};
// Runs a command `runs` times from start to exit, with its output thrown away.
ProcessFigures MeasureProcess(const std::vector<std::string>& command, int runs);

// Registers the compilations of synthetic graphs as benchmarks; `folder` gets the pictures that they name.
void RegisterCompilations(const std::string& folder);

struct ShaderFigures {
  std::string name;
  // Ours, then the hand-written reference's.
  int instructions[2] = {0, 0};  // SPIR-V after spirv-opt -O, without names and declarations
  int samples[2] = {0, 0};
  double frame_ms[2] = {0, 0};   // fastest of the frames, drawn in turns
  double difference = 0;         // of the two pictures: mean absolute, in steps of 1/255
  std::string renderer;
  std::string error;
};
// Compiles the graph, reads the reference, compares weight, time and picture.
ShaderFigures MeasureShader(const std::string& graph_path, const std::string& reference_path);

}  // namespace texgraph::bench
