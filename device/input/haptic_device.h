// HapticDevice: what the servo needs of a device whose handle it can read and whose motors it can drive, in the plane
// of the scene. The servo's thread; nothing here allocates, throws or, but for wait_until(), waits. SI units.
#pragma once

#include <cstdint>

#include "core/conventions.h"
#include "core/safety.h"

namespace ghostforce {

struct HandleReading {
  Vector<2> position{0.0};  // q_h [m]; where it was last known, if it is not known now
  double speed = 0.0;       // of the handle, in all its directions [m/s]
  bool is_known = false;
  std::int64_t time_ns = 0;             // when it came, by now_ns()
  bool deadman_held = false;            // any on the grip
  bool is_ready = false;                // every step before the handle's place is reached
  bool is_healthy = false;              // exchanges have been fast and even for a while
  OffReason trouble = OffReason::none;  // why motors must not push
  bool may_still_push = false;          // a device has not answered since it was told to stop, perhaps another one

  // What the device wants its motors to push with besides, to check them and its encoders: at the handle [N].
  Vector<2> probe{0.0};
  bool is_still = true;    // enough for that check
  bool is_checked = true;  // nothing but the probe may be pushed with before
};

class HapticDevice {
 public:
  HapticDevice() = default;
  HapticDevice(const HapticDevice&) = delete;
  HapticDevice& operator=(const HapticDevice&) = delete;
  virtual ~HapticDevice() = default;

  // The clock of everything here.
  virtual std::int64_t now_ns() const noexcept = 0;

  // Lets the device work until a tick is due at `deadline_ns`; a little longer if its answer is about to come, so that
  // the tick has the newest reading.
  virtual void wait_until(std::int64_t deadline_ns) noexcept = 0;

  virtual HandleReading read() noexcept = 0;

  // Newtons at the handle per newton in the scene, where distances may be longer or shorter than the handle's: it keeps
  // a wall as stiff in the hand as its setting says.
  virtual double force_at_handle() const noexcept = 0;

  // No force is stronger than this from now on, those included with which the device checks itself [N].
  virtual void set_force_limit(double /*limit*/) noexcept {}

  // Drives the motors: the force at the handle, in the plane [N]. It acts until the next call. `is_armed` false: motors
  // off, whatever the force.
  virtual void set_force(const Vector<2>& force, bool is_armed) noexcept = 0;

  // How much stronger the true force may be than the one asked for, because the motors are not known well; 1 or more.
  virtual double force_uncertainty() const noexcept = 0;

  // Turns the motors off and tells the device, within 0.1 s. Called before the thread ends.
  virtual void shut_down() noexcept = 0;
};

}  // namespace ghostforce
