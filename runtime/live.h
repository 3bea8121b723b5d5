// SPDX-License-Identifier: Apache-2.0
// Picture after picture by one shader: the process, the context, the program, the textures and the
// mesh stay, and between pictures a program sets uniforms, moves the camera and changes texels.
// What is set stays until it is set again. Each picture is the one that Render draws of a request
// that has all of these values from the beginning.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "runtime/render.h"
#include "runtime/texel_update.h"

namespace texgraph::runtime {

class LiveRenderer {
 public:
  // Uploads and links; the request's `timed_frames` are not looked at. Nothing, with what Render
  // would report in `diagnostics`, if that fails.
  static std::unique_ptr<LiveRenderer> Open(RenderRequest request, Diagnostics& diagnostics);
  LiveRenderer(const LiveRenderer&) = delete;
  LiveRenderer& operator=(const LiveRenderer&) = delete;
  ~LiveRenderer();

  // Each of these is false, with the reason reported and nothing changed, if its values don't fit.
  // A uniform parameter: one number for each component, or one for all; bools are 0 or 1.
  // Reported: kUnknownParameter, kNotRenderable, kPortType, kValueRange.
  bool SetParameter(std::string_view name, std::span<const double> numbers,
                    Diagnostics& diagnostics);
  // Of the request's scene. Reported: kUsage.
  bool SetCamera(const Camera& camera, Diagnostics& diagnostics);
  // Texels of one of the graph's textures; they change for the next picture. A texture that the
  // shader does not use can be changed without effect. Textures that are alike in the graph are one
  // and change together. Reported: kUnknownReference, kValueRange.
  bool UpdateTexels(const TexelUpdate& update, Diagnostics& diagnostics);

  // The texels of that texture as they were uploaded; null if the shader has no such texture.
  const textures::TextureData* FindTexture(std::string_view name) const;
  const RenderRequest& request() const;

  // The request's outputs at that time, in seconds. After the driver has failed, all further ones
  // fail.
  RenderResult Draw(double time);

 private:
  class Process;
  explicit LiveRenderer(std::unique_ptr<Process> process);

  std::unique_ptr<Process> process_;
};

}  // namespace texgraph::runtime
