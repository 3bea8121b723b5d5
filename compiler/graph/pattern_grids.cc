// SPDX-License-Identifier: Apache-2.0
// Ports that repeat what a texture says of its patterns ("@grid_of"): they follow from the texture,
// and a graph that gives them all the same gives them as the texture has them.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "compiler/graph/literal.h"
#include "compiler/graph/subgraph_checker.h"

namespace texgraph::graph {
namespace {

// Whether the texture's grid is that of its texels; a sheet in layers has none any more.
bool HasGrid(const Texture& texture) { return texture.pack == TexturePack::kAtlas; }

std::array<uint32_t, 2> GridOf(const Texture& texture) {
  return texture.kind == TextureKind::kTiles ? texture.TilesInPack() : texture.grid;
}

}  // namespace

SubgraphChecker::NamedTexture SubgraphChecker::TextureAt(const Node& node,
                                                         std::string_view input) const {
  const auto found = std::ranges::find(node.inputs, input, &Input::port);
  if (found == node.inputs.end()) return {};  // it is missing
  const Resolved& resolved = arguments_[found - node.inputs.begin()];
  if (resolved.kind != Resolved::Kind::kSymbol || resolved.symbol.kind != Symbol::Kind::kTexture) {
    return {};
  }
  return {&check_.graph.textures[resolved.symbol.index], found->argument.range};
}

// A picture that was packed by another program says nothing: then the port is to be connected.
std::optional<BoundPort> SubgraphChecker::BindGrid(const Target& target,
                                                   const blocks::Overload& overload,
                                                   const Node& node) {
  const blocks::Port& port = target.port;
  const NamedTexture named = TextureAt(node, overload.inputs[*port.grid_of].name);
  if (!named.texture) return std::nullopt;
  const Texture& texture = *named.texture;
  if (!HasGrid(texture)) return BindDefault(target, node.range);
  const ir::ConstId grid = check_.module.Intern(port.type, GridOf(texture));
  return BoundPort{ConstantValue{grid}, port.type, port.type, {}, node.range};
}

void SubgraphChecker::CheckGrids(const CheckedNode& checked, const blocks::Overload& overload) {
  if (checked.inputs.size() != overload.inputs.size()) return;  // reported
  for (size_t i = 0; i < overload.inputs.size(); ++i) {
    const blocks::Port& port = overload.inputs[i];
    if (!port.grid_of) continue;
    const auto* grid = std::get_if<ConstantValue>(&checked.inputs[i].source);
    const auto* ref = std::get_if<TextureRef>(&checked.inputs[*port.grid_of].source);
    if (!grid || !grid->value || !ref) continue;
    const Texture& texture = check_.graph.textures[ref->texture];
    const std::span<const uint32_t> given = check_.module.Words(grid->value);
    if (!HasGrid(texture) || std::ranges::equal(given, GridOf(texture))) continue;
    const Place place{"port", port.name, "node", checked.node->name, port.range};
    check_.diagnostics
        .Error(DiagnosticKind::kPatternGrid, checked.inputs[i].range,
               fmt::format("{} is {} x {}, but the patterns of '{}' lie in {} x {}; without a "
                           "value it is as the texture says",
                           place.Text(), static_cast<int32_t>(given[0]),
                           static_cast<int32_t>(given[1]), texture.name, GridOf(texture)[0],
                           GridOf(texture)[1]))
        .AddNote(texture.kind == TextureKind::kTiles ? texture.range : texture.grid_range,
                 "the texture says so here");
  }
}

}  // namespace texgraph::graph
