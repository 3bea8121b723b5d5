// SPDX-License-Identifier: Apache-2.0
// Gaussian noise with a given power spectrum, as periodic exemplars for tiling and blending (Heitz
// and Neyret 2018): white noise of integer hashes, filtered in the Fourier domain. Zero mean, and
// exactly the standard deviation that was asked for. The numbers are floats of both signs, to be
// stored as halves: nothing clips. docs/decisions/0025-noise-preparation.md has the why.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/textures/gaussian.h"
#include "compiler/textures/plane.h"

namespace texgraph::textures {

inline constexpr uint32_t kMinNoiseSize = 16;
inline constexpr uint32_t kMaxNoiseSize = 2048;
inline constexpr size_t kMaxNoiseChannels = 4;
inline constexpr double kMinBandwidth = 0.25;  // narrower ones would fall between the frequencies
inline constexpr double kMaxStretch = 64;

// All frequencies are in cycles across the exemplar; directions in degrees, counterclockwise from
// the u axis, are those in which waves run. Both a frequency and its opposite always count alike.

struct SpectrumShape {
  double direction = 0;
  // 1: alike in all directions. Else everything is so many times as long across `direction`.
  double stretch = 1;
  // The standard deviation, in degrees, of the directions around `direction`; 0: all alike.
  double spread = 0;
};

// A ring: a Gaussian of the distance from 0, of standard deviation `bandwidth` around `frequency`.
struct BandSpectrum {
  double frequency = 16;
  double bandwidth = 4;
  SpectrumShape shape;
};

// Two round spots at (x, y) and (-x, -y): waves of one direction and length.
struct LobeSpectrum {
  double x = 16;
  double y = 0;
  double bandwidth = 2;
};

// Power proportional to frequency^-exponent from `lowest` to `highest`: 0 white, 2 clouds, 4 hills.
struct PowerLawSpectrum {
  double exponent = 2;
  double lowest = 1;
  double highest = 0;  // 0: as high as the exemplar has them
  SpectrumShape shape;
};

// A picture of the power of each frequency, with 0 in its middle, at texel (width / 2, height / 2).
// It spans all frequencies of the exemplar, whatever its size.
struct PaintedSpectrum {
  Plane power;
};

struct SpectrumPart {
  std::variant<BandSpectrum, LobeSpectrum, PowerLawSpectrum, PaintedSpectrum> kind;
  double share = 1;  // of the variance, beside the other parts
};

// A sum: at least one part.
using NoiseSpectrum = std::vector<SpectrumPart>;

struct NoiseOptions {
  uint32_t size = 256;  // texels a side, a power of two
  uint32_t seed = 0;
  double sigma = kNoiseSigma;
  // How the channels correlate, row by row, with ones on the diagonal; none: each is drawn alone.
  // Each channel keeps its spectrum, so the more two have in common the more they can correlate.
  std::vector<double> correlations = {};
};

// The share of the variance at each frequency of an exemplar of `size`, in the order of
// FourierTransform; the sum is 1, that of frequency 0 is 0. Nothing if no frequency has any.
std::optional<std::vector<double>> PowerOf(const NoiseSpectrum& spectrum, uint32_t size);

// False, and reported at `range` (kValueRange): sizes, numbers and frequencies out of range, what
// leaves no frequency, correlations that are not a symmetric matrix of the channels.
bool CheckNoise(std::span<const NoiseSpectrum> channels, const NoiseOptions& options,
                std::string_view name, SourceRange range, Diagnostics& diagnostics);

// One exemplar for each channel. Their covariances are exact as well. Reported, naming `name`: all
// of CheckNoise, correlations that these spectra cannot have (kValueRange), kOutOfMemory.
std::optional<std::vector<Plane>> MakeNoise(std::span<const NoiseSpectrum> channels,
                                            const NoiseOptions& options, std::string_view name,
                                            SourceRange range, Diagnostics& diagnostics);

}  // namespace texgraph::textures
