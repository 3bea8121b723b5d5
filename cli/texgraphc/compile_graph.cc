// SPDX-License-Identifier: Apache-2.0
#include "cli/texgraphc/compile_graph.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "cli/texgraphc/depfile.h"
#include "compiler/base/files.h"
#include "compiler/base/output_files.h"

namespace texgraph::cli {
namespace {

std::string ShaderBytes(const CompileOptions& options, Compiled& compiled) {
  if (options.target != Target::kSpirv) return std::move(compiled.glsl);
  const char* words = reinterpret_cast<const char*>(compiled.spirv.data());
  return std::string(words, compiled.spirv.size() * sizeof(uint32_t));
}

void WriteOutputs(const Options& options, CompiledGraph& graph, OutputPlanner& planner) {
  Compiled& compiled = *graph.compiled;
  std::vector<std::string> inputs;
  if (graph.path != "-") inputs.push_back(graph.path);
  inputs.insert(inputs.end(), compiled.dependencies.begin(), compiled.dependencies.end());
  std::optional<OutputPaths> paths = planner.Plan(compiled, graph.diagnostics);
  if (!paths) return;
  OutputFiles files;
  if (paths->shader == "-") files.Add("-", std::move(compiled.dump));
  files.Add(paths->shader, ShaderBytes(options.compile, compiled));
  if (!paths->manifest.empty()) files.Add(paths->manifest, std::move(compiled.manifest));
  for (size_t i = 0; i < paths->files.size(); ++i) {
    files.Add(paths->files[i], std::move(compiled.files[i].bytes));
  }
  if (!paths->dependencies.empty()) {
    const std::string& target =
        options.dependency_target.empty() ? paths->shader : options.dependency_target;
    files.Add(paths->dependencies, PrintDepfile(target, inputs));
  }
  if (!files.Commit(graph.diagnostics)) return;
  if (paths->shader != "-") (void)WriteAll(STDERR_FILENO, compiled.dump);
}

// Compiles on several threads while the caller takes the results in order.
class Workers {
 public:
  Workers(const Options& options, unsigned count)
      : options_(options), slots_(options.graphs.size()) {
    for (unsigned i = 0; i < count; ++i) {
      try {
        threads_.emplace_back([this] { Work(); });
      } catch (const std::system_error&) {
        break;  // no more threads to be had; Take() works too
      }
    }
  }
  ~Workers() {
    next_ = slots_.size();
    for (std::thread& thread : threads_) thread.join();
  }

  CompiledGraph Take(size_t i) {
    if (threads_.empty()) Work();
    slots_[i].done.wait(false);
    return std::move(*std::exchange(slots_[i].graph, nullptr));
  }

 private:
  struct Slot {
    std::atomic<bool> done{false};
    std::unique_ptr<CompiledGraph> graph;
  };

  void Work() {
    for (size_t i = next_++; i < slots_.size(); i = next_++) {
      slots_[i].graph = std::make_unique<CompiledGraph>(CompileGraph(options_, options_.graphs[i]));
      slots_[i].done = true;
      slots_[i].done.notify_one();
    }
  }

  const Options& options_;
  std::vector<Slot> slots_;
  std::atomic<size_t> next_{0};
  std::vector<std::thread> threads_;
};

}  // namespace

CompiledGraph CompileGraph(const Options& options, const std::string& path) {
  CompiledGraph graph;
  graph.path = path;
  bool standard_input = path == "-";
  std::optional<std::string> text =
      standard_input ? ReadStandardInput(graph::kMaxDocumentBytes, graph.diagnostics)
                     : ReadFile(path, graph::kMaxDocumentBytes, {}, graph.diagnostics);
  if (!text) return graph;
  graph::DocumentFormat format = options.format ? *options.format : graph::FormatOf(path, *text);
  SourceId source = graph.sources.Add(standard_input ? "<stdin>" : path, std::move(*text));
  CompileOptions compile = options.compile;
  SetManifestPlace(options, compile);
  compile.prepare_files = true;
  graph.compiled = Compile(source, format, compile, graph.sources, graph.diagnostics);
  if (options.no_warnings) graph.diagnostics.DropWarnings();
  if (options.warnings_are_errors) graph.diagnostics.PromoteWarnings();
  if (graph.diagnostics.HasErrors()) graph.compiled.reset();
  return graph;
}

ExitCode FinishGraph(const Options& options, CompiledGraph graph, OutputPlanner& planner) {
  if (graph.compiled) WriteOutputs(options, graph, planner);
  PrintDiagnostics(graph.diagnostics, graph.sources, options.color);
  return graph.diagnostics.exit_code();
}

ExitCode CompileGraphs(const Options& options) {
  unsigned cores = std::max(std::thread::hardware_concurrency(), 1u);
  size_t jobs = std::min<size_t>(options.jobs == 0 ? cores : options.jobs, options.graphs.size());
  OutputPlanner planner(options);
  ExitCode code = ExitCode::kOk;
  auto finish = [&](CompiledGraph graph) {
    ExitCode one = FinishGraph(options, std::move(graph), planner);
    if (code == ExitCode::kOk) code = one;
  };
  if (jobs == 1) {
    for (const std::string& path : options.graphs) finish(CompileGraph(options, path));
    return code;
  }
  Workers workers(options, static_cast<unsigned>(jobs));
  for (size_t i = 0; i < options.graphs.size(); ++i) finish(workers.Take(i));
  return code;
}

void PrintDiagnostics(const Diagnostics& diagnostics, const Sources& sources, bool color) {
  if (diagnostics.all().empty()) return;
  (void)WriteAll(STDERR_FILENO, FormatDiagnostics(diagnostics, sources, color));
}

}  // namespace texgraph::cli
