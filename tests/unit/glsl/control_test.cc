// SPDX-License-Identifier: Apache-2.0
// Ifs and loops: variables, assignments that happen at once, and what may move where.
#include <string>

#include "tests/unit/glsl/shader_text.h"

namespace texgraph::glsl {
namespace {

TEST(Control, ASwapKeepsOneOldValue) {
  const std::string module = R"(input uv: vec2
function main() -> (x: float, y: float) {
  %u = extract.0 @uv : float
  %v = extract.1 @uv : float
  %1 = for %i = 0 to 5 step 1 (%a = %u, %b = %v) : (float, float) { yield %b, %a }
  %2 = extract.0 %1 : float
  %3 = extract.1 %1 : float
  return %2, %3
}
main main
)";
  EXPECT_EQ(MainBody(module), R"(  float a = uv.x;
  float b = uv.y;
  for (int i = 0; i < 5; ++i) {
    float previous_a = a;
    a = b;
    b = previous_a;
  }
  out_x = a;
  out_y = b;
)");
  EXPECT_TRUE(IsValid(module));
}

TEST(Control, ARotationKeepsOneOldValue) {
  const std::string module = R"(input uv: vec2
function main() -> (x: float, y: float, z: float) {
  %u = extract.0 @uv : float
  %v = extract.1 @uv : float
  %1 = for %i = 0 to 5 step 1 (%a = %u, %b = %v, %c = 1.0) : (float, float, float) {
    %d = add %a, %c : float
    yield %b, %c, %d }
  %2 = extract.0 %1 : float
  %3 = extract.1 %1 : float
  %4 = extract.2 %1 : float
  return %2, %3, %4
}
main main
)";
  EXPECT_EQ(MainBody(module), R"(  float a = uv.x;
  float b = uv.y;
  float c = 1.0;
  for (int i = 0; i < 5; ++i) {
    float previous_a = a;
    a = b;
    b = c;
    c += previous_a;
  }
  out_x = a;
  out_y = b;
  out_z = c;
)");
  EXPECT_TRUE(IsValid(module));
}

TEST(Control, AValueThatLivesOnIsCopiedBeforeItIsOverwritten) {
  const std::string module = R"(input uv: vec2
function main() -> (x: float, y: float) {
  %u = extract.0 @uv : float
  %1 = for %i = 0 to 5 step 1 (%a = %u, %last = 0.0) : (float, float) {
    %a.2 = mul %a, 1.5 : float
    yield %a.2, %a }
  %2 = extract.0 %1 : float
  %3 = extract.1 %1 : float
  return %2, %3
}
main main
)";
  EXPECT_EQ(MainBody(module), R"(  float a = uv.x;
  float last = 0.0;
  for (int i = 0; i < 5; ++i) {
    last = a;
    a *= 1.5;
  }
  out_x = a;
  out_y = last;
)");
  EXPECT_TRUE(IsValid(module));
}

TEST(Control, AnUnusedResultIsStillCarried) {
  const std::string module = R"(input uv: vec2
function main() -> (x: float) {
  %u = extract.0 @uv : float
  %1 = for %i = 0 to 10 step 1 (%a = 0.0, %b = %u) : (float, float) {
    %c = add %a, %b : float
    yield %b, %c }
  %2 = extract.0 %1 : float
  return %2
}
main main
)";
  EXPECT_EQ(MainBody(module), R"(  float a = 0.0;
  float b = uv.x;
  for (int i = 0; i < 10; ++i) {
    float previous_a = a;
    a = b;
    b += previous_a;
  }
  out_x = a;
)");
  EXPECT_TRUE(IsValid(module));
}

TEST(Control, BothSidesAssign) {
  const std::string module = R"(input uv: vec2
function main() -> (x: vec3) {
  %u = extract.0 @uv : float
  %v = extract.1 @uv : float
  %1 = lt %u, %v : bool
  %2 = if %1 : (vec3, float) {
    %s = sin %u : float
    %3 = mul %s, %s : float
    %4 = splat %3 : vec3
    yield %4, %s
  } else {
    %c = cos %v : float
    %5 = construct %c, %u, %c : vec3
    yield %5, 2.0
  }
  %color = extract.0 %2 : vec3
  %k = extract.1 %2 : float
  %6 = splat %k : vec3
  %7 = mul %color, %6 : vec3
  return %7
}
main main
)";
  EXPECT_EQ(MainBody(module), R"(  vec3 color;
  float k;
  if (uv.x < uv.y) {
    k = sin(uv.x);
    color = vec3(k * k);
  } else {
    float c = cos(uv.y);
    color = vec3(c, uv.x, c);
    k = 2.0;
  }
  out_x = color * k;
)");
  EXPECT_TRUE(IsValid(module));
}

TEST(Control, ElseIf) {
  const std::string module = R"(input uv: vec2
function main() -> (x: float) {
  %u = extract.0 @uv : float
  %1 = lt %u, 0.25 : bool
  %value = if %1 : float {
    %2 = sin %u : float
    %3 = exp %2 : float
    %4 = log %3 : float
    %x = mul %4, %4 : float
    yield %x
  } else {
    %5 = lt %u, 0.5 : bool
    %6 = if %5 : float {
      %7 = cos %u : float
      %8 = mul %7, %7 : float
      yield %8
    } else {
      %9 = lt %u, 0.75 : bool
      %10 = if %9 : float {
        %y = sqrt %u : float
        %11 = mul %y, %y : float
        yield %11
      } else { yield 1.0 }
      yield %10
    }
    yield %6
  }
  %12 = mul %value, 2.0 : float
  return %12
}
main main
)";
  EXPECT_EQ(MainBody(module), R"(  float value;
  if (uv.x < 0.25) {
    float logarithm = log(exp(sin(uv.x)));
    value = logarithm * logarithm;
  } else if (uv.x < 0.5) {
    float cosine = cos(uv.x);
    value = cosine * cosine;
  } else if (uv.x < 0.75) {
    float y = sqrt(uv.x);
    value = y * y;
  } else {
    value = 1.0;
  }
  out_x = value * 2.0;
)");
  EXPECT_TRUE(IsValid(module));
}

TEST(Control, ASideWithoutWorkGivesTheFirstValue) {
  const std::string module = R"(input uv: vec2
function main() -> (x: float) {
  %u = extract.0 @uv : float
  %v = extract.1 @uv : float
  %1 = lt %u, 0.25 : bool
  %2 = if %1 : (float, float) {
    yield %v, 1.0
  } else {
    %s = sin %v : float
    %3 = mul %s, %s : float
    yield %s, %3
  }
  %a = extract.0 %2 : float
  %b = extract.1 %2 : float
  %4 = mul %a, %b : float
  %i = convert %u : int
  %5 = eq %i, 3 : bool
  %c = if %5 : float { yield %4 } else { %t = sin %4 : float %9 = mul %t, %t : float yield %9 }
  return %c
}
main main
)";
  EXPECT_EQ(MainBody(module), R"(  float a = uv.y;
  float b = 1.0;
  if (!(uv.x < 0.25)) {
    a = sin(uv.y);
    b = a * a;
  }
  float c = a * b;
  int i = int(uv.x);
  if (i != 3) {
    float t = sin(c);
    c = t * t;
  }
  out_x = c;
)");
  EXPECT_TRUE(IsValid(module));
}

// The variables of the inner loop and of the if are those of the outer loop, as a person would have
// it.
TEST(Control, NestedLoopsShareTheirVariables) {
  const std::string module = R"(texture t: sampler2D
input uv: vec2
function main() -> (x: vec4) {
  %0 = for %y = -1 to 2 step 1 (%color = vec4(0.0), %best = 0.0) : (vec4, float) {
    %1 = for %x = -1 to 2 step 1 (%color.2 = %color, %best.2 = %best) : (vec4, float) {
      %2 = convert %x : float
      %3 = convert %y : float
      %4 = construct %2, %3 : vec2
      %5 = add @uv, %4 : vec2
      %s = sample_lod @t, %5, 0.0 : vec4
      %6 = extract.3 %s : float
      %7 = lt %best.2, %6 : bool
      %8 = if %7 : (vec4, float) { 
        %9 = mix %s, %color.2, vec4(0.25) : vec4
        yield %9, %6 } else { yield %color.2, %best.2 }
      %color.3 = extract.0 %8 : vec4
      %best.3 = extract.1 %8 : float
      yield %color.3, %best.3
    }
    %color.4 = extract.0 %1 : vec4
    %best.4 = extract.1 %1 : float
    yield %color.4, %best.4
  }
  %color.5 = extract.0 %0 : vec4
  return %color.5
}
main main
)";
  EXPECT_EQ(MainBody(module), R"(  vec4 color = vec4(0.0);
  float best = 0.0;
  for (int y = -1; y < 2; ++y) {
    for (int x = -1; x < 2; ++x) {
      vec4 s = textureLod(t, uv + vec2(float(x), float(y)), 0.0);
      if (best < s.w) {
        color = mix(s, color, 0.25);
        best = s.w;
      }
    }
  }
  out_x = color;
)");
  EXPECT_TRUE(IsValid(module));
}

// An index that would wrap before the end of its loop is computed from a count of rounds.
TEST(Control, LoopHeaders) {
  const std::string module = R"(input uv: vec2
function main() -> (x: float) {
  %u = extract.0 @uv : float
  %1 = for %2 = 10 to 0 step -3 (%a = %u) : float {
    %3 = for %4 = 0 to 8 step 2 (%5 = %a) : float {
       %6 = mul %2, %4 : int
       %7 = convert %6 : float
       %8 = add %5, %7 : float
       yield %8 }
    yield %3
  }
  %9 = for %10 = 2147483640 to 2147483647 step 4 (%b = %1) : float {
    %11 = convert %10 : float
    %12 = add %b, %11 : float
    yield %12 }
  %13 = for %14 = -2147483645 to -2147483648 step -2 (%c = %9) : float {
    %16 = add %c, 1.0 : float
    yield %16 }
  return %13
}
main main
)";
  EXPECT_EQ(MainBody(module), R"(  float a = uv.x;
  for (int i = 10; i > 0; i -= 3) {
    for (int j = 0; j < 8; j += 2) {
      a += float(i * j);
    }
  }
  for (int turn = 0; turn < 2; ++turn) {
    int i = 2147483640 + turn * 4;
    a += float(i);
  }
  for (int turn = 0; turn < 2; ++turn) {
    int i = -2147483645 + turn * (-2);
    a += 1.0;
  }
  out_x = a;
)");
  EXPECT_TRUE(IsValid(module));
}

// A sine may move into the branch that alone uses it; neither implicit samples may, nor what a loop
// would do again.
TEST(Control, WhatMovesIntoABranch) {
  const std::string module = R"(texture t: sampler2D
input uv: vec2
uniform s: float = 1.0
function main() -> (x: vec4) {
  %1 = sample @t, @uv : vec4
  %2 = mul @uv, vec2(2.0) : vec2
  %3 = sample @t, %2 : vec4
  %4 = lt @s, 0.5 : bool
  %5 = sin @s : float
  %6 = exp @s : float
  %r = if %4 : vec4 {
    %7 = splat %5 : vec4
    %8 = mul %1, %7 : vec4
    %9 = mul %8, %8 : vec4
    yield %9
  } else { yield vec4(0.0) }
  %10 = select %4, %3, %r : vec4
  %11 = for %i = 0 to 3 step 1 (%a = %10) : vec4 {
    %12 = splat %6 : vec4
    %13 = mul %a, %12 : vec4
    yield %13
  }
  return %11
}
main main
)";
  EXPECT_EQ(MainBody(module), R"(  vec4 texel = texture(t, uv);
  vec4 texel2 = texture(t, uv * 2.0);
  bool test = s < 0.5;
  float growth = exp(s);
  vec4 r = vec4(0.0);
  if (test) {
    vec4 product = texel * sin(s);
    r = product * product;
  }
  vec4 a = test ? texel2 : r;
  for (int i = 0; i < 3; ++i) {
    a *= growth;
  }
  out_x = a;
)");
  EXPECT_TRUE(IsValid(module));
}

// What an if does is all that the loop does, and its condition depends on carried values alone: once
// false, always false. So the loop ends there.
std::string LoopOfAnIf(const std::string& condition, const std::string& otherwise) {
  return R"(input uv: vec2
function main() -> (x: float, y: float) {
  %u = extract.0 @uv : float
  %v = extract.1 @uv : float
  %1 = for %i = 0 to 5 step 1 (%open = %u, %sum = 0.0) : (float, float) {
    %f = convert %i : float
    %2 = lt 0.5, )" +
         condition + R"( : bool
    %3 = if %2 : (float, float) {
      %4 = sin %open : float
      %5 = mul %4, %v : float
      %6 = add %sum, %5 : float
      %7 = sub %open, %5 : float
      yield %7, %6
    } else {
      yield )" +
         otherwise + R"(
    }
    %8 = extract.0 %3 : float
    %9 = extract.1 %3 : float
    yield %8, %9
  }
  %10 = extract.0 %1 : float
  %11 = extract.1 %1 : float
  return %10, %11
}
main main
)";
}

TEST(Control, AnIfThatIsAllOfALoopEndsIt) {
  const std::string module = LoopOfAnIf("%open", "%open, %sum");
  EXPECT_EQ(MainBody(module), R"(  float open = uv.x;
  float sum = 0.0;
  for (int i = 0; i < 5 && open > 0.5; ++i) {
    float product = sin(open) * uv.y;
    open -= product;
    sum += product;
  }
  out_x = open;
  out_y = sum;
)");
  EXPECT_TRUE(IsValid(module));
}

TEST(Control, AnIfThatMayBeTrueLaterDoesNotEndItsLoop) {
  // The next round may come to another answer.
  for (const std::string& module :
       {LoopOfAnIf("%f", "%open, %sum"), LoopOfAnIf("%open", "%sum, %sum")}) {
    std::string body = MainBody(module);
    EXPECT_NE(body.find("for (int i = 0; i < 5; ++i) {"), std::string::npos) << body;
    EXPECT_NE(body.find("if ("), std::string::npos) << body;
    EXPECT_TRUE(IsValid(module));
  }
}

}  // namespace
}  // namespace texgraph::glsl
