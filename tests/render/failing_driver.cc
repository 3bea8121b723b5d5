// SPDX-License-Identifier: Apache-2.0
// An EGL library that fails in one way, FAULT, and otherwise passes everything on to the real one.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/glcorearb.h>
#include <dlfcn.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>

#define CRASH_AT_OPENING 1
#define HANG_AT_OPENING 2
#define GREEDY_AT_OPENING 3
#define CRASH_AT_DRAWING 4
#define HANG_AT_DRAWING 5
#define SILENT 6
#define INCOMPLETE 7
#define OUT_OF_MEMORY 8

namespace {

void* Real(const char* name) {
  static void* const library = dlopen(REAL_EGL, RTLD_NOW | RTLD_LOCAL);
  return library ? dlsym(library, name) : nullptr;
}

template <class T>
T RealAs(const char* name) {
  return reinterpret_cast<T>(Real(name));
}

[[noreturn]] void Crash() {
  fprintf(stderr, "the driver's last words\n");
  fflush(stderr);
  *reinterpret_cast<volatile int*>(4) = 0;
  abort();
}

[[noreturn]] void Hang() {
  for (;;) pause();
}

// Takes 16 MiB at a time, and uses them, until there is no more.
[[noreturn]] void TakeEverything() {
  constexpr size_t kStep = size_t{16} << 20;
  for (size_t taken = 0; taken < size_t{64} << 30; taken += kStep) {
    void* memory = malloc(kStep);
    if (memory == nullptr) abort();
    memset(memory, 1, kStep);
  }
  Hang();
}

EGLDisplay EGLAPIENTRY GetPlatformDisplay(EGLenum platform, void* display,
                                          const EGLint* attributes) {
  if (FAULT == CRASH_AT_OPENING) Crash();
  if (FAULT == HANG_AT_OPENING) Hang();
  if (FAULT == GREEDY_AT_OPENING) TakeEverything();
  const auto get = RealAs<decltype(&eglGetProcAddress)>("eglGetProcAddress");
  const auto real =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(get("eglGetPlatformDisplayEXT"));
  return real(platform, display, attributes);
}

void APIENTRY CrashAtDrawing(GLenum, GLint, GLsizei) { Crash(); }
void APIENTRY HangAtDrawing(GLenum, GLint, GLsizei) { Hang(); }
const GLubyte* APIENTRY SayNothing(GLenum) { return nullptr; }
GLenum APIENTRY SayOutOfMemory() {
  static int calls = 0;
  return calls++ == 1 ? GL_OUT_OF_MEMORY : GL_NO_ERROR;
}

}  // namespace

extern "C" {

__eglMustCastToProperFunctionPointerType eglGetProcAddress(const char* name) {
  using Function = __eglMustCastToProperFunctionPointerType;
  if (strcmp(name, "eglGetPlatformDisplayEXT") == 0)
    return reinterpret_cast<Function>(&GetPlatformDisplay);
  if (strcmp(name, "glDrawArrays") == 0) {
    if (FAULT == CRASH_AT_DRAWING) return reinterpret_cast<Function>(&CrashAtDrawing);
    if (FAULT == HANG_AT_DRAWING) return reinterpret_cast<Function>(&HangAtDrawing);
  }
  if (FAULT == SILENT && strcmp(name, "glGetString") == 0)
    return reinterpret_cast<Function>(&SayNothing);
  if (FAULT == INCOMPLETE && strcmp(name, "glGetFragDataLocation") == 0) return nullptr;
  if (FAULT == OUT_OF_MEMORY && strcmp(name, "glGetError") == 0) {
    return reinterpret_cast<Function>(&SayOutOfMemory);
  }
  return RealAs<decltype(&eglGetProcAddress)>("eglGetProcAddress")(name);
}

EGLint eglGetError() { return RealAs<decltype(&eglGetError)>("eglGetError")(); }
EGLBoolean eglInitialize(EGLDisplay display, EGLint* major, EGLint* minor) {
  return RealAs<decltype(&eglInitialize)>("eglInitialize")(display, major, minor);
}
EGLBoolean eglBindAPI(EGLenum api) { return RealAs<decltype(&eglBindAPI)>("eglBindAPI")(api); }
EGLContext eglCreateContext(EGLDisplay display, EGLConfig config, EGLContext share,
                            const EGLint* attributes) {
  return RealAs<decltype(&eglCreateContext)>("eglCreateContext")(display, config, share,
                                                                 attributes);
}
EGLBoolean eglDestroyContext(EGLDisplay display, EGLContext context) {
  return RealAs<decltype(&eglDestroyContext)>("eglDestroyContext")(display, context);
}
EGLBoolean eglMakeCurrent(EGLDisplay display, EGLSurface draw, EGLSurface read,
                          EGLContext context) {
  return RealAs<decltype(&eglMakeCurrent)>("eglMakeCurrent")(display, draw, read, context);
}
EGLBoolean eglTerminate(EGLDisplay display) {
  return RealAs<decltype(&eglTerminate)>("eglTerminate")(display);
}

}  // extern "C"
