// SPDX-License-Identifier: Apache-2.0
// Draws a shader over a rectangle of texture space, or on a mesh, without a window. The driver runs
// in a child process with limits on time and memory: whatever it does, the caller gets a result or
// a diagnostic. docs/rendering.md says what the pixels mean.
//
// Pixel (x, y) of a picture of W x H, y counted from the bottom, has uv = (u0 + (x + 1/2) (u1 - u0)
// / W, v0 + (y + 1/2) (v1 - v0) / H) at its centre, position (uv, 0) and normal (0, 0, 1), each as
// the GPU interpolates it.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/textures/image.h"
#include "compiler/textures/texels.h"
#include "runtime/gl_context.h"
#include "runtime/manifest.h"
#include "runtime/scene.h"

namespace texgraph::runtime {

inline constexpr uint32_t kMaxPictureSide = 65535;
inline constexpr uint64_t kMaxPictureBytes = uint64_t{1} << 30;  // of all outputs asked for
inline constexpr uint32_t kTileSide = 1024;

enum class PixelFormat : uint8_t {
  kImage8,   // colours as sRGB, normals as (n + 1) / 2, everything else as it is; clamped to 0..1
  kImage16,  // the same with 16 bits
  kFloat     // the shader's own numbers
};

struct TextureBinding {
  std::string variable;  // the sampler in the shader
  std::shared_ptr<const textures::TextureData> data;
};

struct RenderRequest {
  std::string shader;                    // GLSL of the manifest's dialect; for a mesh, a function
  Manifest manifest;                     // uniforms have the values of its parameters
  std::vector<TextureBinding> textures;  // one for each sampler that the manifest names
  uint32_t width = 512;
  uint32_t height = 512;
  std::array<double, 4> window = {0, 0, 1, 1};  // u0, v0 (left, bottom), u1, v1 (right, top)
  double time = 0;
  std::vector<std::string> outputs;  // by name; empty: color, or else the first; of a mesh, lit
  std::optional<Scene> scene;        // a mesh to draw, instead of the window
  PixelFormat format = PixelFormat::kImage8;
  ContextOptions context;
  double timeout = 60;                        // seconds, for this request
  uint64_t memory_limit = uint64_t{8} << 30;  // bytes of data that the child may have
  // Pictures are drawn in squares of this side, an even number. It changes uv by rounding only, and
  // not at all where window and size are powers of two.
  uint32_t tile = kTileSide;
  uint32_t timed_frames =
      0;  // drawn again so many times for `frame_seconds`, at most kMaxTimedFrames
};
inline constexpr uint32_t kMaxTimedFrames = 1000;

struct RenderedOutput {
  std::string name;
  uint32_t channels = 4;      // of the shader's output
  textures::Image image;      // kImage8, kImage16: grey, RGB or RGBA
  std::vector<float> floats;  // kFloat: four for each pixel, row 0 at the bottom; those beyond
                              // `channels` mean nothing
  uint64_t nan_pixels = 0;    // drawn as 0 in images; also warned of in the diagnostics
};

struct RenderResult {
  Diagnostics diagnostics;
  std::vector<RenderedOutput> outputs;  // in the order asked for
  std::string context;                  // which context was used, with its version and renderer
  std::string context_note;             // why another was not; may be empty
  std::string driver_log;               // what the driver said of the shader, and printed
  double compile_seconds =
      0;  // compiling, linking and the first draw, at which drivers finish compiling
  std::vector<double> frame_seconds;
  bool ok() const { return !diagnostics.HasErrors(); }
};

RenderResult Render(const RenderRequest& request);
// The same for many in as few processes as can be; a failure concerns its own request only.
// `on_result` is called, on this thread, whenever a request has been drawn or has failed there.
std::vector<RenderResult> RenderAll(std::span<const RenderRequest> requests,
                                    const std::function<void()>& on_result = {});

// Textures that were made in this process, by the file that the manifest names.
using MadeTextures = std::map<std::string, std::shared_ptr<const textures::TextureData>>;

// Reads the images and KTX 2.0 files that the manifest's used textures name, relative to `folder`,
// from inside `roots`; what was `made` is taken from there. False with what is wrong in
// `diagnostics`.
bool LoadTextures(const Manifest& manifest, const std::string& folder,
                  std::vector<TextureBinding>& textures, Diagnostics& diagnostics,
                  const Roots& roots = {}, const MadeTextures& made = {});

}  // namespace texgraph::runtime
