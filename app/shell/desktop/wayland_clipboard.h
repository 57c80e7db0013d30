// Text on a Wayland desktop's clipboard, by the desktop's own tools wl-copy and wl-paste, which run beside the program:
// the text's owner is another program, which may be frozen, and GLFW would wait for it for good. UI thread, but for
// text().
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <string>
#include <vector>

#include "app/shell/desktop/clipboard_limits.h"

namespace ghostforce {

class WaylandClipboard {
 public:
  WaylandClipboard() = default;
  WaylandClipboard(const WaylandClipboard&) = delete;
  WaylandClipboard& operator=(const WaylandClipboard&) = delete;

  // False: the tool cannot be started, and nothing is copied. It holds the text until something else is copied, also
  // after the program's end.
  bool copy(const std::string& text);

  // "" where there is no text. Throws Failure(file_trouble), with what to do, where there is no such tool, the owner
  // does not answer for `patience_ns` or the text is too long. Any thread.
  static std::string text(std::int64_t patience_ns = clipboard_patience_ns);

  // Often: buries the tools that have ended.
  void poll();

 private:
  std::vector<pid_t> copies_;  // of wl-copy, that have not ended yet
};

}  // namespace ghostforce
