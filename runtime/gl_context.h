// SPDX-License-Identifier: Apache-2.0
// A headless OpenGL context of version 3.3 core or later, current on the thread that opened it.
// Drivers crash and hang: only the child process of render.h opens one. A context is never closed;
// its process ends.
#pragma once

#include <memory>
#include <string>

#include "runtime/gl_functions.h"

namespace texgraph::runtime {

enum class ContextChoice : uint8_t { kAuto, kEgl, kOsmesa };

struct ContextOptions {
  ContextChoice choice = ContextChoice::kAuto;  // EGL first, OSMesa second
  std::string egl_library = "libEGL.so.1";
  std::string osmesa_library;  // "": libOSMesa.so.8, then libOSMesa.so.6
};

struct GlContext {
  GlFunctions gl;
  int version = 0;  // 45: OpenGL 4.5
  // "EGL (surfaceless): OpenGL 4.5 (Core Profile) Mesa 22.3.6, llvmpipe (LLVM 15.0.6, 256 bits)"
  std::string description;
};

// Null, with the reason in `why_not`, if there is none. With kAuto, `why_not` may be filled beside
// a context: it then says why EGL was not used.
std::unique_ptr<GlContext> OpenContext(const ContextOptions& options, std::string& why_not);

// The two ways.
std::unique_ptr<GlContext> OpenEgl(const std::string& library, std::string& why_not);
std::unique_ptr<GlContext> OpenOsmesa(const std::string& library, std::string& why_not);

// After the context was made current: fills the table by `lookup` and checks the version; false
// with a reason if it won't do.
bool FinishContext(GlContext& context, const std::string& way,
                   const std::function<void*(const char*)>& lookup, std::string& why_not);

}  // namespace texgraph::runtime
