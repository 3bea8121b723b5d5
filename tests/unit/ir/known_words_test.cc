// SPDX-License-Identifier: Apache-2.0
#include "compiler/ir/known_words.h"

#include <gtest/gtest.h>

#include <bit>
#include <optional>

#include "tests/unit/ir/module_text.h"

namespace texgraph::ir {
namespace {

KnownWords Float(float value) {
  const uint32_t word = std::bit_cast<uint32_t>(value);
  return KnownWords::All({&word, 1});
}

// A float per word; nothing for what is not known.
std::vector<std::optional<float>> Floats(const KnownWords& known) {
  std::vector<std::optional<float>> floats;
  for (size_t i = 0; i < known.words.size(); ++i) {
    floats.push_back(known.known[i] ? std::optional(std::bit_cast<float>(known.words[i]))
                                    : std::nullopt);
  }
  return floats;
}

using Wanted = std::vector<std::optional<float>>;

Wanted ResultOf(const std::string& text, std::vector<KnownWords> arguments, uint32_t result = 0) {
  Module module = ModuleFrom(text);
  if (!module.main) return {};
  // main, the last, has no parameters; the function before it is asked.
  const FunctionId function(module.main.index - 1);
  return Floats(FindKnownResult(module, function, std::move(arguments), result));
}

const std::optional<float> kUnknown;

TEST(KnownWordsTest, PartsOfAStructAreKnownForThemselves) {
  const std::string text = R"(struct Pair { at: vec2, size: float }
function pair(%x: float, %y: float) -> Pair {
  %0 = mul %y, 2.0 : float
  %1 = construct %x, %y : vec2
  %2 = construct %1, %0 : Pair
  return %2
}
function f(%x: float, %y: float) -> (pair: Pair, sum: float, swapped: vec2) {
  %0 = call pair(%x, %y) : Pair
  %1 = extract.0 %0 : vec2
  %2 = extract.1 %0 : float
  %3 = extract.1 %1 : float
  %4 = add %2, %3 : float
  %5 = swizzle.yx %1 : vec2
  return %0, %4, %5
}
function main() -> float {
  return 0.0
}
main main
)";
  const KnownWords nothing = KnownWords::Nothing(1);
  EXPECT_EQ(ResultOf(text, {nothing, Float(3)}, 0), (Wanted{kUnknown, 3, 6}));
  EXPECT_EQ(ResultOf(text, {nothing, Float(3)}, 1), (Wanted{9}));
  EXPECT_EQ(ResultOf(text, {nothing, Float(3)}, 2), (Wanted{3, kUnknown}));
  EXPECT_EQ(ResultOf(text, {Float(3), nothing}, 1), (Wanted{kUnknown}));
}

TEST(KnownWordsTest, BothSidesOfAnUnknownIfMustAgree) {
  const std::string text = R"(function f(%x: float) -> (same: float, other: float) {
  %0 = lt %x, 1.0 : bool
  %1 = if %0 : (float, float) {
    yield 2.0, 3.0
  } else {
    yield 2.0, 4.0
  }
  %2 = extract.0 %1 : float
  %3 = extract.1 %1 : float
  return %2, %3
}
function main() -> float {
  return 0.0
}
main main
)";
  EXPECT_EQ(ResultOf(text, {KnownWords::Nothing(1)}, 0), (Wanted{2}));
  EXPECT_EQ(ResultOf(text, {KnownWords::Nothing(1)}, 1), (Wanted{kUnknown}));
  EXPECT_EQ(ResultOf(text, {Float(0)}, 1), (Wanted{3}));
  EXPECT_EQ(ResultOf(text, {Float(5)}, 1), (Wanted{4}));
}

TEST(KnownWordsTest, LoopsRun) {
  const std::string text = R"(function f(%x: float, %y: float) -> (sum: float, last: float) {
  %0 = for %i = 0 to 4 step 1 (%s = %x, %l = %y) : (float, float) {
    %1 = add %s, %s : float
    %2 = convert %i : float
    yield %1, %2
  }
  %3 = extract.0 %0 : float
  %4 = extract.1 %0 : float
  return %3, %4
}
function main() -> float {
  return 0.0
}
main main
)";
  EXPECT_EQ(ResultOf(text, {Float(1.5), KnownWords::Nothing(1)}, 0), (Wanted{24}));
  EXPECT_EQ(ResultOf(text, {KnownWords::Nothing(1), Float(1)}, 0), (Wanted{kUnknown}));
  EXPECT_EQ(ResultOf(text, {KnownWords::Nothing(1), KnownWords::Nothing(1)}, 1), (Wanted{3}));
}

TEST(KnownWordsTest, GlobalsAreNotKnown) {
  const std::string text = R"(input x: float
function f(%y: float) -> float {
  %0 = add @x, %y : float
  return %0
}
function main() -> float {
  return 0.0
}
main main
)";
  EXPECT_EQ(ResultOf(text, {Float(1)}), (Wanted{kUnknown}));
}

}  // namespace
}  // namespace texgraph::ir
