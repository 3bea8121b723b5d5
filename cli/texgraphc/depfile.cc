// SPDX-License-Identifier: Apache-2.0
#include "cli/texgraphc/depfile.h"

#include <unordered_set>

namespace texgraph::cli {
namespace {

// GCC's mkdeps.cc: a space needs a backslash, and then so do the backslashes just before it.
void AppendEscaped(std::string& out, std::string_view name) {
  size_t backslashes = 0;
  for (char c : name) {
    switch (c) {
      case ' ':
      case '\t':
        out.append(backslashes, '\\');
        out += '\\';
        break;
      case '#':
        out += '\\';
        break;
      case '$':
        out += '$';
        break;
      default:
        break;
    }
    backslashes = c == '\\' ? backslashes + 1 : 0;
    out += c;
  }
}

}  // namespace

std::string PrintDepfile(std::string_view target, const std::vector<std::string>& dependencies) {
  std::string out;
  AppendEscaped(out, target);
  out += ':';
  std::unordered_set<std::string_view> seen;
  for (const std::string& name : dependencies) {
    if (!seen.insert(name).second) continue;
    out += " \\\n  ";
    AppendEscaped(out, name);
  }
  out += '\n';
  return out;
}

}  // namespace texgraph::cli
