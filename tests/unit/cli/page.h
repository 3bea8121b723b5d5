// SPDX-License-Identifier: Apache-2.0
// What stands between the fences of a page of the manual, for tests that do what it says.
#pragma once

#include <string>
#include <vector>

namespace texgraph {

// The whole file, by its path in the project: "docs/patterns.md".
std::string ReadPage(const std::string& page);

// The fenced texts of a part of a page in one language, "json" or "", in their order.
std::vector<std::string> Fenced(const std::string& text, const std::string& language);

}  // namespace texgraph
