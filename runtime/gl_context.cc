// SPDX-License-Identifier: Apache-2.0
#include "runtime/gl_context.h"

#include <fmt/format.h>

namespace texgraph::runtime {

bool FinishContext(GlContext& context, const std::string& way,
                   const std::function<void*(const char*)>& lookup, std::string& why_not) {
  const std::string missing = context.gl.Load(lookup);
  if (!missing.empty()) {
    why_not = fmt::format("{} has no {}", way, missing);
    return false;
  }
  // A table of another library's functions would do nothing and say nothing; a version text proves
  // that it is this context's.
  const auto* version = reinterpret_cast<const char*>(context.gl.GetString(GL_VERSION));
  const auto* renderer = reinterpret_cast<const char*>(context.gl.GetString(GL_RENDERER));
  if (version == nullptr || renderer == nullptr) {
    why_not = fmt::format("{} gave a context that does not answer", way);
    return false;
  }
  GLint major = 0;
  GLint minor = 0;
  context.gl.GetIntegerv(GL_MAJOR_VERSION, &major);
  context.gl.GetIntegerv(GL_MINOR_VERSION, &minor);
  context.version = 10 * major + minor;
  if (context.version < 33) {
    why_not = fmt::format("{} has OpenGL {} only; 3.3 is needed", way, version);
    return false;
  }
  context.description = fmt::format("{}: OpenGL {}, {}", way, version, renderer);
  return true;
}

std::unique_ptr<GlContext> OpenContext(const ContextOptions& options, std::string& why_not) {
  why_not.clear();
  if (options.choice != ContextChoice::kOsmesa) {
    auto context = OpenEgl(options.egl_library, why_not);
    if (context || options.choice == ContextChoice::kEgl) return context;
  }
  std::string why_not_osmesa;
  auto context = OpenOsmesa(options.osmesa_library, why_not_osmesa);
  if (!context) why_not += (why_not.empty() ? "" : "; ") + why_not_osmesa;
  return context;
}

}  // namespace texgraph::runtime
