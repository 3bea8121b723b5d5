// SPDX-License-Identifier: Apache-2.0
// What textures say of each other: "of", "weights", "edges" and "means". Means are of maps, the
// numbers of maps lead to lists, sprites or patterns, and those of lists and sprites to patterns:
// since every step leads to another kind, there are no circles.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/base/name_map.h"
#include "compiler/base/text.h"
#include "compiler/graph/argument.h"
#include "compiler/graph/graph_reader.h"

namespace texgraph::graph {
std::string_view KindText(TextureKind kind) {
  switch (kind) {
    case TextureKind::kFile:
      return "a single picture";
    case TextureKind::kLayers:
      return "an array of layers";
    case TextureKind::kSheet:
      return "a sheet";
    case TextureKind::kMap:
      return "a map";
    case TextureKind::kLists:
      return "lists";
    case TextureKind::kSprites:
      return "sprites";
    case TextureKind::kMeans:
      return "means";
    case TextureKind::kTiles:
      return "a set of tiles";
    case TextureKind::kTiling:
      return "a tiling";
    case TextureKind::kCorners:
      return "a pack of corners";
    case TextureKind::kPermutation:
      return "a permutation";
    case TextureKind::kNoise:
      return "noise";
    case TextureKind::kGaussian:
      return "a Gaussian picture";
    case TextureKind::kTable:
      return "a table";
    case TextureKind::kColorMap:
      return "a colour map";
    case TextureKind::kCubes:
      return "a set of cubes";
  }
  return {};
}

namespace {

bool IsAllowed(TextureKind from, TextureKind to) {
  switch (to) {
    case TextureKind::kLayers:
    case TextureKind::kSheet:
      return from != TextureKind::kMeans;
    case TextureKind::kLists:
    case TextureKind::kSprites:
      return from == TextureKind::kMap;
    case TextureKind::kMap:
      return from == TextureKind::kMeans;
    case TextureKind::kTiles:
      return from == TextureKind::kMap;
    case TextureKind::kFile:
    case TextureKind::kMeans:
    case TextureKind::kTiling:
    case TextureKind::kCorners:
    case TextureKind::kPermutation:
    case TextureKind::kNoise:
    case TextureKind::kGaussian:
    case TextureKind::kTable:
    case TextureKind::kColorMap:
    case TextureKind::kCubes:
      break;
  }
  return false;
}

std::string_view AllowedText(TextureKind from) {
  switch (from) {
    case TextureKind::kMap:
      return "layers, a sheet, lists, sprites or tiles";
    case TextureKind::kMeans:
      return "a map";
    default:
      return "layers or a sheet";
  }
}

// What the numbers of a texture that names `of` count, and how many there are.
struct Counted {
  std::string_view things;
  uint32_t count = 0;
};

Counted CountedBy(const Graph& graph, const Texture& of) {
  if (of.kind == TextureKind::kLists) return {"lists", of.map.height};
  if (of.kind == TextureKind::kTiles) {
    const auto [columns, rows] = of.TilesInPack();
    return {"tiles", columns * rows};
  }
  if (of.kind != TextureKind::kSprites) return {"patterns", of.PatternCount()};
  if (!of.of) return {"patterns of sprites", 0};
  return {"patterns of sprites", graph.textures[*of.of].PatternCount()};
}

}  // namespace

std::optional<uint32_t> PatternsOf(const Graph& graph, uint32_t index) {
  std::optional<uint32_t> at = index;
  // Means, a map, lists, patterns: no chain is longer.
  for (int step = 0; at && step < 4; ++step) {
    if (graph.textures[*at].HasPatterns()) return at;
    at = graph.textures[*at].of;
  }
  return std::nullopt;
}

std::optional<Reach> ReachOf(const Graph& graph, const Texture& texture) {
  if (!texture.of) return std::nullopt;
  const Texture& of = graph.textures[*texture.of];
  const Counted counted = CountedBy(graph, of);
  if (counted.count == 0) return std::nullopt;  // nothing is known of it, or it has a mistake
  return Reach{counted.things, of.name, of.range, counted.count};
}

std::string BeyondReach(const Reach& reach, int64_t number) {
  return fmt::format("'{}' has {} {}, 0 to {}; {} is none of them", reach.name, reach.count,
                     reach.things, reach.count - 1, number);
}

void GraphReader::ResolveTextures() {
  for (size_t i = 0; i < graph_.textures.size(); ++i) {
    texture_names_.Add(graph_.textures[i].name, static_cast<uint32_t>(i));
  }
  const auto count = static_cast<uint32_t>(graph_.textures.size());
  for (uint32_t i = 0; i < count; ++i) {
    ResolveOf(i);
    ResolveTiles(i);
    ResolveTable(i);
  }
  for (uint32_t i = 0; i < count; ++i) {
    ResolveCorners(i);
    ResolveEdges(i);
    ResolveWeights(i);
  }
  for (uint32_t i = 0; i < count; ++i) CheckNumbers(i);
  for (uint32_t i = 0; i < count; ++i) CheckMeans(i);
}

// `words`: what might have been meant as well.
std::optional<uint32_t> GraphReader::FindTexture(const DocumentNode& node, Owner owner,
                                                 std::span<const std::string_view> words) {
  std::string_view name;
  if (!ReadText(&node, owner, name)) return std::nullopt;
  if (const uint32_t* found = texture_names_.Find(name)) {
    // What is wrong with a texture is said at its own place.
    return KnownKind(*found) ? std::optional(*found) : std::nullopt;
  }
  std::vector<std::string_view> names(words.begin(), words.end());
  for (const Texture& texture : graph_.textures) names.push_back(texture.name);
  std::string message = words.empty()
                            ? fmt::format("no texture is called '{}'", Printable(name, 64))
                            : fmt::format("'{}' is neither {} nor the name of a texture",
                                          Printable(name, 64), ListedQuoted(words, " nor "));
  diagnostics_.Error(DiagnosticKind::kUnknownReference, node.range,
                     message + DidYouMean(name, names));
  return std::nullopt;
}

// Whether it has a key that says what it is made of.
bool GraphReader::KnownKind(uint32_t index) const {
  return std::ranges::any_of(texture_keys_[index],
                             [](const DocumentNode* key) { return key != nullptr; });
}

void GraphReader::ResolveOf(uint32_t index) {
  Texture& texture = graph_.textures[index];
  const bool is_means = texture.kind == TextureKind::kMeans;
  if (!is_means && !texture.IsMap()) return;
  if (texture.kind == TextureKind::kTiling || texture.kind == TextureKind::kPermutation) return;
  const DocumentNode* node =
      texture_keys_[index][static_cast<size_t>(is_means ? TextureKey::kMeans : TextureKey::kOf)];
  if (!node) return;
  const Owner owner{"texture", texture.name};
  const std::optional<uint32_t> of = FindTexture(*node, owner);
  if (!of) return;
  const Texture& other = graph_.textures[*of];
  if (IsAllowed(texture.kind, other.kind)) {
    texture.of = of;
    return;
  }
  diagnostics_
      .Error(DiagnosticKind::kBadValue, node->range,
             fmt::format("'{}' of {} names {}, but '{}' is {}", node->key, owner.Text(),
                         AllowedText(texture.kind), other.name, KindText(other.kind)))
      .AddNote(other.range, fmt::format("'{}' is here", other.name));
}

// Numbers, one for each pattern or one for all of them, or the lists that choose from the patterns.
void GraphReader::ResolveWeights(uint32_t index) {
  Texture& texture = graph_.textures[index];
  const DocumentNode* node = texture_keys_[index][static_cast<size_t>(TextureKey::kWeights)];
  const uint32_t count = texture.PatternCount();
  if (!node || !texture.HasPatterns() || !texture.is_array || count == 0) return;
  const Owner owner{"texture", texture.name};
  if (node->kind == DocumentKind::kArray) {
    ReadWeights(*node, owner, texture);
  } else if (node->kind == DocumentKind::kNumber) {
    const double weight = ReadWeight(*node);
    if (weight >= 0) texture.weights.assign(count, weight);
  } else if (node->kind == DocumentKind::kString) {
    CountWeights(*node, owner, index);
  } else {
    diagnostics_.Error(
        DiagnosticKind::kGraphShape, node->range,
        fmt::format("'weights' of {} must be numbers, one for each pattern or one for all, or the "
                    "name of lists, not {}",
                    owner.Text(), graph::KindText(node->kind)));
  }
  if (texture.weights.empty()) return;
  if (std::ranges::any_of(texture.weights, [](double weight) { return weight > 0; })) return;
  BadValue(*node,
           fmt::format("the weights of {} sum to nothing: no pattern has one", owner.Text()));
}

void GraphReader::ReadWeights(const DocumentNode& node, Owner owner, Texture& texture) {
  const uint32_t count = texture.PatternCount();
  if (node.child_count != count) {
    return BadValue(node, fmt::format("{} has {} patterns, but {} weights", owner.Text(), count,
                                      node.child_count));
  }
  for (const DocumentNode& child : document_.children(node)) {
    const double weight = ReadWeight(child);
    if (weight < 0) return texture.weights.clear();
    texture.weights.push_back(weight);
  }
}

// Below 0, and reported, if it is none.
double GraphReader::ReadWeight(const DocumentNode& node) {
  if (node.kind == DocumentKind::kNumber && node.number >= 0 && node.number <= kMaxWeight) {
    return node.number;
  }
  BadValue(node, fmt::format("a weight is a number from 0 to {}", kMaxWeight));
  return -1;
}

// The numbers of the lists that `node` names and that choose from the patterns of the texture; null
// if there are none, which was reported.
const NumberMap* GraphReader::FindLists(const DocumentNode& node, Owner owner, uint32_t index,
                                        std::span<const std::string_view> words) {
  const Texture& texture = graph_.textures[index];
  const std::optional<uint32_t> found = FindTexture(node, owner, words);
  if (!found) return nullptr;
  const Texture& lists = graph_.textures[*found];
  if (lists.kind != TextureKind::kLists) {
    diagnostics_
        .Error(DiagnosticKind::kBadValue, node.range,
               fmt::format("'{}' of {} names lists, but '{}' is {}", node.key, owner.Text(),
                           lists.name, KindText(lists.kind)))
        .AddNote(lists.range, fmt::format("'{}' is here", lists.name));
    return nullptr;
  }
  const DocumentNode* of = texture_keys_[*found][static_cast<size_t>(TextureKey::kOf)];
  if (!of || (lists.of && *lists.of != index)) {
    diagnostics_
        .Error(
            DiagnosticKind::kBadValue, node.range,
            fmt::format("the lists '{}' are not of the patterns of {}", lists.name, owner.Text()))
        .AddNote(of ? of->range : lists.range,
                 fmt::format("\"of\": \"{}\" would say so", texture.name));
    return nullptr;
  }
  return lists.map.numbers.empty() ? nullptr : &lists.map;  // none: it has a mistake
}

// A pattern's weight is how often the lists have it.
void GraphReader::CountWeights(const DocumentNode& node, Owner owner, uint32_t index) {
  const NumberMap* lists = FindLists(node, owner, index);
  if (!lists) return;
  Texture& texture = graph_.textures[index];
  texture.weights.assign(texture.PatternCount(), 0.0);
  for (int32_t pattern : lists->numbers) {
    if (pattern >= 0 && static_cast<size_t>(pattern) < texture.weights.size()) {
      texture.weights[static_cast<size_t>(pattern)] += 1;
    }
  }
}

// Every number that stands in the graph must be one of what it counts.
void GraphReader::CheckNumbers(uint32_t index) {
  const Texture& texture = graph_.textures[index];
  const std::optional<Reach> reach = ReachOf(graph_, texture);
  if (!reach || !texture.IsMap() || !texture.files.empty()) return;
  if (texture.kind == TextureKind::kTiling) return;
  const TextureKeys& keys = texture_keys_[index];
  const auto check = [&](const DocumentNode& number) {
    if (number.kind != DocumentKind::kNumber || number.integer < reach->count) return;
    diagnostics_
        .Error(DiagnosticKind::kValueRange, number.range, BeyondReach(*reach, number.integer))
        .AddNote(reach->range, fmt::format("'{}' is here", reach->name));
  };
  const DocumentNode* values = keys[static_cast<size_t>(texture.kind)];
  if (values->kind != DocumentKind::kArray) return;
  for (const DocumentNode& row : document_.children(*values)) {
    if (row.kind == DocumentKind::kObject) {
      if (const DocumentNode* pattern = document_.Find(row, "pattern")) check(*pattern);
    } else if (row.kind == DocumentKind::kArray) {
      for (const DocumentNode& number : document_.children(row)) check(number);
    }
  }
}

void GraphReader::CheckMeans(uint32_t index) {
  Texture& texture = graph_.textures[index];
  if (texture.kind != TextureKind::kMeans || !texture.of) return;
  if (const auto patterns = PatternsOf(graph_, index)) {
    texture.alpha_is_opacity = graph_.textures[*patterns].alpha_is_opacity;
    return;
  }
  // A chain that breaks at an "of" with a mistake was reported there.
  uint32_t last = index;
  while (graph_.textures[last].of) last = *graph_.textures[last].of;
  if (texture_keys_[last][static_cast<size_t>(TextureKey::kOf)]) return;
  diagnostics_
      .Error(DiagnosticKind::kBadValue,
             texture_keys_[index][static_cast<size_t>(TextureKey::kMeans)]->range,
             fmt::format("the numbers of '{}' lead to no patterns, so that they have no mean",
                         graph_.textures[*texture.of].name))
      .AddNote(graph_.textures[last].range,
               fmt::format("'{}' has no 'of', which would say what its numbers count",
                           graph_.textures[last].name));
}

}  // namespace texgraph::graph
