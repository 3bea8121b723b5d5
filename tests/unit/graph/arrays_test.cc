// SPDX-License-Identifier: Apache-2.0
// Lists of numbers and of rows at template ports that take arrays.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <string>
#include <vector>

#include "compiler/graph/literal.h"
#include "tests/unit/graph/check_testing.h"

namespace texgraph::graph {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

Argument List(std::initializer_list<double> numbers, uint32_t columns, bool is_integer = true) {
  Argument argument;
  argument.kind = Argument::Kind::kVector;
  argument.is_integer = is_integer;
  argument.columns = columns;
  for (double number : numbers) argument.numbers.push_back(number);
  return argument;
}

struct ArrayLiteral : ::testing::Test {
  // The literal's type and words, or what is wrong with it.
  std::string Made(const Argument& argument, ir::TypeId element, uint32_t length = 0) {
    Diagnostics diagnostics;
    ir::TypeId type = module.types.Array(element, length);
    auto made = MakeLiteral(argument, type, {"port", "p", "", "", {}}, module, diagnostics);
    // The choice of an overload looks at everything but the sizes of numbers.
    bool fits = made || diagnostics.all()[0].kind == DiagnosticKind::kNumberRange;
    EXPECT_EQ(LiteralCost(argument, type, module.types).has_value(), fits);
    if (!made) return diagnostics.all()[0].message;
    std::string text = module.types.Text(module.constant(*made).type);
    for (uint32_t word : module.Words(*made)) {
      text += ir::IsFloat(element) ? fmt::format(" {}", std::bit_cast<float>(word))
                                   : fmt::format(" {}", static_cast<int32_t>(word));
    }
    return text;
  }
  ir::Module module;
};

TEST_F(ArrayLiteral, HasAsManyElementsAsThereAre) {
  EXPECT_EQ(Made(List({1, 2, 3}, 0), ir::kFloat), "float[3] 1 2 3");
  EXPECT_EQ(Made(List({-7}, 0), ir::kInt), "int[1] -7");
  EXPECT_EQ(Made(List({0.5, 1, 2, 3}, 2, false), ir::kVec2), "vec2[2] 0.5 1 2 3");
  EXPECT_EQ(Made(List({1, 2, 3, 4, 5, 6}, 3), ir::kIvec3), "ivec3[2] 1 2 3 4 5 6");
  EXPECT_EQ(Made(List({1, 2, 3, 4}, 4), ir::kVec4), "vec4[1] 1 2 3 4");
  EXPECT_EQ(Made(List({1, 2, 3, 4}, 2), ir::kVec2, 2), "vec2[2] 1 2 3 4");
  // More than a literal has on the stack.
  Argument many = List({}, 2);
  for (int i = 0; i < 200; ++i) many.numbers.push_back(i);
  EXPECT_THAT(Made(many, ir::kVec2), HasSubstr("vec2[100] 0 1 2 "));
}

TEST_F(ArrayLiteral, HasRowsOfTheElementsWidth) {
  EXPECT_EQ(Made(List({1, 2, 3, 4}, 0), ir::kVec2),
            "port 'p' takes vec2[], got 4 numbers; write each vec2 as a row: [[1, 2], ...]");
  EXPECT_EQ(Made(List({1, 2, 3, 4, 5, 6}, 3), ir::kVec2),
            "port 'p' takes vec2[], got 2 rows of 3 numbers; write each vec2 as a row: "
            "[[1, 2], ...]");
  EXPECT_EQ(Made(List({1, 2, 3}, 1), ir::kFloat),
            "port 'p' takes float[], got 3 rows of 1 number; write all numbers in one row: "
            "[1, 2, 3]");
  EXPECT_EQ(Made(List({1.5, 2}, 0, false), ir::kInt),
            "port 'p' takes int[], got 2 numbers with fractions");
  EXPECT_EQ(Made(List({1, 2, 3, 4, 5, 6}, 2), ir::kVec2, 2),
            "port 'p' takes vec2[2], got 3 rows of 2 numbers");
  EXPECT_THAT(Made(List({1, 1e39}, 2, false), ir::kVec2), HasSubstr("is out of its range"));
  Argument number;
  number.numbers.push_back(3);
  EXPECT_EQ(Made(number, ir::kFloat), "port 'p' takes float[], got 3.0");
}

std::string Polygon(std::string_view points) {
  return fmt::format(
      "\n\"parameters\": {{\"scale\": {{\"type\": \"float\", \"value\": 2}}}},\n"
      "\"nodes\": {{\"n\": {{\"block\": \"sdf_polygon\", \"in\": {{\n"
      "\"points\": {}}}}}}}",
      points);
}

TEST(ArrayPorts, TakeRows) {
  CheckText check(Polygon("[[0, 0], [1, 0.5], [0, 1]]"), "\"height\": \"n\"");
  ASSERT_TRUE(check.checked) << check.Messages();
  const BoundPort& points = check.checked->main.nodes[0].inputs[1];
  ir::ConstId value = std::get<ConstantValue>(points.source).value;
  EXPECT_EQ(check.module.types.Text(check.module.constant(value).type), "vec2[3]");
  EXPECT_EQ(check.module.types.Text(points.type), "vec2[]");
}

TEST(ArrayPorts, RefuseOtherLengthsAndThings) {
  auto expect = [](std::string_view points, const std::vector<std::string>& places,
                   std::string_view message) {
    CheckText check(Polygon(points), "\"height\": \"n\"");
    EXPECT_FALSE(check.checked) << points;
    EXPECT_EQ(check.Places(), places) << check.Messages();
    EXPECT_THAT(check.Messages(), HasSubstr(message));
  };
  expect("[[0, 0], [1, 0]]", {"5:11 value-range (31:39)"},
         "port 'points' of node 'n' takes 3 to 1024 elements, got 2");
  std::string rows;
  for (int i = 0; i < 1025; ++i) rows += i == 0 ? "[0, 1]" : ", [2, 3]";
  expect("[" + rows + "]", {"5:11 size-limit (31:39)"}, "takes 3 to 1024 elements, got 1025");
  expect("[[0, 0], [1, 0], [1]]", {"5:28 bad-value"}, "this row has 1 numbers, the first has 2");
  expect("[]", {"5:11 bad-value"}, "an empty array is no value");
  expect("\"scale\"", {"5:11 port-type (31:39)"}, "takes vec2[], got float");
  expect("\"uv\"", {"5:11 not-constant (31:39)"}, "must be known when the shader is made");
}

}  // namespace
}  // namespace texgraph::graph
