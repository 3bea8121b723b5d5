// SPDX-License-Identifier: Apache-2.0
// texgraph_bench [--only=compiling|shaders|chart|patterns|tiles] [--graph=NAME] [--write FILE]:
// measures compilation, shaders, the chart of one paper and the table of another, tiles made of a
// picture, or one of them, or the shader of one graph, and prints the report as Markdown, to FILE
// too. The limits beside the figures are the project's promises; a missed one is marked, and the
// exit status is 1.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "tests/bench/measure.h"

namespace texgraph::bench {
namespace {

namespace fs = std::filesystem;

// Fastest time of each benchmark, in milliseconds.
class FastestTimes : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
      std::string name = run.run_name.function_name;
      auto [known, added] = times.try_emplace(name, run.GetAdjustedRealTime());
      if (!added) known->second = std::min(known->second, run.GetAdjustedRealTime());
    }
  }
  std::map<std::string, double> times;
};

class Report {
 public:
  void Line(const std::string& line) { text_ += line + "\n"; }
  // A row of name, figure and limit; the figure must not be above the limit.
  void Row(const std::string& what, double figure, const std::string& unit, double limit) {
    bool ok = figure <= limit;
    missed_ += !ok;
    Line(fmt::format("| {} | {:.2f} {} | {:g} {} | {} |", what, figure, unit, limit, unit,
                     ok ? "yes" : "**no**"));
  }
  // Ours to a reference's, which must be at most kShaderLimit.
  std::string Ratio(double ours, double theirs) {
    double value = theirs > 0 ? ours / theirs : ours > 0 ? 1e9 : 1;
    bool ok = value <= kShaderLimit;
    missed_ += !ok;
    return fmt::format("{0}{1:.3f}{0}", ok ? "" : "**", value);
  }
  void Miss() { ++missed_; }
  const std::string& text() const { return text_; }
  int missed() const { return missed_; }
  static constexpr double kShaderLimit = 1.05;
  static constexpr double kSamePicture = 0.02;  // mean difference, in steps of 1/255

 private:
  std::string text_;
  int missed_ = 0;
};

std::string Machine() {
  std::string model = "unknown processor";
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (!line.starts_with("model name")) continue;
    model = line.substr(line.find(':') + 2);
    break;
  }
  utsname name{};
  uname(&name);
  return fmt::format("{}, {} threads, {} {}", model, std::thread::hardware_concurrency(),
                     name.sysname, name.machine);
}

void ReportCompilation(const std::map<std::string, double>& times, const ProcessFigures& cold,
                       Report& report) {
  report.Line("## Compiling\n");
  report.Line("| what | fastest | promised | kept |\n|---|---|---|---|");
  report.Row("brick wall, whole process from start to exit (fastest of 40)", cold.fastest_ms, "ms",
             5);
  report.Row("brick wall, peak memory of the process", static_cast<double>(cold.peak_kib) / 1024,
             "MiB", 16);
  auto time = [&](const std::string& name) {
    auto found = times.find(name);
    return found == times.end() ? 1e9 : found->second;
  };
  report.Row("1,000 chained additions, in process", time("adds/1000"), "ms", 2.5);
  report.Row("1,000 pairs of noise and mix, in process", time("noise_and_mix/1000"), "ms", 6);
  report.Row("1,000 tiled images over 8 files, in process", time("images/1000"), "ms", 10);
  report.Row("10 bombings inside of one another, in process", time("bombing/10"), "ms", 50);
  for (const char* name : {"adds", "noise_and_mix", "images", "diamond"}) {
    report.Row(fmt::format("{}: 10,000 against 1,000", name),
               time(fmt::format("{}/10000", name)) / time(fmt::format("{}/1000", name)), "times",
               12);
  }
  report.Line(fmt::format("\nThe brick wall's whole process: median {:.2f} ms.", cold.median_ms));
  report.Line(
      "\nFor comparison, MaterialX 1.39.6's GLSL generator on a machine of this kind: whole "
      "process 53 ms for one `add`,");
  report.Line(
      "105 ms for a marble, 18 MiB; in process 46 ms, 120 ms and 1,350 ms for the three graphs of "
      "1,000.\n");
}

void ReportShaders(const std::vector<ShaderFigures>& shaders, Report& report) {
  report.Line("## Shaders against hand-written ones\n");
  report.Line(
      "References: `tests/bench/reference/`. Instructions: SPIR-V in functions after `spirv-opt "
      "-O`. Time: fastest frame of");
  report.Line(
      "1024 x 1024, both drawn in turns. At most 1.05 is promised for each ratio. Difference: mean "
      "of the two pictures, of 255.\n");
  report.Line(
      "| graph | instructions | ratio | samples | ratio | frame | ratio | difference "
      "|\n|---|---|---|---|---|---|---|---|");
  std::string renderer;
  for (const ShaderFigures& s : shaders) {
    if (!s.error.empty()) {
      report.Line(fmt::format("| {} | failed: {} |", s.name, s.error));
      report.Miss();
      continue;
    }
    renderer = s.renderer;
    auto ratio = [&](double ours, double theirs) { return report.Ratio(ours, theirs); };
    report.Line(fmt::format(
        "| {} | {} / {} | {} | {} / {} | {} | {:.1f} / {:.1f} ms | {} | {:.2f} |", s.name,
        s.instructions[0], s.instructions[1], ratio(s.instructions[0], s.instructions[1]),
        s.samples[0], s.samples[1], ratio(s.samples[0], s.samples[1]), s.frame_ms[0], s.frame_ms[1],
        ratio(s.frame_ms[0], s.frame_ms[1]), s.difference));
  }
  report.Line(fmt::format("\nDrawn with {}.", renderer));
}

// A row for each number of textures and layers; the sides of the textures go across.
void ReportChart(const std::vector<ChartEntry>& entries, Report& report) {
  report.Line("\n## The chart of the brick shader generator\n");
  report.Line(
      "A wall of 4 x 8 bricks: the first layer is the brick, the others are its children, each "
      "with ranges for position, scale,");
  report.Line(
      "rotation and opacity that keep it inside its cell. The layers share a texture or have one "
      "each. "
      "For each side of the textures,");
  report.Line(
      "in texels: the fastest frame of 1024 x 1024, its ratio to a plain tiled texture, and its "
      "ratio to `reference/chart.frag`,");
  report.Line(
      "written by hand, which draws the same picture. At most 1.05 is promised for the ratios to "
      "what is written by hand.\n");
  std::vector<std::string> rows;
  std::string head = "| textures | layers | samples | instructions | ratio |";
  std::string line = "|---|---|---|---|---|";
  for (const ChartEntry& entry : entries) {
    const ShaderFigures& f = entry.figures;
    const std::string what = fmt::format("{} layers of {} textures of {} texels", entry.layers,
                                         entry.textures, entry.side);
    // Rounding may differ in the last place, and so a few pixels at the edges.
    if (!f.error.empty() || f.difference > Report::kSamePicture) {
      report.Line(
          fmt::format("{}: {}", what,
                      f.error.empty() ? fmt::format("differ by {:.2f}", f.difference) : f.error));
      report.Miss();
      return;
    }
    if (entry.side == entries[0].side) {
      rows.push_back(fmt::format("| {} | {} | {} | {} / {} | {} |", entry.textures, entry.layers,
                                 f.samples[0], f.instructions[0], f.instructions[1],
                                 report.Ratio(f.instructions[0], f.instructions[1])));
    }
    if (rows.size() == 1) {
      head += fmt::format(" {0}: frame | to plain | to hand |", entry.side);
      line += "---|---|---|";
    }
    rows.back() +=
        fmt::format(" {:.1f} ms | {:.2f} | {} |", f.frame_ms[0], f.frame_ms[0] / f.frame_ms[2],
                    report.Ratio(f.frame_ms[0], f.frame_ms[1]));
  }
  report.Line(head + "\n" + line);
  for (const std::string& row : rows) report.Line(row);
}

void ReportPatterns(const std::vector<PatternEntry>& entries, Report& report) {
  report.Line("\n## The table of \"Pattern Based Procedural Textures\"\n");
  report.Line(
      "Look-ups and instructions a pixel, counted in SPIR-V after `spirv-opt -O`: what computes, "
      "without loads, moves and labels.");
  report.Line(
      "To plain: the fastest frame of 1024 x 1024 that shows 16 x 16 patterns, to that of one "
      "trilinear look-up in the same patterns.");
  report.Line(
      "Over sizes: the slowest of virtual textures of 2^8, 2^14 and 2^20 cells to the fastest.\n");
  report.Line(
      "| graph | look-ups | promised | paper | instructions | promised | paper | to plain | "
      "promised "
      "| over sizes |\n|---|---|---|---|---|---|---|---|---|---|");
  for (const PatternEntry& e : entries) {
    if (!e.error.empty()) {
      report.Line(fmt::format("| {} | failed: {} |", e.name, e.error));
      report.Miss();
      continue;
    }
    const bool to_plain = e.most_to_plain == 0 || e.to_plain <= e.most_to_plain;
    if (e.samples > e.most_samples || e.computing > e.most_computing || !to_plain) report.Miss();
    auto figure = [](const std::string& text, bool ok) { return ok ? text : "**" + text + "**"; };
    report.Line(fmt::format(
        "| {} | {} | {} | {} | {} | {} | {} | {} | {} | {:.3f} |", e.name,
        figure(std::to_string(e.samples), e.samples <= e.most_samples), e.most_samples,
        e.paper_samples, figure(std::to_string(e.computing), e.computing <= e.most_computing),
        e.most_computing, e.paper_instructions, figure(fmt::format("{:.2f}", e.to_plain), to_plain),
        e.most_to_plain > 0 ? fmt::format("{:.2f}", e.most_to_plain) : "", e.over_sizes));
  }
}

void ReportTiles(const std::vector<TilesEntry>& entries, Report& report) {
  report.Line("\n## Tiles made of a picture\n");
  report.Line(
      "To plain: the fastest frame of 1024 x 1024, to that of one trilinear look-up in the same "
      "tiles in one picture (an atlas) with as many texels a pixel. To gradients: the same look-up "
      "with textureGrad, which no shader for an atlas can do without, since there the place jumps "
      "from tile to tile. By hand: a shader for corner tiles of two colours in an atlas, as an "
      "engineer would write it. Instructions are those that compute.\n");
  report.Line(
      "| block | look-ups | instructions | frame | to plain | promised | to gradients | to by hand "
      "|\n|---|---|---|---|---|---|---|---|");
  for (const TilesEntry& e : entries) {
    if (!e.error.empty()) {
      report.Line(fmt::format("| {} | failed: {} |", e.name, e.error));
      report.Miss();
      continue;
    }
    const bool ok = e.most_to_plain == 0 || e.to_plain <= e.most_to_plain;
    if (!ok) report.Miss();
    report.Line(
        fmt::format("| {} | {} | {} | {:.1f} ms | {}{:.2f}{} | {} | {:.2f} | {} |", e.name,
                    e.samples, e.computing, e.frame_ms, ok ? "" : "**", e.to_plain, ok ? "" : "**",
                    e.most_to_plain > 0 ? fmt::format("{:.2f}", e.most_to_plain) : "",
                    e.to_gradients, e.to_by_hand > 0 ? fmt::format("{:.2f}", e.to_by_hand) : ""));
  }
}

// What the command line asks for.
struct Request {
  std::string only;   // "compiling", "shaders", "chart", "patterns", "tiles" or everything
  std::string graph;  // the only graph whose shader is measured; empty: all that have a reference
  std::string write;
};

std::optional<Request> ReadCommandLine(int argc, char** argv) {
  Request request;
  for (int i = 1; i < argc; ++i) {
    std::string_view argument = argv[i];
    size_t equals = argument.find('=');
    std::string_view name = argument.substr(0, equals);
    std::string* value = name == "--only"    ? &request.only
                         : name == "--graph" ? &request.graph
                         : name == "--write" ? &request.write
                                             : nullptr;
    if (!value || (equals == argument.npos && i + 1 == argc)) return std::nullopt;
    *value = equals == argument.npos ? argv[++i] : argument.substr(equals + 1);
  }
  const std::string_view parts[] = {"", "compiling", "shaders", "chart", "patterns", "tiles"};
  if (std::ranges::find(parts, request.only) == std::end(parts)) return std::nullopt;
  return request;
}

void MeasureCompilation(const std::string& root, Report& report) {
  char program[] = "texgraph_bench";
  char* arguments[] = {program, nullptr};
  int count = 1;
  benchmark::Initialize(&count, arguments);
  const std::string folder =
      (fs::temp_directory_path() / fmt::format("texgraph_bench.{}", getpid())).string();
  fs::create_directories(folder);
  ProcessFigures cold = MeasureProcess(
      {TEXGRAPHC, root + "/graphs/brick_wall/brick_wall.json", "-o", folder + "/shader.frag"}, 40);
  RegisterCompilations(folder);
  FastestTimes times;
  benchmark::RunSpecifiedBenchmarks(&times);
  fs::remove_all(folder);
  ReportCompilation(times.times, cold, report);
}

void MeasureShaders(const std::string& root, const std::string& only_graph, Report& report) {
  std::vector<fs::path> references;
  for (const fs::directory_entry& entry : fs::directory_iterator(root + "/tests/bench/reference")) {
    if (entry.path().extension() == ".frag") references.push_back(entry.path());
  }
  std::ranges::sort(references);
  std::vector<ShaderFigures> shaders;
  for (const fs::path& reference : references) {
    std::string name = reference.stem().string();
    if (!only_graph.empty() && name != only_graph) continue;
    // An example, or a graph beside the reference that was written for nothing else.
    const std::string example = fmt::format("{0}/graphs/{1}/{1}", root, name);
    for (const std::string& graph : {example + ".json", example + ".jsonc", example + ".yaml",
                                     fs::path(reference).replace_extension(".json").string()}) {
      if (!fs::exists(graph)) continue;
      shaders.push_back(MeasureShader(graph, reference.string()));
      if (shaders.back().name.empty()) shaders.back().name = name;
    }
  }
  ReportShaders(shaders, report);
}

void MeasureAndReportChart(const std::string& root, Report& report) {
  const std::string folder =
      (fs::temp_directory_path() / fmt::format("texgraph_chart.{}", getpid())).string();
  fs::create_directories(folder);
  ReportChart(MeasureChart(root, folder), report);
  fs::remove_all(folder);
}

int Main(int argc, char** argv) {
  std::optional<Request> request = ReadCommandLine(argc, argv);
  if (!request) {
    std::fputs(
        "usage: texgraph_bench [--only=compiling|shaders|chart|patterns|tiles] [--graph=NAME] "
        "[--write FILE]\n",
        stderr);
    return 2;
  }
  const std::string root = TEXGRAPH_SOURCE_DIR;
  Report report;
  report.Line("# Benchmarks\n");
  report.Line(
      "Written by `build/release/bin/texgraph_bench --write docs/benchmarks.md`. Ratios compare "
      "what was measured in one run.\n");
  report.Line(fmt::format("Machine: {}.\n", Machine()));
  auto is_wanted = [&](std::string_view part) {
    return request->only.empty() || request->only == part;
  };
  if (is_wanted("compiling")) MeasureCompilation(root, report);
  if (is_wanted("shaders")) MeasureShaders(root, request->graph, report);
  if (is_wanted("chart")) MeasureAndReportChart(root, report);
  if (is_wanted("patterns")) ReportPatterns(MeasurePatterns(root), report);
  if (is_wanted("tiles")) ReportTiles(MeasureTiles(root), report);
  std::fputs(report.text().c_str(), stdout);
  if (!request->write.empty()) std::ofstream(request->write) << report.text();
  return report.missed() > 0;
}

}  // namespace
}  // namespace texgraph::bench

int main(int argc, char** argv) { return texgraph::bench::Main(argc, argv); }
