// Session: what the person at the window has loaded and changed. A value of the UI thread; panels and keys edit it, the
// application sends it on. Nothing in here knows of a device.
#pragma once

#include <cstdint>

#include "app/theme.h"
#include "app/view/compose.h"
#include "core/scene.h"

namespace ghostforce {

struct Session {
  Scene scene;              // as loaded
  Settings settings;        // as changed since
  Vector<2> goal{0.0};      // where the person wants the goal [m]
  bool drags_goal = false;  // the pointer holds the goal
  Compare compare = Compare::overlay;
  bool paused = false;
  double speed = 1.0;  // of model time against real time
  std::uint32_t steps_asked = 0;
  std::uint32_t restarts_asked = 0;
  bool pointer_moves_goal = true;  // the input is the mouse
};

inline Session session_of(const Scene& scene) {
  return {.scene = scene, .settings = scene.settings, .goal = scene.goal.points.back()};
}

// What the loop reports about itself, for the status bar.
struct LoopReading {
  std::string_view input_title;
  double rate_hz = 0.0;
  std::uint64_t late_ticks = 0;
  std::uint64_t dropped_samples = 0;
  bool diverged = false;  // the settings made the simulation unstable; it waits for others
  std::string remark{};     // what the operating system granted and refused the loop; may be empty
};

}  // namespace ghostforce
