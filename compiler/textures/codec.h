// SPDX-License-Identifier: Apache-2.0
// The two decoders behind image.h, and how it opens files. They read from an open file and say in
// words what is wrong with it; both libraries leave their own errors by longjmp, so nothing with a
// destructor lives in the functions that call them.
#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>

#include "compiler/base/diagnostics.h"
#include "compiler/base/roots.h"
#include "compiler/textures/image.h"

namespace texgraph::textures {

struct CloseFile {
  void operator()(FILE* file) const { fclose(file); }
};
using File = std::unique_ptr<FILE, CloseFile>;

// Opens regular files of at most kMaxImageFileBytes only: opening a FIFO or a device could wait for
// ever or change something. Reported: what ReadImage says of files.
File OpenImage(const std::string& path, SourceRange range, const Roots& roots,
               Diagnostics& diagnostics);

struct CodecError {
  DiagnosticKind kind = DiagnosticKind::kBadImage;
  char text[256] = "";
};

// Fills `image`, its pixels only if `header_only` is false. False with a reason in `error`.
bool DecodePng(FILE* file, bool header_only, Image& image, CodecError& error);
bool DecodeJpeg(FILE* file, bool header_only, Image& image, CodecError& error);

// Checks the size in `image` against kMaxImagePixels and, unless `header_only`, allocates the
// pixels.
bool PreparePixels(bool header_only, Image& image, CodecError& error);

}  // namespace texgraph::textures
