// SPDX-License-Identifier: Apache-2.0
#include "cli/texgraph/load_shader.h"

#include <fmt/format.h>

#include "compiler/base/files.h"
#include "compiler/graph/document.h"

namespace texgraph::cli {
namespace {

constexpr size_t kMaxShaderBytes = size_t{64} << 20;

std::string ReadInput(const std::string& path, Diagnostics& diagnostics) {
  auto text = path == "-" ? ReadStandardInput(graph::kMaxDocumentBytes, diagnostics)
                          : ReadFile(path, graph::kMaxDocumentBytes, {}, diagnostics);
  return text ? std::move(*text) : "";
}

bool ReadShaderFile(const graph::Document& document, const RenderOptions& options, Sources& sources,
                    Shader& shader, Diagnostics& diagnostics) {
  auto manifest = runtime::ReadManifest(document, diagnostics);
  if (!manifest ||
      !runtime::ApplySettings(options.compile.settings, sources, *manifest, diagnostics))
    return false;
  shader.manifest = std::move(*manifest);
  if (shader.manifest.dialect == runtime::ShaderDialect::kSpirv)
    return true;  // refused later, with a reason
  const std::string path = JoinPath(shader.folder, shader.manifest.shader);
  if (!Roots(options.compile.roots, diagnostics).Contain(path)) {
    diagnostics.Error(
        DiagnosticKind::kOutsideRoot, {},
        fmt::format("shader '{}' is outside of the folders that --root allows", Printable(path)));
  }
  if (diagnostics.HasErrors()) return false;
  auto text = ReadFile(path, kMaxShaderBytes, {}, diagnostics);
  if (!text) return false;
  shader.text = std::move(*text);
  shader.inputs.push_back(path);
  return true;
}

bool CompileGraphShader(SourceId source, graph::DocumentFormat format, const RenderOptions& options,
                        Sources& sources, Shader& shader, Diagnostics& diagnostics) {
  CompileOptions compile = options.compile;
  compile.manifest_folder = shader.folder;
  compile.derive_textures = true;
  if (!options.mesh.mesh.empty()) compile.emit = Emit::kFunction;  // the light goes around it
  auto compiled = Compile(source, format, compile, sources, diagnostics);
  if (!compiled || diagnostics.HasErrors()) return false;
  const SourceId made = sources.Add("<manifest>", std::move(compiled->manifest));
  const auto document =
      graph::ReadDocument(made, graph::DocumentFormat::kJson, sources, diagnostics);
  auto manifest = document ? runtime::ReadManifest(*document, diagnostics) : std::nullopt;
  if (!manifest) return false;
  shader.manifest = std::move(*manifest);
  shader.text = std::move(compiled->glsl);
  for (Compiled::Texture& texture : compiled->textures) {
    shader.made.emplace(texture.file, std::move(texture.data));
  }
  shader.inputs.insert(shader.inputs.end(), compiled->dependencies.begin(),
                       compiled->dependencies.end());
  return true;
}

}  // namespace

bool LoadShader(const RenderOptions& options, Sources& sources, Shader& shader,
                Diagnostics& diagnostics) {
  std::string text = ReadInput(options.input, diagnostics);
  if (diagnostics.HasErrors()) return false;
  const bool standard_input = options.input == "-";
  if (!standard_input) shader.inputs.push_back(options.input);
  shader.folder = standard_input ? "" : std::string(FolderOf(options.input));
  const graph::DocumentFormat format = graph::FormatOf(options.input, text);
  const SourceId source = sources.Add(standard_input ? "<stdin>" : options.input, std::move(text));
  // Only a JSON text can be a manifest; what is wrong with it as a document is said by whoever
  // reads it in earnest.
  if (format == graph::DocumentFormat::kJson &&
      sources.Text(source).find("\"texgraph_manifest\"") != std::string_view::npos) {
    Diagnostics trial;
    const auto document = graph::ReadDocument(source, format, sources, trial);
    if (document && runtime::IsManifest(*document)) {
      return ReadShaderFile(*document, options, sources, shader, diagnostics);
    }
  }
  return CompileGraphShader(source, format, options, sources, shader, diagnostics);
}

}  // namespace texgraph::cli
