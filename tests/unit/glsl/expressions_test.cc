// SPDX-License-Identifier: Apache-2.0
// How operations are spelled, where parentheses stand, and where a scalar stands for a vector. What
// is right follows from the GLSL 3.30 specification, sections 5 and 8.
#include "compiler/glsl/expressions.h"

#include <string>
#include <vector>

#include "tests/unit/glsl/shader_text.h"

namespace texgraph::glsl {
namespace {

constexpr char kGlobals[] = R"(struct Tile { cell: ivec2, local: vec2 }
uniform a: float = 1.0
uniform b: float = 2.0
uniform c: float = 3.0
uniform v: vec3 = vec3(1.0)
uniform w: vec3 = vec3(1.0)
uniform h: vec2 = vec2(1.0)
uniform f: vec4 = vec4(1.0)
uniform i: int = 1
uniform j: int = 2
uniform i2: ivec2 = ivec2(1)
uniform u: uint = 1u
uniform n: uint = 2u
uniform u3: uvec3 = uvec3(1u)
uniform p: bool = true
uniform q: bool = false
uniform p3: bvec3 = bvec3(true)
uniform q3: bvec3 = bvec3(true)
uniform m: mat3 = mat3(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)
uniform k: mat3 = mat3(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)
texture t: sampler2D
texture layers: sampler2DArray
texture volume: sampler3D
)";

struct Case {
  const char* type;  // of the result
  const char* ir;    // the lines, the last of which makes %r
  const char* glsl;
};

// The expression that main's output is set to. %r stands for a value without a name.
std::string Expression(const Case& test, Dialect dialect) {
  std::string module = std::string(kGlobals) + "function main() -> (x: " + test.type + ") {\n" +
                       test.ir + " : " + test.type + "\n return %r\n}\nmain main\n";
  for (size_t r; (r = module.find("%r")) != std::string::npos;) module.replace(r, 2, "%99");
  std::string body = MainBody(module, dialect);
  constexpr std::string_view kStart = "  out_x = ";
  if (!body.starts_with(kStart) || !body.ends_with(";\n")) return body;
  return body.substr(kStart.size(), body.size() - kStart.size() - 2);
}

// A shader that has all the expressions, for glslangValidator.
std::string AllOf(const std::vector<Case>& cases, std::string version) {
  std::string text = version + R"(
struct Tile { ivec2 cell; vec2 local; };
uniform float a, b, c; uniform vec3 v, w; uniform vec2 h; uniform vec4 f; uniform int i, j; uniform ivec2 i2;
uniform uint u, n; uniform uvec3 u3; uniform bool p, q; uniform bvec3 p3, q3; uniform mat3 m, k;
uniform sampler2D t; uniform sampler2DArray layers; uniform sampler3D volume;
out vec4 color;
void main() {
)";
  for (size_t i = 0; i < cases.size(); ++i) {
    text += std::string(cases[i].type) + " r" + std::to_string(i) + " = " + cases[i].glsl + ";\n";
  }
  return text + "color = f;\n}\n";
}

void Check(const std::vector<Case>& cases, Dialect dialect = Dialect::k330) {
  for (const Case& test : cases) EXPECT_EQ(Expression(test, dialect), test.glsl) << test.ir;
  EXPECT_EQ(
      Complaint(AllOf(cases, dialect == Dialect::k330 ? "#version 330" : "#version 450 core")), "");
}

TEST(Expressions, Operators) {
  Check({
      {"float", "%r = add @a, @b", "a + b"},   {"float", "%r = sub @a, @b", "a - b"},
      {"float", "%r = mul @a, @b", "a * b"},   {"float", "%r = div @a, @b", "a / b"},
      {"float", "%r = neg @a", "-a"},          {"int", "%r = mod @i, @j", "i % j"},
      {"int", "%r = and @i, @j", "i & j"},     {"int", "%r = or @i, @j", "i | j"},
      {"int", "%r = xor @i, @j", "i ^ j"},     {"int", "%r = not @i", "~i"},
      {"int", "%r = shl @i, 3", "i << 3"},     {"uint", "%r = shr @u, 16u", "u >> 16u"},
      {"bool", "%r = lt @a, @b", "a < b"},     {"bool", "%r = le @a, @b", "a <= b"},
      {"bool", "%r = eq @i, @j", "i == j"},    {"bool", "%r = ne @u, @n", "u != n"},
      {"bool", "%r = land @p, @q", "p && q"},  {"bool", "%r = lor @p, @q", "p || q"},
      {"bool", "%r = lxor @p, @q", "p ^^ q"},  {"bool", "%r = lnot @p", "!p"},
      {"mat3", "%r = matmul @m, @k", "m * k"}, {"vec3", "%r = matmul @m, @v", "m * v"},
      {"vec3", "%r = matmul @v, @m", "v * m"}, {"mat3", "%r = mul @m, @k", "matrixCompMult(m, k)"},
      {"mat3", "%r = add @m, @k", "m + k"},    {"mat3", "%r = div @m, @k", "m / k"},
      {"mat3", "%r = neg @m", "-m"},
  });
}

TEST(Expressions, ParenthesesOnlyWhereNeeded) {
  Check({
      {"float", "%1 = add @a, @b : float\n%r = add %1, @c", "a + b + c"},
      // Another order of additions would round otherwise.
      {"float", "%1 = add @b, @c : float\n%r = add @a, %1", "a + (b + c)"},
      {"float", "%1 = mul @b, @c : float\n%r = mul @a, %1", "a * (b * c)"},
      {"float", "%1 = sub @b, @c : float\n%r = sub @a, %1", "a - (b - c)"},
      {"float", "%1 = mul @a, @b : float\n%r = add %1, @c", "a * b + c"},
      {"float", "%1 = add @a, @b : float\n%r = mul %1, @c", "(a + b) * c"},
      {"float", "%1 = mul @b, @c : float\n%r = div @a, %1", "a / (b * c)"},
      {"float", "%1 = div @a, @b : float\n%r = div %1, @c", "a / b / c"},
      {"float", "%1 = neg @a : float\n%r = mul %1, @b", "-a * b"},
      {"float", "%1 = add @a, @b : float\n%r = neg %1", "-(a + b)"},
      {"float", "%1 = neg @a : float\n%r = neg %1", "-(-a)"},
      {"float", "%r = neg -2.0", "-(-2.0)"},
      {"int", "%1 = not @i : int\n%r = not %1", "~~i"},
      {"int", "%1 = shl @i, 2 : int\n%r = add %1, @j", "(i << 2) + j"},
      // Not needed, but nobody remembers that.
      {"int", "%1 = add @i, @j : int\n%r = shl %1, 2", "(i + j) << 2"},
      {"int", "%1 = shr @i, 3 : int\n%r = xor @j, %1", "j ^ (i >> 3)"},
      {"int", "%1 = and @i, 7 : int\n%r = or %1, @j", "(i & 7) | j"},
      {"int", "%1 = xor @i, @j : int\n%2 = xor %1, 5 : int\n%r = xor %2, @i", "i ^ j ^ 5 ^ i"},
      {"int", "%1 = xor @j, 5 : int\n%r = xor @i, %1", "i ^ j ^ 5"},
      {"bool", "%1 = and @i, 1 : int\n%r = eq %1, 0", "(i & 1) == 0"},
      {"bool", "%1 = lt @a, @b : bool\n%2 = lt @b, @c : bool\n%r = land %1, %2", "a < b && b < c"},
      {"bool", "%1 = land @p, @q : bool\n%r = lor %1, @p", "(p && q) || p"},
      {"bool", "%1 = lor @p, @q : bool\n%r = land @p, %1", "p && (p || q)"},
      {"bool", "%1 = lt @a, @b : bool\n%r = lnot %1", "!(a < b)"},
      {"bool", "%1 = lt @a, @b : bool\n%r = eq %1, @p", "a < b == p"},
      {"float", "%1 = add @v, @w : vec3\n%r = extract.1 %1", "(v + w).y"},
      {"float", "%1 = neg @v : vec3\n%r = extract.1 %1", "(-v).y"},
      {"vec3", "%1 = add @v, @w : vec3\n%r = swizzle.zyx %1", "(v + w).zyx"},
      {"float", "%1 = lt @a, @b : bool\n%2 = add @a, 1.0 : float\n%r = select %1, %2, @c",
       "a < b ? a + 1.0 : c"},
      {"float", "%1 = select @p, @a, @b : float\n%r = add %1, @c", "(p ? a : b) + c"},
      {"float", "%1 = select @p, @a, @b : float\n%r = select @q, @c, %1", "q ? c : p ? a : b"},
      {"float", "%1 = select @p, @a, @b : float\n%r = select @q, %1, @c", "q ? (p ? a : b) : c"},
      {"float", "%1 = select @p, @a, @b : float\n%r = sin %1", "sin(p ? a : b)"},
      {"bool", "%1 = select @p, @q, @p : bool\n%r = land %1, @q", "(p ? q : p) && q"},
  });
}

TEST(Expressions, Constants) {
  Check({
      {"float", "%r = mul @a, 0.1", "a * 0.1"},
      {"float", "%r = mul @a, -0.0", "a * -0.0"},
      {"float", "%r = add @a, 1e-45", "a + 1e-45"},
      {"float", "%r = add @a, 3.4028235e38", "a + 3.4028235e38"},
      {"float", "%r = add @a, 16777217.0", "a + 16777216.0"},
      {"int", "%r = mul @i, -2147483648", "i * (-2147483647 - 1)"},
      {"int", "%r = mul @i, 2147483647", "i * 2147483647"},
      {"uint", "%r = mul @u, 4294967295u", "u * 4294967295u"},
      {"vec3", "%r = cross @v, vec3(1.0)", "cross(v, vec3(1.0))"},
      {"vec3", "%r = cross @v, vec3(1.0, 2.0, -3.0)", "cross(v, vec3(1.0, 2.0, -3.0))"},
      {"vec3", "%r = select @p3, @v, vec3(0.0)", "mix(vec3(0.0), v, p3)"},
      {"mat3", "%r = matmul @m, mat3(2.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 2.0)",
       "m * mat3(2.0)"},
      {"mat3", "%r = matmul @m, mat3(1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0)",
       "m * mat3(1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0)"},
      {"Tile", "%r = select @p, Tile(ivec2(1), vec2(0.5, 1.0)), Tile(ivec2(2), vec2(0.0))",
       "p ? Tile(ivec2(1), vec2(0.5, 1.0)) : Tile(ivec2(2), vec2(0.0))"},
  });
}

// x + -y is x - y to the bit, and x - -y is x + y.
TEST(Expressions, SignsInSums) {
  Check({
      {"float", "%r = add @a, -2.0", "a - 2.0"},
      {"float", "%r = sub @a, -2.0", "a + 2.0"},
      {"vec3", "%r = add @v, vec3(-2.0)", "v - 2.0"},
      {"vec3", "%r = add @v, vec3(-2.0, 1.0, 0.0)", "v + vec3(-2.0, 1.0, 0.0)"},
      {"int", "%r = add @i, -2147483648", "i + (-2147483647 - 1)"},
      {"float", "%1 = neg @b : float\n%r = add @a, %1", "a - b"},
      {"float", "%1 = add @b, @c : float\n%2 = neg %1 : float\n%r = add @a, %2", "a - (b + c)"},
      {"float", "%1 = neg @b : float\n%r = sub @a, %1", "a - -b"},
      {"float", "%r = mul @a, -2.0", "a * -2.0"},
      {"float", "%r = add -2.0, @a", "-2.0 + a"},
  });
}

TEST(Expressions, ConstantsStandOnTheRightOfComparisons) {
  Check({
      {"bool", "%r = lt 0.5, @a", "a > 0.5"},
      {"bool", "%r = le 0.5, @a", "a >= 0.5"},
      {"bool", "%r = lt @a, 0.5", "a < 0.5"},
  });
}

TEST(Expressions, ScalarsBesideVectors) {
  Check({
      {"vec3", "%1 = splat @a : vec3\n%r = mul @v, %1", "v * a"},
      {"vec3", "%1 = splat @a : vec3\n%r = mul %1, @v", "a * v"},
      {"vec3", "%1 = splat @a : vec3\n%r = mul %1, vec3(2.0)", "vec3(a) * 2.0"},
      {"vec3", "%1 = add @a, @b : float\n%2 = splat %1 : vec3\n%r = mul @v, %2", "v * (a + b)"},
      {"vec3", "%r = sub @v, vec3(0.5)", "v - 0.5"},
      {"vec3", "%r = sub vec3(1.0), @v", "1.0 - v"},
      {"uvec3", "%r = shr @u3, uvec3(16u)", "u3 >> 16u"},
      {"uvec3", "%r = shl uvec3(1u), @u3", "uvec3(1u) << u3"},
      {"vec3", "%r = min @v, vec3(1.0)", "min(v, 1.0)"},
      {"vec3", "%r = max vec3(0.0), @v", "max(vec3(0.0), v)"},
      {"vec3", "%r = clamp @v, vec3(0.0), vec3(1.0)", "clamp(v, 0.0, 1.0)"},
      {"vec3", "%r = clamp @v, vec3(0.0), @w", "clamp(v, vec3(0.0), w)"},
      {"vec3", "%1 = splat @a : vec3\n%r = mix @v, @w, %1", "mix(v, w, a)"},
      {"vec3", "%r = mix @v, @w, @v", "mix(v, w, v)"},
      {"vec3", "%r = step vec3(0.5), @v", "step(0.5, v)"},
      {"vec3", "%r = smoothstep vec3(0.0), vec3(1.0), @v", "smoothstep(0.0, 1.0, v)"},
      {"vec3", "%r = smoothstep vec3(0.0), @w, @v", "smoothstep(vec3(0.0), w, v)"},
      {"vec3", "%r = fmod @v, vec3(2.0)", "mod(v, 2.0)"},
      {"vec3", "%r = pow @v, vec3(2.0)", "pow(v, vec3(2.0))"},
      {"vec3", "%1 = splat @a : vec3\n%r = cross @v, %1", "cross(v, vec3(a))"},
      {"bvec3", "%1 = splat @a : vec3\n%r = lt @v, %1", "lessThan(v, vec3(a))"},
      {"mat3", "%1 = splat @a : mat3\n%r = mul @m, %1", "m * a"},
      {"mat3", "%1 = splat @a : mat3\n%r = transpose %1",
       "transpose(outerProduct(vec3(a), vec3(1.0)))"},
      {"mat3", "%r = add @m, mat3(1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0)", "m + 1.0"},
      {"vec3", "%r = splat @a", "vec3(a)"},
  });
}

TEST(Expressions, Functions) {
  Check({
      {"float", "%r = abs @a", "abs(a)"},
      {"int", "%r = abs @i", "abs(i)"},
      {"float", "%r = sign @a", "sign(a)"},
      {"float", "%r = floor @a", "floor(a)"},
      {"float", "%r = ceil @a", "ceil(a)"},
      {"float", "%r = trunc @a", "trunc(a)"},
      // round() may go either way at one half.
      {"float", "%r = round @a", "roundEven(a)"},
      {"float", "%r = fract @a", "fract(a)"},
      {"float", "%r = sqrt @a", "sqrt(a)"},
      {"float", "%r = inversesqrt @a", "inversesqrt(a)"},
      {"float", "%r = exp @a", "exp(a)"},
      {"float", "%r = log @a", "log(a)"},
      {"float", "%r = exp2 @a", "exp2(a)"},
      {"float", "%r = log2 @a", "log2(a)"},
      {"float", "%r = sin @a", "sin(a)"},
      {"float", "%r = cos @a", "cos(a)"},
      {"float", "%r = tan @a", "tan(a)"},
      {"float", "%r = asin @a", "asin(a)"},
      {"float", "%r = acos @a", "acos(a)"},
      {"float", "%r = atan @a", "atan(a)"},
      {"float", "%r = atan2 @a, @b", "atan(a, b)"},
      {"float", "%r = sinh @a", "sinh(a)"},
      {"float", "%r = cosh @a", "cosh(a)"},
      {"float", "%r = tanh @a", "tanh(a)"},
      {"float", "%r = asinh @a", "asinh(a)"},
      {"float", "%r = acosh @a", "acosh(a)"},
      {"float", "%r = atanh @a", "atanh(a)"},
      {"float", "%r = dot @v, @w", "dot(v, w)"},
      {"float", "%r = length @v", "length(v)"},
      {"float", "%r = distance @v, @w", "distance(v, w)"},
      {"vec3", "%r = normalize @v", "normalize(v)"},
      {"vec3", "%r = reflect @v, @w", "reflect(v, w)"},
      {"mat3", "%r = transpose @m", "transpose(m)"},
      {"bool", "%r = any @p3", "any(p3)"},
      {"bool", "%r = all @p3", "all(p3)"},
      {"bool", "%r = all @p", "p"},
      {"bool", "%r = isnan @a", "isnan(a)"},
      {"bool", "%r = isinf @a", "isinf(a)"},
      {"bvec3", "%r = lt @v, @w", "lessThan(v, w)"},
      {"bvec3", "%r = le @v, @w", "lessThanEqual(v, w)"},
      {"bvec3", "%r = eq @v, @w", "equal(v, w)"},
      {"bvec3", "%r = ne @v, @w", "notEqual(v, w)"},
      {"bvec3", "%r = lnot @p3", "not(p3)"},
      {"bvec3", "%r = lxor @p3, @q3", "notEqual(p3, q3)"},
      {"vec4", "%r = sample_lod @t, @h, @a", "textureLod(t, h, a)"},
      {"vec4", "%r = sample_grad @t, @h, @h, vec2(0.5)", "textureGrad(t, h, h, vec2(0.5))"},
      {"vec4", "%r = sample_lod @layers, @v, 0.0", "textureLod(layers, v, 0.0)"},
      {"vec4", "%r = sample_lod @volume, @v, 0.0", "textureLod(volume, v, 0.0)"},
      {"vec4", "%r = sample @t, @h", "texture(t, h)"},
      {"vec4", "%r = sample @t, @h, -1.0", "texture(t, h, -1.0)"},
      {"vec4", "%r = fetch @t, @i2, 0", "texelFetch(t, i2, 0)"},
      {"ivec2", "%r = texture_size @t, @i", "textureSize(t, i)"},
  });
}

TEST(Expressions, Conversions) {
  Check({
      {"float", "%r = convert @i", "float(i)"},
      {"int", "%r = convert @a", "int(a)"},
      {"uint", "%r = convert @i", "uint(i)"},
      {"float", "%r = convert @p", "float(p)"},
      {"bool", "%r = convert @a", "bool(a)"},
      {"uvec3", "%r = convert @v", "uvec3(v)"},
      {"vec3", "%r = convert @p3", "vec3(p3)"},
      {"uint", "%r = bitcast @a", "floatBitsToUint(a)"},
      {"int", "%r = bitcast @a", "floatBitsToInt(a)"},
      {"float", "%r = bitcast @u", "uintBitsToFloat(u)"},
      {"float", "%r = bitcast @i", "intBitsToFloat(i)"},
      {"uint", "%r = bitcast @i", "uint(i)"},
      {"int", "%r = bitcast @u", "int(u)"},
      {"vec3", "%r = bitcast @u3", "uintBitsToFloat(u3)"},
  });
}

TEST(Expressions, PartsOfVectors) {
  Check({
      {"vec4", "%r = construct @a, @b, @c, 1.0", "vec4(a, b, c, 1.0)"},
      {"vec4",
       "%1 = extract.0 @v : float\n%2 = extract.1 @v : float\n%3 = extract.2 @v : float\n"
       "%r = construct %1, %2, %3, @a",
       "vec4(v, a)"},
      {"vec4",
       "%1 = extract.0 @f : float\n%2 = extract.1 @f : float\n%3 = extract.2 @f : float\n"
       "%r = construct %1, %2, %3, 1.0",
       "vec4(f.xyz, 1.0)"},
      {"vec4",
       "%1 = extract.2 @f : float\n%2 = extract.1 @f : float\n%3 = extract.0 @h : float\n"
       "%4 = extract.1 @h : float\n%r = construct %1, %2, %3, %4",
       "vec4(f.zy, h)"},
      {"vec3", "%1 = extract.0 @h : float\n%2 = extract.1 @v : float\n%r = construct %1, %2, %1",
       "vec3(h.x, v.y, h.x)"},
      {"vec2", "%1 = extract.1 @v : float\n%2 = extract.0 @v : float\n%r = construct %1, %2",
       "v.yx"},
      {"vec3", "%r = swizzle.xxz @v", "v.xxz"},
      {"vec3", "%1 = sample_lod @t, @h, 0.0 : vec4\n%r = swizzle.xyz %1",
       "textureLod(t, h, 0.0).xyz"},
      // The sample is there once, though three components of it are used.
      {"vec4",
       "%1 = sample_lod @t, @h, 0.0 : vec4\n%2 = extract.0 %1 : float\n%3 = extract.1 %1 : float\n"
       "%4 = extract.2 %1 : float\n%r = construct %2, %3, %4, 1.0",
       "vec4(textureLod(t, h, 0.0).xyz, 1.0)"},
      {"mat3", "%r = construct @v, @w, @v", "mat3(v, w, v)"},
      {"vec3", "%r = extract.1 @m", "m[1]"},
      {"float", "%1 = extract.1 @m : vec3\n%r = extract.2 %1", "m[1].z"},
      {"Tile", "%r = construct @i2, @h", "Tile(i2, h)"},
      {"vec2", "%r = extract.1 Tile(ivec2(1), vec2(2.0))", "Tile(ivec2(1), vec2(2.0)).local"},
      {"float", "%1 = and @i, 1 : int\n%r = index @v, %1", "v[i & 1]"},
  });
}

TEST(Expressions, OfVersion450) {
  Check({{"float", "%r = fma @a, @b, @c", "a * b + c"}});
  Check({{"float", "%r = fma @a, @b, @c", "fma(a, b, c)"},
         {"ivec2", "%1 = lt @h, vec2(0.5) : bvec2\n%r = select %1, @i2, ivec2(0)",
          "mix(ivec2(0), i2, lessThan(h, vec2(0.5)))"}},
        Dialect::k450);
}

// An expression of many operations is written in pieces.
TEST(Expressions, AreNeitherLongNorDeep) {
  std::string module =
      std::string(kGlobals) + "function main() -> (x: float) {\n %0 = sin @a : float\n";
  for (int i = 1; i <= 40; ++i) {
    module += " %" + std::to_string(i) + " = sin %" + std::to_string(i - 1) + " : float\n";
  }
  module += " return %40\n}\nmain main\n";
  std::string body = MainBody(module);
  int deepest = 0, depth = 0;
  for (char c : body) {
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    deepest = std::max(deepest, depth);
  }
  EXPECT_LE(deepest, 8);
  EXPECT_GT(deepest, 3);
  EXPECT_TRUE(IsValid(module));
}

}  // namespace
}  // namespace texgraph::glsl
