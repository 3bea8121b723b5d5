// SPDX-License-Identifier: Apache-2.0
#include "compiler/compile.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/base/files.h"
#include "compiler/blocks/block.h"
#include "compiler/glsl/legalize.h"
#include "compiler/glsl/print_glsl.h"
#include "compiler/ir/print.h"
#include "compiler/ir/verify.h"
#include "compiler/manifest/check_textures.h"
#include "compiler/manifest/graph_textures.h"
#include "compiler/manifest/manifest.h"
#include "compiler/manifest/pictures.h"
#include "compiler/passes/passes.h"
#include "compiler/spirv/compile_spirv.h"
#include "compiler/textures/ktx2.h"
#include "compiler/textures/prepare.h"

namespace texgraph {
namespace {

// The pictures that the manifest names instead of their sources. False if one cannot be made.
bool PreparePictures(const graph::Graph& graph, const std::vector<bool>& used,
                     const std::string& folder, const Roots& roots, Compiled& compiled,
                     Diagnostics& diagnostics) {
  for (uint32_t t = 0; t < graph.textures.size(); ++t) {
    const graph::Texture& texture = graph.textures[t];
    if (!used[t] || !texture.IsPrepared() || graph::FirstEqualTexture(graph, t) != t) continue;
    for (size_t layer = 0; layer < texture.files.size(); ++layer) {
      auto picture =
          textures::ReadPicture(manifest::PictureOf(texture, layer, folder), diagnostics, roots);
      if (!picture) return false;
      std::optional<std::string> png = textures::EncodePng(*picture);
      if (!png) {
        diagnostics.Error(DiagnosticKind::kOutOfMemory, texture.file_ranges[layer],
                          "there is not enough memory to write this picture");
        return false;
      }
      compiled.files.push_back({manifest::PreparedName(graph, t, layer), std::move(*png)});
    }
  }
  return true;
}

// Everything that is made beside the shader, and the manifest that names it. False if something
// cannot be made.
bool MakeTextures(const Lowered& lowered, const glsl::ShaderInterface& interface,
                  const CompileOptions& options, const std::string& folder, Compiled& compiled,
                  Diagnostics& diagnostics) {
  const graph::Graph& graph = *lowered.graph;
  std::vector<manifest::DerivedTexture> derived;
  if (options.prepare_files || options.derive_textures) {
    const Roots roots(options.roots, diagnostics);
    const std::vector<bool> used = manifest::UsedTextures(graph, *lowered.module, interface);
    auto made = manifest::DeriveTextures(graph, used, folder, roots, diagnostics);
    if (!made) return false;
    derived = std::move(*made);
    if (options.prepare_files &&
        !PreparePictures(graph, used, folder, roots, compiled, diagnostics))
      return false;
  }
  for (const manifest::DerivedTexture& texture : derived) {
    const std::string name = manifest::DerivedName(graph, texture.texture);
    if (options.prepare_files)
      compiled.files.push_back({name, textures::EncodeKtx2(*texture.data)});
    if (options.derive_textures) compiled.textures.push_back({name, texture.data});
  }
  compiled.manifest = manifest::PrintManifest(*lowered.checked, *lowered.module, interface, options,
                                              folder, derived);
  return true;
}

std::vector<std::string> Dependencies(const Lowered& lowered, const std::string& folder) {
  std::vector<std::string> paths = lowered.library->FilesRead();
  for (const graph::Texture& texture : lowered.graph->textures) {
    for (std::string_view file : texture.files) paths.push_back(JoinPath(folder, file));
    for (const graph::Mask& mask : texture.masks) paths.push_back(JoinPath(folder, mask.file));
  }
  std::ranges::sort(paths);
  paths.erase(std::ranges::unique(paths).begin(), paths.end());
  return paths;
}

glsl::Dialect DialectOf(Target target) {
  return target == Target::kGlsl330 ? glsl::Dialect::k330 : glsl::Dialect::k450;
}

// Nothing is printed of a module that breaks the rules: what is written is valid or not there.
bool IsWellFormed(const ir::Module& module, SourceRange where, Diagnostics& diagnostics) {
  std::string violation = ir::Verify(module);
  if (violation.empty()) return true;
  diagnostics.Error(DiagnosticKind::kInternal, where,
                    fmt::format("the passes made a wrong module: {}; please report this",
                                Printable(violation, 300)));
  return false;
}

// A function as somebody would paste it, as a whole shader.
std::string Pasted(const std::string& function, glsl::Dialect dialect) {
  return fmt::format("#version {}\n{}\nvoid main() {{}}\n",
                     dialect == glsl::Dialect::k330 ? "330" : "450 core", function);
}

// Appends the module's text to the dump if it was asked for.
class Dumper {
 public:
  Dumper(const CompileOptions& options, const ir::Module& module, std::string& text)
      : options_(options), module_(module), text_(text) {}
  void After(std::string_view phase) {
    bool wanted = std::ranges::any_of(options_.dump_after, [&](const std::string& name) {
      return name == phase || name == "all";
    });
    if (wanted) text_ += fmt::format("// after {}\n{}\n", phase, ir::Print(module_));
  }

 private:
  const CompileOptions& options_;
  const ir::Module& module_;
  std::string& text_;
};

}  // namespace

Lowered::Lowered() : module(std::make_unique<ir::Module>()) {}
Lowered::Lowered(Lowered&&) = default;
Lowered& Lowered::operator=(Lowered&&) = default;
Lowered::~Lowered() = default;

std::optional<Lowered> Lower(SourceId source, graph::DocumentFormat format,
                             const CompileOptions& options, Sources& sources,
                             Diagnostics& diagnostics) {
  Lowered lowered;
  ir::Module& module = *lowered.module;
  Dumper dump(options, module, lowered.dump);
  std::vector<graph::Setting> settings =
      graph::ReadSettings(options.settings, sources, diagnostics);
  auto read = graph::ReadGraph(source, format, sources, diagnostics);
  if (!read) return std::nullopt;
  lowered.graph = std::make_unique<graph::Graph>(std::move(*read));
  lowered.library = std::make_unique<blocks::Library>(module, sources, diagnostics,
                                                      options.block_folders, options.optimize);
  auto checked = graph::CheckGraph(*lowered.graph, settings, *lowered.library, module, diagnostics);
  manifest::CheckTextures(*lowered.graph, std::string(FolderOf(sources.Name(source))),
                          options.roots, diagnostics);
  if (checked) CheckMapMultiples(*checked, module, diagnostics);
  if (checked) CheckPatternRanges(*checked, module, diagnostics);
  if (!checked || diagnostics.HasErrors()) return std::nullopt;
  lowered.checked = std::make_unique<graph::CheckedGraph>(std::move(*checked));

  if (!passes::BuildModule(*lowered.checked, *lowered.library, module, options.optimize,
                           diagnostics)) {
    return std::nullopt;
  }
  dump.After("build");
  if (!passes::Specialize(module, options.optimize, lowered.graph->range, diagnostics))
    return std::nullopt;
  dump.After("specialize");
  if (options.optimize) passes::Simplify(module);
  dump.After("simplify");
  const std::vector<bool> changed = passes::Differentiate(module, options.optimize);
  if (options.optimize) passes::Simplify(module, changed);
  dump.After("differentiate");
  const SourceRange where = lowered.graph->range;
  if (!glsl::Legalize(module, DialectOf(options.target), diagnostics, where)) return std::nullopt;
  dump.After("legalize");
  return lowered;
}

std::optional<Compiled> Compile(SourceId source, graph::DocumentFormat format,
                                const CompileOptions& options, Sources& sources,
                                Diagnostics& diagnostics) {
  std::optional<Lowered> lowered = Lower(source, format, options, sources, diagnostics);
  if (!lowered || !IsWellFormed(*lowered->module, lowered->graph->range, diagnostics))
    return std::nullopt;
  Compiled compiled;
  compiled.name = lowered->graph->name;
  compiled.dump = std::move(lowered->dump);
  glsl::PrintOptions print;
  print.dialect = DialectOf(options.target);
  print.as_function = options.emit == Emit::kFunction;
  print.name = compiled.name;
  print.version = TEXGRAPH_VERSION;
  print.for_spirv = options.target == Target::kSpirv;
  glsl::ShaderInterface interface;
  compiled.glsl = glsl::PrintGlsl(*lowered->module, print, &interface);
  if (options.target == Target::kSpirv) {
    auto words = spirv::CompileSpirv(compiled.glsl, diagnostics);
    if (!words) return std::nullopt;
    compiled.spirv = std::move(*words);
  }
  if (options.validate && options.target != Target::kSpirv &&
      !spirv::ValidateGlsl(print.as_function ? Pasted(compiled.glsl, print.dialect) : compiled.glsl,
                           diagnostics)) {
    return std::nullopt;
  }
  const std::string folder(FolderOf(sources.Name(source)));
  compiled.dependencies = Dependencies(*lowered, folder);
  if (!MakeTextures(*lowered, interface, options, folder, compiled, diagnostics))
    return std::nullopt;
  return compiled;
}

}  // namespace texgraph
