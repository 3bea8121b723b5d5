// SPDX-License-Identifier: Apache-2.0
#include "compiler/base/source.h"

#include <algorithm>

namespace texgraph {

SourceId Sources::Add(std::string name, std::string text) {
  files_.push_back({std::move(name), std::move(text), {}});
  return SourceId(files_.size() - 1);
}

const std::vector<uint32_t>& Sources::LineStarts(const File& file) const {
  if (file.line_starts.empty()) {
    file.line_starts.push_back(0);
    for (size_t i = 0; i < file.text.size(); ++i) {
      if (file.text[i] == '\n') file.line_starts.push_back(static_cast<uint32_t>(i + 1));
    }
  }
  return file.line_starts;
}

LineColumn Sources::Locate(SourceId id, uint32_t offset) const {
  const std::vector<uint32_t>& starts = LineStarts(files_[id.index]);
  auto next = std::upper_bound(starts.begin(), starts.end(), offset);
  size_t line = static_cast<size_t>(next - starts.begin());
  return {static_cast<uint32_t>(line), offset - starts[line - 1] + 1};
}

std::string_view Sources::Line(SourceId id, uint32_t offset) const {
  const File& file = files_[id.index];
  const std::vector<uint32_t>& starts = LineStarts(file);
  uint32_t begin = starts[Locate(id, offset).line - 1];
  size_t end = file.text.find('\n', begin);
  if (end == std::string::npos) end = file.text.size();
  if (end > begin && file.text[end - 1] == '\r') --end;
  return std::string_view(file.text).substr(begin, end - begin);
}

}  // namespace texgraph
