// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/tile_patches.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "compiler/textures/hash.h"
#include "compiler/textures/tile_seams.h"
#include "compiler/textures/tile_shades.h"

namespace texgraph::textures {
namespace {

using Origin = std::array<int64_t, 2>;

// More starts find nothing better, as a rule.
constexpr size_t kMaxStarts = 256;
// Of two patches that are the same, as parts of what a pair costs in the mean.
constexpr double kOverlapCost = 1;
// Of a set whose grid is that of random patches, as a part of what all its seams cost in the mean.
constexpr double kGridCost = 1;
constexpr int kMaxSweeps = 8;

// Places of one kind of colour: corners, edges that lie, edges that stand.
enum class PatchKind : uint8_t { kCorner, kLies, kStands };

struct Patches {
  PatchKind kind;
  uint32_t count = 0;  // of colours
  std::vector<Origin> origins;
};

// Along an axis a patch is used from `first` to before `end`, from its left bottom texel.
struct UsedPart {
  int64_t first;
  int64_t end;
};

UsedPart UsedOf(PatchKind kind, int axis, uint32_t tile_size) {
  const int64_t size = tile_size;
  const int64_t reach = TileReach(tile_size);
  const bool along =
      (kind == PatchKind::kLies && axis == 0) || (kind == PatchKind::kStands && axis == 1);
  return along ? UsedPart{0, size} : UsedPart{size - reach, size + reach};
}

class PatchSearch {
 public:
  PatchSearch(const TileSample& sample, const TilePackLayout& layout, const TileSetOptions& options,
              uint32_t scale)
      : sample_(sample), layout_(layout), options_(options), scale_(scale) {
    if (layout.kind == TileKind::kCorner) {
      kinds_ = {{PatchKind::kCorner, layout.colors[0], {}}};
    } else {
      kinds_ = {{PatchKind::kLies, layout.colors[0], {}},
                {PatchKind::kStands, layout.colors[1], {}}};
    }
    for (size_t k = 0; k < kinds_.size(); ++k) {
      for (uint32_t i = 0; i < options.candidates; ++i)
        kinds_[k].origins.push_back(RandomOrigin(kinds_[k].kind, 2 * i + static_cast<uint32_t>(k)));
      for (uint32_t i = 0; i < kinds_[k].count; ++i) slots_.push_back(k);
    }
  }

  void RatePairs(TileWork& work);
  void RateGrids();
  std::vector<PatchSet> BestSets(size_t most) const;

 private:
  // Candidates of all kinds stand in one row, those of a kind behind each other.
  size_t Total() const { return kinds_.size() * options_.candidates; }
  const Origin& OriginOf(size_t i) const {
    return kinds_[i / options_.candidates].origins[i % options_.candidates];
  }
  PatchKind KindOf(size_t i) const { return kinds_[i / options_.candidates].kind; }

  Origin RandomOrigin(PatchKind kind, uint32_t stream) const;
  TexelPlace AtScale(const Origin& origin, int64_t x, int64_t y) const {
    return {(origin[0] + x) >> scale_, (origin[1] + y) >> scale_};
  }
  int64_t Roughness(size_t i) const;
  // Of all seams that the two can have with each other, in whatever order.
  int64_t SeamsOf(size_t i, size_t j) const;
  int64_t CornerSeams(const Origin& a, const Origin& b) const;
  int64_t EdgeSeams(const Origin& lies, const Origin& stands) const;
  int64_t EdgeEnds(bool stands, const Origin& a, const Origin& b) const;
  // The share of the smaller of the two that is part of the other, too.
  double Overlap(size_t i, size_t j) const;
  double UsualCost() const;
  double CostOf(const std::vector<size_t>& set, size_t slot, size_t candidate) const;
  double Improve(std::vector<size_t>& set, size_t first_slot) const;
  PatchSet SetOf(const std::vector<size_t>& candidates) const;

  const TileSample& sample_;
  const TilePackLayout& layout_;
  const TileSetOptions& options_;
  uint32_t scale_;
  std::vector<Patches> kinds_;
  std::vector<size_t> slots_;  // the kind of each colour
  std::vector<float> costs_;   // of pairs, both ways
  std::vector<float> grids_;   // of pairs: their parts of a set's grid
  std::vector<int64_t> roughness_;
};

Origin PatchSearch::RandomOrigin(PatchKind kind, uint32_t stream) const {
  Origin origin;
  for (int axis = 0; axis < 2; ++axis) {
    const int64_t size = axis == 0 ? sample_.width() : sample_.height();
    const UsedPart used = UsedOf(kind, axis, layout_.tile_size);
    const int64_t places = sample_.wraps() ? size : size - (used.end - used.first) + 1;
    const uint32_t random = TileHash(options_.seed, 2 * stream + static_cast<uint32_t>(axis));
    origin[static_cast<size_t>(axis)] =
        static_cast<int64_t>(uint64_t{random} * static_cast<uint64_t>(places) >> 32) - used.first;
  }
  return origin;
}

// Sum of the steps between neighbours on a grid over what is used of the patch.
int64_t PatchSearch::Roughness(size_t i) const {
  const UsedPart columns = UsedOf(KindOf(i), 0, layout_.tile_size);
  const UsedPart rows = UsedOf(KindOf(i), 1, layout_.tile_size);
  const int64_t step = int64_t{1} << scale_;
  int64_t sum = 0;
  int64_t count = 0;
  for (int64_t y = rows.first; y + step < rows.end; y += step) {
    for (int64_t x = columns.first; x + step < columns.end; x += step, count += 2) {
      const TexelPlace at = AtScale(OriginOf(i), x, y);
      sum += sample_.Difference(scale_, at, {at.x + 1, at.y}) +
             sample_.Difference(scale_, at, {at.x, at.y + 1});
    }
  }
  return sum / std::max<int64_t>(count, 1);
}

int64_t PatchSearch::CornerSeams(const Origin& a, const Origin& b) const {
  const int64_t size = layout_.tile_size;
  const uint32_t side = (layout_.tile_size + (1u << scale_) - 1) >> scale_;
  const int64_t length = std::max<int64_t>(side / 2, 1);
  const TexelPlace from = AtScale(a, size, size);
  return SeamBetween({sample_, scale_, side, from, AtScale(b, 0, size)}, false, length) +
         SeamBetween({sample_, scale_, side, from, AtScale(b, size, 0)}, true, length);
}

int64_t PatchSearch::EdgeSeams(const Origin& lies, const Origin& stands) const {
  const int64_t size = layout_.tile_size;
  const uint32_t side = (layout_.tile_size + (1u << scale_) - 1) >> scale_;
  int64_t cost = 0;
  for (const bool top : {false, true}) {
    for (const bool right : {false, true}) {
      const TilePair pair{sample_, scale_, side, AtScale(lies, 0, top ? 0 : size),
                          AtScale(stands, right ? 0 : size, 0)};
      cost += SeamFromCorner(pair, right, top);
    }
  }
  return cost;
}

int64_t PatchSearch::EdgeEnds(bool stands, const Origin& a, const Origin& b) const {
  const int64_t size = layout_.tile_size;
  const uint32_t side = (layout_.tile_size + (1u << scale_) - 1) >> scale_;
  const TexelPlace start = stands ? AtScale(b, size, 0) : AtScale(b, 0, size);
  return MismatchAround({sample_, scale_, side, AtScale(a, size, size), start},
                        std::max<int64_t>(side / 16, 1));
}

int64_t PatchSearch::SeamsOf(size_t i, size_t j) const {
  const Origin& a = OriginOf(i);
  const Origin& b = OriginOf(j);
  const PatchKind kind = KindOf(i);
  if (kind == PatchKind::kCorner) return CornerSeams(a, b) + (i == j ? 0 : CornerSeams(b, a));
  if (kind == KindOf(j)) {
    const bool stands = kind == PatchKind::kStands;
    return EdgeEnds(stands, a, b) + (i == j ? 0 : EdgeEnds(stands, b, a));
  }
  return kind == PatchKind::kLies ? EdgeSeams(a, b) : EdgeSeams(b, a);
}

void PatchSearch::RatePairs(TileWork& work) {
  const size_t total = Total();
  costs_.resize(total * total);
  roughness_.resize(total);
  for (size_t i = 0; i < total; ++i) roughness_[i] = Roughness(i);
  int64_t mean = 0;
  for (int64_t value : roughness_) mean += value;
  mean = std::max<int64_t>(mean / static_cast<int64_t>(total), 1);
  ForEachTile(static_cast<uint32_t>(total), options_.threads, [&](uint32_t i) {
    for (size_t j = i; j < total; ++j) {
      // What is rough hides seams; without this the dullest places of the sample would win.
      const auto rough = static_cast<double>(roughness_[i] + roughness_[j] + mean);
      const double cost = static_cast<double>(SeamsOf(i, j)) / rough;
      costs_[i * total + j] = costs_[j * total + i] = static_cast<float>(cost);
    }
    work.Add(total - i);
  });
  const double usual = UsualCost();
  for (size_t i = 0; i < total; ++i) {
    for (size_t j = 0; j < total; ++j) {
      if (i != j) costs_[i * total + j] += static_cast<float>(kOverlapCost * usual * Overlap(i, j));
    }
  }
}

double PatchSearch::UsualCost() const {
  double sum = 0;
  for (float cost : costs_) sum += double{cost};
  return sum / static_cast<double>(costs_.size());
}

// The grid is a sum over pairs, as seams are, so that patches are found whose light parts are each
// other's dark ones.
void PatchSearch::RateGrids() {
  const double usual = UsualCost();
  const size_t total = Total();
  const int64_t size = layout_.tile_size;
  PatchShades shades(sample_, scale_, layout_.tile_size);
  for (size_t i = 0; i < total; ++i) {
    const PatchKind kind = KindOf(i);
    const Origin& origin = OriginOf(i);
    shades.Add({origin[0] + (kind == PatchKind::kLies ? size / 2 : size),
                origin[1] + (kind == PatchKind::kStands ? size / 2 : size)},
               kind != PatchKind::kCorner);
  }
  double mean = 0;
  for (size_t i = 0; i < total; ++i) mean += shades.Product(i, i);
  mean /= static_cast<double>(total);
  grids_.resize(total * total);
  if (mean <= 0) return;
  // Seams are those of all pairs, and of each patch with itself.
  const double seams = static_cast<double>(slots_.size() + 1) / 2;
  for (size_t i = 0; i < total; ++i) {
    for (size_t j = 0; j < total; ++j) {
      // Around edges that lie there is nothing of those that stand.
      if (KindOf(i) != KindOf(j)) continue;
      const double grid = shades.Product(i, j) / mean;
      grids_[i * total + j] = static_cast<float>(grid);
      costs_[i * total + j] +=
          static_cast<float>((i == j ? 1 : 2) * kGridCost * usual * seams * grid);
    }
  }
}

double PatchSearch::Overlap(size_t i, size_t j) const {
  double share = 1;
  for (int axis = 0; axis < 2; ++axis) {
    const int64_t sample = axis == 0 ? sample_.width() : sample_.height();
    const UsedPart a = UsedOf(KindOf(i), axis, layout_.tile_size);
    const UsedPart b = UsedOf(KindOf(j), axis, layout_.tile_size);
    const auto at = [&](size_t candidate) {
      return OriginOf(candidate)[static_cast<size_t>(axis)];
    };
    // Twice the distance of their middles.
    int64_t apart = std::abs(2 * (at(i) - at(j)) + a.first + a.end - b.first - b.end);
    if (sample_.wraps()) apart = std::min(apart % (2 * sample), 2 * sample - apart % (2 * sample));
    const int64_t width = a.end - a.first;
    const int64_t other = b.end - b.first;
    const auto common = static_cast<double>(width + other - apart) / 2;
    const auto less = static_cast<double>(std::min(width, other));
    share *= std::clamp(common / less, 0.0, 1.0);
  }
  return share;
}

double PatchSearch::CostOf(const std::vector<size_t>& set, size_t slot, size_t candidate) const {
  const size_t total = Total();
  double cost = double{costs_[candidate * total + candidate]};
  for (size_t other = 0; other < set.size(); ++other) {
    if (other != slot) {
      // The same candidate twice would be no second colour.
      cost += set[other] == candidate ? 1e30 : double{costs_[candidate * total + set[other]]};
    }
  }
  return cost;
}

// Each colour from `first_slot` on in turn takes the best candidate, the others given; the cost of
// all.
double PatchSearch::Improve(std::vector<size_t>& set, size_t first_slot) const {
  bool changed = true;
  for (int sweep = 0; sweep < kMaxSweeps && changed; ++sweep) {
    changed = false;
    for (size_t slot = first_slot; slot < set.size(); ++slot) {
      double least = CostOf(set, slot, set[slot]);
      for (size_t i = 0; i < options_.candidates; ++i) {
        const size_t candidate = slots_[slot] * options_.candidates + i;
        const double cost = CostOf(set, slot, candidate);
        if (cost >= least) continue;
        least = cost;
        set[slot] = candidate;
        changed = true;
      }
    }
  }
  const size_t total = Total();
  double cost = 0;
  for (size_t slot = 0; slot < set.size(); ++slot) {
    cost += CostOf(set, slot, set[slot]) + double{costs_[set[slot] * total + set[slot]]};
  }
  return cost / 2;
}

PatchSet PatchSearch::SetOf(const std::vector<size_t>& candidates) const {
  PatchSet set;
  for (size_t candidate : candidates) {
    set.patches.push_back(OriginOf(candidate));
    set.roughness += static_cast<double>(roughness_[candidate]);
  }
  set.roughness /= static_cast<double>(candidates.size());
  if (grids_.empty()) return set;
  for (size_t i : candidates) {
    for (size_t j : candidates) set.grid += double{grids_[i * Total() + j]};
  }
  set.grid /= static_cast<double>(candidates.size());
  return set;
}

std::vector<PatchSet> PatchSearch::BestSets(size_t most) const {
  std::vector<std::pair<double, std::vector<size_t>>> sets;
  for (size_t start = 0; start < std::min<size_t>(options_.candidates, kMaxStarts); ++start) {
    std::vector<size_t> set;
    for (size_t kind : slots_) {
      // First any that differ; the sweeps do the rest.
      const size_t i = (start + set.size()) % options_.candidates;
      set.push_back(kind * options_.candidates + i);
    }
    // The best with this patch, then wherever that leads: many starts lead to the same set.
    for (const size_t first_slot : {size_t{1}, size_t{0}}) {
      const double cost = Improve(set, first_slot);
      std::vector<size_t> sorted = set;
      std::ranges::sort(sorted);
      sets.emplace_back(cost, std::move(sorted));
    }
  }
  std::ranges::sort(sets);
  sets.erase(std::ranges::unique(sets, {}, [](const auto& set) { return set.second; }).begin(),
             sets.end());
  std::vector<PatchSet> best;
  for (size_t i = 0; i < std::min(most, sets.size()); ++i) best.push_back(SetOf(sets[i].second));
  return best;
}

}  // namespace

uint32_t TileHash(uint32_t seed, uint32_t stream) { return Pcg(stream + Pcg(seed)); }

std::vector<TexelPlace> PatchesOfTile(const TilePackLayout& layout,
                                      const std::vector<Origin>& patches,
                                      const TileColors& colors) {
  const int64_t size = layout.tile_size;
  const auto place = [&](size_t patch, int64_t x, int64_t y) {
    return TexelPlace{patches[patch][0] + x, patches[patch][1] + y};
  };
  if (layout.kind == TileKind::kCorner) {
    return {place(colors[0], size, size), place(colors[1], 0, size), place(colors[2], size, 0),
            place(colors[3], 0, 0)};
  }
  const size_t stands = layout.colors[0];
  return {place(colors[0], 0, size), place(stands + colors[1], 0, 0), place(colors[2], 0, 0),
          place(stands + colors[3], size, 0)};
}

std::vector<PatchSet> RankPatches(const TileSample& sample, const TilePackLayout& layout,
                                  const TileSetOptions& options, uint32_t scale, size_t most,
                                  TileWork& work) {
  PatchSearch search(sample, layout, options, scale);
  search.RatePairs(work);
  if (options.even) search.RateGrids();
  return search.BestSets(most);
}

std::vector<uint32_t> SeamOverBorder(const TileSample& sample, uint32_t tile_size, bool stands,
                                     const Origin& from, const Origin& to) {
  const int64_t size = tile_size;
  const TexelPlace a{from[0] + size, from[1] + size};
  const TexelPlace b{to[0] + (stands ? size : 0), to[1] + (stands ? 0 : size)};
  return SeamPath({sample, 0, tile_size, a, b}, stands, std::max<int64_t>(size / 4, 1),
                  BorderDepth(tile_size));
}

}  // namespace texgraph::textures
