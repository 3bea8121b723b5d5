// SPDX-License-Identifier: Apache-2.0
// Ports that say how many cells a map is laid over ("@multiple_of"): the map's columns and rows
// must divide them, or a texel of the map would cover parts of cells.
#include <fmt/format.h>

#include "compiler/graph/checked_graph.h"

namespace texgraph::graph {
namespace {

struct Size {
  uint32_t columns = 0, rows = 0;
};

// Nothing where the texture is no map, or its picture could not be read.
Size SizeOfMap(const Texture& texture) {
  if (texture.kind == TextureKind::kSprites) return {texture.sprites.columns, texture.sprites.rows};
  return {texture.map.width, texture.map.height};
}

void CheckPort(const CheckedGraph& graph, const CheckedNode& node, const blocks::Port& port,
               size_t index, const ir::Module& module, Diagnostics& diagnostics) {
  const auto* cells = std::get_if<ConstantValue>(&node.inputs[index].source);
  const auto* map = std::get_if<TextureRef>(&node.inputs[*port.multiple_of].source);
  if (!cells || !map) return;
  const Texture& texture = graph.graph->textures[map->texture];
  const Size size = SizeOfMap(texture);
  if (size.columns == 0 || size.rows == 0) return;
  const uint32_t columns = module.Words(cells->value)[0], rows = module.Words(cells->value)[1];
  const bool columns_fit = columns % size.columns == 0;
  if (columns_fit && rows % size.rows == 0) return;
  diagnostics
      .Error(DiagnosticKind::kMapSize, node.inputs[index].range,
             fmt::format("port '{}' of node '{}' has {} {}, but the {} {} of the map '{}' do not "
                         "divide them",
                         port.name, node.node->name, columns_fit ? rows : columns,
                         columns_fit ? "rows" : "columns", columns_fit ? size.rows : size.columns,
                         columns_fit ? "rows" : "columns", texture.name))
      .AddNote(texture.range,
               fmt::format("the map has {} x {} texels, each for as many whole cells", size.columns,
                           size.rows));
}

}  // namespace

void CheckMapMultiples(const CheckedGraph& graph, const ir::Module& module,
                       Diagnostics& diagnostics) {
  auto check = [&](const CheckedSubgraph& subgraph) {
    for (const CheckedNode& node : subgraph.nodes) {
      if (!node.block) continue;
      for (size_t i = 0; i < node.inputs.size(); ++i) {
        const blocks::Port& port = node.overload->inputs[i];
        if (port.multiple_of) CheckPort(graph, node, port, i, module, diagnostics);
      }
    }
  };
  for (const CheckedSubgraph& function : graph.functions) check(function);
  check(graph.main);
}

}  // namespace texgraph::graph
