// MotorCheck: whether the motors move the handle as they are told. It finds out when motors come on, before they may push.
// For one leg after another it asks for a short force to and fro along the leg's way,
//     f(t) = a (sin 2ωt − ½ sin ωt), and once more with the other sign,
// and adds up the energy that the motor gives to the handle: torque times movement of the encoder.
//
// A hand that only holds on gives back no more than it got. From rest that energy is never negative, whatever the hand's
// mass, stiffness and damping are. So it is negative where a motor or an encoder has the wrong sign. Two motors that take
// turns against each other tell in the same way whether their legs are mixed up. The force has no impulse, no
// displacement and no mean displacement of its own: a hand that moves or accelerates evenly adds no energy.
//
// The margin is twice what the same force would have made of the hand's own motion just before, when nothing was sent,
// and three standard deviations of what the encoders' steps pretend. A hand that is too lively is waited for.
//
// A plain value, fed with each reply; never allocates or throws; any one thread. N, m, rad, N·m, J; times in ns.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "core/conventions.h"
#include "core/motor_verdict.h"

namespace ghostforce {

class MotorCheck {
 public:
  static constexpr double half_s = 0.045;        // of a force to and fro; the other one follows at once
  static constexpr double rest_s = 0.120;        // before each leg's: what the hand does by itself is seen here
  static constexpr double least_force = 0.6;     // a [N]
  static constexpr double greatest_force = 2.4;  // a, where the hand is heavy, stiff or lively [N]
  static constexpr int most_rounds = 12;         // of all legs, before it gives up
  static constexpr double crest = 1.37;          // the greatest force is this times a

  // A place of the arms, and the torques that act from then on.
  struct Reading {
    std::int64_t time_ns = 0;
    Vector<3> angles{0.0};   // of the upper arms [rad]
    Vector<3> torques{0.0};  // on them [N·m]
  };

  // So much force along the way of a leg, which this leg's motor makes alone [N].
  struct Push {
    std::size_t leg = 0;
    double force = 0.0;
  };

  // `legs`: 2 or 3, of a device with so many motors.
  explicit MotorCheck(std::size_t legs = 3) noexcept;

  // No push is stronger [N].
  void set_force_limit(double limit) noexcept { limit_ = limit; }

  // `count_angle`: of one step of an encoder [rad]; `levers`: torque on each leg per newton along its way [m].
  void add(const Reading& reading, double count_angle, const Vector<3>& levers) noexcept;

  // Motors have come on.
  void begin() noexcept;
  // They are off: what was found is forgotten.
  void end() noexcept;

  // What to push with now.
  Push push_at(std::int64_t now_ns) noexcept;

  MotorVerdict verdict() const noexcept { return verdict_; }
  // With the leg whose motor it is about.
  MotorFinding finding() const noexcept { return {verdict_, leg_}; }
  // The hand is quiet enough to begin.
  bool is_still() const noexcept { return is_still_; }
  // Of the newest push to and fro [J].
  double energy() const noexcept { return newest_.whole; }
  double margin() const noexcept { return newest_.margin; }

 private:
  static constexpr std::size_t history_size = 512;
  static constexpr std::size_t weight_count = 181;  // every half millisecond

  // Given to the handle, on average over the time of one push to and fro and back again [J].
  struct Energy {
    double first = 0.0;   // over its first half alone
    double second = 0.0;  // and its second
    double whole = 0.0;
    Vector<3> at_legs{0.0};  // `whole`, had each leg's encoder been the pushed one's
    double margin = 0.0;     // of `whole`
    double torque = 0.0;     // mean magnitude [N·m]
    bool has_moved = false;  // any encoder
    bool is_quiet = false;   // the encoders' steps are the greater part of the margin
    bool is_valid = false;   // it was pushed with, and listened to all along
  };

  const Reading& back(std::size_t steps) const noexcept {
    return history_[(next_ + history_size - 1 - steps) % history_size];
  }
  double own_energy(std::size_t leg) const noexcept;
  Energy energy_of_push() const noexcept;
  void judge(const Energy& energy) noexcept;
  MotorVerdict verdict_on_legs() const noexcept;

  std::array<double, weight_count> weights_{};  // of a movement in the energy of a push with a = 1
  std::array<Reading, history_size> history_{};
  std::size_t next_ = 0;
  std::size_t count_ = 0;
  double count_angle_ = 0.0;
  Vector<3> levers_{1.0};
  bool is_still_ = false;

  std::size_t legs_;
  bool is_running_ = false;
  std::size_t leg_ = 0;
  double limit_ = std::numeric_limits<double>::infinity();
  double force_ = 0.0;           // a; 0: at rest
  double own_ = 0.0;             // the hand's own energy before the push, for a = 1
  std::int64_t began_ns_ = 0;    // the push
  std::int64_t ended_ns_ = 0;    // the one before
  bool needs_rest_ = true;       // before the next one
  int tries_ = 0;                // for this leg
  int votes_ = 0;                // of pushes in a row; below 0: wrong
  int silent_tries_ = 0;         // in a row
  int rounds_ = 0;               // of all legs, without a verdict
  double unclear_energy_ = 0.0;  // of pushes in a row that were too weak to tell [J]
  double unclear_margin_ = 0.0;
  Energy newest_;
  std::array<Energy, 3> found_{};  // leg by leg
  MotorVerdict verdict_ = MotorVerdict::none;
};

}  // namespace ghostforce
