// XClient: another program on a display, as far as a test needs one: it makes and destroys windows,
// takes the keyboard, and owns the clipboard.
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
  // Owns it from now on, and answers nobody: as a program that is frozen.
  void own(const std::string& selection) {
    xcb_set_selection_owner(connection_.get(), make_window(), atom(selection), XCB_CURRENT_TIME);
    wait();
  }
  // The next request of another client for it is answered with this text.
  void answer_with(const std::string& text) {
    while (!answers_with(text, *next_event())) {
    }
  }
  // So are all of them, until another client owns it.
  void answer_until_another_owns_it(const std::string& text) {
    for (;;) {
      const Event event = next_event();
      if ((event->response_type & 0x7F) == XCB_SELECTION_CLEAR) return;
      answers_with(text, *event);
    }
  }
  bool is_owned(const std::string& selection) {
    const std::unique_ptr<xcb_get_selection_owner_reply_t, decltype(&std::free)> reply(
        xcb_get_selection_owner_reply(connection_.get(), xcb_get_selection_owner(connection_.get(), atom(selection)),
                                      nullptr),
        std::free);
    return reply && reply->owner != XCB_WINDOW_NONE;
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
  using Event = std::unique_ptr<xcb_generic_event_t, decltype(&std::free)>;

  Event next_event() {
    Event event(xcb_wait_for_event(connection_.get()), std::free);
    if (!event) throw std::runtime_error("the display has gone");
    return event;
  }
  // False: it is no request.
  bool answers_with(const std::string& text, const xcb_generic_event_t& event) {
    if (event.response_type != XCB_SELECTION_REQUEST) return false;
    const auto& request = reinterpret_cast<const xcb_selection_request_event_t&>(event);
    xcb_change_property(connection_.get(), XCB_PROP_MODE_REPLACE, request.requestor, request.property, request.target,
                        8, static_cast<std::uint32_t>(text.size()), text.data());
    std::array<char, 32> bytes{};
    xcb_selection_notify_event_t answer{};
    answer.response_type = XCB_SELECTION_NOTIFY;
    answer.requestor = request.requestor;
    answer.selection = request.selection;
    answer.target = request.target;
    answer.property = request.property;
    std::memcpy(bytes.data(), &answer, sizeof answer);
    xcb_send_event(connection_.get(), 0, request.requestor, 0, bytes.data());
    wait();
    return true;
  }
  xcb_atom_t atom(const std::string& name) {
    const std::unique_ptr<xcb_intern_atom_reply_t, decltype(&std::free)> reply(
        xcb_intern_atom_reply(
            connection_.get(),
            xcb_intern_atom(connection_.get(), 0, static_cast<std::uint16_t>(name.size()), name.data()), nullptr),
        std::free);
    return reply ? reply->atom : xcb_atom_t{XCB_ATOM_NONE};
  }
  // Until the server has done what was asked.
  void wait() {
    std::free(xcb_get_input_focus_reply(connection_.get(), xcb_get_input_focus(connection_.get()), nullptr));
  }

  std::unique_ptr<xcb_connection_t, decltype(&xcb_disconnect)> connection_;
  xcb_screen_t* screen_ = nullptr;
};

}  // namespace ghostforce
