// SPDX-License-Identifier: Apache-2.0
// Optimal string alignment distance (Damerau-Levenshtein without edits inside a swapped pair),
// computed only in the band of the diagonal that can stay within the bound (Ukkonen 1985).
#include <algorithm>
#include <array>
#include <cstdlib>

#include "compiler/base/diagnostics.h"

namespace texgraph {
namespace {

constexpr size_t kMaxLength = 64;        // longer names are not guessed at
constexpr size_t kMaxCells = 1'000'000;  // work for one call: about two milliseconds

char Folded(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// At most `bound`, or `bound` + 1 if the names are further apart. Both are at most kMaxLength long.
int Distance(std::string_view a, std::string_view b, int bound, size_t& cells) {
  int rows = static_cast<int>(a.size()), columns = static_cast<int>(b.size());
  if (std::abs(rows - columns) > bound) return bound + 1;
  using Row = std::array<int, kMaxLength + 1>;
  Row before_last, last, current;
  for (int j = 0; j <= columns; ++j) last[j] = j;
  before_last.fill(bound + 1);
  for (int i = 1; i <= rows; ++i) {
    int from = std::max(1, i - bound), to = std::min(columns, i + bound);
    current.fill(bound + 1);
    if (from == 1) current[0] = i;
    int best = current[from - 1];
    for (int j = from; j <= to; ++j) {
      bool equal = Folded(a[i - 1]) == Folded(b[j - 1]);
      int value = std::min({last[j] + 1, current[j - 1] + 1, last[j - 1] + (equal ? 0 : 1)});
      bool swapped = i > 1 && j > 1 && Folded(a[i - 1]) == Folded(b[j - 2]) &&
                     Folded(a[i - 2]) == Folded(b[j - 1]);
      if (swapped) value = std::min(value, before_last[j - 2] + 1);
      current[j] = value;
      best = std::min(best, value);
    }
    cells += static_cast<size_t>(to - from + 1);
    if (best > bound) return bound + 1;
    before_last = last;
    last = current;
  }
  return std::min(last[columns], bound + 1);
}

}  // namespace

std::string_view NearestName(std::string_view seen,
                             const std::vector<std::string_view>& candidates) {
  if (seen.empty() || seen.size() > kMaxLength) return {};
  // A third of the letters may be wrong; of one or two letters, none.
  int bound = std::min(4, static_cast<int>(seen.size()) / 3);
  std::string_view nearest;
  size_t cells = 0;
  for (std::string_view candidate : candidates) {
    if (candidate.empty() || candidate.size() > kMaxLength || candidate == seen) continue;
    int distance = Distance(seen, candidate, bound, cells);
    if (distance <= bound) {
      nearest = candidate;
      if (distance == 0) break;
      bound = distance - 1;
    }
    if (cells > kMaxCells) break;
  }
  return nearest;
}

std::string DidYouMean(std::string_view seen, const std::vector<std::string_view>& candidates) {
  std::string_view nearest = NearestName(seen, candidates);
  if (nearest.empty()) return {};
  return "; did you mean '" + Printable(nearest, kMaxLength) + "'?";
}

}  // namespace texgraph
