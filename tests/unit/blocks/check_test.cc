// SPDX-License-Identifier: Apache-2.0
// What the checker refuses: names, types, shapes of loops and calls, each with its place.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/blocks/block_testing.h"

namespace texgraph::blocks {
namespace {

using ::testing::HasSubstr;

// The body of `float x(...)`, whose first line is line 2.
std::string Body(std::string_view text) {
  return ReportOf("float x(float a, vec3 v, int n, mat3 m, const int k, sampler2D s) {\n" +
                  std::string(text) + "\n}\n");
}

std::string Expression(std::string_view text) { return Body("return " + std::string(text) + ";"); }

TEST(BlockNames, Unknown) {
  EXPECT_EQ(Expression("b"), "2:8: there is no 'b' here [block-name]\n");
  EXPECT_EQ(Body("float offset = a; return offsett;"),
            "2:26: there is no 'offsett' here; did you mean 'offset'? [block-name]\n");
  EXPECT_EQ(
      Expression("smothstep(0.0, 1.0, a)"),
      "2:8: there is no function or block 'smothstep'; did you mean 'smoothstep'? [block-name]\n");
  EXPECT_EQ(Expression("v.q"), "2:10: vec3 has no components 'q'; it has 'xyz' [block-type]\n");
  EXPECT_EQ(Expression("v.xr"), "2:10: vec3 has no components 'xr'; it has 'xyz' [block-type]\n");
  EXPECT_EQ(Expression("v.xw"), "2:10: vec3 has no components 'xw'; it has 'xyz' [block-type]\n");
  EXPECT_EQ(Expression("m.x"), "2:10: mat3 has no member 'x' [block-type]\n");
  EXPECT_EQ(Body("vector3 w = v; return a;"), "2:1: there is no type 'vector3' [block-name]\n");
  EXPECT_EQ(Body("samplerCube w = v; return a;"),
            "2:1: blocks have no 'samplerCube' [block-subset]\n");
  EXPECT_EQ(
      Body("genType w = v; return a;"),
      "2:1: 'genType' stands for nothing here: no parameter of the function is one [block-type]\n");
  EXPECT_EQ(ReportOf("struct S { vec2 size; };\nfloat x(S s) { return s.seze.x; }"),
            "2:25: 'S' has no member 'seze'; did you mean 'size'? [block-type]\n");
  // One wrong declaration is one mistake, however often the name is used.
  EXPECT_EQ(Body("vec5 w = v; w += w; return w.x + w.y;"),
            "2:1: there is no type 'vec5'; did you mean 'vec2'? [block-name]\n");
}

TEST(BlockNames, Scopes) {
  EXPECT_EQ(Body("{ float b = a; } return b;"), "2:25: there is no 'b' here [block-name]\n");
  EXPECT_EQ(Body("if (a > 1.0) float b = a; return b;"),
            "2:34: there is no 'b' here [block-name]\n");
  EXPECT_EQ(Body("for (int i = 0; i < 2; i++) { a += 1.0; } return float(i);"),
            "2:56: there is no 'i' here [block-name]\n");
  EXPECT_EQ(Body("float b = b; return b;"), "2:11: there is no 'b' here [block-name]\n");
  EXPECT_EQ(Body("{ float b = a; { float b = 2.0; a = b; } return b; }"), "");
  EXPECT_EQ(Body("float b = a; float b = a; return b;"),
            "2:20: 'b' is declared twice [block-name]\n  2:7: the first time is here\n");
  EXPECT_EQ(Body("float a = 1.0; return a;"),
            "2:7: 'a' is declared twice [block-name]\n  1:15: the first time is here\n");
  EXPECT_EQ(Body("for (int i = 0; i < 2; i++) { int i = 3; a += float(i); } return a;"),
            "2:35: 'i' is declared twice [block-name]\n  2:10: the first time is here\n");
  EXPECT_EQ(
      Body("float max = a; return max(a, 1.0);"),
      "2:23: 'max' is a variable here, not a function [block-name]\n  2:7: it is declared here\n");
}

TEST(BlockNames, Reserved) {
  EXPECT_EQ(Body("float input = a; return a;"),
            "2:7: 'input' is a reserved word of GLSL [block-name]\n");
  EXPECT_EQ(Body("float gl_a = a; return a;"),
            "2:7: 'gl_a' is reserved: GLSL keeps 'gl_' and '__' for itself [block-name]\n");
  EXPECT_EQ(Body("float a__b = a; return a;"),
            "2:7: 'a__b' is reserved: GLSL keeps 'gl_' and '__' for itself [block-name]\n");
  EXPECT_EQ(ReportOf("float mix(float a) { return a; }\nfloat x(float a) { return a; }"),
            "1:7: 'mix' is the name of a built-in function [block-name]\n");
  EXPECT_EQ(ReportOf("const float filter = 1.0;\nfloat x(float sample) { return sample; }"),
            "1:13: 'filter' is a reserved word of GLSL [block-name]\n");
  EXPECT_EQ(ReportOf("float x(float sample) { return sample; }"),
            "1:15: 'sample' is a reserved word of GLSL [block-name]\n");
  EXPECT_EQ(ReportOf("struct S { float half; };\nfloat x(S s) { return 1.0; }"),
            "1:18: 'half' is a reserved word of GLSL [block-name]\n");
}

TEST(BlockNames, Declarations) {
  EXPECT_EQ(ReportOf("float y(float a) { return a; }"),
            "1:1: this file must define the function 'x' [block-name]\n");
  EXPECT_EQ(ReportOf(""), "1:1: this file must define the function 'x' [block-name]\n");
  EXPECT_EQ(ReportOf("float x(vec2 uv);"),
            "1:7: the block's function 'x' has no body [block-name]\n");
  EXPECT_EQ(ReportOf("const int N = 1;\nstruct N { int i; };\nfloat x() { return 1.0; }"),
            "2:8: 'N' is declared twice [block-name]\n  1:11: the first time is here\n");
  EXPECT_EQ(ReportOf("struct Tile { int i; };\nfloat x() { return 1.0; }").substr(0, 43),
            "1:8: 'Tile' is declared twice [block-name]\n");
  EXPECT_EQ(
      ReportOf("float x(float a) { return a; }\nfloat x(float b) { return b; }"),
      "2:7: two functions 'x' take the same types [block-name]\n  1:7: the first one is here\n");
  EXPECT_EQ(
      ReportOf("genType x(genType a) { return a; }\nvec2 x(vec2 b) { return b; }"),
      "2:6: two functions 'x' take the same types [block-name]\n  1:9: the first one is here\n");
  EXPECT_EQ(ReportOf("float f(vec2 p);\nfloat f(vec2 q);\nfloat x() { return 1.0; }"),
            "2:7: the field 'f' is declared twice [block-name]\n  1:7: the first time is here\n");
  EXPECT_EQ(
      ReportOf("float f(vec2 p);\nfloat f(float p) { return p; }\nfloat x() { return f(1.0); }"),
      "1:7: no function 'f' below agrees with this prototype [block-type]\n"
      "  2:7: this one has its name\n");
  EXPECT_EQ(ReportOf("float f(vec2);\nfloat x() { return f(vec2(1)); }"),
            "1:9: this parameter needs a name [block-name]\n");
  EXPECT_EQ(ReportOf("float x(float result) { return result; }"), "");
  EXPECT_EQ(ReportOf("float x(float a, out float result) { result = a; return a; }"),
            "1:28: 'result' is the name of the returned value's port [block-name]\n"
            "  1:7: the other one is here\n");
  EXPECT_EQ(ReportOf("float image(vec2 uv);\nfloat x(float image) { return image; }"),
            "2:15: two ports have the name 'image' [block-name]\n  1:7: the other one is here\n");
  EXPECT_EQ(ReportOf("float x() { return g(); }\nfloat g() { return 1.0; }"),
            "1:20: 'g' is declared below; move it up [block-name]\n");
  EXPECT_EQ(ReportOf("float x() { return N; }\nconst float N = 1.0;"),
            "1:20: 'N' is declared below; move it up [block-name]\n");
  EXPECT_EQ(ReportOf("float x() { S s; return 1.0; }\nstruct S { int i; };"),
            "1:13: 'S' is declared below; move it up [block-name]\n");
  EXPECT_EQ(ReportOf("float x() { return f(vec2(1)); }\nfloat f(vec2 p);"),
            "1:20: 'f' is declared below; move it up [block-name]\n");
  EXPECT_EQ(ReportOf("float g(); float x() { return g(); }\nfloat g() { return 1.0; }"), "");
}

TEST(BlockTypes, Signatures) {
  EXPECT_EQ(ReportOf("void x(float a) { }"),
            "1:6: a block returns a value or has an 'out' parameter [block-type]\n");
  EXPECT_EQ(ReportOf("float x(float w[2]) { return w[0]; }"),
            "1:15: an array cannot be a port, unless it is 'const' [block-type]\n");
  EXPECT_EQ(ReportOf("void x(inout float a) { a = 1.0; }"),
            "1:20: the parameters of a block go in or out; make two of 'a' [block-subset]\n");
  EXPECT_EQ(ReportOf("void x(out sampler2D s) { }"),
            "1:22: a texture cannot go out [block-type]\n");
  EXPECT_EQ(ReportOf("sampler2D x(sampler2D s) { return s; }"),
            "1:1: a function cannot return a texture [block-type]\n");
  EXPECT_EQ(ReportOf("float x(const mat2 m) { return 1.0; }"),
            "1:20: a 'const' parameter is a scalar, a vector, or an array of numbers or of "
            "vectors of numbers, not mat2 [block-type]\n");
  EXPECT_EQ(ReportOf("float x(void a) { return 1.0; }"),
            "1:9: a parameter cannot be void [block-type]\n");
  EXPECT_EQ(ReportOf("void f(vec2 p);\nfloat x() { return 1.0; }"),
            "1:1: a field returns a value [block-type]\n");
  EXPECT_EQ(ReportOf("float f(const int p);\nfloat x() { return 1.0; }"),
            "1:19: the parameters of a field are plain values that go in [block-subset]\n");
  EXPECT_EQ(ReportOf("void x(out float a) { }"), "1:18: 'a' is never given a value [block-type]\n");
  EXPECT_EQ(ReportOf("float x(float a) { if (a > 1.0) return a; }"),
            "1:7: 'x' may end without returning a value [block-type]\n");
  EXPECT_EQ(ReportOf("float x(float a) { if (a > 1.0) return a; else return 2.0; }"), "");
}

TEST(BlockTypes, ArraysOfAnyLength) {
  EXPECT_EQ(ReportOf("float x(const float w[], const vec4[] c, const ivec2 i[3]) {\n"
                     "  return w[w.length() - 1] + c[1].x + float(i[2].y); }"),
            "");
  EXPECT_EQ(ReportOf("float x(const bool w[]) { return 1.0; }"),
            "1:20: a 'const' parameter is a scalar, a vector, or an array of numbers or of "
            "vectors of numbers, not bool[] [block-type]\n");
  EXPECT_EQ(ReportOf("float x(float w[]) { return 1.0; }"),
            "1:15: an array cannot be a port, unless it is 'const' [block-type]\n");
  EXPECT_EQ(ReportOf("float f(float w[]) { return w[0]; }\nfloat x() { return 1.0; }"),
            "1:15: an array without a length must be a 'const' parameter [block-type]\n");
  EXPECT_EQ(ReportOf("float f(const float w[]);\nfloat x() { return 1.0; }"),
            "1:21: the parameters of a field are plain values that go in [block-subset]\n");
  EXPECT_EQ(ReportOf("struct S { float w[]; };\nfloat x() { return 1.0; }"),
            "1:12: an array has at least one element, and its length is written "
            "[block-constant]\n");
  // What has no length cannot be copied, compared or chosen.
  EXPECT_EQ(ReportOf("float x(const float w[]) { float v[2] = w; return v[0]; }"),
            "1:41: the value of 'v' must be float[2], got float[] [block-type]\n");
  EXPECT_EQ(ReportOf("float x(const int a[], const int b[]) { return a == b ? 1.0 : 0.0; }"),
            "1:48: '==' does not take int[] and int[] [block-type]\n");
  EXPECT_EQ(ReportOf("float x(bool c, const float a[], const float b[]) {\n"
                     "  return (c ? a : b)[0]; }"),
            "2:10: '?' cannot choose between values of type float[] [block-type]\n");
  EXPECT_EQ(ReportOf("float x(const float w[]) { w[0] = 1.0; return w[0]; }"),
            "1:28: 'w' cannot be assigned to [block-type]\n"
            "  1:21: it is a constant or the index of a loop\n");
}

// What is known of an index when the length is.
TEST(BlockTypes, IndexesOfArraysOfAnyLength) {
  EXPECT_EQ(ReportOf("float x(const float w[], const int n) { return w[n - 1]; }"),
            "1:50: the index is outside of float[2], whose last one is 1 [block-type]\n");
  EXPECT_EQ(ReportOf("float x(const float w[]) { return w[w.length() - 3]; }"),
            "1:37: the index is outside of float[2], whose last one is 1 [block-type]\n");
  EXPECT_EQ(ReportOf("float x(const float w[]) { return w.length() > 2 ? w[2] : w[1]; }"), "");
  EXPECT_EQ(ReportOf("float x(const float w[], const float v[]) { float s = 0.0;\n"
                     "  for (int i = 0; i < w.length(); i++) { s += v[i]; } return s; }"),
            "");
}

TEST(BlockTypes, Operators) {
  EXPECT_EQ(Expression("a + true"), "2:8: '+' does not take float and bool [block-type]\n");
  EXPECT_EQ(Expression("v + vec2(a)"), "2:8: '+' does not take vec3 and vec2 [block-type]\n");
  EXPECT_EQ(Expression("a % 2.0"),
            "2:8: '%' does not take float and float; use 'mod' [block-type]\n");
  EXPECT_EQ(Expression("a & 2.0"), "2:8: '&' does not take float and float [block-type]\n");
  EXPECT_EQ(Expression("a << 2"), "2:8: '<<' does not take float and int [block-type]\n");
  EXPECT_EQ(Expression("m * vec2(a)"), "2:8: '*' does not take mat3 and vec2 [block-type]\n");
  EXPECT_EQ(Expression("m + v"), "2:8: '+' does not take mat3 and vec3 [block-type]\n");
  EXPECT_EQ(Expression("-true"), "2:8: '-' does not take bool [block-type]\n");
  EXPECT_EQ(Expression("~a"), "2:8: '~' does not take float [block-type]\n");
  EXPECT_EQ(Expression("a && true"), "2:8: '&&' does not take float and bool [block-type]\n");
  EXPECT_EQ(Expression("v < v ? a : a"),
            "2:8: '<' does not take vec3 and vec3; use 'lessThan' and its kind [block-type]\n");
  EXPECT_EQ(Expression("s == s ? a : a"),
            "2:8: '==' does not take sampler2D and sampler2D [block-type]\n");
  EXPECT_EQ(Expression("v == m ? a : a"), "2:8: '==' does not take vec3 and mat3 [block-type]\n");
  EXPECT_EQ(Expression("a ? a : a"), "2:8: the condition must be bool, got float [block-type]\n");
  EXPECT_EQ(Expression("a > 1.0 ? v : a"),
            "2:8: the two values of '?' are vec3 and float [block-type]\n");
  EXPECT_EQ(Expression("v"), "2:8: what 'x' returns must be float, got vec3 [block-type]\n");
  EXPECT_EQ(Expression("n"), "");
  EXPECT_EQ(Body("return;"), "2:1: 'x' must return a float [block-type]\n");
}

TEST(BlockTypes, Assignments) {
  EXPECT_EQ(Body("n = a; return a;"),
            "2:5: what is assigned must be int, got float [block-type]\n");
  EXPECT_EQ(Body("a += v; return a;"),
            "2:1: what is assigned must be float, got vec3 [block-type]\n");
  EXPECT_EQ(Body("int i = 1.0; return a;"),
            "2:9: the value of 'i' must be int, got float [block-type]\n");
  EXPECT_EQ(Body("k = 1; return a;"),
            "2:1: 'k' cannot be assigned to [block-type]\n"
            "  1:51: it is a constant or the index of a loop\n");
  EXPECT_EQ(Body("s = s; return a;"),
            "2:1: 's' cannot be assigned to [block-type]\n  1:64: it is a texture\n");
  EXPECT_EQ(Body("const float b = a; b = 1.0; return a;"),
            "2:20: 'b' cannot be assigned to [block-type]\n"
            "  2:13: it is a constant or the index of a loop\n");
  EXPECT_EQ(Body("for (int i = 0; i < 2; i++) { i = 3; } return a;"),
            "2:31: 'i' cannot be assigned to [block-type]\n"
            "  2:10: it is a constant or the index of a loop\n");
  EXPECT_EQ(Body("v.xx = vec2(a); return a;"),
            "2:3: a component is assigned twice here [block-type]\n");
  EXPECT_EQ(Body("a + 1.0 = a; return a;"),
            "2:1: this is not a variable, so it cannot be assigned to [block-type]\n");
  EXPECT_EQ(Body("const float b; return a;"),
            "2:13: the constant 'b' needs a value [block-syntax]\n");
  EXPECT_EQ(Body("sampler2D t = s; return a;"),
            "2:1: a variable cannot be a sampler2D [block-type]\n");
  EXPECT_EQ(Body("void t; return a;"), "2:1: a variable cannot be a void [block-type]\n");
  EXPECT_EQ(ReportOf("const float N = 1.0;\nfloat x() { N = 2.0; return N; }"),
            "2:13: 'N' is a constant, so it cannot be assigned to [block-type]\n");
}

TEST(BlockTypes, Arrays) {
  EXPECT_EQ(Body("float w[2]; return w[2];"),
            "2:22: the index is outside of float[2], whose last one is 1 [block-type]\n");
  EXPECT_EQ(Body("float w[2]; return w[-1];"),
            "2:22: the index is outside of float[2], whose last one is 1 [block-type]\n");
  EXPECT_EQ(Expression("v[3]"),
            "2:10: the index is outside of vec3, whose last one is 2 [block-type]\n");
  EXPECT_EQ(Expression("a[0]"), "2:10: float has no elements [block-type]\n");
  EXPECT_EQ(Expression("v[a]"), "2:10: an index must be int, got float [block-type]\n");
  EXPECT_EQ(Expression("v.length()"),
            "2:8: only arrays have '.length()'; this is vec3 [block-type]\n");
  EXPECT_EQ(Body("float w[0]; return a;"),
            "2:9: an array has at least one element, and its length is written [block-constant]\n");
  EXPECT_EQ(Body("float w[2147483647]; return a;"),
            "2:9: an array has at most 1024 elements [size-limit]\n");
  EXPECT_EQ(Body("float w[-1]; return a;"),
            "2:9: an array has at least one element, and its length is written [block-constant]\n");
  EXPECT_EQ(Body("float w[]; return a;"),
            "2:1: an array has at least one element, and its length is written [block-constant]\n");
  EXPECT_EQ(Body("float w[n]; return a;"), "2:9: there is no 'n' here [block-name]\n");
  EXPECT_EQ(Body("float w[a + 1.0]; return a;"), "2:9: there is no 'a' here [block-name]\n");
  EXPECT_EQ(Body("float w[1.5]; return a;"),
            "2:9: the value must be int, got float [block-type]\n");
  EXPECT_EQ(Body("float w[2] = float[2](a); return a;"),
            "2:14: 'float[2]' takes 2 values, got 1 [block-type]\n");
  EXPECT_EQ(Body("float w[2] = float[2](a, v); return a;"),
            "2:26: element 1 must be float, got vec3 [block-type]\n");
  EXPECT_EQ(
      Body("float w[65]; w[n] = a; return w[n];"),
      "2:14: only arrays of at most 64 elements can be written at a computed index [size-limit]\n");
  EXPECT_EQ(Body("mat4 w[257]; return a;"),
            "2:8: this array has more than 4096 numbers [size-limit]\n");
}

TEST(BlockTypes, Structs) {
  EXPECT_EQ(ReportOf("struct S { };\nfloat x() { return 1.0; }"),
            "1:8: a struct needs a member [block-type]\n");
  EXPECT_EQ(ReportOf("struct S { int i; float i; };\nfloat x() { return 1.0; }"),
            "1:25: 'S' has two members 'i' [block-name]\n");
  EXPECT_EQ(ReportOf("struct S { sampler2D s; };\nfloat x() { return 1.0; }"),
            "1:12: a member cannot be a sampler2D [block-type]\n");
  EXPECT_EQ(ReportOf("struct S { S s; };\nfloat x() { return 1.0; }"),
            "1:12: there is no type 'S' [block-name]\n");
  EXPECT_EQ(ReportOf("struct S { int i; vec2 p; };\nfloat x() { S s = S(1, 2.0); return s.p.x; }"),
            "2:24: member 'p' must be vec2, got float [block-type]\n");
  std::string deep = "struct S0 { float a; };\n";
  for (int i = 1; i < 20; ++i) {
    deep += "struct S" + std::to_string(i) + " { S" + std::to_string(i - 1) + " s; };\n";
  }
  EXPECT_THAT(ReportOf(deep + "float x() { return 1.0; }"),
              HasSubstr("17:8: structs nest more than 16 deep here [size-limit]\n"));
  EXPECT_EQ(ReportOf("struct S { mat4 m[200]; mat4 n[200]; };\nfloat x() { return 1.0; }"),
            "1:8: this struct has more than 4096 numbers [size-limit]\n");
}

TEST(BlockTypes, Constructors) {
  EXPECT_EQ(Expression("vec3(a, a)"), "2:8: vec3 takes 3 components, got 2 [block-type]\n");
  EXPECT_EQ(Expression("vec2(a, a, a).x"),
            "2:19: vec2 takes 2 components; this is too much [block-type]\n");
  EXPECT_EQ(Expression("vec3()"), "2:8: vec3 needs at least one value [block-type]\n");
  EXPECT_EQ(Expression("float(a, a)"), "2:8: float takes one value, got 2 [block-type]\n");
  EXPECT_EQ(Expression("mat2(a, a, a)[0].x"),
            "2:8: mat2 takes one value or 4, got 3 [block-type]\n");
  EXPECT_EQ(Expression("mat3(m, a)[0].x"),
            "2:13: mat3 cannot be made of mat3 and more [block-type]\n");
  EXPECT_EQ(Expression("vec2(s).x"), "2:13: vec2 cannot be made of sampler2D [block-type]\n");
  EXPECT_EQ(Expression("sampler2D(a)"), "2:8: a sampler2D cannot be made [block-type]\n");
  EXPECT_EQ(Expression("vec2(v).x + vec2(a, v).y + vec4(m[0], 1).w + float(v) + float(true)"), "");
}

TEST(BlockTypes, Builtins) {
  EXPECT_EQ(Expression("max(a)"), "2:8: 'max' takes 2 arguments, got 1 [block-type]\n");
  EXPECT_EQ(Expression("atan(a, a, a)"),
            "2:8: 'atan' takes 1 or 2 arguments, got 3 [block-type]\n");
  EXPECT_EQ(Expression("max(a, v).x"),
            "2:8: 'max' does not take (float, vec3); they must be of one size [block-type]\n");
  EXPECT_EQ(
      Expression("clamp(v, a, v).x"),
      "2:8: 'clamp' does not take (vec3, float, vec3); they must be of one size [block-type]\n");
  EXPECT_EQ(Expression("sin(true)"), "2:8: 'sin' does not take (bool) [block-type]\n");
  EXPECT_EQ(Expression("sin(m)"), "2:8: 'sin' does not take (mat3) [block-type]\n");
  EXPECT_EQ(Expression("cross(v.xy, v.xy).x"),
            "2:8: 'cross' does not take (vec2, vec2); it takes vec3 [block-type]\n");
  EXPECT_EQ(Expression("any(true) ? a : a"),
            "2:8: 'any' does not take (bool); it takes a vector of bool [block-type]\n");
  EXPECT_EQ(Expression("lessThan(a, a) ? a : a"),
            "2:8: 'lessThan' does not take (float, float); compare scalars with an operator "
            "[block-type]\n");
  EXPECT_EQ(
      Expression("texture(a, v.xy).x"),
      "2:8: 'texture' does not take (float, vec2); the first must be a sampler [block-type]\n");
  EXPECT_EQ(Expression("texture(s, v).x"),
            "2:19: the coordinate must be vec2, got vec3 [block-type]\n");
  EXPECT_EQ(Expression("texelFetch(s, ivec2(1), a).x"),
            "2:32: the level must be int, got float [block-type]\n");
  EXPECT_EQ(
      Expression("determinant(mat4(a))"),
      "2:8: 'determinant' does not take (mat4); blocks have it for mat2 and mat3 [block-type]\n");
  EXPECT_EQ(Expression("dFdx(a)"),
            "2:8: blocks have no 'dFdx'; the compiler owns derivatives; use 'footprint' "
            "[block-subset]\n");
  EXPECT_EQ(Expression("fwidth(a)"),
            "2:8: blocks have no 'fwidth'; the compiler owns derivatives; use 'footprint' "
            "[block-subset]\n");
  EXPECT_EQ(Expression("textureOffset(s, v.xy, ivec2(1)).x"),
            "2:8: blocks have no 'textureOffset' [block-subset]\n");
  EXPECT_EQ(Expression("fract(sin(dot(v.xy, vec2(12.9898, 78.233))) * 43758.5453)"),
            "2:8: the fraction of a large sine differs between machines; use a hash block of the "
            "library [block-subset]\n");
  EXPECT_EQ(Expression("fract(0.5 + 0.5 * sin(a))"), "");
}

TEST(BlockTypes, Calls) {
  std::string f = "float f(float p, vec2 q) { return p; }\n";
  EXPECT_EQ(ReportOf(f + "float x(float a) { return f(a, a); }"),
            "2:32: 'q' of 'f' must be vec2, got float [block-type]\n  1:23: it is declared here\n");
  EXPECT_EQ(ReportOf(f + "float x(float a) { return f(a); }"),
            "2:27: no function 'f' takes (float) [block-type]\n  1:7: it is declared here\n");
  EXPECT_EQ(ReportOf("float g(vec2 p);\nfloat x(float a) { return g(a, a); }"),
            "2:27: 'g' takes 1 arguments, got 2 [block-type]\n  1:7: it is declared here\n");
  EXPECT_EQ(ReportOf("float g(vec2 p);\nfloat x(float a) { return g(a); }"),
            "2:29: 'p' of 'g' must be vec2, got float [block-type]\n");
  std::string outs = "float f(float p, out float q) { q = p; return p; }\n";
  EXPECT_EQ(ReportOf(outs + "float x(float a) { float b; return 1.0 + f(a, b); }"),
            "2:42: 'f' has out parameters, so call it in a statement of its own [block-subset]\n");
  EXPECT_EQ(ReportOf(outs + "float x(float a) { return f(a, a + 1.0); }"),
            "2:32: this is not a variable, so it cannot be assigned to [block-type]\n");
  EXPECT_EQ(ReportOf(outs + "float x(float a) { float b; a = f(a, b); f(a, b); return f(b, a); }"),
            "");
  EXPECT_EQ(
      ReportOf(f + "float x(float a) { f(a, vec2(a)); return a; }"),
      "2:20: this statement does nothing: the function has no out parameters [block-syntax]\n");
  EXPECT_EQ(ReportOf("void f(out float q) { q = 1.0; }\nfloat x(float a) { a = f(a); return a; }"),
            "2:24: what is assigned must be float, got void [block-type]\n");
  EXPECT_EQ(ReportOf("float f(float p, int q) { return p; } float f(int p, float q) { return q; }\n"
                     "float x() { return f(1, 2); }"),
            "2:20: several functions 'f' fit equally well; convert the arguments [block-type]\n"
            "  1:7: this one does\n  1:45: and so does this one\n");
  EXPECT_EQ(
      ReportOf("float x(float a) { return x(a); }"),
      "1:27: 'x' calls itself, and GLSL has no recursion; use a counted loop [block-recursion]\n");
  EXPECT_EQ(ReportOf("float g(float a);\nfloat f(float a) { return g(a); }\n"
                     "float g(float a) { return f(a); }\nfloat x(float a) { return f(a); }"),
            "3:27: 'f' calls itself through 'g', and GLSL has no recursion; use a counted loop "
            "[block-recursion]\n");
}

TEST(BlockTypes, Loops) {
  auto loop = [](std::string_view header) {
    return Body("for (" + std::string(header) + ") { a += 1.0; } return a;");
  };
  EXPECT_EQ(loop("float i = 0.0; i < 1.0; i += 0.5"),
            "2:6: a loop has one index, an int: 'for (int i = 0; i < n; i++)' [block-subset]\n");
  EXPECT_EQ(loop("int i = 0, j = 0; i < 1; i++"),
            "2:6: a loop has one index, an int: 'for (int i = 0; i < n; i++)' [block-subset]\n");
  EXPECT_EQ(loop("int i; i < 3; i++"),
            "2:10: the loop's index needs its first value [block-subset]\n");
  EXPECT_EQ(loop("int i = 0; i != 3; i++"),
            "2:17: a loop compares its index with a bound: 'i < n' [block-subset]\n");
  EXPECT_EQ(loop("int i = 0; 3 > i; i++"),
            "2:17: a loop compares its index with a bound: 'i < n' [block-subset]\n");
  EXPECT_EQ(loop("int i = 0; i < 2 - i; i++"),
            "2:21: the loop's bound cannot depend on the loop's index [block-subset]\n");
  EXPECT_EQ(loop("int i = 0; i < 3; i *= 2"),
            "2:24: a loop steps its index: 'i++' or 'i += 2' [block-subset]\n");
  EXPECT_EQ(loop("int i = 0; i < 3; n++"),
            "2:24: a loop steps its index: 'i++' or 'i += 2' [block-subset]\n");
  EXPECT_EQ(
      loop("int i = 0; i < n; i++"),
      "2:21: the loop's bound must be known when the shader is made; use constants and 'const' "
      "parameters [block-constant]\n");
  EXPECT_EQ(loop("int i = n; i < 2; i++"),
            "2:14: the loop's first value must be known when the shader is made; use constants and "
            "'const' parameters [block-constant]\n");
  EXPECT_EQ(
      loop("int i = 0; i < k; i += n"),
      "2:29: the loop's step must be known when the shader is made; use constants and 'const' "
      "parameters [block-constant]\n");
  EXPECT_EQ(
      loop("int i = 0; i < 65536; i++"),
      "2:1: this loop makes 65536 rounds; llvmpipe ends all loops after 65535 [loop-limit]\n");
  EXPECT_EQ(loop("int i = 0; i < 65535; i++"), "");
  EXPECT_EQ(loop("int i = 0; i <= 2147483647; i += 1000000"),
            "2:1: this loop does not end [loop-limit]\n");
  EXPECT_EQ(loop("int i = 0; i < 2; i--"), "2:1: this loop does not end [loop-limit]\n");
  EXPECT_EQ(loop("int i = 0; i < 2; i += 0"), "2:1: this loop does not end [loop-limit]\n");
  EXPECT_EQ(loop("int i = 2; i > 0; i++"), "2:1: this loop does not end [loop-limit]\n");
  EXPECT_EQ(loop("int i = 0; i > 2; i++"), "");
  EXPECT_EQ(
      Body("for (int i = 0; i < 2; i++) { return a; } return a;"),
      "2:31: a loop has no 'return'; keep the value in a variable and return it behind the loop "
      "[block-subset]\n");
  EXPECT_EQ(
      Body("for (int i = 0; i < 300; i++)\nfor (int j = 0; j < 300; j++) a += 1.0;\nreturn a;"),
      "3:1: this loop makes 300 rounds in each of 300; llvmpipe ends all loops after 65535 "
      "[loop-limit]\n");
  EXPECT_EQ(
      ReportOf("float f(float a) { for (int i = 0; i < 300; i++) a += 1.0; return a; }\n"
               "float x(float a) { for (int i = 0; i < 300; i++) a = f(a); return a; }"),
      "2:54: the loops around and in this call make 90000 rounds; llvmpipe ends all loops after "
      "65535 [loop-limit]\n");
}

TEST(BlockTypes, Constants) {
  EXPECT_EQ(ReportOf("const float N = 1.0 / 0.0;\nfloat x() { return N; }"),
            "1:17: this is not a constant, or has no finite value [block-constant]\n");
  EXPECT_EQ(ReportOf("const int N = 1 / 0;\nfloat x() { return 1.0; }"),
            "1:15: this is not a constant, or has no finite value [block-constant]\n");
  EXPECT_EQ(ReportOf("float f() { return 1.0; }\nconst float N = f();\nfloat x() { return N; }"),
            "2:17: a constant cannot call a function that is not built in [block-constant]\n");
  EXPECT_EQ(ReportOf("const int N = 1.5;\nfloat x() { return 1.0; }"),
            "1:15: the value must be int, got float [block-type]\n");
  EXPECT_EQ(
      ReportOf("float f(const int n) { return float(n); }\nfloat x(int n) { return f(n); }"),
      "2:27: 'f' needs a value here that is known when the shader is made [block-constant]\n");
}

TEST(BlockLimits, Sizes) {
  std::string many = "float x(float a) {\n";
  for (int i = 0; i < 5000; ++i) many += "float a" + std::to_string(i) + " = a;\n";
  EXPECT_EQ(ReportOf(many + "return a; }"),
            "4097:7: this function has more than 4096 variables; make functions of its parts "
            "[size-limit]\n");
  std::string parameters = "float x(float a";
  for (int i = 0; i < 256; ++i) parameters += ", float a" + std::to_string(i);
  EXPECT_EQ(ReportOf(parameters + ") { return a; }"),
            "1:7: a function has at most 256 parameters [size-limit]\n");
  std::string fields;
  for (int i = 0; i < 65; ++i) fields += "float f" + std::to_string(i) + "(vec2 p);\n";
  EXPECT_EQ(ReportOf(fields + "float x() { return 1.0; }"),
            "65:7: a file has at most 64 fields [size-limit]\n");
  std::string chain = "float f0(float a) { return a; }\n";
  for (int i = 1; i < 70; ++i) {
    chain +=
        "float f" + std::to_string(i) + "(float a) { return f" + std::to_string(i - 1) + "(a); }\n";
  }
  EXPECT_EQ(ReportOf(chain + "float x(float a) { return f60(a); }"), "");
  EXPECT_EQ(ReportOf(chain + "float x(float a) { return f69(a); }"),
            "8:28: more than 64 functions call each other here [nesting-limit]\n");
  // Work is not repeated: 60 functions that call the one before twice are 60 functions.
  std::string diamond = "float f0(float a) { return a; }\n";
  for (int i = 1; i < 60; ++i) {
    std::string callee = "f" + std::to_string(i - 1);
    diamond += "float f" + std::to_string(i) + "(float a) { return " + callee + "(a) + " + callee +
               "(2.0 * a); }\n";
  }
  TestLibrary test({{"x.glsl", diamond + "float x(float a) { return f59(a); }"}});
  EXPECT_TRUE(test.Function("x"));
  EXPECT_EQ(test.module.functions.size(), 61u);
}

}  // namespace
}  // namespace texgraph::blocks
