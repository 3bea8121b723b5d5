// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/pattern_levels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "compiler/textures/border_ratios.h"
#include "compiler/textures/texel_chain.h"

namespace texgraph::textures {
namespace {

using ir::Texel;
using PatternLevel = ir::Texture::Level;

// What is tried: how far the means at the borders go to those of all patterns, and what is left of
// slopes there, own and common ones. In this order.
struct Strength {
  double means, own, common;
};
constexpr Strength kStrengths[] = {{1, 1, 1}, {1, 0.75, 1}, {1, 0.5, 1}, {1, 0.25, 1},
                                   {1, 0, 1}, {1, 0, 0.75}, {1, 0, 0.5}, {1, 0, 0.25}};
// In levels of so few texels, borders that are the same everywhere would be a grid to see.
constexpr uint32_t kTinySide = 4;
constexpr Strength kTinyStrengths[] = {{0, 1, 1},     {0.25, 1, 1}, {0.25, 0.5, 1}, {0.5, 1, 1},
                                       {0.5, 0.5, 1}, {0.75, 1, 1}, {0.75, 0, 1},   {1, 1, 1},
                                       {1, 0.5, 1},   {1, 0, 1},    {1, 0, 0.5}};
// Up to this size, what is inside of the patterns is mostly what is at their borders.
constexpr uint32_t kSmallSide = 16;
// How many lines of texels tell whether borders fit.
constexpr size_t kTriedLines = 128;

// Of the difference of a pattern's mean from that of all, what the level before the last loses.
// With a pixel of f tiles a side, the pattern in its middle has (1 - f/4)^2 of it in the mean, for
// f up to 1. What trilinear filtering shows of it falls from 1 to 1 - s while f goes from 1/4 to
// 1/2, and from there to 0 at f = 1, linearly in log f. The mean square of the difference, over log
// f, is least for s = 0.112.
constexpr double kMixedShare = 0.112;

bool WeighsColors(const PatternLevel& level, bool alpha_is_opacity) {
  return alpha_is_opacity &&
         std::ranges::any_of(level.texels, [](const Texel& t) { return t[3] != 1.0f; });
}

// A group of texels that belong to one another at the border: two at opposite sides, or the four
// corners. At a border the filter shows their mean (of two, for each pair of corners at one side),
// which is to be the same for all layers; the rest, texels[i] - mean = +-amplitude, is a layer's
// own. Corners have the signs + - - +: all pairs of neighbours cancel.
struct Group {
  std::array<size_t, 4> index{};  // in a layer
  size_t count = 2;

  static float Sign(size_t i) { return i == 0 || i == 3 ? 1.0f : -1.0f; }
};

std::vector<Group> GroupsOf(const PatternLevel& level) {
  const size_t w = level.width, h = level.height;
  std::vector<Group> groups;
  groups.push_back({{0, w - 1, w * (h - 1), w * h - 1}, 4});
  for (size_t x = 1; x + 1 < w; ++x) groups.push_back({{x, w * (h - 1) + x}, 2});
  for (size_t y = 1; y + 1 < h; ++y) groups.push_back({{w * y, w * y + w - 1}, 2});
  return groups;
}

// Finds the least change of one level with which its borders fit.
class EdgeMatcher {
 public:
  EdgeMatcher(PatternLevel& level, std::span<const double> shares, bool weigh)
      : level_(level),
        given_(level.texels),
        groups_(GroupsOf(level)),
        plane_(size_t{level.width} * level.height),
        changes_(plane_) {
    for (const Group& group : groups_) AddMean(group, shares, weigh);
  }

  bool BordersAreEqual() const {
    for (const Group& group : groups_) {
      for (size_t i = 0; i < group.count; ++i) {
        for (size_t layer = 1; layer < level_.depth; ++layer) {
          if (Given(layer, group, i) != Given(0, group, i)) return false;
        }
      }
    }
    return true;
  }

  // The narrowest change, and the one of these that leaves most of the slopes, for which borders
  // differ no more than what is inside; or the one that comes nearest to it.
  void Match() {
    const uint32_t side = std::min(level_.width, level_.height);
    // Inside of large levels the change is not seen; trying it needs two rings of texels alone.
    const bool is_small = side <= kSmallSide;
    AxisDifferences inside = MeasureInside(level_, !is_small);
    const std::span<const Strength> strengths =
        side <= kTinySide ? std::span<const Strength>(kTinyStrengths) : kStrengths;
    Change best{1, {1, 1, 1}};
    double least = std::numeric_limits<double>::infinity();
    for (uint32_t reach = 1; reach <= side / 2; reach *= 2) {
      for (const Strength& strength : strengths) {
        const Change change{reach, strength};
        Apply(change, is_small ? reach : 2);
        if (is_small) inside = MeasureInside(level_, false);
        const BorderRatios ratios = CompareBorders(level_, inside, kTriedLines);
        const double largest = std::max(ratios.values, ratios.slopes);
        // A wider change has to be worth it. Where nothing is the same as anything, it is the
        // smoothest.
        const bool both_infinite = std::isinf(largest) && std::isinf(least);
        if (largest < 0.99 * least || (both_infinite && reach > best.reach)) {
          least = largest;
          best = change;
        }
        if (largest <= 1.0) return Apply(change, reach);
      }
    }
    Apply(best, best.reach);
  }

 private:
  struct Change {
    uint32_t reach;  // how many texels deep it goes: 1 for the outermost ones alone
    Strength strength;
  };

  const Texel& Given(size_t layer, const Group& group, size_t i) const {
    return given_[layer * plane_ + group.index[i]];
  }

  void AddMean(const Group& group, std::span<const double> shares, bool weigh) {
    for (size_t i = 0; i < group.count; ++i) {
      std::array<double, 4> sum{};
      for (size_t layer = 0; layer < level_.depth; ++layer) {
        Texel texel = Given(layer, group, i);
        if (weigh) WeighColors({&texel, 1}, false);
        for (size_t c = 0; c < 4; ++c) sum[c] += shares[layer] * double{texel[c]};
      }
      Texel& mean = means_.emplace_back();
      for (size_t c = 0; c < 4; ++c) mean[c] = static_cast<float>(sum[c]);
      if (weigh) WeighColors({&mean, 1}, true);
      for (float& channel : mean) channel = std::clamp(channel, 0.0f, 1.0f);
    }
  }

  // Changes the texels of the first `depth` rings.
  void Apply(const Change& change, uint32_t depth) {
    const std::vector<float> across = Blend(level_.width, change.reach);
    const std::vector<float> up = Blend(level_.height, change.reach);
    for (size_t layer = 0; layer < level_.depth; ++layer) {
      const Texel* mean = means_.data();
      for (const Group& group : groups_) {
        for (size_t c = 0; c < 4; ++c) ChangeGroup(group, layer, c, mean, change.strength);
        mean += group.count;
      }
      ChangeInside(layer, across, up, std::min(depth, level_.height / 2));
    }
  }

  // On the way to the mean texels, but with another amplitude, as far as all texels stay within 0
  // to 1.
  void ChangeGroup(const Group& group, size_t layer, size_t c, const Texel* mean,
                   const Strength& strength) {
    const auto part = static_cast<float>(strength.means);
    const auto count = static_cast<float>(group.count);
    float own = 0, common = 0;  // amplitudes
    for (size_t i = 0; i < group.count; ++i) {
      own += Group::Sign(i) * Given(layer, group, i)[c] / count;
      common += Group::Sign(i) * mean[i][c] / count;
    }
    std::array<float, 4> values;
    float up = 1, down = -1;  // how far the amplitude may move
    for (size_t i = 0; i < group.count; ++i) {
      const float given = Given(layer, group, i)[c];
      values[i] = part == 1 ? mean[i][c] : given + part * (mean[i][c] - given);
      const float above = 1 - values[i], below = values[i];
      up = std::min(up, Group::Sign(i) > 0 ? above : below);
      down = std::max(down, Group::Sign(i) > 0 ? -below : -above);
    }
    const float wanted = static_cast<float>(strength.own) * (own - common) +
                         static_cast<float>(strength.common) * common;
    const float move = std::clamp(wanted - own - part * (common - own), down, up);
    for (size_t i = 0; i < group.count; ++i) {
      const float value = values[i] + Group::Sign(i) * move;
      level_.texels[layer * plane_ + group.index[i]][c] = value;
      changes_[group.index[i]][c] = value - Given(layer, group, i)[c];
    }
  }

  // How much of a change at the first of `size` texels goes to each of them; the other way round
  // for the last. What the two have in common fades as it is; what they differ in is a slope across
  // the border, which goes on to both sides as far as it fades: by 2 a texel, 1 at the first.
  static std::vector<float> Blend(uint32_t size, uint32_t reach) {
    std::vector<float> fade(size);
    for (uint32_t d = 0; d < std::min(reach, size); ++d) {
      const float t = static_cast<float>(d) / static_cast<float>(reach);
      fade[d] = 1 - t * t * (3 - 2 * t);
    }
    std::vector<float> blend(size);
    for (uint32_t d = 0; d < size; ++d) {
      const uint32_t other = size - 1 - d;
      blend[d] = (1 + static_cast<float>(d)) * fade[d] - static_cast<float>(other) * fade[other];
    }
    return blend;
  }

  // What changed at the four sides goes on inwards and fades: a Coons patch of the changes.
  void ChangeInside(size_t layer, std::span<const float> across, std::span<const float> up,
                    uint32_t depth) {
    const uint32_t w = level_.width, h = level_.height;
    for (uint32_t y = 1; y + 1 < h; ++y) {
      const bool near = std::min(y, h - 1 - y) < depth;
      const float low = up[y], high = up[h - 1 - y];
      const Texel& left = changes_[size_t{w} * y];
      const Texel& right = changes_[size_t{w} * y + w - 1];
      for (uint32_t x = 1; x + 1 < w; ++x) {
        if (!near && x == depth && w > 2 * depth) x = w - depth;
        if (x + 1 >= w) break;
        const float from_left = across[x], from_right = across[w - 1 - x];
        const Texel& bottom = changes_[x];
        const Texel& top = changes_[plane_ - w + x];
        const size_t at = layer * plane_ + size_t{w} * y + x;
        for (size_t c = 0; c < 4; ++c) {
          const float sides =
              from_left * left[c] + from_right * right[c] + low * bottom[c] + high * top[c];
          const float corners =
              low * (from_left * changes_[0][c] + from_right * changes_[w - 1][c]) +
              high * (from_left * changes_[plane_ - w][c] + from_right * changes_[plane_ - 1][c]);
          level_.texels[at][c] = std::clamp(given_[at][c] + sides - corners, 0.0f, 1.0f);
        }
      }
    }
  }

  PatternLevel& level_;
  std::vector<Texel> given_;
  std::vector<Group> groups_;
  size_t plane_;
  std::vector<Texel> means_;    // of each group's texels
  std::vector<Texel> changes_;  // of one layer: at its outermost texels
};

std::span<Texel> LayerOf(PatternLevel& level, size_t layer) {
  const size_t plane = size_t{level.width} * level.height;
  return std::span(level.texels).subspan(layer * plane, plane);
}

// The layers of each group that has more than one.
std::vector<std::vector<uint32_t>> LayersOfGroups(std::span<const uint32_t> groups) {
  std::vector<std::vector<uint32_t>> layers(groups.size());
  for (size_t i = 0; i < groups.size(); ++i) layers[groups[i]].push_back(static_cast<uint32_t>(i));
  std::erase_if(layers, [](const auto& group) { return group.size() < 2; });
  return layers;
}

PatternLevel TakeLayers(PatternLevel& level, std::span<const uint32_t> layers) {
  PatternLevel taken;
  taken.width = level.width;
  taken.height = level.height;
  taken.depth = static_cast<uint32_t>(layers.size());
  for (uint32_t layer : layers) {
    const std::span<const Texel> texels = LayerOf(level, layer);
    taken.texels.insert(taken.texels.end(), texels.begin(), texels.end());
  }
  return taken;
}

void MatchLevel(PatternLevel& level, std::span<const double> shares, bool is_base,
                bool alpha_is_opacity) {
  if (level.depth < 2) return;
  EdgeMatcher matcher(level, shares, WeighsColors(level, alpha_is_opacity));
  if (!is_base || !matcher.BordersAreEqual()) matcher.Match();
}

std::array<double, 4> MeanOf(std::span<const Texel> texels) {
  std::array<double, 4> mean{};
  for (const Texel& texel : texels) {
    for (size_t c = 0; c < 4; ++c) mean[c] += double{texel[c]};
  }
  for (double& channel : mean) channel /= static_cast<double>(texels.size());
  return mean;
}

}  // namespace

std::vector<double> LayerShares(std::span<const double> weights, size_t layers) {
  double sum = 0;
  for (double weight : weights) sum += weight;
  if (weights.size() != layers || !(sum > 0)) {
    return std::vector<double>(layers, 1.0 / static_cast<double>(layers));
  }
  std::vector<double> shares(weights.begin(), weights.end());
  for (double& share : shares) share /= sum;
  return shares;
}

void MatchEdges(ir::Texture& patterns, std::span<const double> shares, bool alpha_is_opacity,
                std::span<const uint32_t> groups) {
  for (PatternLevel& level : patterns.levels) {
    if (level.width < 2 || level.height < 2) continue;
    const bool is_base = &level == &patterns.levels[0];
    if (groups.size() != level.depth) {
      MatchLevel(level, shares, is_base, alpha_is_opacity);
      continue;
    }
    for (const std::vector<uint32_t>& layers : LayersOfGroups(groups)) {
      PatternLevel own = TakeLayers(level, layers);
      std::vector<double> own_shares;
      for (uint32_t layer : layers) own_shares.push_back(shares[layer]);
      MatchLevel(own, LayerShares(own_shares, layers.size()), is_base, alpha_is_opacity);
      for (size_t i = 0; i < layers.size(); ++i) {
        std::ranges::copy(LayerOf(own, i), LayerOf(level, layers[i]).begin());
      }
    }
  }
}

void MixCoarsestLevels(ir::Texture& patterns, std::span<const double> shares,
                       bool alpha_is_opacity) {
  const size_t count = patterns.levels.size();
  PatternLevel& last = patterns.levels.back();
  if (count < 2 || last.width != 1 || last.height != 1) return;
  const bool weigh = WeighsColors(patterns.levels[0], alpha_is_opacity);
  if (weigh) WeighColors(last.texels, false);
  std::array<double, 4> mean{};
  for (size_t layer = 0; layer < last.depth; ++layer) {
    for (size_t c = 0; c < 4; ++c) mean[c] += shares[layer] * double{last.texels[layer][c]};
  }
  for (Texel& texel : last.texels) {
    for (size_t c = 0; c < 4; ++c) texel[c] = static_cast<float>(mean[c]);
  }
  if (weigh) WeighColors(last.texels, true);
  if (count < 3) return;
  PatternLevel& before = patterns.levels[count - 2];
  if (weigh) WeighColors(before.texels, false);
  for (size_t layer = 0; layer < before.depth; ++layer) {
    const std::span<Texel> texels = LayerOf(before, layer);
    const std::array<double, 4> own = MeanOf(texels);
    for (Texel& texel : texels) {
      for (size_t c = 0; c < 4; ++c) {
        const double moved = double{texel[c]} + kMixedShare * (mean[c] - own[c]);
        texel[c] = static_cast<float>(std::clamp(moved, 0.0, 1.0));
      }
    }
  }
  if (weigh) WeighColors(before.texels, true);
}

}  // namespace texgraph::textures
