// Monitors: how much room there is for a window, and which one it is on. Main thread, between the window library's
// beginning and end.
#pragma once

#include "app/shell/window_size.h"

struct GLFWmonitor;
struct GLFWwindow;

namespace ghostforce {

// As large as what the desktop leaves free of the primary monitor, at most; as WindowOptions has it.
WindowSize fitted(WindowSize size);

// The one that shows most of the window; null: there is none.
GLFWmonitor* monitor_of(GLFWwindow* window);

}  // namespace ghostforce
