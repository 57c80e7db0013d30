#include "app/shell/desktop/monitors.h"

#include <GLFW/glfw3.h>

#include <algorithm>

namespace ghostforce {

WindowSize fitted(WindowSize size) {
  GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
  if (monitor == nullptr) return size;
  int x = 0, y = 0, width = 0, height = 0;
  glfwGetMonitorWorkarea(monitor, &x, &y, &width, &height);
  if (width < least_window_width || height < least_window_height) return size;
  // Where a window's coordinates are pixels, GLFW makes it larger by the display's scale.
  float scale = 1.0F;
  if (glfwGetPlatform() == GLFW_PLATFORM_X11) glfwGetMonitorContentScale(monitor, &scale, nullptr);
  const auto before_scaling = [scale](int length) { return static_cast<int>(static_cast<float>(length) / scale); };
  return {std::min(size.width, before_scaling(width)), std::min(size.height, before_scaling(height))};
}

GLFWmonitor* monitor_of(GLFWwindow* window) {
  int x = 0, y = 0, width = 0, height = 0;
  glfwGetWindowPos(window, &x, &y);
  glfwGetWindowSize(window, &width, &height);
  GLFWmonitor* best = glfwGetPrimaryMonitor();
  int most = 0;
  int count = 0;
  GLFWmonitor** monitors = glfwGetMonitors(&count);
  for (int i = 0; i < count; ++i) {
    int left = 0, top = 0;
    glfwGetMonitorPos(monitors[i], &left, &top);
    const GLFWvidmode* mode = glfwGetVideoMode(monitors[i]);
    if (mode == nullptr) continue;
    const int across = std::min(x + width, left + mode->width) - std::max(x, left);
    const int down = std::min(y + height, top + mode->height) - std::max(y, top);
    if (const int shared = std::max(0, across) * std::max(0, down); shared > most) {
      most = shared;
      best = monitors[i];
    }
  }
  return best;
}

}  // namespace ghostforce
