// The hand on a SpaceMouse. A thread of the input's own looks for a device about twice a second, opens it and reads it
// (hidapi; all of which may wait and allocate); the servo thread only takes the newest reading. SI units.
//
// set(), reading() and the constructor belong to the UI thread, restart() and goal() to the servo thread; these two
// neither wait nor throw. The destructor waits for the reading thread: some 20 ms, or until that has seen what is
// plugged in.
#pragma once

#include <array>
#include <cstdint>
#include <stop_token>
#include <thread>

#include "core/latest_value.h"
#include "device/input.h"
#include "device/spacemouse_motion.h"

namespace ghostforce {

// Trivially copyable: it crosses threads whole.
struct SpaceMouseReading {
  enum class Trouble : std::uint8_t {
    none,
    absent,       // none is plugged in
    not_allowed,  // one is, and this user may not open it
    not_opened,   // one is, and cannot be opened for another reason
  };

  Trouble trouble = Trouble::absent;
  std::uint32_t connection = 0;  // another number each time a device has been opened; 0: there is none
  std::array<char, 64> name{};   // of the one that was seen last, ends in 0
  std::array<double, 6> axes{};  // -1 to 1: right, towards the user, down, turns about these
  std::uint32_t buttons = 0;     // bit 0: the first
  std::uint64_t reports = 0;     // that came in since the input was made

  bool connected() const noexcept { return connection != 0; }
};

class SpaceMouseInput final : public Input {
 public:
  explicit SpaceMouseInput(const SpaceMouseSettings& settings = {});
  ~SpaceMouseInput() override = default;  // the thread is asked to stop and waited for

  // UI thread. Settings that are not valid change nothing; returns whether they are.
  bool set(const SpaceMouseSettings& settings) noexcept;

  // UI thread. Good until the next call.
  const SpaceMouseReading& reading() noexcept { return for_window_.latest(); }

  void restart(const Vector<2>& goal) noexcept override;
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
