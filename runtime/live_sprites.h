// SPDX-License-Identifier: Apache-2.0
// Sprites that a program moves while it draws: the grid of a graph's texture of sprites
// (compiler/textures/sprites.h), and the way of its texels to a renderer. A sprite that moves
// changes those of the cells that it leaves and enters, eight at most in each layer that it is in.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/textures/sprites.h"
#include "runtime/live.h"

namespace texgraph::runtime {

class LiveSprites {
 public:
  // For the texture of that name, as large as the graph made it; there are no sprites at first,
  // whatever the graph has. Reported: kUnknownReference for a texture that the shader does not use,
  // kPortType for one that holds no sprites.
  static std::optional<LiveSprites> Open(const LiveRenderer& renderer, std::string_view texture,
                                         Diagnostics& diagnostics);
  // How many patterns there are: a sprite's is below.
  uint32_t patterns() const { return patterns_; }

  // Places are in cells, from the left lower corner of the map.
  textures::SpriteGrid& grid() { return grid_; }
  // What changed in the grid since the last call, rows of texels that lie beside each other as one;
  // everything at first.
  std::vector<TexelUpdate> TakeUpdates();
  // The same, for the renderer's next picture. How many texels changed; nothing, with the reason
  // reported, if the renderer is another one and its texture does not fit.
  std::optional<size_t> Send(LiveRenderer& renderer, Diagnostics& diagnostics);

 private:
  LiveSprites(std::string texture, const textures::TextureData& data, uint32_t patterns);

  std::string texture_;
  uint32_t patterns_;
  textures::SpriteGrid grid_;
  bool has_sent_ = false;
};

}  // namespace texgraph::runtime
