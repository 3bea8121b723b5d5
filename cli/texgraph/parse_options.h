// SPDX-License-Identifier: Apache-2.0
// What the commands' command lines have in common: parsing with CLI11, whose options are declared
// by the command, and mistakes in our wording.
#pragma once

#include <CLI/CLI.hpp>
#include <span>
#include <string_view>

#include "compiler/base/diagnostics.h"

namespace texgraph::cli {

// Parses what follows the command. The values of `numbers` may begin with a minus sign. False, with
// kUsage reported, if that is not possible.
bool ParseOptions(int argc, const char* const* argv, std::span<const std::string_view> numbers,
                  std::string_view command, CLI::App& app, Diagnostics& diagnostics);

// Reports what the app took for no option of its own; `names` are its long ones.
void ReportUnknownOptions(const CLI::App& app, std::span<const std::string_view> names,
                          std::string_view command, Diagnostics& diagnostics);

// --color WHEN
bool ReadColor(std::string_view text, std::string_view command, Diagnostics& diagnostics);

}  // namespace texgraph::cli
