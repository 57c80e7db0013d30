#include "app/shell/desktop/display_watch.h"

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <utility>

#define GLFW_EXPOSE_NATIVE_WAYLAND
#define GLFW_NATIVE_INCLUDE_NONE  // nothing of Wayland is needed to build
#include <GLFW/glfw3.h>
#include <GLFW/glfw3native.h>

#include <dlfcn.h>
#include <poll.h>
#include <pthread.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include "app/base/failure.h"
#include "app/base/words.h"
#include "device/input/thread_signals.h"
#include "device/servo/realtime.h"

namespace ghostforce {

DisplayWatch::DisplayWatch(std::uint32_t window, void (*when_lost)() noexcept)
    : window_(window),
      when_lost_(when_lost),
      connection_(xcb_connect(nullptr, nullptr)),
      end_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  if (xcb_connection_has_error(connection_.get()) != 0) {
    throw Failure(ExitCode::no_display,
                  "the display takes no second connection, which tells whether keys reach the window; close other "
                  "programs");
  }
  const std::uint32_t events = XCB_EVENT_MASK_FOCUS_CHANGE | XCB_EVENT_MASK_STRUCTURE_NOTIFY;
  const auto request = xcb_change_window_attributes_checked(connection_.get(), window, XCB_CW_EVENT_MASK, &events);
  if (const FromXcb<xcb_generic_error_t> error(xcb_request_check(connection_.get(), request)); error) {
    throw Failure(ExitCode::no_display, "the window was closed by another program while it was opened");
  }
  thread_ = std::thread([this] { watch(); });
}

DisplayWatch::~DisplayWatch() {
  eventfd_write(end_.number(), 1);
  thread_.join();
}

void DisplayWatch::watch() noexcept {
  const AlternateStack alternate_stack;
  leave_process_signals();
  pthread_setname_np(pthread_self(), "display-watch");
  // It has next to nothing to do, but without delay, however busy the machine is.
  request_realtime();
  std::array<pollfd, 2> waits{{{xcb_get_file_descriptor(connection_.get()), POLLIN, 0}, {end_.number(), POLLIN, 0}}};
  while (waits[1].revents == 0) {
    take_events();
    if (loss() != DisplayLoss::none) {
      if (when_lost_ != nullptr) when_lost_();
      return;
    }
    poll(waits.data(), waits.size(), -1);
  }
}

// Where our window has the focus, a grab takes it away from the keyboard's point of view, and its end gives it back. A
// window that gets the focus while the keyboard is grabbed is told so.
void DisplayWatch::take_events() noexcept {
  while (const FromXcb<xcb_generic_event_t> event{xcb_poll_for_event(connection_.get())}) {
    const auto* const focus = reinterpret_cast<const xcb_focus_in_event_t*>(event.get());  // focus out is alike
    const auto* const destroyed = reinterpret_cast<const xcb_destroy_notify_event_t*>(event.get());
    switch (event->response_type) {  // what another client makes up has one bit more
      case XCB_FOCUS_IN:
        keyboard_is_taken_ = focus->mode == XCB_NOTIFY_MODE_GRAB || focus->mode == XCB_NOTIFY_MODE_WHILE_GRABBED;
        break;
      case XCB_FOCUS_OUT:
        if (focus->mode == XCB_NOTIFY_MODE_GRAB) keyboard_is_taken_ = true;
        break;
      case XCB_DESTROY_NOTIFY:
        if (destroyed->window == window_) loss_ = DisplayLoss::window;
        break;
      default:
        break;
    }
  }
  if (loss() == DisplayLoss::none && xcb_connection_has_error(connection_.get()) != 0) loss_ = DisplayLoss::server;
}

bool DisplayWatch::window_exists(std::uint32_t window) noexcept {
  const XcbConnection connection(xcb_connect(nullptr, nullptr));
  const auto request = xcb_get_window_attributes(connection.get(), window);
  return FromXcb<xcb_get_window_attributes_reply_t>(
             xcb_get_window_attributes_reply(connection.get(), request, nullptr)) != nullptr;
}

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
