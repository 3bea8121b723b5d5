// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/break_graph.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace texgraph::fuzz {
namespace {

constexpr std::string_view kScalars[] = {"0",
                                         "-1",
                                         "1e39",
                                         "1e-50",
                                         "2147483648",
                                         "-0.0",
                                         "0.5",
                                         "null",
                                         "true",
                                         "\"\"",
                                         "\"uv\"",
                                         "\"a.b.c\"",
                                         "\"nothing\"",
                                         "[]",
                                         "{}",
                                         "[1, 2, 3]",
                                         "[[1]]",
                                         "[true]",
                                         "1e999",
                                         "\"\\u0000\"",
                                         "\"\\ud800\"",
                                         "NaN",
                                         "010",
                                         "[0.5, 0.5]",
                                         "[[1, 2], [3, 4]]",
                                         "\"time\"",
                                         "\"../../../etc/passwd\"",
                                         "\"normal\"",
                                         "4294967295"};
constexpr std::string_view kNames[] = {
    "uv",      "main",   "",         "a__b", "gl_x",  "color", "float", "in",    "texgraph",
    "outputs", "result", "\x1b[31m", "x.y",  "block", "type",  "Tile",  "type ", "\xc3\xa4"};
constexpr std::string_view kBytes[] = {
    "\"", "{",  "}",  "[",  "]",  ",",   ":",   "\n", "\\",  "\xff",  "\xed\xa0\x80", "\0", "#",
    "&a", "*a", "- ", "  ", "\t", "1e5", "// ", "/*", "...", "---\n", "!!int ",       "'",  "|\n"};

class Breaker {
 public:
  explicit Breaker(std::mt19937& random) : random_(random) {}

  void Change(Tree& root) {
    std::vector<Tree*> parents;
    Collect(root, parents);
    if (parents.empty()) return;
    Tree& parent = *parents[Below(parents.size())];
    auto& children = parent.children;
    const size_t at = Below(children.size());
    Tree& other_parent = *parents[Below(parents.size())];
    const auto other = other_parent.children[Below(other_parent.children.size())];
    switch (Below(9)) {
      case 0:
        children.erase(children.begin() + static_cast<std::ptrdiff_t>(at));
        return;
      case 1: {
        const auto doubled = children[at];
        children.insert(children.begin() + static_cast<std::ptrdiff_t>(at), doubled);
        return;
      }
      case 2:
        std::swap(children[at].second, children[Below(children.size())].second);
        return;
      case 3:
        children[at].first = kNames[Below(std::size(kNames))];
        return;
      case 4:
        children[at].first = other.first;
        return;
      case 5:
        children[at].second = other.second;
        return;
      case 6:
        children.push_back(other);
        return;
      case 7:
        Misspell(children[at]);
        return;
      default:
        children[at].second = Tree::Raw(kScalars[Below(std::size(kScalars))]);
    }
  }

  void ChangeBytes(std::string& text) {
    const size_t at = Below(text.size() + 1), length = std::min(Below(8), text.size() - at);
    switch (Below(4)) {
      case 0:
        text.erase(at, length);
        return;
      case 1:
        text.insert(at, kBytes[Below(std::size(kBytes))]);
        return;
      case 2:
        if (at < text.size()) text[at] = static_cast<char>(random_());
        return;
      default:
        text.resize(at);
    }
  }

 private:
  size_t Below(size_t n) { return n == 0 ? 0 : random_() % n; }

  static void Collect(Tree& tree, std::vector<Tree*>& parents) {
    if (!tree.children.empty()) parents.push_back(&tree);
    for (auto& child : tree.children) Collect(child.second, parents);
  }

  void Misspell(std::pair<std::string, Tree>& member) {
    std::string& word =
        member.second.kind == Tree::Kind::kString ? member.second.text : member.first;
    if (word.empty()) return;
    const size_t at = Below(word.size());
    if (Below(2) == 0) {
      word.erase(at, 1);
    } else {
      std::swap(word[at], word[Below(word.size())]);
    }
  }

  std::mt19937& random_;
};

}  // namespace

std::string BreakGraph(const RandomGraphText& graph, std::mt19937& random) {
  Breaker breaker(random);
  Tree tree = graph.tree;
  const uint32_t changes = 1 + random() % 3;
  const bool bytes = random() % 4 == 0;
  for (uint32_t i = 0; i < changes && !bytes; ++i) breaker.Change(tree);
  std::string text = PrintTree(tree, graph.format);
  for (uint32_t i = 0; i < changes && bytes; ++i) breaker.ChangeBytes(text);
  return text;
}

}  // namespace texgraph::fuzz
