// SPDX-License-Identifier: Apache-2.0
// Drivers that crash, hang, eat memory or lie: failing_driver.cc, once for each way.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <chrono>

#include "runtime/live.h"
#include "tests/render/render_testing.h"

namespace texgraph::runtime {
namespace {

using test::FirstMessage;
using test::FirstName;
using test::FloatAt;
using test::ShaderRequest;
using testing::AllOf;
using testing::HasSubstr;

RenderRequest RequestWith(const std::string& library, ContextChoice choice) {
  RenderRequest request = ShaderRequest("", "out_color = vec4(0.5); out_height = 0.0;", 4, 4);
  request.context.egl_library = library;
  request.context.choice = choice;
  request.timeout = 20;
  return request;
}

double SecondsOf(const RenderRequest& request, RenderResult& result) {
  const auto start = std::chrono::steady_clock::now();
  result = Render(request);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST(FailingDriverTest, CrashAtOpening) {
  const RenderResult result = Render(RequestWith(CRASH_AT_OPENING_LIBRARY, ContextChoice::kEgl));
  EXPECT_EQ(FirstName(result.diagnostics), "driver-failure");
  EXPECT_EQ(result.diagnostics.exit_code(), ExitCode::kRuntime);
  EXPECT_THAT(FirstMessage(result.diagnostics),
              AllOf(HasSubstr("while opening a context"), HasSubstr("SIGSEGV")));
  EXPECT_THAT(result.driver_log, HasSubstr("the driver's last words"));
}

TEST(FailingDriverTest, CrashAtDrawing) {
  const RenderResult result = Render(RequestWith(CRASH_AT_DRAWING_LIBRARY, ContextChoice::kAuto));
  EXPECT_EQ(FirstName(result.diagnostics), "driver-failure");
  EXPECT_THAT(FirstMessage(result.diagnostics),
              AllOf(HasSubstr("while drawing"), HasSubstr("SIGSEGV")));
  EXPECT_THAT(result.context, HasSubstr("EGL"));
}

TEST(FailingDriverTest, CrashBetweenPictures) {
  Diagnostics diagnostics;
  const auto renderer =
      LiveRenderer::Open(RequestWith(CRASH_AT_DRAWING_LIBRARY, ContextChoice::kAuto), diagnostics);
  ASSERT_TRUE(renderer) << FirstMessage(diagnostics);
  EXPECT_THAT(FirstMessage(renderer->Draw(0).diagnostics), HasSubstr("SIGSEGV"));
  EXPECT_THAT(FirstMessage(renderer->Draw(0).diagnostics), HasSubstr("at an earlier picture"));
}

TEST(FailingDriverTest, LiveHangsAreEndedInTime) {
  RenderRequest request = RequestWith(HANG_AT_DRAWING_LIBRARY, ContextChoice::kEgl);
  request.timeout = 0.7;
  Diagnostics diagnostics;
  auto renderer = LiveRenderer::Open(request, diagnostics);
  ASSERT_TRUE(renderer) << FirstMessage(diagnostics);
  EXPECT_EQ(FirstName(renderer->Draw(0).diagnostics), "time-limit");
  renderer.reset();
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);  // no child is left
}

TEST(FailingDriverTest, HangsAreEndedInTime) {
  for (const char* library : {HANG_AT_OPENING_LIBRARY, HANG_AT_DRAWING_LIBRARY}) {
    RenderRequest request = RequestWith(library, ContextChoice::kEgl);
    request.timeout = 0.7;
    RenderResult result;
    const double seconds = SecondsOf(request, result);
    EXPECT_GE(seconds, 0.7);
    EXPECT_LT(seconds, 10);
    EXPECT_EQ(FirstName(result.diagnostics), "time-limit") << FirstMessage(result.diagnostics);
    EXPECT_EQ(result.diagnostics.exit_code(), ExitCode::kRuntime);
  }
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);  // no child is left
}

TEST(FailingDriverTest, MemoryIsLimited) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer needs more memory than the limit allows";
#endif
  RenderRequest request = RequestWith(GREEDY_AT_OPENING_LIBRARY, ContextChoice::kEgl);
  request.memory_limit = size_t{256} << 20;
  const RenderResult result = Render(request);
  EXPECT_EQ(FirstName(result.diagnostics), "driver-failure");
  EXPECT_THAT(FirstMessage(result.diagnostics), HasSubstr("SIGABRT"));
}

// What EGL does wrong while a context is opened, OSMesa may still do right; the result says so.
TEST(FailingDriverTest, AutoGoesOnWithOsmesa) {
  const std::pair<const char*, const char*> cases[] = {
      {CRASH_AT_OPENING_LIBRARY, "SIGSEGV"},
      {HANG_AT_OPENING_LIBRARY, "it hung"},
      {SILENT_LIBRARY, "does not answer"},
      {INCOMPLETE_LIBRARY, "glGetFragDataLocation"},
      {"/no/such/library.so", "cannot be loaded"}};
  for (const auto& [library, why] : cases) {
    RenderRequest request = RequestWith(library, ContextChoice::kAuto);
    request.timeout = 2;
    const RenderResult result = Render(request);
    ASSERT_TRUE(result.ok()) << library << FirstMessage(result.diagnostics);
    EXPECT_THAT(result.context, HasSubstr("OSMesa"));
    EXPECT_THAT(result.context_note, AllOf(HasSubstr("EGL"), HasSubstr(why)));
    EXPECT_EQ(FloatAt(result.outputs[0], 4, 1, 1, 0), 0.5f);
  }
}

TEST(FailingDriverTest, NoContextAtAll) {
  RenderRequest request = RequestWith("/no/such/library.so", ContextChoice::kAuto);
  request.context.osmesa_library = "/nor/this/one.so";
  const RenderResult result = Render(request);
  EXPECT_EQ(FirstName(result.diagnostics), "no-context");
  EXPECT_EQ(result.diagnostics.exit_code(), ExitCode::kRuntime);
  EXPECT_THAT(FirstMessage(result.diagnostics),
              AllOf(HasSubstr("/no/such/library.so"), HasSubstr("/nor/this/one.so")));
}

TEST(FailingDriverTest, OutOfMemoryIsALimit) {
  const RenderResult result = Render(RequestWith(OUT_OF_MEMORY_LIBRARY, ContextChoice::kEgl));
  EXPECT_EQ(FirstName(result.diagnostics), "out-of-memory") << FirstMessage(result.diagnostics);
  EXPECT_EQ(result.diagnostics.exit_code(), ExitCode::kLimit);
}

TEST(FailingDriverTest, OneCrashLeavesTheOthers) {
  std::vector<RenderRequest> requests(4, RequestWith("libEGL.so.1", ContextChoice::kEgl));
  requests[1].context.egl_library = CRASH_AT_DRAWING_LIBRARY;
  requests[2].context.egl_library = CRASH_AT_DRAWING_LIBRARY;
  const std::vector<RenderResult> results = RenderAll(requests);
  EXPECT_TRUE(results[0].ok());
  EXPECT_EQ(FirstName(results[1].diagnostics), "driver-failure");
  EXPECT_EQ(FirstName(results[2].diagnostics), "driver-failure");
  EXPECT_TRUE(results[3].ok());
}

// A real driver that takes too long: a thousand dependent sines keep Mesa's compiler busy for many
// seconds.
TEST(FailingDriverTest, SlowCompilersAreStopped) {
  std::string body = "float x = uv.x + time;\n";
  for (int i = 0; i < 3000; ++i) body += "x = sin(x + " + std::to_string(i) + ".25);\n";
  RenderRequest request = ShaderRequest("", body + "out_color = vec4(x); out_height = x;", 4, 4);
  request.timeout = 0.8;
  RenderResult result;
  const double seconds = SecondsOf(request, result);
  EXPECT_LT(seconds, 10);
  EXPECT_EQ(FirstName(result.diagnostics), "time-limit") << FirstMessage(result.diagnostics);
}

}  // namespace
}  // namespace texgraph::runtime
