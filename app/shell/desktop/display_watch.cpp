#include "app/shell/desktop/display_watch.h"

#include <poll.h>
#include <pthread.h>
#include <sys/eventfd.h>
#include <xcb/xcb.h>

#include <array>
#include <cstdlib>

#include "app/base/failure.h"
#include "device/input/thread_signals.h"
#include "device/servo/realtime.h"

namespace ghostforce {
namespace {

// libxcb gives away what malloc() made.
struct Free {
  void operator()(void* memory) const noexcept { std::free(memory); }
};
template <typename Type>
using Given = std::unique_ptr<Type, Free>;

}  // namespace

void DisplayWatch::Disconnect::operator()(xcb_connection_t* connection) const noexcept {
  xcb_disconnect(connection);
}

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
  if (const Given<xcb_generic_error_t> error(xcb_request_check(connection_.get(), request)); error) {
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
  while (const Given<xcb_generic_event_t> event{xcb_poll_for_event(connection_.get())}) {
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
  const std::unique_ptr<xcb_connection_t, Disconnect> connection(xcb_connect(nullptr, nullptr));
  const auto request = xcb_get_window_attributes(connection.get(), window);
  return Given<xcb_get_window_attributes_reply_t>(
             xcb_get_window_attributes_reply(connection.get(), request, nullptr)) != nullptr;
}

}  // namespace ghostforce
