// SPDX-License-Identifier: Apache-2.0
// Graphs that need no pictures, for tests of everything around them.
#pragma once

#include <string>
#include <string_view>

namespace texgraph {

// Bricks in grey. The parameter's value is 7.
inline constexpr std::string_view kProceduralGraph = R"({
  "texgraph": 1,
  "parameters": { "rows": { "type": "int", "value": 7, "range": [1, 64] } },
  "nodes": {
    "grid": { "block": "brick_grid", "in": { "rows": "rows", "columns": 3 } },
    "shade": { "block": "tile_random", "in": { "tile": "grid" } }
  },
  "outputs": { "height": "shade" }
}
)";

}  // namespace texgraph
