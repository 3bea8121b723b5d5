// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/tile_labels.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <utility>

#include "compiler/textures/tile_cut.h"
#include "compiler/textures/tile_patches.h"
#include "compiler/textures/tile_seams.h"

namespace texgraph::textures {
namespace {

// The whole tile is cut at the first scale at which it is no larger; finer ones move the seams by
// little.
constexpr uint32_t kCoarseSide = 64;
constexpr size_t kTriedMiddles = 4;
constexpr uint32_t kNoBorder = 4;
constexpr int64_t kBand = 4;  // texels to both sides of a seam

uint32_t SideAt(uint32_t size, uint32_t scale) { return (size + (1u << scale) - 1) >> scale; }

class TileLabeller {
 public:
  TileLabeller(const TileSample& sample, const TileTask& task)
      : sample_(sample), task_(task), patches_(task.patches) {
    if (task.kind == TileKind::kWang) CutCorners();
  }

  LabelledTile Label();
  int64_t Seams(uint32_t scale) { return WholeCut(scale).Energy(); }

 private:
  void CutCorners();
  TileCut WholeCut(uint32_t scale);
  bool IsNew(const TexelPlace& middle) const;
  std::vector<TexelPlace> BestMiddles(const TileCut& cut) const;
  void PlaceMiddle(TileCut& cut);
  TileCut Finer(const TileCut& coarse);
  void FreeBand(TileCut& cut) const;

  TileCut EmptyCut(uint32_t scale);
  // The texel of the tile that texel `at` of a scale stands for.
  uint32_t Middle(uint32_t at) const {
    return std::min(((2 * at + 1) << scale_) / 2, task_.size - 1);
  }
  // All in texels of the tile, a bit for each label.
  uint8_t Reaching(uint32_t x, uint32_t y) const;
  bool InMiddle(uint32_t x, uint32_t y) const;
  uint8_t Nearest(uint32_t x, uint32_t y) const;
  uint32_t BorderAt(uint32_t x, uint32_t y, uint32_t side) const;
  // In texels of the scale; nothing for those that are not at a border.
  bool IsFixed(uint32_t x, uint32_t y, uint32_t side, uint8_t& label) const;
  bool IsInCorner(uint32_t x, uint32_t y, uint8_t& label) const;

  const TileSample& sample_;
  const TileTask& task_;
  std::vector<TexelPlace> patches_;
  uint32_t scale_ = 0;
  // Of Wang tiles SeamAtCorner: left bottom, right bottom, left top, right top.
  std::array<std::vector<uint32_t>, 4> corners_;
};

constexpr std::array<uint8_t, 2> kLying = {0, 2};  // bottom, top
constexpr std::array<uint8_t, 2> kStanding = {3, 1};

// What is around a corner depends on the two edges that meet there alone, so that a pack of corners
// can show it.
void TileLabeller::CutCorners() {
  for (uint32_t corner = 0; corner < 4; ++corner) {
    const bool right = corner % 2 == 1;
    const bool top = corner / 2 == 1;
    const TilePair pair{sample_, 0, task_.size, patches_[kLying[top]], patches_[kStanding[right]]};
    corners_[corner] = SeamAtCorner(pair, right, top, BorderDepth(task_.size));
  }
}

uint8_t TileLabeller::Reaching(uint32_t x, uint32_t y) const {
  const uint32_t reach = TileReach(task_.size);
  const bool left = x < reach;
  const bool right = x >= task_.size - reach;
  const bool bottom = y < reach;
  const bool top = y >= task_.size - reach;
  if (task_.kind == TileKind::kWang) {
    return static_cast<uint8_t>(bottom | right << 1 | top << 2 | left << 3);
  }
  return static_cast<uint8_t>((left && bottom) | (right && bottom) << 1 | (left && top) << 2 |
                              (right && top) << 3);
}

bool TileLabeller::InMiddle(uint32_t x, uint32_t y) const {
  const uint32_t apart = std::max(task_.size / 8, 1u);
  const auto inside = [&](uint32_t at) { return at >= apart && at + apart < task_.size; };
  return inside(x) && inside(y);
}

uint8_t TileLabeller::Nearest(uint32_t x, uint32_t y) const {
  const bool right = 2 * x >= task_.size;
  const bool top = 2 * y >= task_.size;
  if (task_.kind == TileKind::kCorner) return static_cast<uint8_t>(right + 2 * top);
  const uint32_t across = std::min(x, task_.size - 1 - x);
  const uint32_t up = std::min(y, task_.size - 1 - y);
  if (up <= across) return top ? 2 : 0;
  return right ? 1 : 3;
}

// Which border the texel is near, as an index of colours; kNoBorder for most.
uint32_t TileLabeller::BorderAt(uint32_t x, uint32_t y, uint32_t side) const {
  const uint32_t depth = std::max(BorderDepth(task_.size) >> scale_, 1u);
  const uint32_t up = std::min(y, side - 1 - y);
  const uint32_t across = std::min(x, side - 1 - x);
  const uint32_t lies = 2 * y >= side ? 2 : 0;
  const uint32_t stands = 2 * x >= side ? 1 : 3;
  if (task_.kind == TileKind::kCorner) {
    if (up < depth) return lies;
    return across < depth ? stands : kNoBorder;
  }
  // Edges end at corners: beyond these the seam between two of them is free within a wedge.
  if (up == 0 || (up < depth && across > 2 * up)) return lies;
  return across < depth && up > 2 * across ? stands : kNoBorder;
}

// In texels of the tile.
bool TileLabeller::IsInCorner(uint32_t x, uint32_t y, uint8_t& label) const {
  const bool right = 2 * x >= task_.size;
  const bool top = 2 * y >= task_.size;
  const uint32_t across = right ? task_.size - 1 - x : x;
  const uint32_t up = top ? task_.size - 1 - y : y;
  const std::vector<uint32_t>& seam = corners_[right + 2 * top];
  if (up >= seam.size() || across >= seam.size()) return false;
  label = across < seam[up] ? kStanding[right] : kLying[top];
  return true;
}

bool TileLabeller::IsFixed(uint32_t x, uint32_t y, uint32_t side, uint8_t& label) const {
  const bool is_wang = task_.kind == TileKind::kWang;
  if (is_wang && IsInCorner(Middle(x), Middle(y), label)) return true;
  const uint32_t border = BorderAt(x, y, side);
  if (border == kNoBorder) return false;
  if (is_wang) {
    label = static_cast<uint8_t>(border);
    return true;
  }
  const bool stands = border % 2 == 1;
  const uint32_t along = Middle(stands ? y : x);
  const uint32_t across = Middle(stands ? x : y);
  const bool far = border == 1 || border == 2;
  // Rows of the seam: those before the border are at the far side of a tile.
  const uint32_t depth = BorderDepth(task_.size);
  const uint32_t row =
      far ? depth - std::min(task_.size - across, depth) : depth + std::min(across, depth - 1);
  const bool second = along >= task_.borders[border][row];
  constexpr uint8_t kLabels[4][2] = {{0, 1}, {1, 3}, {2, 3}, {0, 2}};
  label = kLabels[border][second ? 1 : 0];
  return true;
}

TileCut TileLabeller::EmptyCut(uint32_t scale) {
  scale_ = scale;
  TileCut cut;
  cut.side = SideAt(task_.size, scale);
  cut.labels.resize(size_t{cut.side} * cut.side);
  cut.allowed.resize(cut.labels.size());
  cut.cost = [this, scale](uint32_t x, uint32_t y, uint32_t a, uint32_t b) {
    const auto place = [&](uint32_t label) {
      const TexelPlace& patch = patches_[label];
      return TexelPlace{(patch.x >> scale) + x, (patch.y >> scale) + y};
    };
    return sample_.SeamCost(scale, place(a), place(b));
  };
  return cut;
}

TileCut TileLabeller::WholeCut(uint32_t scale) {
  TileCut cut = EmptyCut(scale);
  for (uint32_t y = 0; y < cut.side; ++y) {
    for (uint32_t x = 0; x < cut.side; ++x) {
      uint8_t& label = cut.labels[y * cut.side + x];
      uint8_t& allowed = cut.allowed[y * cut.side + x];
      if (IsFixed(x, y, cut.side, label)) {
        allowed = static_cast<uint8_t>(1u << label);
        continue;
      }
      label = Nearest(Middle(x), Middle(y));
      allowed = static_cast<uint8_t>(Reaching(Middle(x), Middle(y)) | 1u << label);
    }
  }
  cut.Improve();
  return cut;
}

// What is there anyway, or next to it, fits best of all and is nothing new.
bool TileLabeller::IsNew(const TexelPlace& middle) const {
  const int64_t least = task_.size / 4;
  const auto apart = [&](int64_t a, int64_t b, int64_t size) {
    const int64_t distance = std::abs(a - b);
    return sample_.wraps() ? std::min(distance % size, size - distance % size) : distance;
  };
  return std::ranges::none_of(task_.patches, [&](const TexelPlace& patch) {
    return apart(middle.x, patch.x, sample_.width()) < least &&
           apart(middle.y, patch.y, sample_.height()) < least;
  });
}

// Those that look most like the tile a quarter of it away from its border, all around.
std::vector<TexelPlace> TileLabeller::BestMiddles(const TileCut& cut) const {
  const uint32_t first = cut.side / 4;
  const uint32_t last = cut.side - 1 - first;
  std::vector<std::pair<int64_t, size_t>> ranks;
  for (size_t i = 0; i < task_.middles.size(); ++i) {
    if (!IsNew(task_.middles[i])) continue;
    int64_t cost = 0;
    const auto add = [&](uint32_t x, uint32_t y) {
      const TexelPlace& patch = patches_[cut.labels[size_t{y} * cut.side + x]];
      const auto place = [&](const TexelPlace& from) {
        return TexelPlace{(from.x >> scale_) + x, (from.y >> scale_) + y};
      };
      cost += sample_.Difference(scale_, place(patch), place(task_.middles[i]));
    };
    for (uint32_t at = first; at <= last; ++at) {
      add(at, first);
      add(at, last);
      add(first, at);
      add(last, at);
    }
    ranks.emplace_back(cost, i);
  }
  std::ranges::sort(ranks);
  std::vector<TexelPlace> best;
  for (size_t i = 0; i < std::min(ranks.size(), kTriedMiddles); ++i)
    best.push_back(task_.middles[ranks[i].second]);
  return best;
}

// Without it a tile would have nothing that is not in all tiles with the same colour.
void TileLabeller::PlaceMiddle(TileCut& cut) {
  const TileCut without = cut;
  const std::vector<TexelPlace> middles = BestMiddles(without);
  const uint32_t from = 3 * cut.side / 8;
  const uint32_t to = cut.side - from;
  int64_t least = 0;
  size_t best = middles.size();
  for (size_t i = 0; i < middles.size(); ++i) {
    patches_.resize(kMiddlePatch);
    patches_.push_back(middles[i]);
    TileCut with = without;
    for (uint32_t at = 0; at < with.labels.size(); ++at) {
      const uint32_t x = at % cut.side;
      const uint32_t y = at / cut.side;
      if (x >= from && x < to && y >= from && y < to) {
        with.labels[at] = kMiddlePatch;
        with.allowed[at] = 1u << kMiddlePatch;
      } else if (InMiddle(Middle(x), Middle(y)) && !std::has_single_bit(with.allowed[at])) {
        with.allowed[at] |= 1u << kMiddlePatch;
      }
    }
    with.Improve();
    const int64_t energy = with.Energy();
    if (best < middles.size() && energy >= least) continue;
    least = energy;
    best = i;
    cut = std::move(with);
  }
  if (best < middles.size()) patches_.back() = middles[best];
}

// The coarse labels, a scale finer.
TileCut TileLabeller::Finer(const TileCut& coarse) {
  TileCut cut = EmptyCut(scale_ - 1);
  for (uint32_t y = 0; y < cut.side; ++y) {
    for (uint32_t x = 0; x < cut.side; ++x) {
      uint8_t& label = cut.labels[y * cut.side + x];
      if (IsFixed(x, y, cut.side, label)) continue;
      label = coarse.labels[y / 2 * coarse.side + x / 2];
      const uint32_t reaching = Reaching(Middle(x), Middle(y)) | 1u << kMiddlePatch;
      if (!(reaching >> label & 1)) label = Nearest(Middle(x), Middle(y));
    }
  }
  return cut;
}

// Texels near a seam may have the labels that are near.
void TileLabeller::FreeBand(TileCut& cut) const {
  const int64_t side = cut.side;
  const auto spread = [&](const std::vector<uint8_t>& from, int64_t stride_x, int64_t stride_y) {
    std::vector<uint8_t> to(from.size());
    for (int64_t i = 0; i < side; ++i) {
      for (int64_t j = 0; j < side; ++j) {
        uint8_t set = 0;
        const int64_t end = std::min(j + kBand, side - 1);
        for (int64_t k = std::max<int64_t>(j - kBand, 0); k <= end; ++k)
          set |= from[static_cast<size_t>(i * stride_y + k * stride_x)];
        to[static_cast<size_t>(i * stride_y + j * stride_x)] = set;
      }
    }
    return to;
  };
  std::vector<uint8_t> sets(cut.labels.size());
  for (size_t i = 0; i < sets.size(); ++i) sets[i] = static_cast<uint8_t>(1u << cut.labels[i]);
  sets = spread(spread(sets, 1, side), side, 1);
  for (uint32_t y = 0; y < cut.side; ++y) {
    for (uint32_t x = 0; x < cut.side; ++x) {
      const size_t i = size_t{y} * cut.side + x;
      uint8_t label = cut.labels[i];
      uint32_t allowed = 0;
      if (!IsFixed(x, y, cut.side, label)) {
        allowed = Reaching(Middle(x), Middle(y));
        if (InMiddle(Middle(x), Middle(y))) allowed |= 1u << kMiddlePatch;
      }
      cut.allowed[i] = static_cast<uint8_t>((allowed & sets[i]) | 1u << label);
    }
  }
}

LabelledTile TileLabeller::Label() {
  TileCut cut = WholeCut(ScalesOfTile(task_.size) - 1);
  PlaceMiddle(cut);
  while (scale_ > 0) {
    cut = Finer(cut);
    FreeBand(cut);
    cut.Improve();
  }
  return {std::move(cut.labels), patches_};
}

}  // namespace

uint32_t ScalesOfTile(uint32_t size) {
  uint32_t scale = 0;
  while (SideAt(size, scale) > kCoarseSide) ++scale;
  return scale + 1;
}

int64_t SeamsOfTile(const TileSample& sample, const TileTask& task, uint32_t scale) {
  return TileLabeller(sample, task).Seams(scale);
}

LabelledTile LabelTile(const TileSample& sample, const TileTask& task) {
  return TileLabeller(sample, task).Label();
}

}  // namespace texgraph::textures
