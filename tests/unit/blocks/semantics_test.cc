// SPDX-License-Identifier: Apache-2.0
// What blocks compute: the IR is run on the CPU, as lowered with and without folding, and compared
// with the same thing in C++. Every block here is plain GLSL as well, and glslangValidator is
// asked.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <set>

#include "compiler/blocks/plain_glsl.h"
#include "compiler/ir/evaluate.h"
#include "tests/unit/blocks/block_testing.h"

namespace texgraph::blocks {
namespace {

using Floats = std::vector<float>;

// A block `x` of floats, and the same in C++: for each set of arguments, the words of all results.
struct Case {
  std::string text;
  std::vector<Floats> arguments;  // each set: the parameters' words one after the other
  std::function<Floats(const Floats&)> expected;
  std::vector<uint32_t> template_words = {};
};

// Converts floats to the words of the parameters' types.
std::vector<std::vector<uint32_t>> WordsOf(const ir::Module& module, const ir::Function& function,
                                           const Floats& values) {
  std::vector<std::vector<uint32_t>> arguments;
  size_t next = 0;
  for (const ir::Parameter& parameter : function.parameters) {
    std::vector<uint32_t>& words = arguments.emplace_back();
    for (uint32_t i = 0; i < module.types.Words(parameter.type); ++i) {
      float value = values.at(next++);
      words.push_back(ir::IsFloat(parameter.type)
                          ? Bits(value)
                          : static_cast<uint32_t>(static_cast<int64_t>(value)));
    }
  }
  EXPECT_EQ(next, values.size());
  return arguments;
}

void Check(const Case& test_case) {
  SCOPED_TRACE(test_case.text);
  for (bool fold : {true, false}) {
    TestLibrary test(Files{{"x.glsl", test_case.text}}, fold);
    ir::FunctionId id = test.Function("x", 0, test_case.template_words);
    ASSERT_TRUE(id.valid()) << test.Report();
    const ir::Function& function = test.module[id];
    for (const Floats& values : test_case.arguments) {
      Floats expected = test_case.expected(values), seen;
      std::vector<std::vector<uint32_t>> results =
          RunFunction(test.module, id, WordsOf(test.module, function, values));
      for (size_t i = 0; i < results.size(); ++i) {
        bool is_float = ir::IsFloat(function.results[i].type);
        for (uint32_t word : results[i]) {
          seen.push_back(is_float ? std::bit_cast<float>(word)
                                  : static_cast<float>(static_cast<int32_t>(word)));
        }
      }
      EXPECT_THAT(seen, testing::Pointwise(testing::FloatEq(), expected))
          << "fold " << fold << ", of " << testing::PrintToString(values);
    }
  }
}

// f(a, b) for a few pairs.
const std::vector<Floats> kPairs = {{0, 0}, {1, 2}, {-1.5f, 0.25f}, {3, -2}, {2, 2}};

Floats One(float value) { return {value}; }

const std::vector<Case>& Cases() {
  static const std::vector<Case> cases = {
      // Operators and conversions
      {"float x(float a, float b) { return a + 2 * b - a / 4 - -b; }", kPairs,
       [](const Floats& v) { return One(v[0] + 2 * v[1] - v[0] / 4 - -v[1]); }},
      {"int x(int a, int b) { return a * 3 % 5 + (b << 2) - (a >> 1) + (a & b) + (a | b) + (a ^ b) "
       "+ ~a; }",
       {{7, 3}, {-7, 2}, {100, 0}},
       [](const Floats& v) {
         int a = static_cast<int>(v[0]), b = static_cast<int>(v[1]);
         return One(static_cast<float>(a * 3 % 5 + (b << 2) - (a >> 1) + (a & b) + (a | b) +
                                       (a ^ b) + ~a));
       }},
      {"uint x(uint a, int b) { return (a + uint(b)) / 3u % 7u + (a >> b); }",
       {{7, 3}, {4000000, 2}},
       [](const Floats& v) {
         uint32_t a = static_cast<uint32_t>(v[0]), b = static_cast<uint32_t>(v[1]);
         return One(static_cast<float>((a + b) / 3u % 7u + (a >> b)));
       }},
      {"float x(int a, float b) { float c = a; c += a; return c * b + float(a > 1) + "
       "float(uint(a)); }",
       {{3, 0.5f}, {1, -2}},
       [](const Floats& v) { return One(2 * v[0] * v[1] + (v[0] > 1 ? 1.0f : 0.0f) + v[0]); }},
      {"vec4 x(vec2 a) { return vec4(a.yx, vec2(ivec2(a))) + vec4(vec3(1), 0).wxyz + a.xyxy.z; }",
       {{1.5f, -2.5f}},
       [](const Floats& v) {
         return Floats{v[1] + v[0], v[0] + 1 + v[0], 1 + 1 + v[0], -2 + 1 + v[0]};
       }},
      {"bool x(vec2 a, vec2 b) { return a == b || a != b.yx && a.x <= b.x ^^ a.y >= 9.0; }",
       {{1, 2, 1, 2}, {1, 2, 2, 1}, {5, 9, 1, 2}, {5, 3, 1, 3}, {1, 3, 1, 9}},
       [](const Floats& v) {
         bool equal = v[0] == v[2] && v[1] == v[3], crossed = v[0] == v[3] && v[1] == v[2];
         bool second = !crossed && v[0] <= v[2], third = v[1] >= 9;
         return One(equal || (second != third) ? 1.0f : 0.0f);
       }},
      {"float x(float a, float b) { return a > b ? a : b > 0.0 ? sin(b) + sin(a) + cos(a) : -1.0; "
       "}",
       kPairs,
       [](const Floats& v) {
         float sum = std::sin(v[1]) + std::sin(v[0]);
         return One(v[0] > v[1] ? v[0] : v[1] > 0 ? sum + std::cos(v[0]) : -1.0f);
       }},
      // Vectors: reading and writing parts
      {"vec3 x(vec3 a, float b) { a.x = b; a.zy += vec2(1.0, 10.0); a[1] *= 2.0; a.rgb.b -= b; "
       "return a; }",
       {{1, 2, 3, 4}},
       [](const Floats& v) {
         return Floats{v[3], (v[1] + 10) * 2, v[2] + 1 - v[3]};
       }},
      {"vec4 x(vec4 a) { a.wzyx.xy.y = 7.0; a.xyz.zx = a.xy; return a; }",
       {{1, 2, 3, 4}},
       [](const Floats&) {
         return Floats{2, 2, 1, 4};
       }},
      {"vec3 x(vec3 a, int i) { a[i] = 9.0; return a + a[i] * vec3(a[2 - i]); }",
       {{1, 2, 3, 0}, {1, 2, 3, 1}, {1, 2, 3, 2}},
       [](const Floats& v) {
         Floats a{v[0], v[1], v[2]};
         size_t i = static_cast<size_t>(v[3]);
         a[i] = 9;
         float plus = a[i] * a[2 - i];
         return Floats{a[0] + plus, a[1] + plus, a[2] + plus};
       }},
      // Matrices, column by column
      {"vec2 x(vec4 a, vec2 v) { mat2 m = mat2(a.xy, a.z, a.w); m[1].x += 1.0; m[0] *= 2.0;\n"
       "  return m * v + v * m; }",
       {{1, 2, 3, 4, 5, 6}},
       [](const Floats& v) {
         float m00 = 2 * v[0], m01 = 2 * v[1], m10 = v[2] + 1, m11 = v[3];
         return Floats{m00 * v[4] + m10 * v[5] + v[4] * m00 + v[5] * m01,
                       m01 * v[4] + m11 * v[5] + v[4] * m10 + v[5] * m11};
       }},
      {"vec4 x(vec4 a, float s) { mat2 m = mat2(a), n = mat2(s);\n"
       "  mat2 r = (m + n) * 2.0 - m / s - (1.0 - n) * m + -m; return vec4(r[0], r[1]); }",
       {{1, 2, 3, 4, 5}},
       [](const Floats& v) {
         // n is s on the diagonal; 1 - n is 1 minus that, everywhere.
         float n[4] = {v[4], 0, 0, v[4]};
         float k[4] = {1 - n[0], 1, 1, 1 - n[3]};
         float p[4] = {k[0] * v[0] + k[2] * v[1], k[1] * v[0] + k[3] * v[1],
                       k[0] * v[2] + k[2] * v[3], k[1] * v[2] + k[3] * v[3]};
         Floats r;
         for (int i = 0; i < 4; ++i) {
           r.push_back((v[i] + n[i]) * 2 - v[i] / v[4] - p[i] + -v[i]);
         }
         return r;
       }},
      {"vec4 x(vec4 a) { mat3 m = mat3(mat2(a)); mat2 n = mat2(m); m[2] = vec3(5); \n"
       "  return vec4(m[0].z + m[1].y, m[2].x, n[1].x, mat4(2.0)[3].w + mat4(2.0)[3].z); }",
       {{1, 2, 3, 4}},
       [](const Floats& v) {
         return Floats{v[3], 5, v[2], 2};
       }},
      {"vec3 x(vec3 a, vec3 b, vec3 c) { mat3 m = mat3(a, b, c); mat3 i = inverse(m) * m;\n"
       "  return vec3(determinant(m), round(i[0].x + i[1].y + i[2].z), round(i[1].x + i[2].y + "
       "i[0].z)); }",
       {{2, 0, 1, 1, 3, 0, 0, 1, 4}, {1, 2, 3, 0, 1, 4, 5, 6, 0}},
       [](const Floats& v) {
         float det = v[0] * (v[4] * v[8] - v[5] * v[7]) - v[3] * (v[1] * v[8] - v[2] * v[7]) +
                     v[6] * (v[1] * v[5] - v[2] * v[4]);
         return Floats{det, 3, 0};
       }},
      {"vec4 x(vec4 a) { mat2 i = inverse(mat2(a)); return vec4(i[0], i[1]) * "
       "determinant(mat2(a)); }",
       {{4, 2, 1, 3}},
       [](const Floats& v) {
         return Floats{v[3], -v[1], -v[2], v[0]};
       }},
      {"vec4 x(vec2 a, vec2 b) { mat2 o = outerProduct(a, b), t = transpose(o);\n"
       "  mat2 p = matrixCompMult(o, t); return vec4(o[0], t[0]) + vec4(p[1].x); }",
       {{1, 2, 3, 4}},
       [](const Floats& v) {
         float o00 = v[0] * v[2], o01 = v[1] * v[2], o10 = v[0] * v[3];
         float p = o10 * o01;
         return Floats{o00 + p, o01 + p, o00 + p, o10 + p};
       }},
      // Arrays and structs
      {"const float W[3] = float[3](0.25, 0.5, 1.0);\nconst int N = W.length();\n"
       "float x(int i) { float s[N] = W; s[1] += 1.0; s[i] *= 4.0; return s[0] + 10.0 * s[1] + "
       "100.0 * W[i]; }",
       {{0}, {1}, {2}},
       [](const Floats& v) {
         const float w[3] = {0.25f, 0.5f, 1};
         float s[3] = {0.25f, 1.5f, 1};
         size_t i = static_cast<size_t>(v[0]);
         s[i] *= 4;
         return One(s[0] + 10 * s[1] + 100 * w[i]);
       }},
      {"struct P { vec2 at; float w[2]; };\nstruct Q { P a; P b; };\n"
       "float x(vec2 v, int i) { P p = P(v, float[](1.0, 2.0)); Q q = Q(p, p); q.b.at.y = 5.0;\n"
       "  q.a.w[i] = 7.0; p = q.a; return q.b.at.y + q.a.at.x + p.w[0] * 10.0 + p.w[1] * 100.0\n"
       "    + (q.a == q.b ? 1000.0 : 2000.0) + (q == q ? 0.5 : 0.25); }",
       {{1, 2, 0}, {3, 4, 1}},
       [](const Floats& v) {
         return One(5 + v[0] + (v[2] == 0 ? 70 : 10) + (v[2] == 0 ? 200 : 700) + 2000 + 0.5f);
       }},
      {"vec3 x(float a) { const vec3 T[2] = vec3[2](vec3(a), vec3(1, 2, 3)); vec3 u; float w[2];\n"
       "  u.y = a; w[1] = u.y; return T[1] + T[0] * w[1] + u + w[0]; }",
       {{3}},
       [](const Floats& v) {
         return Floats{1 + v[0] * v[0], 2 + v[0] * v[0] + v[0], 3 + v[0] * v[0]};
       }},
      // Branches
      {"float x(float a, float b) { float c = a; if (a > b) { c += 1.0; float a = 9.0; b = a; }\n"
       "  else if (a == b) c = 5.0; else { c -= b; } return c * 10.0 + b; }",
       kPairs,
       [](const Floats& v) {
         float c = v[0], b = v[1];
         if (v[0] > b) {
           c += 1;
           b = 9;
         } else if (v[0] == b) {
           c = 5;
         } else {
           c -= b;
         }
         return One(c * 10 + b);
       }},
      {"float x(float a, float b) { float c; if (a > 0.0) { if (b > 0.0) c = 1.0; else c = 2.0; } "
       "return c; }",
       kPairs, [](const Floats& v) { return One(v[0] > 0 ? (v[1] > 0 ? 1 : 2) : 0); }},
      // Returns: in one side, in the other, in both, and where either may go on
      {"float x(float a, float b) { if (a > b) return 1.0; b *= 2.0; if (b > a) { b += 1.0; } else "
       "return b;\n"
       "  if (a < -1.0) { return -1.0; } else if (a < 0.0) { return -2.0; } return b; }",
       kPairs,
       [](const Floats& v) {
         float a = v[0], b = v[1];
         if (a > b) return One(1);
         b *= 2;
         if (b > a) {
           b += 1;
         } else {
           return One(b);
         }
         if (a < -1) return One(-1);
         if (a < 0) return One(-2);
         return One(b);
       }},
      {"float x(float a, float b) {\n"
       "  if (a > 0.0) { a += 1.0; if (b > 1.0) return a; { b += 0.5; if (b < 0.0) return -a; } a "
       "*= 2.0; }\n"
       "  else { if (b > 0.0) { return 7.0; } a -= 1.0; }\n"
       "  if (a > 100.0) return 0.0;\n"
       "  return a + b; }",
       {{0, 0}, {1, 2}, {-1.5f, 0.25f}, {3, -2}, {2, 0.5f}, {-1, -1}, {99, 0}},
       [](const Floats& v) {
         float a = v[0], b = v[1];
         if (a > 0) {
           a += 1;
           if (b > 1) return One(a);
           b += 0.5f;
           if (b < 0) return One(-a);
           a *= 2;
         } else {
           if (b > 0) return One(7);
           a -= 1;
         }
         if (a > 100) return One(0);
         return One(a + b);
       }},
      {"void x(float a, float b, out float p, out vec2 q) {\n"
       "  p = a; q = vec2(b); if (a > b) { p += 1.0; if (b > 0.0) { q.x = 3.0; return; } q.y = "
       "4.0; }\n"
       "  if (b == 2.0) return; p *= 2.0; }",
       {{0, 0}, {1, 2}, {-1.5f, 0.25f}, {3, -2}, {2, 2}, {3, 1}},
       [](const Floats& v) {
         float a = v[0], b = v[1], p = a, qx = b, qy = b;
         auto all = [&] { return Floats{p, qx, qy}; };
         if (a > b) {
           p += 1;
           if (b > 0) {
             qx = 3;
             return all();
           }
           qy = 4;
         }
         if (b == 2) return all();
         p *= 2;
         return all();
       }},
      // Loops
      {"float x(float a, float b) { float s = 0.0, p = 1.0; for (int i = 0; i < 5; i++) { s += p; "
       "p *= a; }\n"
       "  for (int i = 7; i >= 0; i -= 3) s += float(i); for (int i = -1; i <= 1; i += 1) { s += b "
       "* float(i * i); }\n"
       "  for (int i = 3; i > 5; --i) s = 1e6; return s; }",
       kPairs,
       [](const Floats& v) {
         float s = 0, p = 1;
         for (int i = 0; i < 5; i++) {
           s += p;
           p *= v[0];
         }
         for (int i = 7; i >= 0; i -= 3) s += static_cast<float>(i);
         for (int i = -1; i <= 1; i += 1) s += v[1] * static_cast<float>(i * i);
         return One(s);
       }},
      {"float x(float a, float b) { float s = a; for (int i = 0; i < 3; i++) { float t = 0.0;\n"
       "  for (int j = 0; j < 2; j++) { if (b > 0.0) { t += s; } else t -= float(i + j); } s = t + "
       "1.0; }\n"
       "  if (a > 1.0) { for (int i = 0; i < 2; i++) s *= 0.5; } return s; }",
       kPairs,
       [](const Floats& v) {
         float s = v[0];
         for (int i = 0; i < 3; i++) {
           float t = 0;
           for (int j = 0; j < 2; j++) {
             if (v[1] > 0) {
               t += s;
             } else {
               t -= static_cast<float>(i + j);
             }
           }
           s = t + 1;
         }
         if (v[0] > 1) s *= 0.25f;
         return One(s);
       }},
      {"float x(float a) { float s = 0.0; for (int i = 0; i < 3; i++) { float t; t += a; s += t; } "
       "return s; }",
       {{2}},
       [](const Floats& v) { return One(3 * v[0]); }},
      // Template parameters decide bounds and branches
      {"float x(float a, const int n, const vec2 w, const bool up) { float s = 0.0; int m = n * 2 "
       "- 1;\n"
       "  for (int i = 0; i < m; i++) { s += a; } if (up) { s = -s; } else { m = 1; }\n"
       "  for (int i = 0; i < m; i += int(w.y)) s += w.x; return s; }",
       {{1}, {2}},
       [](const Floats& v) { return One(-5 * v[0] + 3 * 0.5f); },
       {3, Bits(0.5f), Bits(2.0f), 1}},
      {"float x(float a, const int n, const vec2 w, const bool up) { float s = 0.0; int m = n * 2 "
       "- 1;\n"
       "  for (int i = 0; i < m; i++) { s += a; } if (up) { s = -s; } else { m = 1; }\n"
       "  for (int i = 0; i < m; i += int(w.y)) s += w.x; return s; }",
       {{1}, {2}},
       [](const Floats& v) { return One(5 * v[0] + 0.5f); },
       {3, Bits(0.5f), Bits(2.0f), 0}},
      // Functions
      {"float f(float a, inout float b, out float c) { b += a; c = b * 2.0; return b - 1.0; }\n"
       "float x(float a, float b) { vec2 p = vec2(a, b); float c = f(a, p.y, p.x); p.x += f(1.0, "
       "p.y, c);\n"
       "  return p.x * 10.0 + p.y + c * 100.0; }",
       {{1, 2}, {3, -1}},
       [](const Floats& v) {
         float y = v[1] + v[0], x = y * 2, c;
         y += 1;
         c = y * 2;
         x += y - 1;
         return One(x * 10 + y + c * 100);
       }},
      {"genType sq(genType a) { return a * a; }\nint sq(int a) { return -a; }\n"
       "vec3 x(vec3 a, int n) { return sq(a) + sq(a.x) + float(sq(n)) + sq(a.yz).y; }",
       {{1, 2, 3, 4}},
       [](const Floats& v) {
         float plus = v[0] * v[0] - v[3] + v[2] * v[2];
         return Floats{v[0] * v[0] + plus, v[1] * v[1] + plus, v[2] * v[2] + plus};
       }},
      {"float f(int a) { return 1.0; }\nfloat f(float a) { return 2.0; }\nfloat g(float a, float "
       "b) { return 3.0; }\n"
       "float g(int a, float b) { return 4.0; }\n"
       "float x(int a, uint b) { return f(a) + 10.0 * f(b) + 100.0 * g(a, a) + 1000.0 * g(1.0, a); "
       "}",
       {{1, 2}},
       [](const Floats&) { return One(1 + 20 + 400 + 3000); }},
      {"int taps(const int q) { return q == 0 ? 2 : 3; }\n"
       "float sum(float a, const int n) { float s = 0.0; for (int i = 0; i < taps(n) * n; i++) s "
       "+= a; return s; }\n"
       "float x(float a, const int q) { return sum(a, q) + 10.0 * sum(1.0, 2) + sum(5.0, 0); }",
       {{1}, {2}},
       [](const Floats& v) { return One(12 * v[0] + 60); },
       {4}},
      {"struct Part { ivec2 cell; vec2 local; uint seed; };\n"
       "float w(float v[3], Part p) { return v[p.cell.x] + p.local.y; }\n"
       "float x(float a) { Part p = Part(ivec2(1, 2), vec2(a), 3u); return w(float[3](a, "
       "2.0 * a, a), p); }",
       {{2}},
       [](const Floats& v) { return One(3 * v[0]); }},
      // Built-in functions with more than one operation behind them
      {"vec2 x(vec2 a, vec2 b) { return mix(a, b, lessThan(a, b)) + mix(a, b, 0.25) + mix(a, b, "
       "vec2(0, 1)); }",
       {{1, 5, 2, 3}},
       [](const Floats& v) {
         return Floats{v[2] + 0.75f * v[0] + 0.25f * v[2] + v[0],
                       v[1] + 0.75f * v[1] + 0.25f * v[3] + v[3]};
       }},
      {"vec4 x(float a) { return vec4(radians(180.0 * a), degrees(a), atan(a, -1.0), atan(a)); }",
       {{0.5f}, {2}},
       [](const Floats& v) {
         return Floats{180 * v[0] * 0.017453292519943295f, v[0] * 57.29577951308232f,
                       std::atan2(v[0], -1.0f), std::atan(v[0])};
       }},
      {"vec3 x(vec3 a, vec3 b) { return clamp(a, 0.0, 1.0) + max(b, 0.5) + min(a, b) * step(0.5, "
       "b)\n"
       "  + vec3(max(1, 2), abs(-3), sign(-2.0)) + clamp(a, b, b + 1.0) + vec3(mod(a, 2.0).x); }",
       {{-1.5f, 0.25f, 3, 0.25f, 0.75f, 2}},
       [](const Floats& v) {
         Floats r;
         const float plus[3] = {2, 3, -1};
         for (size_t i = 0; i < 3; ++i) {
           float a = v[i], b = v[i + 3];
           r.push_back(std::fmin(std::fmax(a, 0.0f), 1.0f) + std::fmax(b, 0.5f) +
                       std::fmin(a, b) * (b < 0.5f ? 0.0f : 1.0f) + plus[i] +
                       std::fmin(std::fmax(a, b), b + 1) + 0.5f);
         }
         return r;
       }},
      {"vec4 x(vec3 a, vec3 b) { bvec3 c = greaterThan(a, b); bvec3 d = not(notEqual(a, b));\n"
       "  return vec4(any(c), all(greaterThanEqual(a, b)), any(d), float(any(equal(c, d)) == "
       "true)) + vec4(lessThanEqual(a, b), 0); }",
       {{1, 2, 3, 1, 1, 1}, {1, 2, 3, 4, 5, 6}},
       [](const Floats& v) {
         bool any_more = false, all_not_less = true, any_same = false, alike = false;
         Floats r(4);
         for (size_t i = 0; i < 3; ++i) {
           float a = v[i], b = v[i + 3];
           any_more = any_more || a > b;
           all_not_less = all_not_less && a >= b;
           any_same = any_same || a == b;
           alike = alike || (a > b) == (a == b);
           r[i] = a <= b ? 1.0f : 0.0f;
         }
         r[0] += any_more;
         r[1] += all_not_less;
         r[2] += any_same;
         r[3] += alike;
         return r;
       }},
      {"float x(float a) { return uintBitsToFloat(floatBitsToUint(a) ^ 0x80000000u) + "
       "intBitsToFloat(floatBitsToInt(a)) * 3.0; }",
       {{1.5f}},
       [](const Floats& v) { return One(2 * v[0]); }},
      {"vec3 x(vec3 i, vec3 n, float eta) { return refract(i, n, eta) + 10.0 * faceforward(n, i, "
       "n) + reflect(i, n) * 0.0; }",
       {{0.6f, -0.8f, 0, 0, 1, 0, 0.5f}, {0.6f, -0.8f, 0, 0, 1, 0, 3}, {0.6f, 0.8f, 0, 0, 1, 0, 1}},
       [](const Floats& v) {
         float d = v[0] * v[3] + v[1] * v[4] + v[2] * v[5], eta = v[6];
         float k = 1 - eta * eta * (1 - d * d);
         Floats r;
         for (size_t j = 0; j < 3; ++j) {
           float bent = k < 0 ? 0 : eta * v[j] - (eta * d + std::sqrt(k)) * v[j + 3];
           r.push_back(bent + 10 * (d < 0 ? v[j + 3] : -v[j + 3]));
         }
         return r;
       }},
      {"float x(vec3 a, vec3 b) { return dot(a, b) + length(cross(a, b)) + distance(a, b) + "
       "length(-2.0)\n"
       "  + float(isnan(a.x)) + float(isinf(a.x)) + fma(a.x, 2.0, 1.0); }",
       {{1, 2, 3, 4, 5, 6}},
       [](const Floats& v) {
         return One(32 + std::sqrt(9.0f + 36 + 9) + std::sqrt(27.0f) + 2 + 2 * v[0] + 1);
       }},
  };
  return cases;
}

TEST(BlockSemantics, ComputesWhatGlslSays) {
  for (const Case& test_case : Cases()) Check(test_case);
}

TEST(BlockSemantics, IsPlainGlsl) {
  if (std::system("glslangValidator --version > /dev/null 2>&1") != 0) {
    GTEST_SKIP() << "glslangValidator is not installed";
  }
  TemporaryFolder folder;
  std::string command = "cd " + folder.path() + " && glslangValidator -t";
  int number = 0;
  for (const Case& test_case : Cases()) {
    TestLibrary test(Files{{"x.glsl", test_case.text}});
    const Block* block = test.library.Find("x");
    ASSERT_NE(block, nullptr) << test.Report();
    std::string file = "case" + std::to_string(number++) + ".frag";
    folder.Write(file, PlainGlsl(test.library, test.sources, *block, block->overloads[0]));
    command += " " + file;
  }
  if (std::system((command + " > log 2>&1").c_str()) == 0) return;
  std::ifstream log(folder.path() + "/log");
  ADD_FAILURE() << std::string((std::istreambuf_iterator<char>(log)), {});
}

}  // namespace
}  // namespace texgraph::blocks
