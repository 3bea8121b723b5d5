// SPDX-License-Identifier: Apache-2.0
#include "cli/texgraph/option_values.h"

#include "compiler/base/text.h"

namespace texgraph::cli {

void Usage(Diagnostics& diagnostics, std::string message) {
  diagnostics.Error(DiagnosticKind::kUsage, {}, std::move(message))
      .AddNote({}, "'texgraph render --help' lists the options");
}

bool ReadPair(std::string_view text, double& first, double& second) {
  const size_t comma = text.find(',');
  return comma != std::string_view::npos && ReadNumber(text.substr(0, comma), first) &&
         ReadNumber(text.substr(comma + 1), second);
}

uint32_t ReadWord(std::string_view option, std::string_view seen,
                  const std::vector<std::string_view>& words, Diagnostics& diagnostics) {
  for (uint32_t i = 0; i < words.size(); ++i) {
    if (words[i] == seen) return i;
  }
  const std::string all = Listed(words, " or ", [](std::string_view word) { return word; });
  Usage(diagnostics, fmt::format("{} takes {}, got '{}'{}", option, all, Printable(seen),
                                 DidYouMean(seen, words)));
  return 0;
}

void ReadSeconds(std::string_view option, std::string_view text, double& value,
                 Diagnostics& diagnostics) {
  if (ReadNumber(text, value)) return;
  Usage(diagnostics,
        fmt::format("{} takes a number of seconds, got '{}'", option, Printable(text)));
}

}  // namespace texgraph::cli
