// SPDX-License-Identifier: Apache-2.0
#include "compiler/graph/graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "compiler/base/text.h"
#include "compiler/graph/argument.h"
#include "compiler/graph/graph_reader.h"
#include "compiler/graph/names.h"

namespace texgraph::graph {

std::string GraphReader::Owner::Text() const {
  return name.empty() ? std::string(kind) : fmt::format("{} '{}'", kind, Printable(name));
}

void GraphReader::FindKeys(const DocumentNode& node, Owner owner,
                           std::span<const std::string_view> keys,
                           std::span<const DocumentNode*> found) {
  for (const DocumentNode& child : document_.children(node)) {
    size_t i = 0;
    while (i < keys.size() && keys[i] != child.key) ++i;
    if (i < keys.size()) {
      if (!found[i]) found[i] = &child;
      continue;
    }
    std::vector<std::string_view> names(keys.begin(), keys.end());
    diagnostics_.Error(DiagnosticKind::kUnknownKey, child.key_range,
                       fmt::format("{} has no key '{}'{}", owner.Text(), Printable(child.key),
                                   DidYouMean(child.key, names)));
  }
}

void GraphReader::ReportMissing(const DocumentNode& object, Owner owner, std::string_view key) {
  SourceRange range = object.key_range;
  if (!range.source.valid()) {
    range = object.range;
    range.end = std::min(range.end, range.begin + 1);
  }
  diagnostics_.Error(DiagnosticKind::kMissingKey, range,
                     fmt::format("{} needs the key '{}'", owner.Text(), key));
}

bool GraphReader::Is(const DocumentNode* node, DocumentKind kind, Owner owner) {
  if (!node) return false;
  if (node->kind == kind) return true;
  bool has_key = node->key_range.source.valid();
  std::string what = owner.Text();
  if (!has_key && node != document_.nodes.data()) what = "an entry of " + what;
  if (has_key && node->key != owner.name) {
    what = fmt::format("'{}' of {}", Printable(node->key), what);
  }
  diagnostics_.Error(
      DiagnosticKind::kGraphShape, node->range,
      fmt::format("{} must be {}, not {}", what, KindText(kind), KindText(node->kind)));
  return false;
}

bool GraphReader::ReadText(const DocumentNode* node, Owner owner, std::string_view& out) {
  if (!Is(node, DocumentKind::kString, owner)) return false;
  out = node->text;
  return true;
}

void GraphReader::ReadBool(const DocumentNode* node, Owner owner, bool& out) {
  if (Is(node, DocumentKind::kBool, owner)) out = node->boolean;
}

void GraphReader::BadValue(const DocumentNode& node, std::string message) {
  diagnostics_.Error(DiagnosticKind::kBadValue, node.range, std::move(message));
}

void GraphReader::ReportWord(const DocumentNode& node, Owner owner,
                             const std::vector<std::string_view>& words) {
  BadValue(node, fmt::format("'{}' of {} is {}, not '{}'{}", node.key, owner.Text(),
                             ListedQuoted(words, " or "), Printable(node.text),
                             DidYouMean(node.text, words)));
}

void GraphReader::ReadVersion(const DocumentNode& root, const DocumentNode* version) {
  if (!version) {
    ReportMissing(root, {"a graph", ""}, "texgraph");
    return;
  }
  if (version->kind == DocumentKind::kNumber && version->number == 1) return;
  diagnostics_.Error(DiagnosticKind::kGraphVersion, version->range,
                     version->is_integer
                         ? fmt::format("version {} of the graph format is not known; this program "
                                       "reads version 1",
                                       version->integer)
                         : std::string("'texgraph' is the version of the graph format, 1"));
}

void GraphReader::ReadName(const DocumentNode* name, std::string_view file_name) {
  std::string_view text;
  if (ReadText(name, {"the graph", ""}, text)) {
    CheckBoundName(text, name->range, diagnostics_);
    graph_.name = text;
    graph_.range = name->range;
  } else {
    graph_.name = NameOfFile(file_name);
  }
  graph_.main.name = graph_.name;
}

void GraphReader::ReadRoot(std::string_view file_name) {
  const DocumentNode& root = document_.nodes[0];
  graph_.range = root.range;
  graph_.range.end = std::min(root.range.end, root.range.begin + 1);
  if (!Is(&root, DocumentKind::kObject, {"a graph", ""})) return;
  constexpr std::array<std::string_view, 9> kKeys = {"texgraph", "name",       "description",
                                                     "textures", "parameters", "functions",
                                                     "nodes",    "outputs",    "$schema"};
  Owner owner{"a graph", ""};
  auto [version, name, description, textures, parameters, functions, nodes, outputs, schema] =
      Keys(root, owner, kKeys);
  ReadVersion(root, version);
  ReadName(name, file_name);
  std::string_view ignored;
  ReadText(schema, owner, ignored);
  ReadText(description, owner, graph_.description);
  graph_.main.range = graph_.range;
  ReadTextures(textures);
  ReadParameters(parameters);
  ReadFunctions(functions);
  ReadNodes(nodes, owner, graph_.main);
  if (!outputs) ReportMissing(root, owner, "outputs");
  ReadOutputs(outputs, owner, false, graph_.main);
}

uint32_t FirstEqualTexture(const Graph& graph, uint32_t index) {
  auto state = [](const Texture& t) {
    return std::tie(t.files, t.kind, t.masks, t.key, t.color_space, t.alpha_is_opacity, t.filter,
                    t.wrap_u, t.wrap_v, t.wrap_w, t.mipmaps, t.max_level, t.pack, t.grid,
                    t.match_edges, t.edge_groups, t.weights, t.map, t.legend, t.is_constant,
                    t.sprites, t.dithered, t.tiles, t.noise, t.deviations);
  };
  auto equal = [&](const Texture& a, const Texture& b) {
    // How a set of tiles is cut depends on those that are cut like it.
    if (a.kind == TextureKind::kTiles) return &a == &b;
    const bool has_of = a.kind == TextureKind::kMeans || a.kind == TextureKind::kTiling ||
                        a.kind == TextureKind::kCorners || a.kind == TextureKind::kTable;
    return state(a) == state(b) && (!has_of || a.of == b.of);
  };
  uint32_t first = 0;
  while (first < index && !equal(graph.textures[first], graph.textures[index])) ++first;
  return first;
}

std::optional<Graph> ReadGraph(SourceId source, DocumentFormat format, const Sources& sources,
                               Diagnostics& diagnostics) {
  size_t errors_before = diagnostics.error_count();
  std::optional<Document> document = ReadDocument(source, format, sources, diagnostics);
  if (!document) return std::nullopt;
  Graph graph;
  graph.document = std::move(*document);
  GraphReader(graph, diagnostics).ReadRoot(sources.Name(source));
  CheckNamespace(graph, diagnostics);
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  return graph;
}

}  // namespace texgraph::graph
