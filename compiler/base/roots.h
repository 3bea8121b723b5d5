// SPDX-License-Identifier: Apache-2.0
// The folders that files named by a graph or a manifest may lie in. Links are followed before a
// path is judged, and an open file is judged once more by where it really is, so neither "..",
// an absolute path, a link, nor a folder exchanged in between leads outside.
#pragma once

#include <string>
#include <vector>

#include "compiler/base/diagnostics.h"

namespace texgraph {

class Roots {
 public:
  // Without folders: files may lie anywhere.
  Roots() = default;
  // Reports kCannotRead for a folder that is not there; nothing lies in that one.
  Roots(const std::vector<std::string>& folders, Diagnostics& diagnostics);

  // Whether `path` may be opened. A path to nothing is judged as text.
  bool Contain(const std::string& path) const;
  // Whether what was opened as `descriptor` lies inside.
  bool ContainFile(int descriptor) const;

 private:
  bool ContainReal(const std::string& real_path) const;

  bool limited_ = false;
  std::vector<std::string> folders_;  // real paths
};

}  // namespace texgraph
