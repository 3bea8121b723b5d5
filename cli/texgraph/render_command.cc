// SPDX-License-Identifier: Apache-2.0
#include "cli/texgraph/render_command.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/texgraph/contact_sheet.h"
#include "cli/texgraph/load_shader.h"
#include "cli/texgraph/mesh_options.h"
#include "cli/texgraph/output_check.h"
#include "cli/texgraph/progress.h"
#include "cli/texgraph/sequence.h"
#include "compiler/base/files.h"
#include "compiler/base/output_files.h"
#include "compiler/textures/image.h"
#include "runtime/exr.h"
#include "runtime/live.h"
#include "runtime/mesh_shader.h"

namespace texgraph::cli {
namespace {

void AddTextureInputs(Shader& shader) {
  for (const runtime::ManifestTexture& texture : shader.manifest.textures) {
    for (const std::string& file : texture.files) {
      if (!shader.made.contains(file)) shader.inputs.push_back(JoinPath(shader.folder, file));
    }
  }
}

runtime::PixelFormat PixelsFor(const RenderOptions& options) {
  if (options.format == PictureFormat::kExr) return runtime::PixelFormat::kFloat;
  return options.bits == 16 ? runtime::PixelFormat::kImage16 : runtime::PixelFormat::kImage8;
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
  if (options.contact_sheet && options.frames == 0) {
    if (!options.mesh.mesh.empty()) request.outputs.emplace_back(runtime::kLitOutput);
    for (const runtime::ManifestOutput& output : request.manifest.outputs)
      request.outputs.push_back(output.name);
  }
  request.format = PixelsFor(options);
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

// Everything that is drawn in a run, from the first request to the files.
class Drawing {
 public:
  Drawing(const RenderOptions& options, const Shader& shader, runtime::RenderRequest request,
          Diagnostics& diagnostics)
      : options_(options),
        shader_(shader),
        request_(std::move(request)),
        diagnostics_(diagnostics) {}

  // False, with what is wrong reported: then no file has changed.
  bool Run() {
    if (!Prepare()) return false;
    if (!DrawFrames()) return false;
    if (layout_ && !WriteSheet()) return false;
    ReportNan();
    return files_.Commit(diagnostics_);
  }

  std::string Message() const {
    const bool numbered = options_.frames > 0 && !layout_;
    std::string text = numbered
                           ? fmt::format("{} to {}", Printable(FramePath(options_.output, 1)),
                                         Printable(FramePath(options_.output, options_.frames)))
                           : Printable(options_.output);
    text += fmt::format(": {}", names_);
    if (layout_) text += fmt::format(" in {} columns and {} rows", layout_->columns, layout_->rows);
    text += fmt::format(" of {} x {} pixels, drawn by {}\n", options_.width, options_.height,
                        Printable(context_));
    if (!context_note_.empty()) text += Printable(context_note_) + "\n";
    return text;
  }

 private:
  bool Prepare() {
    if (options_.sweep) {
      sweep_ = FindSweep(*options_.sweep, request_.manifest, diagnostics_);
      if (!sweep_) return false;
    }
    if (options_.contact_sheet) {
      const size_t cells = options_.frames > 0 ? options_.frames : request_.outputs.size();
      layout_ = LayOutSheet(static_cast<uint32_t>(std::max<size_t>(cells, 1)), options_.width,
                            options_.height, request_.format, diagnostics_);
      if (!layout_) return false;
    }
    if (options_.frames == 0 || layout_)
      return CheckOutput(options_.output, shader_.inputs, diagnostics_);
    for (uint32_t number = 1; number <= options_.frames; ++number) {
      if (!CheckOutput(FramePath(options_.output, number), shader_.inputs, diagnostics_))
        return false;
    }
    return true;
  }

  bool DrawFrames() {
    Diagnostics refusal;
    const auto renderer = runtime::LiveRenderer::Open(request_, refusal);
    if (!renderer) return ReportFailure(std::move(refusal));
    const uint32_t total = std::max(1u, options_.frames);
    Progress progress(total, !options_.quiet);
    for (uint32_t frame = 0; frame < total; ++frame) {
      runtime::RenderResult result;
      if (!DrawFrame(options_, sweep_, frame, *renderer, result))
        return ReportFailure(std::move(result.diagnostics));
      progress.Advance();
      if (!TakeResult(frame, result)) return false;
    }
    return true;
  }

  bool ReportFailure(Diagnostics&& failure) {
    const Diagnostic& first = failure.all().front();
    if (first.kind == DiagnosticKind::kDriverCompile) {
      ReportRefusedShader(options_.output, DrawnShader(), first, diagnostics_);
    } else {
      diagnostics_.Append(std::move(failure));
    }
    return false;
  }

  bool TakeResult(uint32_t frame, runtime::RenderResult& result) {
    if (frame == 0) {
      context_ = result.context;
      context_note_ = result.context_note;
      for (const runtime::RenderedOutput& output : result.outputs)
        names_ += (names_.empty() ? "" : ", ") + output.name;
      if (options_.frames > 0) names_ += fmt::format(", {} frames,", options_.frames);
    }
    CountNan(result);
    for (runtime::RenderedOutput& output : result.outputs) {
      if (layout_) {
        cells_.push_back(std::move(output));
      } else if (!Stage(
                     options_.frames > 0 ? FramePath(options_.output, frame + 1) : options_.output,
                     output)) {
        return false;
      }
    }
    return true;
  }

  // What the driver was given.
  std::string DrawnShader() const {
    if (!request_.scene) return request_.shader;
    std::vector<std::string_view> outputs(request_.outputs.begin(), request_.outputs.end());
    if (outputs.empty()) outputs = {runtime::kLitOutput};
    return runtime::ComposeMeshShader(request_.shader, request_.manifest, outputs).fragment;
  }

  // One warning for all frames.
  void CountNan(const runtime::RenderResult& result) {
    bool has_nan = false;
    for (const runtime::RenderedOutput& output : result.outputs)
      has_nan = has_nan || output.nan_pixels > 0;
    if (!has_nan) return;
    if (nan_frames_++ == 0) nan_warnings_ = result.diagnostics;
  }

  void ReportNan() {
    if (nan_frames_ == 0) return;
    diagnostics_.Append(std::move(nan_warnings_));
    if (nan_frames_ > 1) {
      diagnostics_.Warn(DiagnosticKind::kNanPixels, {},
                        fmt::format("{} of {} frames have NaN pixels; the first was told of",
                                    nan_frames_, options_.frames));
    }
  }

  bool WriteSheet() {
    runtime::RenderedOutput sheet;
    if (DrawSheet(*layout_, cells_, sheet))
      return Stage(options_.output, sheet, layout_->width, layout_->height);
    ReportMemory();
    return false;
  }

  bool Stage(const std::string& path, const runtime::RenderedOutput& output) {
    return Stage(path, output, options_.width, options_.height);
  }

  bool Stage(const std::string& path, const runtime::RenderedOutput& output, uint32_t width,
             uint32_t height) {
    const auto depth = options_.bits == 32 ? runtime::ExrDepth::kFloat : runtime::ExrDepth::kHalf;
    auto bytes = options_.format == PictureFormat::kExr
                     ? runtime::EncodeExr(output.floats, width, height, output.channels, depth)
                     : textures::EncodePng(output.image);
    if (bytes) return files_.Stage(path, std::move(*bytes), diagnostics_);
    ReportMemory();
    return false;
  }

  void ReportMemory() {
    diagnostics_.Error(DiagnosticKind::kOutOfMemory, {},
                       "there is not enough memory to write the picture");
  }

  const RenderOptions& options_;
  const Shader& shader_;
  runtime::RenderRequest request_;
  Diagnostics& diagnostics_;
  std::optional<FoundSweep> sweep_;
  std::optional<SheetLayout> layout_;
  std::vector<runtime::RenderedOutput> cells_;
  OutputFiles files_;
  std::string names_;
  std::string context_;
  std::string context_note_;
  Diagnostics nan_warnings_;
  uint32_t nan_frames_ = 0;
};

}  // namespace

void RunRender(const RenderOptions& options, Sources& sources, Diagnostics& diagnostics,
               std::string& message) {
  Shader shader;
  if (!LoadShader(options, sources, shader, diagnostics)) return;
  AddTextureInputs(shader);
  std::vector<runtime::TextureBinding> textures;
  const Roots roots(options.compile.roots, diagnostics);
  if (!CheckOutput(options.output, shader.inputs, diagnostics)) return;
  std::optional<runtime::Scene> scene;
  if (!options.mesh.mesh.empty()) {
    scene = MakeScene(options, diagnostics);
    if (!scene) return;
    if (!runtime::MakeShape(options.mesh.mesh)) shader.inputs.push_back(options.mesh.mesh);
    if (!CheckOutput(options.output, shader.inputs, diagnostics)) return;
  }
  if (!runtime::LoadTextures(shader.manifest, shader.folder, textures, diagnostics, roots,
                             shader.made)) {
    return;
  }
  runtime::RenderRequest request = RequestFor(options, shader);
  request.textures = std::move(textures);
  request.scene = std::move(scene);
  Drawing drawing(options, shader, std::move(request), diagnostics);
  if (drawing.Run()) message = drawing.Message();
}

}  // namespace texgraph::cli
