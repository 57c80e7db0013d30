// Text on an X server's clipboard, read by a connection of its own and with a limit of time and of size. Its owner is
// another program, which may be frozen; GLFW would wait for it for good, when it reads and when it ends. UI thread, but
// for text().
#pragma once

#include <cstdint>
#include <string>

struct GLFWwindow;

namespace ghostforce {

class X11Clipboard {
 public:
  X11Clipboard() = default;
  // Gives up what it has copied where the clipboard's manager does not answer: GLFW would wait for it as it ends.
  ~X11Clipboard();
  X11Clipboard(const X11Clipboard&) = delete;
  X11Clipboard& operator=(const X11Clipboard&) = delete;

  // For other programs to paste, by GLFW.
  void copy(GLFWwindow* window, const std::string& text);

  // Empty where there is no text. Throws Failure(file_trouble), with what to do, where the owner does not answer or the
  // text is too long. Any thread but that of a window that owns the clipboard: there nobody would answer.
  static std::string text();

 private:
  std::uint32_t owner_ = 0;  // the window that has owned the clipboard since copy(); 0: nothing was copied
};

}  // namespace ghostforce
