// A sine that is the same to the last bit wherever the program runs: the mathematical libraries of systems and browsers
// round theirs differently. Pure, never allocates or throws; any thread.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace ghostforce {

// Of an angle in turns; within 4e-16 of the true one [1]. Whole turns are taken off exactly.
inline double sine_of_turns(double turns) noexcept {
  double part = turns - std::round(turns);  // -0.5 to 0.5
  // The sine is the same at equal distances from a quarter turn, so that the series is short.
  if (part > 0.25) part = 0.5 - part;
  if (part < -0.25) part = -0.5 - part;
  // Taylor's, to the power of 21: the next term would be less than a hundredth of the last bit.
  constexpr auto coefficients = [] {
    std::array<double, 11> all{};
    double coefficient = 1.0;
    for (int i = 0; i < 11; ++i) {
      all[static_cast<std::size_t>(i)] = coefficient;
      coefficient /= -static_cast<double>((2 * i + 2) * (2 * i + 3));
    }
    return all;
  }();
  const double angle = 2.0 * std::numbers::pi * part;
  const double square = angle * angle;
  double sum = coefficients.back();
  for (std::size_t i = coefficients.size() - 1; i-- > 0;) sum = coefficients[i] + sum * square;
  return sum * angle;
}

}  // namespace ghostforce
