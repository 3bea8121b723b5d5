// SPDX-License-Identifier: Apache-2.0
#include "cli/texgraph/parse_options.h"

#include <fmt/format.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <string>
#include <vector>

#include "cli/texgraph/option_values.h"

namespace texgraph::cli {
namespace {

// CLI11 takes "-1,0,1,1" for options; joined to its name by '=' it is a value.
std::vector<std::string> Arguments(int argc, const char* const* argv,
                                   std::span<const std::string_view> numbers) {
  std::vector<std::string> arguments;
  for (int i = 2; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (std::ranges::find(numbers, argument) != numbers.end() && i + 1 < argc) {
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

bool TakesColor() {
  const char* terminal = getenv("TERM");
  const char* no_color = getenv("NO_COLOR");
  return isatty(STDERR_FILENO) && (no_color == nullptr || *no_color == '\0') &&
         terminal != nullptr && std::string_view(terminal) != "dumb";
}

}  // namespace

bool ParseOptions(int argc, const char* const* argv, std::span<const std::string_view> numbers,
                  std::string_view command, CLI::App& app, Diagnostics& diagnostics) {
  try {
    const std::vector<std::string> arguments = Arguments(argc, argv, numbers);
    app.parse(std::vector<std::string>(arguments.rbegin(),
                                       arguments.rend()));  // CLI11 takes them from the back
    return true;
  } catch (const CLI::ParseError& error) {
    Usage(diagnostics, Reworded(error), command);
    return false;
  }
}

void ReportUnknownOptions(const CLI::App& app, std::span<const std::string_view> names,
                          std::string_view command, Diagnostics& diagnostics) {
  const std::vector<std::string_view> known(names.begin(), names.end());
  for (const std::string& extra : app.remaining()) {
    if (extra == "--") continue;
    Usage(diagnostics,
          fmt::format("unknown option '{}'{}", Printable(extra),
                      DidYouMean(extra.substr(0, extra.find('=')), known)),
          command);
  }
}

bool ReadColor(std::string_view text, std::string_view command, Diagnostics& diagnostics) {
  const uint32_t color =
      ReadWord("--color", text, {"auto", "always", "never"}, diagnostics, command);
  return color == 1 || (color == 0 && TakesColor());
}

}  // namespace texgraph::cli
