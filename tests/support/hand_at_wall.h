// HandAtWall: a hand on a device with one motor that renders a slanted wall, written for the estimator's tests and
// benches and apart from everything that the program simulates: continuous time between the ticks, a motor that holds
// its force from tick to tick and gets it from what the encoders read one tick before, and a hand that is not still.
// The same seed gives the same hand with every library. SI units; x along the motor, y across it, the wall through the
// origin.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "core/hand_estimator.h"

namespace ghostforce {

// std::mt19937_64 gives the same numbers everywhere; the distributions of the standard library do not.
class HandRandom {
 public:
  explicit HandRandom(std::uint64_t seed) : bits_(seed) {}

  double uniform(double from, double to) { return from + (to - from) * static_cast<double>(bits_() >> 11) * 0x1p-53; }
  double over_decades(double from, double to) { return std::exp(uniform(std::log(from), std::log(to))); }
  // Of mean 0 and standard deviation 1, by Box and Muller.
  double normal() {
    return std::sqrt(-2.0 * std::log(1.0 - uniform(0.0, 1.0))) * std::cos(uniform(0.0, 2.0 * std::numbers::pi));
  }

 private:
  std::mt19937_64 bits_;
};

struct Sine {
  double amplitude;  // [m]
  double omega;      // [rad/s]
  double phase;      // [rad]
};

// A correction of where the hand wants to be, by minimum jerk.
struct Submovement {
  double from_s;
  double lasts_s;
  std::array<double, 2> way;  // [m]
};

// All that one hand is, and what it does by itself.
struct HandOfTest {
  double k_u = 300.0;     // [N/m]
  double mass = 0.2;      // of hand and device [kg]
  double damping = 5.0;   // of hand and device [N·s/m]
  double friction = 0.0;  // dry, of the device, on each axis [N]

  double wall_angle = 0.7;  // from the motor to n [rad]
  double k_r = 600.0;       // [N/m]
  double ratio = 1.0;       // ρ
  double k_c = 1e5;         // [N/m]
  double press = 2.5;       // of the hand against the motor at rest [N]

  double encoder = 60e-6;  // [m]; 0: exact
  std::array<std::vector<Sine>, 2> tremor{};
  std::vector<Sine> drift{};  // along the wall
  std::vector<Submovement> submovements{};
};

// How damping belongs to the hand: in proportion to the critical one, or drawn apart from mass and stiffness.
enum class HandPopulation : std::uint8_t { tied, apart };

// k_u 50 to 1000 N/m, 0.1 to 0.5 kg; a wall of 200 to 800 N/m at 25 to 65 degrees, half of them rendered with ρ = 1,
// half with the ratio for a belief of half to twice the truth. The hand trembles by 0.05 to 0.3 mm rms on either axis
// around one frequency of 8 to 12 Hz, as hands held out do; drifts along the wall at up to 20 mm/s; and corrects itself
// about once a second, by 0.6 to 4.6 mm rms, the more the faster it goes.
HandOfTest draw_hand(HandPopulation population, std::uint64_t seed);

// The same hand, still: no tremor, drift or submovements, exact encoders.
HandOfTest held_still(HandOfTest hand);

// p (sin 2π·3t + 0.6 sin 2π·16t)/1.6, faded in over 0.2 s [N]
double two_tones(double force, double since_s);

class HandAtWall {
 public:
  static constexpr double motor_limit = 6.0;  // [N]

  explicit HandAtWall(const HandOfTest& hand, double rate = 1000.0);

  // What the device reads at this tick and gives until the next, of which so much is tone; and time goes on.
  HandSample step(double tone);

  // From the next tick on. Muscles that pull against each other stiffen a hand that presses no harder for it.
  void set_k_u(double k_u);
  void set_ratio(double ratio) { hand_.ratio = ratio; }

  double seconds() const { return static_cast<double>(tick_) / rate_; }
  const HandOfTest& hand() const { return hand_; }
  // Of the motor by the wall at rest, over the depth of the handle [N/m].
  double wall_force_per_depth() const;

 private:
  using Plane = std::array<double, 2>;
  struct Motion {
    Plane place{};
    Plane speed{};
  };

  Plane goal_at(double seconds) const;
  Motion change_of(const Motion& motion, const Plane& goal, double motor, const Plane& friction) const;
  // While the goal goes from here to there.
  void move(const Plane& from, const Plane& to, double step, double motor);

  HandOfTest hand_;
  double rate_;
  std::int64_t tick_ = 0;
  Plane base_goal_{};  // without what the hand does by itself
  Plane goal_{};       // at this tick; straight on from tick to tick
  Motion motion_{};
  Plane read_before_{};  // what the encoders read one tick ago
};

// The samples of a hand that has settled for a second, from where the tones begin on (`force`: p; 0: none).
std::vector<HandSample> samples_of(const HandOfTest& hand, double force, double seconds, double rate = 1000.0);

}  // namespace ghostforce
