// SPDX-License-Identifier: Apache-2.0
// A request on an open context, in the child process: what it needs is made once, and then drawn as
// often as its values change. All that is found out goes into the shared result at once.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "runtime/gl_context.h"
#include "runtime/mesh_painter.h"
#include "runtime/shared_result.h"
#include "runtime/texel_update.h"

namespace texgraph::runtime {

class Drawing {
 public:
  Drawing(const GlContext& context, const RenderRequest& request, const RenderPlan& plan,
          SharedResult& shared)
      : gl_(context.gl), context_(context), request_(request), plan_(plan), shared_(shared) {}
  Drawing(const Drawing&) = delete;
  Drawing& operator=(const Drawing&) = delete;
  ~Drawing();

  // Each is false if the driver failed at it; why is in the result.
  bool Prepare();
  bool Draw();
  // After the request's time, uniforms or camera changed.
  bool SetValues();
  bool Update(size_t sampler, const TexelUpdate& update);
  // Draws as often as the request says, to see how long it takes.
  void TimeFrames();

 private:
  bool Fail(DiagnosticKind kind, const std::string& text) {
    shared_.Fail(kind, text);
    return false;
  }
  bool CheckError(std::string_view what);
  bool Upload();
  bool Link();
  bool MakeFramebuffer();
  bool ChooseOutputs();
  bool PrepareMesh();
  void DrawTile(uint32_t x, uint32_t y);
  void ReadTile(uint32_t x, uint32_t y);
  template <class Function>
  void EachTile(Function function) {
    for (uint32_t y = 0; y < request_.height; y += tile_) {
      for (uint32_t x = 0; x < request_.width; x += tile_) function(x, y);
    }
  }

  const GlFunctions& gl_;
  const GlContext& context_;
  const RenderRequest& request_;
  const RenderPlan& plan_;
  SharedResult& shared_;
  std::vector<GLuint> textures_;  // of each sampler, on the unit of its number
  GLuint program_ = 0;
  GLuint framebuffer_ = 0;
  GLuint vertex_array_ = 0;
  std::vector<GLuint> renderbuffers_;
  uint32_t tile_ = 0;
  std::vector<float> rows_;
  std::unique_ptr<MeshPainter> painter_;  // if it is a mesh
  double start_ = 0;                      // of compiling
  bool has_drawn_ = false;
};

}  // namespace texgraph::runtime
