// SPDX-License-Identifier: Apache-2.0
// What GLSL lacks is written with what it has, and what drivers cannot do is refused.
#include "compiler/glsl/legalize.h"

#include <string>

#include "tests/unit/glsl/shader_text.h"

namespace texgraph::glsl {
namespace {

std::string Main(std::string type, std::string body) {
  return "function main() -> (x: " + type + ") {\n" + body + "}\nmain main\n";
}

TEST(Legalize, LogicOfVectors) {
  const std::string module = "uniform v: vec2 = vec2(1.0)\nuniform w: vec2 = vec2(1.0)\n" +
                             Main("float", R"(  %1 = lt @v, @w : bvec2
  %2 = eq @v, vec2(0.5) : bvec2
  %3 = land %1, %2 : bvec2
  %4 = lor %3, %1 : bvec2
  %5 = any %4 : bool
  %6 = convert %5 : float
  return %6
)");
  EXPECT_EQ(MainBody(module), R"(  bvec2 test = lessThan(v, w);
  bvec2 test2 = equal(v, vec2(0.5));
  bvec2 flags = bvec2(test.x && test2.x, test.y && test2.y);
  out_x = float(any(bvec2(flags.x || test.x, flags.y || test.y)));
)");
  EXPECT_TRUE(IsValid(module));
}

TEST(Legalize, ChoiceByComponent) {
  const std::string module = "uniform v: vec2 = vec2(1.0)\nuniform a: ivec2 = ivec2(1)\n" +
                             Main("vec2", R"(  %1 = lt @v, vec2(0.5) : bvec2
  %2 = select %1, @a, ivec2(7, 8) : ivec2
  %3 = convert %2 : vec2
  %4 = select %1, %3, @v : vec2
  return %4
)");
  EXPECT_EQ(MainBody(module), R"(  bvec2 test = lessThan(v, vec2(0.5));
  out_x = mix(v, vec2(ivec2(test.x ? a.x : 7, test.y ? a.y : 8)), test);
)");
  EXPECT_EQ(MainBody(module, Dialect::k450), R"(  bvec2 test = lessThan(v, vec2(0.5));
  out_x = mix(v, vec2(mix(ivec2(7, 8), a, test)), test);
)");
  EXPECT_TRUE(IsValid(module));
}

// Outside its array an index is the nearest one inside; where it cannot be outside, nothing is
// added.
TEST(Legalize, IndexesStayInside) {
  auto indexed = [](std::string lines, std::string index) {
    std::string body =
        MainBody("uniform i: int = 1\nuniform u: uint = 1u\nuniform v: vec4 = vec4(1.0)\n" +
                 Main("float", lines + "  %9 = index @v, " + index + " : float\n  return %9\n"));
    return body.substr(10, body.size() - 12);
  };
  EXPECT_EQ(indexed("", "@i"), "v[clamp(i, 0, 3)]");
  EXPECT_EQ(indexed("", "@u"), "v[min(u, 3u)]");
  EXPECT_EQ(indexed("", "3"), "v[3]");
  EXPECT_EQ(indexed("", "4"), "v[clamp(4, 0, 3)]");
  EXPECT_EQ(indexed("  %1 = and @i, 3 : int\n", "%1"), "v[i & 3]");
  EXPECT_EQ(indexed("  %1 = and @i, 7 : int\n", "%1"), "v[clamp(i & 7, 0, 3)]");
  EXPECT_EQ(indexed("  %1 = mod @u, 4u : uint\n", "%1"), "v[u % 4u]");
  // The remainder of a negative number is negative.
  EXPECT_EQ(indexed("  %1 = mod @i, 4 : int\n", "%1"), "v[clamp(i % 4, 0, 3)]");
  EXPECT_EQ(indexed("  %1 = clamp @i, 1, 3 : int\n", "%1"), "v[clamp(i, 1, 3)]");
  EXPECT_EQ(indexed("  %1 = clamp @i, 3, 0 : int\n", "%1"), "v[clamp(clamp(i, 3, 0), 0, 3)]");
  // A row of two, and a place in it from the upper bits.
  const std::string place = "  %1 = shr @u, 31u : uint\n  %2 = convert %1 : int\n";
  const std::string row = "  %3 = clamp @i, 0, 1 : int\n  %4 = mul %3, 2 : int\n";
  EXPECT_EQ(indexed(place + row + "  %5 = add %4, %2 : int\n", "%5"),
            "v[clamp(i, 0, 1) * 2 + int(u >> 31u)]");
  EXPECT_EQ(indexed(row + "  %5 = add %4, 2 : int\n", "%5"),
            "v[clamp(clamp(i, 0, 1) * 2 + 2, 0, 3)]");
  EXPECT_EQ(indexed("  %1 = add @i, 1 : int\n  %2 = and %1, -1 : int\n", "%2"),
            "v[clamp((i + 1) & -1, 0, 3)]")
      << "the sum may wrap";
  EXPECT_EQ(indexed("  %1 = shr @i, 30 : int\n", "%1"), "v[clamp(i >> 30, 0, 3)]");
}

TEST(Legalize, IndexesOfLoops) {
  const std::string module = "uniform v: vec4 = vec4(1.0)\n" + Main("float", R"(
  %1 = for %i = 0 to 4 step 1 (%a = 0.0) : float {
    %2 = index @v, %i : float
    %3 = add %a, %2 : float
    yield %3
  }
  %4 = for %j = 3 to -2 step -1 (%b = %1) : float {
    %5 = index @v, %j : float
    %6 = add %b, %5 : float
    yield %6
  }
  return %4
)");
  EXPECT_EQ(MainBody(module), R"(  float a = 0.0;
  for (int i = 0; i < 4; ++i) {
    a += v[i];
  }
  for (int j = 3; j > -2; --j) {
    a += v[clamp(j, 0, 3)];
  }
  out_x = a;
)");
  EXPECT_TRUE(IsValid(module));
}

// Only main names inputs, so that it can become a function.
TEST(Legalize, InputsBecomeParameters) {
  const std::string module = R"(input uv: vec2
input normal: vec3
function f(%x: float) -> float {
  %1 = extract.0 @uv : float
  %2 = mul %1, %x : float
  return %2
}
function g(%uv: vec2) -> (float, more: float) {
  %1 = call f(2.0) : float
  %2 = extract.2 @normal : float
  %3 = extract.1 %uv : float
  %4 = mul %2, %3 : float
  return %1, %4
}
function main() -> (x: float) {
  %1 = call g(vec2(0.5)) : (float, float)
  %2 = extract.0 %1 : float
  %3 = extract.1 %1 : float
  %4 = add %2, %3 : float
  return %4
}
main main
)";
  EXPECT_EQ(Functions(module), R"(float f(float x, vec2 uv) {
  return uv.x * x;
}

float g(vec2 uv, vec2 uv2, vec3 normal, out float more) {
  more = normal.z * uv.y;
  return f(2.0, uv2);
}

void main() {
  float more;
  float g_value = g(vec2(0.5), uv, normal, more);
  out_x = g_value + more;
}
)");
  EXPECT_TRUE(IsValid(module));
}

TEST(Legalize, OneResultIsReturned) {
  const std::string module = R"(uniform a: float = 1.0
function f(%x: float) -> (hit: float) {
  %1 = sin %x : float
  return %1
}
function main() -> (x: float) {
  %1 = call f(@a) : float
  return %1
}
main main
)";
  EXPECT_EQ(Functions(module),
            "float f(float x) {\n  return sin(x);\n}\n\nvoid main() {\n  out_x = f(a);\n}\n");
}

// --- Limits --------------------------------------------------------------------------------------

std::string Textures(int count) {
  std::string module;
  for (int i = 0; i < count; ++i) module += "texture t" + std::to_string(i) + ": sampler2D\n";
  std::string body = "  %s0 = fetch @t0, ivec2(0), 0 : vec4\n";
  for (int i = 1; i < count; ++i) {
    std::string n = std::to_string(i);
    body += "  %t" + n + " = fetch @t" + n + ", ivec2(0), 0 : vec4\n  %s" + n + " = add %s" +
            std::to_string(i - 1) + ", %t" + n + " : vec4\n";
  }
  return module + Main("vec4", body + "  return %s" + std::to_string(count - 1) + "\n");
}

TEST(Limits, Textures) {
  EXPECT_EQ(LegalizeReport(Textures(16)), "");
  EXPECT_EQ(LegalizeReport(Textures(17)),
            "warning: target-limit: the shader samples 17 textures, and OpenGL promises only 16\n");
  EXPECT_EQ(LegalizeReport(Textures(32)),
            "warning: target-limit: the shader samples 32 textures, and OpenGL promises only 16\n");
  EXPECT_EQ(LegalizeReport(Textures(33)),
            "target-limit: the shader samples 33 textures, and few drivers allow more than 32; put "
            "equal sizes into one texture with 'layers'\n");
}

// Textures that nothing samples do not count.
TEST(Limits, OnlyWhatIsUsed) {
  std::string module;
  for (int i = 0; i < 40; ++i) module += "texture t" + std::to_string(i) + ": sampler2D\n";
  EXPECT_EQ(
      LegalizeReport(module + Main("vec4", "  %1 = fetch @t7, ivec2(0), 0 : vec4\n  return %1\n")),
      "");
}

TEST(Limits, Outputs) {
  auto outputs = [](int count) {
    std::string results, values;
    for (int i = 0; i < count; ++i) {
      results += (i ? ", o" : "o") + std::to_string(i) + ": float";
      values += i ? ", 0.5" : "0.5";
    }
    return "function main() -> (" + results + ") {\n  return " + values + "\n}\nmain main\n";
  };
  EXPECT_EQ(LegalizeReport(outputs(8)), "");
  EXPECT_EQ(LegalizeReport(outputs(9)),
            "target-limit: the graph has 9 outputs, and a fragment shader may have 8\n");
}

TEST(Limits, Uniforms) {
  auto uniforms = [](int count) {
    std::string module, body = "  %s0 = extract.0 @m0 : vec4\n";
    for (int i = 0; i < count; ++i) {
      std::string n = std::to_string(i);
      module += "uniform m" + n + ": mat4\n";
      if (i == 0) continue;
      body += "  %c" + n + " = extract.0 @m" + n + " : vec4\n  %s" + n + " = add %s" +
              std::to_string(i - 1) + ", %c" + n + " : vec4\n";
    }
    return module + Main("vec4", body + "  return %s" + std::to_string(count - 1) + "\n");
  };
  EXPECT_EQ(LegalizeReport(uniforms(64)), "");
  EXPECT_EQ(LegalizeReport(uniforms(65)),
            "warning: target-limit: the uniform parameters have 1040 components, and OpenGL "
            "promises only 1024\n");
  EXPECT_EQ(
      LegalizeReport(uniforms(257)),
      "target-limit: the uniform parameters have 4112 components, and drivers allow 4096; make "
      "some of them constant\n");
}

// All rounds of all loops count together, as llvmpipe counts them.
TEST(Limits, Rounds) {
  auto loops = [](int outer, int inner, int calls) {
    std::string module = R"(function f as blur(%x: float) -> float {
  %1 = for %i = 0 to )" + std::to_string(outer) +
                         R"( step 1 (%a = %x) : float {
    %2 = for %j = 0 to )" +
                         std::to_string(inner) + R"( step 1 (%b = %a) : float {
      %3 = sin %b : float
      yield %3
    }
    yield %2
  }
  return %1
}
uniform u: float = 1.0
)";
    std::string body = "  %0 = sin @u : float\n";
    for (int i = 1; i <= calls; ++i) {
      body += "  %" + std::to_string(i) + " = call f(%" + std::to_string(i - 1) + ") : float\n";
    }
    return module + Main("float", body + "  return %" + std::to_string(calls) + "\n");
  };
  EXPECT_EQ(LegalizeReport(loops(255, 256, 1)), "");  // 255 + 255 * 256 = 65,535
  EXPECT_EQ(LegalizeReport(loops(256, 256, 1)),
            "loop-limit: the loops of 'blur' make 65792 rounds for one pixel, and drivers stop "
            "after 65535\n");
  EXPECT_EQ(LegalizeReport(loops(100, 100, 6)), "");
  EXPECT_EQ(LegalizeReport(loops(100, 100, 7)),
            "loop-limit: the loops of 'main' make 70700 rounds for one pixel, and drivers stop "
            "after 65535\n");
  EXPECT_EQ(
      LegalizeReport(loops(2147483647, 2147483647, 3)),
      "loop-limit: the loops of 'blur' make more than 1099511627776 rounds for one pixel, and "
      "drivers stop after 65535\n");
}

TEST(Limits, Nesting) {
  auto nest = [](int depth) {
    std::string open, ends;
    for (int i = 0; i < depth; ++i) {
      std::string n = std::to_string(i);
      open +=
          "  %c" + n + " = lt @u, " + n + ".0 : bool\n  %r" + n + " = if %c" + n + " : float {\n";
    }
    for (int i = depth; i > 0; --i) {
      std::string inner = i == depth ? "s" : "r" + std::to_string(i);
      ends += "    yield %" + inner + "\n  } else { yield 0.0 }\n";
    }
    return "uniform u: float = 1.0\n" +
           Main("float", open + "  %s = sin @u : float\n" + ends + "  return %r0\n");
  };
  EXPECT_EQ(LegalizeReport(nest(200)), "");
  EXPECT_EQ(
      LegalizeReport(nest(201)),
      "target-limit: ifs and loops nest 201 deep in 'main', and compilers of GLSL take 200\n");
  EXPECT_TRUE(IsValid(nest(200)));
}

}  // namespace
}  // namespace texgraph::glsl
