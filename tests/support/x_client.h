// XClient: another program on a display, as far as a test needs one: it makes and destroys windows, and takes the keyboard.
#pragma once

#include <xcb/xcb.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>

namespace ghostforce {

class XClient {
 public:
  // `display`: as in DISPLAY.
  explicit XClient(const std::string& display) : connection_(xcb_connect(display.c_str(), nullptr), xcb_disconnect) {
    if (xcb_connection_has_error(connection_.get()) != 0) throw std::runtime_error("the display cannot be opened");
    screen_ = xcb_setup_roots_iterator(xcb_get_setup(connection_.get())).data;
  }

  std::uint32_t make_window() {
    const std::uint32_t window = xcb_generate_id(connection_.get());
    xcb_create_window(connection_.get(), XCB_COPY_FROM_PARENT, window, screen_->root, 0, 0, 100, 100, 0,
                      XCB_WINDOW_CLASS_INPUT_OUTPUT, screen_->root_visual, 0, nullptr);
    xcb_map_window(connection_.get(), window);
    wait();
    return window;
  }
  void focus(std::uint32_t window) {
    xcb_set_input_focus(connection_.get(), XCB_INPUT_FOCUS_POINTER_ROOT, window, XCB_CURRENT_TIME);
    wait();
  }
  void destroy(std::uint32_t window) {
    xcb_destroy_window(connection_.get(), window);
    wait();
  }
  // As xkill does it.
  void kill_owner(std::uint32_t window) {
    xcb_kill_client(connection_.get(), window);
    wait();
  }
  // As menus and screen lockers do it.
  bool grab_keyboard() {
    const auto request = xcb_grab_keyboard(connection_.get(), 0, screen_->root, XCB_CURRENT_TIME, XCB_GRAB_MODE_ASYNC,
                                           XCB_GRAB_MODE_ASYNC);
    const std::unique_ptr<xcb_grab_keyboard_reply_t, decltype(&std::free)> reply(
        xcb_grab_keyboard_reply(connection_.get(), request, nullptr), std::free);
    return reply && reply->status == XCB_GRAB_STATUS_SUCCESS;
  }
  void release_keyboard() {
    xcb_ungrab_keyboard(connection_.get(), XCB_CURRENT_TIME);
    wait();
  }
  // Tells others of the window of something that never was.
  void make_up(std::uint8_t type, std::uint32_t window) {
    std::array<char, 32> event{};  // as long as all of them
    if (type == XCB_DESTROY_NOTIFY) {
      xcb_destroy_notify_event_t destroyed{};
      destroyed.response_type = type;
      destroyed.event = destroyed.window = window;
      std::memcpy(event.data(), &destroyed, sizeof destroyed);
    } else {
      xcb_focus_in_event_t focus{};
      focus.response_type = type;
      focus.event = window;
      std::memcpy(event.data(), &focus, sizeof focus);
    }
    xcb_send_event(connection_.get(), 0, window, XCB_EVENT_MASK_FOCUS_CHANGE | XCB_EVENT_MASK_STRUCTURE_NOTIFY,
                   event.data());
    wait();
  }

 private:
  // Until the server has done what was asked.
  void wait() {
    std::free(xcb_get_input_focus_reply(connection_.get(), xcb_get_input_focus(connection_.get()), nullptr));
  }

  std::unique_ptr<xcb_connection_t, decltype(&xcb_disconnect)> connection_;
  xcb_screen_t* screen_ = nullptr;
};

}  // namespace ghostforce
