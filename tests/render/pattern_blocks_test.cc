// SPDX-License-Identifier: Apache-2.0
// The blocks that choose patterns, on the GPU against the CPU: the same pattern in every cell, to
// the bit, also a million cells away.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "compiler/compile.h"
#include "compiler/graph/graph.h"
#include "tests/fuzz/graph_textures.h"
#include "tests/render/render_check.h"

namespace texgraph::test {
namespace {

// A number for each cell; nothing of it is a fraction.
std::string GraphOf(const std::string& number) {
  return R"({"texgraph": 1, "textures": {
      "stuff": {"lists": [[0, 0, 1], [2, 3, 3], [4, 5, 6]]},
      "still": {"lists": [[7, 1, 1, 9], [3, 2, 1, 0]], "binding": "constant"},
      "where": {"map": [[0, 1, 2], [2, 1, -1], [1, 0, 2], [2, 2, 1]]}},
    "nodes": {
      "tiles": {"block": "virtual_tile_map", "in": {"cells": [2, 2], "seed": 5}},
      "wide": {"block": "virtual_tile_map", "in": {"cells": [12, 16], "toroidal": true}},
      )" +
         number + R"(}, "outputs": {"height": "n"}})";
}

struct PatternCase {
  const char* name;
  const char* node;
};

class PatternBlocks : public testing::TestWithParam<PatternCase> {};

// O4, and of the copies of bombing and the points of Voronoi, too.
TEST_P(PatternBlocks, AreEqualToTheBit) {
  for (const std::array<double, 4>& window : {std::array<double, 4>{0, 0, 1, 1},
                                              {-40.25, -17.5, 23.75, 46.5},
                                              {524288 - 35, -524288, 524288 - 3, -524288 + 32}}) {
    for (bool optimize : {true, false}) {
      Sources sources;
      Diagnostics diagnostics;
      SourceId source = sources.Add("patterns.json", GraphOf(GetParam().node));
      CompileOptions options;
      options.optimize = optimize;
      auto lowered = Lower(source, graph::DocumentFormat::kJson, options, sources, diagnostics);
      ASSERT_TRUE(lowered) << FormatDiagnostics(diagnostics, sources, false);
      CheckOptions check;
      check.width = check.height = 128;
      check.window = window;
      check.textures = fuzz::LoadGraphTextures(*lowered->graph, "", false);
      const CheckReport report = CompareCpuAndGpu(*lowered->module, check);
      ASSERT_EQ(report.error, "");
      ASSERT_EQ(report.outputs.size(), 1u);
      const OutputDifference& output = report.outputs[0];
      EXPECT_EQ(output.identical, output.cpu.size())
          << GetParam().name << " at " << window[0] << ", optimised " << optimize << "\n"
          << report.Text();
      if (window[0] != 0) {
        EXPECT_NE(*std::ranges::min_element(output.cpu), *std::ranges::max_element(output.cpu));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Blocks, PatternBlocks,
    testing::Values(PatternCase{"virtual_indirection_map",
                                R"("n": {"block": "virtual_indirection_map", "in": {"tile": "tiles",
                        "patterns": 65536}})"},
                    PatternCase{"virtual_indirection_map_stream",
                                R"("n": {"block": "virtual_indirection_map", "in": {"tile": "tiles",
                        "patterns": 1000, "stream": 3}})"},
                    PatternCase{"permutation",
                                R"("n": {"block": "virtual_indirection_map", "in": {"tile": "tiles",
                        "patterns": 256, "randomness": "permutation"}})"},
                    PatternCase{"explicit_indirection_map",
                                R"("n": {"block": "explicit_indirection_map", "in": {"map": "where",
                        "tile": "tiles"}})"},
                    PatternCase{"materials_map",
                                R"("m": {"block": "explicit_indirection_map", "in": {"map": "where",
                        "tile": "tiles"}},
                       "n": {"block": "materials_map", "in": {"lists": "stuff", "material": "m",
                        "tile": "tiles"}})"},
                    PatternCase{"constant_lists",
                                R"("m": {"block": "explicit_indirection_map", "in": {"map": "where",
                        "tile": "tiles"}},
                       "f": {"block": "to_float", "in": {"value": "m"}},
                       "beyond": {"block": "to_int", "in": {"value": "f"}},
                       "n": {"block": "materials_map", "in": {"lists": "still",
                        "material": "beyond", "tile": "tiles", "stream": 2}})"},
                    PatternCase{
                        "areas_map",
                        R"("n": {"block": "areas_map", "in": {"areas": "where", "tile": "wide",
                        "cells": [12, 16]}})"},
                    PatternCase{"dithered_areas_map",
                                R"("n": {"block": "dithered_areas_map", "in": {"areas": "where",
                        "tile": "wide", "cells": [12, 16]}})"},
                    PatternCase{"transition_tiles",
                                R"("m": {"block": "dithered_areas_map", "in": {"areas": "where",
                        "tile": "wide", "cells": [12, 16]}},
                       "t": {"block": "transition_tiles", "in": {"material": "m",
                        "families": [0, 1, 0], "transitions": [-1, 7, 2, 9, 4, 1, 0, 3, 14, 11, 5,
                        6, 13, 8, 12, -1]}},
                       "n": {"block": "to_float", "in": {"value": "t.transition"}})"},
                    // The copy of the highest rank of three in each cell, and its numbers.
                    PatternCase{"bomb",
                                R"("copies": {"block": "bomb", "in": {"image": [1, 1, 1, 1],
                        "scale": [1, 1], "jitter": 0, "copies": 3, "edges": false}},
                       "n": {"block": "tile_random", "in": {"tile": "copies.tile"}})"},
                    PatternCase{"bomb3",
                                R"("p": {"block": "components", "in": {"vector": "uv"}},
                       "place": {"block": "combine3", "in": {"x": "p.x", "y": "p.y", "z": "p.x"}},
                       "copies": {"block": "bomb3", "in": {"image": [1, 1, 1, 1], "uv": "place",
                        "scale": [1, 1, 1], "jitter": 0, "copies": 3, "edges": false}},
                       "n": {"block": "tile_random", "in": {"tile": "copies.tile"}})"},
                    PatternCase{"voronoi",
                                R"("cells": {"block": "voronoi", "in": {"scale": [1, 1],
                        "jitter": 0, "seed": 3}},
                       "n": {"block": "tile_random", "in": {"tile": "cells.tile"}})"},
                    PatternCase{"voronoi_in_space",
                                R"("p": {"block": "components", "in": {"vector": "uv"}},
                       "place": {"block": "combine3", "in": {"x": "p.x", "y": "p.y", "z": "p.x"}},
                       "cells": {"block": "voronoi", "in": {"uv": "place", "scale": [1, 1, 1],
                        "jitter": 0, "seed": 3}},
                       "n": {"block": "tile_random", "in": {"tile": "cells.tile"}})"}),
    [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace texgraph::test
