// The hand on a SpaceMouse. A thread of the input's own looks for a device about twice a second, opens it and reads it
// (hidapi; all of which may wait and allocate); the servo thread only takes the newest reading. SI units.
//
// set(), reading() and the constructor belong to the UI thread, restart() and goal() to the servo thread; these two
// neither wait nor throw. The destructor waits for the reading thread: some 20 ms, or until that has seen what is
// plugged in.
#pragma once

#include <stop_token>
#include <thread>

#include "core/latest_value.h"
#include "device/input/input.h"
#include "device/spacemouse/spacemouse_motion.h"

namespace ghostforce {

class SpaceMouseInput final : public Input {
 public:
  explicit SpaceMouseInput(const SpaceMouseSettings& settings = {});
  ~SpaceMouseInput() override = default;  // the thread is asked to stop and waited for

  // UI thread. Settings that are not valid change nothing; returns whether they are.
  bool set(const SpaceMouseSettings& settings) noexcept;

  // UI thread. Good until the next call.
  const SpaceMouseReading& reading() noexcept { return for_window_.latest(); }

  void restart(const Vector<2>& goal) noexcept override { motion_.restart(goal); }
  Vector<2> goal(std::int64_t tick, double rate) noexcept override;

 private:
  void read(const std::stop_token& stop);
  void publish(const SpaceMouseReading& reading) noexcept;

  LatestValue<SpaceMouseSettings> settings_;
  LatestValue<SpaceMouseReading> for_servo_{SpaceMouseReading{}};
  LatestValue<SpaceMouseReading> for_window_{SpaceMouseReading{}};
  SpaceMouseMotion motion_;  // servo thread's
  std::jthread reader_;      // last: it uses what stands above
};

}  // namespace ghostforce
