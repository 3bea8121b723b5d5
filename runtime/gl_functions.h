// SPDX-License-Identifier: Apache-2.0
// The OpenGL functions of one context, looked up by that context's own loader. A function that
// another loader gave may exist and do nothing, so there is one table a context and no global one.
#pragma once

#include <GL/glcorearb.h>

#include <functional>
#include <string>

namespace texgraph::runtime {

struct GlFunctions {
#define GL_FUNCTION(name, type) type name = nullptr;
#include "runtime/gl_functions.def"
#undef GL_FUNCTION

  // Fills the table. Returns the name of the first function that is missing, or "".
  std::string Load(const std::function<void*(const char*)>& lookup);
};

// "GL_OUT_OF_MEMORY"
std::string GlErrorName(GLenum error);

}  // namespace texgraph::runtime
