// SPDX-License-Identifier: Apache-2.0
#include "cli/texgraphc/options.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <array>
#include <charconv>
#include <cstdlib>
#include <string_view>

#include "cli/texgraphc/help.h"
#include "compiler/base/text.h"

namespace texgraph::cli {
namespace {

constexpr unsigned kMaxJobs = 256;

template <class T>
struct Word {
  std::string_view word;
  T value;
};
constexpr auto kTargets = std::to_array<Word<Target>>(
    {{"glsl330", Target::kGlsl330}, {"glsl450", Target::kGlsl450}, {"spirv", Target::kSpirv}});
constexpr auto kForms =
    std::to_array<Word<Emit>>({{"shader", Emit::kShader}, {"function", Emit::kFunction}});
constexpr auto kFormats =
    std::to_array<Word<graph::DocumentFormat>>({{"json", graph::DocumentFormat::kJson},
                                                {"jsonc", graph::DocumentFormat::kJsonc},
                                                {"yaml", graph::DocumentFormat::kYaml}});
enum class ColorWhen { kAuto, kAlways, kNever };
constexpr auto kColors = std::to_array<Word<ColorWhen>>(
    {{"auto", ColorWhen::kAuto}, {"always", ColorWhen::kAlways}, {"never", ColorWhen::kNever}});
constexpr auto kPhases = std::to_array<Word<int>>({{"build", 0},
                                                   {"specialize", 1},
                                                   {"simplify", 2},
                                                   {"differentiate", 3},
                                                   {"legalize", 4},
                                                   {"all", 5}});

// The options that compilers spell with one dash and several letters, and what CLI11 knows them as.
constexpr auto kSingleDash = std::to_array<std::pair<std::string_view, std::string_view>>(
    {{"-MD", "--MD"}, {"-MF", "--MF"}, {"-MT", "--MT"}, {"-Werror", "--Werror"}});
constexpr auto kLongOptions = std::to_array<std::string_view>(
    {"--manifest", "--target", "--emit", "--set", "--root", "--format", "--color", "--dump-after",
     "--validate", "--list-blocks", "--print-reference", "--help", "--version", "-Werror"});

// The texts of the options that CLI11 only collects.
struct Raw {
  std::string target = "glsl330", form = "shader", color = "auto", format, jobs = "1";
  bool help = false, version = false;
};

void Usage(Diagnostics& diagnostics, std::string message) {
  diagnostics.Error(DiagnosticKind::kUsage, {}, std::move(message))
      .AddNote({}, "'texgraphc --help' lists the options");
}

// -MF out.d and -MFout.d as --MF out.d, and so on.
std::vector<std::string> SpelledOut(int argc, const char* const* argv) {
  std::vector<std::string> arguments;
  bool options = true;  // until "--"
  for (int i = 1; i < argc; ++i) {
    std::string_view argument = argv[i];
    if (argument == "--") options = false;
    bool found = false;
    for (auto [single, spelled] : kSingleDash) {
      if (!options || !argument.starts_with(single)) continue;
      bool takes_value = single == "-MF" || single == "-MT";
      if (argument != single && !takes_value) continue;
      arguments.emplace_back(spelled);
      if (argument != single) arguments.emplace_back(argument.substr(single.size()));
      found = true;
      break;
    }
    if (!found) arguments.emplace_back(argument);
  }
  return arguments;
}

void Declare(CLI::App& app, Options& options, Raw& raw) {
  app.set_help_flag();
  app.allow_extras();
  auto text = [&](const char* name, std::string& value) {
    app.add_option(name, value)->take_last();
  };
  auto list = [&](const char* name, std::vector<std::string>& values) {
    app.add_option(name, values)->allow_extra_args(false);
  };
  text("-o", options.output);
  text("--manifest", options.manifest);
  text("--target", raw.target);
  text("--emit", raw.form);
  list("--set", options.compile.settings);
  text("-j", raw.jobs);
  list("-I", options.compile.block_folders);
  list("--root", options.compile.roots);
  text("--format", raw.format);
  app.add_flag("--validate", options.compile.validate);
  app.add_flag("--MD", options.write_dependencies);
  text("--MF", options.dependency_file);
  text("--MT", options.dependency_target);
  text("--color", raw.color);
  app.add_flag("-w", options.no_warnings);
  app.add_flag("--Werror", options.warnings_are_errors);
  list("--dump-after", options.compile.dump_after);
  app.add_flag("--list-blocks", options.list_blocks);
  text("--print-reference", options.reference);
  app.add_flag("-h,--help", raw.help);
  app.add_flag("--version", raw.version);
  app.add_option("graphs", options.graphs);
}

template <class T, size_t N>
bool ReadWord(std::string_view option, std::string_view seen, const std::array<Word<T>, N>& words,
              T& value, Diagnostics& diagnostics) {
  std::vector<std::string_view> names;
  for (const Word<T>& word : words) {
    if (word.word == seen) {
      value = word.value;
      return true;
    }
    names.push_back(word.word);
  }
  const std::string all = Listed(names, " or ", [](std::string_view name) { return name; });
  Usage(diagnostics, fmt::format("{} takes {}, got '{}'{}", option, all, Printable(seen),
                                 DidYouMean(seen, names)));
  return false;
}

bool ReadJobs(std::string_view seen, unsigned& jobs, Diagnostics& diagnostics) {
  unsigned value = 0;
  auto [end, error] = std::from_chars(seen.data(), seen.data() + seen.size(), value);
  if (error == std::errc() && end == seen.data() + seen.size() && value <= kMaxJobs) {
    jobs = value;
    return true;
  }
  Usage(diagnostics,
        fmt::format("-j takes a number from 0 to {}, got '{}'", kMaxJobs, Printable(seen)));
  return false;
}

bool ReadWords(const Raw& raw, Options& options, Diagnostics& diagnostics) {
  ColorWhen color = ColorWhen::kAuto;
  bool good = ReadWord("--color", raw.color, kColors, color, diagnostics);
  options.color = color == ColorWhen::kAlways || (color == ColorWhen::kAuto && TerminalHasColor());
  good &= ReadWord("--target", raw.target, kTargets, options.compile.target, diagnostics);
  good &= ReadWord("--emit", raw.form, kForms, options.compile.emit, diagnostics);
  good &= ReadJobs(raw.jobs, options.jobs, diagnostics);
  if (!raw.format.empty()) {
    graph::DocumentFormat format{};
    good &= ReadWord("--format", raw.format, kFormats, format, diagnostics);
    options.format = format;
  }
  for (const std::string& phase : options.compile.dump_after) {
    int ignored = 0;
    good &= ReadWord("--dump-after", phase, kPhases, ignored, diagnostics);
  }
  return good;
}

// Options that exclude or need each other; the first conflict's message, or "".
std::string Conflict(const Options& options) {
  bool several = options.graphs.size() > 1;
  if (options.graphs.empty()) return "no graph given";
  if (std::count(options.graphs.begin(), options.graphs.end(), "-") > 1)
    return "standard input can be read only once";
  if (options.compile.target == Target::kSpirv && options.compile.emit == Emit::kFunction) {
    return "--emit function prints GLSL; it does not go with --target spirv";
  }
  if (several && options.output == "-") return "several shaders cannot all go to standard output";
  if (several && !options.manifest.empty())
    return "--manifest names one file, but there are several graphs";
  if (several && !options.dependency_file.empty())
    return "-MF names one file, but there are several graphs";
  if (several && !options.dependency_target.empty())
    return "-MT names one target, but there are several graphs";
  if (!options.dependency_target.empty() && !options.write_dependencies &&
      options.dependency_file.empty()) {
    return "-MT names the target in a dependency file; add -MD to write one";
  }
  if (options.write_dependencies && options.output == "-" && options.dependency_file.empty()) {
    return "-MD needs -MF when the shader goes to standard output";
  }
  return {};
}

void ReportUnexpected(const std::string& argument, Diagnostics& diagnostics) {
  std::string_view name = std::string_view(argument).substr(0, argument.find('='));
  std::vector<std::string_view> names(kLongOptions.begin(), kLongOptions.end());
  Usage(diagnostics,
        fmt::format("unknown option '{}'{}", Printable(argument), DidYouMean(name, names)));
}

// CLI11's own message in our wording, with options as they were spelled: "-o needs a value".
std::string Reworded(std::string message, bool missing_value) {
  for (auto [single, spelled] : kSingleDash) {
    size_t at = message.find(spelled);
    if (at != std::string::npos) message.replace(at, spelled.size(), single);
  }
  if (missing_value) return message.substr(0, message.find(':')) + " needs a value";
  message = message.substr(0, message.find('\n'));
  if (!message.empty() && message[0] >= 'A' && message[0] <= 'Z') {
    message[0] = static_cast<char>(message[0] + 32);
  }
  return message;
}

}  // namespace

std::optional<CommandLine> ReadCommandLine(int argc, const char* const* argv,
                                           Diagnostics& diagnostics) {
  CommandLine line;
  Options& options = line.options;
  Raw raw;
  CLI::App app;
  Declare(app, options, raw);
  try {
    std::vector<std::string> arguments = SpelledOut(argc, argv);
    app.parse(std::vector<std::string>(arguments.rbegin(),
                                       arguments.rend()));  // CLI11 takes them from the back
  } catch (const CLI::ParseError& error) {
    options.color = TerminalHasColor();
    bool missing_value = dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr;
    Usage(diagnostics, Reworded(error.what(), missing_value));
    return std::nullopt;
  }
  if (raw.help) line.text = kHelp;
  if (raw.version && line.text.empty()) line.text = "texgraphc " TEXGRAPH_VERSION "\n";
  if (!line.text.empty()) return line;
  for (const char* name : {"-o", "--manifest", "--MF", "--MT"}) {
    if (app.count(name) > 0 && app.get_option(name)->as<std::string>().empty()) {
      Usage(diagnostics, Reworded(name, true));
    }
  }
  for (const std::string& argument : app.remaining()) {
    if (argument != "--") ReportUnexpected(argument, diagnostics);
  }
  if (!ReadWords(raw, options, diagnostics) || diagnostics.HasErrors()) return std::nullopt;
  if (options.list_blocks || !options.reference.empty()) return line;
  if (std::string conflict = Conflict(options); !conflict.empty()) {
    Usage(diagnostics, std::move(conflict));
    return std::nullopt;
  }
  if (!options.dependency_file.empty()) options.write_dependencies = true;
  return line;
}

bool TerminalHasColor() {
  const char* terminal = std::getenv("TERM");
  const char* no_color = std::getenv("NO_COLOR");
  return isatty(STDERR_FILENO) && (no_color == nullptr || *no_color == '\0') &&
         terminal != nullptr && std::string_view(terminal) != "dumb";
}

}  // namespace texgraph::cli
