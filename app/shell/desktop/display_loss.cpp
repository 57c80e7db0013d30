#include "app/shell/desktop/display_loss.h"

#include <dlfcn.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <utility>

#include "app/base/failure.h"
#include "app/base/words.h"

#define GLFW_EXPOSE_NATIVE_WAYLAND
#define GLFW_NATIVE_INCLUDE_NONE  // nothing of Wayland is needed to build
#include <GLFW/glfw3.h>
#include <GLFW/glfw3native.h>

namespace ghostforce {
namespace {

std::function<void()> put_everything_in_order;

std::thread::id ui_thread;
std::atomic<DisplayLoss> lost = DisplayLoss::none;  // as another thread has found out

using ErrorHandler = int(void* display, void* error);
ErrorHandler* usual_error_handler = nullptr;
std::atomic<std::uint32_t> expected_window = 0;

// Longer than a frame, and than the end of a device that is owed a stop.
constexpr std::chrono::seconds patience(10);

// The libraries are GLFW's: it opens them when it looks for a display.
template <typename Function>
Function* find_function(const char* library, const char* name) {
  void* const handle = dlopen(library, RTLD_LAZY | RTLD_NOLOAD);
  return handle != nullptr ? reinterpret_cast<Function*>(dlsym(handle, name)) : nullptr;
}

[[noreturn]] void end_without_display(DisplayLoss loss) {
  static std::atomic_flag has_begun;
  if (std::this_thread::get_id() != ui_thread) {
    // A thread of the graphics driver: the UI thread may be in the midst of a frame, and what it is to put in order is
    // its own. It ends the program, unless it waits for this thread.
    lost = loss;
    std::this_thread::sleep_for(patience);
  }
  // Who comes second does not come back either.
  while (has_begun.test_and_set()) pause();
  if (put_everything_in_order) put_everything_in_order();
  write_words(loss == DisplayLoss::window
                  ? "the window is gone: another program closed it; start the program again\n"
                  : "the display is gone: its server ended, or the connection to it broke; start the program again "
                    "when the display is back\n");
  // No destructor and no library's last call: they would talk to the server, and never return.
  std::fflush(nullptr);
  std::_Exit(static_cast<int>(ExitCode::no_display));
}

extern "C" int on_x11_loss(void* /*display*/) {
  end_without_display(DisplayLoss::server);
}

// Xlib's own handler prints words for programmers and ends the program.
extern "C" int on_x11_error(void* display, void* error) {
  if (expected_window != 0 && !DisplayWatch::window_exists(expected_window)) end_without_display(DisplayLoss::window);
  return usual_error_handler(display, error);
}

}  // namespace

void watch_display() {
  ui_thread = std::this_thread::get_id();
  if (glfwGetPlatform() != GLFW_PLATFORM_X11) return;
  using Handler = int(void*);
  if (auto* const set_handler = find_function<Handler*(Handler*)>("libX11.so.6", "XSetIOErrorHandler")) {
    set_handler(on_x11_loss);
  }
  if (auto* const set_handler = find_function<ErrorHandler*(ErrorHandler*)>("libX11.so.6", "XSetErrorHandler")) {
    ErrorHandler* const before = set_handler(on_x11_error);
    if (before != on_x11_error) usual_error_handler = before;  // a second window finds ours
  }
}

void expect_window(std::uint32_t window) {
  expected_window = window;
}

void end_if_display_is_lost(DisplayLoss seen_by_watch) {
  if (seen_by_watch != DisplayLoss::none) end_without_display(seen_by_watch);
  if (lost != DisplayLoss::none) end_without_display(lost);
  if (glfwGetPlatform() != GLFW_PLATFORM_WAYLAND) return;
  static auto* const get_error = find_function<int(wl_display*)>("libwayland-client.so.0", "wl_display_get_error");
  if (get_error != nullptr && get_error(glfwGetWaylandDisplay()) != 0) end_without_display(DisplayLoss::server);
}

BeforeDisplayLoss::BeforeDisplayLoss(std::function<void()> put_in_order) {
  put_everything_in_order = std::move(put_in_order);
}

BeforeDisplayLoss::~BeforeDisplayLoss() {
  put_everything_in_order = nullptr;
}

}  // namespace ghostforce
