// What a connection to an X server beside GLFW's is held by.
#pragma once

#include <cstdlib>
#include <memory>

#include <xcb/xcb.h>

namespace ghostforce {

struct XcbDisconnect {
  void operator()(xcb_connection_t* connection) const noexcept { xcb_disconnect(connection); }
};
using XcbConnection = std::unique_ptr<xcb_connection_t, XcbDisconnect>;

// libxcb gives away what malloc() made.
struct XcbFree {
  void operator()(void* memory) const noexcept { std::free(memory); }
};
template <typename Type>
using FromXcb = std::unique_ptr<Type, XcbFree>;

}  // namespace ghostforce
