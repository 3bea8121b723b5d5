// SPDX-License-Identifier: Apache-2.0
// Random graphs for as long as one likes, valid and broken. What goes wrong is kept in a folder, as
// a graph that texgraphc takes. docs/testing.md tells how to use it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <fstream>

#include "tests/fuzz/break_graph.h"
#include "tests/fuzz/check_graph.h"
#include "tests/fuzz/random_graph.h"

namespace texgraph::fuzz {
namespace {

using Clock = std::chrono::steady_clock;

struct Settings {
  uint32_t seed = 1;
  double seconds = 60;
  uint32_t count = 0xffffffffu;
  uint32_t broken = 8;
  uint32_t nodes = 14;
  std::string folder = "fuzz_graphs";
};

class Fuzzer {
 public:
  explicit Fuzzer(const Settings& settings) : settings_(settings) {}

  int Run() {
    const auto start = Clock::now();
    const auto since = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
    uint32_t done = 0;
    for (uint32_t seed = settings_.seed; done < settings_.count && since() < settings_.seconds;
         ++seed, ++done) {
      RandomGraphOptions options;
      options.nodes = settings_.nodes;
      const RandomGraphText graph = RandomGraph(seed, options);
      Valid(graph, seed);
      std::mt19937 random(seed);
      for (uint32_t i = 0; i < settings_.broken; ++i) {
        Broken(BreakGraph(graph, random), graph, seed, i);
      }
    }
    std::filesystem::remove(current_);
    fmt::print(
        "{} graphs from seed {}: {} failures, {} at a limit, {} refused texts did not say why\n",
        done, settings_.seed, failures_, limits_, broken_failures_);
    fmt::print(
        "{} values compared, {} different where undefined, {} with much slack; slowest {:.2f} s\n",
        values_, undefined_, loose_, slowest_);
    return failures_ + broken_failures_ == 0 ? 0 : 1;
  }

 private:
  // Before it is tried: should that crash, it is there.
  std::string Keep(const std::string& text, const std::string& name) {
    const std::string path = settings_.folder + "/" + name;
    std::ofstream(path, std::ios::binary) << text;
    current_ = path;
    return path;
  }

  void Report(const std::string& what, uint32_t seed, bool failed, Clock::time_point start) {
    slowest_ = std::max(slowest_, std::chrono::duration<double>(Clock::now() - start).count());
    if (!failed) {
      std::filesystem::remove(current_);
    } else {
      fmt::print("seed {}, {}:\n{}\n\n", seed, current_, what.substr(0, 4000));
      current_.clear();
      std::fflush(stdout);
    }
  }

  void Valid(const RandomGraphText& graph, uint32_t seed) {
    const auto start = Clock::now();
    const std::string path = Keep(graph.text, graph.FileName(seed));
    const GraphReport report = CheckValidGraph(graph.text, graph.format, path, seed);
    failures_ += report.failure.empty() ? 0 : 1;
    limits_ += report.limit.empty() ? 0 : 1;
    values_ += report.values;
    undefined_ += report.undefined;
    loose_ += report.loose;
    Report(report.failure, seed, !report.failure.empty(), start);
  }

  void Broken(const std::string& text, const RandomGraphText& graph, uint32_t seed, uint32_t i) {
    const auto start = Clock::now();
    const std::string path = Keep(text, fmt::format("broken_{}_{}", i, graph.FileName(seed)));
    const std::string wrong = CheckBrokenGraph(text, graph.format, path);
    broken_failures_ += wrong.empty() ? 0 : 1;
    Report(wrong, seed, !wrong.empty(), start);
  }

  const Settings& settings_;
  std::string current_;
  uint32_t failures_ = 0, limits_ = 0, broken_failures_ = 0;
  uint64_t values_ = 0, undefined_ = 0, loose_ = 0;
  double slowest_ = 0;
};

}  // namespace
}  // namespace texgraph::fuzz

int main(int argc, char** argv) {
  texgraph::fuzz::Settings settings;
  CLI::App app("Compiles random graphs, valid and broken, and checks what comes of them.");
  app.add_option("--seed", settings.seed, "the first graph's; the next has the next")
      ->capture_default_str();
  app.add_option("--seconds", settings.seconds, "how long")->capture_default_str();
  app.add_option("--count", settings.count, "how many graphs at most; 1 repeats one");
  app.add_option("--broken", settings.broken, "broken texts of each graph")->capture_default_str();
  app.add_option("--nodes", settings.nodes, "nodes of a graph at most")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_option("--keep", settings.folder, "folder for what fails")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  std::filesystem::create_directories(settings.folder);
  if (!texgraph::fuzz::WriteGraphImages(settings.folder)) {
    fmt::print(stderr, "cannot write to {}\n", settings.folder);
    return 3;
  }
  return texgraph::fuzz::Fuzzer(settings).Run();
}
