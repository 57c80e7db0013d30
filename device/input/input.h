// What the servo asks while it ticks: an Input knows where the hand wants the device to be, and its HapticDevice, where
// it has one, reads the handle and drives the motors. A PointerTarget is an input whose goal the pointer moves.
//
// Input and HapticDevice belong to the servo thread: their functions never allocate, lock, throw, open files or, but
// for HapticDevice::wait_until(), wait. SI units, in the plane of the scene.
#pragma once

#include <cstdint>
#include <optional>

#include "core/conventions.h"
#include "core/mechanism.h"
#include "core/motor_heat.h"
#include "core/motor_verdict.h"
#include "core/safety.h"

namespace ghostforce {

// What a device tells of its handle and of itself.
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
  MotorFinding finding{};  // of that check when it ended last, where the device tells

  // The direction in which one motor pushes alone, where that turns with the handle [rad]. Empty: the settings say it.
  std::optional<double> motor_angle{};
  std::size_t pushing_motor = 0;         // which of two that is, 0 or 1
  bool zero_pose_moved = false;          // one has said so, and they were moving
  bool waits_for_zero_pose = false;      // a person has to say that the arms are where they count from
  bool is_saturated = false;             // a motor cannot give what it was asked for just now
  std::optional<LinkagePose> linkage{};  // of a device whose links move in the plane, as they stand in the scene

  MotorHeats heat{};  // estimated, since the input was made
};

// What the servo needs of a device whose handle it can read and whose motors it can drive.
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
  // off, whatever the force. Returns what of it they are asked for: less where one of them can give no more.
  virtual Vector<2> set_force(const Vector<2>& force, bool is_armed) noexcept = 0;

  // How much stronger the true force may be than the one asked for, because the motors are not known well; 1 or more.
  virtual double force_uncertainty() const noexcept = 0;

  // Turns the motors off and tells the device, within 0.1 s. Called before the thread ends.
  virtual void shut_down() noexcept = 0;
};

// Something that knows where the hand wants the device to be. The window makes it (input_catalog.h) and hands it to the
// servo, which owns it from then on. What it takes in from other threads, it takes in as whole values (see MouseInput).
class Input {
 public:
  Input() = default;
  Input(const Input&) = delete;
  Input& operator=(const Input&) = delete;
  virtual ~Input() = default;

  // The run starts, or starts again, at rest with this goal [m].
  virtual void restart(const Vector<2>& goal) noexcept = 0;

  // q_u(t_k) [m], where t_k = k / rate; asked once per tick. `rate` in ticks per second of model time [Hz].
  virtual Vector<2> goal(std::int64_t tick, double rate) noexcept = 0;

  // k_u of the hand in tick k [N/m], where a hand that changes moves the simulated devices, whoever says where to;
  // asked once per tick. Empty: the settings say it.
  virtual std::optional<double> user_stiffness(std::int64_t /*tick*/, double /*rate*/) noexcept { return {}; }

  // The motors of this input; null: it has none. Then nothing that it does can be felt.
  virtual HapticDevice* haptic_device() noexcept { return nullptr; }
};

// An input whose goal the pointer of the window moves. UI thread; nothing here waits, allocates or throws.
class PointerTarget {
 public:
  PointerTarget() = default;
  PointerTarget(const PointerTarget&) = delete;
  PointerTarget& operator=(const PointerTarget&) = delete;
  virtual ~PointerTarget() = default;

  // Moves the goal to `goal` [m] within `duration_s` of model time, which is the time until the next call: frame
  // interval × speed. A goal that is not finite is ignored and counted.
  virtual void move_to(const Vector<2>& goal, double duration_s) noexcept = 0;

  virtual std::uint64_t ignored_moves() const noexcept = 0;

  // The stiffness of the hand that the pointer guides, for a hand that is not part of the model [N/m].
  virtual void set_user_stiffness(double /*k_u*/) noexcept {}
};

}  // namespace ghostforce
