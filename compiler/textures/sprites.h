// SPDX-License-Identifier: Apache-2.0
// Sprites placed freely over a grid of cells, as the texture that a shader finds them by: an array
// of RGBA32F whose layer k holds, for each cell, the k-th sprite that touches it, the lowest first:
// (offset x, offset y, pattern, 1) with offset = at - cell, pattern -1 where there is none. A
// sprite covers local - offset in [0, 1]^2. Programs that move sprites while they run change a few
// texels.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/textures/texels.h"

namespace texgraph::textures {

inline constexpr uint32_t kMaxSpriteLayers = 64;
inline constexpr uint64_t kMaxSpriteTexels = uint64_t{1} << 22;  // cells times layers

struct Sprite {
  int32_t pattern = 0;
  double x = 0;  // the left lower corner, in cells; a sprite is one cell large
  double y = 0;
};

class SpriteGrid {
 public:
  using Id = uint32_t;
  enum class Failure : uint8_t {
    kNone,
    kNoSuchSprite,
    kNoSuchPattern,   // not in 0 .. patterns - 1
    kOutside,         // touches no cell, or is nowhere: a coordinate that is not finite
    kTooManyInACell,  // more than `layers`
  };
  struct Texel {
    uint32_t x = 0, y = 0, layer = 0;
    std::array<float, 4> value{};
  };

  // A grid of `width` times `height` cells, `layers` sprites in each at most, each of a pattern
  // from 0 to `patterns` - 1. Cells are counted from the left and from v = 0. What of a sprite lies
  // outside of the grid is not shown: the grid does not wrap.
  SpriteGrid(uint32_t width, uint32_t height, uint32_t layers, uint32_t patterns);

  // The new sprite lies over all others. On a failure nothing has changed, here and below.
  Failure Add(const Sprite& sprite, Id& id);
  // The sprite keeps its place above and below the others.
  Failure Move(Id id, const Sprite& to);
  Failure Remove(Id id);

  // The texels that differ from those at the last call (at first: from an empty grid), each once,
  // by layer, then y, then x.
  std::vector<Texel> TakeChanges();
  // All texels: x fastest, then y, then layer.
  const std::vector<std::array<float, 4>>& texels() const { return texels_; }
  uint32_t width() const { return width_; }
  uint32_t height() const { return height_; }
  uint32_t layers() const { return layers_; }

 private:
  struct Cells {  // those that a sprite touches
    std::array<uint32_t, 4> index{};
    uint32_t count = 0;
  };
  Cells CellsOf(const Sprite& sprite) const;
  Failure Check(const Sprite& sprite, const Cells& cells, const Cells& leaving) const;
  void Put(Id id);
  void Take(Id id);
  void WriteCell(uint32_t cell);

  uint32_t width_, height_, layers_, patterns_;
  std::vector<std::optional<Sprite>> sprites_;       // by id
  std::vector<std::vector<Id>> cells_;               // the sprites in each, the lowest first
  std::vector<std::array<float, 4>> texels_, seen_;  // now, and at the last TakeChanges
  std::vector<uint32_t> dirty_;                      // cells that were written since
};

struct PlacedSprite {
  Sprite sprite;
  SourceRange range;
};

// The most sprites in one cell; at least 1. Those outside of the grid count nowhere.
uint32_t SpriteLayersNeeded(std::span<const PlacedSprite> sprites, uint32_t width, uint32_t height);

// The texture: nearest, one level. `layers`, 1 to kMaxSpriteLayers: as many as needed if not given.
// Reported at the sprite, naming `name`: kValueRange for a pattern that is not there, a sprite
// outside of the grid and more than `layers` in a cell; at `range`: kSizeLimit, kOutOfMemory.
std::optional<TextureData> SpritesTexture(std::span<const PlacedSprite> sprites, uint32_t width,
                                          uint32_t height, std::optional<uint32_t> layers,
                                          uint32_t patterns, std::string_view name,
                                          SourceRange range, Diagnostics& diagnostics);

}  // namespace texgraph::textures
