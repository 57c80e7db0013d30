// Energy round a closed loop, the motion of the energy test: the circle that the goal goes round, the energy that the
// rendering gave to the hand on a loop and the area that the loop encloses, and CircleEnergyMeter, which measures one
// turn after another, strategy by strategy, beside what energy_per_loop() in energy.h predicts. Values; never allocates
// or throws. Any one thread. SI units.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>

#include "core/settings.h"
#include "core/snapshot.h"
#include "core/wall.h"

namespace ghostforce {

// The goal of the energy test is on its circle from this time on [s].
inline constexpr double circle_begins_s = 0.5;

struct Circle {
  Vector<2> center{0.0};           // [m]
  double radius = 0.0;             // [m]
  double turns_per_second = 0.25;  // counter-clockwise +, and so is the area inside [1/s]

  friend bool operator==(const Circle&, const Circle&) = default;
};

// Of one turn [s].
inline double period_of(const Circle& circle) noexcept {
  return 1.0 / std::abs(circle.turns_per_second);
}

// Starts at the right of the center.
inline Vector<2> position_on(const Circle& circle, double time_s) noexcept {
  const double angle = 2.0 * std::numbers::pi * circle.turns_per_second * time_s;
  return circle.center + circle.radius * Vector<2>(std::cos(angle), std::sin(angle));
}

// What a person may choose of it.
struct CircleChoice {
  std::optional<double> radius;  // [m]; empty: half of the depth that there is, within reason
  bool is_clockwise = false;

  friend bool operator==(const CircleChoice&, const CircleChoice&) = default;
};

// A circle that lies inside the wall, all of it at least a quarter of its radius deep, round `near`, or, where that is
// not deep enough, round the nearest point behind it, along the normal, that is.
inline Circle circle_inside(const Wall<2>& wall, const Vector<2>& near, const CircleChoice& choice) noexcept {
  constexpr double least = 0.005;
  constexpr double greatest = 0.020;
  constexpr double clearance = 0.25;
  const double radius = choice.radius.value_or(std::clamp(0.5 * depth(wall, near), least, greatest));
  const double missing = (1.0 + clearance) * radius - depth(wall, near);
  Circle circle{near - wall.normal * std::max(missing, 0.0), radius};
  if (choice.is_clockwise) circle.turns_per_second = -circle.turns_per_second;
  return circle;
}

// The sense in which a loop of the naïve device takes energy out of the wall: W of energy_per_loop() is positive.
inline bool makes_energy_clockwise(const Settings& settings) noexcept {
  const double theta = settings.actuated_angle - settings.wall_normal_angle;
  return std::sin(theta) * std::cos(theta) > 0.0;
}

// By energy_per_loop(), of a strategy whose device goes round such an area; 0 where it has every motor [J].
double predicted_energy(const Strategy& strategy, const Settings& settings, double area) noexcept;

// One loop of a device, as it was measured.
struct MeasuredLoop {
  double area = 0.0;    // S, counter-clockwise + [m²]
  double energy = 0.0;  // W over the loop [J]
};

// Fed with a device on its way round one loop.
class LoopEnergyMeter {
 public:
  // `device` is q_h [m], `energy` W since some start [J].
  LoopEnergyMeter(const Vector<2>& device, double energy) noexcept
      : start_(device), last_(device), first_energy_(energy), last_energy_(energy) {}

  void add(const Vector<2>& device, double energy) noexcept {
    const Vector<2> before = last_ - start_;
    const Vector<2> now = device - start_;
    twice_area_ += before.x * now.y - before.y * now.x;
    last_ = device;
    last_energy_ = energy;
  }

  // Of the path so far, closed by a straight line back to its start.
  MeasuredLoop loop() const noexcept { return {0.5 * twice_area_, last_energy_ - first_energy_}; }

 private:
  Vector<2> start_;
  Vector<2> last_;
  double first_energy_;
  double last_energy_;
  double twice_area_ = 0.0;
};

// Of one strategy. Areas and energies per turn, of the last one and the mean over all.
struct CircleEnergy {
  MeasuredLoop last;
  MeasuredLoop mean;
  double predicted = 0.0;    // predicted_energy() for the mean area [J]
  bool stays_inside = true;  // the device was in contact all the way; if not, the formula does not hold
};

struct CircleReading {
  Circle circle;
  int turns = 0;       // complete, under the present settings
  double share = 0.0;  // of the turn that is being measured; 0 before the first begins
  PerStrategy<CircleEnergy> strategies{};
};

// Fed with every tick's snapshot.
class CircleEnergyMeter {
 public:
  // Forgets all turns: another run, other settings, another circle.
  void start(const Settings& settings, const Circle& circle) noexcept;

  void add(const Snapshot& snapshot) noexcept;

  const CircleReading& reading() const noexcept { return reading_; }

 private:
  void begin_turn(const Snapshot& snapshot) noexcept;
  void end_turn() noexcept;

  Settings settings_;
  CircleReading reading_;
  double begins_s_ = -1.0;  // of the first turn; negative: not known yet
  double began_s_ = 0.0;    // of the turn that is being measured
  std::int64_t last_tick_ = 0;
  PerStrategy<std::optional<LoopEnergyMeter>> meters_{};
  PerStrategy<bool> in_contact_{};
};

}  // namespace ghostforce
