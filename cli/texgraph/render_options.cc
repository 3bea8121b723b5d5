// SPDX-License-Identifier: Apache-2.0
#include "cli/texgraph/render_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string_view>

#include "cli/texgraph/mesh_options.h"
#include "cli/texgraph/option_values.h"
#include "cli/texgraph/parse_options.h"
#include "cli/texgraph/sequence_options.h"

namespace texgraph::cli {
namespace {

// The texts of the options that CLI11 only collects.
struct Raw {
  std::string size = "512";
  std::string window = "0,0,1,1";
  std::string timeout = "60";
  std::string target = "glsl330";
  std::string context = "auto";
  std::string color = "auto";
  SequenceTexts sequence;
  MeshTexts mesh;
  std::vector<std::string> inputs;
  bool help = false;
};

constexpr std::string_view kLongOptions[] = {
    "--size",     "--uv",      "--output", "--format",        "--bits",
    "--time",     "--sweep",   "--frames", "--root",          "--set",
    "--help",     "--color",   "--target", "--contact-sheet", "--context",
    "--timeout",  "--version", "--mesh",   "--camera",        "--fov",
    "--light",    "--tile",    "--relief", "--samples",       "--background",
    "--turntable"};

// A side beyond what any picture may have is a limit, as where it is drawn; anything but a number
// is a mistake.
void ReadSize(std::string_view text, RenderOptions& options, Diagnostics& diagnostics) {
  const size_t times = text.find('x');
  const std::string_view first = text.substr(0, times);
  const std::string_view second = times == std::string_view::npos ? first : text.substr(times + 1);
  int64_t width = 0;
  int64_t height = 0;
  if (!ReadNumber(first, width) || !ReadNumber(second, height)) {
    Usage(diagnostics, fmt::format("--size takes WxH or N, got '{}'", Printable(text)));
    return;
  }
  for (int64_t side : {width, height}) {
    if (side >= 1 && side <= runtime::kMaxPictureSide) continue;
    diagnostics.Error(DiagnosticKind::kSizeLimit, {},
                      fmt::format("a picture has 1 to {} pixels each way, not {} x {}",
                                  runtime::kMaxPictureSide, width, height));
    return;
  }
  options.width = static_cast<uint32_t>(width);
  options.height = static_cast<uint32_t>(height);
}

void ReadWindow(std::string_view text, RenderOptions& options, Diagnostics& diagnostics) {
  std::string_view rest = text;
  for (size_t i = 0; i < 4; ++i) {
    const size_t comma = rest.find(',');
    const bool last = i == 3;
    if ((comma == std::string_view::npos) != last ||
        !ReadNumber(rest.substr(0, comma), options.window[i])) {
      Usage(diagnostics,
            fmt::format("--uv takes four numbers U0,V0,U1,V1, got '{}'", Printable(text)));
      return;
    }
    if (!last) rest.remove_prefix(comma + 1);
  }
}

void Declare(CLI::App& app, RenderOptions& options, Raw& raw) {
  app.set_help_flag();
  app.allow_extras();
  const auto text = [&](const char* name, std::string& value) {
    app.add_option(name, value)->take_last();
  };
  const auto list = [&](const char* name, std::vector<std::string>& values) {
    app.add_option(name, values)->allow_extra_args(false);
  };
  text("-o", options.output);
  text("--size", raw.size);
  text("--uv", raw.window);
  text("--output", options.output_name);
  text("--format", raw.sequence.format);
  text("--bits", raw.sequence.bits);
  text("--time", raw.sequence.time);
  text("--sweep", raw.sequence.sweep);
  text("--frames", raw.sequence.frames);
  text("--mesh", options.mesh.mesh);
  text("--camera", raw.mesh.camera);
  text("--fov", raw.mesh.field_of_view);
  text("--light", raw.mesh.light);
  text("--tile", raw.mesh.tile);
  text("--relief", raw.mesh.relief);
  text("--samples", raw.mesh.samples);
  text("--background", raw.mesh.background);
  app.add_flag("--turntable", options.mesh.turntable);
  text("--timeout", raw.timeout);
  text("--target", raw.target);
  text("--context", raw.context);
  text("--color", raw.color);
  list("--set", options.compile.settings);
  list("-I", options.compile.block_folders);
  list("--root", options.compile.roots);
  app.add_flag("--contact-sheet", options.contact_sheet);
  app.add_flag("-q", options.quiet);
  app.add_flag("-h,--help", raw.help);
  app.add_option("inputs", raw.inputs);
}

void CheckRender(const CLI::App& app, const Raw& raw, RenderOptions& options,
                 Diagnostics& diagnostics) {
  ReportUnknownOptions(app, kLongOptions, "render", diagnostics);
  options.color = ReadColor(raw.color, "render", diagnostics);
  options.compile.target =
      ReadWord("--target", raw.target, {"glsl330", "glsl450"}, diagnostics) == 0 ? Target::kGlsl330
                                                                                 : Target::kGlsl450;
  options.context = static_cast<runtime::ContextChoice>(
      ReadWord("--context", raw.context, {"auto", "egl", "osmesa"}, diagnostics));
  if (app.count("--mesh") > 0 && options.mesh.mesh.empty())
    Usage(diagnostics, "--mesh takes a shape or a .glb file, got ''");
  ReadMeshOptions(raw.mesh, app.count("--uv") > 0, options, diagnostics);
  ReadSequenceOptions(raw.sequence, options, diagnostics);
  ReadSeconds("--timeout", raw.timeout, options.timeout, diagnostics);
  ReadSize(raw.size, options, diagnostics);
  ReadWindow(raw.window, options, diagnostics);
  if (raw.inputs.empty()) Usage(diagnostics, "no graph or manifest given");
  if (raw.inputs.size() > 1) Usage(diagnostics, "one graph or manifest at a time");
  if (raw.inputs.size() == 1) options.input = raw.inputs[0];
  if (options.output.empty()) Usage(diagnostics, "no picture named; '-o FILE' does");
}

}  // namespace

std::optional<RenderOptions> ReadRenderOptions(int argc, const char* const* argv, bool& wants_help,
                                               Diagnostics& diagnostics) {
  // What may begin with a minus sign.
  static constexpr std::string_view kNumbers[] = {"--uv",     "--time",   "--timeout", "--size",
                                                  "--frames", "--camera", "--fov",     "--light",
                                                  "--tile",   "--relief", "--samples"};
  RenderOptions options;
  Raw raw;
  CLI::App app;
  Declare(app, options, raw);
  if (!ParseOptions(argc, argv, kNumbers, "render", app, diagnostics)) return std::nullopt;
  wants_help = raw.help;
  if (wants_help) return options;
  CheckRender(app, raw, options, diagnostics);
  if (diagnostics.HasErrors()) return std::nullopt;
  return options;
}

}  // namespace texgraph::cli
