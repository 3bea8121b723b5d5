// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/cube_parts.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "compiler/textures/min_cut.h"
#include "compiler/textures/tile_patches.h"
#include "compiler/textures/tile_threads.h"

namespace texgraph::textures {
namespace {

using At3 = std::array<int32_t, 3>;

// Seams that cost nothing else are small, too.
constexpr int64_t kSeam = 1;
constexpr uint8_t kFree = 2;
constexpr int64_t kMaxNodes = 4096;  // that are cut at once
constexpr int32_t kBand = 2;         // texels to both sides of a coarse seam
constexpr uint32_t kOutside = ~0u;

size_t Volume(const At3& size) {
  return static_cast<size_t>(size[0]) * static_cast<size_t>(size[1]) * static_cast<size_t>(size[2]);
}

size_t IndexIn(const At3& size, const At3& at) {
  return static_cast<size_t>((at[2] * size[1] + at[1]) * size[0] + at[0]);
}

// Calls `work` for each place from `first` on, x fastest.
template <class Work>
void ForEachPlace(const At3& first, const At3& size, const Work& work) {
  At3 at;
  for (at[2] = first[2]; at[2] < first[2] + size[2]; ++at[2]) {
    for (at[1] = first[1]; at[1] < first[1] + size[1]; ++at[1]) {
      for (at[0] = first[0]; at[0] < first[0] + size[0]; ++at[0]) work(at);
    }
  }
}

// The zone in which a seam may run: what it costs there, and its best way.
struct SeamZone {
  At3 size{};
  uint32_t axis = 0;           // the lower side is 0, the upper one 1
  std::vector<uint8_t> sides;  // kFree, or given
  std::vector<int64_t> costs;  // of a seam on one side of the texel

  // Sets all sides.
  void Cut();
  // What the seam costs.
  int64_t Energy() const;

 private:
  void CutAtOnce();
  SeamZone Halved() const;
  void TakeFrom(const SeamZone& coarse);
  template <class Work>
  void ForEachPair(const Work& work) const;
};

// `work(p, q, cost)` for neighbours; kOutside for what lies below the zone or above it.
template <class Work>
void SeamZone::ForEachPair(const Work& work) const {
  const size_t strides[3] = {1, static_cast<size_t>(size[0]),
                             static_cast<size_t>(size[0]) * static_cast<size_t>(size[1])};
  uint32_t p = 0;
  ForEachPlace({}, size, [&](const At3& at) {
    for (uint32_t i = 0; i < 3; ++i) {
      const bool last = at[i] + 1 == size[i];
      if (i == axis && at[i] == 0) work(kOutside, p, 2 * costs[p] + kSeam);
      if (i == axis && last) work(p, kOutside, 2 * costs[p] + kSeam);
      if (last) continue;
      const auto q = p + static_cast<uint32_t>(strides[i]);
      work(p, q, costs[p] + costs[q] + kSeam);
    }
    ++p;
  });
}

void SeamZone::CutAtOnce() {
  std::vector<uint32_t> nodes(sides.size(), kOutside);
  uint32_t count = 0;
  for (size_t i = 0; i < sides.size(); ++i) {
    if (sides[i] == kFree) nodes[i] = count++;
  }
  MinCut network(count);
  // Source: below. Sink: above.
  const auto side = [&](uint32_t p, uint8_t outside) { return p == kOutside ? outside : sides[p]; };
  ForEachPair([&](uint32_t p, uint32_t q, int64_t cost) {
    const uint8_t a = side(p, 0);
    const uint8_t b = side(q, 1);
    if (a == kFree && b == kFree) return network.AddPair(nodes[p], nodes[q], cost, cost);
    if (a == kFree) network.AddNode(nodes[p], b == 0 ? cost : -cost);
    if (b == kFree) network.AddNode(nodes[q], a == 0 ? cost : -cost);
  });
  const std::vector<bool> above = network.Solve();
  for (size_t i = 0; i < sides.size(); ++i) {
    if (sides[i] == kFree) sides[i] = above[nodes[i]] ? 1 : 0;
  }
}

int64_t SeamZone::Energy() const {
  const auto side = [&](uint32_t p, uint8_t outside) { return p == kOutside ? outside : sides[p]; };
  int64_t energy = 0;
  ForEachPair([&](uint32_t p, uint32_t q, int64_t cost) {
    if (side(p, 0) != side(q, 1)) energy += cost;
  });
  return energy;
}

// Large ones at half the scale first, whose seam may then move by a little: that takes a time that
// grows with the seam and not faster than the texels.
void SeamZone::Cut() {
  std::vector<SeamZone> coarser;
  const SeamZone* finest = this;
  while (std::ranges::count(finest->sides, kFree) > kMaxNodes) {
    coarser.push_back(finest->Halved());
    finest = &coarser.back();
  }
  for (size_t i = coarser.size(); i-- > 0;) {
    coarser[i].CutAtOnce();
    (i > 0 ? coarser[i - 1] : *this).TakeFrom(coarser[i]);
  }
  CutAtOnce();
}

SeamZone SeamZone::Halved() const {
  SeamZone half;
  half.axis = axis;
  for (size_t i = 0; i < 3; ++i) half.size[i] = (size[i] + 1) / 2;
  half.sides.resize(Volume(half.size), kFree);
  half.costs.resize(half.sides.size());
  std::vector<int64_t> counts(half.sides.size());
  size_t from = 0;
  ForEachPlace({}, size, [&](const At3& at) {
    const size_t to = IndexIn(half.size, {at[0] / 2, at[1] / 2, at[2] / 2});
    half.costs[to] += costs[from];
    ++counts[to];
    if (sides[from] != kFree) half.sides[to] = sides[from];
    ++from;
  });
  for (size_t i = 0; i < counts.size(); ++i) half.costs[i] /= counts[i];
  return half;
}

// The sides of a zone of half the scale, but for what is free and near the seam.
void SeamZone::TakeFrom(const SeamZone& coarse) {
  // By axes: near both sides, or not, along x, then also along y, then along z.
  std::vector<uint8_t> near(sides.size());
  size_t to = 0;
  ForEachPlace({}, size, [&](const At3& at) {
    const uint8_t side =
        sides[to] != kFree ? sides[to]
                           : coarse.sides[IndexIn(coarse.size, {at[0] / 2, at[1] / 2, at[2] / 2})];
    near[to++] = static_cast<uint8_t>(1u << side);
  });
  const std::vector<uint8_t> own = near;
  for (uint32_t i = 0; i < 3; ++i) {
    const std::vector<uint8_t> before = near;
    to = 0;
    ForEachPlace({}, size, [&](const At3& at) {
      for (int32_t step = -kBand; step <= kBand; ++step) {
        At3 other = at;
        other[i] += step;
        if (other[i] >= 0 && other[i] < size[i]) near[to] |= before[IndexIn(size, other)];
        // Beyond its ends there is one side alone.
        else if (i == axis)
          near[to] |= other[i] < 0 ? 1 : 2;
      }
      ++to;
    });
  }
  for (size_t i = 0; i < sides.size(); ++i) {
    if (sides[i] == kFree && near[i] != 3) sides[i] = own[i] >> 1;
  }
}

}  // namespace

bool CubePart::Has(const At3& at) const {
  for (size_t i = 0; i < 3; ++i) {
    if (at[i] < first[i] || at[i] >= first[i] + size[i]) return false;
  }
  return true;
}

uint8_t CubePart::At(const At3& at) const {
  return labels[IndexIn(size, {at[0] - first[0], at[1] - first[1], at[2] - first[2]})];
}

VoxelPlace CubePatches::PlaceOf(const CubeColors& colors, uint8_t label, const At3& at) const {
  VoxelPlace place = corners[colors[label]];
  for (size_t i = 0; i < 3; ++i) {
    place[i] += at[i] - (label >> i & 1 ? static_cast<int64_t>(size) : 0);
  }
  return place;
}

// Two parts, one a cube after the other along `axis`; null: the patch of a corner alone.
struct CubeParts::Join {
  uint32_t axis = 0;
  At3 first{};
  At3 size{};
  const CubePart* below = nullptr;
  const CubePart* above = nullptr;
  CubeColors colors{};
  std::vector<Given> given;
};

CubeParts::Joined CubeParts::Cut(const Join& join) const {
  const uint32_t axis = join.axis;
  SeamZone zone;
  zone.axis = axis;
  zone.size = join.size;
  zone.size[axis] = 2 * reach_ - size_;
  At3 first = join.first;
  first[axis] = size_ - reach_;
  const auto label = [&](At3 at, bool above) {
    if (!above) return join.below ? join.below->At(at) : uint8_t{0};
    at[axis] -= size_;
    const uint8_t lower = join.above ? join.above->At(at) : uint8_t{0};
    return static_cast<uint8_t>(lower | 1u << axis);
  };
  // Differences of both sides, then their sizes and half of how much they change.
  const uint32_t channels = patches_.sample.channels();
  std::vector<int32_t> differences;
  differences.reserve(Volume(zone.size) * channels);
  zone.sides.reserve(Volume(zone.size));
  ForEachPlace(first, zone.size, [&](const At3& at) {
    const auto texel = [&](bool above) {
      return patches_.sample.At(patches_.scale,
                                patches_.PlaceOf(join.colors, label(at, above), at));
    };
    const uint16_t* a = texel(false);
    const uint16_t* b = texel(true);
    for (uint32_t c = 0; c < channels; ++c) differences.push_back(int32_t{a[c]} - int32_t{b[c]});
    uint8_t side = kFree;
    for (const Given& given : join.given) {
      At3 from = at;
      if (given.moved) from[given.axis] -= size_;
      if (given.part->Has(from)) side = given.part->At(from) >> axis & 1;
    }
    zone.sides.push_back(side);
  });
  zone.costs.reserve(zone.sides.size());
  ForEachPlace({}, zone.size, [&](const At3& at) {
    const int32_t* here = &differences[IndexIn(zone.size, at) * channels];
    int64_t cost = 0;
    for (uint32_t c = 0; c < channels; ++c) cost += 2 * std::abs(here[c]);
    for (uint32_t i = 0; i < 3; ++i) {
      At3 next = at;
      if (++next[i] == zone.size[i]) continue;
      const int32_t* there = &differences[IndexIn(zone.size, next) * channels];
      for (uint32_t c = 0; c < channels; ++c) cost += std::abs(there[c] - here[c]);
    }
    zone.costs.push_back(cost);
  });
  Joined joined;
  zone.Cut();
  joined.energy = zone.Energy();
  joined.part.first = join.first;
  joined.part.size = join.size;
  joined.part.labels.reserve(Volume(join.size));
  ForEachPlace(join.first, join.size, [&](const At3& at) {
    bool above = at[axis] >= reach_;
    if (!above && at[axis] >= first[axis]) {
      above =
          zone.sides[IndexIn(zone.size, {at[0] - first[0], at[1] - first[1], at[2] - first[2]})] ==
          1;
    }
    joined.part.labels.push_back(label(at, above));
  });
  return joined;
}

CubeParts::CubeParts(CubePatches patches, uint32_t threads)
    : patches_(std::move(patches)),
      count_(static_cast<uint32_t>(patches_.corners.size())),
      size_(static_cast<int32_t>(patches_.size)),
      reach_(static_cast<int32_t>(TileReach(patches_.size))),
      depth_(static_cast<int32_t>(BorderDepth(patches_.size))) {
  JoinEdges(threads);
  JoinFaces(threads);
}

// Along x as far as the patches reach; along y near faces across x; along z near edges alone.
void CubeParts::JoinEdges(uint32_t threads) {
  const uint32_t pairs = count_ * count_;
  for (auto& edges : edges_) edges.resize(pairs);
  ForEachTile(3 * pairs, threads, [&](uint32_t i) {
    const uint32_t axis = i / pairs;
    const uint32_t from = i % pairs % count_;
    const uint32_t to = i % pairs / count_;
    Join join;
    join.axis = axis;
    for (uint32_t other = 0; other < 3; ++other) {
      const int32_t wide = other < axis ? depth_ : reach_;
      join.first[other] = other == axis ? 0 : -wide;
      join.size[other] = other == axis ? size_ : 2 * wide;
    }
    join.colors[0] = from;
    join.colors[size_t{1} << axis] = to;
    edges_[axis][i % pairs] = Cut(join);
  });
}

const CubePart& CubeParts::Face(uint32_t axis, std::array<uint32_t, 4> colors) const {
  size_t index = 0;
  for (size_t i = 4; i-- > 0;) index = index * count_ + colors[i];
  return faces_[axis][index].part;
}

void CubeParts::JoinFaces(uint32_t threads) {
  const uint32_t fours = count_ * count_ * count_ * count_;
  for (auto& faces : faces_) faces.resize(fours);
  ForEachTile(3 * fours, threads, [&](uint32_t i) {
    const uint32_t across = i / fours;
    std::array<uint32_t, 4> colors;
    uint32_t rest = i % fours;
    for (uint32_t& color : colors) {
      color = rest % count_;
      rest /= count_;
    }
    // The face lies along two axes; of these, pairs of the lower one are joined along the higher.
    const uint32_t low = across == 0 ? 1 : 0;
    const uint32_t high = across == 2 ? 1 : 2;
    Join join;
    join.axis = high;
    join.size.fill(size_);
    const int32_t wide = across == 2 ? reach_ : depth_;
    join.first[across] = -wide;
    join.size[across] = 2 * wide;
    join.below = &Edge(low, colors[0], colors[1]);
    join.above = &Edge(low, colors[2], colors[3]);
    for (uint32_t corner = 0; corner < 4; ++corner)
      join.colors[((corner & 1) << low) | ((corner >> 1) << high)] = colors[corner];
    join.given = {{&Edge(high, colors[0], colors[2]), low, false},
                  {&Edge(high, colors[1], colors[3]), low, true}};
    faces_[across][i % fours] = Cut(join);
  });
}

CubePart CubeParts::Cube(const CubeColors& c) const {
  Join join;
  join.axis = 2;
  join.size.fill(size_);
  join.below = &Face(2, {c[0], c[1], c[2], c[3]});
  join.above = &Face(2, {c[4], c[5], c[6], c[7]});
  join.colors = c;
  join.given = {{&Face(0, {c[0], c[2], c[4], c[6]}), 0, false},
                {&Face(0, {c[1], c[3], c[5], c[7]}), 0, true},
                {&Face(1, {c[0], c[1], c[4], c[5]}), 1, false},
                {&Face(1, {c[2], c[3], c[6], c[7]}), 1, true}};
  return Cut(join).part;
}

int64_t CubeParts::Energy() const {
  int64_t energy = 0;
  for (const auto* kind : {&edges_, &faces_}) {
    for (const auto& parts : *kind) {
      for (const Joined& joined : parts) energy += joined.energy;
    }
  }
  return energy;
}

}  // namespace texgraph::textures
