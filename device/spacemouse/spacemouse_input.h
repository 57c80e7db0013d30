// The hand on a SpaceMouse: how its cap moves the goal (SpaceMouseMotion), and the input that does it with the newest
// reading (SpaceMouseInput), from whoever reads the device: a thread on a desktop (hid_spacemouse_input.h), the browser
// in a page. Nothing here waits or throws. SI units.
#pragma once

#include <array>
#include <cstdint>

#include "core/conventions.h"
#include "core/latest_value.h"
#include "device/input/input.h"
#include "device/report/spacemouse.h"

namespace ghostforce {

// Whether all numbers are finite, the dead zone less than 1, and none negative.
bool is_valid(const SpaceMouseSettings& settings) noexcept;

// Deflection of the cap, at most 1 long, from its axes, -1 to 1 each. The dead zone is round, and beyond its edge the
// deflection starts from 0: no step there, and no direction is lost.
Vector<2> deflection(const std::array<double, 6>& axes, const SpaceMouseSettings& settings) noexcept;

// The cap's sideways axis is x; y is lifting it, or pushing it away. Either the goal is as far from its place of rest
// as the cap is deflected, or it goes as fast. Whatever happens (late reports, a change of mode, a device that goes and
// comes back), the goal never moves faster than fastest_m_s, and it stays where it is while there is no device, or one
// that has gone silent. Stepped once per tick; allocates nothing; one thread.
class SpaceMouseMotion {
 public:
  static constexpr double farthest_m = 1.0;   // goals lie within ± this on each axis
  static constexpr double fastest_m_s = 0.6;  // of the goal
  // The cap's deflection passes two of these lags, which turn some hundred steps a second into one smooth motion.
  static constexpr double lag_s = 0.010;
  // A deflected cap repeats its reports some hundred times a second. When a rate gets none for this long, the last one,
  // that of a cap at rest, was lost: the rate is 0 until the next report.
  static constexpr double longest_silence_s = 0.5;

  void restart(const Vector<2>& goal) noexcept;

  // The next tick, with the newest reading.
  Vector<2> step(const SpaceMouseReading& reading, const SpaceMouseSettings& settings, double rate_hz) noexcept;

 private:
  Vector<2> goal_{0.0};
  Vector<2> rest_{0.0};    // where the goal is in position mode when nobody touches the cap
  Vector<2> first_{0.0};   // deflection after the first lag
  Vector<2> second_{0.0};  // and after the other
  std::uint32_t connection_ = 0;
  std::uint64_t reports_ = 0;    // of the newest reading
  double since_report_s_ = 0.0;  // in rate mode
  SpaceMouseSettings::Mode mode_ = SpaceMouseSettings::Mode::position;
};

// set(), reading() and the constructor belong to the UI thread, publish() to who reads the device, restart() and goal()
// to the servo thread.
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
