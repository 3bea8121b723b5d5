// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/texel_chain.h"

#include <fmt/format.h>
#include <string.h>

#include <algorithm>

#include "compiler/textures/half.h"
#include "compiler/textures/srgb.h"

namespace texgraph::textures {
namespace {

using ir::Texel;

float DecodeSample(uint32_t sample, uint8_t bits, bool srgb) {
  if (bits == 8) {
    return srgb ? SrgbDecode8(static_cast<uint8_t>(sample)) : static_cast<float>(sample) / 255.0f;
  }
  if (srgb) return static_cast<float>(SrgbDecode(sample / 65535.0));
  return static_cast<float>(sample) / 65535.0f;
}

// The value of each sample that an image of these bits can hold.
std::vector<float> DecodeTable(uint8_t bits, bool srgb) {
  std::vector<float> table(size_t{1} << bits);
  for (size_t i = 0; i < table.size(); ++i)
    table[i] = DecodeSample(static_cast<uint32_t>(i), bits, srgb);
  return table;
}

template <class T>
void Store(uint8_t* to, T a, T b, T c, T d) {
  const T values[4] = {a, b, c, d};
  memcpy(to, values, sizeof values);
}

template <class T>
std::array<T, 4> Load(const uint8_t* from) {
  std::array<T, 4> values;
  memcpy(values.data(), from, sizeof values);
  return values;
}

void Encode(TexelFormat format, const Texel& t, uint8_t* to) {
  switch (format) {
    case TexelFormat::kRgba8:
      return Store(to, Unorm8(t[0]), Unorm8(t[1]), Unorm8(t[2]), Unorm8(t[3]));
    case TexelFormat::kSrgb8Alpha8:
      return Store(to, SrgbEncode8(t[0]), SrgbEncode8(t[1]), SrgbEncode8(t[2]), Unorm8(t[3]));
    case TexelFormat::kRgba16:
      return Store(to, Unorm16(t[0]), Unorm16(t[1]), Unorm16(t[2]), Unorm16(t[3]));
    case TexelFormat::kRgba16F:
      return Store(to, FloatToHalf(t[0]), FloatToHalf(t[1]), FloatToHalf(t[2]), FloatToHalf(t[3]));
    case TexelFormat::kRgba32F:
      return Store(to, t[0], t[1], t[2], t[3]);
    case TexelFormat::kR16F: {
      const uint16_t half = FloatToHalf(t[0]);
      memcpy(to, &half, sizeof half);
      return;
    }
    case TexelFormat::kR32F:
      memcpy(to, &t[0], sizeof t[0]);
      return;
  }
}

}  // namespace

ir::Texel DecodeTexel(TexelFormat format, const uint8_t* from) {
  switch (format) {
    case TexelFormat::kRgba16F: {
      const std::array<uint16_t, 4> halves = Load<uint16_t>(from);
      return {HalfToFloat(halves[0]), HalfToFloat(halves[1]), HalfToFloat(halves[2]),
              HalfToFloat(halves[3])};
    }
    case TexelFormat::kRgba32F:
      return Load<float>(from);
    case TexelFormat::kR16F: {
      uint16_t half;
      memcpy(&half, from, sizeof half);
      return {HalfToFloat(half), 0, 0, 1};
    }
    case TexelFormat::kR32F: {
      Texel texel{0, 0, 0, 1};
      memcpy(texel.data(), from, sizeof(float));
      return texel;
    }
    default:
      break;
  }
  Texel texel;
  for (uint32_t c = 0; c < 4; ++c) {
    if (format == TexelFormat::kRgba16) {
      texel[c] = DecodeSample(Load<uint16_t>(from)[c], 16, false);
    } else {
      texel[c] = DecodeSample(from[c], 8, format == TexelFormat::kSrgb8Alpha8 && c < 3);
    }
  }
  return texel;
}

void AppendPicture(const Image& image, bool srgb, std::vector<Texel>& texels) {
  const std::vector<float> color = DecodeTable(image.bits, srgb);
  const std::vector<float> alpha = srgb ? DecodeTable(image.bits, false) : color;
  const uint32_t color_channels = image.channels >= 3 ? 3 : 1;
  const bool has_alpha = image.channels % 2 == 0;
  for (uint32_t row = 0; row < image.height; ++row) {
    const uint32_t y = image.height - 1 - row;
    for (uint32_t x = 0; x < image.width; ++x) {
      Texel texel;
      for (uint32_t c = 0; c < 3; ++c)
        texel[c] = color[image.At(x, y, std::min(c, color_channels - 1))];
      texel[3] = has_alpha ? alpha[image.At(x, y, image.channels - 1u)] : 1.0f;
      texels.push_back(texel);
    }
  }
}

TexelFormat FormatFor(std::span<const Image> pictures, const TextureOptions& options) {
  if (options.as_float) return TexelFormat::kRgba32F;
  // One deep layer makes the whole array deep.
  for (const Image& image : pictures) {
    if (image.bits == 16) return TexelFormat::kRgba16;
  }
  return options.srgb ? TexelFormat::kSrgb8Alpha8 : TexelFormat::kRgba8;
}

ir::SamplerState SamplerFor(const TextureOptions& options) {
  ir::SamplerState sampler;
  sampler.wrap_u = options.wrap_u;
  sampler.wrap_v = options.wrap_v;
  sampler.wrap_w = options.is_3d ? options.wrap_w : ir::Wrap::kClamp;
  sampler.filter = options.filter;
  sampler.mip_filter = !options.mipmaps                         ? ir::MipFilter::kNone
                       : options.filter == ir::Filter::kNearest ? ir::MipFilter::kNearest
                                                                : ir::MipFilter::kLinear;
  if (options.max_level) sampler.max_level = static_cast<float>(*options.max_level);
  return sampler;
}

void WeighColors(std::span<Texel> texels, bool divide) {
  for (Texel& texel : texels) {
    const float weight = texel[3] + kLeastOpacity;
    for (size_t c = 0; c < 3; ++c) texel[c] = divide ? texel[c] / weight : texel[c] * weight;
  }
}

Texel MeanTexel(std::span<const Texel> texels, bool alpha_is_opacity) {
  std::array<double, 4> sum{};
  double weights = 0;
  for (const Texel& texel : texels) {
    const double weight = alpha_is_opacity ? double{texel[3]} + double{kLeastOpacity} : 1.0;
    for (size_t c = 0; c < 3; ++c) sum[c] += weight * double{texel[c]};
    sum[3] += double{texel[3]};
    weights += weight;
  }
  Texel mean;
  for (size_t c = 0; c < 3; ++c) mean[c] = static_cast<float>(sum[c] / weights);
  mean[3] = static_cast<float>(sum[3] / static_cast<double>(texels.size()));
  return mean;
}

void BuildLevels(ir::Texture& chain, bool alpha_is_opacity) {
  const bool weigh =
      alpha_is_opacity &&
      std::ranges::any_of(chain.levels[0].texels, [](const Texel& t) { return t[3] != 1.0f; });
  if (!weigh) return ir::BuildMipChain(chain);
  std::vector<Texel> base = chain.levels[0].texels;
  WeighColors(chain.levels[0].texels, false);
  ir::BuildMipChain(chain);
  chain.levels[0].texels = std::move(base);
  for (size_t i = 1; i < chain.levels.size(); ++i) WeighColors(chain.levels[i].texels, true);
}

TextureData EncodeLevels(ir::Texture& chain, TexelFormat format) {
  TextureData data;
  data.format = format;
  data.is_array = chain.is_array;
  data.is_3d = chain.is_3d;
  data.layers = chain.is_array ? chain.levels[0].depth : 1;
  data.sampler = chain.sampler;
  const uint32_t size = TexelBytes(format);
  for (ir::Texture::Level& from : chain.levels) {
    TexelLevel& to = data.levels.emplace_back();
    to.width = from.width;
    to.height = from.height;
    to.depth = chain.is_3d ? from.depth : 1;
    to.bytes.resize(from.texels.size() * size);
    for (size_t i = 0; i < from.texels.size(); ++i)
      Encode(format, from.texels[i], &to.bytes[i * size]);
    std::vector<Texel>().swap(from.texels);
  }
  return data;
}

bool CheckPixels(uint64_t pixels, std::string_view name, SourceRange range,
                 Diagnostics& diagnostics) {
  if (pixels <= kMaxImagePixels) return true;
  diagnostics.Error(DiagnosticKind::kSizeLimit, range,
                    fmt::format("texture '{}' has {} pixels; the limit is {}", Printable(name),
                                pixels, kMaxImagePixels));
  return false;
}

bool CheckPictures(std::span<const Image> pictures, std::string_view name, SourceRange range,
                   Diagnostics& diagnostics) {
  uint64_t pixels = 0;
  for (const Image& image : pictures) {
    if (image.width != pictures[0].width || image.height != pictures[0].height) {
      diagnostics.Error(
          DiagnosticKind::kBadImage, range,
          fmt::format("the layers of texture '{}' differ in size: {} x {} and {} x {}",
                      Printable(name), pictures[0].width, pictures[0].height, image.width,
                      image.height));
      return false;
    }
    pixels += uint64_t{image.width} * image.height;
  }
  return CheckPixels(pixels, name, range, diagnostics);
}

void ReportNoMemory(std::string_view name, SourceRange range, Diagnostics& diagnostics) {
  diagnostics.Error(DiagnosticKind::kOutOfMemory, range,
                    fmt::format("there is not enough memory for texture '{}'", Printable(name)));
}

}  // namespace texgraph::textures
