// SPDX-License-Identifier: Apache-2.0
// The whole compiler as one call: a graph's text in, a shader and its manifest out. It reads files
// (the graph's blocks, the headers of its images, and the images that it prepares) and writes none.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/base/source.h"
#include "compiler/graph/document.h"

namespace texgraph {
namespace blocks {
class Library;
}
namespace graph {
struct CheckedGraph;
struct Graph;
}  // namespace graph
namespace ir {
class Module;
}
namespace textures {
struct TextureData;
}

enum class Target : uint8_t { kGlsl330, kGlsl450, kSpirv };
// kShader: a whole fragment shader. kFunction: a GLSL function to paste into somebody's own.
enum class Emit : uint8_t { kShader, kFunction };

struct CompileOptions {
  Target target = Target::kGlsl330;
  Emit emit = Emit::kShader;
  bool optimize = true;                    // off: neither folds nor simplifies, for the tests
  std::vector<std::string> block_folders;  // -I
  std::vector<std::string> settings;       // "name=value", --set
  std::vector<std::string>
      roots;  // --root: images are read from inside these folders only; none: from anywhere
  bool validate = false;  // --validate: GLSL is also shown to glslang, as SPIR-V always is
  // Print the IR after each of these phases into Compiled::dump: "build", "specialize", "simplify",
  // "differentiate", "legalize", or "all".
  std::vector<std::string> dump_after;
  // For the manifest: the folder that it goes to ("" is the current one), to which the paths of
  // textures are made relative, and the shader's path from there; "" is the graph's name with
  // ShaderExtension().
  std::string manifest_folder;
  std::string shader_name;
  // Pictures with a mask or a colour key are prepared, and derived textures are made, as files: the
  // manifest names Compiled::files in their place. Off: the manifest names the sources of pictures,
  // and says what is to be done with them.
  bool prepare_files = false;
  // Derived textures (sheets, maps, means, ...) are made, as Compiled::textures.
  bool derive_textures = false;
};

// ".frag", ".glsl" or ".spv".
constexpr std::string_view ShaderExtension(Target target, Emit emit) {
  return target == Target::kSpirv ? ".spv" : emit == Emit::kFunction ? ".glsl" : ".frag";
}

struct Compiled {
  std::string name;             // the graph's, an identifier
  std::string glsl;             // also for kSpirv: what was given to glslang
  std::vector<uint32_t> spirv;  // kSpirv only
  std::string manifest;         // JSON, see docs/manifest.schema.json
  std::string dump;
  struct File {
    std::string name;   // in the manifest's folder, without a folder of its own
    std::string bytes;  // PNG or KTX 2.0
  };
  std::vector<File> files;  // prepare_files: those of all textures that the shader uses
  struct Texture {
    std::string file;  // what the manifest calls it
    std::shared_ptr<const textures::TextureData> data;
  };
  std::vector<Texture> textures;  // derive_textures: those that the shader uses
  std::vector<std::string>
      dependencies;  // paths of the files that were read, beside the graph itself
};

// A graph as a module after all passes: what the printer prints, and what the tests evaluate.
struct Lowered {
  Lowered();
  Lowered(Lowered&&);
  Lowered& operator=(Lowered&&);
  ~Lowered();
  std::unique_ptr<ir::Module> module;
  std::unique_ptr<graph::Graph> graph;
  std::unique_ptr<blocks::Library> library;
  std::unique_ptr<graph::CheckedGraph> checked;
  std::string dump;
};
std::optional<Lowered> Lower(SourceId source, graph::DocumentFormat format,
                             const CompileOptions& options, Sources& sources,
                             Diagnostics& diagnostics);

// Nothing if the graph is wrong, with every mistake in `diagnostics`. `source` is the graph's text;
// image paths in it are relative to its folder.
std::optional<Compiled> Compile(SourceId source, graph::DocumentFormat format,
                                const CompileOptions& options, Sources& sources,
                                Diagnostics& diagnostics);

}  // namespace texgraph
