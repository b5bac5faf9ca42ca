#pragma once

#include <cstdlib>
#include <dlfcn.h>

namespace ogive {

/// Whether VTK can draw: DISPLAY names an X server that answers and knows GLX. VTK crashes where this is false. Link
/// with the library of dlopen.
inline bool display_available() {
  if (const char *name = std::getenv("DISPLAY"); name == nullptr || *name == '\0') return false;
  // Asked at run time, so that a program without pictures does not depend on X.
  void *x11 = ::dlopen("libX11.so.6", RTLD_LAZY | RTLD_LOCAL);
  if (x11 == nullptr) return false;
  using Open = void *(*)(const char *);
  using Query = int (*)(void *, const char *, int *, int *, int *);
  using Close = int (*)(void *);
  const auto open = reinterpret_cast<Open>(::dlsym(x11, "XOpenDisplay"));
  const auto query = reinterpret_cast<Query>(::dlsym(x11, "XQueryExtension"));
  const auto close = reinterpret_cast<Close>(::dlsym(x11, "XCloseDisplay"));
  bool available = false;
  if (void *display = open && query && close ? open(nullptr) : nullptr) {
    int opcode = 0, event = 0, error = 0;
    available = query(display, "GLX", &opcode, &event, &error) != 0;
    close(display);
  }
  ::dlclose(x11);
  return available;
}

} // namespace ogive
