// SPDX-License-Identifier: Apache-2.0
#include "graphs/pictures/canvas.h"

#include <algorithm>
#include <cmath>

namespace texgraph::pictures {

namespace {

constexpr int kSide = 4;  // samples of a pixel, each way

double Square(double value) {
  value = Clamp(value, 0, 1);
  return value * value;
}

uint8_t Byte(double value) {
  return static_cast<uint8_t>(std::floor(Clamp(value, 0, 1) * 255 + 0.5));
}

}  // namespace

Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
Point operator*(Point p, double factor) { return {p.x * factor, p.y * factor}; }
double Dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
double Length(Point p) { return std::sqrt(Dot(p, p)); }

Point Unit(Point p) {
  const double length = Length(p);
  return length < 1e-9 ? Point{1, 0} : p * (1 / length);
}

Point Direction(int x, int y, uint32_t seed) {
  return Unit({2 * Random(x, y, seed) - 1, 2 * Random(x, y, seed + 1) - 1});
}

Point Turned(Point p, Point along) { return {Dot(p, along), p.y * along.x - p.x * along.y}; }

Canvas::Canvas(int width, int height)
    : width_(width),
      height_(height),
      samples_(static_cast<size_t>(width) * static_cast<size_t>(height) * kSide * kSide) {}

void Canvas::Fill(const std::function<Color(Point)>& color) {
  Stamp({0, 0}, 2.0 * width_ / height_ + 2, [&](Point p) { return Surface{color(p), 1}; });
}

void Canvas::Stamp(Point center, double reach, const std::function<Surface(Point)>& surface) {
  const double scale = height_ * kSide;
  const auto first = [&](double low) {
    return std::max(0, static_cast<int>(std::floor(low * scale)));
  };
  const auto last = [&](double high, int size) {
    return std::min(size * kSide, static_cast<int>(std::floor(high * scale)) + 1);
  };
  const int x1 = last(center.x + reach, width_);
  const int y1 = last(center.y + reach, height_);
  for (int y = first(center.y - reach); y < y1; ++y) {
    for (int x = first(center.x - reach); x < x1; ++x) {
      const Surface top = surface({(x + 0.5) / scale - center.x, (y + 0.5) / scale - center.y});
      if (top.alpha <= 0) continue;
      Sample& sample = samples_[static_cast<size_t>(y) * static_cast<size_t>(width_ * kSide) +
                                static_cast<size_t>(x)];
      const double alpha = Clamp(top.alpha, 0, 1);
      const auto lay = [&](float below, double above) {
        return static_cast<float>(below * (1 - alpha) + above * alpha);
      };
      sample = {lay(sample.r, Square(top.color.r)), lay(sample.g, Square(top.color.g)),
                lay(sample.b, Square(top.color.b)), lay(sample.a, 1)};
    }
  }
}

void Canvas::Spot(Point center, Point along, Point size, Color color, double alpha,
                  double softness) {
  Stamp(center, std::max(size.x, size.y), [&](Point p) {
    const Point local = Turned(p, along);
    const double distance = Length({local.x / size.x, local.y / size.y});
    return Surface{color, alpha * SmoothStep(1, 1 - softness, distance)};
  });
}

void Canvas::Stroke(Point from, Point to, double bend, double width, Color foot, Color tip) {
  const Point middle = (from + to) * 0.5;
  const double length = Length(to - from);
  const Point along = Unit(to - from);
  Stamp(middle, 0.5 * length + width + std::fabs(bend), [&](Point p) {
    const Point local = Turned(p + (middle - from), along);
    const double t = local.x / length;
    if (t < 0 || t > 1) return Surface{foot, 0};
    const double across = local.y - 4 * bend * t * (1 - t);
    const double half = width * (1 - t * t) * SmoothStep(0, 0.08, t);
    const double light = 1 - 0.16 * Clamp(across / (half + 1e-6), -1, 1);
    return Surface{Mix(foot, tip, t) * light, std::fabs(across) < half ? 1.0 : 0.0};
  });
}

Canvas::Sample Canvas::MeanOf(int x, int y) const {
  double sum[4] = {0, 0, 0, 0};
  for (int j = 0; j < kSide; ++j) {
    for (int i = 0; i < kSide; ++i) {
      const Sample& sample =
          samples_[static_cast<size_t>(y * kSide + j) * static_cast<size_t>(width_ * kSide) +
                   static_cast<size_t>(x * kSide + i)];
      sum[0] += sample.r;
      sum[1] += sample.g;
      sum[2] += sample.b;
      sum[3] += sample.a;
    }
  }
  constexpr double kShare = 1.0 / (kSide * kSide);
  return {static_cast<float>(sum[0] * kShare), static_cast<float>(sum[1] * kShare),
          static_cast<float>(sum[2] * kShare), static_cast<float>(sum[3] * kShare)};
}

Picture Canvas::Finish(Color backdrop) const {
  Picture picture{width_, height_, true, {}};
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const Sample mean = MeanOf(x, y);
      const bool is_there = mean.a > 1.0f / 512;
      const double share = is_there ? 1.0 / mean.a : 0;
      picture.pixels.push_back(Byte(is_there ? std::sqrt(mean.r * share) : backdrop.r));
      picture.pixels.push_back(Byte(is_there ? std::sqrt(mean.g * share) : backdrop.g));
      picture.pixels.push_back(Byte(is_there ? std::sqrt(mean.b * share) : backdrop.b));
      picture.pixels.push_back(Byte(mean.a));
    }
  }
  return picture;
}

Picture Canvas::FinishOpaque() const {
  Picture picture{width_, height_, false, {}};
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const Sample mean = MeanOf(x, y);
      for (float channel : {mean.r, mean.g, mean.b}) {
        picture.pixels.push_back(Byte(std::sqrt(static_cast<double>(channel))));
      }
    }
  }
  return picture;
}

Picture Sheet(int columns, const std::vector<Picture>& pictures) {
  const Picture& first = pictures.front();
  const int rows = (static_cast<int>(pictures.size()) + columns - 1) / columns;
  Picture sheet{columns * first.width, rows * first.height, first.has_alpha, {}};
  const size_t channels = first.has_alpha ? 4 : 3;
  const size_t row_bytes = static_cast<size_t>(first.width) * channels;
  const size_t stride = static_cast<size_t>(sheet.width) * channels;
  sheet.pixels.resize(stride * static_cast<size_t>(sheet.height));
  for (size_t i = 0; i < pictures.size(); ++i) {
    const size_t left = i % static_cast<size_t>(columns) * row_bytes;
    const size_t top = i / static_cast<size_t>(columns) * static_cast<size_t>(first.height);
    for (size_t y = 0; y < static_cast<size_t>(first.height); ++y) {
      const auto from = pictures[i].pixels.begin() + static_cast<std::ptrdiff_t>(y * row_bytes);
      std::copy(from, from + static_cast<std::ptrdiff_t>(row_bytes),
                sheet.pixels.begin() + static_cast<std::ptrdiff_t>((top + y) * stride + left));
    }
  }
  return sheet;
}

Picture Coarse(Picture picture) {
  for (uint8_t& value : picture.pixels) {
    value = static_cast<uint8_t>(std::min(255, (value + 4) / 8 * 8));
  }
  return picture;
}

}  // namespace texgraph::pictures
