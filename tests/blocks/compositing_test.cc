// SPDX-License-Identifier: Apache-2.0
// Blending against W3C Compositing and Blending Level 1 in its premultiplied form, section 9.1:
//   co = cs (1 - ab) + cb (1 - as) + as ab B(Cb, Cs),  ao = as + ab (1 - as)
// with lower case c for colours times alpha.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/blocks/run_block.h"

namespace texgraph::blocks {
namespace {

using Mode = std::function<double(double back, double front)>;

double HardLight(double back, double front) {
  return front <= 0.5 ? back * 2 * front : back + (2 * front - 1) - back * (2 * front - 1);
}

const std::pair<const char*, Mode> kModes[] = {
    {"mix", [](double, double front) { return front; }},
    {"add", [](double back, double front) { return back + front; }},
    {"subtract", [](double back, double front) { return std::fmax(0, back - front); }},
    {"multiply", [](double back, double front) { return back * front; }},
    {"screen", [](double back, double front) { return back + front - back * front; }},
    {"overlay", [](double back, double front) { return HardLight(front, back); }},
    {"darken", [](double back, double front) { return std::fmin(back, front); }},
    {"lighten", [](double back, double front) { return std::fmax(back, front); }},
    {"difference", [](double back, double front) { return std::fabs(back - front); }},
};

struct Pairs {
  std::vector<Vector> front, back;
};

// Colours and alphas of all kinds, both ends of the ranges among them.
Pairs AllPairs() {
  Pairs pairs;
  for (double front_alpha : {0.0, 0.2, 0.7, 1.0}) {
    for (double back_alpha : {0.0, 0.35, 1.0}) {
      for (double front : {0.0, 0.3, 0.6, 1.0}) {
        for (double back : {0.0, 0.25, 0.75, 1.0}) {
          pairs.front.push_back({front, 1 - front, 0.5, front_alpha});
          pairs.back.push_back({back, 0.1, back, back_alpha});
        }
      }
    }
  }
  return pairs;
}

void ExpectComposite(const Values& seen, const Pairs& pairs, double factor, const Mode& mode,
                     const char* what) {
  for (size_t i = 0; i < pairs.front.size(); ++i) {
    double as = pairs.front[i][3] * factor, ab = pairs.back[i][3];
    double alpha = as + ab * (1 - as);
    ASSERT_NEAR(seen.Float(i, 3), alpha, 1e-6) << what;
    for (size_t c = 0; c < 3; ++c) {
      double front = pairs.front[i][c], back = pairs.back[i][c];
      double wanted = as * front * (1 - ab) + ab * back * (1 - as) + as * ab * mode(back, front);
      ASSERT_NEAR(seen.Float(i, c) * alpha, wanted, 1e-6)
          << what << ": " << front << " (" << as << ") on " << back << " (" << ab << ")";
    }
  }
}

TEST(BlendTest, EveryModeIsTheStandards) {
  Pairs pairs = AllPairs();
  for (const auto& [word, mode] : kModes) {
    auto outputs = RunBlock("blend", {{"foreground", Vectors(pairs.front)},
                                      {"background", Vectors(pairs.back)},
                                      {"mode", Word{word}}});
    ASSERT_EQ(outputs.size(), 1u);
    ExpectComposite(outputs["result"], pairs, 1, mode, word);
  }
}

TEST(BlendTest, OpacityAndMaskAreFactorsOfAlpha) {
  Pairs pairs = AllPairs();
  auto outputs = RunBlock("blend", {{"foreground", Vectors(pairs.front)},
                                    {"background", Vectors(pairs.back)},
                                    {"mode", Word{"multiply"}},
                                    {"opacity", Floats({0.5})},
                                    {"mask", Floats({0.4})}});
  ASSERT_EQ(outputs.size(), 1u);
  ExpectComposite(outputs["result"], pairs, 0.2, kModes[3].second, "multiply");
}

TEST(OverTest, IsPorterAndDuffs) {
  Pairs pairs = AllPairs();
  auto outputs =
      RunBlock("over", {{"foreground", Vectors(pairs.front)}, {"background", Vectors(pairs.back)}});
  ASSERT_EQ(outputs.size(), 1u);
  ExpectComposite(outputs["result"], pairs, 1, kModes[0].second, "over");
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
