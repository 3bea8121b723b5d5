// SPDX-License-Identifier: Apache-2.0
#include "runtime/render.h"

#include <fmt/format.h>

#include "runtime/draw.h"
#include "runtime/job.h"

namespace texgraph::runtime {
namespace {

// Requests that share a child may ask for so many bytes of pixels together.
constexpr size_t kGroupBytes = size_t{256} << 20;

bool SameContext(const ContextOptions& a, const ContextOptions& b) {
  return a.choice == b.choice && a.egl_library == b.egl_library &&
         a.osmesa_library == b.osmesa_library;
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
      Drawing drawing(*context, *job->request, job->plan, shared);
      if (drawing.Prepare() && drawing.Draw()) drawing.TimeFrames();
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
