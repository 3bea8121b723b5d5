// SPDX-License-Identifier: Apache-2.0
#include "compiler/base/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstring>
#include <vector>

namespace texgraph {
namespace {

constexpr size_t kChunk = 64u << 10;

// Reads `fd` to its end. Returns 0, an error number, or EFBIG if there is more than `limit`.
int ReadToEnd(int fd, size_t limit, size_t expected, std::string& out) {
  size_t size = 0;
  out.resize(std::min(expected, limit) + 1);
  while (true) {
    if (size == out.size()) out.resize(std::min(out.size() * 2 + kChunk, limit + 1));
    ssize_t got = read(fd, out.data() + size, out.size() - size);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0 && errno == EAGAIN) {  // standard input may have been left non-blocking
      pollfd wait = {fd, POLLIN, 0};
      poll(&wait, 1, -1);
      continue;
    }
    if (got < 0) return errno;
    if (got == 0) break;
    size += static_cast<size_t>(got);
    if (size > limit) return EFBIG;
  }
  out.resize(size);
  return 0;
}

std::string_view KindOf(mode_t mode) {
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

void ReportUnread(std::string_view shown, std::string_view reason, SourceRange place,
                  Diagnostics& diagnostics) {
  diagnostics.Error(DiagnosticKind::kCannotRead, place,
                    fmt::format("cannot read {}: {}", shown, reason));
}

std::optional<std::string> ReadDescriptor(int fd, size_t limit, size_t expected,
                                          std::string_view shown, SourceRange place,
                                          Diagnostics& diagnostics) {
  std::string text;
  int error = expected > limit ? EFBIG : ReadToEnd(fd, limit, expected, text);
  if (error == 0) return text;
  if (error == EFBIG) {
    diagnostics.Error(DiagnosticKind::kSizeLimit, place,
                      fmt::format("{} is longer than the limit of {} bytes", shown, limit));
  } else {
    ReportUnread(shown, ErrorText(error), place, diagnostics);
  }
  return std::nullopt;
}

// The names on the way from the root; ".." beyond it stays there.
std::vector<std::string_view> Parts(std::string_view absolute) {
  std::vector<std::string_view> parts;
  while (!absolute.empty()) {
    size_t slash = std::min(absolute.find('/'), absolute.size());
    std::string_view part = absolute.substr(0, slash);
    if (part == "..") {
      if (!parts.empty()) parts.pop_back();
    } else if (!part.empty() && part != ".") {
      parts.push_back(part);
    }
    absolute.remove_prefix(std::min(slash + 1, absolute.size()));
  }
  return parts;
}

std::string Quoted(std::string_view path) { return fmt::format("'{}'", Printable(path)); }

}  // namespace

std::optional<std::string> ReadFile(const std::string& path, size_t limit, SourceRange place,
                                    Diagnostics& diagnostics) {
  if (path.find('\0') != std::string::npos) {
    ReportUnread(Quoted(path), "the path has a zero byte", place, diagnostics);
    return std::nullopt;
  }
  // Non-blocking: opening a pipe that nobody writes to must not wait. It changes nothing for
  // regular files.
  int fd = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  struct stat status;
  if (fd < 0 || fstat(fd, &status) != 0) {
    int error = errno;
    if (fd >= 0) close(fd);
    ReportUnread(Quoted(path), ErrorText(error), place, diagnostics);
    return std::nullopt;
  }
  std::optional<std::string> text;
  if (S_ISREG(status.st_mode)) {
    text = ReadDescriptor(fd, limit, static_cast<size_t>(status.st_size), Quoted(path), place,
                          diagnostics);
  } else {
    ReportUnread(Quoted(path), fmt::format("it is {}, not a regular file", KindOf(status.st_mode)),
                 place, diagnostics);
  }
  close(fd);
  return text;
}

std::optional<std::string> ReadStandardInput(size_t limit, Diagnostics& diagnostics) {
  return ReadDescriptor(STDIN_FILENO, limit, 0, "standard input", {}, diagnostics);
}

bool SameFile(const std::string& a, const std::string& b) {
  struct stat first, second;
  return stat(a.c_str(), &first) == 0 && stat(b.c_str(), &second) == 0 &&
         first.st_dev == second.st_dev && first.st_ino == second.st_ino;
}

std::string_view FolderOf(std::string_view path) {
  size_t slash = path.rfind('/');
  if (slash == std::string_view::npos) return {};
  return path.substr(0, std::max<size_t>(slash, 1));
}

std::string_view FileNameOf(std::string_view path) { return path.substr(path.rfind('/') + 1); }

std::string JoinPath(std::string_view folder, std::string_view name) {
  if (folder.empty() || name.starts_with('/')) return std::string(name);
  return fmt::format("{}{}{}", folder, folder.ends_with('/') ? "" : "/", name);
}

std::string AbsolutePath(std::string_view path) {
  std::string full(path);
  if (!path.starts_with('/')) {
    char buffer[PATH_MAX];
    const char* here = getcwd(buffer, sizeof buffer);
    full = fmt::format("{}/{}", here != nullptr ? here : "", path);
  }
  std::string out;
  for (std::string_view part : Parts(full)) out.append("/").append(part);
  return out.empty() ? "/" : out;
}

std::string RelativePath(std::string_view path, std::string_view folder) {
  std::string absolute_path = AbsolutePath(path), absolute_folder = AbsolutePath(folder);
  std::vector<std::string_view> to = Parts(absolute_path), from = Parts(absolute_folder);
  size_t common = 0;
  while (common < std::min(to.size(), from.size()) && to[common] == from[common]) ++common;
  std::string out;
  auto append = [&](std::string_view part) { out.append(out.empty() ? "" : "/").append(part); };
  for (size_t i = common; i < from.size(); ++i) append("..");
  for (size_t i = common; i < to.size(); ++i) append(to[i]);
  return out.empty() ? "." : out;
}

std::string ErrorText(int error_number) {
  const char* text = strerrordesc_np(error_number);
  if (text == nullptr) return fmt::format("error {}", error_number);
  std::string out = text;
  bool acronym = out.size() > 1 && out[1] >= 'A' && out[1] <= 'Z';
  if (!acronym && out[0] >= 'A' && out[0] <= 'Z') out[0] = static_cast<char>(out[0] - 'A' + 'a');
  return out;
}

}  // namespace texgraph
