// The pace of the window and of the loop: FramePacer, when to look for something to draw, and LateTicks, how often the
// loop came too late. They are told the time [s] and read no clock. UI thread.
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>

namespace ghostforce {

// How long a window waits for the person between two looks at what there is to draw. Displays without vertical sync
// would otherwise draw as fast as they can. The time is that of any clock that does not go back.
class FramePacer {
 public:
  explicit FramePacer(double now_s) : last_stir_s_(now_s) {}

  // A frame is due because the person has just done something, though nothing else is known to have changed: ImGui may
  // not have taken all of it in, and what waits for a pointer to rest is still to come. `drawn_s`: the newest frame.
  bool is_due(double drawn_s, double now_s) const noexcept {
    return frames_to_settle_ > 0 || (now_s - last_stir_s_ <= stirred_s && now_s - drawn_s >= rest_look_s);
  }

  // How long to wait for the person, after a look that began then. `idle`: nothing goes on by itself.
  double wait_s(bool idle, double began_s, double now_s) const noexcept {
    const double interval_s = idle && frames_to_settle_ == 0 ? rest_look_s : frame_s;
    return std::max(0.0, interval_s - (now_s - began_s));
  }

  // After that wait; `stirred`: the person or the desktop did something with the window.
  void waited(bool stirred, double now_s) noexcept {
    frames_to_settle_ = stirred ? settling_frames : std::max(0, frames_to_settle_ - 1);
    if (stirred) last_stir_s_ = now_s;
  }

  static constexpr double frame_s = 1.0 / 60.0;
  static constexpr double rest_look_s = 0.1;  // how long news waits at most
  static constexpr double stirred_s = 1.5;    // until a word of explanation is there
  // ImGui takes what comes in at once apart, one event a frame.
  static constexpr int settling_frames = 6;

 private:
  int frames_to_settle_ = settling_frames;
  double last_stir_s_;
};

// How many ticks of the loop came too late, of those that the loop counts since its thread was started. What happens
// while a device is looked for or opened is left out. A value.
class LateTicks {
 public:
  explicit LateTicks(double lately_s) noexcept : lately_s_(lately_s) {}

  // `counted`: the loop's own count by now; a smaller one than before: a new loop's. `interval_s`: since the last call.
  void note(std::uint64_t counted, bool is_opening, double interval_s);

  std::uint64_t all() const noexcept { return all_; }
  // In the last `lately_s`.
  std::uint64_t lately() const noexcept { return lately_; }

 private:
  struct Burst {
    double at_s;
    std::uint64_t ticks;
  };

  double lately_s_;
  double clock_s_ = 0.0;
  std::uint64_t counted_ = 0;
  bool is_opening_ = false;
  std::uint64_t all_ = 0;
  std::uint64_t lately_ = 0;
  std::deque<Burst> bursts_;  // that lately_ is the sum of
};

}  // namespace ghostforce
