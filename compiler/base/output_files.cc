// SPDX-License-Identifier: Apache-2.0
#include "compiler/base/output_files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstring>
#include <utility>

#include "compiler/base/files.h"

namespace texgraph {
namespace {

// The temporary files that exist, for the signal handler: it may only read atomics and call unlink.
constexpr size_t kMaxTemporaries = 10240;
std::array<std::atomic<char*>, kMaxTemporaries> temporaries;
std::atomic<int> renaming{0};        // threads that are between their first and last rename
std::atomic<int> pending_signal{0};  // arrived meanwhile
static_assert(std::atomic<char*>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

void EndBySignal(int signal_number) { EndProcess(128 + signal_number); }

void OnSignal(int signal_number) {
  pending_signal.store(signal_number);
  if (renaming.load() == 0) EndBySignal(signal_number);
}

// While one lives, signals wait. Either the handler sees the count or the constructor sees the
// signal, never neither.
class Renaming {
 public:
  Renaming() {
    renaming.fetch_add(1);
    if (int signal_number = pending_signal.load()) EndBySignal(signal_number);
  }
  ~Renaming() {
    if (renaming.fetch_sub(1) == 1 && pending_signal.load() != 0)
      EndBySignal(pending_signal.load());
  }
};

}  // namespace

// Not unnamed, since OutputFiles::File holds them.
namespace output_files {

// A file beside `target`, removed again unless it was renamed.
class Temporary {
 public:
  Temporary() = default;
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  // Returns 0 or an error number. `mode` as for open().
  int Create(const std::string& target, mode_t mode) {
    static std::atomic<unsigned> counter{0};
    for (int tries = 0; tries < 100; ++tries) {
      Register(JoinPath(FolderOf(target),
                        fmt::format(".texgraph-{}-{}.tmp", getpid(), counter.fetch_add(1))));
      descriptor_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
      if (descriptor_ >= 0) return 0;
      int error = errno;
      Forget();
      if (error != EEXIST) return error;
    }
    return EEXIST;
  }

  int Write(std::string_view bytes) {
    int error = WriteAll(descriptor_, bytes);
    // A network or quota error may show first at close.
    if (close(std::exchange(descriptor_, -1)) != 0 && error == 0) error = errno;
    return error;
  }

  int descriptor() const { return descriptor_; }
  const std::string& path() const { return path_; }
  void Remove() {
    if (descriptor_ >= 0) close(std::exchange(descriptor_, -1));
    if (!path_.empty()) unlink(path_.c_str());
    Forget();
  }
  // It is under its final name now.
  void Forget() {
    if (slot_ != nullptr) slot_->store(nullptr);
    slot_ = nullptr;
    path_.clear();
  }

 private:
  void Register(std::string path) {
    path_ = std::move(path);
    for (std::atomic<char*>& slot : temporaries) {
      char* expected = nullptr;
      if (slot.compare_exchange_strong(expected, path_.data())) {
        slot_ = &slot;
        return;
      }
    }
  }

  std::string path_;
  int descriptor_ = -1;
  std::atomic<char*>* slot_ = nullptr;
};

// One output on its way.
struct Step {
  std::string target;   // after symbolic links
  bool direct = false;  // standard output, a device or a pipe
  bool exists = false;  // a file to replace
  mode_t mode = 0666;
  Temporary temporary;
  enum class State { kWaiting, kExchanged, kCreated, kReplaced } state = State::kWaiting;
};

}  // namespace output_files

namespace {

using output_files::Step;

// Where `path` leads, also if the last link points to nothing yet.
int FollowLinks(std::string path, std::string& target) {
  for (int links = 0; links < 40; ++links) {
    char buffer[PATH_MAX];
    ssize_t length = readlink(path.c_str(), buffer, sizeof buffer);
    if (length < 0) {
      target = std::move(path);
      return errno == EINVAL || errno == ENOENT ? 0 : errno;
    }
    if (length == static_cast<ssize_t>(sizeof buffer)) return ENAMETOOLONG;
    path = JoinPath(FolderOf(path), std::string_view(buffer, static_cast<size_t>(length)));
  }
  return ELOOP;
}

// Finds out what is at `path`; returns 0 or an error number.
int Examine(const std::string& path, Step& step) {
  if (path == "-") {
    step.direct = true;
    return 0;
  }
  if (path.empty()) return ENOENT;
  if (path.find('\0') != std::string::npos) return EINVAL;
  struct stat status;
  if (stat(path.c_str(), &status) == 0) {
    if (S_ISDIR(status.st_mode)) return EISDIR;
    if (!S_ISREG(status.st_mode)) {
      step.target = path;
      step.direct = true;
      return 0;
    }
    // A rename would get around the write protection of the file itself.
    if (access(path.c_str(), W_OK) != 0) return errno;
    step.exists = true;
    step.mode = status.st_mode & 0777;
  } else if (errno != ENOENT) {
    return errno;
  }
  return FollowLinks(path, step.target);
}

int WriteTemporary(Step& step, const std::string& bytes) {
  if (int error = step.temporary.Create(step.target, step.exists ? 0600 : 0666)) return error;
  if (step.exists && fchmod(step.temporary.descriptor(), step.mode) != 0) return errno;
  return step.temporary.Write(bytes);
}

int WriteDirectly(const std::string& path, const Step& step, const std::string& bytes) {
  if (path == "-") return WriteAll(STDOUT_FILENO, bytes);
  // Non-blocking for the open alone: a pipe without a reader is an error, not a wait.
  int descriptor = open(step.target.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
  if (descriptor < 0) return errno;
  fcntl(descriptor, F_SETFL, 0);
  int error = WriteAll(descriptor, bytes);
  if (close(descriptor) != 0 && error == 0) error = errno;
  return error;
}

int PutInPlace(Step& step) {
  const char* from = step.temporary.path().c_str();
  const char* to = step.target.c_str();
  // An exchange keeps the old file under the temporary name, so that it can be put back.
  if (step.exists && renameat2(AT_FDCWD, from, AT_FDCWD, to, RENAME_EXCHANGE) == 0) {
    step.state = Step::State::kExchanged;
    return 0;
  }
  if (rename(from, to) != 0) return errno;
  step.state = step.exists ? Step::State::kReplaced : Step::State::kCreated;
  return 0;
}

void PutBack(Step& step) {
  const char* from = step.temporary.path().c_str();
  if (step.state == Step::State::kExchanged) {
    renameat2(AT_FDCWD, from, AT_FDCWD, step.target.c_str(), RENAME_EXCHANGE);
  } else if (step.state == Step::State::kCreated) {
    rename(step.target.c_str(), from);
  }
}

void ReportFailure(const std::string& path, int error, Diagnostics& diagnostics) {
  std::string shown = path == "-" ? "standard output" : fmt::format("'{}'", Printable(path));
  diagnostics.Error(DiagnosticKind::kCannotWrite, {},
                    fmt::format("cannot write {}: {}", shown,
                                error == EISDIR ? "it is a folder" : ErrorText(error)));
}

}  // namespace

struct OutputFiles::File {
  std::string path;
  std::string bytes;
  bool is_staged = false;
  Step step;
};

OutputFiles::OutputFiles() = default;

OutputFiles::~OutputFiles() {
  for (auto& file : files_) file->step.temporary.Remove();
}

void OutputFiles::Add(std::string path, std::string bytes) {
  File& file = *files_.emplace_back(std::make_unique<File>());
  file.path = std::move(path);
  file.bytes = std::move(bytes);
}

bool OutputFiles::Stage(std::string path, std::string bytes, Diagnostics& diagnostics) {
  Add(std::move(path), std::move(bytes));
  File& file = *files_.back();
  int error = Examine(file.path, file.step);
  if (error == 0 && !file.step.direct) {
    error = WriteTemporary(file.step, file.bytes);
    file.bytes = std::string();
  }
  file.is_staged = true;
  if (error != 0) ReportFailure(file.path, error, diagnostics);
  return error == 0;
}

bool OutputFiles::Commit(Diagnostics& diagnostics) {
  auto fail = [&](const File& failed, int error) {
    for (auto& file : files_) file->step.temporary.Remove();
    ReportFailure(failed.path, error, diagnostics);
    return false;
  };
  for (auto& file : files_) {
    if (file->is_staged) continue;
    if (int error = Examine(file->path, file->step)) return fail(*file, error);
  }
  for (auto& file : files_) {
    if (file->step.direct || file->is_staged) continue;
    if (int error = WriteTemporary(file->step, file->bytes)) return fail(*file, error);
  }
  for (auto& file : files_) {
    if (!file->step.direct) continue;
    if (int error = WriteDirectly(file->path, file->step, file->bytes)) return fail(*file, error);
  }
  Renaming guard;
  for (size_t i = 0; i < files_.size(); ++i) {
    if (files_[i]->step.direct) continue;
    if (int error = PutInPlace(files_[i]->step)) {
      for (size_t done = i; done-- > 0;) PutBack(files_[done]->step);
      return fail(*files_[i], error);
    }
  }
  for (auto& file : files_) {
    file->step.state == Step::State::kExchanged ? file->step.temporary.Remove()
                                                : file->step.temporary.Forget();
  }
  files_.clear();
  return true;
}

void EndProcess(int exit_code) {
  for (std::atomic<char*>& slot : temporaries) {
    if (char* path = slot.load()) unlink(path);
  }
  _exit(exit_code);
}

int WriteAll(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    ssize_t written = write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes.remove_prefix(static_cast<size_t>(written));
  }
  return 0;
}

void PrepareProcess() {
  for (int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(descriptor, F_GETFD) >= 0 || errno != EBADF) continue;
    // The wrong direction on purpose: using it must stay an error. The lowest free number is this
    // one.
    (void)open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
  signal(SIGPIPE, SIG_IGN);
  signal(SIGXFSZ, SIG_IGN);
  struct sigaction action = {};
  action.sa_handler = OnSignal;
  sigemptyset(&action.sa_mask);
  for (int number : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction old;
    bool ignored = sigaction(number, nullptr, &old) == 0 && old.sa_handler == SIG_IGN;
    if (!ignored) sigaction(number, &action, nullptr);  // nohup stays nohup
  }
}

}  // namespace texgraph
