// SPDX-License-Identifier: Apache-2.0
// Ports that repeat what a set of tiles or cubes says of its colours ("@colors_of"): of corners
// where the port is an int, of edges where it is an ivec2. They follow from the texture, and a
// graph that gives them all the same gives them as the texture has them.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "compiler/graph/literal.h"
#include "compiler/graph/subgraph_checker.h"

namespace texgraph::graph {
namespace {

std::string ColorsText(const Texture& texture) {
  const auto [first, second] = texture.tiles.colors;
  if (!texture.tiles.has_edge_colors) return fmt::format("{} corner colours", first);
  return fmt::format("{} colours of edges that lie and {} of edges that stand", first, second);
}

// The words of the port that fit the tiles; empty if their colours are of the other kind.
std::span<const uint32_t> ColorsFor(const blocks::Port& port, const Texture& texture) {
  const bool wants_edges = port.type == ir::kIvec2;
  if (wants_edges != texture.tiles.has_edge_colors) return {};
  return std::span(texture.tiles.colors).first(wants_edges ? 2 : 1);
}

}  // namespace

// A pack that was made by another program says nothing: then the port is to be connected.
std::optional<BoundPort> SubgraphChecker::BindColors(const Target& target,
                                                     const blocks::Overload& overload,
                                                     const Node& node) {
  const blocks::Port& port = target.port;
  const NamedTexture named = TextureAt(node, overload.inputs[*port.colors_of].name);
  if (!named.texture) return std::nullopt;
  const Texture& texture = *named.texture;
  if (texture.kind == TextureKind::kCorners) {
    check_.diagnostics
        .Error(DiagnosticKind::kTileColors, named.range,
               fmt::format("block '{}' takes tiles, but '{}' is a pack of corners", node.block,
                           texture.name))
        .AddNote(texture.range, fmt::format("'{}' is here", texture.name));
    return std::nullopt;
  }
  if (!texture.HasTiles()) return BindDefault(target, node.range);
  const std::span<const uint32_t> colors = ColorsFor(port, texture);
  if (colors.empty()) {
    check_.diagnostics
        .Error(DiagnosticKind::kTileColors, named.range,
               fmt::format("block '{}' takes tiles with colours of {}, but '{}' has {}", node.block,
                           port.type == ir::kIvec2 ? "edges" : "corners", texture.name,
                           ColorsText(texture)))
        .AddNote(texture.range, fmt::format("'{}' is here", texture.name));
    return std::nullopt;
  }
  const ir::ConstId value = check_.module.Intern(port.type, colors);
  return BoundPort{ConstantValue{value}, port.type, port.type, {}, node.range};
}

void SubgraphChecker::CheckColors(const CheckedNode& checked, const blocks::Overload& overload) {
  if (checked.inputs.size() != overload.inputs.size()) return;  // reported
  for (size_t i = 0; i < overload.inputs.size(); ++i) {
    const blocks::Port& port = overload.inputs[i];
    if (!port.colors_of) continue;
    CheckCorners(checked, *port.colors_of);
    const auto* value = std::get_if<ConstantValue>(&checked.inputs[i].source);
    const auto* ref = std::get_if<TextureRef>(&checked.inputs[*port.colors_of].source);
    if (!value || !value->value || !ref) continue;
    const Texture& texture = check_.graph.textures[ref->texture];
    if (!texture.HasTiles()) continue;
    if (std::ranges::equal(check_.module.Words(value->value), ColorsFor(port, texture))) continue;
    const Place place{"port", port.name, "node", checked.node->name, port.range};
    check_.diagnostics
        .Error(DiagnosticKind::kTileColors, checked.inputs[i].range,
               fmt::format("{} does not fit '{}', which has {}; without a value it is as the "
                           "texture says",
                           place.Text(), texture.name, ColorsText(texture)))
        .AddNote(texture.range, fmt::format("'{}' is here", texture.name));
  }
}

// A pack of corners beside tiles at port `tiles` is that of these tiles.
void SubgraphChecker::CheckCorners(const CheckedNode& checked, size_t tiles) {
  const auto* ref = std::get_if<TextureRef>(&checked.inputs[tiles].source);
  if (!ref || !check_.graph.textures[ref->texture].HasTiles()) return;
  for (const BoundPort& input : checked.inputs) {
    const auto* other = std::get_if<TextureRef>(&input.source);
    if (!other) continue;
    const Texture& corners = check_.graph.textures[other->texture];
    if (corners.kind != TextureKind::kCorners || corners.of == ref->texture) continue;
    const std::string_view shown = check_.graph.textures[ref->texture].name;
    check_.diagnostics
        .Error(DiagnosticKind::kTileColors, input.range,
               fmt::format("'{}' has the corners of '{}', but node '{}' shows '{}'", corners.name,
                           check_.graph.textures[*corners.of].name, checked.node->name, shown))
        .AddNote(corners.range, fmt::format("\"corners\": \"{}\" would do here", shown));
  }
}

}  // namespace texgraph::graph
