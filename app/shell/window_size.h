// How large a window is, and may be.
#pragma once

namespace ghostforce {

// Smaller, and the bars have no room for their words [screen coordinates].
inline constexpr int least_window_width = 480;
inline constexpr int least_window_height = 360;

struct WindowSize {
  int width = 0;
  int height = 0;
};

}  // namespace ghostforce
