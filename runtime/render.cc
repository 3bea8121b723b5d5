// SPDX-License-Identifier: Apache-2.0
#include "runtime/render.h"

#include <fmt/format.h>
#include <string.h>
#include <sys/mman.h>

#include <new>

#include "runtime/child.h"
#include "runtime/draw.h"
#include "runtime/shared_result.h"

namespace texgraph::runtime {
namespace {

// Requests that share a child may ask for so many bytes of pixels together.
constexpr size_t kGroupBytes = size_t{256} << 20;

class SharedBlock {
 public:
  SharedBlock() = default;
  SharedBlock(const SharedBlock&) = delete;
  SharedBlock& operator=(const SharedBlock&) = delete;
  ~SharedBlock() {
    if (result_ != nullptr) munmap(result_, size_);
  }
  bool Allocate(size_t pixel_bytes) {
    size_ = kPixelOffset + pixel_bytes;
    void* memory = mmap(nullptr, size_, PROT_READ | PROT_WRITE,
                        MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (memory == MAP_FAILED) return false;
    result_ = new (memory) SharedResult();
    return true;
  }
  SharedResult& operator*() const { return *result_; }

 private:
  SharedResult* result_ = nullptr;
  size_t size_ = 0;
};

struct Job {
  const RenderRequest* request;
  RenderResult* result;
  RenderPlan plan;
  SharedBlock shared;
};

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

bool SameContext(const ContextOptions& a, const ContextOptions& b) {
  return a.choice == b.choice && a.egl_library == b.egl_library &&
         a.osmesa_library == b.osmesa_library;
}

// The text of a field that the child wrote.
template <size_t N>
std::string Text(const char (&field)[N]) {
  return std::string(field, strnlen(field, N));
}

// --- In the child
// --------------------------------------------------------------------------------------------------

void DrawAll(std::span<Job* const> jobs, const ContextOptions& options,
             const std::function<void()>& notify) {
  (*jobs[0]->shared).stage = Stage::kOpening;
  std::string why_not;
  const std::unique_ptr<GlContext> context = OpenContext(options, why_not);
  for (Job* job : jobs) {
    SharedResult& shared = *job->shared;
    SharedResult::SetText(shared.context_note, why_not);
    if (context) {
      SharedResult::SetText(shared.context, context->description);
      DrawRequest(*context, *job->request, job->plan, shared);
    } else {
      shared.Fail(DiagnosticKind::kNoContext,
                  fmt::format("there is no OpenGL context: {}", why_not));
    }
    shared.stage = Stage::kDone;
    notify();
  }
}

// --- In the parent
// -------------------------------------------------------------------------------------------------

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

// The child said that it is done with this job.
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

// The child crashed or was too slow at this job.
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

// Runs the jobs in one child until one fails hard. Returns how many have a result, at least one.
size_t RunGroup(std::span<Job* const> jobs, const std::function<void()>& on_result) {
  ContextOptions options = jobs[0]->request->context;
  for (;;) {
    Child child;
    std::string why_not;
    const bool started = child.Start(
        jobs[0]->request->memory_limit,
        [&](const std::function<void()>& notify) { DrawAll(jobs, options, notify); }, why_not);
    if (!started) {
      jobs[0]->result->diagnostics.Error(
          DiagnosticKind::kDriverFailure, {},
          fmt::format("cannot start a process for the driver: {}", why_not));
      return 1;
    }
    size_t done = 0;
    Child::Event event = Child::Event::kNotified;
    while (done < jobs.size() &&
           (event = child.Wait(jobs[done]->request->timeout)) == Child::Event::kNotified) {
      Collect(*jobs[done++]);
      if (on_result) on_result();
    }
    if (done == jobs.size()) return done;
    const bool opening = done == 0 && (*jobs[0]->shared).stage == Stage::kOpening;
    if (!opening || options.choice != ContextChoice::kAuto) {
      CollectFailure(*jobs[done], child, event);
      if (on_result) on_result();
      return done + 1;
    }
    // EGL took the process with it; what is left is OSMesa.
    const std::string how = event == Child::Event::kTimedOut ? "it hung" : child.ending();
    for (Job* job : jobs)
      job->result->context_note = fmt::format("EGL failed while opening a context ({})", how);
    options.choice = ContextChoice::kOsmesa;
  }
}

}  // namespace

std::vector<RenderResult> RenderAll(std::span<const RenderRequest> requests,
                                    const std::function<void()>& on_result) {
  std::vector<RenderResult> results(requests.size());
  size_t next = 0;
  while (next < requests.size()) {
    std::vector<std::unique_ptr<Job>> jobs;
    std::vector<Job*> group;
    size_t bytes = 0;
    for (; next < requests.size(); ++next) {
      auto job = std::make_unique<Job>();
      job->request = &requests[next];
      job->result = &results[next];
      if (!PlanRender(*job->request, job->plan, job->result->diagnostics)) continue;
      const bool fits =
          group.empty() || (SameContext(job->request->context, group[0]->request->context) &&
                            bytes + job->plan.bytes <= kGroupBytes);
      if (!fits) break;
      if (!job->shared.Allocate(job->plan.bytes)) {
        job->result->diagnostics.Error(DiagnosticKind::kOutOfMemory, {},
                                       "there is not enough memory for the picture");
        continue;
      }
      bytes += job->plan.bytes;
      group.push_back(job.get());
      jobs.push_back(std::move(job));
    }
    for (size_t done = 0; done < group.size();) {
      done += RunGroup(std::span<Job* const>(group).subspan(done), on_result);
    }
  }
  return results;
}

RenderResult Render(const RenderRequest& request) {
  return std::move(RenderAll(std::span<const RenderRequest>(&request, 1))[0]);
}

}  // namespace texgraph::runtime
