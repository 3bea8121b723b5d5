// SPDX-License-Identifier: Apache-2.0
#include "cli/texgraph/option_values.h"

#include "compiler/base/files.h"
#include "compiler/base/text.h"

namespace texgraph::cli {

void Usage(Diagnostics& diagnostics, std::string message, std::string_view command) {
  diagnostics.Error(DiagnosticKind::kUsage, {}, std::move(message))
      .AddNote({}, fmt::format("'texgraph {} --help' lists the options", command));
}

bool ReadPair(std::string_view text, double& first, double& second) {
  const size_t comma = text.find(',');
  return comma != std::string_view::npos && ReadNumber(text.substr(0, comma), first) &&
         ReadNumber(text.substr(comma + 1), second);
}

uint32_t ReadWord(std::string_view option, std::string_view seen,
                  const std::vector<std::string_view>& words, Diagnostics& diagnostics,
                  std::string_view command) {
  for (uint32_t i = 0; i < words.size(); ++i) {
    if (words[i] == seen) return i;
  }
  const std::string all = Listed(words, " or ", [](std::string_view word) { return word; });
  Usage(
      diagnostics,
      fmt::format("{} takes {}, got '{}'{}", option, all, Printable(seen), DidYouMean(seen, words)),
      command);
  return 0;
}

void ReadSeconds(std::string_view option, std::string_view text, double& value,
                 Diagnostics& diagnostics) {
  if (ReadNumber(text, value)) return;
  Usage(diagnostics,
        fmt::format("{} takes a number of seconds, got '{}'", option, Printable(text)));
}

std::string ExtensionOf(std::string_view path) {
  const std::string_view name = FileNameOf(path);
  const size_t dot = name.rfind('.');
  if (dot == std::string_view::npos || dot == 0) return "";
  std::string extension(name.substr(dot + 1));
  for (char& c : extension) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
  }
  return extension;
}

}  // namespace texgraph::cli
