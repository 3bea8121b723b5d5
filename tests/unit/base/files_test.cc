// SPDX-License-Identifier: Apache-2.0
#include "compiler/base/files.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <thread>

#include "tests/unit/base/scratch_folder.h"

namespace texgraph {
namespace {

using testing::HasSubstr;

constexpr size_t kLimit = 1 << 20;

// The only diagnostic's kind and message after a read that must fail.
std::pair<DiagnosticKind, std::string> FailureOf(const std::string& path, size_t limit = kLimit) {
  Diagnostics diagnostics;
  EXPECT_FALSE(ReadFile(path, limit, {}, diagnostics).has_value()) << path;
  EXPECT_EQ(diagnostics.all().size(), 1u);
  if (diagnostics.all().empty()) return {};
  return {diagnostics.all()[0].kind, diagnostics.all()[0].message};
}

TEST(ReadFile, WholeFiles) {
  ScratchFolder folder;
  std::string zeros("a\0b\r\n", 5), large(300'000, 'x');
  folder.Write("zeros", zeros);
  folder.Write("large", large);
  folder.Write("empty", "");
  Diagnostics diagnostics;
  EXPECT_EQ(ReadFile(folder / "zeros", kLimit, {}, diagnostics), zeros);
  EXPECT_EQ(ReadFile(folder / "large", kLimit, {}, diagnostics), large);
  EXPECT_EQ(ReadFile(folder / "empty", kLimit, {}, diagnostics), "");
  // Regular files that say that they are empty, and are not.
  EXPECT_THAT(ReadFile("/proc/self/status", kLimit, {}, diagnostics).value_or(""),
              HasSubstr("Pid:"));
  EXPECT_FALSE(diagnostics.HasErrors());
}

TEST(ReadFile, TheLimitIsExact) {
  ScratchFolder folder;
  folder.Write("ten", "0123456789");
  Diagnostics diagnostics;
  EXPECT_EQ(ReadFile(folder / "ten", 10, {}, diagnostics), "0123456789");
  EXPECT_FALSE(diagnostics.HasErrors());
  EXPECT_EQ(FailureOf(folder / "ten", 9).first, DiagnosticKind::kSizeLimit);
  EXPECT_EQ(FailureOf("/proc/self/status", 9).first, DiagnosticKind::kSizeLimit);
}

TEST(ReadFile, AHugeFileIsRefusedBeforeItIsRead) {
  ScratchFolder folder;
  folder.Write("sparse", "");
  ASSERT_EQ(truncate((folder / "sparse").c_str(), off_t{1} << 40), 0);
  EXPECT_EQ(FailureOf(folder / "sparse").first, DiagnosticKind::kSizeLimit);
}

TEST(ReadFile, OnlyRegularFiles) {
  ScratchFolder folder;
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  ASSERT_EQ(mkdir((folder / "sub").c_str(), 0700), 0);
  ASSERT_EQ(symlink("loop", (folder / "loop").c_str()), 0);
  auto message = [](const std::string& path) {
    auto [kind, text] = FailureOf(path);
    EXPECT_EQ(kind, DiagnosticKind::kCannotRead);
    return text;
  };
  EXPECT_THAT(message(folder / "pipe"), HasSubstr("it is a pipe"));
  EXPECT_THAT(message(folder / "sub"), HasSubstr("it is a folder"));
  EXPECT_THAT(message("/dev/zero"), HasSubstr("it is a device"));
  EXPECT_THAT(message(folder / "none"), HasSubstr("no such file or directory"));
  EXPECT_THAT(message(folder / "loop"), HasSubstr("symbolic links"));
  EXPECT_THAT(message(""), HasSubstr("no such file"));
  EXPECT_THAT(message(std::string(10'000, 'a')), HasSubstr("name too long"));
  EXPECT_THAT(message(std::string("a\0b", 3)), HasSubstr("zero byte"));
  EXPECT_THAT(message("\x1b[31m"), HasSubstr("'\\x1b[31m'"));
}

TEST(ReadStandardInput, APipeToItsEndAndToTheLimit) {
  int saved = dup(STDIN_FILENO);
  auto feed = [](const std::string& text, size_t limit, Diagnostics& diagnostics) {
    int ends[2];
    EXPECT_EQ(pipe(ends), 0);
    dup2(ends[0], STDIN_FILENO);
    close(ends[0]);
    std::thread writer([&] {
      for (size_t at = 0; at < text.size(); at += 1000) {
        if (write(ends[1], text.data() + at, std::min<size_t>(1000, text.size() - at)) < 0) break;
      }
      close(ends[1]);
    });
    auto read = ReadStandardInput(limit, diagnostics);
    dup2(open("/dev/null", O_RDONLY | O_CLOEXEC), STDIN_FILENO);  // closes the pipe
    writer.join();
    return read;
  };
  signal(SIGPIPE, SIG_IGN);
  Diagnostics diagnostics;
  std::string text(100'000, 'y');
  EXPECT_EQ(feed(text, kLimit, diagnostics), text);
  EXPECT_FALSE(diagnostics.HasErrors());
  EXPECT_FALSE(feed(text, 99'999, diagnostics).has_value());
  EXPECT_EQ(diagnostics.exit_code(), ExitCode::kLimit);
  Diagnostics closed;
  close(STDIN_FILENO);
  EXPECT_FALSE(ReadStandardInput(kLimit, closed).has_value());
  EXPECT_EQ(closed.exit_code(), ExitCode::kIo);
  dup2(saved, STDIN_FILENO);
  close(saved);
}

TEST(Paths, FoldersNamesAndJoining) {
  EXPECT_EQ(FolderOf("a/b/c.json"), "a/b");
  EXPECT_EQ(FolderOf("c.json"), "");
  EXPECT_EQ(FolderOf("/c.json"), "/");
  EXPECT_EQ(FileNameOf("a/b/c.json"), "c.json");
  EXPECT_EQ(FileNameOf("c.json"), "c.json");
  EXPECT_EQ(FileNameOf("a/"), "");
  EXPECT_EQ(JoinPath("a", "b"), "a/b");
  EXPECT_EQ(JoinPath("a/", "b"), "a/b");
  EXPECT_EQ(JoinPath("", "b"), "b");
  EXPECT_EQ(JoinPath("/", "b"), "/b");
  EXPECT_EQ(JoinPath("a", "/b"), "/b");
}

TEST(Paths, SameFile) {
  ScratchFolder folder;
  folder.Write("a", "x");
  folder.Write("b", "x");
  ASSERT_EQ(symlink("a", (folder / "link").c_str()), 0);
  EXPECT_TRUE(SameFile(folder / "a", folder / "./a"));
  EXPECT_TRUE(SameFile(folder / "a", folder / "link"));
  EXPECT_FALSE(SameFile(folder / "a", folder / "b"));
  EXPECT_FALSE(SameFile(folder / "none", folder / "none"));
}

TEST(Paths, AbsoluteAndRelative) {
  std::string here = std::filesystem::current_path();
  EXPECT_EQ(AbsolutePath("/a/./b//../c/"), "/a/c");
  EXPECT_EQ(AbsolutePath("/../.."), "/");
  EXPECT_EQ(AbsolutePath(""), here);
  EXPECT_EQ(AbsolutePath("x/../y"), here + "/y");
  EXPECT_EQ(RelativePath("/a/b/c.png", "/a/b"), "c.png");
  EXPECT_EQ(RelativePath("/a/b/c.png", "/a/x/y"), "../../b/c.png");
  EXPECT_EQ(RelativePath("a/c.png", ""), "a/c.png");
  EXPECT_EQ(RelativePath("c.png", "out"), "../c.png");
  EXPECT_EQ(RelativePath("a/", "a"), ".");
  EXPECT_EQ(RelativePath("/a", "/"), "a");
  // The library of the standard agrees.
  for (const char* path : {"a/b", "../x", "/usr/lib", "a/../../q"}) {
    for (const char* folder : {".", "a", "../z/w", "/usr"}) {
      auto normal = [](const char* p) { return std::filesystem::absolute(p).lexically_normal(); };
      EXPECT_EQ(RelativePath(path, folder), normal(path).lexically_relative(normal(folder)))
          << path << folder;
    }
  }
}

TEST(ErrorText, LowerCaseWithoutLocale) {
  EXPECT_EQ(ErrorText(ENOENT), "no such file or directory");
  EXPECT_EQ(ErrorText(123456), "error 123456");
}

}  // namespace
}  // namespace texgraph
