// The hand on a SpaceMouse: the newest reading, from whoever reads the device, moves the goal (spacemouse_motion.h). A
// thread does it on a desktop (device/spacemouse), the browser in a page. SI units.
//
// set(), reading() and the constructor belong to the UI thread, publish() to who reads the device, restart() and goal()
// to the servo thread; none waits or throws.
#pragma once

#include "core/latest_value.h"
#include "device/input/input.h"
#include "device/spacemouse/spacemouse_motion.h"

namespace ghostforce {

class SpaceMouseInput : public Input {
 public:
  explicit SpaceMouseInput(const SpaceMouseSettings& settings = {});

  // Settings that are not valid change nothing; returns whether they are.
  bool set(const SpaceMouseSettings& settings) noexcept;

  // Good until the next call.
  const SpaceMouseReading& reading() noexcept { return for_window_.latest(); }

  void publish(const SpaceMouseReading& reading) noexcept;

  void restart(const Vector<2>& goal) noexcept override { motion_.restart(goal); }
  Vector<2> goal(std::int64_t tick, double rate) noexcept override;

 private:
  LatestValue<SpaceMouseSettings> settings_;
  LatestValue<SpaceMouseReading> for_servo_{SpaceMouseReading{}};
  LatestValue<SpaceMouseReading> for_window_{SpaceMouseReading{}};
  SpaceMouseMotion motion_;  // servo thread's
};

}  // namespace ghostforce
