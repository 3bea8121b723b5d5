// SPDX-License-Identifier: Apache-2.0
// OSMesa, Mesa's software renderer without EGL. Mesa 25.1 dropped it, so its header is not used and
// it is loaded by name.
#include <dlfcn.h>
#include <fmt/format.h>

#include <array>

#include "runtime/gl_context.h"

namespace texgraph::runtime {
namespace {

using OsmesaContext = struct osmesa_context*;
using CreateContextAttribs = OsmesaContext (*)(const int* attributes, OsmesaContext share);
using MakeCurrent = GLboolean (*)(OsmesaContext, void* buffer, GLenum type, GLsizei width,
                                  GLsizei height);
using GetProcAddress = void (*(*)(const char* name))();

constexpr int kFormat = 0x22;
constexpr int kProfile = 0x33;
constexpr int kCoreProfile = 0x34;
constexpr int kMajorVersion = 0x36;
constexpr int kMinorVersion = 0x37;

void* Load(const std::string& name, std::string& why_not) {
  if (!name.empty()) {
    if (void* library = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL)) return library;
  } else {
    for (const char* version : {"libOSMesa.so.8", "libOSMesa.so.6"}) {
      if (void* library = dlopen(version, RTLD_NOW | RTLD_LOCAL)) return library;
    }
  }
  why_not = fmt::format("OSMesa cannot be loaded ({})", dlerror());
  return nullptr;
}

}  // namespace

std::unique_ptr<GlContext> OpenOsmesa(const std::string& name, std::string& why_not) {
  void* library = Load(name, why_not);
  if (library == nullptr) return nullptr;
  const auto create =
      reinterpret_cast<CreateContextAttribs>(dlsym(library, "OSMesaCreateContextAttribs"));
  const auto make_current = reinterpret_cast<MakeCurrent>(dlsym(library, "OSMesaMakeCurrent"));
  const auto get_address = reinterpret_cast<GetProcAddress>(dlsym(library, "OSMesaGetProcAddress"));
  if (create == nullptr || make_current == nullptr || get_address == nullptr) {
    why_not = "OSMesa is too old: it has no core profile";
    return nullptr;
  }
  // OSMesa insists on a window's buffer; everything is drawn into framebuffer objects.
  static std::array<uint8_t, 16 * 16 * 4> buffer;
  static constexpr int kVersions[][2] = {{4, 5}, {3, 3}};
  for (const auto& version : kVersions) {
    const int attributes[] = {kFormat,       GL_RGBA,       kProfile,
                              kCoreProfile,  kMajorVersion, version[0],
                              kMinorVersion, version[1],    0};
    OsmesaContext handle = create(attributes, nullptr);
    if (handle == nullptr || !make_current(handle, buffer.data(), GL_UNSIGNED_BYTE, 16, 16))
      continue;
    auto context = std::make_unique<GlContext>();
    auto lookup = [get_address](const char* function) {
      return reinterpret_cast<void*>(get_address(function));
    };
    if (!FinishContext(*context, "OSMesa", lookup, why_not)) return nullptr;
    return context;
  }
  why_not = "OSMesa gives no OpenGL 3.3 core context";
  return nullptr;
}

}  // namespace texgraph::runtime
