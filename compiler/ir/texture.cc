// SPDX-License-Identifier: Apache-2.0
#include "compiler/ir/texture.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace texgraph::ir {
namespace {

using Level = Texture::Level;

// The largest level that lambda may choose.
float LastLevel(const Texture& texture) {
  float last = static_cast<float>(texture.levels.size() - 1);
  return std::max(0.0f, std::min(last, texture.sampler.max_level));
}

const Texel& At(const Level& level, uint32_t x, uint32_t y, uint32_t z) {
  return level.texels[(size_t{z} * level.height + y) * level.width + x];
}

// --- Wrapping (8.14.2, table 8.20) ---------------------------------------------------------------

// `i` is a whole number, however large. Powers of two beyond 2^53 have no neighbours that differ by
// one; they wrap all the same.
uint32_t WrapIndex(double i, uint32_t size, Wrap wrap) {
  double n = size;
  switch (wrap) {
    case Wrap::kClamp:
      return static_cast<uint32_t>(std::clamp(i, 0.0, n - 1));
    case Wrap::kRepeat: {
      double rest = std::fmod(i, n);
      return static_cast<uint32_t>(rest < 0 ? rest + n : rest);
    }
    case Wrap::kMirror: {
      // (n - 1) - mirror((i mod 2n) - n), mirror(a) = a >= 0 ? a : -(1 + a)
      double rest = std::fmod(i, 2 * n);
      if (rest < 0) rest += 2 * n;
      double a = rest - n;
      return static_cast<uint32_t>((n - 1) - (a >= 0 ? a : -(1 + a)));
    }
  }
  return 0;
}

// The texels that a filter reads along one axis: i1 has the weight alpha, i0 the rest.
struct Taps {
  uint32_t i0 = 0, i1 = 0;
  float alpha = 0.0f;
};

// The product with the size is rounded to float, as on GPUs: k / size then means texel k, not the
// one before it. What repeats loses its whole part first, as there: then it is as exact far away.
Taps TapsOf(float coordinate, uint32_t size, Wrap wrap, Filter filter) {
  if (wrap == Wrap::kRepeat) coordinate -= std::floor(coordinate);
  float scaled = coordinate * static_cast<float>(size);
  double u = std::isfinite(scaled) ? scaled : 0.0;
  if (filter == Filter::kNearest) {
    uint32_t i = WrapIndex(std::floor(u), size, wrap);
    return {i, i, 0.0f};
  }
  double below = std::floor(u - 0.5);
  return {WrapIndex(below, size, wrap), WrapIndex(below + 1, size, wrap),
          static_cast<float>(u - 0.5 - below)};
}

uint32_t LayerOf(float coordinate, uint32_t layers) {
  if (!std::isfinite(coordinate)) return 0;
  return static_cast<uint32_t>(std::clamp(std::floor(double{coordinate} + 0.5), 0.0, layers - 1.0));
}

// --- Filtering within a level (8.14.2, equations 8.18 to 8.21) -----------------------------------

Texel Blend(const Texel& a, const Texel& b, float t) {
  Texel r;
  for (size_t c = 0; c < 4; ++c) r[c] = (1.0f - t) * a[c] + t * b[c];
  return r;
}

Texel Plane(const Level& level, const Taps& u, const Taps& v, uint32_t z) {
  if (u.i0 == u.i1 && v.i0 == v.i1) return At(level, u.i0, v.i0, z);
  return Blend(Blend(At(level, u.i0, v.i0, z), At(level, u.i1, v.i0, z), u.alpha),
               Blend(At(level, u.i0, v.i1, z), At(level, u.i1, v.i1, z), u.alpha), v.alpha);
}

Texel SampleLevel(const Texture& texture, const float* coordinate, size_t index) {
  const Level& level = texture.levels[index];
  const SamplerState& sampler = texture.sampler;
  Taps u = TapsOf(coordinate[0], level.width, sampler.wrap_u, sampler.filter);
  Taps v = TapsOf(coordinate[1], level.height, sampler.wrap_v, sampler.filter);
  if (texture.is_array) return Plane(level, u, v, LayerOf(coordinate[2], level.depth));
  if (!texture.is_3d) return Plane(level, u, v, 0);
  Taps w = TapsOf(coordinate[2], level.depth, sampler.wrap_w, sampler.filter);
  if (w.i0 == w.i1) return Plane(level, u, v, w.i0);
  return Blend(Plane(level, u, v, w.i0), Plane(level, u, v, w.i1), w.alpha);
}

// --- The footprint (8.14.1, equation 8.8) --------------------------------------------------------

// The length of one gradient in texels of level 0.
double LengthInTexels(const Texture& texture, const float* gradient) {
  const Level& base = texture.levels[0];
  double u = double{gradient[0]} * base.width, v = double{gradient[1]} * base.height;
  double w = texture.is_3d ? double{gradient[2]} * base.depth : 0.0;
  return std::sqrt(u * u + v * v + w * w);
}

// log2 of 0 is minus infinity, which means magnification; what is not a number does as well.
float LevelOf(double rho) {
  return std::isnan(rho) ? -std::numeric_limits<float>::infinity()
                         : static_cast<float>(std::log2(rho));
}

// EXT_texture_filter_anisotropic: N samples along the longer axis, each of the level that fits an
// N-th of it.
Texel SampleAnisotropic(const Texture& texture, const float* coordinate, const float* dx,
                        const float* dy, float bias) {
  double px = LengthInTexels(texture, dx), py = LengthInTexels(texture, dy);
  double longer = std::max(px, py), shorter = std::min(px, py);
  double most = std::floor(std::min(texture.sampler.anisotropy, 16.0f));
  // Also for a shorter axis of length 0; for two of them the quotient is no number, and one sample
  // is taken.
  double n = longer / shorter > 1.0 ? std::min(std::ceil(longer / shorter), most) : 1.0;
  float lod = LevelOf(longer / n) + bias;
  const float* axis = px > py ? dx : dy;
  const size_t width = texture.is_3d ? 3 : 2;
  std::array<double, 4> sum{};
  for (int i = 1; i <= static_cast<int>(n); ++i) {
    double along = i / (n + 1) - 0.5;
    std::array<float, 3> at{coordinate[0], coordinate[1],
                            texture.is_3d || texture.is_array ? coordinate[2] : 0.0f};
    for (size_t k = 0; k < width; ++k) at[k] = static_cast<float>(at[k] + along * axis[k]);
    Texel texel = SampleLod(texture, at.data(), lod);
    for (size_t c = 0; c < 4; ++c) sum[c] += texel[c];
  }
  Texel mean;
  for (size_t c = 0; c < 4; ++c) mean[c] = static_cast<float>(sum[c] / n);
  return mean;
}

}  // namespace

Texel SampleLod(const Texture& texture, const float* coordinate, float lod) {
  const float last = LastLevel(texture);
  // Magnification, or NaN.
  if (!(lod > 0.0f) || texture.sampler.mip_filter == MipFilter::kNone) {
    return SampleLevel(texture, coordinate, 0);
  }
  lod = std::min(lod, last);
  if (texture.sampler.mip_filter == MipFilter::kNearest) {
    // ceil(lambda + 1/2) - 1: halves go to the finer level.
    return SampleLevel(texture, coordinate, static_cast<size_t>(std::ceil(lod + 0.5f) - 1.0f));
  }
  float fine = std::floor(lod), part = lod - fine;
  Texel texel = SampleLevel(texture, coordinate, static_cast<size_t>(fine));
  if (part == 0.0f) return texel;
  return Blend(texel, SampleLevel(texture, coordinate, static_cast<size_t>(fine) + 1), part);
}

float LodOfGradients(const Texture& texture, const float* dx, const float* dy) {
  return LevelOf(std::max(LengthInTexels(texture, dx), LengthInTexels(texture, dy)));
}

Texel SampleGrad(const Texture& texture, const float* coordinate, const float* dx, const float* dy,
                 float bias) {
  if (texture.sampler.anisotropy > 1.0f) {
    return SampleAnisotropic(texture, coordinate, dx, dy, bias);
  }
  return SampleLod(texture, coordinate, LodOfGradients(texture, dx, dy) + bias);
}

Texel Fetch(const Texture& texture, const int32_t* coordinate, int32_t level) {
  if (level < 0 || static_cast<size_t>(level) >= texture.levels.size()) return {};
  const Level& l = texture.levels[static_cast<size_t>(level)];
  // Negative ones become larger than any size.
  uint32_t x = static_cast<uint32_t>(coordinate[0]), y = static_cast<uint32_t>(coordinate[1]);
  uint32_t z = texture.is_array || texture.is_3d ? static_cast<uint32_t>(coordinate[2]) : 0;
  if (x >= l.width || y >= l.height || z >= l.depth) return {};
  return At(l, x, y, z);
}

}  // namespace texgraph::ir
