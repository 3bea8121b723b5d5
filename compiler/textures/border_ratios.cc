// SPDX-License-Identifier: Apache-2.0
// How much more a tiling of patterns changes at its borders than inside of the patterns.
#include "compiler/textures/border_ratios.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "compiler/textures/pattern_levels.h"

namespace texgraph::textures {
namespace {

// The sum of |b[j] - a[k]| over all j and k but j = k. Sorted, each number is subtracted as often
// as there are larger ones in the other list, so that many layers take little time.
double SumOfPairs(std::vector<double>& a, std::vector<double>& b) {
  double own = 0;
  for (size_t i = 0; i < a.size(); ++i) own += std::abs(b[i] - a[i]);
  std::ranges::sort(a);
  std::ranges::sort(b);
  const auto n = static_cast<double>(a.size());
  double sum = 0;
  for (size_t i = 0, below = 0; i < a.size(); ++i) {
    while (below < b.size() && b[below] < a[i]) ++below;
    sum += a[i] * (2.0 * static_cast<double>(below) - n);
  }
  for (size_t i = 0, below = 0; i < b.size(); ++i) {
    while (below < a.size() && a[below] <= b[i]) ++below;
    sum += b[i] * (2.0 * static_cast<double>(below) - n);
  }
  return sum - own;
}

// One line of texels across all layers: across a border, and inside.
class Lines {
 public:
  Lines(const ir::Texture::Level& level, bool vertical)
      : level_(level),
        step_(vertical ? level.width : 1),
        across_(vertical ? 1 : level.width),
        length_(vertical ? level.height : level.width),
        count_(vertical ? level.width : level.height),
        is_vertical_(vertical) {}

  bool is_vertical() const { return is_vertical_; }
  size_t length() const { return length_; }
  size_t count() const { return count_; }
  double At(size_t layer, size_t line, size_t i, size_t channel) const {
    const size_t plane = size_t{level_.width} * level_.height;
    return double{level_.texels[layer * plane + line * across_ + i * step_][channel]};
  }

 private:
  const ir::Texture::Level& level_;
  size_t step_, across_, length_, count_;
  bool is_vertical_;
};

// What begins at texel i of a line: the difference to the next one, and of that to the one after.
void AddTexel(const Lines& lines, size_t layer, size_t line, size_t i, size_t skip,
              Differences& inside) {
  const size_t n = lines.length();
  for (size_t c = 0; c < 4; ++c) {
    const double here = lines.At(layer, line, i, c);
    const double next = lines.At(layer, line, (i + 1) % n, c);
    if (i + 1 + skip < n) inside.values.Add(std::abs(next - here));
    // A pattern of two texels has no slopes inside but those across its own border.
    if (n > 2 && i + 2 + skip >= n) continue;
    const double second = lines.At(layer, line, (i + 2) % n, c);
    inside.slopes.Add(std::abs(here - 2 * next + second));
  }
}

void AddInside(const Lines& lines, size_t layers, size_t skip, Differences& inside) {
  // As the texels lie in memory.
  const size_t rows = lines.is_vertical() ? lines.length() : lines.count();
  const size_t columns = lines.is_vertical() ? lines.count() : lines.length();
  for (size_t layer = 0; layer < layers; ++layer) {
    for (size_t y = skip; y + skip < rows; ++y) {
      for (size_t x = skip; x + skip < columns; ++x) {
        AddTexel(lines, layer, lines.is_vertical() ? x : y, lines.is_vertical() ? y : x, skip,
                 inside);
      }
    }
  }
}

void AddBorders(const Lines& lines, size_t layers, size_t most_lines, Differences& borders,
                DifferenceMean& halves, DifferenceMean& jumps) {
  const size_t n = lines.length();
  const auto pairs = static_cast<double>(layers * (layers - 1));
  std::vector<double> a(layers), b(layers);
  const auto add = [&](DifferenceMean& mean, auto of_left, auto of_right) {
    for (size_t k = 0; k < layers; ++k) {
      a[k] = of_left(k);
      b[k] = of_right(k);
    }
    mean.Add(SumOfPairs(a, b), pairs);
  };
  const size_t stride = (lines.count() + most_lines - 1) / most_lines;
  for (size_t line = 0; line < lines.count(); line += stride) {
    for (size_t c = 0; c < 4; ++c) {
      const auto first = [&](size_t k) { return lines.At(k, line, 0, c); };
      const auto second = [&](size_t k) { return lines.At(k, line, 1, c); };
      const auto last = [&](size_t k) { return lines.At(k, line, n - 1, c); };
      const auto before = [&](size_t k) { return lines.At(k, line, n - 2, c); };
      const auto slope = [&](size_t k) { return first(k) - last(k); };
      add(borders.values, last, first);
      add(
          halves, [&](size_t k) { return 0.75 * last(k) + 0.25 * first(k); },
          [&](size_t k) { return 0.75 * first(k) + 0.25 * last(k); });
      add(
          borders.slopes, [&](size_t k) { return 2 * last(k) - before(k); }, first);
      add(borders.slopes, last, [&](size_t k) { return 2 * first(k) - second(k); });
      add(jumps, slope, slope);
    }
  }
}

double Ratio(const DifferenceMean& border, const DifferenceMean& inside) {
  if (border.Get() == 0) return 0;
  if (inside.Get() == 0) return std::numeric_limits<double>::infinity();
  return border.Get() / inside.Get();
}

}  // namespace

AxisDifferences MeasureInside(const ir::Texture::Level& level, bool skip_ring) {
  AxisDifferences inside;
  AddInside(Lines(level, false), level.depth, skip_ring ? 1 : 0, inside.right);
  AddInside(Lines(level, true), level.depth, skip_ring ? 1 : 0, inside.up);
  return inside;
}

BorderRatios CompareBorders(const ir::Texture::Level& level, const AxisDifferences& inside,
                            size_t most_lines) {
  if (level.depth < 2 || level.width < 2 || level.height < 2) return {};
  BorderRatios largest;
  for (bool vertical : {false, true}) {
    Differences borders;
    DifferenceMean halves, jumps;
    AddBorders(Lines(level, vertical), level.depth, most_lines, borders, halves, jumps);
    const Differences& own = vertical ? inside.up : inside.right;
    largest.values = std::max(
        {largest.values, Ratio(borders.values, own.values), 2 * Ratio(halves, own.values)});
    largest.slopes =
        std::max({largest.slopes, Ratio(borders.slopes, own.slopes), Ratio(jumps, own.slopes)});
  }
  return largest;
}

BorderRatios MeasureBorders(const ir::Texture::Level& level) {
  return CompareBorders(level, MeasureInside(level, false), level.texels.size());
}

}  // namespace texgraph::textures
