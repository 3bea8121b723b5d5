// SPDX-License-Identifier: Apache-2.0
// A document as a tree that can be changed at will, wrong documents included: keys stand in their
// order and may stand twice. Printed as JSON or YAML it is what the graph reader takes.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace texgraph::fuzz {

struct Tree {
  enum class Kind { kObject, kArray, kString, kRaw };  // kRaw: a number, true, false, null
  Kind kind = Kind::kObject;
  std::string text;  // kString, kRaw
  // Of objects with their keys, of arrays with keys that mean nothing.
  std::vector<std::pair<std::string, Tree>> children;

  static Tree Object() { return {}; }
  static Tree Array() { return {Kind::kArray, "", {}}; }
  static Tree String(std::string_view text) { return {Kind::kString, std::string(text), {}}; }
  static Tree Raw(std::string_view text) { return {Kind::kRaw, std::string(text), {}}; }
  static Tree Bool(bool value) { return Raw(value ? "true" : "false"); }

  // Appends a member and returns it.
  Tree& Set(std::string_view key, Tree value);
  Tree& Add(Tree value) { return Set("", std::move(value)); }
  bool empty() const { return children.empty(); }
};

std::string PrintJson(const Tree& tree);
// Block style outside, flow style from the third level on.
std::string PrintYaml(const Tree& tree);

}  // namespace texgraph::fuzz
