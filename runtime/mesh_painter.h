// SPDX-License-Identifier: Apache-2.0
// Draws a scene's mesh with the program in use, several samples a pixel, and averages them. It
// needs a depth buffer and a texture for each output, of one square of the picture.
#pragma once

#include <string>
#include <vector>

#include "runtime/gl_context.h"
#include "runtime/mesh_shader.h"
#include "runtime/render.h"
#include "runtime/shared_result.h"

namespace texgraph::runtime {

class MeshPainter {
 public:
  MeshPainter(const GlContext& context, const RenderRequest& request, const RenderPlan& plan);
  MeshPainter(const MeshPainter&) = delete;
  MeshPainter& operator=(const MeshPainter&) = delete;
  ~MeshPainter();

  const MeshShader& shader() const { return shader_; }
  // The side of a square whose samples the driver and the memory have room for, at most `side`: a
  // power of two.
  uint32_t TileSide(uint32_t side, uint32_t largest) const;
  // With `program` (of shader()) in use. False with what failed in `what`, and the driver's words
  // in `log`, if there are any.
  bool Prepare(GLuint program, uint32_t tile, uint32_t free_unit, std::string& what,
               std::string& log);
  // What the scene's camera and lights are now. With the program in use.
  void SetScene();
  // One square, its left bottom corner at pixel (x, y), into the attachments of `target`, one for
  // each output.
  void DrawTile(uint32_t x, uint32_t y, GLuint target);

 private:
  void UploadMesh();
  bool MakeSamples(std::string& what);
  GLint Uniform(GLuint program, const std::string& name) const {
    return gl_.GetUniformLocation(program, name.c_str());
  }
  GLint Own(const std::string& name) const { return Uniform(program_, shader_.prefix + name); }
  void Set3(const std::string& name, const glm::dvec3& value) const;

  const GlFunctions& gl_;
  const GlContext& context_;
  const RenderRequest& request_;
  const RenderPlan& plan_;
  const Scene& scene_;
  MeshShader shader_;
  Box box_;
  View view_;
  uint32_t tile_ = 0;
  uint32_t unit_ = 0;
  GLuint program_ = 0;
  GLuint resolve_ = 0;
  GLuint vertex_array_ = 0;
  GLuint empty_array_ = 0;
  GLuint buffers_[2] = {0, 0};  // vertices, indices
  GLuint framebuffer_ = 0;
  GLuint depth_ = 0;
  std::vector<GLuint> samples_;
};

}  // namespace texgraph::runtime
