// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/synthetic_graphs.h"

#include <fmt/format.h>

namespace texgraph::bench {
namespace {

std::string Graph(const std::string& textures, const std::string& nodes,
                  const std::string& output) {
  return fmt::format(
      "{{\n  \"texgraph\": 1,\n{}  \"nodes\": {{\n{}\n  }},\n"
      "  \"outputs\": {{ \"color\": \"{}\" }}\n}}\n",
      textures, nodes, output);
}

void Separate(std::string& nodes) {
  if (!nodes.empty()) nodes += ",\n";
}

}  // namespace

std::string ChainOfAdds(int n) {
  std::string nodes = "    \"start\": { \"block\": \"ramp\" }";
  std::string last = "start";
  for (int i = 0; i < n; ++i) {
    Separate(nodes);
    nodes += fmt::format(
        "    \"sum{}\": {{ \"block\": \"add\", \"in\": {{ \"a\": \"{}\", \"b\": {}.25 }} }}", i,
        last, i + 1);
    last = fmt::format("sum{}", i);
  }
  return Graph("", nodes, last);
}

std::string NoiseAndMixPairs(int n) {
  std::string nodes = "    \"start\": { \"block\": \"ramp\" }";
  std::string last = "start";
  for (int i = 0; i < n; ++i) {
    Separate(nodes);
    nodes += fmt::format(
        "    \"cloud{0}\": {{ \"block\": \"value_noise\", \"in\": {{ \"scale\": [{1}.5, {1}.5], "
        "\"seed\": {0} }} }},\n"
        "    \"mix{0}\": {{ \"block\": \"lerp\", \"in\": {{ \"a\": \"{2}\", \"b\": \"cloud{0}\", "
        "\"amount\": 0.5 }} }}",
        i, i % 50 + 2, last);
    last = fmt::format("mix{}", i);
  }
  return Graph("", nodes, last);
}

std::string TiledImages(int n, int files) {
  std::string textures = "  \"textures\": {\n";
  for (int f = 0; f < files; ++f) {
    textures += fmt::format("    \"picture{0}\": {{ \"file\": \"picture{0}.png\" }}{1}\n", f,
                            f + 1 < files ? "," : "");
  }
  textures += "  },\n";
  std::string nodes, last;
  for (int i = 0; i < n; ++i) {
    Separate(nodes);
    nodes += fmt::format(
        "    \"image{0}\": {{ \"block\": \"tiled_image\", "
        "\"in\": {{ \"picture\": \"picture{1}\", \"tiling\": [{2}.5, {2}.5] }} }}",
        i, i % files, i + 1);
    std::string image = fmt::format("image{}", i);
    if (i > 0) {
      nodes += fmt::format(
          ",\n    \"sum{}\": {{ \"block\": \"add\", \"in\": {{ \"a\": \"{}\", \"b\": \"{}\" }} }}",
          i, last, image);
      image = fmt::format("sum{}", i);
    }
    last = image;
  }
  return Graph(textures, nodes, last);
}

std::string Diamond(int n) {
  std::string nodes = "    \"start\": { \"block\": \"ramp\" }";
  std::string last = "start";
  for (int i = 0; i < n; ++i) {
    Separate(nodes);
    nodes += fmt::format(
        "    \"step{0}\": {{ \"block\": \"add\", \"in\": {{ \"a\": \"{1}\", \"b\": \"{1}\" }} }}",
        i, last);
    last = fmt::format("step{}", i);
  }
  return Graph("", nodes, last);
}

std::string BombingInsideBombing(int depth) {
  std::string functions = R"("copy0": {"inputs": {"uv": "vec2"}, "nodes": {
    "spots": {"block": "value_noise", "in": {"uv": "uv"}},
    "image": {"block": "rgba", "in": {"color": [1, 0.5, 0], "alpha": "spots"}}},
    "outputs": {"color": "image"}})";
  for (int i = 1; i < depth; ++i) {
    functions += fmt::format(
        ", \"copy{0}\": {{ \"inputs\": {{ \"uv\": \"vec2\" }}, \"nodes\": {{ \"copies\": {{ "
        "\"block\": \"bomb\", \"in\": {{ \"image\": \"copy{1}\", \"uv\": \"uv\", "
        "\"scale\": [2, 2], \"seed\": {0} }} }} }}, "
        "\"outputs\": {{ \"color\": \"copies.color\" }} }}",
        i, i - 1);
  }
  return fmt::format(
      "{{ \"texgraph\": 1, \"functions\": {{ {} }}, \"nodes\": {{ \"field\": {{ \"block\": "
      "\"bomb\", \"in\": {{ \"image\": \"copy{}\" }} }} }}, "
      "\"outputs\": {{ \"color\": \"field.color\" }} }}",
      functions, depth - 1);
}

}  // namespace texgraph::bench
