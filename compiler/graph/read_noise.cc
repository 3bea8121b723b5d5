// SPDX-License-Identifier: Apache-2.0
// Noise by its spectrum, and the tables of pictures that are drawn as noise.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "compiler/base/text.h"
#include "compiler/graph/argument.h"
#include "compiler/graph/graph_reader.h"

namespace texgraph::graph {
namespace {

constexpr double kMaxExponent = 8;
constexpr double kMaxShare = 1e6;
constexpr double kMaxDirection = 360;  // degrees
constexpr double kMaxSpread = 90;

enum PartKey : size_t {
  kBand,
  kLobes,
  kPowerLaw,
  kPainted,
  kBandwidth,
  kLowest,
  kHighest,
  kDirection,
  kStretch,
  kSpread,
  kShare,
  kPartKeyCount
};
constexpr size_t kPartKinds = 4;  // the first keys, in NoisePart::Kind's order
constexpr std::array<std::string_view, kPartKeyCount> kPartKeys = {
    "band",    "lobes",     "power_law", "painted", "bandwidth", "lowest",
    "highest", "direction", "stretch",   "spread",  "share"};

constexpr uint32_t Bit(PartKey key) { return 1u << key; }
constexpr uint32_t kShapeKeys = Bit(kDirection) | Bit(kStretch) | Bit(kSpread) | Bit(kShare);
constexpr std::array<uint32_t, kPartKinds> kKeysOfPart = {
    Bit(kBand) | Bit(kBandwidth) | kShapeKeys, Bit(kLobes) | Bit(kBandwidth) | Bit(kShare),
    Bit(kPowerLaw) | Bit(kLowest) | Bit(kHighest) | kShapeKeys, Bit(kPainted) | Bit(kShare)};

}  // namespace

void GraphReader::ReadNoise(const TextureKeys& keys, Owner owner, Texture& texture) {
  const auto at = [&](TextureKey key) { return keys[static_cast<size_t>(key)]; };
  const DocumentNode* size = at(TextureKey::kSize);
  ReadWhole(size, owner, kMinNoiseSize, kMaxNoiseSize, texture.noise.size);
  if (!std::has_single_bit(texture.noise.size)) {
    BadValue(*size, fmt::format("'size' of {} is a power of two, {} to {}", owner.Text(),
                                kMinNoiseSize, kMaxNoiseSize));
  }
  ReadWhole(at(TextureKey::kSeed), owner, 0, kMaxMapNumber, texture.noise.seed);
  ReadSpectrum(*at(TextureKey::kNoise), 0, texture);
  if (at(TextureKey::kSecond)) ReadSpectrum(*at(TextureKey::kSecond), 1, texture);
}

// One part, or a list of them.
void GraphReader::ReadSpectrum(const DocumentNode& node, size_t field, Texture& texture) {
  const auto read = [&](const DocumentNode& child) {
    NoisePart part;
    if (ReadPart(child, texture, part)) texture.noise.spectra[field].push_back(part);
  };
  if (node.kind == DocumentKind::kObject) return read(node);
  if (node.kind != DocumentKind::kArray) {
    diagnostics_.Error(
        DiagnosticKind::kGraphShape, node.range,
        fmt::format("'{}' of texture '{}' must be a part of a spectrum, {{ \"band\": "
                    "16 }}, or a list of parts, not {}",
                    node.key, texture.name, KindText(node.kind)));
    return;
  }
  if (node.child_count == 0 || node.child_count > kMaxNoiseParts) {
    return BadValue(node, fmt::format("a spectrum has 1 to {} parts, not {}", kMaxNoiseParts,
                                      node.child_count));
  }
  for (const DocumentNode& child : document_.children(node)) read(child);
}

// Exactly one of the first keys, and no others than belong to it.
std::optional<NoisePart::Kind> GraphReader::ReadPartKind(
    const DocumentNode& node, Owner owner, std::span<const DocumentNode* const> keys) {
  size_t kind = kPartKinds;
  for (size_t i = 0; i < kPartKinds; ++i) {
    if (!keys[i]) continue;
    if (kind < kPartKinds) {
      diagnostics_
          .Error(DiagnosticKind::kGraphShape, keys[i]->key_range,
                 fmt::format("{} has '{}' and '{}'; it takes one of them", owner.Text(),
                             kPartKeys[kind], kPartKeys[i]))
          .AddNote(keys[kind]->key_range, fmt::format("'{}' is here", kPartKeys[kind]));
      return std::nullopt;
    }
    kind = i;
  }
  if (kind == kPartKinds) {
    diagnostics_.Error(DiagnosticKind::kMissingKey, node.range,
                       fmt::format("{} needs one of the keys {}", owner.Text(),
                                   ListedQuoted(std::span(kPartKeys).first<kPartKinds>(), " or ")));
    return std::nullopt;
  }
  for (size_t i = kPartKinds; i < kPartKeyCount; ++i) {
    if (!keys[i] || (kKeysOfPart[kind] >> i & 1)) continue;
    std::vector<std::string_view> others;
    for (size_t k = kPartKinds; k < kPartKeyCount; ++k) {
      if (kKeysOfPart[kind] >> k & 1) others.push_back(kPartKeys[k]);
    }
    diagnostics_.Error(DiagnosticKind::kUnknownKey, keys[i]->key_range,
                       fmt::format("{} with '{}' has no key '{}'; it may have {}", owner.Text(),
                                   kPartKeys[kind], kPartKeys[i], ListedQuoted(others, " and ")));
    return std::nullopt;
  }
  return static_cast<NoisePart::Kind>(kind);
}

bool GraphReader::ReadPart(const DocumentNode& node, Texture& texture, NoisePart& part) {
  const Owner owner{"a part of the spectrum of texture", texture.name};
  if (!Is(&node, DocumentKind::kObject, owner)) return false;
  const auto keys = Keys(node, owner, kPartKeys);
  const std::optional<NoisePart::Kind> kind = ReadPartKind(node, owner, keys);
  if (!kind) return false;
  part.kind = *kind;
  const double most = texture.noise.size / 2 - 1.0;
  bool good = ReadPartNumber(keys[kBand], 0, most, part.frequency[0]);
  if (keys[kLobes]) good = ReadLobes(*keys[kLobes], most, part.frequency);
  good = ReadPartNumber(keys[kPowerLaw], -kMaxExponent, kMaxExponent, part.exponent) && good;
  if (keys[kPainted]) {
    part.file = texture.files.size();
    ReadFile(*keys[kPainted], owner, texture);
    good = texture.files.size() > part.file;
  }
  part.bandwidth = std::max(std::hypot(part.frequency[0], part.frequency[1]) / 4, 1.0);
  good = ReadPartNumber(keys[kBandwidth], kMinBandwidth, most, part.bandwidth) && good;
  good = ReadPartNumber(keys[kLowest], 0, texture.noise.size, part.lowest) && good;
  good = ReadPartNumber(keys[kHighest], part.lowest, texture.noise.size, part.highest) && good;
  good = ReadPartNumber(keys[kDirection], -kMaxDirection, kMaxDirection, part.direction) && good;
  good = ReadPartNumber(keys[kStretch], 1, kMaxStretch, part.stretch) && good;
  good = ReadPartNumber(keys[kSpread], 0, kMaxSpread, part.spread) && good;
  return ReadPartNumber(keys[kShare], 1 / kMaxShare, kMaxShare, part.share) && good;
}

// Leaves `out` as it is if there is no node; false, and reported, if it is no such number.
bool GraphReader::ReadPartNumber(const DocumentNode* node, double least, double greatest,
                                 double& out) {
  if (!node) return true;
  if (node->kind == DocumentKind::kNumber && node->number >= least && node->number <= greatest) {
    out = node->number;
    return true;
  }
  BadValue(*node, fmt::format("'{}' is a number from {} to {}", node->key, least, greatest));
  return false;
}

bool GraphReader::ReadLobes(const DocumentNode& node, double most, std::array<double, 2>& out) {
  size_t count = 0;
  if (node.kind == DocumentKind::kArray) {
    for (const DocumentNode& child : document_.children(node)) {
      const bool good = child.kind == DocumentKind::kNumber && std::abs(child.number) <= most;
      if (good && count < out.size()) out[count] = child.number;
      count += good ? 1 : out.size() + 1;
    }
  }
  if (count == out.size()) return true;
  BadValue(node, fmt::format("'lobes' is a frequency, cycles across and up, each from {} to {}",
                             -most, most));
  return false;
}

void GraphReader::ResolveTable(uint32_t index) {
  Texture& texture = graph_.textures[index];
  if (texture.kind != TextureKind::kTable) return;
  const DocumentNode* node = texture_keys_[index][static_cast<size_t>(TextureKey::kTable)];
  if (!node) return;
  const Owner owner{"texture", texture.name};
  const std::optional<uint32_t> found = FindTexture(*node, owner);
  if (!found) return;
  const Texture& other = graph_.textures[*found];
  if (other.kind == TextureKind::kGaussian) {
    texture.of = found;
    return;
  }
  diagnostics_
      .Error(DiagnosticKind::kBadValue, node->range,
             fmt::format("'table' of {} names a Gaussian picture, but '{}' is {}", owner.Text(),
                         other.name, KindText(other.kind)))
      .AddNote(other.range, fmt::format("'{}' is here", other.name));
}

}  // namespace texgraph::graph
