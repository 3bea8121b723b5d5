// SPDX-License-Identifier: Apache-2.0
// Each case that changes the process (limits, users, signals, descriptors) runs in a forked child.
#include "compiler/base/output_files.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "tests/unit/base/scratch_folder.h"

namespace texgraph {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using Outputs = std::vector<std::pair<std::string, std::string>>;

// The message of the failure, "" on success.
std::string Commit(const Outputs& outputs) {
  OutputFiles files;
  for (const auto& [path, bytes] : outputs) files.Add(path, bytes);
  Diagnostics diagnostics;
  bool done = files.Commit(diagnostics);
  EXPECT_EQ(done, !diagnostics.HasErrors());
  if (done) return "";
  EXPECT_EQ(diagnostics.exit_code(), ExitCode::kIo);
  return diagnostics.all()[0].message;
}

// The exit code of a child that runs `body`, or minus the signal that ended it.
int InChild(const std::function<int()>& body) {
  pid_t child = fork();
  if (child == 0) _exit(body());
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

mode_t ModeOf(const std::string& path) {
  struct stat status;
  return stat(path.c_str(), &status) == 0 ? status.st_mode & 07777 : 0;
}

TEST(OutputFiles, NewFilesAndReplacedFiles) {
  ScratchFolder folder;
  folder.Write("old.frag", "old");
  EXPECT_EQ(
      Commit({{folder / "old.frag", "new"}, {folder / "shader.json", std::string(200'000, 'j')}}),
      "");
  EXPECT_EQ(folder.Read("old.frag"), "new");
  EXPECT_EQ(folder.Read("shader.json").size(), 200'000u);
  EXPECT_THAT(folder.Names(), ElementsAre("old.frag", "shader.json"));
}

TEST(OutputFiles, StagedFilesAppearAtTheCommit) {
  ScratchFolder folder;
  folder.Write("b", "old");
  Diagnostics diagnostics;
  {
    OutputFiles files;
    EXPECT_TRUE(files.Stage(folder / "a", "first", diagnostics));
    EXPECT_TRUE(files.Stage(folder / "b", "second", diagnostics));
    files.Add(folder / "c", "third");
    EXPECT_EQ(folder.Read("b"), "old");
    EXPECT_EQ(folder.Read("a"), "");
    EXPECT_TRUE(files.Commit(diagnostics));
  }
  EXPECT_THAT(folder.Names(), ElementsAre("a", "b", "c"));
  EXPECT_EQ(folder.Read("a") + folder.Read("b") + folder.Read("c"), "firstsecondthird");
  EXPECT_FALSE(diagnostics.HasErrors());
}

TEST(OutputFiles, StagedFilesWithoutACommitLeaveNothing) {
  ScratchFolder folder;
  folder.Write("b", "old");
  Diagnostics diagnostics;
  {
    OutputFiles files;
    EXPECT_TRUE(files.Stage(folder / "a", "first", diagnostics));
    EXPECT_TRUE(files.Stage(folder / "b", "second", diagnostics));
    EXPECT_FALSE(files.Stage(folder / "missing/c", "third", diagnostics));
  }
  EXPECT_THAT(diagnostics.all()[0].message, HasSubstr("missing/c': no such file"));
  EXPECT_THAT(folder.Names(), ElementsAre("b"));
  EXPECT_EQ(folder.Read("b"), "old");
}

TEST(OutputFiles, NothingChangesWhenOneCannotBeWritten) {
  ScratchFolder folder;
  folder.Write("a", "old");
  ASSERT_EQ(mkdir((folder / "sub").c_str(), 0700), 0);
  EXPECT_THAT(Commit({{folder / "a", "new"}, {folder / "missing/b", "x"}}),
              HasSubstr("missing/b': no such file"));
  EXPECT_THAT(Commit({{folder / "a", "new"}, {folder / "sub", "x"}}), HasSubstr("it is a folder"));
  EXPECT_THAT(Commit({{folder / "a", "new"}, {"/dev/full", "x"}}), HasSubstr("no space left"));
  EXPECT_THAT(Commit({{folder / "a", "new"}, {folder / "new/", "x"}}), HasSubstr("cannot write"));
  EXPECT_THAT(Commit({{folder / "a", "new"}, {"", "x"}}), HasSubstr("cannot write"));
  EXPECT_THAT(Commit({{folder / "a", "new"}, {folder / "a/b", "x"}}), HasSubstr("not a directory"));
  EXPECT_EQ(folder.Read("a"), "old");
  EXPECT_THAT(folder.Names(), ElementsAre("a", "sub"));
}

TEST(OutputFiles, ALinkToNowhereChangesNothing) {
  ScratchFolder folder;
  folder.Write("a", "old");
  ASSERT_EQ(mkdir((folder / "sub").c_str(), 0700), 0);
  ASSERT_EQ(symlink("nowhere/x", (folder / "dangling").c_str()), 0);
  EXPECT_THAT(Commit({{folder / "a", "new"}, {folder / "c", "new"}, {folder / "dangling", "x"}}),
              HasSubstr("no such file"));
  EXPECT_EQ(folder.Read("a"), "old");
  EXPECT_THAT(folder.Names(), ElementsAre("a", "dangling", "sub"));
}

TEST(OutputFiles, RenamesBeforeAFailedOneAreTakenBack) {
  if (getuid() != 0) GTEST_SKIP() << "needs a second user";
  ScratchFolder folder;
  // Nobody may write to the file but, in a sticky folder of somebody else's, not rename over it.
  folder.Write("old", "old");
  chmod((folder / "old").c_str(), 0666);
  ASSERT_EQ(mkdir((folder / "sticky").c_str(), 0755), 0);
  folder.Write("sticky/b", "old");
  chmod((folder / "sticky/b").c_str(), 0666);
  chmod((folder / "sticky").c_str(), 01777);
  EXPECT_EQ(InChild([&] {
              if (setuid(65534) != 0) return 10;
              Outputs outputs = {
                  {folder / "old", "new"}, {folder / "fresh", "new"}, {folder / "sticky/b", "new"}};
              std::string message = Commit(outputs);
              return message.find("sticky/b': operation not permitted") == std::string::npos ? 11
                                                                                             : 0;
            }),
            0);
  EXPECT_EQ(folder.Read("old"), "old");
  EXPECT_EQ(folder.Read("sticky/b"), "old");
  EXPECT_THAT(folder.Names(), ElementsAre("old", "sticky"));
}

TEST(OutputFiles, LinksAreFollowedAndStay) {
  ScratchFolder folder;
  folder.Write("real", "old");
  ASSERT_EQ(symlink("real", (folder / "link").c_str()), 0);
  ASSERT_EQ(symlink("fresh", (folder / "dangling").c_str()), 0);
  ASSERT_EQ(symlink("loop", (folder / "loop").c_str()), 0);
  EXPECT_EQ(Commit({{folder / "link", "new"}, {folder / "dangling", "made"}}), "");
  EXPECT_EQ(folder.Read("real"), "new");
  EXPECT_EQ(folder.Read("fresh"), "made");
  EXPECT_THAT(folder.Names(), ElementsAre("dangling", "fresh", "link", "loop", "real"));
  EXPECT_THAT(Commit({{folder / "loop", "x"}}), HasSubstr("symbolic links"));
}

TEST(OutputFiles, PermissionsAreKeptOrFollowTheUmask) {
  ScratchFolder folder;
  folder.Write("private", "old");
  chmod((folder / "private").c_str(), 0640);
  mode_t old = umask(077);
  EXPECT_EQ(Commit({{folder / "private", "new"}, {folder / "fresh", "x"}}), "");
  umask(022);
  EXPECT_EQ(Commit({{folder / "public", "x"}}), "");
  umask(old);
  EXPECT_EQ(ModeOf(folder / "private"), 0640u);
  EXPECT_EQ(ModeOf(folder / "fresh"), 0600u);
  EXPECT_EQ(ModeOf(folder / "public"), 0644u);
}

TEST(OutputFiles, WriteProtectionIsRespected) {
  ScratchFolder folder;
  folder.Write("file", "old");
  chmod((folder / "file").c_str(), 0444);
  ASSERT_EQ(mkdir((folder / "sub").c_str(), 0555), 0);
  EXPECT_EQ(
      InChild([&] {
        if (getuid() == 0 && setuid(65534) != 0) return 10;
        if (Commit({{folder / "file", "new"}}).find("permission denied") == std::string::npos)
          return 11;
        if (Commit({{folder / "sub/x", "new"}}).find("permission denied") == std::string::npos)
          return 12;
        return 0;
      }),
      0);
  EXPECT_EQ(folder.Read("file"), "old");
  EXPECT_THAT(folder.Names(), ElementsAre("file", "sub"));
}

TEST(OutputFiles, DevicesAndPipesAreWrittenDirectly) {
  ScratchFolder folder;
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(Commit({{"/dev/null", "x"}}), "");
  EXPECT_THAT(Commit({{folder / "pipe", "x"}}),
              HasSubstr("cannot write"));  // nobody reads; must not wait
  int reader = open((folder / "pipe").c_str(), O_RDONLY | O_NONBLOCK);
  EXPECT_EQ(Commit({{folder / "pipe", "hello"}}), "");
  char buffer[16];
  EXPECT_EQ(read(reader, buffer, sizeof buffer), 5);
  close(reader);
  EXPECT_THAT(folder.Names(), ElementsAre("pipe"));
}

TEST(OutputFiles, StandardOutputFailuresAreSeen) {
  ScratchFolder folder;
  folder.Write("a", "old");
  auto with_stdout = [&](const std::function<void()>& arrange) {
    return InChild([&] {
      arrange();
      PrepareProcess();
      OutputFiles files;
      files.Add("-", std::string(100'000, 'x'));
      files.Add(folder / "a", "new");
      Diagnostics diagnostics;
      return files.Commit(diagnostics) ? 0 : static_cast<int>(diagnostics.exit_code());
    });
  };
  EXPECT_EQ(with_stdout([] { close(STDOUT_FILENO); }), 3);
  EXPECT_EQ(with_stdout([] { dup2(open("/dev/full", O_WRONLY), STDOUT_FILENO); }), 3);
  EXPECT_EQ(with_stdout([] {
              int ends[2];
              if (pipe(ends) != 0) _exit(9);
              close(ends[0]);
              dup2(ends[1], STDOUT_FILENO);
            }),
            3);
  EXPECT_EQ(folder.Read("a"), "old");
  EXPECT_THAT(folder.Names(), ElementsAre("a"));
}

TEST(OutputFiles, TheFileSizeLimitIsAnError) {
  ScratchFolder folder;
  folder.Write("a", "old");
  EXPECT_EQ(InChild([&] {
              PrepareProcess();
              rlimit limit = {1000, 1000};
              setrlimit(RLIMIT_FSIZE, &limit);
              OutputFiles files;
              files.Add(folder / "a", std::string(5000, 'x'));
              Diagnostics diagnostics;
              return files.Commit(diagnostics) ? 0 : static_cast<int>(diagnostics.exit_code());
            }),
            3);
  EXPECT_EQ(folder.Read("a"), "old");
  EXPECT_THAT(folder.Names(), ElementsAre("a"));
}

TEST(OutputFiles, ASignalInTheMiddleLeavesNothing) {
  ScratchFolder folder;
  folder.Write("a", "old");
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  // The child has written its temporary file and waits for the pipe's reader when the signal comes.
  for (int number : {SIGINT, SIGTERM, SIGHUP}) {
    int reader = open((folder / "pipe").c_str(), O_RDONLY | O_NONBLOCK);
    pid_t child = fork();
    if (child == 0) {
      close(reader);
      PrepareProcess();
      Commit({{folder / "a", "new"}, {folder / "pipe", std::string(1 << 20, 'x')}});
      _exit(0);
    }
    for (int i = 0; i < 5000 && folder.Names().size() < 3; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_EQ(folder.Names().size(), 3u);
    kill(child, number);
    int status = 0;
    waitpid(child, &status, 0);
    close(reader);
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 128 + number);
    EXPECT_EQ(folder.Read("a"), "old");
    EXPECT_THAT(folder.Names(), ElementsAre("a", "pipe"));
  }
}

TEST(OutputFiles, ParallelWritersNeverTear) {
  ScratchFolder folder;
  std::vector<std::thread> writers;
  std::atomic<bool> torn{false}, stop{false};
  std::thread reader([&] {
    while (!stop) {
      std::string text = folder.Read("a");
      bool whole = text.empty() ||
                   (text.size() == 50'000 && text.find_first_not_of(text[0]) == std::string::npos);
      if (!whole) torn = true;
    }
  });
  for (int w = 0; w < 8; ++w) {
    writers.emplace_back([&, w] {
      for (int i = 0; i < 20; ++i) {
        OutputFiles files;
        files.Add(folder / "a", std::string(50'000, static_cast<char>('a' + w)));
        Diagnostics diagnostics;
        EXPECT_TRUE(files.Commit(diagnostics));
      }
    });
  }
  for (std::thread& writer : writers) writer.join();
  stop = true;
  reader.join();
  EXPECT_FALSE(torn);
  EXPECT_THAT(folder.Names(), ElementsAre("a"));
}

}  // namespace
}  // namespace texgraph
