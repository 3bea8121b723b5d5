// SPDX-License-Identifier: Apache-2.0
#include "compiler/passes/pattern.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <unordered_map>

#include "compiler/passes/pattern_stack.h"

namespace texgraph::passes {
namespace {

using ir::Op;
using ir::OpShape;

constexpr float kTiny = 1e-20f;

[[noreturn]] void Malformed(std::string_view text, const char* why) {
  std::fprintf(stderr, "texgraph: malformed pattern '%.*s': %s\n", static_cast<int>(text.size()),
               text.data(), why);
  std::abort();
}

struct TestName {
  std::string_view name;
  ValueTest test;
};
constexpr TestName kTests[] = {
    {"const", ValueTest::kConst},
    {"reciprocal", ValueTest::kReciprocal},
    {"negative", ValueTest::kNegative},
    {"wrapping", ValueTest::kWrapping},
    {"power_of_two", ValueTest::kPowerOfTwo},
    {"shift", ValueTest::kShift},
    {"nonnegative", ValueTest::kNonnegative},
    {"integral", ValueTest::kIntegral},
    {"float_integer", ValueTest::kFloatInteger},
};

Op OpNamed(std::string_view name) {
  static const auto& names = *[] {
    auto* made = new std::unordered_map<std::string_view, Op>;
    made->reserve(ir::kOpCount);
    for (int i = 0; i < ir::kOpCount; ++i) {
      made->emplace(ir::Info(static_cast<Op>(i)).name, static_cast<Op>(i));
    }
    return made;
  }();
  auto found = names.find(name);
  if (found == names.end()) Malformed(name, "unknown operation");
  return found->second;
}

// Shapes whose operations are made from their operands' types and the type of the place alone.
bool IsAllowed(OpShape shape) {
  switch (shape) {
    case OpShape::kLeaf:
    case OpShape::kMaking:
    case OpShape::kTaking:
    case OpShape::kControl:
    case OpShape::kCalling:
      return false;
    default:
      return true;
  }
}

class Parser {
 public:
  Parser(std::string_view text, std::vector<PatternNode>& pool) : text_(text), pool_(pool) {}

  void Run() {
    size_t pending = 0;
    do {
      SkipSpaces();
      if (at_ == text_.size()) Malformed(text_, "unexpected end");
      if (text_[at_] == '(') {
        ++at_;
        Open();
      } else if (text_[at_] == ')') {
        ++at_;
        pending -= Close() - 1;
      } else {
        pool_.push_back(Atom(Word()));
        if (open_count_ > 0) ++open_[open_count_ - 1].operand_count;
        ++pending;
      }
      if (pending > kMaxPending) Malformed(text_, "too deep");
    } while (open_count_ > 0);
    SkipSpaces();
    if (at_ != text_.size()) Malformed(text_, "text after the end");
  }

 private:
  void SkipSpaces() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }

  std::string_view Word() {
    const size_t begin = at_;
    while (at_ < text_.size() && text_[at_] != ' ' && text_[at_] != '(' && text_[at_] != ')') ++at_;
    return text_.substr(begin, at_ - begin);
  }

  // Cuts what follows `mark` off the word.
  static std::string_view Suffix(std::string_view& word, char mark) {
    for (size_t i = 1; i < word.size(); ++i) {
      if (word[i] != mark) continue;
      std::string_view suffix = word.substr(i + 1);
      word = word.substr(0, i);
      return suffix;
    }
    return {};
  }

  uint8_t ScalarNamed(std::string_view name) {
    if (name.empty()) return PatternNode::kAnyScalar;
    constexpr std::string_view kNames[] = {"bool", "int", "uint", "float"};
    for (uint8_t i = 0; i < 4; ++i) {
      if (kNames[i] == name) return i;
    }
    Malformed(text_, "unknown scalar");
  }

  void Open() {
    std::string_view word = Word();
    PatternNode node;
    node.kind = PatternNode::Kind::kOp;
    node.scalar = ScalarNamed(Suffix(word, '.'));
    node.op = OpNamed(word);
    if (!IsAllowed(ir::Info(node.op).shape))
      Malformed(text_, "operation that patterns cannot make");
    if (open_count_ == open_.size()) Malformed(text_, "too deep");
    open_[open_count_++] = node;
  }

  size_t Close() {
    if (open_count_ == 0 || open_[open_count_ - 1].operand_count == 0) {
      Malformed(text_, "unbalanced parenthesis");
    }
    const PatternNode node = open_[--open_count_];
    pool_.push_back(node);
    if (open_count_ > 0) ++open_[open_count_ - 1].operand_count;
    return node.operand_count;
  }

  static std::optional<uint8_t> VariableNamed(std::string_view word) {
    if (word == "r") return 8;
    if (word.size() == 1 && word[0] >= 'a' && word[0] <= 'f')
      return static_cast<uint8_t>(word[0] - 'a');
    if (word.size() != 2 || word[1] < '0' || word[1] > '3') return std::nullopt;
    if (word[0] == 'x') return static_cast<uint8_t>(word[1] - '0');
    if (word[0] == 'd') return static_cast<uint8_t>(word[1] - '0' + 4);
    return std::nullopt;
  }

  PatternNode Atom(std::string_view word) {
    PatternNode node;
    const bool is_named = word.size() > 3;
    if (is_named && (word == "true" || word == "false" || word == "ones" || word == "tiny")) {
      node.literal = word == "true" ? 1 : word == "tiny" ? kTiny : 0;
      node.all_ones = word == "ones";
      return node;
    }
    if (!word.empty() && (word[0] == '-' || (word[0] >= '0' && word[0] <= '9'))) {
      auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), node.literal);
      if (error == std::errc() && end == word.data() + word.size()) return node;
    }
    std::string_view test = Suffix(word, ':');
    node.scalar = ScalarNamed(Suffix(word, '.'));
    std::optional<uint8_t> variable = VariableNamed(word);
    if (!variable) Malformed(text_, "unknown word");
    node.kind = PatternNode::Kind::kVariable;
    node.variable = *variable;
    if (test.empty()) return node;
    for (const TestName& known : kTests) {
      if (known.name == test) node.test = known.test;
    }
    if (node.test == ValueTest::kAny) Malformed(text_, "unknown test");
    return node;
  }

  std::string_view text_;
  size_t at_ = 0;
  std::array<PatternNode, 16> open_;
  size_t open_count_ = 0;
  std::vector<PatternNode>& pool_;
};

}  // namespace

std::vector<PatternNode> ParsePattern(std::string_view text) {
  std::vector<PatternNode> nodes;
  ParsePattern(text, nodes);
  return nodes;
}

void ParsePattern(std::string_view text, std::vector<PatternNode>& pool) {
  Parser(text, pool).Run();
}

Op RootOf(std::string_view text) {
  if (!text.starts_with('(')) Malformed(text, "no operation");
  return OpNamed(text.substr(1, text.find_first_of(" .)") - 1));
}

}  // namespace texgraph::passes
