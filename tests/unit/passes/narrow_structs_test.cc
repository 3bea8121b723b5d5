// SPDX-License-Identifier: Apache-2.0
#include "compiler/passes/narrow_structs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "compiler/ir/print.h"
#include "compiler/ir/verify.h"
#include "compiler/passes/passes.h"
#include "tests/unit/ir/module_text.h"

namespace texgraph::passes {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string Narrowed(const std::string& text, bool* any = nullptr) {
  ir::Module module = ir::ModuleFrom(text);
  if (!module.main) return "";
  std::vector<bool> changed(module.functions.size());
  const bool narrowed = NarrowStructs(module, changed);
  if (any) *any = narrowed;
  EXPECT_EQ(ir::Verify(module), "");
  return ir::Print(module);
}

const std::string kStruct = "struct Tile { cell: ivec2, local: vec2, size: vec2, seed: uint }\n";

TEST(NarrowStructsTest, WhatNothingReadsIsGone) {
  const std::string text = Narrowed(kStruct + R"(input uv: vec2
function grid(%p: vec2) -> Tile {
  %0 = convert %p : ivec2
  %1 = fract %p : vec2
  %2 = construct %0, %1, vec2(0.5), 7u : Tile
  return %2
}
function main() -> (color: vec2, opacity: uint) {
  %0 = call grid(@uv) : Tile
  %1 = extract.1 %0 : vec2
  %2 = extract.3 %0 : uint
  return %1, %2
}
main main
)");
  EXPECT_THAT(text, HasSubstr("struct Tile { local: vec2, seed: uint }"));
  EXPECT_THAT(text, HasSubstr("construct %1, 7u : Tile"));
  EXPECT_THAT(text, HasSubstr("extract.0"));
  EXPECT_THAT(text, Not(HasSubstr("extract.3")));
}

// Handing a member on, changed or not, is no use of it.
TEST(NarrowStructsTest, MembersThatOnlyMakeThemselvesAreNotRead) {
  const std::string text = Narrowed(kStruct + R"(input uv: vec2
function moved(%t: Tile) -> Tile {
  %0 = extract.0 %t : ivec2
  %1 = extract.1 %t : vec2
  %2 = extract.2 %t : vec2
  %3 = extract.3 %t : uint
  %4 = mul %2, %2 : vec2
  %5 = add %1, vec2(0.5) : vec2
  %6 = construct %0, %5, %4, %3 : Tile
  return %6
}
function main() -> vec2 {
  %0 = construct ivec2(1, 2), @uv, vec2(0.5), 7u : Tile
  %1 = for %i = 0 to 3 step 1 (%t = %0) : Tile {
    %2 = call moved(%t) : Tile
    yield %2
  }
  %3 = extract.1 %1 : vec2
  return %3
}
main main
)");
  EXPECT_THAT(text, HasSubstr("struct Tile { local: vec2 }"));
}

TEST(NarrowStructsTest, AMemberThatAnotherIsMadeOfStays) {
  const std::string text = Narrowed(kStruct + R"(input uv: vec2
function main() -> vec2 {
  %0 = construct ivec2(1, 2), @uv, vec2(0.5), 7u : Tile
  %1 = extract.2 %0 : vec2
  %2 = construct ivec2(1, 2), %1, vec2(0.5), 7u : Tile
  %3 = extract.1 %2 : vec2
  return %3
}
main main
)");
  EXPECT_THAT(text, HasSubstr("struct Tile { local: vec2, size: vec2 }"));
}

TEST(NarrowStructsTest, ConstantsLoseTheSameMembers) {
  const std::string text = Narrowed(kStruct + R"(struct Two { first: Tile, second: Tile }
input uv: vec2
function main() -> (color: vec2, opacity: uint) {
  %0 = lt 0.5, 0.25 : bool
  %1 = construct ivec2(0), @uv, vec2(0.0), 1u : Tile
  %2 = select %0, %1, Tile(ivec2(1, 2), vec2(3.0, 4.0), vec2(5.0), 6u) : Tile
  %3 = extract.1 %2 : vec2
  %4 = extract.1 Two(Tile(ivec2(1), vec2(2.0), vec2(3.0), 4u), Tile(ivec2(5), vec2(6.0), vec2(7.0), 8u)) : Tile
  %5 = extract.3 %4 : uint
  return %3, %5
}
main main
)");
  EXPECT_THAT(text, HasSubstr("Tile(vec2(3.0, 4.0), 6u)"));
  EXPECT_THAT(text, HasSubstr("Two(Tile(vec2(6.0, 6.0), 8u))"));
}

TEST(NarrowStructsTest, StructsThatAreReadAreLeftAlone) {
  bool any = true;
  Narrowed(R"(struct Pair { a: float, b: float }
input uv: vec2
function main() -> float {
  %0 = extract.0 @uv : float
  %1 = construct %0, 2.0 : Pair
  %2 = extract.0 %1 : float
  %3 = extract.1 %1 : float
  %4 = add %2, %3 : float
  return %4
}
main main
)",
           &any);
  EXPECT_FALSE(any);
}

// A struct keeps one member even if nothing reads it, and with that what the member is made of.
TEST(NarrowStructsTest, TheOneMemberThatStaysIsMadeOfWhatStays) {
  const std::string text = Narrowed(R"(struct Read { a: float, b: float }
struct Passed { c: float, d: float }
input uv: vec2
function second(%passed: Passed, %read: Read) -> float {
  %0 = extract.1 %read : float
  return %0
}
function main() -> float {
  %0 = extract.0 @uv : float
  %1 = construct %0, 2.0 : Read
  %2 = extract.0 %1 : float
  %3 = construct %2, 3.0 : Passed
  %4 = call second(%3, %1) : float
  return %4
}
main main
)");
  EXPECT_THAT(text, HasSubstr("struct Read { a: float, b: float }"));
  EXPECT_THAT(text, HasSubstr("struct Passed { c: float }"));
}

// Simplify drops what went into the members.
TEST(NarrowStructsTest, SimplifyDropsWhatTheyWereMadeOf) {
  ir::Module module = ir::ModuleFrom(kStruct + R"(input uv: vec2
function grid(%p: vec2, %size: vec2) -> Tile {
  %0 = sin %size : vec2
  %1 = cos %0 : vec2
  %2 = exp %1 : vec2
  %3 = sqrt %2 : vec2
  %4 = tan %3 : vec2
  %5 = log %4 : vec2
  %6 = sin %p : vec2
  %7 = convert %6 : ivec2
  %8 = construct %7, %p, %5, 7u : Tile
  return %8
}
function main() -> vec2 {
  %0 = call grid(@uv, vec2(0.3)) : Tile
  %1 = call grid(vec2(0.5), @uv) : Tile
  %2 = extract.1 %0 : vec2
  %3 = extract.1 %1 : vec2
  %4 = add %2, %3 : vec2
  return %4
}
main main
)");
  ASSERT_TRUE(module.main);
  Simplify(module);
  EXPECT_EQ(ir::Verify(module), "");
  const std::string text = ir::Print(module);
  EXPECT_THAT(text, Not(HasSubstr("sin")));
  EXPECT_THAT(text, Not(HasSubstr("exp")));
}

}  // namespace
}  // namespace texgraph::passes
