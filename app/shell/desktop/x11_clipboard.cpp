#include "app/shell/desktop/x11_clipboard.h"

#include <poll.h>

#include <cstddef>
#include <optional>
#include <string_view>

#include <GLFW/glfw3.h>

#include "app/shell/desktop/clipboard_limits.h"
#include "app/shell/desktop/xcb_connection.h"
#include "device/input/monotonic_clock.h"

namespace ghostforce {
namespace {

// Asks for a selection, from a window that nobody sees.
class SelectionReader {
 public:
  SelectionReader() : connection_(xcb_connect(nullptr, nullptr)) {
    if (!is_connected()) return;
    window_ = xcb_generate_id(connection_.get());
    const xcb_screen_t* const screen = xcb_setup_roots_iterator(xcb_get_setup(connection_.get())).data;
    xcb_create_window(connection_.get(), XCB_COPY_FROM_PARENT, window_, screen->root, 0, 0, 1, 1, 0,
                      XCB_WINDOW_CLASS_INPUT_ONLY, XCB_COPY_FROM_PARENT, 0, nullptr);
  }

  // False: the server takes no more connections, and nothing else may be asked for.
  bool is_connected() const { return xcb_connection_has_error(connection_.get()) == 0; }

  xcb_atom_t atom(std::string_view name) const {
    const auto request = xcb_intern_atom(connection_.get(), 0, static_cast<std::uint16_t>(name.size()), name.data());
    const FromXcb<xcb_intern_atom_reply_t> reply(xcb_intern_atom_reply(connection_.get(), request, nullptr));
    return reply ? reply->atom : xcb_atom_t{XCB_ATOM_NONE};
  }

  std::uint32_t owner(xcb_atom_t selection) const {
    const auto request = xcb_get_selection_owner(connection_.get(), selection);
    const FromXcb<xcb_get_selection_owner_reply_t> reply(
        xcb_get_selection_owner_reply(connection_.get(), request, nullptr));
    return reply ? reply->owner : xcb_window_t{XCB_WINDOW_NONE};
  }

  void take(xcb_atom_t selection) const {
    xcb_set_selection_owner(connection_.get(), window_, selection, XCB_CURRENT_TIME);
    owner(selection);  // by then the server has done it
  }

  // The property with the answer, XCB_ATOM_NONE for a refusal; empty: the owner does not answer.
  std::optional<xcb_atom_t> ask(xcb_atom_t selection, xcb_atom_t target) const {
    xcb_convert_selection(connection_.get(), window_, selection, target, atom("GHOSTFORCE_SELECTION"),
                          XCB_CURRENT_TIME);
    xcb_flush(connection_.get());
    const std::int64_t end_ns = monotonic_ns() + clipboard_patience_ns;
    pollfd waits{xcb_get_file_descriptor(connection_.get()), POLLIN, 0};
    for (;;) {
      while (const FromXcb<xcb_generic_event_t> event{xcb_poll_for_event(connection_.get())}) {
        if ((event->response_type & 0x7F) != XCB_SELECTION_NOTIFY) continue;
        return reinterpret_cast<const xcb_selection_notify_event_t*>(event.get())->property;
      }
      const std::int64_t left_ms = (end_ns - monotonic_ns()) / 1'000'000;
      if (left_ms <= 0 || xcb_connection_has_error(connection_.get()) != 0) return std::nullopt;
      poll(&waits, 1, static_cast<int>(left_ms));
    }
  }

  // Empty: it is too long, or comes in pieces, as only long texts do.
  std::optional<std::string> text_in(xcb_atom_t property) const {
    const auto request = xcb_get_property(connection_.get(), 1, window_, property, XCB_GET_PROPERTY_TYPE_ANY, 0,
                                          most_clipboard_bytes / 4);
    const FromXcb<xcb_get_property_reply_t> reply(xcb_get_property_reply(connection_.get(), request, nullptr));
    if (!reply) return std::string();
    if (reply->bytes_after > 0 || reply->type == atom("INCR")) return std::nullopt;
    return std::string(static_cast<const char*>(xcb_get_property_value(reply.get())),
                       static_cast<std::size_t>(xcb_get_property_value_length(reply.get())));
  }

 private:
  XcbConnection connection_;
  xcb_window_t window_ = XCB_WINDOW_NONE;
};

}  // namespace

X11Clipboard::~X11Clipboard() {
  if (owner_ == 0) return;
  const SelectionReader reader;
  if (!reader.is_connected()) return;
  const xcb_atom_t clipboard = reader.atom("CLIPBOARD");
  const xcb_atom_t manager = reader.atom("CLIPBOARD_MANAGER");
  if (reader.owner(clipboard) != owner_ || reader.owner(manager) == XCB_WINDOW_NONE) return;
  if (!reader.ask(manager, reader.atom("TARGETS"))) reader.take(clipboard);
}

void X11Clipboard::copy(GLFWwindow* window, const std::string& text) {
  glfwSetClipboardString(window, text.c_str());  // returns once the server has done it
  const SelectionReader reader;
  if (reader.is_connected()) owner_ = reader.owner(reader.atom("CLIPBOARD"));
}

std::string X11Clipboard::text() {
  const SelectionReader reader;
  if (!reader.is_connected()) throw_clipboard_is_silent();
  const xcb_atom_t clipboard = reader.atom("CLIPBOARD");
  if (reader.owner(clipboard) == XCB_WINDOW_NONE) return {};
  const std::optional<xcb_atom_t> property = reader.ask(clipboard, reader.atom("UTF8_STRING"));
  if (!property) throw_clipboard_is_silent();
  if (*property == XCB_ATOM_NONE) return {};
  if (auto text = reader.text_in(*property)) return *std::move(text);
  throw_clipboard_is_too_long();
}

}  // namespace ghostforce
