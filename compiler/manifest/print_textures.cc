// SPDX-License-Identifier: Apache-2.0
#include "compiler/manifest/print_textures.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "compiler/base/files.h"
#include "compiler/base/text.h"
#include "compiler/manifest/graph_textures.h"
#include "compiler/manifest/pictures.h"

namespace texgraph::manifest {
namespace {

using Entry = glsl::ShaderInterface::Entry;
using graph::TextureKind;
using textures::TexelFormat;

std::string_view WrapName(graph::TextureWrap wrap) {
  switch (wrap) {
    case graph::TextureWrap::kRepeat:
      return "repeat";
    case graph::TextureWrap::kClamp:
      return "clamp";
    case graph::TextureWrap::kMirror:
      return "mirror";
  }
  return {};
}

std::string_view FormatName(TexelFormat format) {
  switch (format) {
    case TexelFormat::kRgba8:
      return "rgba8";
    case TexelFormat::kSrgb8Alpha8:
      return "srgb8_alpha8";
    case TexelFormat::kRgba16:
      return "rgba16";
    case TexelFormat::kRgba16F:
      return "rgba16f";
    case TexelFormat::kRgba32F:
      return "rgba32f";
    case TexelFormat::kR16F:
      return "r16f";
    case TexelFormat::kR32F:
      return "r32f";
  }
  return {};
}

std::string SidesJson(const std::array<uint32_t, 2>& sides) {
  return JsonList({std::to_string(sides[0]), std::to_string(sides[1])});
}

// What the numbers of a map count.
std::string_view ThingsOf(const graph::Graph& graph, const graph::Texture& texture) {
  if (!texture.of) return "numbers";
  const TextureKind kind = graph.textures[*texture.of].kind;
  return kind == TextureKind::kLists ? "lists" : kind == TextureKind::kTiles ? "tiles" : "patterns";
}

class TexturePrinter {
 public:
  TexturePrinter(const TextureSection& section, uint32_t index, JsonWriter& json)
      : section_(section),
        graph_(section.graph),
        texture_(section.graph.textures[index]),
        index_(index),
        json_(json) {
    first_ = graph::FirstEqualTexture(graph_, index);
    for (const Entry& entry : section_.shader.textures) {
      const ir::Global& global = section_.module.globals[entry.global.index];
      if (global.name == graph_.textures[first_].name) entry_ = &entry;
    }
    for (const DerivedTexture& derived : section_.derived) {
      if (derived.texture == first_) data_ = derived.data.get();
    }
  }

  void Print() {
    json_.OpenObject();
    json_.String("name", texture_.name);
    json_.String("type", texture_.is_3d      ? "sampler3D"
                         : texture_.is_array ? "sampler2DArray"
                                             : "sampler2D");
    json_.String("status", entry_ ? "used" : texture_.is_constant ? "folded" : "unused");
    if (entry_) {
      json_.String("variable", entry_->name);
      PrintNumber("location", entry_->location);
      PrintNumber("binding", entry_->binding);
    }
    PrintFiles();
    if (data_) PrintShape();
    if (texture_.HasPatterns() && texture_.IsDerived()) PrintPatterns();
    if (texture_.kind == TextureKind::kTiles) PrintTileLayout(LayoutInLayers(), json_);
    if (texture_.kind == TextureKind::kCubes) PrintCubes();
    if (texture_.IsMap()) PrintMap();
    PrintSampling();
    json_.CloseObject();
  }

 private:
  void PrintNumber(std::string_view key, uint32_t number) {
    if (number != glsl::ShaderInterface::kNone) json_.Integer(key, number);
  }

  // What the shader does not sample is not made: then the files are the sources.
  void PrintFiles() {
    const bool is_derived = texture_.IsDerived() && entry_;
    const bool is_prepared = texture_.IsPrepared() && section_.options.prepare_files && entry_;
    if (!is_derived && !is_prepared) {
      json_.Raw("files", JsonList(Sources()));
      PrintPreparation();
      return;
    }
    std::vector<std::string> files;
    if (is_derived) {
      files.push_back(JsonQuoted(DerivedName(graph_, index_)));
    } else {
      for (size_t layer = 0; layer < texture_.files.size(); ++layer)
        files.push_back(JsonQuoted(PreparedName(graph_, index_, layer)));
    }
    json_.Raw("files", JsonList(files));
    const bool is_corners = texture_.kind == TextureKind::kCorners;
    const bool is_means = texture_.kind == TextureKind::kMeans;
    if (texture_.files.empty() && !is_means && !is_corners) return;
    json_.OpenObject("prepared_from");
    if (is_corners) {
      json_.String("tiles", graph_.textures[*texture_.of].name);
    } else if (is_means) {
      json_.String("map", graph_.textures[*texture_.of].name);
    } else {
      json_.Raw("files", JsonList(Sources()));
    }
    PrintPreparation();
    json_.CloseObject();
  }

  std::vector<std::string> Sources() const {
    std::vector<std::string> files;
    for (std::string_view file : texture_.files) files.push_back(FileJson(file));
    return files;
  }

  std::string FileJson(std::string_view file) const {
    const std::string path = JoinPath(section_.graph_folder, file);
    return JsonQuoted(file.starts_with('/') ? path
                                            : RelativePath(path, section_.options.manifest_folder));
  }

  void PrintPreparation() {
    if (!texture_.masks.empty()) {
      static constexpr std::string_view kChannels[] = {"red", "green", "blue", "alpha"};
      json_.OpenList("masks");
      for (const graph::Mask& mask : texture_.masks) {
        json_.OpenObject();
        json_.Raw("file", FileJson(mask.file));
        json_.String("channel", kChannels[static_cast<size_t>(mask.channel)]);
        json_.Bool("invert", mask.invert);
        json_.CloseObject();
      }
      json_.CloseList();
    }
    if (!texture_.key) return;
    json_.OpenObject("key");
    std::vector<std::string> numbers;
    for (double number : texture_.key->color) numbers.push_back(DoubleText(number));
    json_.Raw("color", JsonList(numbers));
    json_.Raw("tolerance", DoubleText(texture_.key->tolerance));
    json_.Integer("edge", texture_.key->edge);
    json_.CloseObject();
  }

  void PrintShape() {
    json_.String("format", FormatName(data_->format));
    const textures::TexelLevel& base = data_->levels[0];
    std::vector<std::string> size = {std::to_string(base.width), std::to_string(base.height)};
    if (data_->is_array) size.push_back(std::to_string(data_->layers));
    if (data_->is_3d) size.push_back(std::to_string(base.depth));
    json_.Raw("size", JsonList(size));
    json_.Integer("levels", static_cast<long long>(data_->levels.size()));
  }

  void PrintPatterns() {
    json_.Integer("patterns", texture_.PatternCount());
    if (texture_.pack == graph::TexturePack::kAtlas) PrintSides("grid", texture_.grid);
  }

  void PrintSides(std::string_view key, const std::array<uint32_t, 2>& sides) {
    json_.Raw(key, SidesJson(sides));
  }

  void PrintCubes() {
    const textures::CubePackLayout layout =
        textures::LayOutCubes(texture_.tiles.colors[0], texture_.tiles.size);
    json_.OpenObject("cubes");
    json_.Integer("corner_colors", layout.colors);
    json_.Integer("cube_size", layout.cube_size);
    const std::string side = std::to_string(layout.side);
    json_.Raw("pack", JsonList({side, side, std::to_string(layout.layers)}));
    json_.CloseObject();
  }

  void PrintMap() {
    json_.OpenObject("map");
    if (texture_.kind == TextureKind::kSprites) {
      json_.String("holds", "sprites");
      PrintSides("cells", {texture_.sprites.columns, texture_.sprites.rows});
      json_.Integer("layers", texture_.sprites.layers);
    } else {
      json_.String("holds", ThingsOf(graph_, texture_));
      PrintSides("cells", {texture_.map.width, texture_.map.height});
    }
    if (const auto reach = graph::ReachOf(graph_, texture_)) {
      json_.String("of", reach->name);
      json_.Integer("count", reach->count);
    }
    json_.CloseObject();
  }

  // As the texture has them.
  textures::TilePackLayout LayoutInLayers() const {
    textures::TilePackLayout layout = TileLayoutOf(texture_);
    if (!texture_.is_array) return layout;
    layout.columns = layout.rows = 2;
    layout.gutter = 0;
    return layout;
  }

  void PrintSampling() {
    json_.String("alpha", texture_.alpha_is_opacity ? "opacity" : "data");
    // What was made with 16 bits was decoded before.
    const bool srgb = data_ ? data_->format == TexelFormat::kSrgb8Alpha8
                            : texture_.color_space == graph::ColorSpace::kSrgb;
    json_.String("color_space", srgb ? "srgb" : "linear");
    json_.String("filter", texture_.filter == graph::TextureFilter::kLinear ? "linear" : "nearest");
    std::vector<std::string> wraps = {JsonQuoted(WrapName(texture_.wrap_u)),
                                      JsonQuoted(WrapName(texture_.wrap_v))};
    if (texture_.is_3d) wraps.push_back(JsonQuoted(WrapName(texture_.wrap_w)));
    json_.Raw("wrap", JsonList(wraps));
    json_.Bool("mipmaps", texture_.mipmaps);
    const bool is_pack = texture_.pack == graph::TexturePack::kAtlas || texture_.HasTiles() ||
                         texture_.kind == TextureKind::kCorners;
    if (data_ && is_pack) {
      json_.Integer("max_level", static_cast<long long>(data_->levels.size()) - 1);
    } else if (texture_.max_level) {
      json_.Integer("max_level", *texture_.max_level);
    }
  }

  const TextureSection& section_;
  const graph::Graph& graph_;
  const graph::Texture& texture_;
  const uint32_t index_;
  JsonWriter& json_;
  uint32_t first_ = 0;                           // of equal textures
  const Entry* entry_ = nullptr;                 // in the shader, if it is there
  const textures::TextureData* data_ = nullptr;  // if it was made
};

}  // namespace

void PrintTileLayout(const textures::TilePackLayout& layout, JsonWriter& json) {
  json.OpenObject("tiles");
  if (layout.kind == textures::TileKind::kWang) {
    json.Raw("edge_colors", SidesJson(layout.colors));
  } else {
    json.Integer("corner_colors", layout.colors[0]);
  }
  json.Integer("tile_size", layout.tile_size);
  json.Raw("pack", SidesJson({layout.columns, layout.rows}));
  json.Integer("gutter", layout.gutter);
  json.CloseObject();
}

void PrintTextures(const TextureSection& section, JsonWriter& json) {
  json.OpenList("textures");
  for (uint32_t i = 0; i < section.graph.textures.size(); ++i) {
    TexturePrinter(section, i, json).Print();
  }
  json.CloseList();
}

}  // namespace texgraph::manifest
