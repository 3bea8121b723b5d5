// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/tile_seams.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace texgraph::textures {
namespace {

TexelPlace Moved(const TexelPlace& place, int64_t x, int64_t y) {
  return {place.x + x, place.y + y};
}

// Paths from row 0 and row -1 of a border to `length` texels from it, one for each column that they
// can begin in.
class BorderPaths {
 public:
  BorderPaths(const TilePair& pair, bool stands, int64_t length)
      : pair_(pair),
        stands_(stands),
        length_(static_cast<size_t>(length)),
        first_(std::max<int64_t>(pair.side / 4, 1)),
        columns_(static_cast<size_t>(std::max(int64_t{pair.side} - pair.side / 4, first_ + 1) -
                                     first_)) {
    for (const bool below : {false, true}) {
      std::vector<int64_t>& sums = sums_[below ? 1 : 0];
      sums.resize(length_ * columns_);
      for (size_t row = length_; row-- > 0;) AddRow(below, row, sums);
    }
  }

  // The column of the cheapest path; both halves begin in the same one.
  size_t Best() const {
    size_t best = 0;
    for (size_t i = 1; i < columns_; ++i) {
      if (Cost(i) < Cost(best)) best = i;
    }
    return best;
  }
  int64_t Cost(size_t column) const { return sums_[0][column] + sums_[1][column]; }

  // From the border outwards: the first texels of `b` in `depth` rows.
  std::vector<uint32_t> Follow(bool below, size_t column, int64_t depth) const {
    std::vector<uint32_t> path;
    for (size_t row = 0; row < static_cast<size_t>(depth); ++row) {
      if (row > 0) column = NextOf(sums_[below ? 1 : 0], row, column);
      path.push_back(static_cast<uint32_t>(first_ + static_cast<int64_t>(column)));
    }
    return path;
  }

 private:
  // Where a path in this column of the row before goes on: one to each side is possible.
  size_t NextOf(const std::vector<int64_t>& sums, size_t row, size_t column) const {
    const int64_t* at = &sums[row * columns_];
    size_t next = column;
    if (column > 0 && at[column - 1] < at[next]) next = column - 1;
    if (column + 1 < columns_ && at[column + 1] < at[next]) next = column + 1;
    return next;
  }

  void AddRow(bool below, size_t row, std::vector<int64_t>& sums) {
    const int64_t across = below ? -1 - static_cast<int64_t>(row) : static_cast<int64_t>(row);
    int64_t last = 0;
    for (size_t i = 0; i <= columns_; ++i) {
      const int64_t at = first_ - 1 + static_cast<int64_t>(i);
      const int64_t x = stands_ ? across : at;
      const int64_t y = stands_ ? at : across;
      const int64_t cost =
          pair_.sample.Difference(pair_.scale, Moved(pair_.a, x, y), Moved(pair_.b, x, y));
      if (i > 0) {
        int64_t& sum = sums[row * columns_ + i - 1];
        sum = last + cost;
        if (row + 1 < length_) {
          sum += sums[(row + 1) * columns_ + NextOf(sums, row + 1, i - 1)];
        }
      }
      last = cost;
    }
  }

  const TilePair& pair_;
  bool stands_;
  size_t length_;
  int64_t first_;  // crossings begin here
  size_t columns_;
  std::vector<int64_t> sums_[2];  // row by row, away from the border: what the rest of a path costs
};

}  // namespace

int64_t SeamBetween(const TilePair& pair, bool stands, int64_t length) {
  const BorderPaths paths(pair, stands, length);
  return paths.Cost(paths.Best());
}

std::vector<uint32_t> SeamPath(const TilePair& pair, bool stands, int64_t length, int64_t depth) {
  const BorderPaths paths(pair, stands, length);
  const size_t column = paths.Best();
  std::vector<uint32_t> path = paths.Follow(true, column, depth);
  std::ranges::reverse(path);
  const std::vector<uint32_t> above = paths.Follow(false, column, depth);
  path.insert(path.end(), above.begin(), above.end());
  return path;
}

int64_t SeamFromCorner(const TilePair& pair, bool right, bool top) {
  const int64_t half = std::max<int64_t>(pair.side / 2, 1);
  std::vector<int64_t> row(static_cast<size_t>(half));
  for (int64_t j = 0; j < half; ++j) {
    int64_t diagonal = 0;
    for (int64_t i = 0; i < half; ++i) {
      const auto at = static_cast<size_t>(i);
      const int64_t x = right ? pair.side - 1 - i : i;
      const int64_t y = top ? pair.side - 1 - j : j;
      const int64_t cost =
          pair.sample.Difference(pair.scale, Moved(pair.a, x, y), Moved(pair.b, x, y));
      int64_t best = i == 0 && j == 0 ? 0 : std::numeric_limits<int64_t>::max();
      if (j > 0) best = row[at];
      if (i > 0) best = std::min(best, row[at - 1]);
      if (i > 0 && j > 0) best = std::min(best, diagonal);
      diagonal = row[at];
      row[at] = best + cost;
    }
  }
  return row.back();
}

std::vector<uint32_t> SeamAtCorner(const TilePair& pair, bool right, bool top, int64_t depth) {
  const auto cost = [&](int64_t across, int64_t up) {
    const int64_t x = right ? pair.side - 1 - across : across;
    const int64_t y = top ? pair.side - 1 - up : up;
    return pair.sample.Difference(pair.scale, Moved(pair.a, x, y), Moved(pair.b, x, y));
  };
  struct Step {
    int64_t sum = 0;    // what the path up to here costs
    uint32_t from = 0;  // texels of `b` in the row before
  };
  std::vector<std::vector<Step>> rows{{Step{}}};
  std::vector<int64_t> before(static_cast<size_t>(depth));  // cost(i, row before)
  for (int64_t i = 0; i < depth; ++i) before[static_cast<size_t>(i)] = cost(i, 0);
  for (int64_t up = 1; up < depth; ++up) {
    std::vector<Step>& row = rows.emplace_back();
    const std::vector<Step>& last = rows[rows.size() - 2];
    std::vector<int64_t> between{0};  // sums of what it costs to pass between the two rows
    std::vector<int64_t> costs;
    for (int64_t i = 0; i < depth; ++i) {
      costs.push_back(cost(i, up));
      between.push_back(between.back() + costs.back() + before[static_cast<size_t>(i)]);
    }
    for (int64_t count = 0; count <= std::min(2 * up + 1, depth); ++count) {
      const auto at = static_cast<size_t>(count);
      Step step{std::numeric_limits<int64_t>::max() / 2, 0};
      for (size_t from = 0; from < std::min(last.size(), at + 1) && 2 * count >= up; ++from) {
        const int64_t sum = last[from].sum + between[at] - between[from];
        if (sum < step.sum) step = {sum, static_cast<uint32_t>(from)};
      }
      // Beyond the rows and columns all is of the nearer edge outside of the wedge.
      if (count > 0 && (count < depth || depth > 2 * up)) {
        step.sum += cost(count - 1, up) + cost(count, up);
      }
      if (up + 1 == depth && 2 * count < depth) step.sum += cost(count, up) + cost(count, depth);
      row.push_back(step);
    }
    before = std::move(costs);
  }
  size_t at = 0;
  for (size_t i = 1; i < rows.back().size(); ++i) {
    if (rows.back()[i].sum < rows.back()[at].sum) at = i;
  }
  std::vector<uint32_t> path(rows.size());
  for (size_t row = rows.size(); row-- > 0;) {
    path[row] = static_cast<uint32_t>(at);
    at = rows[row][at].from;
  }
  return path;
}

int64_t MismatchAround(const TilePair& pair, int64_t reach) {
  int64_t sum = 0;
  for (int64_t y = -reach; y < reach; ++y) {
    for (int64_t x = -reach; x < reach; ++x)
      sum += pair.sample.Difference(pair.scale, Moved(pair.a, x, y), Moved(pair.b, x, y));
  }
  return sum * std::max<int64_t>(pair.side / 2, 1) / (4 * reach * reach);
}

}  // namespace texgraph::textures
