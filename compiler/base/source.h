// SPDX-License-Identifier: Apache-2.0
// The texts that a compilation reads, and positions in them. Every later structure points back here
// with byte ranges, so that a diagnostic can show file, line, column and the line itself.
#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/base/ids.h"

namespace texgraph {

using SourceId = Id<struct SourceTag>;

// Half-open range of byte offsets in one source. An invalid source means "no place" (the command
// line, say).
struct SourceRange {
  SourceId source;
  uint32_t begin = 0;
  uint32_t end = 0;
};

// 1-based line and column; columns count bytes, as compilers and editors' "goto" do.
struct LineColumn {
  uint32_t line = 1;
  uint32_t column = 1;
};

class Sources {
 public:
  // `name` is what diagnostics print: the path as the user gave it, or "<stdin>".
  SourceId Add(std::string name, std::string text);
  const std::string& Name(SourceId id) const { return files_[id.index].name; }
  std::string_view Text(SourceId id) const { return files_[id.index].text; }
  LineColumn Locate(SourceId id, uint32_t offset) const;
  // The line that holds `offset`, without its line end.
  std::string_view Line(SourceId id, uint32_t offset) const;
  size_t size() const { return files_.size(); }

 private:
  struct File {
    std::string name;
    std::string text;
    mutable std::vector<uint32_t> line_starts;  // made when the first position is asked for
  };
  const std::vector<uint32_t>& LineStarts(const File& file) const;
  std::deque<File> files_;
};

}  // namespace texgraph
