// SPDX-License-Identifier: Apache-2.0
#include "tests/unit/cli/page.h"

#include <fstream>
#include <sstream>

namespace texgraph {

std::string ReadPage(const std::string& page) {
  std::ifstream file(std::string(TEXGRAPH_SOURCE_DIR "/") + page);
  std::ostringstream read;
  read << file.rdbuf();
  return read.str();
}

std::vector<std::string> Fenced(const std::string& text, const std::string& language) {
  constexpr std::string_view kFence = "\n```";
  std::vector<std::string> found;
  for (size_t at = text.find(kFence); at != std::string::npos; at = text.find(kFence, at)) {
    at += kFence.size();
    const size_t line = text.find('\n', at);
    if (line == std::string::npos) break;
    const size_t end = text.find(kFence, line);
    if (text.substr(at, line - at) == language) {
      found.push_back(text.substr(line + 1, end - line));
    }
    at = end == std::string::npos ? text.size() : end + kFence.size();
  }
  return found;
}

}  // namespace texgraph
