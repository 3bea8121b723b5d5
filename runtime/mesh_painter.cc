// SPDX-License-Identifier: Apache-2.0
#include "runtime/mesh_painter.h"

#include <fmt/format.h>
#include <stddef.h>

#include <algorithm>
#include <bit>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>

#include "runtime/gl_program.h"

namespace texgraph::runtime {
namespace {

// Of the samples of one square, for each output 16 bytes.
constexpr uint32_t kSampleSide = 1024;

MeshShader ComposeFor(const RenderRequest& request, const RenderPlan& plan) {
  std::vector<std::string_view> names;
  for (const PlannedOutput& planned : plan.outputs) names.push_back(planned.output->name);
  return ComposeMeshShader(request.shader, request.manifest, names);
}

const void* Offset(size_t bytes) { return reinterpret_cast<const void*>(bytes); }

}  // namespace

MeshPainter::MeshPainter(const GlContext& context, const RenderRequest& request,
                         const RenderPlan& plan)
    : gl_(context.gl),
      context_(context),
      request_(request),
      plan_(plan),
      scene_(*request.scene),
      shader_(ComposeFor(request, plan)),
      box_(BoundsOf(*scene_.mesh)) {}

MeshPainter::~MeshPainter() {
  gl_.Disable(GL_DEPTH_TEST);
  if (resolve_ != 0) gl_.DeleteProgram(resolve_);
  if (framebuffer_ != 0) gl_.DeleteFramebuffers(1, &framebuffer_);
  if (depth_ != 0) gl_.DeleteRenderbuffers(1, &depth_);
  for (GLuint* array : {&vertex_array_, &empty_array_}) {
    if (*array != 0) gl_.DeleteVertexArrays(1, array);
  }
  if (buffers_[0] != 0) gl_.DeleteBuffers(2, buffers_);
  gl_.DeleteTextures(static_cast<GLsizei>(samples_.size()), samples_.data());
}

uint32_t MeshPainter::TileSide(uint32_t side, uint32_t largest) const {
  const uint32_t most = std::min(kSampleSide, largest) / scene_.samples;
  return std::max(1u, std::bit_floor(std::min(side, most)));
}

void MeshPainter::UploadMesh() {
  const Mesh& mesh = *scene_.mesh;
  gl_.GenVertexArrays(1, &vertex_array_);
  gl_.GenVertexArrays(1, &empty_array_);
  gl_.BindVertexArray(vertex_array_);
  gl_.GenBuffers(2, buffers_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
  gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(Vertex)),
                 mesh.vertices.data(), GL_STATIC_DRAW);
  gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[1]);
  gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(uint32_t)),
                 mesh.indices.data(), GL_STATIC_DRAW);
  const struct {
    GLuint attribute;
    GLint components;
    size_t offset;
  } kLayout[] = {{kPositionAttribute, 3, offsetof(Vertex, position)},
                 {kNormalAttribute, 3, offsetof(Vertex, normal)},
                 {kTangentAttribute, 4, offsetof(Vertex, tangent)},
                 {kUvAttribute, 2, offsetof(Vertex, uv)}};
  for (const auto& entry : kLayout) {
    gl_.EnableVertexAttribArray(entry.attribute);
    gl_.VertexAttribPointer(entry.attribute, entry.components, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                            Offset(entry.offset));
  }
}

void MeshPainter::Set3(const std::string& name, const glm::dvec3& value) const {
  const glm::vec3 floats(value);
  gl_.Uniform3fv(Own(name), 1, glm::value_ptr(floats));
}

void MeshPainter::SetScene() {
  Camera camera = scene_.camera;
  if (!camera.distance) {
    camera.distance = FramingDistance(*scene_.mesh, box_, camera, request_.width, request_.height);
  }
  view_ = ViewOf(box_, camera, request_.width, request_.height);
  const Lighting& light = scene_.lighting;
  const double yaw = scene_.camera.yaw;
  Set3("eye", view_.eye);
  Set3("key", light.key);
  Set3("key_direction", Direction(yaw + light.yaw, light.pitch));
  Set3("sky", light.sky);
  Set3("ground", light.ground);
  for (size_t i = 0; i < kLampCount; ++i) {
    const Lamp& lamp = light.lamps[i];
    const glm::vec4 axis(glm::vec3(Direction(yaw + lamp.yaw, lamp.pitch)),
                         static_cast<float>(lamp.sharpness));
    gl_.Uniform4fv(Own(fmt::format("lamp_axis[{}]", i)), 1, glm::value_ptr(axis));
    Set3(fmt::format("lamp_radiance[{}]", i), lamp.radiance);
  }
  const auto relief = static_cast<float>(scene_.relief);
  const glm::vec2 tiles(scene_.tiles[0], scene_.tiles[1]);
  gl_.Uniform1fv(Own("relief"), 1, &relief);
  gl_.Uniform2fv(Own("tiles"), 1, glm::value_ptr(tiles));
  gl_.Uniform1i(Own("side"), static_cast<GLint>(scene_.samples));
}

bool MeshPainter::MakeSamples(std::string& what) {
  const auto side = static_cast<GLsizei>(tile_ * scene_.samples);
  gl_.GenFramebuffers(1, &framebuffer_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  samples_.resize(plan_.outputs.size());
  gl_.GenTextures(static_cast<GLsizei>(samples_.size()), samples_.data());
  gl_.ActiveTexture(GL_TEXTURE0 + unit_);
  std::vector<GLenum> buffers;
  for (GLuint texture : samples_) {
    const GLenum attachment = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(buffers.size());
    gl_.BindTexture(GL_TEXTURE_2D, texture);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, side, side, 0, GL_RGBA, GL_FLOAT, nullptr);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, texture, 0);
    buffers.push_back(attachment);
  }
  gl_.GenRenderbuffers(1, &depth_);
  gl_.BindRenderbuffer(GL_RENDERBUFFER, depth_);
  gl_.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, side, side);
  gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
  gl_.DrawBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
  if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return true;
  what = "the driver cannot draw into textures of 32-bit floats";
  return false;
}

bool MeshPainter::Prepare(GLuint program, uint32_t tile, uint32_t free_unit, std::string& what,
                          std::string& log) {
  program_ = program;
  tile_ = tile;
  unit_ = free_unit;
  UploadMesh();
  SetScene();
  if (!MakeSamples(what)) return false;
  resolve_ = LinkProgram(context_, ResolveVertexShader(), ResolveFragmentShader(), what, log);
  if (resolve_ == 0) return false;
  gl_.UseProgram(resolve_);
  gl_.Uniform1i(Uniform(resolve_, "samples"), static_cast<GLint>(unit_));
  gl_.Uniform1i(Uniform(resolve_, "side"), static_cast<GLint>(scene_.samples));
  gl_.Uniform1i(Uniform(resolve_, "is_toned"), request_.format == PixelFormat::kFloat ? 0 : 1);
  const glm::vec4 background(scene_.background);
  gl_.Uniform4fv(Uniform(resolve_, "background"), 1, glm::value_ptr(background));
  return true;
}

void MeshPainter::DrawTile(uint32_t x, uint32_t y, GLuint target) {
  const auto side = static_cast<GLsizei>(tile_ * scene_.samples);
  const glm::mat4 clip(
      TileOf(view_.clip_from_object, request_.width, request_.height, x, y, tile_));
  const GLfloat zeros[4] = {0, 0, 0, 0};
  const GLfloat far = 1;
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.Viewport(0, 0, side, side);
  gl_.Enable(GL_DEPTH_TEST);
  for (size_t i = 0; i < samples_.size(); ++i)
    gl_.ClearBufferfv(GL_COLOR, static_cast<GLint>(i), zeros);
  gl_.ClearBufferfv(GL_DEPTH, 0, &far);
  gl_.UseProgram(program_);
  gl_.UniformMatrix4fv(Own("clip_from_object"), 1, GL_FALSE, glm::value_ptr(clip));
  gl_.BindVertexArray(vertex_array_);
  gl_.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(scene_.mesh->indices.size()), GL_UNSIGNED_INT,
                   nullptr);

  gl_.Disable(GL_DEPTH_TEST);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, target);
  gl_.Viewport(0, 0, static_cast<GLsizei>(tile_), static_cast<GLsizei>(tile_));
  gl_.UseProgram(resolve_);
  gl_.BindVertexArray(empty_array_);
  gl_.ActiveTexture(GL_TEXTURE0 + unit_);
  for (size_t i = 0; i < samples_.size(); ++i) {
    const GLenum attachment = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i);
    // The shader's only output is number 0; the rest of the list says which attachment that is.
    gl_.DrawBuffers(1, &attachment);
    gl_.BindTexture(GL_TEXTURE_2D, samples_[i]);
    gl_.Uniform1i(Uniform(resolve_, "is_light"), plan_.outputs[i].output->name == kLitOutput);
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
  }
}

}  // namespace texgraph::runtime
