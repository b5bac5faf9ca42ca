// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <dlfcn.h>
#include <string>
#include <thread>
#include <type_traits>

namespace ogive {

/// The functions of XCB that the question needs. They are looked up at run time, so that a program without pictures
/// does not depend on X; XCB and not Xlib, because Xlib ends the program when a connection breaks.
struct Xcb {
  /// xcb_query_extension_cookie_t
  struct Cookie {
    unsigned sequence; ///< number of the question
  };
  /// xcb_query_extension_reply_t
  struct Extension {
    std::uint8_t response_type, pad;                              ///< not used here
    std::uint16_t sequence;                                       ///< not used here
    std::uint32_t length;                                         ///< not used here
    std::uint8_t present, major_opcode, first_event, first_error; ///< present: not 0 if the server has it
  };
  /// xcb_connect
  void *(*connect)(const char *, int *) = nullptr;
  /// xcb_connection_has_error
  int (*has_error)(void *) = nullptr;
  /// xcb_disconnect
  void (*disconnect)(void *) = nullptr;
  /// xcb_query_extension
  Cookie (*ask)(void *, std::uint16_t, const char *) = nullptr;
  /// xcb_query_extension_reply
  Extension *(*answer)(void *, Cookie, void **) = nullptr;

  /// True if all functions were found.
  bool complete() const { return connect && has_error && disconnect && ask && answer; }
};

/// XCB as installed; incomplete if it is not.
inline Xcb load_xcb() {
  Xcb xcb;
  void *library = ::dlopen("libxcb.so.1", RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) return xcb;
  const auto look_up = [&](auto &function, const char *name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(::dlsym(library, name));
  };
  look_up(xcb.connect, "xcb_connect");
  look_up(xcb.has_error, "xcb_connection_has_error");
  look_up(xcb.disconnect, "xcb_disconnect");
  look_up(xcb.ask, "xcb_query_extension");
  look_up(xcb.answer, "xcb_query_extension_reply");
  return xcb;
}

/// A connection to the X server `name` if that answers and knows GLX, otherwise null.
inline void *connect_with_glx(const Xcb &xcb, const std::string &name) {
  void *connection = xcb.connect(name.c_str(), nullptr);
  bool glx = false;
  if (xcb.has_error(connection) == 0) {
    void *error = nullptr;
    Xcb::Extension *answer = xcb.answer(connection, xcb.ask(connection, 3, "GLX"), &error);
    glx = answer != nullptr && answer->present != 0;
    std::free(answer);
    std::free(error);
  }
  if (glx) return connection;
  xcb.disconnect(connection);
  return nullptr;
}

/// Whether VTK can draw: DISPLAY names an X server that answers and knows GLX. VTK crashes where this is false. Not to
/// be called by two threads at once. Link with the library of dlopen.
inline bool display_available() {
  const char *variable = std::getenv("DISPLAY");
  const std::string name = variable ? variable : "";
  static const Xcb xcb = load_xcb();
  if (name.empty() || !xcb.complete()) return false;
  // One connection stays open until the program ends: an X server that has lost its last client starts afresh and
  // refuses connections meanwhile, those that VTK is about to make included.
  static std::string held_name;
  static void *held = nullptr;
  if (held && held_name == name && xcb.has_error(held) == 0) return true;
  // Another program may have been the last client just now.
  for (int attempt = 0; attempt < 5; ++attempt) {
    if (attempt > 0) std::this_thread::sleep_for(std::chrono::milliseconds(50));
    void *connection = connect_with_glx(xcb, name);
    if (connection == nullptr) continue;
    if (held) xcb.disconnect(held);
    held = connection;
    held_name = name;
    return true;
  }
  return false;
}

} // namespace ogive
