// SPDX-License-Identifier: Apache-2.0
// Which identifier stands for what. Names are the users' own where they can be; a clash is settled
// by a number ("uv2"), the same way in every run.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "compiler/base/name_map.h"
#include "compiler/ir/module.h"

namespace texgraph::glsl {

// `wish` with only the characters of GLSL identifiers, without "__", a leading digit or "gl_";
// "value" if nothing is left.
std::string Identifier(std::string_view wish);

// Appends text to a one-line comment: printable ASCII without a backslash, other bytes as '_'.
void AppendComment(std::string_view text, std::string& out);

// What a careful person would call an unnamed value of this operation: "texel", "sum", "uv_dx".
std::string DescriptiveName(const ir::Module& module, const ir::Function& function, ir::ValueId v);

// The same for a variable that holds many values of one type: "point", "numbers".
std::string_view TypeWord(const ir::Types& types, ir::TypeId type);

// Unique names, in scopes. Names of GLSL itself are never given.
class NameTable {
 public:
  // Gives `wish`, or `wish` with the smallest number that is free, until the present scope closes.
  std::string_view Claim(std::string_view wish);
  // Makes a name unavailable.
  void Block(std::string_view name) { Add(std::string(name)); }
  bool IsFree(std::string_view name) const;
  bool IsTaken(std::string_view name) const {
    const uint32_t* count = taken_.Find(name);
    return count && *count > 0;
  }
  // Names for which `unwanted` holds are not given either.
  void Avoid(std::function<bool(std::string_view)> unwanted) { unwanted_ = std::move(unwanted); }

  void Open() { marks_.push_back({log_.size(), number_log_.size()}); }
  void Close();

 private:
  struct Mark {
    size_t names;
    size_t numbers;
  };
  std::string_view Add(std::string name);

  std::deque<std::string> texts_;  // stay, for the views that were given out
  NameMap<uint32_t> taken_;        // how often
  std::unordered_map<std::string_view, uint32_t> next_number_;
  std::vector<std::string_view> log_;
  std::vector<std::pair<std::string_view, uint32_t>> number_log_;  // and the value before
  std::vector<Mark> marks_;
  std::function<bool(std::string_view)> unwanted_;
};

}  // namespace texgraph::glsl
