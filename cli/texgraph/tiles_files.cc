// SPDX-License-Identifier: Apache-2.0
#include "cli/texgraph/tiles_files.h"

#include <fmt/format.h>

#include <string_view>

#include "cli/texgraph/output_check.h"
#include "compiler/base/files.h"

namespace texgraph::cli {
namespace {

// "a/grass.png" -> "a/grass"
std::string WithoutExtension(std::string_view path) {
  const size_t name = path.size() - FileNameOf(path).size();
  const size_t dot = path.rfind('.');
  const bool has_extension = dot != std::string_view::npos && dot > name;
  return std::string(path.substr(0, has_extension ? dot : path.size()));
}

bool IsOneFile(const std::string& a, const std::string& b) {
  if (a == "-" || b == "-") return a == b;
  return AbsolutePath(a) == AbsolutePath(b) || SameFile(a, b);
}

}  // namespace

std::optional<TilesFiles> NameTilesFiles(const TilesOptions& options, Diagnostics& diagnostics) {
  TilesFiles files;
  files.packs = options.packs;
  if (files.packs.empty()) {
    for (const std::string& map : options.maps)
      files.packs.push_back(WithoutExtension(FileNameOf(map)) + ".tiles.png");
  }
  if (options.corner_pack) {
    for (const std::string& pack : files.packs)
      files.corner_packs.push_back(WithoutExtension(pack) + ".corners.png");
  }
  files.json = options.json;
  if (files.json.empty() && files.packs[0] != "-")
    files.json = WithoutExtension(files.packs[0]) + ".json";

  std::vector<std::string> all = files.packs;
  all.insert(all.end(), files.corner_packs.begin(), files.corner_packs.end());
  for (const std::string& file : {files.json, options.view, options.tiling}) {
    if (!file.empty()) all.push_back(file);
  }
  if (options.report) all.emplace_back("-");
  for (size_t i = 0; i < all.size(); ++i) {
    if (!CheckOutput(all[i], options.maps, diagnostics)) return std::nullopt;
    for (size_t j = 0; j < i; ++j) {
      if (!IsOneFile(all[i], all[j])) continue;
      diagnostics.Error(
          DiagnosticKind::kUsage, {},
          all[i] == "-" ? "two outputs go to standard output; one of them can"
                        : fmt::format("two outputs would be written to '{}'", Printable(all[i])));
      return std::nullopt;
    }
  }
  return files;
}

}  // namespace texgraph::cli
