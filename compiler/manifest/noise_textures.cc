// SPDX-License-Identifier: Apache-2.0
#include "compiler/manifest/noise_textures.h"

#include <new>

#include "compiler/manifest/pictures.h"
#include "compiler/textures/moments.h"
#include "compiler/textures/noise_spectrum.h"
#include "compiler/textures/prepare.h"
#include "compiler/textures/texel_chain.h"

namespace texgraph::manifest {
namespace {

// A graph that was checked can be made.
static_assert(graph::kMinNoiseSize == textures::kMinNoiseSize &&
              graph::kMaxNoiseSize == textures::kMaxNoiseSize &&
              graph::kMinBandwidth == textures::kMinBandwidth &&
              graph::kMaxStretch == textures::kMaxStretch &&
              graph::kMaxDeviations == textures::kMaxMapSigmas);

using graph::NoisePart;
using textures::Plane;

// The first channels of a picture, row 0 at v = 0.
std::vector<Plane> PlanesOf(const textures::Image& image, bool srgb, size_t channels) {
  std::vector<ir::Texel> texels;
  textures::AppendPicture(image, srgb, texels);
  std::vector<Plane> planes(channels, Plane{image.width, image.height, {}});
  for (size_t c = 0; c < channels; ++c) {
    planes[c].values.reserve(texels.size());
    for (const ir::Texel& texel : texels) planes[c].values.push_back(texel[c]);
  }
  return planes;
}

class NoiseReader {
 public:
  NoiseReader(const graph::Texture& texture, const std::string& folder, const Roots& roots,
              Diagnostics& diagnostics)
      : texture_(texture), folder_(folder), roots_(roots), diagnostics_(diagnostics) {}

  std::optional<textures::NoiseSpectrum> Spectrum(const std::vector<NoisePart>& parts) const {
    textures::NoiseSpectrum spectrum;
    for (const NoisePart& part : parts) {
      textures::SpectrumPart& to = spectrum.emplace_back();
      to.share = part.share;
      const textures::SpectrumShape shape{part.direction, part.stretch, part.spread};
      switch (part.kind) {
        case NoisePart::Kind::kBand:
          to.kind = textures::BandSpectrum{part.frequency[0], part.bandwidth, shape};
          break;
        case NoisePart::Kind::kLobes:
          to.kind = textures::LobeSpectrum{part.frequency[0], part.frequency[1], part.bandwidth};
          break;
        case NoisePart::Kind::kPowerLaw:
          to.kind = textures::PowerLawSpectrum{part.exponent, part.lowest, part.highest, shape};
          break;
        case NoisePart::Kind::kPainted: {
          const auto picture =
              textures::ReadPicture(PictureOf(texture_, part.file, folder_), diagnostics_, roots_);
          if (!picture) return std::nullopt;
          to.kind = textures::PaintedSpectrum{std::move(PlanesOf(*picture, false, 1)[0])};
          break;
        }
      }
    }
    return spectrum;
  }

 private:
  const graph::Texture& texture_;
  const std::string& folder_;
  const Roots& roots_;
  Diagnostics& diagnostics_;
};

}  // namespace

textures::MapFilterOptions MapOptionsOf(const graph::Texture& texture) {
  textures::MapFilterOptions options;
  options.sigmas = texture.deviations;
  return options;
}

std::optional<textures::TextureData> MakeNoiseTexture(const graph::Texture& texture,
                                                      const std::string& folder, const Roots& roots,
                                                      Diagnostics& diagnostics) {
  try {
    const NoiseReader reader(texture, folder, roots, diagnostics);
    std::vector<textures::NoiseSpectrum> channels;
    for (const std::vector<NoisePart>& parts : texture.noise.spectra) {
      if (parts.empty()) continue;
      auto spectrum = reader.Spectrum(parts);
      if (!spectrum) return std::nullopt;
      channels.push_back(std::move(*spectrum));
    }
    textures::NoiseOptions options;
    options.size = texture.noise.size;
    options.seed = texture.noise.seed;
    const auto planes =
        textures::MakeNoise(channels, options, texture.name, texture.range, diagnostics);
    if (!planes) return std::nullopt;
    const auto moments = textures::MakeMoments(*planes, texture.name, texture.range, diagnostics);
    if (!moments) return std::nullopt;
    return textures::PackMoments(*moments, textures::MomentFormat::kHalves, false).moments;
  } catch (const std::bad_alloc&) {
    textures::ReportNoMemory(texture.name, texture.range, diagnostics);
    return std::nullopt;
  }
}

std::optional<textures::GaussianExemplar> MakeGaussian(const graph::Texture& texture,
                                                       const std::string& folder,
                                                       const Roots& roots,
                                                       Diagnostics& diagnostics) {
  const auto picture = textures::ReadPicture(PictureOf(texture, 0, folder), diagnostics, roots);
  if (!picture) return std::nullopt;
  try {
    const std::vector<Plane> planes =
        PlanesOf(*picture, texture.color_space == graph::ColorSpace::kSrgb, 3);
    return textures::Gaussianize(planes, {}, texture.name, texture.range, diagnostics);
  } catch (const std::bad_alloc&) {
    textures::ReportNoMemory(texture.name, texture.range, diagnostics);
    return std::nullopt;
  }
}

}  // namespace texgraph::manifest
