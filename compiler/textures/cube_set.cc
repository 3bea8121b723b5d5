// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/cube_set.h"

#include <fmt/format.h>
#include <string.h>

#include <algorithm>
#include <new>

#include "compiler/textures/cube_parts.h"
#include "compiler/textures/cube_patches.h"
#include "compiler/textures/texel_chain.h"
#include "compiler/textures/tile_patches.h"
#include "compiler/textures/tile_threads.h"

namespace texgraph::textures {
namespace {

int64_t WrapPlace(int64_t at, int64_t size) {
  const int64_t rest = at % size;
  return rest < 0 ? rest + size : rest;
}

// How much texels on both sides of seams differ, as parts of what is usual.
struct Steps {
  double sum = 0;
  double count = 0;
};

class CubeSetMaker {
 public:
  CubeSetMaker(std::span<const Image> sample, const CubeSetOptions& options)
      : slices_(sample),
        options_(options),
        sample_(sample, options.wraps, ScalesOfCube(options.cube_size)) {
    set_.layout = LayOutCubes(options.colors, options.cube_size);
    Image& pack = set_.pack;
    static_cast<ImageInfo&>(pack) = sample[0];
    pack.width = set_.layout.width();
    pack.height = pack.width * set_.layout.depth();
    pack.pixels.resize(pack.RowBytes() * pack.height);
    for (uint32_t axis = 0; axis < 3; ++axis) usual_[axis] = sample_.MeanStep(axis);
  }

  CubeSet Make();

 private:
  void CopyCube(const CubePlace& cube, const CubeColors& colors, const CubePart& part);
  Steps Measure(const CubeColors& colors, const CubePart& part) const;

  std::span<const Image> slices_;
  const CubeSetOptions& options_;
  CubeSample sample_;
  std::array<double, 3> usual_{};
  CubeSet set_;
};

void CubeSetMaker::CopyCube(const CubePlace& cube, const CubeColors& colors, const CubePart& part) {
  const auto size = static_cast<int32_t>(options_.cube_size);
  const CubePatches patches{sample_, 0, options_.cube_size, set_.corners};
  Image& pack = set_.pack;
  const size_t bytes = size_t{pack.channels} * (pack.bits / 8);
  const uint32_t n = options_.cube_size;
  for (int32_t z = 0; z < size; ++z) {
    for (int32_t y = 0; y < size; ++y) {
      const size_t up = (size_t{cube.z} * n + static_cast<size_t>(z)) * pack.width +
                        size_t{cube.y} * n + static_cast<size_t>(y);
      uint8_t* to = &pack.pixels[pack.RowBytes() * (pack.height - 1 - up) + cube.x * n * bytes];
      for (int32_t x = 0; x < size; ++x, to += bytes) {
        // Patches lie within the sample unless it comes around.
        VoxelPlace from = patches.PlaceOf(colors, part.At({x, y, z}), {x, y, z});
        for (size_t i = 0; i < 3; ++i) from[i] = WrapPlace(from[i], sample_.size()[i]);
        const Image& source = slices_[static_cast<size_t>(from[2])];
        const size_t source_row = source.height - 1 - static_cast<size_t>(from[1]);
        memcpy(
            to,
            &source.pixels[source.RowBytes() * source_row + static_cast<size_t>(from[0]) * bytes],
            bytes);
      }
    }
  }
}

Steps CubeSetMaker::Measure(const CubeColors& colors, const CubePart& part) const {
  const CubePatches patches{sample_, 0, options_.cube_size, set_.corners};
  Steps steps;
  for (size_t i = 0; i < part.labels.size(); ++i) {
    const auto index = static_cast<int32_t>(i);
    const std::array<int32_t, 3> at = {index % part.size[0], index / part.size[0] % part.size[1],
                                       index / part.size[0] / part.size[1]};
    for (uint32_t axis = 0; axis < 3; ++axis) {
      std::array<int32_t, 3> next = at;
      if (++next[axis] == part.size[axis]) continue;
      const uint8_t label = part.At(next);
      if (label == part.labels[i] || !(usual_[axis] > 0)) continue;
      steps.sum += sample_.Difference(0, patches.PlaceOf(colors, part.labels[i], at),
                                      patches.PlaceOf(colors, label, next)) /
                   usual_[axis];
      ++steps.count;
    }
  }
  return steps;
}

CubeSet CubeSetMaker::Make() {
  set_.corners = ChooseCubePatches(sample_, options_);
  const CubeParts parts({sample_, 0, options_.cube_size, set_.corners}, options_.threads);
  const CubePackLayout& layout = set_.layout;
  std::vector<Steps> steps(layout.cubes());
  ForEachTile(layout.cubes(), options_.threads, [&](uint32_t i) {
    const CubePlace place{i % layout.side, i / layout.side % layout.side,
                          i / layout.side / layout.side};
    const CubeColors colors = CubeAt(layout, place.x, place.y, place.z);
    const CubePart part = parts.Cube(colors);
    CopyCube(place, colors, part);
    steps[i] = Measure(colors, part);
  });
  Steps all;
  for (const Steps& cube : steps) {
    all.sum += cube.sum;
    all.count += cube.count;
  }
  set_.seams = all.count > 0 ? all.sum / all.count : 0;
  return std::move(set_);
}

bool CheckSolid(const CubeSetOptions& options, const std::array<uint32_t, 3>& sample,
                std::string_view name, SourceRange range, Diagnostics& diagnostics) {
  const uint32_t least = LeastSolid(options.cube_size, options.wraps);
  const uint32_t side = *std::ranges::min_element(sample);
  if (side >= least) return true;
  std::string advice =
      fmt::format("cubes of {} texels take at least {} each way", options.cube_size, least);
  uint32_t largest = options.cube_size;
  while (largest > 0 && LeastSolid(largest, options.wraps) > side) --largest;
  if (largest >= kMinCubeSize) advice += fmt::format("; cubes of {} texels would do", largest);
  diagnostics.Error(DiagnosticKind::kBadImage, range,
                    fmt::format("the sample of '{}' has {} x {} pixels in {} slices; {}",
                                Printable(name), sample[0], sample[1], sample[2], advice));
  return false;
}

bool CheckSlices(std::span<const Image> slices, std::string_view name, SourceRange range,
                 Diagnostics& diagnostics) {
  if (slices.empty()) {
    diagnostics.Error(DiagnosticKind::kBadImage, range,
                      fmt::format("the cubes of '{}' have no sample", Printable(name)));
    return false;
  }
  if (!CheckPictures(slices, name, range, diagnostics)) return false;
  for (const Image& slice : slices) {
    if (slice.channels == slices[0].channels && slice.bits == slices[0].bits) continue;
    diagnostics.Error(DiagnosticKind::kBadImage, range,
                      fmt::format("the slices of '{}' differ: {} channels of {} bits and {} of {}",
                                  Printable(name), slices[0].channels, slices[0].bits,
                                  slice.channels, slice.bits));
    return false;
  }
  return true;
}

}  // namespace

uint32_t LeastSolid(uint32_t cube_size, bool wraps) {
  return wraps ? 2 * TileReach(cube_size) : 2 * cube_size;
}

uint32_t LargestCube(uint32_t colors) {
  const auto fits = [&](uint32_t size) {
    const CubePackLayout layout = LayOutCubes(colors, size);
    const uint64_t texels = uint64_t{layout.width()} * layout.width() * layout.depth();
    return layout.depth() <= kMaxCubePackSide && texels <= kMaxImagePixels;
  };
  uint32_t size = kMaxCubeSize;
  while (!fits(size)) --size;
  return size;
}

bool CheckCubeSet(const CubeSetOptions& options, const std::array<uint32_t, 3>& sample,
                  std::string_view name, SourceRange range, Diagnostics& diagnostics) {
  const auto limit = [&](std::string message) {
    diagnostics.Error(DiagnosticKind::kSizeLimit, range,
                      fmt::format("the cubes of '{}' {}", Printable(name), message));
    return false;
  };
  if (options.colors < kMinCubeColors || options.colors > kMaxCubeColors) {
    return limit(fmt::format("have {} corner colours; {} to {} are possible", options.colors,
                             kMinCubeColors, kMaxCubeColors));
  }
  const uint32_t largest = LargestCube(options.colors);
  if (options.cube_size < kMinCubeSize || options.cube_size > largest) {
    return limit(fmt::format("have {} texels a side; with {} colours {} to {} are possible",
                             options.cube_size, options.colors, kMinCubeSize, largest));
  }
  if (options.candidates < kMinCubeCandidates || options.candidates > kMaxCubeCandidates) {
    return limit(fmt::format("try {} patches; {} to {} are possible", options.candidates,
                             kMinCubeCandidates, kMaxCubeCandidates));
  }
  return CheckSolid(options, sample, name, range, diagnostics);
}

std::optional<CubeSet> MakeCubeSet(std::span<const Image> slices, const CubeSetOptions& options,
                                   std::string_view name, SourceRange range,
                                   Diagnostics& diagnostics) {
  if (!CheckSlices(slices, name, range, diagnostics) ||
      !CheckCubeSet(options,
                    {slices[0].width, slices[0].height, static_cast<uint32_t>(slices.size())}, name,
                    range, diagnostics)) {
    return std::nullopt;
  }
  try {
    return CubeSetMaker(slices, options).Make();
  } catch (const std::bad_alloc&) {
    ReportNoMemory(name, range, diagnostics);
    return std::nullopt;
  }
}

}  // namespace texgraph::textures
