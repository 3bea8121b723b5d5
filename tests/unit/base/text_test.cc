// SPDX-License-Identifier: Apache-2.0
#include "compiler/base/text.h"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

namespace texgraph {
namespace {

// The number of significant digits of a decimal text.
size_t Digits(const std::string& text) {
  std::string digits;
  for (char c : text) {
    if (c == 'e') break;
    if (c >= '0' && c <= '9') digits += c;
  }
  digits.erase(0, digits.find_first_not_of('0'));
  while (!digits.empty() && digits.back() == '0') digits.pop_back();
  return digits.size();
}

bool HasPointOrExponent(const std::string& text) {
  return text.find_first_of(".e") != std::string::npos;
}

TEST(FloatText, KnownValues) {
  EXPECT_EQ(FloatText(1), "1.0");
  EXPECT_EQ(FloatText(0), "0.0");
  EXPECT_EQ(FloatText(-0.0f), "-0.0");
  EXPECT_EQ(FloatText(0.1f), "0.1");
  EXPECT_EQ(FloatText(-2.5f), "-2.5");
  EXPECT_EQ(FloatText(100000), "100000.0");
  EXPECT_EQ(FloatText(0.0001f), "0.0001");
  EXPECT_EQ(FloatText(16777216), "16777216.0");
  EXPECT_EQ(FloatText(1e20f), "1e20");
  EXPECT_EQ(FloatText(0.00001f), "1e-5");
  EXPECT_EQ(FloatText(std::numeric_limits<float>::denorm_min()), "1e-45");
  EXPECT_EQ(FloatText(std::numeric_limits<float>::max()), "3.4028235e38");
}

TEST(FloatText, ReadsBackExactlyAndIsShortest) {
  std::mt19937 random(1);
  for (int i = 0; i < 200000; ++i) {
    float value = std::bit_cast<float>(static_cast<uint32_t>(random()));
    if (!std::isfinite(value)) continue;
    std::string text = FloatText(value);
    EXPECT_EQ(std::bit_cast<uint32_t>(std::strtof(text.c_str(), nullptr)),
              std::bit_cast<uint32_t>(value))
        << text;
    EXPECT_TRUE(HasPointOrExponent(text)) << text;
    if (std::fabs(value) >= 0x1p24f &&
        std::fabs(value) < 1e9f) {  // whole numbers that are written out
      char whole[64];
      std::snprintf(whole, sizeof whole, "%.1f", static_cast<double>(value));
      EXPECT_EQ(text, whole);
      continue;
    }
    // No text of fewer digits reads back: the least precision of printf that does is the reference.
    int precision = 1;
    char shortest[64];
    do {
      std::snprintf(shortest, sizeof shortest, "%.*e", precision - 1, static_cast<double>(value));
    } while (std::strtof(shortest, nullptr) != value && ++precision < 10);
    EXPECT_LE(Digits(text), static_cast<size_t>(precision)) << text;
  }
}

TEST(DoubleText, ReadsBackExactly) {
  EXPECT_EQ(DoubleText(0.1), "0.1");
  EXPECT_EQ(DoubleText(3), "3.0");
  EXPECT_EQ(DoubleText(1e300), "1e300");
  EXPECT_EQ(DoubleText(5e-324), "5e-324");
  std::mt19937_64 random(1);
  for (int i = 0; i < 100000; ++i) {
    double value = std::bit_cast<double>(static_cast<uint64_t>(random()));
    if (!std::isfinite(value)) continue;
    std::string text = DoubleText(value);
    EXPECT_EQ(std::strtod(text.c_str(), nullptr), value) << text;
    EXPECT_TRUE(HasPointOrExponent(text)) << text;
  }
}

TEST(FloatText, DependsOnNoLocale) {
  const char* old = std::setlocale(LC_ALL, nullptr);
  std::string saved = old ? old : "C";
  for (const char* name : {"de_DE.UTF-8", "tr_TR.UTF-8", "C.UTF-8"}) {
    std::setlocale(LC_ALL, name);  // where it is installed
    EXPECT_EQ(FloatText(1.5f), "1.5");
    EXPECT_EQ(DoubleText(1234567.5), "1234567.5");
  }
  std::setlocale(LC_ALL, saved.c_str());
}

TEST(IsIdentifier, LettersDigitsUnderscores) {
  for (const char* good : {"a", "_", "A9_", "brick_wall", "x0"})
    EXPECT_TRUE(IsIdentifier(good)) << good;
  for (const char* bad :
       {"", "1abc", "a b", "a-b", "a.b", "\xc3\xa9", "a\n", "a;", "ab\xff", " a"}) {
    EXPECT_FALSE(IsIdentifier(bad)) << bad;
  }
  EXPECT_FALSE(IsIdentifier(std::string_view("a\0b", 3)));
}

TEST(IsReservedInGlsl, WordsOfEveryDialect) {
  for (const char* word : {"main",
                           "uniform",
                           "in",
                           "out",
                           "inout",
                           "highp",
                           "precision",
                           "varying",
                           "attribute",
                           "texture",
                           "texture2D",
                           "sampler2D",
                           "isamplerCubeArray",
                           "usampler2DMSArray",
                           "sampler2DArrayShadow",
                           "image2DMSArray",
                           "subpassInput",
                           "samplerShadow",
                           "atomic_uint",
                           "dmat4x3",
                           "mat2x3",
                           "hvec4",
                           "fvec2",
                           "common",
                           "partition",
                           "active",
                           "asm",
                           "class",
                           "input",
                           "output",
                           "filter",
                           "sizeof",
                           "cast",
                           "using",
                           "row_major",
                           "packed",
                           "resource",
                           "goto",
                           "superp",
                           "half",
                           "fixed",
                           "unsigned",
                           "patch",
                           "sample",
                           "subroutine",
                           "precise",
                           "dFdxFine",
                           "textureQueryLod",
                           "imulExtended",
                           "bitfieldExtract",
                           "unpackHalf2x16",
                           "interpolateAtOffset",
                           "EmitVertex",
                           "mix",
                           "fract",
                           "smoothstep",
                           "true",
                           "false",
                           "gl_FragColor",
                           "gl_anything",
                           "GL_ES",
                           "a__b",
                           "__",
                           "ftransform",
                           "noise3",
                           "allInvocationsEqual",
                           "textureGatherOffsets",
                           "shadow2DProjLod",
                           "abs",
                           "writeonly",
                           "while",
                           "void"}) {
    EXPECT_TRUE(IsReservedInGlsl(word)) << word;
  }
  for (const char* word :
       {"brick", "Main", "mains", "mai", "color", "uv", "gl", "glare", "_", "a_b", "Texture",
        "noise", "noise5", "vec5", "", "zzz", "A", "tile", "face"}) {
    EXPECT_FALSE(IsReservedInGlsl(word)) << word;
  }
}

TEST(DecodeUtf8, AcceptsAndRefusesAsUnicodeSays) {
  auto decode = [](std::string_view text) { return DecodeUtf8(text, 0); };
  EXPECT_EQ(decode("a").value, 'a');
  EXPECT_EQ(decode("\xc3\xa9").value, 0xe9u);
  EXPECT_EQ(decode("\xe2\x82\xac").value, 0x20acu);
  EXPECT_EQ(decode("\xf0\x9f\x98\x80").value, 0x1f600u);
  EXPECT_EQ(decode("\xf0\x9f\x98\x80").length, 4u);
  EXPECT_EQ(decode("\xf4\x8f\xbf\xbf").value, 0x10ffffu);
  // Overlong, surrogate, too large, cut short, lone continuation.
  for (std::string_view bad :
       {"\xc0\xaf", "\xc1\xbf", "\xe0\x80\xaf", "\xf0\x80\x80\x80", "\xed\xa0\x80", "\xed\xbf\xbf",
        "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xff", "\xfe", "\xc3", "\xe2\x82", "\xf0\x9f\x98",
        "\x80",
        "\xc3"
        "a",
        "\xe2\x28\xa1"}) {
    EXPECT_EQ(decode(bad).length, 0u);
  }
}

TEST(JsonQuoted, ReadsBackThroughAnotherReader) {
  std::string all;
  for (int c = 0; c < 128; ++c) all += static_cast<char>(c);
  all += "\xc3\xa9\xe2\x80\xae\xf0\x9f\x98\x80";
  EXPECT_EQ(nlohmann::json::parse(JsonQuoted(all)).get<std::string>(), all);
  EXPECT_EQ(JsonQuoted("a\"b\\\n"), "\"a\\\"b\\\\\\n\"");
  EXPECT_EQ(nlohmann::json::parse(JsonQuoted("a\xff"
                                             "b\xc3"))
                .get<std::string>(),
            "a\xef\xbf\xbd"
            "b\xef\xbf\xbd");
}

}  // namespace
}  // namespace texgraph
