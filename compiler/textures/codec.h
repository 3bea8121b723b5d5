// SPDX-License-Identifier: Apache-2.0
// The two decoders behind image.h. They read from an open file and say in words what is wrong with
// it; both libraries leave their own errors by longjmp, so nothing with a destructor lives in the
// functions that call them.
#pragma once

#include <cstdint>
#include <cstdio>

#include "compiler/base/diagnostics.h"
#include "compiler/textures/image.h"

namespace texgraph::textures {

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
