// SPDX-License-Identifier: Apache-2.0
#include "cli/texgraphc/output_paths.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include "compiler/base/files.h"

namespace texgraph::cli {
namespace {

// Standard output, a device, a pipe: nothing can stand beside it.
bool IsStream(const std::string& path) {
  struct stat status;
  return path == "-" ||
         (stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode));
}

// Without its last extension.
std::string Stem(const std::string& path) {
  std::string_view name = FileNameOf(path);
  size_t dot = name.rfind('.');
  if (dot == std::string_view::npos || dot == 0) return path;
  return path.substr(0, path.size() - (name.size() - dot));
}

}  // namespace

void SetManifestPlace(const Options& options, CompileOptions& compile) {
  std::string folder =
      options.OutputIsFolder() ? options.output : std::string(FolderOf(options.output));
  compile.manifest_folder =
      options.manifest.empty() ? folder : std::string(FolderOf(options.manifest));
  if (options.OutputIsFolder()) {
    compile.shader_name = RelativePath(folder, compile.manifest_folder);
    compile.shader_name = compile.shader_name == "." ? "" : compile.shader_name + "/";
  } else if (options.output != "-") {
    compile.shader_name = RelativePath(options.output, compile.manifest_folder);
  }
}

OutputPlanner::OutputPlanner(const Options& options) : options_(options) {
  AddInputs(options.graphs);
}

void OutputPlanner::AddInputs(const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    if (path == "-" || !inputs_.insert(AbsolutePath(path)).second) continue;
    struct stat status;
    if (stat(path.c_str(), &status) == 0) input_files_.emplace(status.st_dev, status.st_ino);
  }
}

bool OutputPlanner::IsInput(const std::string& path) const {
  if (IsStream(path)) return false;  // a device may be read and written by many
  if (inputs_.contains(AbsolutePath(path))) return true;
  struct stat status;
  return stat(path.c_str(), &status) == 0 && input_files_.contains({status.st_dev, status.st_ino});
}

std::string OutputPlanner::ManifestBeside(const std::string& shader) const {
  std::string manifest = Stem(shader) + ".json";
  bool free = manifest != shader && !IsInput(manifest);
  return free ? manifest : Stem(shader) + ".manifest.json";
}

std::optional<OutputPaths> OutputPlanner::Plan(const Compiled& compiled, Diagnostics& diagnostics) {
  AddInputs(compiled.dependencies);
  OutputPaths paths;
  paths.shader = options_.output;
  if (options_.OutputIsFolder()) {
    paths.shader = JoinPath(options_.output, compiled.name);
    paths.shader += ShaderExtension(options_.compile.target, options_.compile.emit);
  }
  paths.manifest = options_.manifest;
  if (paths.manifest.empty() && !IsStream(paths.shader))
    paths.manifest = ManifestBeside(paths.shader);
  if (options_.write_dependencies) {
    paths.dependencies =
        options_.dependency_file.empty() ? paths.shader + ".d" : options_.dependency_file;
  }
  if (!paths.manifest.empty()) {
    for (const Compiled::File& file : compiled.files) {
      paths.files.push_back(JoinPath(std::string(FolderOf(paths.manifest)), file.name));
    }
  }
  std::vector<const std::string*> all = {&paths.shader, &paths.manifest, &paths.dependencies};
  for (const std::string& file : paths.files) all.push_back(&file);
  for (const std::string* path : all) {
    if (path->empty()) continue;
    std::string problem;
    if (IsInput(*path)) {
      problem = "it is one of the files that are read";
    } else if (!Take(*path)) {
      problem = "another output goes there";
      if (options_.graphs.size() > 1) {
        problem += "; graphs of one name differ by a key \"name\", or go to two folders";
      }
    }
    if (problem.empty()) continue;
    diagnostics.Error(DiagnosticKind::kUsage, {},
                      fmt::format("cannot write '{}': {}", Printable(*path), problem));
    return std::nullopt;
  }
  return paths;
}

bool OutputPlanner::Take(const std::string& path) {
  if (path == "-") return taken_.insert(path).second;
  return IsStream(path) || taken_.insert(AbsolutePath(path)).second;
}

}  // namespace texgraph::cli
