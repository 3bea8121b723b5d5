// SPDX-License-Identifier: Apache-2.0
#include "cli/texgraph/render_options.h"

#include <fmt/format.h>
#include <stdlib.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>

#include "cli/texgraph/help.h"
#include "cli/texgraph/mesh_options.h"
#include "cli/texgraph/option_values.h"
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

bool TakesColor() {
  const char* terminal = getenv("TERM");
  const char* no_color = getenv("NO_COLOR");
  return isatty(STDERR_FILENO) && (no_color == nullptr || *no_color == '\0') &&
         terminal != nullptr && std::string_view(terminal) != "dumb";
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

// CLI11 takes "-1,0,1,1" for options; joined to its name by '=' it is a value.
std::vector<std::string> Arguments(int argc, const char* const* argv) {
  std::vector<std::string> arguments;
  for (int i = 2; i < argc; ++i) {
    const std::string_view argument = argv[i];
    static constexpr std::string_view kNumbers[] = {"--uv",     "--time",   "--timeout", "--size",
                                                    "--frames", "--camera", "--fov",     "--light",
                                                    "--tile",   "--relief", "--samples"};
    const bool number = std::ranges::find(kNumbers, argument) != std::end(kNumbers);
    if (number && i + 1 < argc) {
      arguments.push_back(fmt::format("{}={}", argument, argv[++i]));
    } else {
      arguments.emplace_back(argument);
    }
  }
  return arguments;
}

// What CLI11 says, in our wording.
std::string Reworded(const CLI::ParseError& error) {
  std::string message = error.what();
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
    return message.substr(0, message.find(':')) + " needs a value";
  }
  message = message.substr(0, message.find('\n'));
  if (!message.empty() && message[0] >= 'A' && message[0] <= 'Z')
    message[0] = static_cast<char>(message[0] + 32);
  return message;
}

void CheckRender(const CLI::App& app, const Raw& raw, RenderOptions& options,
                 Diagnostics& diagnostics) {
  const std::vector<std::string_view> names(std::begin(kLongOptions), std::end(kLongOptions));
  for (const std::string& extra : app.remaining()) {
    if (extra == "--") continue;
    Usage(diagnostics, fmt::format("unknown option '{}'{}", Printable(extra),
                                   DidYouMean(extra.substr(0, extra.find('=')), names)));
  }
  const uint32_t color = ReadWord("--color", raw.color, {"auto", "always", "never"}, diagnostics);
  options.color = color == 1 || (color == 0 && TakesColor());
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

std::optional<TexgraphCommandLine> ReadRender(int argc, const char* const* argv,
                                              Diagnostics& diagnostics) {
  TexgraphCommandLine line;
  Raw raw;
  CLI::App app;
  Declare(app, line.render, raw);
  try {
    const std::vector<std::string> arguments = Arguments(argc, argv);
    app.parse(std::vector<std::string>(arguments.rbegin(),
                                       arguments.rend()));  // CLI11 takes them from the back
  } catch (const CLI::ParseError& error) {
    Usage(diagnostics, Reworded(error));
    return std::nullopt;
  }
  if (raw.help) {
    line.text = kRenderHelp;
    return line;
  }
  CheckRender(app, raw, line.render, diagnostics);
  if (diagnostics.HasErrors()) return std::nullopt;
  return line;
}

}  // namespace

std::optional<TexgraphCommandLine> ReadTexgraphCommandLine(int argc, const char* const* argv,
                                                           Diagnostics& diagnostics) {
  const std::string_view command = argc > 1 ? argv[1] : "";
  if (command == "render") return ReadRender(argc, argv, diagnostics);
  TexgraphCommandLine line;
  if (command == "--help" || command == "-h" || command == "help") {
    line.text = kTexgraphHelp;
    return line;
  }
  if (command == "--version") {
    line.text = "texgraph " TEXGRAPH_VERSION "\n";
    return line;
  }
  const std::vector<std::string_view> names = {"render", "--help", "--version"};
  diagnostics
      .Error(DiagnosticKind::kUsage, {},
             argc > 1 ? fmt::format("unknown command '{}'{}", Printable(command),
                                    DidYouMean(command, names))
                      : "no command given")
      .AddNote({}, "'texgraph --help' lists the commands");
  return std::nullopt;
}

}  // namespace texgraph::cli
