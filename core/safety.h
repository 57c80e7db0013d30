// Safety: whether motors may push. OFF at the start; a person asks for ARMING, which waits until all is well; RAMP waits
// until the device has checked its motors, then lets the force grow over a second; ON; FADE takes it away, and OFF says
// why. Only a person leads out of OFF.
//
// A plain value that is told what is going on once per tick; SI units; never allocates or throws; any one thread.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

namespace ghostforce {

enum class SafetyState : std::uint8_t { off, arming, ramp, on, fade };

enum class OffReason : std::uint8_t {
  none,  // not armed since the start, or the reason was acknowledged
  key,
  visitor_gone,
  button_released,
  focus_lost,
  too_fast,
  over_force,
  loop_late,
  window_stalled,
  unplugged,
  not_homed,
  program_ending,
  overruled,
  machine_sleeps,
  calibration,
  fault,
};

struct OffReasonEntry {
  OffReason id;
  std::string_view name;    // in files
  std::string_view title;   // on screen
  std::string_view remedy;  // what to do now; "{}" stands for the key of the device status
  bool at_once;             // there is nothing left to fade with
  bool is_safety_limit;     // something was too much, or came too late
};

std::span<const OffReasonEntry> off_reason_catalog() noexcept;
const OffReasonEntry& entry_of(OffReason reason) noexcept;

// Why ARMING waits.
enum class ArmingObstacle : std::uint8_t {
  none,
  device_not_ready,
  loop_not_healthy,
  inside_wall,
  force,
  button,
  focus
};

struct ArmingObstacleEntry {
  ArmingObstacle id;
  std::string_view sentence;  // what to do about it; "{}" as above
};

const ArmingObstacleEntry& entry_of(ArmingObstacle obstacle) noexcept;

std::string_view name_of(SafetyState state) noexcept;  // as on the button

// What a person decides about it.
struct SafetyOptions {
  bool needs_button = false;    // a button on the grip must be held: deadman switch
  double force_limit = 6.0;     // of the force's magnitude [N]
  double greatest_k_r = 800.0;  // held at this while armed, until a person types a larger one [N/m]

  friend bool operator==(const SafetyOptions&, const SafetyOptions&) = default;
};

// What is going on in this tick.
struct SafetyReading {
  OffReason trouble = OffReason::none;  // what the device itself says: unplugged, not_homed, fault
  bool device_is_ready = false;         // every step up to the encoders is reached
  bool loop_is_healthy = false;         // exchanges come fast and evenly enough to start
  double since_exchange_s = 0.0;        // age of the newest reading
  double since_window_s = 0.0;          // time since the window's last heartbeat
  bool has_focus = true;                // keys reach the window
  bool deadman_held = false;            // on the grip
  bool is_outside_wall = false;         // the handle
  double speed = 0.0;                   // of the handle [m/s]
  double wanted_force = 0.0;            // magnitude of what the force law wants, before any limit [N]
  bool is_still = true;                 // the handle, enough for the device to check its motors
  bool motors_are_checked = true;       // the device has seen that they do what they are told; RAMP waits for that
};

class Safety {
 public:
  static constexpr double ramp_s = 1.0;
  static constexpr double fade_s = 0.2;
  static constexpr double greatest_speed = 1.0;          // [m/s]
  static constexpr double greatest_wanted_force = 40.0;  // far over any limit: the wall has been left behind [N]
  static constexpr double greatest_arming_force = 0.2;   // [N]
  static constexpr double longest_exchange_s = 0.020;
  static constexpr double longest_window_s = 0.500;

  // A person's requests, obeyed at the next update(). arm() has no effect while a reason waits to be acknowledged.
  void arm() noexcept { arm_asked_ = true; }
  void acknowledge() noexcept;

  // Has an effect in every state but OFF. The first reason stays.
  void turn_off(OffReason reason) noexcept;

  void update(const SafetyReading& reading, const SafetyOptions& options, double elapsed_s) noexcept;

  SafetyState state() const noexcept { return state_; }
  OffReason reason() const noexcept { return reason_; }            // in FADE and OFF
  OffReason last_reason() const noexcept { return last_reason_; }  // stays when it is acknowledged, until RAMP
  ArmingObstacle obstacle() const noexcept { return obstacle_; }   // in ARMING
  double gain() const noexcept { return gain_; }                   // on the force, 0 … 1

  // The device is the handle, and not simulated.
  bool is_armed() const noexcept { return state_ != SafetyState::off && state_ != SafetyState::arming; }

 private:
  static OffReason reason_to_stop(const SafetyReading& reading, const SafetyOptions& options) noexcept;
  static ArmingObstacle obstacle_in(const SafetyReading& reading, const SafetyOptions& options) noexcept;

  SafetyState state_ = SafetyState::off;
  OffReason reason_ = OffReason::none;
  OffReason last_reason_ = OffReason::none;
  ArmingObstacle obstacle_ = ArmingObstacle::none;
  double gain_ = 0.0;
  bool arm_asked_ = false;
};
static_assert(std::is_trivially_copyable_v<Safety>);

}  // namespace ghostforce
