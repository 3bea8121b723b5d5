// SPDX-License-Identifier: Apache-2.0
// Prints a legalised module as GLSL that a person can read and edit: sections inputs, parameters,
// textures, outputs, types, constants, blocks, main; the user's names; one short comment a node. It
// cannot fail, and the text depends on its arguments alone.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "compiler/ir/module.h"

namespace texgraph::glsl {

enum class Dialect : uint8_t { k330, k450 };

struct PrintOptions {
  Dialect dialect = Dialect::k330;
  // A function named `name` instead of main, without #version and layouts: the graph's inputs are
  // its parameters; a single output is its return value, several are out parameters.
  bool as_function = false;
  std::string name;     // of the graph: an identifier
  std::string version;  // of texgraphc, for the first comment
  // Specialisation constants get their constant_id, which only glslang takes, on the way to SPIR-V;
  // and bool uniforms become uint, since SPIR-V has no bool in memory.
  bool for_spirv = false;
};

// What a printed shader declares, for whoever has to bind it. Only what the shader uses is there.
struct ShaderInterface {
  static constexpr uint32_t kNone = 0xffffffffu;
  struct Entry {
    ir::GlobalId global;
    std::string name;              // in the shader: the graph's, unless it clashes with another
    uint32_t location = kNone;     // inputs, uniforms and textures, with k450
    uint32_t binding = kNone;      // textures, with k450
    uint32_t constant_id = kNone;  // specialisation constants, for_spirv
  };
  struct Output {
    std::string
        name;  // in the shader: "out_color"; with as_function the name of the out parameter, or ""
    ir::TypeId type;
    uint32_t location = kNone;  // the index among main's results
  };
  std::vector<Entry> inputs, uniforms, specializations, textures;
  std::vector<Output> outputs;  // in the order of main's results
  std::string entry_point;      // main, or the function's name, which gives way to a global's
};

std::string PrintGlsl(const ir::Module& module, const PrintOptions& options,
                      ShaderInterface* interface = nullptr);

}  // namespace texgraph::glsl
