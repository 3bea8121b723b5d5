// SPDX-License-Identifier: Apache-2.0
// A dependency file in Make syntax, as GCC and Clang write it and make and ninja read it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace texgraph::cli {

// "target: a b c", one name a line, each name once. Spaces, '#' and '$' are escaped; backslashes
// only before a space.
std::string PrintDepfile(std::string_view target, const std::vector<std::string>& dependencies);

}  // namespace texgraph::cli
