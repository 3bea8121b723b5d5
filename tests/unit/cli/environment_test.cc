// SPDX-License-Identifier: Apache-2.0
// The machine around texgraphc: limits, descriptors, signals, devices, locales. HOSTILE.md's inputs
// 45 to 49 and 123 to 139.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <string>
#include <thread>

#include "tests/unit/base/scratch_folder.h"
#include "tests/unit/cli/program.h"
#include "tests/unit/cli/sample_graphs.h"

namespace texgraph {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

void Limit(int resource, rlim_t value) {
  rlimit limit = {value, value};
  setrlimit(static_cast<__rlimit_resource>(resource), &limit);
}

class Environment : public testing::Test {
 protected:
  void SetUp() override {
    folder.Write("wall.json", std::string(kProceduralGraph));
    folder.Write("x.frag", "old");
  }

  // Must fail with this code and leave the old shader, and no other new file.
  Outcome ExpectFailure(Program program, int exit_code) {
    std::vector<std::string> before = folder.Names();
    program.folder = folder.path();
    program.time_limit = 30;
    Outcome outcome = program.Run();
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.error;
    EXPECT_FALSE(outcome.timed_out);
    EXPECT_EQ(folder.Read("x.frag"), "old");
    EXPECT_EQ(folder.Names(), before);
    return outcome;
  }

  ScratchFolder folder;
};

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kSanitized = true;  // reserves terabytes of addresses
#else
constexpr bool kSanitized = false;
#endif

TEST_F(Environment, InputsThatAreNoFiles) {
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  ASSERT_EQ(mkdir((folder / "sub").c_str(), 0700), 0);
  folder.Write("sparse.json", "");
  ASSERT_EQ(truncate((folder / "sparse.json").c_str(), off_t{1} << 30), 0);
  EXPECT_THAT(ExpectFailure(Texgraphc({"pipe", "-o", "x.frag"}), 3).error,
              HasSubstr("it is a pipe"));
  EXPECT_THAT(ExpectFailure(Texgraphc({"sub", "-o", "x.frag"}), 3).error,
              HasSubstr("it is a folder"));
  EXPECT_THAT(ExpectFailure(Texgraphc({"/dev/zero", "-o", "x.frag"}), 3).error,
              HasSubstr("it is a device"));
  EXPECT_THAT(ExpectFailure(Texgraphc({"nowhere.json", "-o", "x.frag"}), 3).error,
              HasSubstr("[cannot-read]"));
  EXPECT_THAT(ExpectFailure(Texgraphc({"sparse.json", "-o", "x.frag"}), 4).error,
              HasSubstr("[size-limit]"));
  EXPECT_THAT(ExpectFailure(Texgraphc({"", "-o", "x.frag"}), 3).error, HasSubstr("[cannot-read]"));
}

TEST_F(Environment, EndlessStandardInput) {
  Program program = Texgraphc({"-", "-o", "x.frag"});
  program.prepare = [] { dup2(open("/dev/zero", O_RDONLY), STDIN_FILENO); };
  EXPECT_THAT(ExpectFailure(program, 4).error, HasSubstr("[size-limit]"));
}

TEST_F(Environment, OutputsThatCannotBeWritten) {
  ASSERT_EQ(mkdir((folder / "sub").c_str(), 0700), 0);
  for (const char* output :
       {"missing/x.frag", "sub", "/dev/full", "x.frag/y.frag", "/proc/x.frag"}) {
    EXPECT_THAT(ExpectFailure(Texgraphc({"wall.json", "-o", output}), 3).error,
                HasSubstr("[cannot-write]"))
        << output;
  }
  EXPECT_THAT(
      ExpectFailure(Texgraphc({"wall.json", "-o", "x.frag", "--manifest", "/dev/full"}), 3).error,
      HasSubstr("no space left"));
  EXPECT_THAT(ExpectFailure(Texgraphc({"wall.json", "-o", "x.frag", "-MF", "missing/d"}), 3).error,
              HasSubstr("missing/d"));
}

TEST_F(Environment, WriteProtectedOutputs) {
  chmod((folder / "x.frag").c_str(), 0444);
  chmod(folder.path().c_str(), 0755);
  Program program = Texgraphc({"wall.json", "-o", "x.frag"});
  program.prepare = [] {
    if (getuid() == 0 && setuid(65534) != 0) _exit(99);
  };
  EXPECT_THAT(ExpectFailure(program, 3).error, HasSubstr("permission denied"));
}

TEST_F(Environment, StandardOutputThatFails) {
  for (const char* option : {"wall.json", "--help", "--list-blocks"}) {
    Program program = Texgraphc({option, "-o", "-"});
    program.prepare = [] { close(STDOUT_FILENO); };
    EXPECT_THAT(ExpectFailure(program, 3).error, HasSubstr("standard output")) << option;
    program.prepare = [] { dup2(open("/dev/full", O_WRONLY), STDOUT_FILENO); };
    EXPECT_THAT(ExpectFailure(program, 3).error, HasSubstr("no space left")) << option;
    program.prepare = [] {
      int ends[2];
      if (pipe(ends) != 0) _exit(99);
      close(ends[0]);
      dup2(ends[1], STDOUT_FILENO);
    };
    EXPECT_THAT(ExpectFailure(program, 3).error, HasSubstr("broken pipe")) << option;
  }
}

TEST_F(Environment, AllStandardDescriptorsClosed) {
  Program program = Texgraphc({"wall.json", "-o", "y.frag"}, folder.path());
  program.prepare = [] {
    for (int descriptor : {0, 1, 2}) close(descriptor);
  };
  EXPECT_EQ(program.Run().exit_code, 0);
  EXPECT_THAT(folder.Read("y.frag"), HasSubstr("#version 330\n"));
  program.arguments = {"nowhere.json", "-o", "y.frag"};
  EXPECT_EQ(program.Run().exit_code, 3);
}

TEST_F(Environment, FileSizeLimit) {
  Program program = Texgraphc({"wall.json", "-o", "x.frag"});
  program.prepare = [] { Limit(RLIMIT_FSIZE, 100); };
  // The message goes to a file too, and may be cut.
  ExpectFailure(program, 3);
}

TEST_F(Environment, AddressSpaceLimit) {
  if (kSanitized) GTEST_SKIP();
  std::string large = "{ \"texgraph\": 1, \"nodes\": {";
  for (int i = 0; i < 300'000; ++i) {
    large += (i == 0 ? "" : ", ") + ("\"n" + std::to_string(i)) +
             "\": { \"block\": \"add\", \"in\": { \"a\": 1 } }";
  }
  folder.Write("large.json", large + "}, \"outputs\": { \"height\": \"n0\" } }");
  Program program = Texgraphc({"large.json", "-o", "x.frag"});
  program.prepare = [] { Limit(RLIMIT_AS, 60 << 20); };
  EXPECT_THAT(ExpectFailure(program, 4).error, HasSubstr("error: out of memory [out-of-memory]"));
}

TEST_F(Environment, SmallStackFewDescriptorsNoHome) {
  Outcome plain = Texgraphc({"wall.json", "-o", "-"}, folder.path()).Run();
  Program program = Texgraphc({"wall.json", "-o", "y.frag"}, folder.path());
  program.prepare = [] {
    if (!kSanitized) Limit(RLIMIT_STACK, 256 << 10);
    Limit(RLIMIT_NOFILE, 8);
    unsetenv("HOME");
    setenv("TMPDIR", "/nowhere", 1);
    umask(077);
  };
  EXPECT_EQ(program.Run().exit_code, 0);
  EXPECT_EQ(folder.Read("y.frag"), plain.out);
  struct stat status;
  ASSERT_EQ(stat((folder / "y.frag").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0600u);
}

TEST_F(Environment, TheSameBytesInEveryLocaleAndAtEveryTime) {
  Outcome plain = Texgraphc({"wall.json", "-o", "-", "--manifest", "m.json"}, folder.path()).Run();
  std::string manifest = folder.Read("m.json");
  for (const char* setting : {"LC_ALL=de_DE.UTF-8", "LC_ALL=tr_TR.UTF-8", "LC_ALL=nonsense",
                              "SOURCE_DATE_EPOCH=0", "TZ=Asia/Kolkata", "MALLOC_PERTURB_=165"}) {
    Program program = Texgraphc({"wall.json", "-o", "-", "--manifest", "m.json"}, folder.path());
    program.environment = {setting};
    EXPECT_EQ(program.Run().out, plain.out) << setting;
    EXPECT_EQ(folder.Read("m.json"), manifest) << setting;
  }
}

TEST_F(Environment, SignalsWhileWritingLeaveNothing) {
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  for (int number : {SIGINT, SIGTERM}) {
    // Standard output is a pipe that is full, so that the program waits in the middle of its
    // outputs.
    int ends[2];
    ASSERT_EQ(pipe2(ends, O_CLOEXEC | O_NONBLOCK), 0);
    std::string fill(1 << 16, 'x');
    while (write(ends[1], fill.data(), fill.size()) > 0) {
    }
    fcntl(ends[1], F_SETFL, 0);
    Program program = Texgraphc({"wall.json", "-o", "-", "--manifest", "m.json"}, folder.path());
    program.prepare = [&] { dup2(ends[1], STDOUT_FILENO); };
    pid_t self = getpid();
    std::thread killer([&] {
      // The temporary manifest shows that the program has come to its outputs.
      for (int i = 0; i < 20'000; ++i) {
        for (const std::string& name : folder.Names()) {
          size_t dash = name.find('-');
          if (!name.starts_with(".texgraph-")) continue;
          pid_t child = std::stoi(name.substr(dash + 1));
          if (child != self) kill(child, number);
          return;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
    });
    Outcome outcome = program.Run();
    killer.join();
    close(ends[0]);
    close(ends[1]);
    EXPECT_EQ(outcome.exit_code, 128 + number);
    EXPECT_THAT(folder.Names(), ElementsAre("pipe", "wall.json", "x.frag"));
  }
}

TEST_F(Environment, EightRunsToOneFile) {
  std::string expected = Texgraphc({"wall.json", "-o", "-"}, folder.path()).Run().out;
  std::vector<std::thread> runs;
  for (int i = 0; i < 8; ++i) {
    runs.emplace_back([&] {
      EXPECT_EQ(Texgraphc({"wall.json", "-o", "y.frag"}, folder.path()).Run().exit_code, 0);
    });
  }
  for (std::thread& run : runs) run.join();
  EXPECT_EQ(folder.Read("y.frag"), expected);
  EXPECT_THAT(folder.Names(), ElementsAre("wall.json", "x.frag", "y.frag", "y.json"));
}

}  // namespace
}  // namespace texgraph
