// SPDX-License-Identifier: Apache-2.0
#include "cli/texgraph/tiles_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>

#include "cli/texgraph/option_values.h"
#include "cli/texgraph/parse_options.h"
#include "compiler/graph/texture.h"
#include "compiler/textures/image.h"

namespace texgraph::cli {
namespace {

constexpr std::string_view kTilesCommand = "tiles";

constexpr std::string_view kTilesOptionNames[] = {
    "--tile-size", "--corners", "--edges",       "--wraps", "--seed",   "--candidates",
    "--weights",   "--json",    "--corner-pack", "--view",  "--tiling", "--tiling-size",
    "--report",    "--color",   "--own-middles", "--even",  "--help"};

// The texts of the options that CLI11 only collects; "" where one was not given.
struct TilesTexts {
  std::string tile_size;
  std::string corners;
  std::string edges;
  std::string seed;
  std::string candidates;
  std::string weights;
  std::string tiling_size;
  std::string color = "auto";
  bool help = false;
};

void DeclareTiles(CLI::App& app, TilesOptions& options, TilesTexts& raw) {
  app.set_help_flag();
  app.allow_extras();
  const auto text = [&](const char* name, std::string& value) {
    app.add_option(name, value)->take_last();
  };
  text("--tile-size", raw.tile_size);
  text("--corners", raw.corners);
  text("--edges", raw.edges);
  app.add_flag("--wraps", options.set.wraps);
  text("--seed", raw.seed);
  text("--candidates", raw.candidates);
  app.add_flag("--own-middles", options.set.own_middles);
  app.add_flag("--even", options.set.even);
  text("--weights", raw.weights);
  app.add_option("-o", options.packs)->allow_extra_args(false);
  text("--json", options.json);
  app.add_flag("--corner-pack", options.corner_pack);
  text("--view", options.view);
  text("--tiling", options.tiling);
  text("--tiling-size", raw.tiling_size);
  app.add_flag("--report", options.report);
  text("--color", raw.color);
  app.add_flag("-q", options.quiet);
  app.add_flag("-h,--help", raw.help);
  app.add_option("maps", options.maps);
}

// Whole numbers with `separator` between them, as many as `numbers` has.
template <size_t Count>
bool ReadWhole(std::string_view text, char separator, std::array<uint32_t, Count>& numbers) {
  for (size_t i = 0; i < Count; ++i) {
    const size_t end = i + 1 < Count ? text.find(separator) : text.size();
    if (end == std::string_view::npos || !ReadNumber(text.substr(0, end), numbers[i])) return false;
    if (i + 1 < Count) text.remove_prefix(end + 1);
  }
  return true;
}

// What is beyond a limit is told where the set is made, with what would do.
class TilesOptionReader {
 public:
  TilesOptionReader(const CLI::App& app, const TilesTexts& raw, TilesOptions& options,
                    Diagnostics& diagnostics)
      : app_(app), raw_(raw), options_(options), diagnostics_(diagnostics) {}

  void Read() {
    ReportUnknownOptions(app_, kTilesOptionNames, kTilesCommand, diagnostics_);
    options_.color = ReadColor(raw_.color, kTilesCommand, diagnostics_);
    if (options_.maps.empty()) Fail("no map given");
    ReadNumberOption("--tile-size", raw_.tile_size, options_.set.tile_size);
    ReadNumberOption("--seed", raw_.seed, options_.set.seed);
    ReadNumberOption("--candidates", raw_.candidates, options_.set.candidates);
    ReadColors();
    ReadWeights();
    ReadTilingSize();
    CheckFiles();
  }

 private:
  bool Given(const char* option) const { return app_.count(option) > 0; }
  void Fail(std::string message) { Usage(diagnostics_, std::move(message), kTilesCommand); }

  void ReadNumberOption(const char* name, std::string_view text, uint32_t& value) {
    if (Given(name) && !ReadNumber(text, value)) {
      Fail(fmt::format("{} takes a whole number from 0 to {}, got '{}'", name, UINT32_MAX,
                       Printable(text)));
    }
  }

  void ReadColors() {
    textures::TileSetOptions& set = options_.set;
    if (Given("--corners") && Given("--edges"))
      Fail("--corners and --edges are two kinds of tiles; one of them is made");
    if (Given("--corners")) {
      if (!ReadNumber(std::string_view(raw_.corners), set.colors[0]))
        Fail(fmt::format("--corners takes 2 to 4, got '{}'", Printable(raw_.corners)));
      set.colors[1] = set.colors[0];
    }
    if (Given("--edges")) {
      set.kind = textures::TileKind::kWang;
      if (!ReadWhole(raw_.edges, ',', set.colors)) {
        Fail(fmt::format("--edges takes H,V from 1 to 4 each, like 2,2; got '{}'",
                         Printable(raw_.edges)));
      }
    } else if (options_.corner_pack) {
      Fail("--corner-pack needs --edges: where corners have colours, the pack has them right");
    }
  }

  void ReadWeights() {
    if (!Given("--weights")) return;
    std::vector<double>& weights = options_.weights;
    bool good = true;
    for (std::string_view rest = raw_.weights; good;) {
      const size_t comma = rest.find(',');
      double weight = 0;
      good =
          ReadNumber(rest.substr(0, comma), weight) && weight >= 0 && weight <= graph::kMaxWeight;
      weights.push_back(weight);
      if (comma == std::string_view::npos) break;
      rest.remove_prefix(comma + 1);
    }
    if (!good || std::ranges::max(weights) <= 0) {
      Fail(
          fmt::format("--weights takes numbers from 0 to {:g}, not all of them 0, like 1,0.5; got "
                      "'{}'",
                      graph::kMaxWeight, Printable(raw_.weights)));
    } else if (weights.size() != options_.maps.size()) {
      Fail(fmt::format("--weights has {} for {} maps; it takes one for each", weights.size(),
                       options_.maps.size()));
    }
  }

  void ReadTilingSize() {
    if (!Given("--tiling-size")) return;
    if (options_.tiling.empty()) Fail("--tiling-size needs --tiling FILE");
    const std::string_view text = raw_.tiling_size;
    auto& size = options_.tiling_size;
    bool good = ReadWhole(text, 'x', size);
    if (!good && ReadNumber(text, size[0])) {
      size[1] = size[0];
      good = true;
    }
    if (!good || size[0] == 0 || size[1] == 0)
      Fail(fmt::format("--tiling-size takes CxR or N from 1 on, got '{}'", Printable(text)));
  }

  void CheckFiles() {
    const size_t maps = options_.maps.size();
    if (!options_.packs.empty() && options_.packs.size() != maps && maps > 0) {
      Fail(fmt::format("-o names {} of the {} packs; it names one for each map, or none",
                       options_.packs.size(), maps));
    }
    CheckPicture("--view", options_.view);
    CheckPicture("--tiling", options_.tiling);
    for (const std::string& pack : options_.packs) {
      CheckPicture("-o", pack);
      if (pack == "-" && options_.corner_pack)
        Fail("--corner-pack writes beside the pack, and standard output has no beside");
    }
    if (Given("--json") && options_.json.empty()) Fail("--json takes a file, got ''");
  }

  void CheckPicture(const char* option, const std::string& path) {
    if (path.empty()) {
      if (Given(option)) Fail(fmt::format("{} takes a file, got ''", option));
      return;
    }
    const std::string extension = ExtensionOf(path);
    if (!extension.empty() && extension != "png")
      Fail(fmt::format("'{}': tiles are written to .png files", Printable(path)));
  }

  const CLI::App& app_;
  const TilesTexts& raw_;
  TilesOptions& options_;
  Diagnostics& diagnostics_;
};

}  // namespace

std::optional<TilesOptions> ReadTilesOptions(int argc, const char* const* argv, bool& wants_help,
                                             Diagnostics& diagnostics) {
  // What may begin with a minus sign.
  static constexpr std::string_view kNumbers[] = {"--tile-size",  "--corners",    "--edges",
                                                  "--seed",       "--candidates", "--weights",
                                                  "--tiling-size"};
  TilesOptions options;
  TilesTexts raw;
  CLI::App app;
  DeclareTiles(app, options, raw);
  if (!ParseOptions(argc, argv, kNumbers, kTilesCommand, app, diagnostics)) return std::nullopt;
  wants_help = raw.help;
  if (wants_help) return options;
  TilesOptionReader(app, raw, options, diagnostics).Read();
  if (diagnostics.HasErrors()) return std::nullopt;
  return options;
}

}  // namespace texgraph::cli
