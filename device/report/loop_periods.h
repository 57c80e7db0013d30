// LoopPeriods: how long the loop took from one tick to the next, counted on a fixed logarithmic scale, with the longest
// and how many ticks were late. A value that is told the time, trivially copyable: it crosses threads whole. Never
// allocates or throws. SI units.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace ghostforce {

class LoopPeriods {
 public:
  // Two an octave; 1 ms is in the middle of one. All that is shorter or longer counts in the first or last.
  static constexpr std::size_t bin_count = 24;

  // `is_late`: by a whole period or more.
  void add(double period_s, bool is_late) noexcept {
    const double bin = std::floor(2.0 * std::log2(period_s / middle_s) + 0.5) + middle_bin;
    ++counts_[static_cast<std::size_t>(std::clamp(bin, 0.0, bin_count - 1.0))];
    ++ticks_;
    if (is_late) ++late_ticks_;
    sum_s_ += period_s;
    worst_s_ = std::max(worst_s_, period_s);
  }

  std::uint64_t ticks() const noexcept { return ticks_; }
  std::uint64_t late_ticks() const noexcept { return late_ticks_; }
  std::uint64_t count(std::size_t bin) const noexcept { return counts_[bin]; }
  double worst_s() const noexcept { return worst_s_; }
  // All of these are 0 without ticks.
  double late_share() const noexcept {
    return ticks_ > 0 ? static_cast<double>(late_ticks_) / static_cast<double>(ticks_) : 0.0;
  }
  double mean_hz() const noexcept { return ticks_ > 0 ? static_cast<double>(ticks_) / sum_s_ : 0.0; }

  // Where the bin begins, and the one before it ends [s].
  static double begin_of(std::size_t bin) noexcept {
    return middle_s * std::exp2(0.5 * (static_cast<double>(bin) - middle_bin - 0.5));
  }

 private:
  static constexpr double middle_s = 0.001;
  static constexpr double middle_bin = 9.0;

  std::array<std::uint64_t, bin_count> counts_{};
  std::uint64_t ticks_ = 0;
  std::uint64_t late_ticks_ = 0;
  double sum_s_ = 0.0;
  double worst_s_ = 0.0;
};
static_assert(std::is_trivially_copyable_v<LoopPeriods>);

}  // namespace ghostforce
