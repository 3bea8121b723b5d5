// SPDX-License-Identifier: Apache-2.0
// The section "textures" of a graph: pictures, patterns that are packed together, sets of tiles
// or cubes made of a sample, noise and what it is drawn with, and maps of whole numbers. What a
// texture says of others ("of", "edges", "weights", "means") is resolved and checked; what stands
// in files is not looked at, except that a map's picture is decoded later (compiler/prepare).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/base/number_map.h"
#include "compiler/base/source.h"

namespace texgraph::graph {

enum class ColorSpace : uint8_t { kSrgb, kLinear };  // "srgb"; "linear" (also "data")
enum class TextureFilter : uint8_t { kLinear, kNearest };
enum class TextureWrap : uint8_t { kRepeat, kClamp, kMirror };

enum class MaskChannel : uint8_t { kRed, kGreen, kBlue, kAlpha };

struct Mask {  // "mask.png", or { "file": "mask.png", "channel": "red", "invert": false }
  std::string_view file;
  SourceRange range;
  MaskChannel channel = MaskChannel::kRed;
  bool invert = false;
  bool operator==(const Mask& other) const {
    return file == other.file && channel == other.channel && invert == other.invert;
  }
};

// "key": what textures::ColorKey is.
struct ColorKey {
  std::array<double, 3> color{};  // in the picture's own numbers, 0 to 1
  double tolerance = 0.05;        // of each channel, from 0 to below 1
  int edge = 2;                   // in texels, 0 to 64
  bool operator==(const ColorKey&) const = default;
};

// By the key that says what it is made of.
enum class TextureKind : uint8_t {
  kFile,
  kLayers,
  kSheet,
  kMap,
  kLists,
  kSprites,
  kMeans,
  kTiles,
  kTiling,
  kCorners,
  kPermutation,
  kNoise,
  kGaussian,
  kTable,
  kColorMap,
  kCubes,
};

std::string_view KindText(TextureKind kind);  // "a map"

// "pack": how the patterns of layers or a sheet lie in one texture, or tiles: in layers of 2 x 2, or
// all in one picture.
enum class TexturePack : uint8_t { kArray, kAtlas, kVolume };

// What tiles are made of a sample: textures::TileSetOptions. Of cubes textures::CubeSetOptions,
// with corners alone.
struct TileSetting {
  bool has_edge_colors = false;  // "edge_colors", else "corner_colors"
  // Of corners, twice the same; or of edges that lie and of those that stand.
  std::array<uint32_t, 2> colors = {2, 2};
  uint32_t size = 256;  // texels, kMinTileSize to kMaxTileSize
  bool wraps = false;   // "wrap": whether the sample repeats
  uint32_t seed = 0;
  uint32_t candidates = 256;  // kMinTileCandidates to kMaxTileCandidates
  bool own_middles = false;
  bool even = false;
  double weight = 1;  // of this map where seams are searched, 0 to kMaxWeight
  bool operator==(const TileSetting&) const = default;
};

// A part of a spectrum: textures::SpectrumPart. Frequencies in cycles across the exemplar,
// directions in degrees.
struct NoisePart {
  enum class Kind : uint8_t { kBand, kLobes, kPowerLaw, kPainted };
  Kind kind = Kind::kBand;
  std::array<double, 2> frequency{};  // of a band the first
  double bandwidth = 1;
  double exponent = 0;
  double lowest = 1;
  double highest = 0;  // 0: no limit
  double direction = 0;
  double stretch = 1;
  double spread = 0;  // 0: alike in all directions
  double share = 1;
  size_t file = 0;  // of a painted one, in Texture::files
  bool operator==(const NoisePart&) const = default;
};

struct NoiseSetting {
  uint32_t size = 256;  // texels a side, a power of two
  uint32_t seed = 0;
  // Of each noise the sum of these; the second may have none: then it is 0.
  std::array<std::vector<NoisePart>, 2> spectra;
  bool operator==(const NoiseSetting&) const = default;
};

struct LegendColor {  // "#3a7d2c", in the picture's own numbers
  std::array<uint8_t, 3> rgb{};
  bool operator==(const LegendColor&) const = default;
};

struct Sprite {
  int32_t pattern = 0;         // from 0
  std::array<double, 2> at{};  // its left lower corner, in cells from that of the map
  bool operator==(const Sprite&) const = default;
};

struct SpriteMap {
  uint32_t columns = 0;
  uint32_t rows = 0;
  uint32_t layers = 0;          // at least as many as there are sprites in a cell
  std::vector<Sprite> sprites;  // later ones lie on top
  std::vector<SourceRange> ranges;
  bool operator==(const SpriteMap& other) const {
    return columns == other.columns && rows == other.rows && layers == other.layers &&
           sprites == other.sprites;
  }
};

// Of maps and lists; with more numbers they cannot be constant.
inline constexpr size_t kMaxConstantNumbers = 4096;
inline constexpr uint32_t kMaxMapSide = 16384;
inline constexpr uint32_t kMinPermutation = 2;
inline constexpr uint64_t kMaxMapNumbers = uint64_t{1} << 26;
inline constexpr uint64_t kMaxSpriteTexels = uint64_t{1} << 22;  // of 16 bytes
inline constexpr uint32_t kMaxSpriteLayers = 64;
inline constexpr uint32_t kMaxGridSide = 1024;
inline constexpr double kMaxWeight = 1e9;
inline constexpr uint32_t kMinTileSize = 4;
inline constexpr uint32_t kMaxTileSize = 4096;
inline constexpr uint32_t kMaxTileColors = 4;
inline constexpr uint32_t kMinTileCandidates = 8;
inline constexpr uint32_t kMaxTileCandidates = 1024;
inline constexpr uint32_t kMinNoiseSize = 16;
inline constexpr uint32_t kMaxNoiseSize = 2048;
inline constexpr size_t kMaxNoiseParts = 16;
inline constexpr double kMinBandwidth = 0.25;
inline constexpr double kMaxStretch = 64;
inline constexpr uint32_t kMaxDeviations = 8;
inline constexpr uint32_t kMinCubeSize = 4;
inline constexpr uint32_t kMaxCubeSize = 64;
inline constexpr uint32_t kMaxCubeColors = 3;
inline constexpr uint32_t kMaxCubeCandidates = 256;
inline constexpr uint32_t kCubeSize = 16;          // without "cube_size"
inline constexpr uint32_t kCubeCandidates = 64;    // without "candidates"
inline constexpr int32_t kMaxMapNumber = 1 << 24;  // floats hold whole numbers up to here

struct Texture {
  std::string_view name;
  SourceRange range;
  TextureKind kind = TextureKind::kFile;
  // One, the layers, the sheet, or the picture of a map; none for what stands in the graph. Paths
  // as the graph has them, from its folder.
  std::vector<std::string_view> files;
  std::vector<SourceRange> file_ranges;
  bool is_array = false;    // sampled as a sampler2DArray
  bool is_3d = false;       // sampled as a sampler3D
  std::vector<Mask> masks;  // none, one for all layers, or one for each
  std::optional<ColorKey> key;
  ColorSpace color_space = ColorSpace::kSrgb;
  bool alpha_is_opacity = true;  // "alpha": "opacity" or "data"
  TextureFilter filter = TextureFilter::kLinear;
  TextureWrap wrap_u = TextureWrap::kRepeat, wrap_v = TextureWrap::kRepeat;
  TextureWrap wrap_w = TextureWrap::kRepeat;  // of volumes: what "wrap" says
  bool mipmaps = true;
  std::optional<int> max_level;  // "max_level": the coarsest mip level that may be used

  // Patterns: kLayers and kSheet.
  TexturePack pack = TexturePack::kArray;
  // Columns and rows of a sheet, of an atlas, and of the slices of cubes' sample; 1 to kMaxGridSide
  // each. Patterns are counted from the left top corner, row by row.
  std::array<uint32_t, 2> grid = {1, 1};
  SourceRange grid_range;
  bool match_edges = false;  // "edges"
  // Of the edges that match, for each pattern the first of the group it fits in: a pattern alone is
  // its own. None: all patterns are one group.
  std::vector<uint32_t> edge_groups;
  // Of each pattern in the coarsest mip levels, 0 to kMaxWeight, not all 0; none: as they are.
  std::vector<double> weights;

  // Of kTiles and kCubes the setting; those that are cut like others ("like") have theirs, but for
  // `weight`. Of kTiling and kPermutation the seed, of kCorners those of its tiles.
  TileSetting tiles;

  NoiseSetting noise;       // kNoise
  uint32_t deviations = 7;  // kColorMap: standard deviations along each axis, 2 to kMaxDeviations

  // What a map's, the lists' or the sprites' numbers count ("of"), the map that means are of
  // ("means"), the tiles of a tiling or of corners, the tiles that these are cut like ("like"), or
  // the picture that a table turns noise back to ("table"), as an index of the graph's textures.
  std::optional<uint32_t> of;
  NumberMap map;  // kMap, kLists, kTiling, kPermutation
  std::vector<LegendColor> legend;
  SourceRange legend_range;
  bool is_constant = false;  // "binding": "constant"
  SourceRange binding_range;
  SpriteMap sprites;      // kSprites
  bool dithered = false;  // kMeans

  bool IsMap() const {
    return kind == TextureKind::kMap || kind == TextureKind::kLists ||
           kind == TextureKind::kSprites || kind == TextureKind::kTiling ||
           kind == TextureKind::kPermutation;
  }
  bool HasTiles() const { return kind == TextureKind::kTiles || kind == TextureKind::kCubes; }
  bool HasPatterns() const { return kind == TextureKind::kLayers || kind == TextureKind::kSheet; }
  // Of layers and sheets.
  uint32_t PatternCount() const {
    return kind == TextureKind::kSheet ? grid[0] * grid[1] : static_cast<uint32_t>(files.size());
  }
  // Columns and rows of the pack of a set of tiles, if it is one picture.
  std::array<uint32_t, 2> TilesInPack() const {
    const auto [first, second] = tiles.colors;
    if (tiles.has_edge_colors) return {second * second, first * first};
    return {first * first, first * first};
  }
  // Its texels are made by texgraph, all levels, and written as one file: no engine has to know
  // how.
  bool IsDerived() const {
    return (kind != TextureKind::kFile && kind != TextureKind::kLayers) ||
           pack != TexturePack::kArray || match_edges || !weights.empty();
  }
  // Its pictures get another alpha channel before they are uploaded; else it may be derived.
  bool IsPrepared() const { return !IsDerived() && (!masks.empty() || key.has_value()); }
  // The mask of a layer; null if there is none.
  const Mask* MaskOf(size_t layer) const {
    if (masks.empty()) return nullptr;
    return &masks[masks.size() == 1 ? 0 : layer];
  }
};

// False, with kSizeLimit, if there are too many numbers for a texture, or for constants if those
// are asked for.
bool CheckMapSize(uint32_t columns, uint32_t rows, const Texture& texture, SourceRange range,
                  Diagnostics& diagnostics);

}  // namespace texgraph::graph
