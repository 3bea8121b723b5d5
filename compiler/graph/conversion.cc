// SPDX-License-Identifier: Apache-2.0
#include "compiler/graph/conversion.h"

#include <fmt/format.h>

#include <initializer_list>
#include <string_view>
#include <vector>

#include "compiler/base/text.h"

namespace texgraph::graph {
namespace {

struct Converter {
  std::string_view from, to;
  std::initializer_list<std::string_view> blocks;
};

const Converter kConverters[] = {
    {"vec4", "vec3", {"rgb"}},
    {"vec4", "vec2", {"xy"}},
    {"vec4", "float", {"channel", "luminance"}},
    {"vec3", "vec4", {"rgba"}},
    {"vec3", "vec2", {"xy"}},
    {"vec3", "float", {"luminance", "magnitude", "dot_product"}},
    {"vec2", "float", {"magnitude", "dot_product"}},
    {"vec2", "vec4", {"combine4"}},
    {"vec2", "vec3", {"combine3"}},
    {"float", "int", {"to_int"}},
    {"float", "bool", {"compare"}},
    {"uint", "int", {"to_int"}},
    {"uint", "float", {"random", "to_float"}},
    {"bool", "float", {"to_float", "select"}},
    {"Tile", "float", {"tile_random", "tile_distance"}},
    {"Tile", "vec2", {"tile_uv"}},
    {"Tile", "vec3", {"tile_random_color"}},
    {"Material", "float", {"material_parts"}},
    {"Material", "vec3", {"material_parts"}},
    {"Material", "vec4", {"material_parts"}},
    {"vec4", "Material", {"material"}},
};

// What nothing converts to, and the overload of a block that makes one.
struct Maker {
  std::string_view to, block, from;
};
constexpr Maker kMakers[] = {
    {"Tile1", "virtual_tile_map", "float"},
    {"Tile3", "virtual_tile_map", "vec3"},
};

}  // namespace

std::optional<int> ConversionCost(ir::TypeId from, ir::TypeId to) {
  if (from == to) return 0;
  if (!ir::IsVector(from) || !ir::IsVector(to) || !ir::IsScalar(from)) return std::nullopt;
  int cost = ir::IsScalar(to) ? 0 : 1;
  if (ir::ScalarOf(from) == ir::ScalarOf(to)) return cost;
  if (from == ir::kInt && ir::ScalarOf(to) == ir::Scalar::kFloat) return cost + 1;
  return std::nullopt;
}

std::string ConvertingBlocks(ir::TypeId from, ir::TypeId to, const ir::Types& types,
                             const blocks::Library& library) {
  std::string from_name = types.Text(from), to_name = types.Text(to);
  std::vector<std::string_view> found;
  for (const Converter& converter : kConverters) {
    if (converter.from != from_name || converter.to != to_name) continue;
    for (std::string_view block : converter.blocks) {
      if (library.Exists(block)) found.push_back(block);
    }
  }
  for (const Maker& maker : kMakers) {
    if (maker.to != to_name || !library.Exists(maker.block)) continue;
    return fmt::format("; the block '{}' makes one of a {}", maker.block, maker.from);
  }
  if (found.empty()) return {};
  if (found.size() == 1) return fmt::format("; the block '{}' converts", found[0]);
  return "; the blocks " + ListedQuoted(found, " and ") + " convert";
}

}  // namespace texgraph::graph
