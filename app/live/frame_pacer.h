// FramePacer: when a window draws again. Displays without vertical sync would otherwise draw as fast as they can, and a
// window in which nothing moves has nothing to show. Told the time, by any clock that does not go back [s]. UI thread.
#pragma once

#include <algorithm>

namespace ghostforce {

class FramePacer {
 public:
  explicit FramePacer(double now_s) : last_stir_s_(now_s) {}

  // How long to wait for the person, after a frame or a look around that began then. `idle`: nothing moves by itself.
  double wait_s(bool idle, double began_s, double now_s) const noexcept {
    const double interval_s = idle && frames_to_settle_ == 0 ? look_s : frame_s;
    return std::max(0.0, interval_s - (now_s - began_s));
  }

  // After that wait; `stirred`: the person or the desktop did something with the window.
  void waited(bool stirred, bool idle, double now_s) noexcept {
    frames_to_settle_ = stirred ? settling_frames : std::max(0, frames_to_settle_ - 1);
    if (stirred || !idle) last_stir_s_ = now_s;
  }

  // Nothing has happened for so long that even what waits for a pointer to rest has come, and what is on the screen is
  // not old: an idle window need not draw.
  bool may_sleep(double last_drawn_s, double now_s) const noexcept {
    return now_s - last_stir_s_ > stirred_s && now_s - last_drawn_s < oldest_s;
  }

  static constexpr double frame_s = 1.0 / 60.0;
  static constexpr double look_s = 0.1;     // how long news waits at most
  static constexpr double stirred_s = 1.5;  // until a word of explanation is there
  static constexpr double oldest_s = 5.0;   // of the status bar's counts
  // ImGui takes what comes in at once apart, one event a frame.
  static constexpr int settling_frames = 6;

 private:
  int frames_to_settle_ = settling_frames;
  double last_stir_s_;
};

}  // namespace ghostforce
