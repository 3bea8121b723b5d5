// SPDX-License-Identifier: Apache-2.0
// Lines of GLSL with their indentation. A line that is longer than 100 columns is broken, at the
// least nested comma or operator that still fits, and goes on four columns further right.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace texgraph::glsl {

class LineWriter {
 public:
  static constexpr size_t kColumns = 100;

  explicit LineWriter(std::string& out) : out_(out) {}

  void Line(std::string_view text);
  // An empty line, unless the text is empty or has one there already.
  void Blank();
  void Indent() { indent_ += 2; }
  void Outdent() { indent_ -= 2; }

 private:
  void Piece(std::string_view text, size_t indent);

  std::string& out_;
  size_t indent_ = 0;
};

}  // namespace texgraph::glsl
