// SPDX-License-Identifier: Apache-2.0
#include "compiler/base/roots.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string_view>

#include "compiler/base/files.h"

namespace texgraph {
namespace {

struct FreeText {
  void operator()(char* text) const { std::free(text); }
};

std::optional<std::string> RealPath(const std::string& path) {
  std::unique_ptr<char, FreeText> real(realpath(path.c_str(), nullptr));
  if (!real) return std::nullopt;
  return std::string(real.get());
}

}  // namespace

Roots::Roots(const std::vector<std::string>& folders, Diagnostics& diagnostics)
    : limited_(!folders.empty()) {
  for (const std::string& folder : folders) {
    std::optional<std::string> real = RealPath(folder);
    int error = real ? 0 : errno;
    struct stat status;
    if (real && (stat(real->c_str(), &status) != 0 || !S_ISDIR(status.st_mode))) error = ENOTDIR;
    if (error == 0) {
      folders_.push_back(std::move(*real));
      continue;
    }
    diagnostics.Error(
        DiagnosticKind::kCannotRead, {},
        fmt::format("cannot use '{}' as --root: {}", Printable(folder), ErrorText(error)));
  }
}

bool Roots::Contain(const std::string& path) const {
  if (!limited_) return true;
  if (path.find('\0') != std::string::npos) return false;
  if (std::optional<std::string> real = RealPath(path)) return ContainReal(*real);
  // Nothing is there, or a link in a circle. What lies beyond the folders is refused all the same,
  // so that nobody learns from the message whether it exists.
  std::string named(FolderOf(path));
  std::optional<std::string> folder = RealPath(named.empty() ? "." : named);
  return ContainReal(folder ? JoinPath(*folder, FileNameOf(path)) : AbsolutePath(path));
}

bool Roots::ContainFile(int descriptor) const {
  if (!limited_) return true;
  char target[PATH_MAX];
  const std::string link = fmt::format("/proc/self/fd/{}", descriptor);
  ssize_t length = readlink(link.c_str(), target, sizeof target);
  if (length <= 0 || static_cast<size_t>(length) == sizeof target) return false;
  return ContainReal(std::string(target, static_cast<size_t>(length)));
}

bool Roots::ContainReal(const std::string& real_path) const {
  for (const std::string& folder : folders_) {
    if (folder == "/" || real_path == folder) return true;
    if (real_path.starts_with(folder) && real_path[folder.size()] == '/') return true;
  }
  return false;
}

}  // namespace texgraph
