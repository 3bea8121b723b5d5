// SPDX-License-Identifier: Apache-2.0
// Runs blocks of the library on the CPU, so that tests can compare them with mathematics: a single
// overload on values of its ports (RunBlock), or a graph at points of the texture plane with a
// given size of pixel (RunGraph), before and after optimisation.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "compiler/ir/texture.h"
#include "compiler/ir/type.h"

namespace texgraph::blocks {

// Many values of one type. Word w of value i is at words[w * count + i].
struct Values {
  ir::TypeId type;
  size_t count = 0;
  std::vector<uint32_t> words;

  float Float(size_t i, size_t component = 0) const;
  int32_t Int(size_t i, size_t component = 0) const {
    return static_cast<int32_t>(Uint(i, component));
  }
  uint32_t Uint(size_t i, size_t component = 0) const { return words[component * count + i]; }
};

using Vector = std::vector<double>;  // the components of one value

Values Floats(const std::vector<double>& values);
Values Ints(const std::vector<int32_t>& values);
Values Uints(const std::vector<uint32_t>& values);
Values Bools(const std::vector<bool>& values);
// Floats (of one component) or vectors of 2, 3 or 4; ivec2.
Values Vectors(const std::vector<Vector>& values);
// A texture of one level with the numbers in its first channel, row by row from v = 0: what a map
// is to a shader.
ir::Texture MapOf(const std::vector<std::vector<double>>& rows);
// The middles of side * side equal squares between low and high in both directions, row by row.
std::vector<Vector> Lattice(double low, double high, int side);
Values CellsOf(const std::vector<std::pair<int32_t, int32_t>>& cells);

// A word of an enumeration, for a template port.
struct Word {
  std::string word;
};

// The elements of an array, for a template port.
struct List {
  Values elements;
};

struct Argument {
  Argument(std::string name, Values v) : port(std::move(name)), values(std::move(v)) {}
  Argument(std::string name, Word w) : port(std::move(name)), word(std::move(w.word)) {}
  Argument(std::string name, List l)
      : port(std::move(name)), values(std::move(l.elements)), is_list(true) {}
  // A texture must live until the block has run.
  Argument(std::string name, const ir::Texture& t) : port(std::move(name)), texture(&t) {}
  std::string port;
  Values values;     // one value stands for all; for template ports one
  std::string word;  // instead of `values`
  const ir::Texture* texture = nullptr;
  bool is_list = false;
};

// The outputs by name ("result" for the return value). Ports that are not given have their
// defaults. The overload is the one whose ports have the names and types of the arguments. Fails
// the test, with no outputs, if there is none. Values 4q to 4q + 3 are the pixels of a quad for
// footprints.
std::map<std::string, Values> RunBlock(std::string_view block,
                                       const std::vector<Argument>& arguments);

struct Point {
  double x = 0;
  double y = 0;
};

// The folder of the pictures that the graphs of RunGraph use, if none is given.
std::string PictureFolder();

// The graph's outputs at points of the texture plane, `pixel` being how much uv changes from one
// pixel to the next, to the right and upwards. `text` is a graph in JSON or JSONC that seems to lie in
// `folder`. Evaluates it once with all optimisations and once without any, and fails the test where
// they differ by more than `tolerance`. What `textures` has stands in place of the graph's textures
// of these names.
std::map<std::string, Values> RunGraph(std::string_view text, const std::vector<Point>& points,
                                       Point pixel, double tolerance = 1e-4,
                                       const std::string& folder = PictureFolder(),
                                       const std::map<std::string, ir::Texture>& textures = {});

}  // namespace texgraph::blocks
