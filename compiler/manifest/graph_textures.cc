// SPDX-License-Identifier: Apache-2.0
#include "compiler/manifest/graph_textures.h"

#include <fmt/format.h>

#include <map>
#include <memory>
#include <utility>

#include "compiler/manifest/noise_textures.h"
#include "compiler/manifest/pictures.h"
#include "compiler/textures/cube_levels.h"
#include "compiler/textures/maps.h"
#include "compiler/textures/means.h"
#include "compiler/textures/sheets.h"
#include "compiler/textures/sprites.h"
#include "compiler/textures/tile_levels.h"
#include "compiler/textures/tile_pictures.h"

namespace texgraph::manifest {
namespace {

// A graph that was checked can be written.
static_assert(graph::kMaxSpriteTexels == textures::kMaxSpriteTexels &&
              graph::kMaxSpriteLayers == textures::kMaxSpriteLayers);
static_assert(graph::kMinTileSize == textures::kMinTileSize &&
              graph::kMaxTileColors == textures::kMaxTileColors &&
              graph::kMaxTileCandidates == textures::kMaxTileCandidates);
static_assert(graph::kMinCubeSize == textures::kMinCubeSize &&
              graph::kMaxCubeSize == textures::kMaxCubeSize &&
              graph::kMaxCubeColors == textures::kMaxCubeColors &&
              graph::kMaxCubeCandidates == textures::kMaxCubeCandidates &&
              graph::kMinTileCandidates == textures::kMinCubeCandidates);

using graph::TextureKind;
using textures::TextureData;

using Pictures = std::shared_ptr<const std::vector<textures::Image>>;
using Tiles = std::shared_ptr<const textures::TileSet>;
using Exemplar = std::shared_ptr<const textures::GaussianExemplar>;

class Maker {
 public:
  Maker(const graph::Graph& graph, const std::string& folder, const Roots& roots,
        Diagnostics& diagnostics)
      : graph_(graph), folder_(folder), roots_(roots), diagnostics_(diagnostics) {}

  // Says that the texture of that index will be made. Pictures that several of these are made of
  // are then read once.
  void Announce(uint32_t index) {
    const graph::Texture& texture = graph_.textures[index];
    std::optional<uint32_t> pictures = index;
    if (texture.kind == TextureKind::kMeans) pictures = graph::PatternsOf(graph_, index);
    const bool is_tiles =
        texture.kind == TextureKind::kTiles || texture.kind == TextureKind::kCorners;
    if (is_tiles) ++tile_readers_[SetOf(PackOf(index))].count;
    const bool is_gaussian =
        texture.kind == TextureKind::kGaussian || texture.kind == TextureKind::kTable;
    if (is_gaussian) ++exemplar_readers_[ExemplarOf(index)].count;
    const bool is_noise = texture.kind == TextureKind::kNoise || is_gaussian;
    if (texture.IsMap() || is_tiles || is_noise || !pictures) return;
    ++readers_[graph::FirstEqualTexture(graph_, *pictures)].count;
  }

  std::optional<TextureData> Make(uint32_t index) {
    const graph::Texture& texture = graph_.textures[index];
    switch (texture.kind) {
      case TextureKind::kFile:
      case TextureKind::kLayers:
      case TextureKind::kSheet:
        return MakePictures(texture, index);
      case TextureKind::kMap:
      case TextureKind::kLists:
      case TextureKind::kTiling:
      case TextureKind::kPermutation:
        return textures::MapTexture(texture.map);
      case TextureKind::kTiles:
      case TextureKind::kCorners:
        return MakeTiles(texture, index);
      case TextureKind::kCubes:
        return MakeCubes(texture, index);
      case TextureKind::kSprites:
        return MakeSprites(texture);
      case TextureKind::kMeans:
        return MakeMeans(texture, index);
      case TextureKind::kNoise:
        return MakeNoiseTexture(texture, folder_, roots_, diagnostics_);
      case TextureKind::kGaussian:
      case TextureKind::kTable:
        return MakeExemplar(texture, index);
      case TextureKind::kColorMap:
        return MakeColorMap(texture, index);
    }
    return std::nullopt;
  }

 private:
  // Those of ReadPictures, kept while another texture is to be made of them.
  Pictures PicturesOf(uint32_t index) {
    const uint32_t first = graph::FirstEqualTexture(graph_, index);
    const auto reader = readers_.find(first);
    if (reader == readers_.end()) return ReadPictures(graph_.textures[index]);
    Reader& kept = reader->second;
    if (!kept.pictures) kept.pictures = ReadPictures(graph_.textures[first]);
    --kept.count;
    return kept.count == 0 ? std::exchange(kept.pictures, nullptr) : kept.pictures;
  }

  // One picture for each pattern; null, and reported, if one cannot be read.
  Pictures ReadPictures(const graph::Texture& texture) {
    std::vector<textures::Image> pictures;
    for (size_t layer = 0; layer < texture.files.size(); ++layer) {
      auto picture =
          textures::ReadPicture(PictureOf(texture, layer, folder_), diagnostics_, roots_);
      if (!picture) return nullptr;
      pictures.push_back(std::move(*picture));
    }
    const bool is_solid = texture.kind == TextureKind::kCubes && texture.files.size() == 1;
    if (texture.kind == TextureKind::kSheet || is_solid) {
      auto cut = textures::CutSheet(pictures[0], texture.grid[0], texture.grid[1], texture.name,
                                    texture.grid_range, diagnostics_);
      if (!cut) return nullptr;
      pictures = std::move(*cut);
    }
    return std::make_shared<const std::vector<textures::Image>>(std::move(pictures));
  }

  std::optional<TextureData> MakePictures(const graph::Texture& texture, uint32_t index) {
    const Pictures pictures = PicturesOf(index);
    if (!pictures) return std::nullopt;
    const textures::TextureOptions options = OptionsOf(texture);
    if (texture.pack == graph::TexturePack::kAtlas) {
      return textures::MakeAtlas(*pictures, texture.grid[0], options, texture.name, texture.range,
                                 diagnostics_);
    }
    return textures::MakeTexture(*pictures, options, texture.name, texture.range, diagnostics_);
  }

  std::optional<TextureData> MakeSprites(const graph::Texture& texture) {
    const graph::SpriteMap& map = texture.sprites;
    std::vector<textures::PlacedSprite> sprites;
    for (size_t i = 0; i < map.sprites.size(); ++i) {
      const graph::Sprite& sprite = map.sprites[i];
      sprites.push_back({{sprite.pattern, sprite.at[0], sprite.at[1]}, map.ranges[i]});
    }
    const auto patterns = texture.of ? graph_.textures[*texture.of].PatternCount()
                                     : static_cast<uint32_t>(graph::kMaxMapNumber) + 1;
    return textures::SpritesTexture(sprites, map.columns, map.rows, map.layers, patterns,
                                    texture.name, texture.range, diagnostics_);
  }

  // The tiles whose corners these are, or itself.
  uint32_t PackOf(uint32_t index) const {
    const graph::Texture& texture = graph_.textures[index];
    return texture.kind == TextureKind::kCorners ? *texture.of : index;
  }
  // The tiles that those of this texture are cut like, or itself.
  uint32_t SetOf(uint32_t index) const { return graph_.textures[index].of.value_or(index); }
  bool IsOfSet(uint32_t index, uint32_t set) const {
    return graph_.textures[index].kind == TextureKind::kTiles && SetOf(index) == set;
  }

  // A pack for each texture of the set, in their order; null, and reported, if there are none.
  Tiles TilesOf(uint32_t set) {
    const auto reader = tile_readers_.find(set);
    if (reader == tile_readers_.end()) return CutTiles(set);
    TileReader& kept = reader->second;
    if (!kept.tiles) kept.tiles = CutTiles(set);
    --kept.count;
    return kept.count == 0 ? std::exchange(kept.tiles, nullptr) : kept.tiles;
  }

  Tiles CutTiles(uint32_t set) {
    std::vector<textures::Image> maps;
    std::vector<double> weights;
    for (uint32_t t = 0; t < graph_.textures.size(); ++t) {
      if (!IsOfSet(t, set)) continue;
      const graph::Texture& map = graph_.textures[t];
      auto picture = textures::ReadPicture(PictureOf(map, 0, folder_), diagnostics_, roots_);
      if (!picture) return nullptr;
      maps.push_back(std::move(*picture));
      weights.push_back(map.tiles.weight);
    }
    const graph::Texture& texture = graph_.textures[set];
    auto tiles = textures::MakeTileSet(maps, weights, TileOptionsOf(texture), texture.name,
                                       texture.range, diagnostics_);
    if (!tiles) return nullptr;
    return std::make_shared<const textures::TileSet>(std::move(*tiles));
  }

  std::optional<TextureData> MakeTiles(const graph::Texture& texture, uint32_t index) {
    const uint32_t shown = PackOf(index);
    const uint32_t set = SetOf(shown);
    const Tiles tiles = TilesOf(set);
    if (!tiles) return std::nullopt;
    size_t pack = 0;
    for (uint32_t t = 0; t < shown; ++t) pack += IsOfSet(t, set);
    const auto make = shown == index ? textures::MakeTileTexture : textures::MakeCornerTexture;
    return make(tiles->packs[pack], tiles->layout, OptionsOf(texture), texture.name, texture.range,
                diagnostics_);
  }

  // Of a Gaussian picture, and of the table that turns it back: the first of equal pictures.
  uint32_t ExemplarOf(uint32_t index) const {
    return graph::FirstEqualTexture(graph_, graph_.textures[index].of.value_or(index));
  }

  std::optional<TextureData> MakeExemplar(const graph::Texture& texture, uint32_t index) {
    const uint32_t first = ExemplarOf(index);
    const auto turn = [&]() -> Exemplar {
      auto made = MakeGaussian(graph_.textures[first], folder_, roots_, diagnostics_);
      if (!made) return nullptr;
      return std::make_shared<const textures::GaussianExemplar>(std::move(*made));
    };
    const auto reader = exemplar_readers_.find(first);
    Exemplar exemplar;
    if (reader == exemplar_readers_.end()) {
      exemplar = turn();
    } else {
      ExemplarReader& kept = reader->second;
      if (!kept.exemplar) kept.exemplar = turn();
      exemplar = --kept.count == 0 ? std::exchange(kept.exemplar, nullptr) : kept.exemplar;
    }
    if (!exemplar) return std::nullopt;
    return texture.kind == TextureKind::kTable ? textures::TableTexture(*exemplar)
                                               : textures::NoiseTexture(*exemplar);
  }

  std::optional<TextureData> MakeColorMap(const graph::Texture& texture, uint32_t index) {
    const Pictures pictures = PicturesOf(index);
    if (!pictures) return std::nullopt;
    return textures::MakeColorMap((*pictures)[0], OptionsOf(texture), MapOptionsOf(texture),
                                  texture.name, texture.range, diagnostics_);
  }

  std::optional<TextureData> MakeCubes(const graph::Texture& texture, uint32_t index) {
    const Pictures slices = PicturesOf(index);
    if (!slices) return std::nullopt;
    const auto cubes = textures::MakeCubeSet(*slices, CubeOptionsOf(texture), texture.name,
                                             texture.range, diagnostics_);
    if (!cubes) return std::nullopt;
    return textures::MakeCubeTexture(*cubes, OptionsOf(texture), texture.name, texture.range,
                                     diagnostics_);
  }

  // The means of the patterns that a map, perhaps by way of lists, leads to.
  std::optional<TextureData> MakeMeans(const graph::Texture& texture, uint32_t index) {
    const std::optional<uint32_t> found = graph::PatternsOf(graph_, index);
    if (!found) return std::nullopt;
    const graph::Texture& patterns = graph_.textures[*found];
    const Pictures pictures = PicturesOf(*found);
    if (!pictures) return std::nullopt;
    // However the patterns are packed, their means are those of single layers.
    textures::TextureOptions options = OptionsOf(patterns);
    options.is_array = true;
    options.is_3d = options.mipmaps = options.match_edges = false;
    options.weights.clear();
    const auto layers =
        textures::MakeTexture(*pictures, options, patterns.name, patterns.range, diagnostics_);
    if (!layers) return std::nullopt;
    std::vector<textures::MeanColor> means =
        textures::PatternMeans(*layers, patterns.alpha_is_opacity);
    const graph::Texture& map = graph_.textures[*texture.of];
    const graph::Texture& counted = graph_.textures[*map.of];
    if (counted.kind == TextureKind::kLists) {
      means = textures::ListMeans(counted.map, means, patterns.alpha_is_opacity);
    }
    return textures::MeansTexture(map.map, means, texture.dithered, patterns.alpha_is_opacity,
                                  texture.name, texture.range, diagnostics_);
  }

  struct Reader {
    uint32_t count = 0;  // of the textures that are still to be made of them
    Pictures pictures;
  };

  struct TileReader {
    uint32_t count = 0;
    Tiles tiles;
  };

  struct ExemplarReader {
    uint32_t count = 0;
    Exemplar exemplar;
  };

  const graph::Graph& graph_;
  const std::string& folder_;
  const Roots& roots_;
  Diagnostics& diagnostics_;
  std::map<uint32_t, TileReader> tile_readers_;          // by the set
  std::map<uint32_t, ExemplarReader> exemplar_readers_;  // by the first of equal pictures
  std::map<uint32_t, Reader> readers_;                   // by the first of equal textures
};

}  // namespace

textures::TextureOptions OptionsOf(const graph::Texture& texture) {
  textures::TextureOptions options;
  options.srgb = texture.color_space == graph::ColorSpace::kSrgb;
  options.alpha_is_opacity = texture.alpha_is_opacity;
  options.mipmaps = texture.mipmaps;
  if (texture.max_level) options.max_level = static_cast<uint32_t>(*texture.max_level);
  options.filter =
      texture.filter == graph::TextureFilter::kNearest ? ir::Filter::kNearest : ir::Filter::kLinear;
  options.wrap_u = static_cast<ir::Wrap>(texture.wrap_u);
  options.wrap_v = static_cast<ir::Wrap>(texture.wrap_v);
  options.wrap_w = static_cast<ir::Wrap>(texture.wrap_w);
  options.is_array = texture.is_array;
  options.is_3d = texture.is_3d;
  options.match_edges = texture.match_edges;
  options.edge_groups = texture.edge_groups;
  options.weights = texture.weights;
  return options;
}

textures::TilePackLayout TileLayoutOf(const graph::Texture& texture) {
  const graph::TileSetting& tiles = texture.tiles;
  return textures::LayOutTiles(
      tiles.has_edge_colors ? textures::TileKind::kWang : textures::TileKind::kCorner, tiles.colors,
      tiles.size);
}

textures::TileSetOptions TileOptionsOf(const graph::Texture& texture) {
  const graph::TileSetting& tiles = texture.tiles;
  textures::TileSetOptions options;
  options.kind = tiles.has_edge_colors ? textures::TileKind::kWang : textures::TileKind::kCorner;
  options.colors = tiles.colors;
  options.tile_size = tiles.size;
  options.wraps = tiles.wraps;
  options.seed = tiles.seed;
  options.candidates = tiles.candidates;
  options.own_middles = tiles.own_middles;
  options.even = tiles.even;
  return options;
}

textures::CubeSetOptions CubeOptionsOf(const graph::Texture& texture) {
  const graph::TileSetting& cubes = texture.tiles;
  textures::CubeSetOptions options;
  options.colors = cubes.colors[0];
  options.cube_size = cubes.size;
  options.wraps = cubes.wraps;
  options.seed = cubes.seed;
  options.candidates = cubes.candidates;
  return options;
}

std::optional<TextureData> MakeGraphTexture(const graph::Graph& graph, uint32_t index,
                                            const std::string& folder, const Roots& roots,
                                            Diagnostics& diagnostics) {
  return Maker(graph, folder, roots, diagnostics).Make(index);
}

std::string DerivedName(const graph::Graph& graph, uint32_t texture) {
  const graph::Texture& first = graph.textures[graph::FirstEqualTexture(graph, texture)];
  return fmt::format("{}.{}.ktx2", graph.name, first.name);
}

std::optional<std::vector<DerivedTexture>> DeriveTextures(const graph::Graph& graph,
                                                          const std::vector<bool>& used,
                                                          const std::string& folder,
                                                          const Roots& roots,
                                                          Diagnostics& diagnostics) {
  std::vector<uint32_t> made;
  for (uint32_t t = 0; t < graph.textures.size(); ++t) {
    if (used[t] && graph.textures[t].IsDerived() && graph::FirstEqualTexture(graph, t) == t) {
      made.push_back(t);
    }
  }
  Maker maker(graph, folder, roots, diagnostics);
  for (uint32_t t : made) maker.Announce(t);
  std::vector<DerivedTexture> derived;
  for (uint32_t t : made) {
    auto data = maker.Make(t);
    if (!data) return std::nullopt;
    derived.push_back({t, std::make_shared<const TextureData>(std::move(*data))});
  }
  return derived;
}

}  // namespace texgraph::manifest
