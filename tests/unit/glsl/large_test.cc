// SPDX-License-Identifier: Apache-2.0
// Functions of thousands of operations: few variables, bounded expressions, little stack.
#include <pthread.h>

#include <algorithm>
#include <functional>
#include <string>

#include "tests/unit/glsl/shader_text.h"

namespace texgraph::glsl {
namespace {

// Runs `work` on a stack of 256 kB.
void OnSmallStack(const std::function<void()>& work) {
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, 256 * 1024);
  pthread_t thread;
  auto run = [](void* argument) -> void* {
    (*static_cast<const std::function<void()>*>(argument))();
    return nullptr;
  };
  ASSERT_EQ(pthread_create(&thread, &attributes, run, const_cast<std::function<void()>*>(&work)),
            0);
  pthread_join(thread, nullptr);
  pthread_attr_destroy(&attributes);
}

// main with `count` operations, each on the result of the one before, named n0, n1, ...
std::string Chain(int count) {
  std::string module = "input uv: vec2\nuniform s: float = 0.5\nfunction main() -> (x: float) {\n";
  module += "  %x = extract.0 @uv : float\n";
  std::string last = "%x";
  for (int i = 0; i < count; ++i) {
    std::string name = "%n" + std::to_string(i);
    module += "  " + name + (i % 2 ? " = add " : " = mul ") + last + ", @s : float\n";
    last = name;
  }
  return module + "  return " + last + "\n}\nmain main\n";
}

size_t CountOf(const std::string& text, std::string_view part) {
  size_t count = 0;
  for (size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++count;
  return count;
}

// The same value computed from the printed text: x -> x * s, x + s, ..., whatever stands around it.
TEST(Large, AThousandNodesKeepTheirNames) {
  std::string body = MainBody(Chain(1000));
  EXPECT_NE(body.find("  float n0 = uv.x * s;\n  float n1 = n0 + s;\n"), std::string::npos);
  EXPECT_EQ(CountOf(body, "float "), 1000u);
}

TEST(Large, FiftyThousandOperationsNeedOneVariable) {
  std::string body;
  std::string module = Chain(50000);
  OnSmallStack([&] { body = MainBody(module); });
  EXPECT_EQ(body.substr(0, body.find('\n')), "  float value;");
  EXPECT_EQ(CountOf(body, "float "), 1u);
  EXPECT_EQ(CountOf(body, " * s") + CountOf(body, " + s"), 50000u);
  size_t longest = 0, deepest = 0, depth = 0, length = 0;
  for (char c : body) {
    length = c == '\n' ? 0 : length + 1;
    longest = std::max(longest, length);
    if (c == '(') deepest = std::max(deepest, ++depth);
    if (c == ')') --depth;
  }
  EXPECT_LE(longest, 100u);
  EXPECT_LE(deepest, 8u);
}

TEST(Large, TenThousandAreValid) { EXPECT_TRUE(IsValid(Chain(10000))); }

// Every value is used twice, so none can be written inside another; still the text grows with the
// values.
TEST(Large, ADiamondGrowsWithItsNodes) {
  auto diamond = [](int count) {
    std::string module =
        "input uv: vec2\nfunction main() -> (x: float) {\n  %0 = extract.0 @uv : float\n";
    for (int i = 1; i <= count; ++i) {
      std::string before = "%" + std::to_string(i - 1);
      module += "  %" + std::to_string(i) + " = mul " + before + ", " + before + " : float\n";
    }
    return module + "  return %" + std::to_string(count) + "\n}\nmain main\n";
  };
  size_t ten = Shader(diamond(3000)).size(), hundred = Shader(diamond(30000)).size();
  EXPECT_LT(hundred, 11 * ten);
}

// Values that live long keep their variables while others come and go.
TEST(Large, ReusedVariablesHoldWhatIsNeeded) {
  std::string module =
      "input uv: vec2\nfunction main() -> (x: float) {\n  %0 = extract.0 @uv : float\n";
  module += "  %keep = sin %0 : float\n";
  for (int i = 1; i <= 4000; ++i) {
    std::string before = "%" + std::to_string(i - 1);
    module += "  %" + std::to_string(i) + " = mul " + before + ", " + before + " : float\n";
  }
  module +=
      "  %5000 = add %4000, %keep : float\n  %5001 = mul %5000, %keep : float\n  return "
      "%5001\n}\nmain main\n";
  std::string body = MainBody(module);
  EXPECT_EQ(body.substr(0, body.find("value2 *=")), R"(  float value, value2;
  value = sin(uv.x);
  value2 = uv.x * uv.x;
  )");
  // After its definition the kept value is only read.
  EXPECT_EQ(CountOf(body, "  value = "), 1u);
  EXPECT_EQ(CountOf(body, "value2 *= value2;"), 3998u);
  EXPECT_NE(body.find("out_x = (value2 * value2 + value) * value;"), std::string::npos);
}

TEST(Large, TenThousandIfs) {
  std::string module =
      "input uv: vec2\nfunction main() -> (x: float) {\n  %x0 = extract.0 @uv : float\n";
  for (int i = 0; i < 10000; ++i) {
    std::string n = std::to_string(i);
    module += "  %c" + n + " = lt %x" + n + ", 0.5 : bool\n  %x" + std::to_string(i + 1) +
              " = if %c" + n + " : float {\n    %a" + n + " = sin %x" + n + " : float\n    %b" + n +
              " = mul %a" + n + ", %a" + n + " : float\n    yield %b" + n +
              "\n  } else { yield %x" + n + " }\n";
  }
  module += "  return %x10000\n}\nmain main\n";
  std::string body;
  OnSmallStack([&] { body = MainBody(module); });
  EXPECT_EQ(body.substr(0, body.find('\n')), "  float value, value2;");
  EXPECT_EQ(CountOf(body, "if ("), 10000u);
}

}  // namespace
}  // namespace texgraph::glsl
