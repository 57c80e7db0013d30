// What readings of a hand say about a Haply 2DIY. Pure; never allocates or throws, any thread. SI units, degrees where it
// says so; by arm where nothing else is said.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/conventions.h"
#include "device/haply/hapi.h"
#include "device/haply/haply_calibration.h"

namespace ghostforce {

// What the encoders told, by port [degrees], when an arm's driven link pointed straight away from the base, and outwards.
struct HaplyTurn {
  hapi::PerPort<double> straight{};
  hapi::PerPort<double> outwards{};
};

enum class HaplyWiringProblem : std::uint8_t {
  none,
  no_movement,
  both_moved,  // so that nobody knows which is which
  same_twice,  // one encoder, or one arm, moved both times
  odd_size,    // the turn was read as no multiple of a right angle that a counter can be wrong by
};

// In a sentence, with what to do; empty for none.
std::string_view words_of(HaplyWiringProblem problem) noexcept;

struct HaplyEncoders {
  HaplyWiringProblem problem = HaplyWiringProblem::none;
  HaplyCalibration calibration;     // with ports, directions, counts per turn and offsets that make the readings right
  std::array<double, 2> ratios{};   // of a right angle, how much of it was read, with its sign
  std::array<double, 2> factors{};  // by which the counts per turn are multiplied
  std::array<double, 2> off_deg{};  // by which the assumed zero pose is off, once the turns are right
};
// By the angles of the calibration, with which the board was set up.
HaplyEncoders find_haply_encoders(const std::array<HaplyTurn, 2>& turns, const HaplyCalibration& assumed) noexcept;

// What the arms did when the motor that the calibration takes for an arm's gave a torque.
struct HaplyPulse {
  double torque = 0.0;
  Vector<2> moved_deg{0.0};
};
struct HaplyMotors {
  HaplyWiringProblem problem = HaplyWiringProblem::none;
  HaplyCalibration calibration;  // with ports and signs so that a positive torque increases its arm's angle
};
HaplyMotors find_haply_motors(const std::array<HaplyPulse, 2>& pulses, const HaplyCalibration& assumed) noexcept;

// While motors carry the handle slowly to and fro, without a hand: their mean torques as sent, towards the base and away
// from it. Friction is the same both ways, and of opposite sign.
struct HaplyHold {
  Vector<2> inwards{0.0};
  Vector<2> outwards{0.0};
  PantographPose pose;  // in the middle of the way
};

// N·m at each arm for each that is sent, from what motors sent with a weight less what they sent without it. The thread
// rubs on the table's edge, by a factor one way and by the same divisor the other way. Empty: a motor gave nothing
// against the weight.
std::optional<Vector<2>> find_torque_scales(const HaplyHold& without, const HaplyHold& with_weight,
                                            double weight) noexcept;

// Whether a handle at a wall swings to and fro by itself.
class SwingCounter {
 public:
  static constexpr double least_speed = 0.05;  // either way [m/s]
  static constexpr double within_s = 0.3;
  static constexpr std::size_t enough = 5;  // turns in that time

  bool add(double time_s, double speed) noexcept;  // true: it does

 private:
  std::array<double, enough> turns_s_{};
  std::size_t count_ = 0;
  int way_ = 0;
};

}  // namespace ghostforce
