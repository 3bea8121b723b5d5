// SPDX-License-Identifier: Apache-2.0
// Reading files that strangers may have named: only regular files, never more than a stated size,
// never waiting for a pipe or a device. Every failure is one diagnostic.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "compiler/base/diagnostics.h"

namespace texgraph {

// The bytes of the regular file at `path`. Reports kCannotRead if it cannot be opened or is a
// folder, a pipe or a device, and kSizeLimit if it is longer than `limit`. `place` is where the
// file was named; no source: on the command line.
std::optional<std::string> ReadFile(const std::string& path, size_t limit, SourceRange place,
                                    Diagnostics& diagnostics);

// The same for standard input, which may be anything.
std::optional<std::string> ReadStandardInput(size_t limit, Diagnostics& diagnostics);

// Whether both paths lead to one existing file.
bool SameFile(const std::string& a, const std::string& b);
// "a/b.json" -> "a" ("" if there is no slash) and "b.json". The root's folder is "/".
std::string_view FolderOf(std::string_view path);
std::string_view FileNameOf(std::string_view path);
// `name` in `folder`: joined by a slash, or `name` alone if it is absolute or the folder is "".
std::string JoinPath(std::string_view folder, std::string_view name);

// From the root, without ".", ".." and double slashes; as text alone, links are not followed. "" is
// the current folder.
std::string AbsolutePath(std::string_view path);
// How `path` is written from `folder`, also as text alone: "../images/a.png", "." for the folder
// itself.
std::string RelativePath(std::string_view path, std::string_view folder);

// "no such file or directory": lower case, the same in every locale.
std::string ErrorText(int error_number);

}  // namespace texgraph
