// SPDX-License-Identifier: Apache-2.0
// Turns a document into a graph, object by object; private to ReadGraph. Every object has a list of
// keys, which is also what docs/graph.schema.json says. A mistake is reported and reading goes on.
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "compiler/base/name_map.h"
#include "compiler/graph/document.h"
#include "compiler/graph/graph.h"

namespace texgraph::graph {

// The keys of a texture, in the order of read_textures.cc.
enum class TextureKey : uint8_t {
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
  kMask,
  kKey,
  kColorSpace,
  kAlpha,
  kFilter,
  kWrap,
  kWrapU,
  kWrapV,
  kMipmaps,
  kMaxLevel,
  kGrid,
  kPack,
  kEdges,
  kWeights,
  kLegend,
  kOf,
  kBinding,
  kCells,
  kDithered,
  kCornerColors,
  kEdgeColors,
  kTileSize,
  kLike,
  kSeed,
  kCandidates,
  kWeight,
  kSize,
  kSecond,
  kDeviations,
  kCubeSize,
  kOwnMiddles,
  kEven,
};
inline constexpr size_t kTextureKeyCount = 48;

inline constexpr size_t kMaxNodes = 1'000'000;  // of a graph, those of its functions included

class GraphReader {
 public:
  GraphReader(Graph& graph, Diagnostics& diagnostics)
      : graph_(graph), document_(graph.document), diagnostics_(diagnostics) {}

  void ReadRoot(std::string_view file_name);

 private:
  // What an object is, for messages: "node" and "grid". Made into text only for a message.
  struct Owner {
    std::string_view kind;
    std::string_view name;
    std::string Text() const;
  };

  // The children of `node` with these keys, null where there is none; reports other keys.
  template <size_t N>
  std::array<const DocumentNode*, N> Keys(const DocumentNode& node, Owner owner,
                                          const std::array<std::string_view, N>& keys) {
    std::array<const DocumentNode*, N> found{};
    FindKeys(node, owner, keys, found);
    return found;
  }
  void FindKeys(const DocumentNode& node, Owner owner, std::span<const std::string_view> keys,
                std::span<const DocumentNode*> found);
  void ReportMissing(const DocumentNode& object, Owner owner, std::string_view key);
  // Whether a value is there and of the kind; if it is of another, that is reported.
  bool Is(const DocumentNode* node, DocumentKind kind, Owner owner);

  // These leave `out` as it is if the key is not there.
  bool ReadText(const DocumentNode* node, Owner owner, std::string_view& out);
  void ReadBool(const DocumentNode* node, Owner owner, bool& out);
  template <class T>
  void ReadWord(const DocumentNode* node, Owner owner,
                std::initializer_list<std::pair<std::string_view, T>> words, T& out) {
    std::string_view text;
    if (!ReadText(node, owner, text)) return;
    for (const auto& [word, value] : words) {
      if (word == text) {
        out = value;
        return;
      }
    }
    std::vector<std::string_view> names;
    for (const auto& pair : words) names.push_back(pair.first);
    ReportWord(*node, owner, names);
  }
  void ReportWord(const DocumentNode& node, Owner owner,
                  const std::vector<std::string_view>& words);
  void BadValue(const DocumentNode& node, std::string message);

  void ReadVersion(const DocumentNode& root, const DocumentNode* version);
  void ReadName(const DocumentNode* name, std::string_view file_name);
  // read_textures.cc: the section, the kinds, and the sampler's state.
  using TextureKeys = std::array<const DocumentNode*, kTextureKeyCount>;
  void ReadTextures(const DocumentNode* section);
  void ReadTexture(const DocumentNode& node);
  bool ReadTextureKind(const DocumentNode& node, Owner owner, TextureKeys& keys, Texture& texture);
  void CheckTextureKeys(const TextureKeys& keys, Owner owner, const Texture& texture);
  void ReadSampling(const TextureKeys& keys, Owner owner, Texture& texture);
  // read_patterns.cc
  void ReadLayers(const DocumentNode& layers, Owner owner, Texture& texture);
  void ReadPatterns(const DocumentNode& node, const TextureKeys& keys, Owner owner,
                    Texture& texture);
  void ReadGrid(const DocumentNode& node, const TextureKeys& keys, Owner owner, Texture& texture);
  void ReadFile(const DocumentNode& node, Owner owner, Texture& texture);
  bool ReadPath(const DocumentNode* node, Owner owner, std::string_view& path);
  void ReadMasks(const DocumentNode& node, Owner owner, Texture& texture);
  void ReadMask(const DocumentNode& node, Owner owner, Texture& texture);
  void ReadKey(const DocumentNode& node, Owner owner, Texture& texture);
  // read_maps.cc
  void ReadMap(const TextureKeys& keys, Owner owner, Texture& texture);
  void ReadMapRows(const DocumentNode& rows, Owner owner, Texture& texture);
  void ReadLegend(const DocumentNode& node, Owner owner, Texture& texture);
  void ReadLists(const TextureKeys& keys, Owner owner, Texture& texture);
  void ReadBinding(const TextureKeys& keys, Owner owner, Texture& texture);
  bool ReadNumbers(const DocumentNode& row, std::string_view what, std::vector<int32_t>& numbers);
  bool ReadSides(const DocumentNode* node, Owner owner, uint32_t greatest,
                 std::array<uint32_t, 2>& sides);
  // read_sprites.cc
  void ReadSprites(const DocumentNode& node, const TextureKeys& keys, Owner owner,
                   Texture& texture);
  bool ReadSprite(const DocumentNode& node, Owner owner, const SpriteMap& map, Sprite& sprite);
  void CountLayers(std::optional<uint32_t> limit, SourceRange cells, SpriteMap& map);
  // read_tiles.cc
  void ReadTiles(const TextureKeys& keys, Owner owner, Texture& texture);
  void ReadTiling(const DocumentNode& node, const TextureKeys& keys, Owner owner, Texture& texture);
  void ReadCubes(const DocumentNode& node, const TextureKeys& keys, Owner owner, Texture& texture);
  void ReadTileColors(const TextureKeys& keys, Owner owner, Texture& texture);
  void ReadWhole(const DocumentNode* node, Owner owner, uint32_t least, uint32_t greatest,
                 uint32_t& out);
  void ReadPermutation(const TextureKeys& keys, Owner owner, Texture& texture);
  void ResolveTiles(uint32_t index);
  void ResolveCorners(uint32_t index);
  // read_noise.cc
  void ReadNoise(const TextureKeys& keys, Owner owner, Texture& texture);
  void ReadSpectrum(const DocumentNode& node, size_t field, Texture& texture);
  bool ReadPart(const DocumentNode& node, Texture& texture, NoisePart& part);
  std::optional<NoisePart::Kind> ReadPartKind(const DocumentNode& node, Owner owner,
                                              std::span<const DocumentNode* const> keys);
  bool ReadLobes(const DocumentNode& node, double most, std::array<double, 2>& out);
  bool ReadPartNumber(const DocumentNode* node, double least, double greatest, double& out);
  void ResolveTable(uint32_t index);
  // resolve_textures.cc: what textures say of each other.
  void ResolveTextures();
  std::optional<uint32_t> FindTexture(const DocumentNode& node, Owner owner,
                                      std::span<const std::string_view> words = {});
  bool KnownKind(uint32_t index) const;
  void ResolveOf(uint32_t index);
  void ResolveWeights(uint32_t index);
  double ReadWeight(const DocumentNode& node);
  void ReadWeights(const DocumentNode& node, Owner owner, Texture& texture);
  const NumberMap* FindLists(const DocumentNode& node, Owner owner, uint32_t index,
                             std::span<const std::string_view> words = {});
  void CountWeights(const DocumentNode& node, Owner owner, uint32_t index);
  void CheckNumbers(uint32_t index);
  void CheckMeans(uint32_t index);
  // resolve_edges.cc
  void ResolveEdges(uint32_t index);
  void ReadParameters(const DocumentNode* section);
  void ReadParameter(const DocumentNode& node);
  void ReadRange(const DocumentNode* node, Owner owner, Parameter& parameter);
  void ReadFunctions(const DocumentNode* section);
  void ReadFunction(const DocumentNode& node);
  void ReadFunctionInput(const DocumentNode& node, Subgraph& function);
  void ReadNodes(const DocumentNode* section, Owner owner, Subgraph& subgraph);
  void ReadNode(const DocumentNode& node, Subgraph& subgraph);
  void ReadOutputs(const DocumentNode* section, Owner owner, bool check_names, Subgraph& subgraph);

  Graph& graph_;
  const Document& document_;
  Diagnostics& diagnostics_;
  size_t node_count_ = 0;
  std::vector<TextureKeys> texture_keys_;  // of each texture; none if it has no known kind
  NameMap<uint32_t> texture_names_;
};

}  // namespace texgraph::graph
