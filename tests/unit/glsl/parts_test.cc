// SPDX-License-Identifier: Apache-2.0
// The small parts: broken lines, literals, live ranges.
#include <bit>

#include "compiler/glsl/line_writer.h"
#include "compiler/glsl/literals.h"
#include "compiler/glsl/live_ranges.h"
#include "tests/unit/glsl/shader_text.h"

namespace texgraph::glsl {
namespace {

std::string Written(std::string_view line, int indents = 0) {
  std::string text;
  LineWriter writer(text);
  for (int i = 0; i < indents; ++i) writer.Indent();
  writer.Line(line);
  return text;
}

TEST(LineWriter, BreaksAtTheLeastNestedComma) {
  EXPECT_EQ(Written("short;", 2), "    short;\n");
  EXPECT_EQ(
      Written("vec4 layer(Tile tile, sampler2D image, vec3 tint, vec2 dx, vec2 dy, float opacity, "
              "out float coverage) {"),
      "vec4 layer(Tile tile, sampler2D image, vec3 tint, vec2 dx, vec2 dy, float opacity,\n"
      "    out float coverage) {\n");
  EXPECT_EQ(
      Written(
          "out_color = some_function_name(first_argument, max(second_argument, third_argument), "
          "mix(fourth, fifth, sixth));",
          1),
      "  out_color = some_function_name(first_argument, max(second_argument, third_argument),\n"
      "      mix(fourth, fifth, sixth));\n");
}

TEST(LineWriter, BreaksBeforeTheWeakestOperator) {
  EXPECT_EQ(
      Written(
          "float total = the_first_quantity * the_second_quantity + the_third_quantity_of_all * "
          "the_fourth_quantity;"),
      "float total = the_first_quantity * the_second_quantity\n"
      "    + the_third_quantity_of_all * the_fourth_quantity;\n");
  EXPECT_EQ(
      Written(
          "float total = the_first_condition && the_second_condition ? the_first_quantity + 1.0 : "
          "the_second_quantity;"),
      "float total = the_first_condition && the_second_condition ? the_first_quantity + 1.0\n"
      "    : the_second_quantity;\n");
}

TEST(LineWriter, LeavesWhatCannotBeBroken) {
  std::string word(150, 'x');
  EXPECT_EQ(Written(word), word + "\n");
  std::string comment = "// " + word + ", " + word;
  EXPECT_EQ(Written(comment), comment + "\n");
}

TEST(LineWriter, KeepsEveryTokenOfALongLine) {
  std::string line = "const float table[200] = float[200](";
  for (int i = 0; i < 200; ++i) line += (i ? ", " : "") + std::to_string(i) + ".5";
  line += ");";
  std::string text = Written(line), joined;
  size_t start = 0;
  while (start < text.size()) {
    size_t end = text.find('\n', start);
    EXPECT_LE(end - start, LineWriter::kColumns);
    size_t first = text.find_first_not_of(' ', start);
    joined += (joined.empty() ? "" : " ") + text.substr(first, end - first);
    start = end + 1;
  }
  EXPECT_EQ(joined, line);
}

TEST(Literals, OfEveryType) {
  ir::Types types;
  ir::TypeId tile = types.Struct("Tile", {{"cell", ir::kIvec2}, {"size", ir::kFloat}});
  ir::TypeId array = types.Array(ir::kFloat, 3);
  auto literal = [&](ir::TypeId type, std::vector<uint32_t> words) {
    std::string text;
    AppendLiteral(
        types, type, words, [&](ir::TypeId t) { return types.Text(t); }, text);
    return text;
  };
  auto bits = [](float value) { return std::bit_cast<uint32_t>(value); };
  EXPECT_EQ(literal(ir::kFloat, {bits(0.1f)}), "0.1");
  EXPECT_EQ(literal(ir::kFloat, {1}), "1e-45");
  EXPECT_EQ(literal(ir::kFloat, {0x80000000u}), "-0.0");
  EXPECT_EQ(literal(ir::kFloat, {0x7fc00000u}), "uintBitsToFloat(2143289344u)");
  EXPECT_EQ(literal(ir::kInt, {0x80000000u}), "(-2147483647 - 1)");
  EXPECT_EQ(literal(ir::kInt, {0xffffffffu}), "-1");
  EXPECT_EQ(literal(ir::kUint, {0xffffffffu}), "4294967295u");
  EXPECT_EQ(literal(ir::kBvec2, {1, 0}), "bvec2(true, false)");
  EXPECT_EQ(literal(ir::kVec3, {bits(1), bits(1), bits(1)}), "vec3(1.0)");
  // Equal numbers, but not equal bits.
  EXPECT_EQ(literal(ir::kVec2, {0, 0x80000000u}), "vec2(0.0, -0.0)");
  EXPECT_EQ(literal(ir::kMat2, {bits(2), 0, 0, bits(2)}), "mat2(2.0)");
  EXPECT_EQ(literal(ir::kMat2, {bits(2), bits(2), bits(2), bits(2)}), "mat2(2.0, 2.0, 2.0, 2.0)");
  EXPECT_EQ(literal(tile, {1, 0xfffffffeu, bits(0.5f)}), "Tile(ivec2(1, -2), 0.5)");
  EXPECT_EQ(literal(array, {bits(1), bits(2), bits(3)}), "float[3](1.0, 2.0, 3.0)");
}

LiveRange Range(std::vector<LiveRange::Interval> live, std::vector<LiveRange::Write> writes) {
  LiveRange range;
  range.live = std::move(live);
  range.writes = std::move(writes);
  return range;
}

TEST(LiveRange, KnowsWhereItIsLive) {
  LiveRange range = Range({{2, 4}, {8, 8}}, {});
  for (uint32_t position : {2, 3, 4, 8}) EXPECT_TRUE(range.LiveAt(position)) << position;
  for (uint32_t position : {0, 1, 5, 7, 9}) EXPECT_FALSE(range.LiveAt(position)) << position;
}

TEST(LiveRange, AWriteIntoALifeIsInTheWay) {
  constexpr uint32_t kNone = LiveRange::kNoSource;
  auto never = [](uint32_t) { return false; };
  LiveRange b = Range({{3, 6}}, {{2, kNone}});
  // Written before b, or where b is read for the last time: b's value is not lost.
  EXPECT_FALSE(WritesInto(Range({}, {{1, kNone}}), b, never));
  EXPECT_FALSE(WritesInto(Range({}, {{6, kNone}}), b, never));
  EXPECT_FALSE(WritesInto(Range({}, {{9, kNone}}), b, never));
  // Written together with b, or while b is needed.
  EXPECT_TRUE(WritesInto(Range({}, {{2, kNone}}), b, never));
  EXPECT_TRUE(WritesInto(Range({}, {{3, kNone}}), b, never));
  EXPECT_TRUE(WritesInto(Range({}, {{1, kNone}, {5, kNone}}), b, never));
  // What is written is b's own value.
  EXPECT_FALSE(WritesInto(Range({}, {{4, 7}}), b, [](uint32_t source) { return source == 7; }));
}

TEST(LiveRange, MergedIsTheUnion) {
  LiveRange a = Range({{2, 4}, {10, 12}}, {{1, 0}, {9, 0}});
  LiveRange b = Range({{5, 7}, {11, 20}, {30, 31}}, {{4, 0}, {29, 0}});
  Merge(a, b);
  std::vector<uint32_t> live, writes;
  for (uint32_t p = 0; p < 40; ++p) {
    if (a.LiveAt(p)) live.push_back(p);
  }
  for (const LiveRange::Write& write : a.writes) writes.push_back(write.position);
  std::vector<uint32_t> want{2, 3, 4, 5, 6, 7};
  for (uint32_t p = 10; p <= 20; ++p) want.push_back(p);
  want.push_back(30);
  want.push_back(31);
  EXPECT_EQ(live, want);
  EXPECT_EQ(writes, (std::vector<uint32_t>{1, 4, 9, 29}));
}

}  // namespace
}  // namespace texgraph::glsl
