// SPDX-License-Identifier: Apache-2.0
// texgraph_bench [--only=compiling|shaders] [--graph=NAME] [--write FILE]: measures compilation and
// shaders, or one of them, or the shader of one graph, and prints the report as Markdown, to FILE
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
  void Ratio(double ratio) { missed_ += ratio > kShaderLimit; }
  const std::string& text() const { return text_; }
  int missed() const { return missed_; }
  static constexpr double kShaderLimit = 1.05;

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
      report.Ratio(1e9);
      continue;
    }
    renderer = s.renderer;
    auto ratio = [&](double ours, double theirs) {
      double value = theirs > 0 ? ours / theirs : ours > 0 ? 1e9 : 1;
      report.Ratio(value);
      return fmt::format("{}{:.3f}{}", value > Report::kShaderLimit ? "**" : "", value,
                         value > Report::kShaderLimit ? "**" : "");
    };
    report.Line(fmt::format(
        "| {} | {} / {} | {} | {} / {} | {} | {:.1f} / {:.1f} ms | {} | {:.2f} |", s.name,
        s.instructions[0], s.instructions[1], ratio(s.instructions[0], s.instructions[1]),
        s.samples[0], s.samples[1], ratio(s.samples[0], s.samples[1]), s.frame_ms[0], s.frame_ms[1],
        ratio(s.frame_ms[0], s.frame_ms[1]), s.difference));
  }
  report.Line(fmt::format("\nDrawn with {}.", renderer));
}

// What the command line asks for.
struct Request {
  std::string only;   // "compiling", "shaders" or everything
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
  if (!request.only.empty() && request.only != "compiling" && request.only != "shaders") {
    return std::nullopt;
  }
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
    references.push_back(entry.path());
  }
  std::ranges::sort(references);
  std::vector<ShaderFigures> shaders;
  for (const fs::path& reference : references) {
    std::string name = reference.stem().string();
    if (!only_graph.empty() && name != only_graph) continue;
    for (const char* extension : {".json", ".jsonc", ".yaml"}) {
      std::string graph = fmt::format("{}/graphs/{}/{}{}", root, name, name, extension);
      if (!fs::exists(graph)) continue;
      shaders.push_back(MeasureShader(graph, reference.string()));
      if (shaders.back().name.empty()) shaders.back().name = name;
    }
  }
  ReportShaders(shaders, report);
}

int Main(int argc, char** argv) {
  std::optional<Request> request = ReadCommandLine(argc, argv);
  if (!request) {
    std::fputs("usage: texgraph_bench [--only=compiling|shaders] [--graph=NAME] [--write FILE]\n",
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
  if (request->only != "shaders") MeasureCompilation(root, report);
  if (request->only != "compiling") MeasureShaders(root, request->graph, report);
  std::fputs(report.text().c_str(), stdout);
  if (!request->write.empty()) std::ofstream(request->write) << report.text();
  return report.missed() > 0;
}

}  // namespace
}  // namespace texgraph::bench

int main(int argc, char** argv) { return texgraph::bench::Main(argc, argv); }
