// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/cube_patches.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <utility>

#include "compiler/textures/cube_parts.h"
#include "compiler/textures/tile_patches.h"
#include "compiler/textures/tile_threads.h"

namespace texgraph::textures {
namespace {

constexpr size_t kFinalists = 8;
// Of two patches that are the same, as parts of what a pair costs in the mean.
constexpr double kSamePatchCost = 1;

class CubeSearch {
 public:
  CubeSearch(const CubeSample& sample, const CubeSetOptions& options)
      : sample_(sample),
        options_(options),
        scale_(ScalesOfCube(options.cube_size) - 1),
        size_(options.cube_size >> scale_),
        reach_(TileReach(static_cast<uint32_t>(size_))),
        row_(static_cast<size_t>(2 * reach_) * sample.channels()) {
    for (uint32_t i = 0; i < options.candidates; ++i) candidates_.push_back(RandomCorner(i));
    blocks_.resize(candidates_.size());
    roughness_.resize(candidates_.size());
  }

  std::vector<VoxelPlace> Choose();

 private:
  VoxelPlace RandomCorner(uint32_t index) const;
  VoxelPlace AtScale(const VoxelPlace& place) const {
    return {place[0] >> scale_, place[1] >> scale_, place[2] >> scale_};
  }
  void ReadBlock(size_t i);
  int64_t SeamAtLeast(size_t from, size_t to, uint32_t axis) const;
  void RatePairs();
  double Overlap(size_t i, size_t j) const;
  double& Cost(size_t i, size_t j) { return costs_[i * candidates_.size() + j]; }
  double CostOf(const std::vector<size_t>& set) const;
  std::vector<std::vector<size_t>> BestSets() const;

  const CubeSample& sample_;
  const CubeSetOptions& options_;
  uint32_t scale_;
  int64_t size_;  // of a cube, texels of the scale
  int64_t reach_;
  size_t row_;  // numbers of a row of a block
  std::vector<VoxelPlace> candidates_;
  // The numbers of each patch as far as it reaches, x fastest.
  std::vector<std::vector<uint16_t>> blocks_;
  std::vector<double> roughness_;
  std::vector<double> costs_;  // of pairs, both ways
};

VoxelPlace CubeSearch::RandomCorner(uint32_t index) const {
  const int64_t reach = TileReach(options_.cube_size);
  VoxelPlace corner;
  for (size_t axis = 0; axis < 3; ++axis) {
    const int64_t size = sample_.size()[axis];
    const int64_t places = sample_.wraps() ? size : size - 2 * reach + 1;
    const uint32_t random = TileHash(options_.seed, 3 * index + static_cast<uint32_t>(axis));
    corner[axis] = static_cast<int64_t>(uint64_t{random} * static_cast<uint64_t>(places) >> 32) +
                   (sample_.wraps() ? 0 : reach);
  }
  return corner;
}

// And how rough it is: the mean step along x, y and z.
void CubeSearch::ReadBlock(size_t i) {
  const VoxelPlace corner = AtScale(candidates_[i]);
  const uint32_t channels = sample_.channels();
  std::vector<uint16_t>& block = blocks_[i];
  block.reserve(row_ * static_cast<size_t>(4 * reach_ * reach_));
  int64_t steps = 0;
  for (int64_t z = -reach_; z < reach_; ++z) {
    for (int64_t y = -reach_; y < reach_; ++y) {
      for (int64_t x = -reach_; x < reach_; ++x) {
        const uint16_t* texel = sample_.At(scale_, {corner[0] + x, corner[1] + y, corner[2] + z});
        const size_t at = block.size();
        block.insert(block.end(), texel, texel + channels);
        const size_t rows = 2 * static_cast<size_t>(reach_);
        const std::pair<bool, size_t> lower[] = {
            {x > -reach_, channels}, {y > -reach_, row_}, {z > -reach_, row_ * rows}};
        for (const auto& [is_there, stride] : lower) {
          for (size_t c = 0; is_there && c < channels; ++c)
            steps += std::abs(int32_t{block[at + c]} - int32_t{block[at + c - stride]});
        }
      }
    }
  }
  roughness_[i] = static_cast<double>(steps) / static_cast<double>(24 * reach_ * reach_ * reach_);
}

// No surface between the two costs less than the sum of the least differences in each of the rows
// that it crosses; for each of these in the mean.
int64_t CubeSearch::SeamAtLeast(size_t from, size_t to, uint32_t axis) const {
  const size_t rows = 2 * static_cast<size_t>(reach_);
  const uint32_t channels = sample_.channels();
  const size_t strides[3] = {channels, row_, row_ * rows};
  const size_t along = strides[axis];
  const size_t u_stride = strides[axis == 0 ? 1 : 0];
  const size_t v_stride = strides[axis == 2 ? 1 : 2];
  // In the patch below the overlap ends where the patch does; in that above it begins there.
  const auto overlap = static_cast<size_t>(2 * reach_ - size_);
  const uint16_t* below = &blocks_[from][(rows - overlap) * along];
  const uint16_t* above = blocks_[to].data();
  int64_t sum = 0;
  for (size_t v = 0; v < rows; ++v) {
    for (size_t u = 0; u < rows; ++u) {
      const size_t at = u * u_stride + v * v_stride;
      int32_t least = std::numeric_limits<int32_t>::max();
      for (size_t t = 0; t < overlap; ++t) {
        int32_t difference = 0;
        for (uint32_t c = 0; c < channels; ++c) {
          const size_t i = at + t * along + c;
          difference += std::abs(int32_t{below[i]} - int32_t{above[i]});
        }
        least = std::min(least, difference);
      }
      sum += least;
    }
  }
  return sum / static_cast<int64_t>(rows * rows);
}

void CubeSearch::RatePairs() {
  const size_t total = candidates_.size();
  costs_.resize(total * total);
  double mean = 1;
  for (double value : roughness_) mean += value / static_cast<double>(total);
  ForEachTile(static_cast<uint32_t>(total), options_.threads, [&](uint32_t i) {
    for (size_t j = i; j < total; ++j) {
      int64_t seams = 0;
      for (uint32_t axis = 0; axis < 3; ++axis) {
        seams += SeamAtLeast(i, j, axis);
        if (i != j) seams += SeamAtLeast(j, i, axis);
      }
      // What is rough hides seams; without this the dullest places of the sample would win.
      Cost(i, j) = static_cast<double>(seams) / (roughness_[i] + roughness_[j] + mean);
      Cost(j, i) = Cost(i, j);
    }
  });
  double usual = 0;
  for (double cost : costs_) usual += cost / static_cast<double>(total * total);
  for (size_t i = 0; i < total; ++i) {
    for (size_t j = 0; j < total; ++j) {
      if (i != j) Cost(i, j) += kSamePatchCost * usual * Overlap(i, j);
    }
  }
}

// The share of one that is part of the other, too.
double CubeSearch::Overlap(size_t i, size_t j) const {
  const int64_t width = 2 * int64_t{TileReach(options_.cube_size)};
  double share = 1;
  for (size_t axis = 0; axis < 3; ++axis) {
    const int64_t size = sample_.size()[axis];
    int64_t apart = std::abs(candidates_[i][axis] - candidates_[j][axis]);
    if (sample_.wraps()) apart = std::min(apart % size, size - apart % size);
    share *= static_cast<double>(std::max<int64_t>(width - apart, 0)) / static_cast<double>(width);
  }
  return share;
}

double CubeSearch::CostOf(const std::vector<size_t>& set) const {
  double cost = 0;
  for (size_t i = 0; i < set.size(); ++i) {
    for (size_t j = i; j < set.size(); ++j) cost += costs_[set[i] * candidates_.size() + set[j]];
  }
  return cost;
}

// All pairs of candidates, or all threes.
std::vector<std::vector<size_t>> CubeSearch::BestSets() const {
  std::vector<std::pair<double, std::vector<size_t>>> best;
  std::vector<size_t> set(options_.colors);
  for (size_t i = 0; i < set.size(); ++i) set[i] = i;
  const size_t total = candidates_.size();
  while (true) {
    std::pair<double, std::vector<size_t>> rated{CostOf(set), set};
    if (best.size() < kFinalists || rated < best.back()) {
      best.insert(std::ranges::upper_bound(best, rated), std::move(rated));
      if (best.size() > kFinalists) best.pop_back();
    }
    // The next combination, in the order of the alphabet.
    size_t at = set.size();
    while (at > 0 && set[at - 1] == total - set.size() + at - 1) --at;
    if (at == 0) break;
    ++set[at - 1];
    for (size_t i = at; i < set.size(); ++i) set[i] = set[i - 1] + 1;
  }
  std::vector<std::vector<size_t>> sets;
  for (auto& [cost, members] : best) sets.push_back(std::move(members));
  return sets;
}

std::vector<VoxelPlace> CubeSearch::Choose() {
  const auto total = static_cast<uint32_t>(candidates_.size());
  ForEachTile(total, options_.threads, [&](uint32_t i) { ReadBlock(i); });
  RatePairs();
  // Pairs say little of how the seams of eight patches go together, so the best sets are tried.
  const std::vector<std::vector<size_t>> sets = BestSets();
  std::vector<double> costs(sets.size());
  ForEachTile(static_cast<uint32_t>(sets.size()), options_.threads, [&](uint32_t i) {
    CubePatches patches{sample_, scale_, static_cast<uint32_t>(size_), {}};
    double roughness = 1;
    for (size_t candidate : sets[i]) {
      patches.corners.push_back(AtScale(candidates_[candidate]));
      roughness += roughness_[candidate];
    }
    costs[i] = static_cast<double>(CubeParts(std::move(patches), 1).Energy()) / roughness;
  });
  const auto best = static_cast<size_t>(std::ranges::min_element(costs) - costs.begin());
  std::vector<VoxelPlace> corners;
  for (size_t candidate : sets[best]) corners.push_back(candidates_[candidate]);
  return corners;
}

}  // namespace

uint32_t ScalesOfCube(uint32_t cube_size) {
  uint32_t scales = 1;
  while (cube_size >> (scales - 1) > kCubeSearchSide) ++scales;
  return scales;
}

std::vector<VoxelPlace> ChooseCubePatches(const CubeSample& sample, const CubeSetOptions& options) {
  return CubeSearch(sample, options).Choose();
}

}  // namespace texgraph::textures
