// SPDX-License-Identifier: Apache-2.0
#include "runtime/draw.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <chrono>

#include "runtime/gl_program.h"
#include "runtime/gl_texture.h"
#include "runtime/pixels.h"

namespace texgraph::runtime {
namespace {

double Seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Drawing::~Drawing() {
  painter_.reset();
  gl_.UseProgram(0);
  if (program_ != 0) gl_.DeleteProgram(program_);
  if (framebuffer_ != 0) gl_.DeleteFramebuffers(1, &framebuffer_);
  if (vertex_array_ != 0) gl_.DeleteVertexArrays(1, &vertex_array_);
  gl_.DeleteRenderbuffers(static_cast<GLsizei>(renderbuffers_.size()), renderbuffers_.data());
  gl_.DeleteTextures(static_cast<GLsizei>(textures_.size()), textures_.data());
}

bool Drawing::CheckError(std::string_view what) {
  const GLenum error = gl_.GetError();
  if (error == GL_NO_ERROR) return true;
  const auto kind =
      error == GL_OUT_OF_MEMORY ? DiagnosticKind::kOutOfMemory : DiagnosticKind::kDriverFailure;
  return Fail(kind, fmt::format("the driver failed while {} ({})", what, GlErrorName(error)));
}

bool Drawing::Upload() {
  shared_.stage = Stage::kUploading;
  GLint units = 0;
  gl_.GetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &units);
  const size_t needed = plan_.samplers.size() + (request_.scene ? 1 : 0);  // one for the samples
  if (needed > static_cast<size_t>(units)) {
    return Fail(DiagnosticKind::kTargetLimit,
                fmt::format("the shader has {} textures; the driver takes {}", needed, units));
  }
  for (const PlannedSampler& sampler : plan_.samplers) {
    std::string why_not;
    const auto unit = static_cast<uint32_t>(textures_.size());
    const GLuint texture = UploadTexture(gl_, unit, *sampler.data, why_not);
    if (texture == 0) {
      return Fail(DiagnosticKind::kTargetLimit,
                  fmt::format("texture '{}' has {}", Printable(sampler.variable), why_not));
    }
    textures_.push_back(texture);
  }
  return CheckError("uploading textures");
}

bool Drawing::Link() {
  shared_.stage = Stage::kCompiling;
  if (request_.manifest.dialect == ShaderDialect::kGlsl450 && context_.version < 45) {
    return Fail(
        DiagnosticKind::kNoContext,
        fmt::format("a glsl450 shader needs OpenGL 4.5; the context is {}", context_.description));
  }
  std::string what;
  std::string log;
  if (request_.scene) {
    painter_ = std::make_unique<MeshPainter>(context_, request_, plan_);
    const MeshShader& shader = painter_->shader();
    program_ = LinkProgram(context_, shader.vertex, shader.fragment, what, log);
  } else {
    program_ = LinkProgram(context_, VertexShader(request_.manifest), request_.shader, what, log);
  }
  SharedResult::SetText(shared_.driver_log, log);
  if (program_ == 0) return Fail(DiagnosticKind::kDriverCompile, what);
  gl_.UseProgram(program_);
  SetUniforms(gl_, program_, request_);
  for (size_t unit = 0; unit < textures_.size(); ++unit) {
    const GLint location = gl_.GetUniformLocation(program_, plan_.samplers[unit].variable.c_str());
    if (location >= 0) gl_.Uniform1i(location, static_cast<GLint>(unit));
  }
  return CheckError("setting uniforms");
}

// One float renderbuffer for each output: only floats keep what is beyond 0..1, and NaN.
bool Drawing::MakeFramebuffer() {
  GLint most = 0;
  GLint viewport[2] = {0, 0};
  gl_.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
  gl_.GetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
  const auto limit =
      static_cast<uint32_t>(std::max(2, std::min({most, viewport[0] / 2, viewport[1] / 2})));
  tile_ = std::min(request_.tile, std::bit_floor(limit));
  if (painter_) tile_ = painter_->TileSide(tile_, limit);
  const auto width = static_cast<GLsizei>(std::min(tile_, request_.width));
  const auto height = static_cast<GLsizei>(std::min(tile_, request_.height));
  rows_.resize(size_t{4} * static_cast<size_t>(width) * static_cast<size_t>(height));
  gl_.GenFramebuffers(1, &framebuffer_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  renderbuffers_.resize(plan_.outputs.size());
  gl_.GenRenderbuffers(static_cast<GLsizei>(renderbuffers_.size()), renderbuffers_.data());
  for (size_t i = 0; i < renderbuffers_.size(); ++i) {
    gl_.BindRenderbuffer(GL_RENDERBUFFER, renderbuffers_[i]);
    gl_.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, width, height);
    gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i),
                                GL_RENDERBUFFER, renderbuffers_[i]);
  }
  if (!CheckError("making a framebuffer")) return false;
  if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return true;
  return Fail(DiagnosticKind::kDriverFailure, "the driver cannot draw into 32-bit floats");
}

// Attachment i is output i of the plan, whatever location the shader gave it.
bool Drawing::ChooseOutputs() {
  GLint most = 0;
  gl_.GetIntegerv(GL_MAX_DRAW_BUFFERS, &most);
  std::vector<GLenum> buffers(static_cast<size_t>(most), GL_NONE);
  for (size_t i = 0; i < plan_.outputs.size(); ++i) {
    const std::string& variable = plan_.outputs[i].output->variable;
    const GLint location = gl_.GetFragDataLocation(program_, variable.c_str());
    if (location < 0 || location >= most) {
      return Fail(DiagnosticKind::kNotRenderable,
                  fmt::format("the shader has no output variable '{}'", Printable(variable)));
    }
    GLenum& buffer = buffers[static_cast<size_t>(location)];
    if (buffer != GL_NONE) {
      return Fail(DiagnosticKind::kUsage, fmt::format("output '{}' is asked for twice",
                                                      Printable(plan_.outputs[i].output->name)));
    }
    buffer = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i);
  }
  // Attachments beyond the highest chosen output stay NONE, and GL wants attachment i at index i
  // only in GL ES.
  gl_.DrawBuffers(most, buffers.data());
  return CheckError("choosing outputs");
}

// Uploads the mesh and makes room for its samples.
bool Drawing::PrepareMesh() {
  std::string what;
  std::string log;
  const auto unit = static_cast<uint32_t>(textures_.size());
  if (!painter_->Prepare(program_, tile_, unit, what, log))
    return Fail(DiagnosticKind::kDriverFailure, log.empty() ? what : what + ": " + log);
  return CheckError("preparing the mesh");
}

// The triangle is that of twice a power of two, whatever part of it the picture needs: the driver
// divides by its side, which is then exact, so that uv and its derivatives depend on the tile's
// place only. The viewport holds all of it: a triangle that is cut falls into several, and where
// they meet, derivatives jump.
void Drawing::DrawTile(uint32_t x, uint32_t y) {
  if (painter_) {
    painter_->DrawTile(x, y, framebuffer_);
    return;
  }
  const uint32_t side = 2 * std::bit_ceil(tile_);
  const auto& window = request_.window;
  const auto u = [&](uint32_t column) {
    return static_cast<float>(window[0] + (window[2] - window[0]) * column / request_.width);
  };
  const auto v = [&](uint32_t row) {
    return static_cast<float>(window[1] + (window[3] - window[1]) * row / request_.height);
  };
  gl_.Viewport(0, 0, static_cast<GLsizei>(side), static_cast<GLsizei>(side));
  gl_.VertexAttrib4f(kWindowAttribute, u(x), v(y), u(x + side), v(y + side));
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

void Drawing::ReadTile(uint32_t x, uint32_t y) {
  const uint32_t width = std::min(tile_, request_.width - x);
  const uint32_t height = std::min(tile_, request_.height - y);
  for (size_t i = 0; i < plan_.outputs.size(); ++i) {
    const PlannedOutput& planned = plan_.outputs[i];
    gl_.ReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i));
    gl_.ReadPixels(0, 0, static_cast<GLsizei>(width), static_cast<GLsizei>(height), GL_RGBA,
                   GL_FLOAT, rows_.data());
    const PictureTarget target{shared_.Pixels() + planned.offset,
                               request_.width,
                               request_.height,
                               planned.channels,
                               request_.format == PixelFormat::kFloat ? 4 : planned.image_channels,
                               request_.format,
                               EncodingOf(planned.output->name)};
    shared_.nan_pixels[i] += StorePixels({rows_.data(), width, height, x, y}, target);
  }
}

void Drawing::TimeFrames() {
  shared_.stage = Stage::kTiming;
  for (uint32_t frame = 0; frame < request_.timed_frames; ++frame) {
    const double start = Seconds();
    EachTile([this](uint32_t x, uint32_t y) { DrawTile(x, y); });
    gl_.Finish();
    shared_.frame_seconds[frame] = Seconds() - start;
    shared_.frame_count = frame + 1;
  }
}

bool Drawing::Prepare() {
  while (gl_.GetError() != GL_NO_ERROR) {
  }
  if (!Upload()) return false;
  start_ = Seconds();
  if (!Link() || !MakeFramebuffer()) return false;
  if (!(painter_ ? PrepareMesh() : ChooseOutputs())) return false;
  gl_.GenVertexArrays(1, &vertex_array_);
  gl_.BindVertexArray(vertex_array_);
  gl_.Disable(GL_DITHER);
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
  return true;
}

bool Drawing::SetValues() {
  gl_.UseProgram(program_);
  SetUniforms(gl_, program_, request_);
  if (painter_) painter_->SetScene();
  return CheckError("setting uniforms");
}

bool Drawing::Update(size_t sampler, const TexelUpdate& update) {
  shared_.stage = Stage::kUploading;
  UpdateTexels(gl_, static_cast<uint32_t>(sampler), *plan_.samplers[sampler].data, update);
  return CheckError("changing texels");
}

bool Drawing::Draw() {
  shared_.stage = Stage::kDrawing;
  for (uint64_t& pixels : shared_.nan_pixels) pixels = 0;
  EachTile([&](uint32_t x, uint32_t y) {
    DrawTile(x, y);
    if (!has_drawn_) {
      gl_.Finish();
      shared_.compile_seconds = Seconds() - start_;
      has_drawn_ = true;
    }
    ReadTile(x, y);
  });
  return CheckError("drawing");
}

}  // namespace texgraph::runtime
