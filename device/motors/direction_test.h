// DirectionTest: whether each motor pushes the way it is told, found out with so little force that a hand which holds
// on loosely is not moved far. It comes before the check of the motors (motor_check.h), which pushes harder.
//
// One motor after another gives pulses of 0.015 N·m, or less where that is more than 0.23 N at the handle:
//     + − − + − + + −, of 0.08 s each, so that none lasts longer than 0.16 s.
// The energy that the motor gives to the handle is added up: torque times movement of the encoder, which is force times
// the handle's movement along that force. A hand that only holds on gives back no more than it got, so that this energy
// is never negative. The order of the pulses (Thue and Morse) makes the mean of it zero for a hand that drifts, gains
// speed evenly, or gains acceleration evenly.
//
// A motor is wrong where that energy is clearly negative, in three such pulse trains in a row with signs that take
// turns, and the handle has gone the same way in all of them, but for that sign. Where it is not, be it that it is
// right or that a firm hand is not moved by an encoder's step, the test goes on: what it leaves open is for the motor
// check.
//
// A plain value, fed with each reply; never allocates or throws; any one thread. N, m, rad, N·m, J; times in ns.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "core/conventions.h"
#include "core/motor_verdict.h"
#include "device/motors/motor_check.h"

namespace ghostforce {

class DirectionTest {
 public:
  static constexpr double pulse_s = 0.080;
  static constexpr std::size_t pulse_count = 8;
  static constexpr double train_s = static_cast<double>(pulse_count) * pulse_s;
  static constexpr double rest_s = 0.120;           // before each train
  static constexpr double greatest_torque = 0.015;  // [N·m]
  static constexpr double greatest_force = 0.23;    // at the handle [N]
  static constexpr int trains_to_tell = 3;          // that a motor is wrong
  static constexpr int crossed_rounds_to_tell = 3;  // of all legs, that two motors move each other's

  // `legs`: 2 or 3, of a device with so many motors.
  explicit DirectionTest(std::size_t legs) noexcept : legs_(legs) {}

  // No push is stronger [N].
  void set_force_limit(double limit) noexcept { limit_ = limit; }

  // As MotorCheck has it. `is_still`: the hand is quiet enough to begin a train.
  void add(const MotorCheck::Reading& reading, double count_angle, const Vector<3>& levers, bool is_still) noexcept;

  // Motors have come on.
  void begin() noexcept;
  // They are off: what was found is forgotten.
  void end() noexcept;

  // What to push with now.
  MotorCheck::Push push_at(std::int64_t now_ns) noexcept;

  // Nothing speaks against any motor, and no train is on its way.
  bool is_done() const noexcept { return is_done_; }
  // This leg's motor was seen to push the right way.
  bool is_right(std::size_t leg) const noexcept { return is_right_[leg]; }
  // That a motor pushes the wrong way, that two move each other's legs, or nothing.
  MotorFinding finding() const noexcept { return finding_; }

 private:
  using PerPulse = std::array<double, pulse_count>;

  // Of one train, for the motor that pushed.
  struct Train {
    PerPulse energy{};   // given to the handle in each pulse [J]
    PerPulse impulse{};  // torque times time [N·m·s]
    PerPulse way{};      // where the arm was after each, from the beginning, times the train's sign [rad]
    // Given to the handle, on average over the train's time, had each leg's encoder been the pushed one's [J].
    Vector<3> mean_energy{0.0};
    double mean_impulse = 0.0;
    double roughness = 0.0;  // Σ (w_k − w_k+1)² of the torques that an encoder's steps are weighed with [(N·m)²]
    double weight_before = 0.0;
    double torque = 0.0;  // mean magnitude, times the time [N·m·s]
  };
  enum class Outcome : std::uint8_t { right, wrong, unclear, unclear_and_quiet };

  // Of a leg's newest train, for one N·m: as Train has it, and what the hand and the encoders' steps leave open of it.
  struct Found {
    Vector<3> energy{0.0};
    double margin = 0.0;  // 0: nothing was found, or the hand was too lively
  };

  void follow_rest(const MotorCheck::Reading& reading) noexcept;
  bool learn_own() noexcept;
  bool are_crossed() noexcept;
  Outcome outcome_of_train() noexcept;
  void take_in(Outcome outcome) noexcept;
  void begin_leg(std::size_t leg) noexcept;

  // Where the arms were while nothing pushed, every four milliseconds at most.
  static constexpr std::size_t rest_size = 256;
  static constexpr std::int64_t rest_step_ns = 4'000'000;
  // The hand's own motion is looked at in so many stretches, each so much earlier than the one before.
  static constexpr int own_shifts = 4;
  static constexpr std::int64_t own_shift_ns = 80'000'000;
  struct Place {
    std::int64_t time_ns = 0;
    Vector<3> angles{0.0};
  };
  std::array<Place, rest_size> rest_{};
  std::size_t rest_next_ = 0;
  std::size_t rest_count_ = 0;

  std::size_t legs_;
  double limit_ = std::numeric_limits<double>::infinity();
  MotorCheck::Reading before_{};  // the newest
  Vector<3> start_{0.0};          // the arms at the train's beginning
  Vector<3> levers_{1.0};
  double count_angle_ = 0.0;
  bool has_reading_ = false;
  bool is_still_ = false;

  bool is_running_ = false;
  bool is_pushing_ = false;
  bool is_done_ = false;
  std::size_t leg_ = 0;
  double sign_ = 1.0;          // of the train
  std::int64_t began_ns_ = 0;  // the train
  std::int64_t ended_ns_ = 0;  // the one before
  Vector<3> own_{0.0};         // what the same train would have made of the hand's own motion, per N·m [rad]
  bool knows_own_ = false;
  Train train_;
  PerPulse way_before_{};        // of the train before, where it was wrong
  int wrong_trains_ = 0;         // in a row
  int unclear_trains_ = 0;       // of this leg
  int crossed_rounds_ = 0;       // in a row, in which two motors seemed to move each other's leg
  double crossed_energy_ = 0.0;  // what told so in the newest, for one N·m
  std::array<Found, 3> found_{};
  std::array<bool, 3> is_right_{};
  MotorFinding finding_;
};

}  // namespace ghostforce
