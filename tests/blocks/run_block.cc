// SPDX-License-Identifier: Apache-2.0
#include "tests/blocks/run_block.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "compiler/base/builtin_input.h"
#include "compiler/base/diagnostics.h"
#include "compiler/base/source.h"
#include "compiler/blocks/block.h"
#include "compiler/compile.h"
#include "compiler/graph/checked_graph.h"
#include "compiler/graph/graph.h"
#include "compiler/ir/evaluate.h"
#include "compiler/ir/module.h"
#include "compiler/ir/verify.h"
#include "compiler/manifest/graph_textures.h"
#include "compiler/textures/texels.h"

namespace texgraph::blocks {

float Values::Float(size_t i, size_t component) const {
  return std::bit_cast<float>(Uint(i, component));
}

namespace {

uint32_t FloatBits(double value) { return std::bit_cast<uint32_t>(static_cast<float>(value)); }

// `values` in `lanes` lanes: repeated if there is one, else the last once more at the end.
std::vector<uint32_t> Spread(const Values& values, size_t lanes) {
  size_t width = values.words.size() / values.count;
  std::vector<uint32_t> words(width * lanes);
  for (size_t w = 0; w < width; ++w) {
    for (size_t lane = 0; lane < lanes; ++lane) {
      words[w * lanes + lane] = values.Uint(std::min(lane, values.count - 1), w);
    }
  }
  return words;
}

Values Narrow(ir::TypeId type, const std::vector<uint32_t>& words, size_t lanes, size_t count) {
  Values values{type, count, {}};
  for (size_t w = 0; w < words.size() / lanes; ++w) {
    values.words.insert(values.words.end(), words.begin() + static_cast<ptrdiff_t>(w * lanes),
                        words.begin() + static_cast<ptrdiff_t>(w * lanes + count));
  }
  return values;
}

const Argument* FindArgument(const std::vector<Argument>& arguments, const std::string& port) {
  for (const Argument& argument : arguments) {
    if (argument.port == port) {
      return &argument;
    }
  }
  return nullptr;
}

// The input of a graph that is zero unless a block asks for another.
bool IsZeroByDefault(const Port& port) {
  return std::ranges::any_of(kBuiltinInputs, [&](const BuiltinInput& input) {
    return input.kind == BuiltinKind::kZero && input.name == port.default_input;
  });
}

std::vector<uint32_t> DefaultWords(const ir::Module& module, const Port& port) {
  if (IsZeroByDefault(port)) return std::vector<uint32_t>(module.types.Words(port.type));
  std::span<const uint32_t> words = module.Words(port.default_value);
  return {words.begin(), words.end()};
}

ir::TypeId SamplerOf(const ir::Texture& texture) {
  if (texture.is_array) return ir::kSampler2DArray;
  return texture.is_3d ? ir::kSampler3D : ir::kSampler2D;
}

bool HasTypeOf(const Argument& argument, const Port& port, const ir::Types& types) {
  if (argument.texture != nullptr) return port.type == SamplerOf(*argument.texture);
  if (argument.is_list) {
    return types.Kind(port.type) == ir::TypeKind::kArray &&
           types.ElementType(port.type, 0) == argument.values.type;
  }
  return !argument.word.empty() || argument.values.type == port.type;
}

bool Fits(const Overload& overload, const std::vector<Argument>& arguments,
          const ir::Types& types) {
  size_t used = 0;
  for (const Port& port : overload.inputs) {
    const Argument* argument = FindArgument(arguments, port.name);
    if (argument == nullptr) {
      if (!port.default_value.valid() && !IsZeroByDefault(port)) {
        return false;
      }
      continue;
    }
    ++used;
    if (!HasTypeOf(*argument, port, types)) {
      return false;
    }
  }
  return used == arguments.size();
}

ir::ConstId TemplateValue(ir::Module& module, const Port& port, const Argument* argument) {
  if (argument == nullptr) {
    return port.default_value;
  }
  if (argument->is_list) {
    const Values& elements = argument->values;
    const ir::TypeId type =
        module.types.Array(elements.type, static_cast<uint32_t>(elements.count));
    const size_t width = elements.words.size() / elements.count;
    std::vector<uint32_t> words;
    for (size_t i = 0; i < elements.words.size(); ++i) {
      words.push_back(elements.Uint(i / width, i % width));
    }
    return module.Intern(type, words);
  }
  if (argument->word.empty()) {
    return module.Intern(port.type, argument->values.words);
  }
  for (const EnumWord& word : port.words) {
    if (word.word == argument->word) {
      uint32_t bits = static_cast<uint32_t>(word.value);
      return module.Intern(port.type, std::span<const uint32_t>(&bits, 1));
    }
  }
  ADD_FAILURE() << "port " << port.name << " has no word " << argument->word;
  return port.default_value;
}

}  // namespace

Values Floats(const std::vector<double>& values) {
  Values result{ir::kFloat, values.size(), {}};
  for (double value : values) {
    result.words.push_back(FloatBits(value));
  }
  return result;
}

Values Ints(const std::vector<int32_t>& values) {
  return {ir::kInt, values.size(), std::vector<uint32_t>(values.begin(), values.end())};
}

Values Uints(const std::vector<uint32_t>& values) { return {ir::kUint, values.size(), values}; }

Values Bools(const std::vector<bool>& values) {
  return {ir::kBool, values.size(), std::vector<uint32_t>(values.begin(), values.end())};
}

std::vector<Vector> Lattice(double low, double high, int side) {
  std::vector<Vector> uv;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      uv.push_back({low + (high - low) * (x + 0.5) / side, low + (high - low) * (y + 0.5) / side});
    }
  }
  return uv;
}

Values Vectors(const std::vector<Vector>& values) {
  size_t width = values[0].size();
  Values result{ir::Vector(ir::Scalar::kFloat, static_cast<uint32_t>(width)), values.size(), {}};
  for (size_t w = 0; w < width; ++w) {
    for (const Vector& value : values) {
      result.words.push_back(FloatBits(value[w]));
    }
  }
  return result;
}

ir::Texture MapOf(const std::vector<std::vector<double>>& rows) {
  ir::Texture map;
  map.sampler.filter = ir::Filter::kNearest;
  map.sampler.mip_filter = ir::MipFilter::kNone;
  ir::Texture::Level level;
  level.width = static_cast<uint32_t>(rows[0].size());
  level.height = static_cast<uint32_t>(rows.size());
  for (const std::vector<double>& row : rows) {
    for (double number : row) level.texels.push_back({static_cast<float>(number), 0, 0, 1});
  }
  map.levels.push_back(std::move(level));
  return map;
}

Values CellsOf(const std::vector<std::pair<int32_t, int32_t>>& cells) {
  Values result{ir::kIvec2, cells.size(), {}};
  for (const auto& [column, row] : cells) {
    result.words.push_back(static_cast<uint32_t>(column));
  }
  for (const auto& [column, row] : cells) {
    result.words.push_back(static_cast<uint32_t>(row));
  }
  return result;
}

std::map<std::string, Values> RunBlock(std::string_view name,
                                       const std::vector<Argument>& arguments) {
  ir::Module module;
  Sources sources;
  Diagnostics diagnostics;
  Library library(module, sources, diagnostics);
  const Block* block = library.Find(name);
  const Overload* overload = nullptr;
  for (size_t i = 0; block != nullptr && i < block->overloads.size() && overload == nullptr; ++i) {
    overload = Fits(block->overloads[i], arguments, module.types) ? &block->overloads[i] : nullptr;
  }
  if (overload == nullptr) {
    ADD_FAILURE() << "no overload of block " << name << " fits\n"
                  << FormatDiagnostics(diagnostics, sources, false);
    return {};
  }
  size_t count = 1;
  for (const Argument& argument : arguments) {
    if (!argument.is_list) count = std::max(count, argument.values.count);
  }
  size_t lanes = (count + 3) / 4 * 4;
  ir::EvaluateInputs inputs;
  inputs.lanes = static_cast<uint32_t>(lanes);
  std::vector<ir::ConstId> template_values;
  std::vector<std::vector<uint32_t>> columns;
  for (const Port& port : overload->inputs) {
    const Argument* argument = FindArgument(arguments, port.name);
    if (port.kind == PortKind::kTexture) {
      const ir::GlobalId global =
          module.AddGlobal({ir::GlobalKind::kTexture, port.name, port.type, {}});
      inputs.textures.resize(module.globals.size());
      inputs.textures[global.index] = argument->texture;
      columns.push_back({global.index});
    } else if (port.kind == PortKind::kTemplate) {
      template_values.push_back(TemplateValue(module, port, argument));
    } else if (argument != nullptr) {
      columns.push_back(Spread(argument->values, lanes));
    } else {
      columns.push_back(Spread({port.type, 1, DefaultWords(module, port)}, lanes));
    }
  }
  ir::FunctionId function = library.Function(*block, *overload, template_values);
  if (!function.valid() || diagnostics.HasErrors()) {
    ADD_FAILURE() << FormatDiagnostics(diagnostics, sources, false);
    return {};
  }
  EXPECT_EQ(ir::Verify(module), "");
  inputs.globals.resize(module.globals.size());
  inputs.textures.resize(module.globals.size());
  std::vector<std::vector<uint32_t>> results = ir::Evaluate(module, function, inputs, columns);
  std::map<std::string, Values> outputs;
  for (size_t i = 0; i < overload->outputs.size(); ++i) {
    outputs[overload->outputs[i].name] =
        Narrow(overload->outputs[i].type, results[i], lanes, count);
  }
  return outputs;
}

namespace {

// The graph with its module, or nothing, with the diagnostics as test failures.
// `sources` must live as long as it: names point into the text.
std::optional<Lowered> LowerGraph(std::string_view text, const std::string& folder, bool optimize,
                                  Sources& sources, Diagnostics& diagnostics) {
  SourceId source = sources.Add(folder + "test.jsonc", std::string(text));
  CompileOptions options;
  options.optimize = optimize;
  std::optional<Lowered> lowered =
      Lower(source, graph::DocumentFormat::kJsonc, options, sources, diagnostics);
  if (!lowered.has_value()) {
    ADD_FAILURE() << FormatDiagnostics(diagnostics, sources, false);
  } else {
    EXPECT_EQ(ir::Verify(*lowered->module), "");
  }
  return lowered;
}

// The graph's textures by the module's globals.
struct Textures {
  std::vector<ir::Texture> textures;
  std::vector<const ir::Texture*> by_global;
};

Textures LoadTextures(const Lowered& lowered, const std::string& folder,
                      const std::map<std::string, ir::Texture>& given) {
  const ir::Module& module = *lowered.module;
  Textures loaded;
  loaded.textures.reserve(module.globals.size());
  loaded.by_global.resize(module.globals.size());
  for (size_t i = 0; i < module.globals.size(); ++i) {
    for (uint32_t t = 0; t < lowered.graph->textures.size(); ++t) {
      const graph::Texture& texture = lowered.graph->textures[t];
      if (module.globals[i].kind != ir::GlobalKind::kTexture ||
          module.globals[i].name != texture.name) {
        continue;
      }
      if (auto known = given.find(std::string(texture.name)); known != given.end()) {
        loaded.by_global[i] = &known->second;
        continue;
      }
      Diagnostics diagnostics;
      auto data = manifest::MakeGraphTexture(*lowered.graph, t, folder, {}, diagnostics);
      EXPECT_TRUE(data.has_value());
      if (!data) continue;
      loaded.textures.push_back(textures::ToTexture(*data));
      loaded.by_global[i] = &loaded.textures.back();
    }
  }
  return loaded;
}

// A quad at each point, the point itself at its lower left.
std::vector<uint32_t> QuadsOf(const std::vector<Point>& points, Point pixel) {
  size_t lanes = 4 * points.size();
  std::vector<uint32_t> words(2 * lanes);
  for (size_t lane = 0; lane < lanes; ++lane) {
    const Point& p = points[lane / 4];
    words[lane] = FloatBits(p.x + (lane % 2) * pixel.x);
    words[lanes + lane] = FloatBits(p.y + (lane / 2 % 2) * pixel.y);
  }
  return words;
}

std::map<std::string, Values> EvaluateGraph(const Lowered& lowered, const std::string& folder,
                                            const std::vector<Point>& points, Point pixel,
                                            const std::map<std::string, ir::Texture>& given) {
  const ir::Module& module = *lowered.module;
  Textures textures = LoadTextures(lowered, folder, given);
  size_t lanes = 4 * points.size();
  ir::EvaluateInputs inputs;
  inputs.lanes = static_cast<uint32_t>(lanes);
  inputs.globals.resize(module.globals.size());
  inputs.textures = textures.by_global;
  for (size_t i = 0; i < module.globals.size(); ++i) {
    if (module.globals[i].kind == ir::GlobalKind::kInput) {
      inputs.globals[i] =
          module.globals[i].name == "uv"
              ? QuadsOf(points, pixel)
              : std::vector<uint32_t>(module.types.Words(module.globals[i].type) * lanes);
    }
  }
  std::vector<std::vector<uint32_t>> results = ir::Evaluate(module, module.main, inputs);
  std::map<std::string, Values> outputs;
  const ir::Function& main = module[module.main];
  for (size_t i = 0; i < main.results.size(); ++i) {
    Values values{main.results[i].type, points.size(), {}};
    for (size_t w = 0; w < results[i].size() / lanes; ++w) {
      for (size_t p = 0; p < points.size(); ++p) {
        values.words.push_back(results[i][w * lanes + 4 * p]);
      }
    }
    outputs[main.results[i].name] = std::move(values);
  }
  return outputs;
}

}  // namespace

std::string PictureFolder() { return TEXGRAPH_SOURCE_DIR "/graphs/brick_wall/"; }

std::map<std::string, Values> RunGraph(std::string_view text, const std::vector<Point>& points,
                                       Point pixel, double tolerance, const std::string& folder,
                                       const std::map<std::string, ir::Texture>& textures) {
  Sources sources;
  Diagnostics diagnostics;
  std::optional<Lowered> plain = LowerGraph(text, folder, false, sources, diagnostics);
  std::optional<Lowered> optimized = LowerGraph(text, folder, true, sources, diagnostics);
  if (!plain.has_value() || !optimized.has_value()) {
    return {};
  }
  std::map<std::string, Values> expected = EvaluateGraph(*plain, folder, points, pixel, textures);
  std::map<std::string, Values> outputs =
      EvaluateGraph(*optimized, folder, points, pixel, textures);
  for (const auto& [name, values] : outputs) {
    for (size_t i = 0; i < values.words.size(); ++i) {
      double seen = std::bit_cast<float>(values.words[i]);
      double wanted = std::bit_cast<float>(expected[name].words[i]);
      if (!(std::fabs(seen - wanted) <= tolerance)) {
        const Point& p = points[i % points.size()];
        ADD_FAILURE() << name << " at (" << p.x << ", " << p.y << "): optimised " << seen
                      << ", unoptimised " << wanted;
        return outputs;
      }
    }
  }
  return outputs;
}

}  // namespace texgraph::blocks
