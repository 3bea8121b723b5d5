// SPDX-License-Identifier: Apache-2.0
// Compilation inside one process: from the text of a graph to the text of its shader and manifest.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "compiler/compile.h"
#include "compiler/textures/image.h"
#include "tests/bench/measure.h"
#include "tests/bench/synthetic_graphs.h"

namespace texgraph::bench {
namespace {

constexpr int kFiles = 8;

void WritePictures(const std::string& folder) {
  textures::Image image;
  image.width = image.height = 16;
  image.channels = 4;
  image.pixels.assign(image.width * image.height * 4, 128);
  for (int i = 0; i < kFiles; ++i) {
    std::ofstream file(fmt::format("{}/picture{}.png", folder, i), std::ios::binary);
    file << textures::EncodePng(image).value_or("");
  }
}

void CompileText(benchmark::State& state, const std::string& name, const std::string& text) {
  for (auto round : state) {
    Sources sources;
    Diagnostics diagnostics;
    SourceId source = sources.Add(name, text);
    auto compiled = Compile(source, graph::DocumentFormat::kJson, {}, sources, diagnostics);
    if (!compiled) {
      std::fputs(FormatDiagnostics(diagnostics, sources, false).c_str(), stderr);
      state.SkipWithError("the graph does not compile");
      return;
    }
    benchmark::DoNotOptimize(compiled->glsl.data());
  }
}

void Register(const std::string& name, const std::string& folder, const std::string& text) {
  benchmark::RegisterBenchmark(
      name.c_str(),
      [folder, text](benchmark::State& state) { CompileText(state, folder + "/graph.json", text); })
      ->Unit(benchmark::kMillisecond)
      ->Repetitions(5)
      ->ReportAggregatesOnly(false);
}

}  // namespace

void RegisterCompilations(const std::string& folder) {
  WritePictures(folder);
  for (int n : {1000, 10000}) {
    Register(fmt::format("adds/{}", n), folder, ChainOfAdds(n));
    Register(fmt::format("noise_and_mix/{}", n), folder, NoiseAndMixPairs(n));
    Register(fmt::format("images/{}", n), folder, TiledImages(n, kFiles));
    Register(fmt::format("diamond/{}", n), folder, Diamond(n));
  }
  Register("bombing/10", folder, BombingInsideBombing(10));
}

}  // namespace texgraph::bench
