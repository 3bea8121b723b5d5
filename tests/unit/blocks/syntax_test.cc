// SPDX-License-Identifier: Apache-2.0
// What the lexer and the parser refuse, each with its place.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/blocks/block_testing.h"

namespace texgraph::blocks {
namespace {

using ::testing::HasSubstr;

// The body of `float x(float a)`, whose first line is line 2.
std::string Body(std::string_view text) {
  return ReportOf("float x(float a) {\n" + std::string(text) + "\n}\n");
}

TEST(BlockSyntax, AcceptsWhatGlslDoes) {
  EXPECT_EQ(ReportOf("float x(void) { return 1.0; }"), "");
  EXPECT_EQ(
      ReportOf("\xef\xbb\xbf// first\r\nfloat x(in float a, const in int b) {\r\n return a; }"),
      "");
  EXPECT_EQ(
      ReportOf("float x() { return 1. + .5 + 1e3 + 2.5E-3 + 1.0f + 3f + float(0x1Fu + 017u); }"),
      "");
  EXPECT_EQ(ReportOf("float x() { /* a * b // c */ return 1.0; } ;"), "");
  EXPECT_EQ(ReportOf("int x() { return 0xffffffff; }"), "");
  EXPECT_EQ(Body("{;} {{ float b = a, c = b; return (((c))); }}"), "");
  EXPECT_EQ(Body("float[2] w = float[](a, 1.0); float v[2] = float[2](a, w[1]); return v[0];"), "");
  EXPECT_EQ(Body("if (a > 1.0) return 1.0; else if (a > 0.5) return 2.0; return 3.0;"), "");
  EXPECT_EQ(Body("a++; ++a; --a; a--; a += 1.0; return a;"), "");
  EXPECT_EQ(ReportOf("float x(float a); float x(float a) { return a; }"), "");
  EXPECT_EQ(Body("float distance = length(vec2(a)); return distance;"), "");
  EXPECT_EQ(Body("return 1e-50 + 0.000000000000000000000000000000000000000000000000001;"), "");
}

TEST(BlockSyntax, Characters) {
  EXPECT_EQ(Body("return a @ 1.0;"),
            "2:10: '@' means nothing here [block-syntax]\n"
            "2:12: expected ';' after 'return', found '1.0' [block-syntax]\n");
  EXPECT_EQ(Body("return \xc3\xa4;"), "2:8: '\xc3\xa4' means nothing here [block-syntax]\n");
  EXPECT_EQ(Body("/* \xc3\xa4 */ return a; // \xe2\x82\xac"), "");
  EXPECT_EQ(ReportOf("// \xff\nfloat x() { return 1.0; }"), "1:4: this is not UTF-8 [encoding]\n");
  EXPECT_EQ(
      Body("return a; /* no end"),
      "2:11: this comment does not end [block-syntax]\n"
      "4:1: expected '}', found the end of the file [block-syntax]\n  1:18: to close this '{'\n");
}

TEST(BlockSyntax, Numbers) {
  EXPECT_EQ(Body("return 1.0x;"), "2:8: '1.0x' is not a number [block-syntax]\n");
  EXPECT_EQ(Body("return 08.0;"), "");
  EXPECT_EQ(Body("return float(08);"), "2:14: '08' is not a number [block-syntax]\n");
  EXPECT_EQ(Body("return float(0x);"), "2:14: '0x' is not a number [block-syntax]\n");
  EXPECT_EQ(Body("return 1.2.3;"), "2:8: '1.2.3' is not a number [block-syntax]\n");
  EXPECT_EQ(Body("return 1e39;"), "2:8: this number is larger than any float [block-syntax]\n");
  EXPECT_EQ(Body("return float(2147483648);"),
            "2:14: this number is larger than the largest int, 2147483647 [block-syntax]\n");
  EXPECT_EQ(Body("return float(4294967296u);"),
            "2:14: this number is larger than the largest uint, 4294967295 [block-syntax]\n");
  EXPECT_EQ(Body("return 1.0lf;"), "2:11: blocks have no doubles; drop the 'lf' [block-subset]\n");
}

TEST(BlockSyntax, Statements) {
  EXPECT_EQ(Body("float b = a\nreturn b;"),
            "2:12: expected ';' after the statement, found 'return' [block-syntax]\n");
  EXPECT_EQ(Body("return a"), "2:9: expected ';' after 'return', found '}' [block-syntax]\n");
  EXPECT_EQ(Body("a + 1.0; return a;"), "2:1: this statement does nothing [block-syntax]\n");
  EXPECT_EQ(Body("a = = 1.0; return a;"), "2:5: expected a value, found '=' [block-syntax]\n");
  EXPECT_EQ(Body("if a > 1.0) { return a; } return 2.0;"),
            "2:4: expected '(' after 'if', found 'a' [block-syntax]\n"
            "2:11: expected a statement's '=' or ';', found ')' [block-syntax]\n");
  EXPECT_EQ(Body("if (a > ) { return 1.0 } return 2.0;"),
            "2:9: expected a value, found ')' [block-syntax]\n"
            "2:24: expected ';' after 'return', found '}' [block-syntax]\n");
  EXPECT_EQ(Body("else return a;"), "2:1: this 'else' has no 'if' [block-syntax]\n");
  EXPECT_EQ(Body("struct S { int i; }; return a;"),
            "2:1: structs stand outside functions [block-syntax]\n");
  EXPECT_EQ(Body("return max(a 1.0);"),
            "2:14: expected ')' or ',' after the argument, found '1.0' [block-syntax]\n");
  EXPECT_EQ(Body("return a[1;"), "2:11: expected ']' after the index, found ';' [block-syntax]\n");
  EXPECT_EQ(Body("return a ? 1.0;"),
            "2:15: expected ':' between the two values of '?', found ';' [block-syntax]\n");
  EXPECT_EQ(Body("float 2b = a; return a;"),
            "2:7: '2b' is not a number [block-syntax]\n"
            "2:7: expected a statement's '=' or ';', found '2b' [block-syntax]\n");
  // Every mistake is found, once.
  EXPECT_EQ(Body("float b = ;\nfloat c = a +;\nb = )a;\nreturn a;"),
            "2:11: expected a value, found ';' [block-syntax]\n"
            "3:14: expected a value, found ';' [block-syntax]\n"
            "4:5: expected a value, found ')' [block-syntax]\n");
}

TEST(BlockSyntax, Declarations) {
  EXPECT_EQ(Body("return max(a, );"), "2:15: expected a value, found ')' [block-syntax]\n");
  EXPECT_EQ(ReportOf("float x(float a) { return a; } }"),
            "1:32: expected a function, a constant or a struct, found '}' [block-syntax]\n");
  EXPECT_EQ(ReportOf("float x(float a { return a; }"),
            "1:17: expected ')' or ',' after the parameter, found '{' [block-syntax]\n");
  EXPECT_EQ(ReportOf("float x(float a) return a;"),
            "1:18: expected ';' or a body in braces after the parameters, found 'return' "
            "[block-syntax]\n");
  EXPECT_EQ(ReportOf("float x(float a,) { return a; }"),
            "1:17: expected a type, found ')' [block-syntax]\n");
  EXPECT_EQ(ReportOf("struct { int i; }; float x() { return 1.0; }"),
            "1:8: expected the struct's name, found '{' [block-syntax]\n");
  EXPECT_EQ(ReportOf("struct S { int i } float x() { return 1.0; }"),
            "1:18: expected ';' after the member, found '}' [block-syntax]\n"
            "1:20: expected ';' after the struct, found 'float' [block-syntax]\n");
  EXPECT_EQ(ReportOf("const float x(float a) { return a; }"),
            "1:1: a function's result is not 'const' [block-syntax]\n");
  EXPECT_EQ(ReportOf("const int N; float x() { return float(N); }"),
            "1:11: the constant 'N' needs a value [block-syntax]\n");
  EXPECT_EQ(ReportOf("float x(float a = 1.0) { return a; }"),
            "1:17: GLSL has no defaults here; write '/// @param a ... @default value' above the "
            "function [block-subset]\n");
}

// What GLSL has and blocks have not: named, with what to do instead.
TEST(BlockSubset, Statements) {
  constexpr std::string_view kLoop =
      "write 'for (int i = 0; i < n; i++)' with a bound that is known when the shader is made";
  EXPECT_EQ(Body("while (a < 1.0) { a += 1.0; } return a;"),
            "2:1: blocks have no 'while'; " + std::string(kLoop) + " [block-subset]\n");
  EXPECT_EQ(Body("do { a += 1.0; } while (a < 1.0); return a;"),
            "2:1: blocks have no 'do'; " + std::string(kLoop) + " [block-subset]\n");
  EXPECT_EQ(
      Body("for (int i = 0; i < 4; i++) { if (a > 1.0) break; continue; }\nreturn a;"),
      "2:44: blocks have no 'break'; put what may be skipped into an 'if' in the loop's body "
      "[block-subset]\n"
      "2:51: blocks have no 'continue'; put what may be skipped into an 'if' in the loop's body "
      "[block-subset]\n");
  EXPECT_EQ(Body("switch (int(a)) { case 0: return a; default: break; } return a;"),
            "2:1: blocks have no 'switch'; write 'if' and 'else', or choose from a constant array "
            "[block-subset]\n");
  EXPECT_EQ(Body("discard;\nreturn a;"),
            "2:1: blocks have no 'discard'; give an opacity of 0 instead [block-subset]\n");
  EXPECT_EQ(Body("float b = c = a; return a;"),
            "2:13: expected ';' after the statement, found '=' [block-syntax]\n");
  EXPECT_EQ(Body("a = a = 1.0; return a;"),
            "2:7: assign one variable in each statement [block-subset]\n");
  EXPECT_EQ(Body("return a++;"), "2:9: expected ';' after 'return', found '++' [block-syntax]\n");
  EXPECT_EQ(Body("return 1.0 + ++a;"),
            "2:14: '++' stands in a statement of its own [block-subset]\n");
  EXPECT_EQ(Body("float w[2] = { a, a }; return a;"),
            "2:14: blocks have no lists in braces; write a constructor, as in 'float[2](0.0, 1.0)' "
            "[block-subset]\n");
  EXPECT_EQ(Body("float w[2][2]; return a;"),
            "2:11: blocks have no arrays of arrays [block-subset]\n");
  EXPECT_EQ(Body("highp float b = a; return b;"),
            "2:1: blocks have no such qualifiers; leave it out [block-subset]\n");
  EXPECT_EQ(Body("int i; for (i = 0; i < 3; i++) { a += 1.0; } return a;"),
            "2:13: a loop makes its own index: 'for (int i = 0; i < n; i++)' [block-subset]\n");
}

TEST(BlockSubset, Declarations) {
  EXPECT_EQ(ReportOf("#version 330\n#define N 4\nfloat x() { return 1.0; }"),
            "1:1: blocks have no preprocessor; use constants, 'const' parameters and functions "
            "[block-subset]\n"
            "2:1: blocks have no preprocessor; use constants, 'const' parameters and functions "
            "[block-subset]\n");
  EXPECT_EQ(ReportOf("// one \\\nfloat y;\nfloat x() { return 1.0; }"),
            "1:8: blocks have no line continuation [block-subset]\n"
            "2:7: blocks have no global variables but constants; write 'const' or use a parameter "
            "[block-subset]\n");
  EXPECT_EQ(ReportOf("uniform float t;\nin vec2 uv;\nfloat x() { return 1.0; }"),
            "1:1: what a block needs comes in through its function's parameters [block-subset]\n"
            "2:1: what a block needs comes in through its function's parameters [block-subset]\n");
  EXPECT_EQ(ReportOf("precision highp float;\nfloat x() { return 1.0; }"),
            "1:1: blocks have no such qualifiers; leave it out [block-subset]\n");
}

TEST(BlockLimits, Nesting) {
  auto nested = [](size_t depth, std::string_view open, std::string_view middle,
                   std::string_view close) {
    std::string text = "float x(float a) { ";
    for (size_t i = 0; i < depth; ++i) text += open;
    text += middle;
    for (size_t i = 0; i < depth; ++i) text += close;
    return ReportOf(text + " return a; }");
  };
  EXPECT_EQ(nested(90, "{ ", "a = 1.0;", "}"), "");
  std::string sum = "a = a";
  for (int i = 0; i < 90; ++i) sum += " + a";
  EXPECT_EQ(Body(sum + "; return a;"), "");
  for (int i = 0; i < 100; ++i) sum += " + a";
  EXPECT_THAT(Body(sum + "; return a;"), HasSubstr("nested too deeply"));
  for (size_t depth : {300, 3000, 30000}) {
    EXPECT_THAT(nested(depth, "{", "", "}"), HasSubstr("[nesting-limit]"));
    EXPECT_THAT(nested(depth, "if (a > 1.0) ", "a = 1.0;", ""), HasSubstr("[nesting-limit]"));
    EXPECT_THAT(nested(depth, "for (int i = 0; i < 1; i++) ", "a = 1.0;", ""),
                HasSubstr("[nesting-limit]"));
    EXPECT_THAT(nested(depth, "(", "a", ")"), HasSubstr("[nesting-limit]"));
    EXPECT_THAT(Body("return " + std::string(depth, '(') + "a;"), HasSubstr("[nesting-limit]"));
    EXPECT_THAT(Body("return " + std::string(depth, '!') + "a;"), HasSubstr("[nesting-limit]"));
    EXPECT_THAT(Body("return " + std::string(depth, '[')), HasSubstr("[block-syntax]"));
    std::string calls, indexes, chooses;
    for (size_t i = 0; i < depth; ++i) {
      calls += "abs(";
      indexes += "a[";
      chooses += "a ? a : ";
    }
    EXPECT_THAT(Body("return " + calls), HasSubstr("[nesting-limit]"));
    EXPECT_THAT(Body("return " + indexes), HasSubstr("[nesting-limit]"));
    EXPECT_THAT(Body("return " + chooses + "a;"), HasSubstr("[nesting-limit]"));
  }
}

}  // namespace
}  // namespace texgraph::blocks
