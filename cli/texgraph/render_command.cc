// SPDX-License-Identifier: Apache-2.0
#include "cli/texgraph/render_command.h"

#include <fmt/format.h>

#include "compiler/base/files.h"
#include "compiler/base/output_files.h"
#include "compiler/graph/document.h"
#include "compiler/textures/image.h"
#include "runtime/manifest.h"
#include "runtime/render.h"

namespace texgraph::cli {
namespace {

constexpr size_t kMaxShaderBytes = size_t{64} << 20;

// A shader to draw, wherever it came from.
struct Shader {
  std::string text;
  runtime::Manifest manifest;
  std::string folder;               // that the manifest's paths start from
  std::vector<std::string> inputs;  // all files that were read
};

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
  auto compiled = Compile(source, format, compile, sources, diagnostics);
  if (!compiled || diagnostics.HasErrors()) return false;
  const SourceId made = sources.Add("<manifest>", std::move(compiled->manifest));
  const auto document =
      graph::ReadDocument(made, graph::DocumentFormat::kJson, sources, diagnostics);
  auto manifest = document ? runtime::ReadManifest(*document, diagnostics) : std::nullopt;
  if (!manifest) return false;
  shader.manifest = std::move(*manifest);
  shader.text = std::move(compiled->glsl);
  shader.inputs.insert(shader.inputs.end(), compiled->dependencies.begin(),
                       compiled->dependencies.end());
  return true;
}

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

// A picture never replaces what it was made from.
bool CheckOutput(const std::string& output, const Shader& shader, Diagnostics& diagnostics) {
  if (output == "-") return true;
  std::vector<std::string> inputs = shader.inputs;
  for (const runtime::ManifestTexture& texture : shader.manifest.textures) {
    for (const std::string& file : texture.files) inputs.push_back(JoinPath(shader.folder, file));
  }
  for (const std::string& input : inputs) {
    if (AbsolutePath(input) != AbsolutePath(output) && !SameFile(input, output)) continue;
    diagnostics.Error(
        DiagnosticKind::kUsage, {},
        fmt::format("cannot write '{}': it is one of the files that are read", Printable(output)));
    return false;
  }
  return true;
}

runtime::RenderRequest RequestFor(const RenderOptions& options, Shader& shader) {
  runtime::RenderRequest request;
  request.shader = std::move(shader.text);
  request.manifest = std::move(shader.manifest);
  request.width = options.width;
  request.height = options.height;
  request.window = options.window;
  request.time = options.time;
  if (!options.output_name.empty()) request.outputs = {options.output_name};
  request.format =
      options.bits == 16 ? runtime::PixelFormat::kImage16 : runtime::PixelFormat::kImage8;
  request.context.choice = options.context;
  request.timeout = options.timeout;
  return request;
}

// Keeps the shader that the driver refused, beside where the picture would have been; says where in
// the error.
void ReportRefusedShader(const std::string& output, const std::string& shader,
                         const Diagnostic& refusal, Diagnostics& diagnostics) {
  const size_t name = output.size() - FileNameOf(output).size();
  const size_t dot = output.rfind('.');
  const bool has_extension = dot != std::string::npos && dot > name;
  const std::string path =
      output == "-" ? "texgraph.failed.frag"
                    : output.substr(0, has_extension ? dot : output.size()) + ".failed.frag";
  Diagnostic& error = diagnostics.Error(refusal.kind, refusal.range, refusal.message);
  error.notes = refusal.notes;
  OutputFiles files;
  files.Add(path, shader);
  Diagnostics ignored;  // the refusal is what matters
  if (files.Commit(ignored))
    error.AddNote({}, fmt::format("the shader was kept in '{}'", Printable(path)));
}

}  // namespace

void RunRender(const RenderOptions& options, Sources& sources, Diagnostics& diagnostics,
               std::string& message) {
  Shader shader;
  if (!LoadShader(options, sources, shader, diagnostics)) return;
  if (!CheckOutput(options.output, shader, diagnostics)) return;
  std::vector<runtime::TextureBinding> textures;
  const Roots roots(options.compile.roots, diagnostics);
  if (!runtime::LoadTextures(shader.manifest, shader.folder, textures, diagnostics, roots)) return;
  runtime::RenderRequest request = RequestFor(options, shader);
  request.textures = std::move(textures);
  runtime::RenderResult result = runtime::Render(request);
  const bool drawn = result.ok();
  if (!drawn && result.diagnostics.all().front().kind == DiagnosticKind::kDriverCompile) {
    ReportRefusedShader(options.output, request.shader, result.diagnostics.all().front(),
                        diagnostics);
  } else {
    diagnostics.Append(std::move(result.diagnostics));
  }
  if (!drawn) return;
  auto bytes = textures::EncodePng(result.outputs[0].image);
  if (!bytes) {
    diagnostics.Error(DiagnosticKind::kOutOfMemory, {},
                      "there is not enough memory to write the picture");
    return;
  }
  OutputFiles files;
  files.Add(options.output, std::move(*bytes));
  if (!files.Commit(diagnostics)) return;
  message =
      fmt::format("{}: {} of {} x {} pixels, drawn by {}\n", Printable(options.output),
                  result.outputs[0].name, options.width, options.height, Printable(result.context));
  if (!result.context_note.empty()) message += Printable(result.context_note) + "\n";
}

}  // namespace texgraph::cli
