// SPDX-License-Identifier: Apache-2.0
// EGL without a window system: Mesa's surfaceless platform, else the first device that gives a
// context.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>
#include <fmt/format.h>

#include "runtime/gl_context.h"

namespace texgraph::runtime {
namespace {

struct Egl {
  decltype(&eglGetProcAddress) GetProcAddress = nullptr;
  decltype(&eglGetError) GetError = nullptr;
  decltype(&eglInitialize) Initialize = nullptr;
  decltype(&eglBindAPI) BindAPI = nullptr;
  decltype(&eglCreateContext) CreateContext = nullptr;
  decltype(&eglDestroyContext) DestroyContext = nullptr;
  decltype(&eglMakeCurrent) MakeCurrent = nullptr;
  decltype(&eglTerminate) Terminate = nullptr;
  PFNEGLGETPLATFORMDISPLAYEXTPROC GetPlatformDisplay = nullptr;
  PFNEGLQUERYDEVICESEXTPROC QueryDevices = nullptr;  // may be missing
};

template <class T>
bool Symbol(void* library, const char* name, T& function) {
  function = reinterpret_cast<T>(dlsym(library, name));
  return function != nullptr;
}

bool LoadEgl(const std::string& name, Egl& egl, std::string& why_not) {
  void* library = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    why_not = fmt::format("EGL cannot be loaded ({})", dlerror());
    return false;
  }
  const bool complete = Symbol(library, "eglGetProcAddress", egl.GetProcAddress) &&
                        Symbol(library, "eglGetError", egl.GetError) &&
                        Symbol(library, "eglInitialize", egl.Initialize) &&
                        Symbol(library, "eglBindAPI", egl.BindAPI) &&
                        Symbol(library, "eglCreateContext", egl.CreateContext) &&
                        Symbol(library, "eglDestroyContext", egl.DestroyContext) &&
                        Symbol(library, "eglMakeCurrent", egl.MakeCurrent) &&
                        Symbol(library, "eglTerminate", egl.Terminate);
  if (complete) {
    egl.GetPlatformDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        egl.GetProcAddress("eglGetPlatformDisplayEXT"));
    egl.QueryDevices =
        reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(egl.GetProcAddress("eglQueryDevicesEXT"));
  }
  if (complete && egl.GetPlatformDisplay != nullptr) return true;
  why_not = "EGL has no eglGetPlatformDisplayEXT";
  return false;
}

// Makes a context of `display` current; false with a reason.
bool OpenDisplay(const Egl& egl, EGLDisplay display, std::string& why_not) {
  if (display == EGL_NO_DISPLAY || !egl.Initialize(display, nullptr, nullptr)) {
    why_not = fmt::format("no display (0x{:04x})", egl.GetError());
    return false;
  }
  egl.BindAPI(EGL_OPENGL_API);
  static constexpr int kVersions[][2] = {{4, 5}, {3, 3}};
  for (const auto& version : kVersions) {
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 version[0],
                                 EGL_CONTEXT_MINOR_VERSION,
                                 version[1],
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_NONE};
    EGLContext context = egl.CreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (context == EGL_NO_CONTEXT) continue;
    if (egl.MakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) return true;
    egl.DestroyContext(display, context);
  }
  why_not = fmt::format("no OpenGL 3.3 core context (0x{:04x})", egl.GetError());
  egl.Terminate(display);
  return false;
}

bool OpenDevice(const Egl& egl, std::string& why_not) {
  if (egl.QueryDevices == nullptr) return false;
  EGLDeviceEXT devices[16];
  EGLint count = 0;
  if (!egl.QueryDevices(16, devices, &count)) return false;
  for (EGLint i = 0; i < count; ++i) {
    std::string ignored;
    if (OpenDisplay(egl, egl.GetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr),
                    ignored)) {
      return true;
    }
  }
  why_not += fmt::format("; none of {} devices either", count);
  return false;
}

}  // namespace

std::unique_ptr<GlContext> OpenEgl(const std::string& library, std::string& why_not) {
  Egl egl;
  if (!LoadEgl(library, egl, why_not)) return nullptr;
  std::string way = "EGL (surfaceless)";
  std::string reason;
  EGLDisplay surfaceless =
      egl.GetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (!OpenDisplay(egl, surfaceless, reason)) {
    way = "EGL (device)";
    if (!OpenDevice(egl, reason)) {
      why_not = "EGL without a window system gives " + reason;
      return nullptr;
    }
  }
  auto context = std::make_unique<GlContext>();
  auto lookup = [&egl](const char* name) {
    return reinterpret_cast<void*>(egl.GetProcAddress(name));
  };
  if (!FinishContext(*context, way, lookup, why_not)) return nullptr;
  return context;
}

}  // namespace texgraph::runtime
