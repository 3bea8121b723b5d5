// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/document_tree.h"

#include <fmt/format.h>

#include <algorithm>

namespace texgraph::fuzz {
namespace {

constexpr int kOpenLevels = 2;  // so many levels have a line for each member

std::string Quoted(std::string_view text) {
  std::string quoted = "\"";
  for (char c : text) {
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      quoted += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    } else {
      quoted += c;
    }
  }
  return quoted + '"';
}

// A word that YAML reads as text when it stands without quotes.
bool IsPlainWord(std::string_view text) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto inside = [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; };
  return text.size() > 3 && letter(text[0]) && std::ranges::all_of(text, inside) &&
         text != "true" && text != "false" && text != "null";
}

bool IsScalar(const Tree& tree) {
  return tree.kind == Tree::Kind::kString || tree.kind == Tree::Kind::kRaw;
}

void Json(const Tree& tree, int level, std::string& out) {
  if (tree.kind == Tree::Kind::kRaw) out += tree.text;
  if (tree.kind == Tree::Kind::kString) out += Quoted(tree.text);
  if (IsScalar(tree)) return;
  const bool object = tree.kind == Tree::Kind::kObject;
  const bool open = object && level < kOpenLevels && !tree.empty();
  out += object ? "{" : "[";
  const char* separator = "";
  for (const auto& [key, child] : tree.children) {
    out += separator;
    out += open ? "\n" + std::string(2 * (level + 1), ' ') : *separator != '\0' ? " " : "";
    if (object) out += Quoted(key) + ": ";
    Json(child, level + 1, out);
    separator = ",";
  }
  if (open) out += "\n" + std::string(2 * level, ' ');
  out += object ? "}" : "]";
}

void Yaml(const Tree& tree, int level, std::string& out) {
  for (const auto& [key, child] : tree.children) {
    out += std::string(2 * level, ' ') + (IsPlainWord(key) ? key : Quoted(key)) + ":";
    if (child.kind == Tree::Kind::kObject && level < kOpenLevels && !child.empty()) {
      out += '\n';
      Yaml(child, level + 1, out);
      continue;
    }
    out += ' ';
    if (child.kind == Tree::Kind::kString && IsPlainWord(child.text)) {
      out += child.text;
    } else {
      Json(child, kOpenLevels, out);
    }
    out += '\n';
  }
}

}  // namespace

Tree& Tree::Set(std::string_view key, Tree value) {
  return children.emplace_back(std::string(key), std::move(value)).second;
}

std::string PrintJson(const Tree& tree) {
  std::string out;
  Json(tree, 0, out);
  return out + '\n';
}

std::string PrintYaml(const Tree& tree) {
  if (tree.kind != Tree::Kind::kObject || tree.empty()) return PrintJson(tree);
  std::string out;
  Yaml(tree, 0, out);
  return out;
}

}  // namespace texgraph::fuzz
