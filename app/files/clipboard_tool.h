// Pictures for the system's clipboard, by the desktop's own tool: wl-copy under Wayland, xclip under X11. It runs beside
// the program and holds the picture until something else is copied; in a page it is the browser that copies. Nobody
// waits for it: UI thread.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ghostforce {

enum class DisplayKind : std::uint8_t { none, x11, wayland };

class ClipboardTool {
 public:
  ClipboardTool() = default;
  ClipboardTool(const ClipboardTool&) = delete;
  ClipboardTool& operator=(const ClipboardTool&) = delete;

  // Starts the tool with these bytes of a PNG file on its standard input. Returns why it could not be started, and what
  // to do; empty: it was.
  std::string copy_png(std::string_view png, DisplayKind display);

  // Often: buries those that have ended. Returns what to tell of one that has failed; empty: none has.
  std::string poll();

  // That have not ended yet.
  std::size_t running() const noexcept { return children_.size(); }

 private:
  std::vector<pid_t> children_;  // in a page: numbers of copies
};

}  // namespace ghostforce
