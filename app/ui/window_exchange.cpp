// What the window exchanges with other programs: the clipboard's text, and files that are dropped on it.
#include <GLFW/glfw3.h>

#include <utility>

#include "app/ui/window.h"

namespace ghostforce {

void Window::set_clipboard_text(const std::string& text) {
  glfwSetClipboardString(handle(), text.c_str());
}

std::string Window::clipboard_text() const {
  const char* const text = glfwGetClipboardString(handle());
  return text == nullptr ? "" : text;
}

DisplayKind Window::display_kind() const {
  switch (glfwGetPlatform()) {
    case GLFW_PLATFORM_X11:
      return DisplayKind::x11;
    case GLFW_PLATFORM_WAYLAND:
      return DisplayKind::wayland;
    default:
      return DisplayKind::none;
  }
}

std::vector<std::string> Window::take_dropped_files() {
  return std::exchange(dropped_files_, {});
}

}  // namespace ghostforce
