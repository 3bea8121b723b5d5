// SPDX-License-Identifier: Apache-2.0
// The textures of a graph that belong to noise: exemplars, pictures as noise and the tables that
// turn them back, colour maps.
#pragma once

#include <optional>
#include <string>

#include "compiler/base/diagnostics.h"
#include "compiler/base/roots.h"
#include "compiler/graph/graph.h"
#include "compiler/textures/gaussianize.h"
#include "compiler/textures/image.h"
#include "compiler/textures/map_filter.h"

namespace texgraph::manifest {

// Of a texture of kColorMap.
textures::MapFilterOptions MapOptionsOf(const graph::Texture& texture);

// Of kNoise: (mean, mean of the second, variance, variance of the second), all levels. Painted
// spectra are read from `folder`: their red channel.
std::optional<textures::TextureData> MakeNoiseTexture(const graph::Texture& texture,
                                                      const std::string& folder, const Roots& roots,
                                                      Diagnostics& diagnostics);

// Of kGaussian: red, green and blue of the picture.
std::optional<textures::GaussianExemplar> MakeGaussian(const graph::Texture& texture,
                                                       const std::string& folder,
                                                       const Roots& roots,
                                                       Diagnostics& diagnostics);

}  // namespace texgraph::manifest
