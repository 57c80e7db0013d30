// MotorHeat: how warm what a motor was told to give has made it, as an estimate. No temperature is measured.
//
// A winding is heated by the square of its current, and the current is proportional to what the motor is told to give;
// the heat leaves it in proportion to how much warmer than its surroundings it is:
//     τ dh/dt = (f/f_c)² − h
// h = 1 is as warm as it becomes in the end where it gives f_c all the time, which it may give for ever. One time
// constant stands for winding and case alike, and none of this knows how warm the room or the case is already.
//
// Left alone, it cools from h to h₀ in τ ln(h/h₀).
//
// A plain value; SI units; never allocates or throws; any one thread.
#pragma once

#include <array>
#include <cmath>
#include <type_traits>

namespace ghostforce {

// Of small motors with brushes, where nobody has published better: assumed.
inline constexpr double motor_heat_time_constant_s = 60.0;   // τ
inline constexpr double motor_continuous_share = 1.0 / 4.0;  // f_c, of the most that the motor can be told to give

// Of each motor of a device; 0 where it has fewer.
using MotorHeats = std::array<double, 3>;

// How long a motor has to give nothing until its heat is half of what it may have for ever [s].
inline double motor_rest_s(double heat) noexcept {
  constexpr double rested = 0.5;
  return heat > rested ? motor_heat_time_constant_s * std::log(heat / rested) : 0.0;
}

class MotorHeat {
 public:
  // The motor was told to give that share of the most that it can, for so long. Exact, however long.
  void hold(double share, double elapsed_s) noexcept {
    if (!(elapsed_s > 0.0) || !std::isfinite(share)) return;
    const double load = share / motor_continuous_share;
    const double in_the_end = load * load;
    heat_ = in_the_end + (heat_ - in_the_end) * std::exp(-elapsed_s / motor_heat_time_constant_s);
  }

  // h [1].
  double heat() const noexcept { return heat_; }

 private:
  double heat_ = 0.0;
};
static_assert(std::is_trivially_copyable_v<MotorHeat>);

}  // namespace ghostforce
