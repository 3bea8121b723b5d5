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

// Registers the compilations of synthetic graphs as benchmarks; `folder` gets the pictures that
// they name.
void RegisterCompilations(const std::string& folder);

struct ShaderFigures {
  std::string name;
  // Ours, then the hand-written reference's; in the chart then a plain tiled texture's.
  int instructions[3] = {0, 0, 0};  // SPIR-V after spirv-opt -O, without names and declarations
  int samples[3] = {0, 0, 0};
  double frame_ms[3] = {0, 0, 0};  // fastest of the frames, drawn in turns
  double difference = 0;           // of the first two pictures: mean absolute, in steps of 1/255
  std::string renderer;
  std::string error;
};
// Compiles the graph, reads the reference, compares weight, time and picture.
ShaderFigures MeasureShader(const std::string& graph_path, const std::string& reference_path);

// One cell of the paper's chart (the brick shader generator, section 3.3): a wall of bricks with
// layers on them.
struct ChartEntry {
  int textures = 1;  // of which the layers take one after the other
  int layers = 1;
  int side = 256;  // of each texture, in texels
  ShaderFigures figures;
};
// All of them, in the order of textures, layers and sides; `folder` gets the graphs and pictures.
// Each is compared with tests/bench/reference/chart.frag and with a plain tiled texture.
std::vector<ChartEntry> MeasureChart(const std::string& root, const std::string& folder);

// A graph of "Pattern Based Procedural Textures" beside the paper's table in section 6.
struct PatternEntry {
  std::string name;
  int samples = 0, most_samples = 0, paper_samples = 0;
  int computing = 0, most_computing = 0, paper_instructions = 0;  // see spirv_weight.h
  // To one plain trilinear look-up in the same patterns, at the same size on the screen.
  double to_plain = 0, most_to_plain = 0;  // 0: nothing is promised
  // To the same look-up with textureGrad, as any shader with such tiles must take; and to a shader
  // for these tiles that was written by hand. 0: there is none.
  double to_gradients = 0, to_by_hand = 0;
  // The slowest to the fastest of 2^8, 2^14 and 2^20 cells, of equal size on the screen.
  double over_sizes = 0;
  std::string error;
};
std::vector<PatternEntry> MeasurePatterns(const std::string& root);

// A block that shows tiles made of a picture.
struct TilesEntry {
  std::string name;
  int samples = 0;
  int computing = 0;  // instructions that compute
  double frame_ms = 0;
  // To one plain trilinear look-up in the same pack, with as many texels a pixel.
  double to_plain = 0, most_to_plain = 0;  // 0: nothing is promised
  // To the same look-up with textureGrad, as any shader with such tiles must take; and to a shader
  // for these tiles that was written by hand. 0: there is none.
  double to_gradients = 0, to_by_hand = 0;
  std::string error;
};
std::vector<TilesEntry> MeasureTiles(const std::string& root);

}  // namespace texgraph::bench
