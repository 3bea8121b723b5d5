// SPDX-License-Identifier: Apache-2.0
// Animations of patterns: every picture in its turn, whatever the rests, and no jump when they
// change.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/blocks/run_block.h"

namespace texgraph::blocks {
namespace {

// The paper's p(t), as a reference: in eighths of a picture, so that all numbers are whole.
int64_t PlaceAt(int64_t time, int64_t frames, int64_t phase, int64_t rest) {
  const int64_t period = frames + rest;
  const int64_t in_period = ((time + phase) % period + period) % period;
  return std::max<int64_t>(in_period - rest, 0);
}

constexpr int64_t kEighth = 8;

struct Case {
  int64_t frames, phase, rest, old_rest, change;  // in eighths, frames a multiple of 8
};

Values Eighths(const std::vector<int64_t>& numbers) {
  std::vector<double> values;
  for (int64_t number : numbers) values.push_back(static_cast<double>(number) / kEighth);
  return Floats(values);
}

TEST(AnimationSequenceTest, IsThePapersFormula) {
  std::vector<int64_t> times;
  for (int64_t t = -100; t < 400; ++t) times.push_back(t);
  for (int frames : {1, 2, 5, 7}) {
    for (int64_t rest : {0, 8, 11, 40}) {
      for (int64_t phase : {0, 3, 16, -24}) {
        auto outputs = RunBlock("animation_sequence", {{"time", Eighths(times)},
                                                       {"frames", Ints({frames})},
                                                       {"phase", Eighths({phase})},
                                                       {"rest", Eighths({rest})}});
        ASSERT_EQ(outputs.size(), 1u);
        for (size_t i = 0; i < times.size(); ++i) {
          ASSERT_EQ(outputs["result"].Int(i),
                    PlaceAt(times[i], kEighth * frames, phase, rest) / kEighth);
        }
      }
    }
  }
}

// What runs with the shader and is out of range: no picture that there is not.
TEST(AnimationSequenceTest, KeepsToItsPictures) {
  for (int frames : {0, -3, 1, 4}) {
    for (double rest : {-5.0, 0.0, 0.3}) {
      std::vector<double> times;
      for (int i = 0; i < 1000; ++i) times.push_back(i * 0.37 - 100);
      for (const char* block : {"animation_sequence", "animation_map"}) {
        auto outputs = RunBlock(block, {{"time", Floats(times)},
                                        {"frames", Ints({frames})},
                                        {"phase", Floats({0.1})},
                                        {"rest", Floats({rest})}});
        ASSERT_EQ(outputs.size(), 1u);
        for (size_t i = 0; i < times.size(); ++i) {
          EXPECT_GE(outputs["result"].Int(i), 0);
          EXPECT_LT(outputs["result"].Int(i), std::max(frames, 1));
        }
      }
    }
  }
}

// The pictures from 3 runs before the change to 3 runs behind it, one each eighth of a picture.
std::vector<int> Run(const Case& one, std::vector<int64_t>& times) {
  const int64_t span = 3 * (one.frames + std::max(one.rest, one.old_rest));
  times.clear();
  for (int64_t t = one.change - span; t <= one.change + span; ++t) times.push_back(t);
  auto outputs =
      RunBlock("animation_map", {{"time", Eighths(times)},
                                 {"frames", Ints({static_cast<int>(one.frames / kEighth)})},
                                 {"phase", Eighths({one.phase})},
                                 {"rest", Eighths({one.rest / 2})},
                                 {"rate", Floats({2})},
                                 {"old_rest", Eighths({2 * one.old_rest})},
                                 {"old_rate", Floats({0.5})},
                                 {"change_time", Eighths({one.change})}});
  std::vector<int> pictures;
  for (size_t i = 0; i < times.size(); ++i) pictures.push_back(outputs["result"].Int(i));
  return pictures;
}

// O18, O19. Only 0 to 0, k to k, k to k + 1 and the last to 0; each picture stays a unit of time;
// before the change it is the old rhythm, and two runs after it the new one.
void ExpectNoJump(const Case& one) {
  std::vector<int64_t> times;
  const std::vector<int> pictures = Run(one, times);
  const int last = static_cast<int>(one.frames / kEighth) - 1;
  int64_t since = times[0];
  for (size_t i = 0; i < times.size(); ++i) {
    if (times[i] < one.change) {
      ASSERT_EQ(pictures[i], PlaceAt(times[i], one.frames, one.phase, one.old_rest) / kEighth);
    }
    if (times[i] >= one.change + 2 * one.frames) {
      ASSERT_EQ(pictures[i], PlaceAt(times[i], one.frames, one.phase, one.rest) / kEighth);
    }
    if (i == 0 || pictures[i] == pictures[i - 1]) continue;
    const bool is_next = pictures[i] == pictures[i - 1] + 1;
    const bool is_end = pictures[i - 1] == last && pictures[i] == 0;
    ASSERT_TRUE(is_next || is_end)
        << one.frames << " " << one.phase << " " << one.rest << " " << one.old_rest << " "
        << one.change << ": " << pictures[i - 1] << " to " << pictures[i] << " at " << times[i];
    // The first picture stays at least as long as any.
    if (since != times[0]) {
      ASSERT_GE(times[i] - since, kEighth);
    }
    since = times[i];
  }
}

TEST(AnimationMapTest, NeverJumpsForWholeNumbers) {
  for (int64_t frames = 1; frames <= 5; ++frames) {
    for (int64_t rest = 0; rest <= 4; rest += 2) {
      for (int64_t old_rest = 0; old_rest <= 4; ++old_rest) {
        for (int64_t phase = 0; phase < frames + 2; ++phase) {
          for (int64_t change = 0; change < frames + old_rest; ++change) {
            ExpectNoJump({8 * frames, 8 * phase, 8 * rest, 8 * old_rest, 8 * change});
            if (HasFatalFailure()) return;
          }
        }
      }
    }
  }
}

TEST(AnimationMapTest, NeverJumpsForFractions) {
  std::mt19937 random(4);
  auto pick = [&](int64_t low, int64_t high) {
    return std::uniform_int_distribution<int64_t>(low, high)(random);
  };
  for (int i = 0; i < 1500; ++i) {
    ExpectNoJump({8 * pick(1, 7), pick(-60, 60), 2 * pick(0, 24), pick(0, 48), pick(-80, 80)});
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace texgraph::blocks
