// SPDX-License-Identifier: Apache-2.0
#include "runtime/gl_functions.h"

#include <fmt/format.h>

namespace texgraph::runtime {

std::string GlFunctions::Load(const std::function<void*(const char*)>& lookup) {
  struct Entry {
    const char* name;
    void** slot;
  };
  const Entry entries[] = {
#define GL_FUNCTION(name, type) {"gl" #name, reinterpret_cast<void**>(&name)},
#include "runtime/gl_functions.def"
#undef GL_FUNCTION
  };
  for (const Entry& entry : entries) {
    *entry.slot = lookup(entry.name);
    if (*entry.slot == nullptr) return entry.name;
  }
  return "";
}

std::string GlErrorName(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM:
      return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
      return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
      return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
      return "GL_OUT_OF_MEMORY";
    default:
      return fmt::format("GL error 0x{:04x}", error);
  }
}

}  // namespace texgraph::runtime
