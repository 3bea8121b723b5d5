// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/tile_cut.h"

#include <bit>
#include <utility>

#include "compiler/textures/min_cut.h"

namespace texgraph::textures {
namespace {

// Borders that cost nothing else are short, too.
constexpr int64_t kBorder = 1;
constexpr uint32_t kMaxLabels = 8;
constexpr uint32_t kMaxMoves = 32;

constexpr uint32_t kNone = ~0u;

// One move: every texel keeps its label or takes `alpha`.
class Expansion {
 public:
  Expansion(TileCut& cut, uint32_t alpha)
      : cut_(cut), alpha_(alpha), node_(cut.labels.size(), kNone) {
    for (uint32_t i = 0; i < node_.size(); ++i) {
      if (cut.labels[i] == alpha || !(cut.allowed[i] >> alpha & 1)) continue;
      node_[i] = static_cast<uint32_t>(texels_.size());
      texels_.push_back(i);
    }
  }

  // True if a label changed.
  bool Move() {
    if (texels_.empty()) return false;
    MinCut network(static_cast<uint32_t>(texels_.size()));
    for (uint32_t texel : texels_) AddBorders(texel, network);
    const std::vector<bool> moved = network.Solve();
    bool any = false;
    for (size_t i = 0; i < texels_.size(); ++i) {
      if (!moved[i]) continue;
      cut_.labels[texels_[i]] = static_cast<uint8_t>(alpha_);
      any = true;
    }
    return any;
  }

 private:
  int64_t Border(uint32_t p, uint32_t q, uint32_t a, uint32_t b) const {
    if (a == b) return 0;
    const uint32_t side = cut_.side;
    return int64_t{cut_.cost(p % side, p / side, a, b)} + cut_.cost(q % side, q / side, a, b) +
           kBorder;
  }

  void AddBorders(uint32_t p, MinCut& network) {
    const uint32_t side = cut_.side;
    const uint32_t x = p % side;
    const uint32_t y = p / side;
    if (x > 0) AddBorder(p, p - 1, network);
    if (y > 0) AddBorder(p, p - side, network);
    // Towards higher texels only those that do not come here themselves.
    if (x + 1 < side && node_[p + 1] == kNone) AddBorder(p, p + 1, network);
    if (y + 1 < side && node_[p + side] == kNone) AddBorder(p, p + side, network);
  }

  // Kolmogorov and Zabih 2004, with 1 for a texel that takes alpha: it goes to the sink's side.
  void AddBorder(uint32_t p, uint32_t q, MinCut& network) {
    const uint32_t fp = cut_.labels[p];
    const uint32_t fq = cut_.labels[q];
    const int64_t both_stay = Border(p, q, fp, fq);
    const int64_t p_moves = Border(p, q, alpha_, fq);
    if (node_[q] == kNone) return network.AddNode(node_[p], p_moves - both_stay);
    const int64_t q_moves = Border(p, q, fp, alpha_);
    network.AddNode(node_[p], p_moves - both_stay);
    network.AddNode(node_[q], -p_moves);
    network.AddPair(node_[p], node_[q], p_moves + q_moves - both_stay);
  }

  TileCut& cut_;
  uint32_t alpha_;
  std::vector<uint32_t> node_;
  std::vector<uint32_t> texels_;
};

}  // namespace

int64_t TileCut::Energy() const {
  int64_t energy = 0;
  for (uint32_t y = 0; y < side; ++y) {
    for (uint32_t x = 0; x < side; ++x) {
      const uint32_t a = labels[y * side + x];
      const auto add = [&](uint32_t to_x, uint32_t to_y) {
        if (to_x >= side || to_y >= side) return;
        const uint32_t b = labels[to_y * side + to_x];
        if (a != b) energy += int64_t{cost(x, y, a, b)} + cost(to_x, to_y, a, b) + kBorder;
      };
      add(x + 1, y);
      add(x, y + 1);
    }
  }
  return energy;
}

void TileCut::Improve() {
  uint32_t all = 0;
  for (uint8_t set : allowed) all |= std::has_single_bit(set) ? 0u : set;
  // Moves since the last that changed something: after one of each label there is no more to gain.
  int idle = 0;
  uint32_t alpha = 0;
  for (uint32_t move = 0; move < kMaxMoves && idle < std::popcount(all); ++move, ++alpha) {
    while (!(all >> alpha % kMaxLabels & 1)) ++alpha;
    idle = Expansion(*this, alpha % kMaxLabels).Move() ? 0 : idle + 1;
  }
}

}  // namespace texgraph::textures
