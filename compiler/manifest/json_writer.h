// SPDX-License-Identifier: Apache-2.0
// JSON for people and programs: objects and lists over several lines, indented by two spaces; lists
// of plain values on one.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace texgraph::manifest {

class JsonWriter {
 public:
  void OpenObject(std::string_view key = {}) { Open(key, '{'); }
  void CloseObject() { Close('}'); }
  void OpenList(std::string_view key = {}) { Open(key, '['); }
  void CloseList() { Close(']'); }
  void String(std::string_view key, std::string_view text);
  void Bool(std::string_view key, bool value) { Raw(key, value ? "true" : "false"); }
  void Integer(std::string_view key, long long value) { Raw(key, std::to_string(value)); }
  // `text` is JSON already.
  void Raw(std::string_view key, std::string_view text);

  // The document with a line end; the writer is empty afterwards.
  std::string Take();

 private:
  void Open(std::string_view key, char bracket);
  void Close(char bracket);
  void Begin(std::string_view key);

  std::string out_;
  std::vector<bool> has_members_;  // of each open object or list
};

// "[a, b]" of texts that are JSON already.
std::string JsonList(const std::vector<std::string>& items);

}  // namespace texgraph::manifest
