// SPDX-License-Identifier: Apache-2.0
// Picture after picture by one shader: the process, the context, the program, the textures and the
// mesh stay, and between pictures a program sets uniforms, moves the camera and changes texels.
// What is set stays until it is set again. Each picture is the one that Render draws of a request
// that has all of these values from the beginning. One thread at a time may use a renderer.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
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
  // A uniform parameter: one number for each component, or one for all, finite and within the
  // parameter's range; whole ones for ints, 0 or 1 for bools. Colours are linear light.
  // Reported: kUnknownParameter, kNotRenderable, kPortType, kValueRange.
  bool SetParameter(std::string_view name, std::span<const double> numbers,
                    Diagnostics& diagnostics);
  // Of the request's scene. Reported: kUsage.
  bool SetCamera(const Camera& camera, Diagnostics& diagnostics);
  // Texels of one of the graph's textures; they change for the next picture. A texture that the
  // shader does not use can be changed without effect. Textures that are alike in the graph are one
  // and change together. Reported: kUnknownReference, kValueRange, kNotRenderable for a map whose
  // numbers are part of the shader.
  bool UpdateTexels(const TexelUpdate& update, Diagnostics& diagnostics);
  // The same for a map of whole numbers, -1 for nothing, in the texture's own format: `update` has
  // no texels yet. Width times height numbers, rows from the lowest up, each below the count of
  // what they count. Also reported: kPortType for what is no map.
  bool UpdateMap(TexelUpdate update, std::span<const int32_t> numbers, Diagnostics& diagnostics);

  // A texture as it was uploaded, before all updates. Both are there as long as the renderer.
  struct Texture {
    const ManifestTexture* texture = nullptr;
    const textures::TextureData* data = nullptr;
  };
  // Nothing if the shader has no such texture.
  std::optional<Texture> FindTexture(std::string_view name) const;
  const RenderRequest& request() const;

  // The request's outputs at that time, in seconds, within the request's `timeout` each. After the
  // driver has failed, all further ones fail.
  RenderResult Draw(double time);

 private:
  class Process;
  explicit LiveRenderer(std::unique_ptr<Process> process);
  // The texture of the graph, or null, reported; `sampler` is in the plan, if it has one.
  const ManifestTexture* Find(const std::string& name, std::optional<size_t>& sampler,
                              Diagnostics& diagnostics) const;

  std::unique_ptr<Process> process_;
};

}  // namespace texgraph::runtime
