// SPDX-License-Identifier: Apache-2.0
#include "runtime/job.h"

#include <fmt/format.h>
#include <string.h>
#include <sys/mman.h>

#include <algorithm>
#include <new>

namespace texgraph::runtime {
namespace {

std::string_view Doing(Stage stage) {
  switch (stage) {
    case Stage::kWaiting:
    case Stage::kOpening:
      return "opening a context";
    case Stage::kUploading:
      return "uploading textures";
    case Stage::kCompiling:
      return "compiling the shader";
    case Stage::kDrawing:
    case Stage::kTiming:
    case Stage::kDone:
      break;
  }
  return "drawing";
}

// The text of a field that the child wrote.
template <size_t N>
std::string Text(const char (&field)[N]) {
  return std::string(field, strnlen(field, N));
}

void CopyOutput(const Job& job, size_t index) {
  const RenderRequest& request = *job.request;
  const PlannedOutput& planned = job.plan.outputs[index];
  SharedResult& shared = *job.shared;
  const uint8_t* pixels = shared.Pixels() + planned.offset;
  RenderedOutput& output = job.result->outputs.emplace_back();
  output.name = planned.output->name;
  output.channels = planned.channels;
  output.nan_pixels = shared.nan_pixels[index];
  if (request.format == PixelFormat::kFloat) {
    output.floats.resize(planned.bytes / sizeof(float));
    memcpy(output.floats.data(), pixels, planned.bytes);
  } else {
    output.image.width = request.width;
    output.image.height = request.height;
    output.image.channels = static_cast<uint8_t>(planned.image_channels);
    output.image.bits = request.format == PixelFormat::kImage16 ? 16 : 8;
    output.image.pixels.assign(pixels, pixels + planned.bytes);
  }
  if (output.nan_pixels == 0) return;
  job.result->diagnostics.Warn(
      DiagnosticKind::kNanPixels, {},
      fmt::format("{} of {} pixels of output '{}' are NaN", output.nan_pixels,
                  uint64_t{request.width} * request.height, Printable(output.name)));
}

}  // namespace

SharedBlock::~SharedBlock() {
  if (result_ != nullptr) munmap(result_, size_);
}

bool SharedBlock::Allocate(size_t pixel_bytes) {
  size_ = kPixelOffset + pixel_bytes;
  void* memory = mmap(nullptr, size_, PROT_READ | PROT_WRITE,
                      MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory == MAP_FAILED) return false;
  result_ = new (memory) SharedResult();
  return true;
}

void Collect(const Job& job) {
  SharedResult& shared = *job.shared;
  RenderResult& result = *job.result;
  result.context = Text(shared.context);
  if (result.context_note.empty()) result.context_note = Text(shared.context_note);
  result.driver_log = Text(shared.driver_log);
  result.compile_seconds = shared.compile_seconds;
  if (shared.failed != 0) {
    Diagnostic& error = result.diagnostics.Error(shared.kind, {}, Text(shared.message));
    if (shared.kind == DiagnosticKind::kDriverCompile && !result.driver_log.empty()) {
      error.AddNote({}, Printable(result.driver_log, 2000));
    }
    return;
  }
  const uint32_t frames = std::min(shared.frame_count, job.request->timed_frames);
  result.frame_seconds.assign(shared.frame_seconds, shared.frame_seconds + frames);
  for (size_t i = 0; i < job.plan.outputs.size(); ++i) CopyOutput(job, i);
}

void CollectFailure(const Job& job, const Child& child, Child::Event event) {
  SharedResult& shared = *job.shared;
  RenderResult& result = *job.result;
  result.context = Text(shared.context);
  result.driver_log = Text(shared.driver_log) + child.Printed();
  const std::string_view doing = Doing(shared.stage);
  if (event == Child::Event::kTimedOut) {
    result.diagnostics.Error(
        DiagnosticKind::kTimeLimit, {},
        fmt::format("the driver was stopped after {} s while {}; --timeout sets the limit",
                    job.request->timeout, doing));
    return;
  }
  Diagnostic& error = result.diagnostics.Error(
      DiagnosticKind::kDriverFailure, {},
      fmt::format("the driver ended its process while {} ({})", doing, child.ending()));
  const std::string printed = child.Printed();
  if (!printed.empty()) error.AddNote({}, "it printed: " + Printable(printed, 2000));
}

}  // namespace texgraph::runtime
