// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/prepare.h"

#include <fmt/format.h>
#include <string.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <vector>

#include "compiler/textures/fill.h"
#include "compiler/textures/srgb.h"

namespace texgraph::textures {
namespace {

using Color = std::array<float, 3>;
using Texel = std::array<float, 4>;

// Of a texel beside the background, whose colour has some of it.
constexpr float kDoubtfulWeight = 1e-3f;
// Numbers of pictures are multiples of 1/255 or 1/65535, tolerances are not.
constexpr float kRounding = 1e-6f;

float Number(const Image& image, uint32_t x, uint32_t y, uint32_t channel) {
  return static_cast<float>(image.At(x, y, channel)) / (image.bits == 8 ? 255.0f : 65535.0f);
}

float MaskNumber(const Image& mask, const MaskSource& source, uint32_t x, uint32_t y) {
  const bool has_alpha = mask.channels % 2 == 0;
  float value = 1.0f;
  if (source.channel != MaskChannel::kAlpha) {
    value = Number(mask, x, y, mask.channels < 3 ? 0 : static_cast<uint32_t>(source.channel));
  } else if (has_alpha) {
    value = Number(mask, x, y, mask.channels - 1u);
  }
  return source.invert ? 1.0f - value : value;
}

float Dot(const Color& a, const Color& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Color Minus(const Color& a, const Color& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

// Marks what lies within `reach` of a marked place along one axis of `outer` times `count` times
// `inner` places.
std::vector<uint8_t> Spread(const std::vector<uint8_t>& marks, size_t outer, size_t count,
                            size_t inner, uint32_t reach) {
  std::vector<uint8_t> spread(marks.size());
  std::vector<uint32_t> since(inner);  // places since the last mark
  const auto visit = [&](size_t first) {
    for (size_t k = 0; k < inner; ++k) {
      since[k] = marks[first + k] != 0 ? 0 : std::min(since[k] + 1, reach + 1);
      if (since[k] <= reach) spread[first + k] = 1;
    }
  };
  for (size_t o = 0; o < outer; ++o) {
    std::ranges::fill(since, reach + 1);
    for (size_t i = 0; i < count; ++i) visit((o * count + i) * inner);
    std::ranges::fill(since, reach + 1);
    for (size_t i = count; i-- > 0;) visit((o * count + i) * inner);
  }
  return spread;
}

class Preparer {
 public:
  Preparer(const Image& picture, const PictureSource& source)
      : picture_(picture),
        source_(source),
        width_(picture.width),
        height_(picture.height),
        alpha_(size_t{width_} * height_, 1.0f) {
    const uint32_t most = picture.bits == 8 ? 255 : 65535;
    for (uint32_t i = 0; i <= most; ++i) {
      table_.push_back(Linear(static_cast<float>(i) / static_cast<float>(most)));
    }
  }

  void ApplyMask(const Image* mask) {
    const bool has_alpha = picture_.channels % 2 == 0;
    for (uint32_t y = 0; y < height_; ++y) {
      for (uint32_t x = 0; x < width_; ++x) {
        float& alpha = alpha_[At(x, y)];
        if (has_alpha) alpha *= Number(picture_, x, y, picture_.channels - 1u);
        if (mask != nullptr) alpha *= MaskNumber(*mask, *source_.mask, x, y);
      }
    }
  }

  void ApplyKey();
  // Afterwards every texel that does not show has a colour of those that do. False if none shows.
  bool FillTransparent();
  Image Finish(uint8_t bits) const;

 private:
  size_t At(uint32_t x, uint32_t y) const { return size_t{y} * width_ + x; }

  float Linear(float number) const {
    return source_.srgb ? static_cast<float>(SrgbDecode(number)) : number;
  }

  uint32_t SampleAt(uint32_t x, uint32_t y, uint32_t c) const {
    return picture_.At(x, y, picture_.channels < 3 ? 0 : c);
  }

  Color OwnColor(uint32_t x, uint32_t y) const {
    Color color;
    for (uint32_t c = 0; c < 3; ++c) color[c] = table_[SampleAt(x, y, c)];
    return color;
  }

  bool IsBackground(uint32_t x, uint32_t y) const {
    const float limit = source_.key->tolerance + kRounding;
    for (uint32_t c = 0; c < 3; ++c) {
      const float number = Number(picture_, x, y, picture_.channels < 3 ? 0 : c);
      if (std::fabs(number - source_.key->color[c]) > limit) return false;
    }
    return true;
  }

  bool Shows(size_t i) const { return alpha_[i] >= 0.5f / 255.0f; }

  const Image& picture_;
  const PictureSource& source_;
  const uint32_t width_, height_;
  std::vector<float> table_;  // linear light of each number that the picture can have
  std::vector<float> alpha_;
  std::vector<Texel> colors_;  // instead of the picture's own where the weight is 1; may be empty
};

// What is kept is known away from the background, and goes on from there over the edge. A texel of
// the edge is a mixture, C = a F + (1 - a) K, of that colour F and the key K, so a is the part of
// the way from K to F that it went.
void Preparer::ApplyKey() {
  std::vector<uint8_t> background(alpha_.size());
  for (uint32_t y = 0; y < height_; ++y) {
    for (uint32_t x = 0; x < width_; ++x) background[At(x, y)] = IsBackground(x, y) ? 1 : 0;
  }
  const uint32_t edge = source_.key->edge;
  const std::vector<uint8_t> near =
      Spread(Spread(background, height_, width_, 1, edge), 1, height_, width_, edge);
  Color key;
  for (uint32_t c = 0; c < 3; ++c) key[c] = Linear(source_.key->color[c]);
  std::vector<Texel> kept(alpha_.size());
  for (uint32_t y = 0; y < height_; ++y) {
    for (uint32_t x = 0; x < width_; ++x) {
      const size_t i = At(x, y);
      if (background[i] != 0) continue;
      const Color own = OwnColor(x, y);
      const Color beyond = Minus(own, key);
      // What a picture with alpha hides says nothing. Where nothing is free of the background, in
      // thin lines, what is furthest from it counts.
      const float known = near[i] != 0 ? kDoubtfulWeight * std::min(Dot(beyond, beyond), 1.0f) : 1;
      const float weight = known * alpha_[i];
      kept[i] = {own[0] * weight, own[1] * weight, own[2] * weight, weight};
    }
  }
  const bool any = FillColors(kept, width_, height_);
  colors_.resize(alpha_.size());
  for (uint32_t y = 0; y < height_; ++y) {
    for (uint32_t x = 0; x < width_; ++x) {
      const size_t i = At(x, y);
      if (!any || background[i] != 0) alpha_[i] = 0.0f;
      if (!any || background[i] != 0 || near[i] == 0) continue;
      const Color full = {kept[i][0], kept[i][1], kept[i][2]};
      const Color way = Minus(full, key), beyond = Minus(OwnColor(x, y), key);
      const float length = Dot(way, way);
      const float part = length > 0.0f ? std::clamp(Dot(beyond, way) / length, 0.0f, 1.0f) : 1.0f;
      alpha_[i] *= part;
      colors_[i][3] = 1.0f;
      for (size_t c = 0; c < 3; ++c) {
        // The less there is of it, the less its own colour tells.
        const float unmixed = part > 0.0f ? std::clamp(key[c] + beyond[c] / part, 0.0f, 1.0f) : 0;
        colors_[i][c] = full[c] + part * (unmixed - full[c]);
      }
    }
  }
}

bool Preparer::FillTransparent() {
  bool all = true, none = true;
  for (size_t i = 0; i < alpha_.size(); ++i) {
    all = all && Shows(i);
    none = none && !Shows(i);
  }
  if (all || none) return all;
  std::vector<Texel> filled(alpha_.size());
  for (uint32_t y = 0; y < height_; ++y) {
    for (uint32_t x = 0; x < width_; ++x) {
      const size_t i = At(x, y);
      if (!Shows(i)) continue;
      const bool changed = !colors_.empty() && colors_[i][3] > 0.0f;
      const Color own =
          changed ? Color{colors_[i][0], colors_[i][1], colors_[i][2]} : OwnColor(x, y);
      for (size_t c = 0; c < 3; ++c) filled[i][c] = own[c] * alpha_[i];
      filled[i][3] = alpha_[i];
    }
  }
  FillColors(filled, width_, height_);
  colors_.resize(alpha_.size());
  for (size_t i = 0; i < alpha_.size(); ++i) {
    if (!Shows(i)) colors_[i] = filled[i];
  }
  return true;
}

Image Preparer::Finish(uint8_t bits) const {
  Image image;
  image.width = width_;
  image.height = height_;
  image.channels = 4;
  image.bits = bits;
  image.pixels.resize(image.RowBytes() * height_);
  size_t at = 0;
  const auto put = [&](uint32_t sample) {
    if (bits == 8) {
      image.pixels[at++] = static_cast<uint8_t>(sample);
    } else {
      const auto wide = static_cast<uint16_t>(sample);
      memcpy(&image.pixels[at], &wide, sizeof wide);
      at += sizeof wide;
    }
  };
  for (uint32_t y = 0; y < height_; ++y) {
    for (uint32_t x = 0; x < width_; ++x) {
      const size_t i = At(x, y);
      for (uint32_t c = 0; c < 3; ++c) {
        if (colors_.empty() || colors_[i][3] == 0.0f) {
          const uint32_t sample = SampleAt(x, y, c);
          put(bits == picture_.bits ? sample : sample * 257);  // 255 becomes 65535
        } else if (bits == 8) {
          put(source_.srgb ? SrgbEncode8(colors_[i][c]) : Unorm8(colors_[i][c]));
        } else {
          put(source_.srgb ? SrgbEncode16(colors_[i][c]) : Unorm16(colors_[i][c]));
        }
      }
      put(bits == 8 ? Unorm8(alpha_[i]) : Unorm16(alpha_[i]));
    }
  }
  return image;
}

}  // namespace

bool CheckMaskSize(const PictureSource& source, const ImageInfo& picture, const ImageInfo& mask,
                   Diagnostics& diagnostics) {
  if (mask.width == picture.width && mask.height == picture.height) return true;
  diagnostics.Error(DiagnosticKind::kBadImage, source.mask->range,
                    fmt::format("mask '{}' has {} x {} pixels, its picture '{}' {} x {}; they must "
                                "be equally large",
                                Printable(source.mask->file), mask.width, mask.height,
                                Printable(source.file), picture.width, picture.height));
  return false;
}

Image PreparePicture(const Image& picture, const Image* mask, const PictureSource& source,
                     bool& left) {
  Preparer preparer(picture, source);
  preparer.ApplyMask(mask);
  if (source.key) preparer.ApplyKey();
  left = preparer.FillTransparent();
  return preparer.Finish(std::max(picture.bits, mask != nullptr ? mask->bits : uint8_t{8}));
}

std::optional<Image> ReadPicture(const PictureSource& source, Diagnostics& diagnostics,
                                 const Roots& roots) {
  std::optional<Image> picture = ReadImage(source.file, source.range, diagnostics, roots);
  std::optional<Image> mask;
  if (source.mask) mask = ReadImage(source.mask->file, source.mask->range, diagnostics, roots);
  if (!picture || (source.mask && !mask)) return std::nullopt;
  if (mask && !CheckMaskSize(source, *picture, *mask, diagnostics)) return std::nullopt;
  if (!mask && !source.key) return picture;
  try {
    bool left = true;
    Image prepared = PreparePicture(*picture, mask ? &*mask : nullptr, source, left);
    if (!left) {
      diagnostics.Warn(
          DiagnosticKind::kBadImage, source.range,
          fmt::format("nothing is left of image '{}': its {} it all", Printable(source.file),
                      source.key ? "key takes" : "mask hides"));
    }
    return prepared;
  } catch (const std::bad_alloc&) {
    diagnostics.Error(
        DiagnosticKind::kOutOfMemory, source.range,
        fmt::format("there is not enough memory to prepare image '{}'", Printable(source.file)));
    return std::nullopt;
  }
}

}  // namespace texgraph::textures
