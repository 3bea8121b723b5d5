// SPDX-License-Identifier: Apache-2.0
// Textures as KTX 2.0 files, with all their levels and uncompressed: what engines read. The files
// that are read may come from strangers: everything is checked before it is used.
// Khronos, KTX File Format Specification 2.0; Khronos Data Format Specification 1.3.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "compiler/base/diagnostics.h"
#include "compiler/base/roots.h"
#include "compiler/textures/texels.h"

namespace texgraph::textures {

// The same texture gives the same bytes, on every machine. The state of the sampler is not in them;
// row 0 stays v = 0, and the file says so (KTXorientation).
std::string EncodeKtx2(const TextureData& data);

// What EncodeKtx2 writes, and what others write of these formats: 2D, arrays and 3D, uncompressed.
// Rows that run downwards are turned. The sampler is the default one, without mip levels if the
// file has one level. Reported, naming `name`: kBadImage, kSizeLimit, kOutOfMemory.
std::optional<TextureData> DecodeKtx2(std::string_view bytes, std::string_view name,
                                      SourceRange range, Diagnostics& diagnostics);

// The file at `path`; all of DecodeKtx2, and kMissingFile, kOutsideRoot, kCannotRead.
std::optional<TextureData> ReadKtx2(const std::string& path, SourceRange range,
                                    Diagnostics& diagnostics, const Roots& roots = {});

}  // namespace texgraph::textures
