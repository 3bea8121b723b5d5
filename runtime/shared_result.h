// SPDX-License-Identifier: Apache-2.0
// The memory that the child process shares with its parent, one block for each request: plain data
// only, since the child may end at any point. The parent trusts nothing in it but numbers that it
// checks.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>

#include "compiler/base/diagnostics.h"
#include "runtime/render.h"

namespace texgraph::runtime {

enum class Stage : uint32_t {
  kWaiting,
  kOpening,
  kUploading,
  kCompiling,
  kDrawing,
  kTiming,
  kDone
};

inline constexpr uint32_t kMaxOutputs = 8;  // what every OpenGL can draw at once

struct SharedResult {
  std::atomic<Stage> stage;
  uint32_t failed;
  DiagnosticKind kind;
  char message[1024];
  char context[512];
  char context_note[1024];
  char driver_log[16384];
  uint64_t nan_pixels[kMaxOutputs];
  double compile_seconds;
  uint32_t frame_count;
  double frame_seconds[kMaxTimedFrames];
  // The pixels follow, output after output, at kPixelOffset.

  uint8_t* Pixels();
  void Fail(DiagnosticKind failure, const std::string& text);
  // Cuts what does not fit.
  template <size_t N>
  static void SetText(char (&field)[N], const std::string& text) {
    const size_t size = text.size() < N - 1 ? text.size() : N - 1;
    text.copy(field, size);
    field[size] = '\0';
  }
};

inline constexpr size_t kPixelOffset = 64 << 10;
static_assert(sizeof(SharedResult) <= kPixelOffset);

inline uint8_t* SharedResult::Pixels() { return reinterpret_cast<uint8_t*>(this) + kPixelOffset; }

inline void SharedResult::Fail(DiagnosticKind failure, const std::string& text) {
  failed = 1;
  kind = failure;
  SetText(message, text);
}

// An output of a request, resolved.
struct PlannedOutput {
  const ManifestOutput* output = nullptr;
  uint32_t channels = 4;        // of the shader's output
  uint32_t image_channels = 4;  // of a picture of it
  size_t offset = 0;            // into the pixels
  size_t bytes = 0;
};

struct PlannedSampler {
  std::string variable;
  const textures::TextureData* data = nullptr;
};

struct RenderPlan {
  std::vector<PlannedOutput> outputs;
  std::vector<PlannedSampler> samplers;  // each variable once
  size_t bytes = 0;                      // of the pixels
};

// Checks a request without touching a driver. Reported: kSizeLimit, kUsage, kUnknownOutput,
// kNotRenderable.
bool PlanRender(const RenderRequest& request, RenderPlan& plan, Diagnostics& diagnostics);
// The part of it that concerns the request's scene, if there is one.
bool CheckScene(const RenderRequest& request, Diagnostics& diagnostics);

}  // namespace texgraph::runtime
