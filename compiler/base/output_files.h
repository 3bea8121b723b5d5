// SPDX-License-Identifier: Apache-2.0
// Writing all outputs of a run or none: each goes to a temporary file beside its place, and only
// when every byte of every file is written and every error was looked at are they renamed, one
// after the other; if a rename fails, those before it are taken back (where the file system can
// exchange two files). A signal that ends the program removes the temporary files first.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/base/diagnostics.h"

namespace texgraph {

class OutputFiles {
 public:
  OutputFiles();
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;
  ~OutputFiles();

  // "-" is standard output. A symbolic link is followed; a device or a pipe (/dev/null) is written
  // to directly; the permissions of a file that is there are kept, those of a new one follow the
  // umask.
  void Add(std::string path, std::string bytes);
  // The same for many files that are made one after the other: the temporary file is written at
  // once and no bytes are kept (but those for standard output or a device). False, with
  // kCannotWrite reported, if it could not be; Commit is then not to be called.
  bool Stage(std::string path, std::string bytes, Diagnostics& diagnostics);

  // False, with kCannotWrite reported, if anything could not be written: then no file at any of the
  // paths has changed. (What went to standard output or to a device cannot be taken back; they are
  // written before the renames.)
  bool Commit(Diagnostics& diagnostics);

 private:
  struct File;
  std::vector<std::unique_ptr<File>> files_;
};

// Writes all of `bytes` to an open descriptor; returns 0 or the error number.
int WriteAll(int descriptor, std::string_view bytes);

// Ends the program at once, the temporary files removed; for failures that cannot be reported
// through Diagnostics.
[[noreturn]] void EndProcess(int exit_code);

// For the first lines of main(). Descriptors 0 to 2 that are closed are filled, so that no file is
// opened in their place; writing to them still fails. A closed pipe and a reached file-size limit
// become write errors. SIGINT, SIGTERM and SIGHUP remove the temporary files and end the program
// with 128 plus the signal's number, but never between two renames.
void PrepareProcess();

}  // namespace texgraph
