// SPDX-License-Identifier: Apache-2.0
#include "compiler/manifest/json_writer.h"

#include <utility>

#include "compiler/base/text.h"

namespace texgraph::manifest {

void JsonWriter::Begin(std::string_view key) {
  if (has_members_.empty()) return;
  if (has_members_.back()) out_ += ',';
  has_members_.back() = true;
  out_ += '\n';
  out_.append(2 * has_members_.size(), ' ');
  if (!key.empty()) out_ += JsonQuoted(key) + ": ";
}

void JsonWriter::Open(std::string_view key, char bracket) {
  Begin(key);
  out_ += bracket;
  has_members_.push_back(false);
}

void JsonWriter::Close(char bracket) {
  bool has_members = has_members_.back();
  has_members_.pop_back();
  if (has_members) {
    out_ += '\n';
    out_.append(2 * has_members_.size(), ' ');
  }
  out_ += bracket;
}

void JsonWriter::String(std::string_view key, std::string_view text) { Raw(key, JsonQuoted(text)); }

void JsonWriter::Raw(std::string_view key, std::string_view text) {
  Begin(key);
  out_ += text;
}

std::string JsonWriter::Take() { return std::exchange(out_, {}) + "\n"; }

std::string JsonList(const std::vector<std::string>& items) {
  std::string out = "[";
  for (const std::string& item : items) {
    if (out.size() > 1) out += ", ";
    out += item;
  }
  return out + "]";
}

}  // namespace texgraph::manifest
