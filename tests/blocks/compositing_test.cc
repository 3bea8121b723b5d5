// SPDX-License-Identifier: Apache-2.0
// Blending against W3C Compositing and Blending Level 1: the modes of section 10 as they stand
// there, composited in the premultiplied form of section 9.1:
//   co = cs (1 - ab) + cb (1 - as) + as ab B(Cb, Cs),  ao = as + ab (1 - as)
// with lower case c for colours times alpha.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/blocks/blend_reference.h"
#include "tests/blocks/run_block.h"

namespace texgraph::blocks {
namespace {

using reference::BlendMode;
using reference::kBlendModes;
using reference::Rgb;

struct Pairs {
  std::vector<Vector> front, back;

  void Add(const Vector& a, const Vector& b) {
    front.push_back(a);
    back.push_back(b);
  }
};

Vector Rounded(const Vector& values) {
  Vector rounded;
  for (double value : values) {
    rounded.push_back(static_cast<float>(value));
  }
  return rounded;
}

// Colours and alphas of all kinds: both ends of the ranges and the places where formulas change,
// greys, equal colours, and 2,000 at random.
Pairs AllPairs() {
  Pairs pairs;
  for (double front_alpha : {0.0, 0.2, 0.7, 1.0}) {
    for (double back_alpha : {0.0, 0.35, 1.0}) {
      for (double front : {0.0, 0.25, 0.5, 0.6, 1.0}) {
        for (double back : {0.0, 0.25, 0.5, 0.75, 1.0}) {
          pairs.Add({front, 1 - front, 0.5, front_alpha}, {back, 0.125, back, back_alpha});
          pairs.Add({front, front, front, front_alpha}, {back, 1, 0, back_alpha});
          pairs.Add({front, 0, 1, front_alpha}, {back, back, back, back_alpha});
        }
      }
    }
  }
  std::mt19937 bits(7);
  std::uniform_real_distribution<double> unit(0, 1);
  auto color = [&] { return Rounded({unit(bits), unit(bits), unit(bits), unit(bits)}); };
  for (int i = 0; i < 2000; ++i) {
    Vector front = color();
    pairs.Add(front, color());
  }
  for (size_t i = 0; i < pairs.front.size(); ++i) {
    pairs.front[i] = Rounded(pairs.front[i]);
    pairs.back[i] = Rounded(pairs.back[i]);
  }
  return pairs;
}

std::vector<Vector> Premultiplied(const std::vector<Vector>& colors) {
  std::vector<Vector> result;
  for (const Vector& c : colors) {
    result.push_back(Rounded({c[0] * c[3], c[1] * c[3], c[2] * c[3], c[3]}));
  }
  return result;
}

void ExpectComposite(const Values& seen, const Pairs& pairs, double factor, const BlendMode& mode,
                     bool premultiplied, const char* what) {
  for (size_t i = 0; i < pairs.front.size(); ++i) {
    const Vector &front = pairs.front[i], &back = pairs.back[i];
    double as = front[3] * factor, ab = back[3];
    double alpha = as + ab * (1 - as);
    ASSERT_NEAR(seen.Float(i, 3), alpha, 1e-6) << what;
    Rgb blended = mode({back[0], back[1], back[2]}, {front[0], front[1], front[2]});
    for (size_t c = 0; c < 3; ++c) {
      double wanted = as * front[c] * (1 - ab) + ab * back[c] * (1 - as) + as * ab * blended[c];
      ASSERT_NEAR(seen.Float(i, c) * (premultiplied ? 1 : alpha), wanted, 3e-6)
          << what << ", component " << c << ": " << front[0] << " " << front[1] << " " << front[2]
          << " (" << as << ") on " << back[0] << " " << back[1] << " " << back[2] << " (" << ab
          << ")";
    }
  }
}

Values Blend(const std::vector<Vector>& front, const std::vector<Vector>& back,
             const std::string& mode, bool premultiplied = false) {
  auto outputs = RunBlock("blend", {{"foreground", Vectors(front)},
                                    {"background", Vectors(back)},
                                    {"mode", Word{mode}},
                                    {"alpha", Word{premultiplied ? "premultiplied" : "straight"}}});
  EXPECT_EQ(outputs.size(), 1u) << mode;
  return outputs.empty() ? Values{} : outputs["result"];
}

TEST(BlendTest, EveryModeIsTheStandards) {
  Pairs pairs = AllPairs();
  for (const auto& [word, mode] : kBlendModes) {
    Values seen = Blend(pairs.front, pairs.back, word);
    ASSERT_EQ(seen.count, pairs.front.size());
    ExpectComposite(seen, pairs, 1, mode, false, word);
  }
}

TEST(BlendTest, EveryModeIsTheStandardsWithPremultipliedAlpha) {
  Pairs pairs = AllPairs();
  for (const auto& [word, mode] : kBlendModes) {
    Values seen = Blend(Premultiplied(pairs.front), Premultiplied(pairs.back), word, true);
    ASSERT_EQ(seen.count, pairs.front.size());
    ExpectComposite(seen, pairs, 1, mode, true, word);
  }
}

TEST(BlendTest, OpacityAndMaskAreFactorsOfAlpha) {
  Pairs pairs = AllPairs();
  for (bool premultiplied : {false, true}) {
    auto form = [&](const std::vector<Vector>& colors) {
      return Vectors(premultiplied ? Premultiplied(colors) : colors);
    };
    auto outputs =
        RunBlock("blend", {{"foreground", form(pairs.front)},
                           {"background", form(pairs.back)},
                           {"mode", Word{"multiply"}},
                           {"opacity", Floats({0.5})},
                           {"mask", Floats({0.4})},
                           {"alpha", Word{premultiplied ? "premultiplied" : "straight"}}});
    ASSERT_EQ(outputs.size(), 1u);
    ExpectComposite(outputs["result"], pairs, 0.2, reference::FindBlendMode("multiply"),
                    premultiplied, "multiply");
  }
}

// Every value that may come, and those that had better not: light without alpha among premultiplied
// colours, HDR light up to the largest half, and numbers next to nothing.
TEST(BlendTest, IsFiniteEverywhere) {
  Pairs pairs;
  const double values[] = {0, 1e-38, 1e-30, 1e-8, 0.5, 1 - 6e-8, 1, 1.0000001, 2, 1000, 65504};
  for (double a : values) {
    for (double b : values) {
      for (double alpha : {0.0, 1e-38, 1e-25, 1e-7, 0.5, 1.0}) {
        for (double other : {0.0, 1e-30, 1.0}) {
          pairs.Add({a, 0, 1, alpha}, {b, b, b, other});
          pairs.Add({a, a, a, other}, {b, 1, 0, alpha});
          pairs.Add({a, b, a, alpha}, {b, a, 0.5, alpha});
        }
      }
    }
  }
  for (const auto& [word, mode] : kBlendModes) {
    for (bool premultiplied : {false, true}) {
      Values seen = Blend(pairs.front, pairs.back, word, premultiplied);
      ASSERT_EQ(seen.count, pairs.front.size());
      for (size_t i = 0; i < 4 * seen.count; ++i) {
        size_t at = i / 4;
        ASSERT_TRUE(std::isfinite(seen.Float(at, i % 4)))
            << word << (premultiplied ? " premultiplied: " : " straight: ") << pairs.front[at][0]
            << " (" << pairs.front[at][3] << ") on " << pairs.back[at][0] << " ("
            << pairs.back[at][3] << ")";
      }
    }
  }
}

TEST(BlendTest, StaysFromZeroToOne) {
  Pairs pairs = AllPairs();
  for (const auto& [word, mode] : kBlendModes) {
    Values seen = Blend(pairs.front, pairs.back, word);
    double most = std::string(word) == "add" ? 2 : 1;
    for (size_t i = 0; i < 4 * seen.count; ++i) {
      ASSERT_GE(seen.Float(i / 4, i % 4), -1e-6) << word;
      ASSERT_LE(seen.Float(i / 4, i % 4), most + 1e-6) << word;
    }
  }
}

// An opaque background stays as it is under a foreground of one grey, which differs by mode. Those
// of the quotients also keep light above 1.
TEST(BlendTest, HasNeutralColours) {
  struct Neutral {
    const char* mode;
    double grey;
    double brightest;
  };
  for (auto [mode, grey, brightest] :
       {Neutral{"add", 0, 4},   {"subtract", 0, 4},      {"multiply", 1, 4},
        {"screen", 0, 4},       {"overlay", 0.5, 4},     {"soft_light", 0.5, 4},
        {"hard_light", 0.5, 4}, {"darken", 4, 4},        {"lighten", 0, 4},
        {"difference", 0, 4},   {"exclusion", 0, 4},     {"color_dodge", 0, 4},
        {"color_burn", 1, 4},   {"linear_burn", 1, 4},   {"linear_light", 0.5, 4},
        {"pin_light", 0.5, 4},  {"vivid_light", 0.5, 4}, {"lighter_color", 0, 4},
        {"darker_color", 4, 4}, {"divide", 1, 4}}) {
    Pairs pairs;
    for (double part : {0.0, 0.1, 0.25, 0.3, 0.8, 1.0}) {
      pairs.Add({grey, grey, grey, 1}, {part, part * part, part * brightest, 1});
    }
    Values seen = Blend(pairs.front, pairs.back, mode);
    for (size_t i = 0; i < pairs.front.size(); ++i) {
      for (size_t c = 0; c < 4; ++c) {
        EXPECT_NEAR(seen.Float(i, c), pairs.back[i][c], 1e-6) << mode;
      }
    }
  }
}

// One quad at a time: where all its pixels are alike it is 0 or 1, and where the sum passes 1 the
// pixel has its share.
TEST(BlendTest, HardMixIsAntialiased) {
  std::vector<Vector> front, back;
  for (double x : {0.3, 0.3, 0.3, 0.3, 0.5, 0.54, 0.5, 0.54}) {
    front.push_back({x, 0.9, 0.71, 1});
    back.push_back({0.49, 0.2, 0.2, 1});
  }
  auto outputs = RunBlock(
      "blend",
      {{"foreground", Vectors(front)}, {"background", Vectors(back)}, {"mode", Word{"hard_mix"}}});
  ASSERT_EQ(outputs.size(), 1u);
  const Values& seen = outputs["result"];
  const double kWanted[] = {0, 1, 0};
  for (size_t c = 0; c < 3; ++c) EXPECT_EQ(seen.Float(0, c), static_cast<float>(kWanted[c]));
  EXPECT_NEAR(seen.Float(4, 0), 0.25, 1e-5);
  EXPECT_NEAR(seen.Float(5, 0), 1, 1e-5);
}

// A colour has its own hue, saturation and luminosity, and black has no light to take a hue from.
TEST(BlendTest, HueModesOfAColourWithItselfChangeNothing) {
  Pairs pairs = AllPairs();
  for (Vector& color : pairs.back) {
    color[3] = 1;
  }
  for (const char* mode : {"hue", "saturation", "color", "luminosity"}) {
    Values seen = Blend(pairs.back, pairs.back, mode);
    for (size_t i = 0; i < 3 * seen.count; ++i) {
      ASSERT_NEAR(seen.Float(i / 3, i % 3), pairs.back[i / 3][i % 3], 1e-5) << mode;
    }
  }
}

// With light above 1 the luminosity still is that of its giver, and nothing is brighter than the
// giver's brightest component, nor darker than black.
TEST(BlendTest, HueModesKeepLightAboveOne) {
  Pairs pairs;
  std::mt19937 bits(3);
  std::uniform_real_distribution<double> light(0, 8);
  auto color = [&] { return Rounded({light(bits), light(bits), light(bits), 1}); };
  for (int i = 0; i < 500; ++i) {
    Vector front = color();
    pairs.Add(front, color());
  }
  for (std::string mode : {"hue", "saturation", "color", "luminosity"}) {
    Values seen = Blend(pairs.front, pairs.back, mode);
    for (size_t i = 0; i < seen.count; ++i) {
      const Vector& giver = mode == "luminosity" ? pairs.front[i] : pairs.back[i];
      Rgb result = {seen.Float(i, 0), seen.Float(i, 1), seen.Float(i, 2)};
      EXPECT_NEAR(reference::Lum(result), reference::Lum({giver[0], giver[1], giver[2]}), 1e-5);
      double brightest = std::max({1.0, giver[0], giver[1], giver[2]});
      EXPECT_GE(reference::Min(result), -1e-5) << mode;
      EXPECT_LE(reference::Max(result), brightest + 1e-5) << mode;
    }
  }
}

TEST(OverTest, IsPorterAndDuffs) {
  Pairs pairs = AllPairs();
  auto outputs =
      RunBlock("over", {{"foreground", Vectors(pairs.front)}, {"background", Vectors(pairs.back)}});
  ASSERT_EQ(outputs.size(), 1u);
  ExpectComposite(outputs["result"], pairs, 1, reference::FindBlendMode("mix"), false, "over");
}

TEST(BlendTest, ColourSurvivesWhereBothAreTransparent) {
  auto outputs = RunBlock("over", {{"foreground", Vectors({{0.3, 0.4, 0.5, 0}})},
                                   {"background", Vectors({{0.6, 0.7, 0.8, 0}})}});
  ASSERT_EQ(outputs.size(), 1u);
  EXPECT_EQ(outputs["result"].Float(0, 3), 0.0f);
  for (size_t c = 0; c < 3; ++c) {
    EXPECT_TRUE(std::isfinite(outputs["result"].Float(0, c)));
  }
}

}  // namespace
}  // namespace texgraph::blocks
