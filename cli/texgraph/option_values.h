// SPDX-License-Identifier: Apache-2.0
// Reading what follows an option: whole texts or nothing, in every locale the same. What is wrong
// is reported as kUsage, beyond a limit as kSizeLimit.
#pragma once

#include <fmt/format.h>

#include <charconv>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/base/diagnostics.h"

namespace texgraph::cli {

// `command`: whose --help lists the options.
void Usage(Diagnostics& diagnostics, std::string message, std::string_view command = "render");

template <class T>
bool ReadNumber(std::string_view text, T& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

// "A,B"
bool ReadPair(std::string_view text, double& first, double& second);

// The index of `seen` in `words`; 0, reported, if it is none of them.
uint32_t ReadWord(std::string_view option, std::string_view seen,
                  const std::vector<std::string_view>& words, Diagnostics& diagnostics,
                  std::string_view command = "render");

void ReadSeconds(std::string_view option, std::string_view text, double& value,
                 Diagnostics& diagnostics);

// The extension of a path's last part, in lower case and without its dot.
std::string ExtensionOf(std::string_view path);

}  // namespace texgraph::cli
