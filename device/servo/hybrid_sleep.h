// HybridSleep: waits for a deadline by sleeping until shortly before it and spinning the rest, which is more punctual
// than a system that wakes threads late. How long before is learnt from how late it was woken. Only for threads that
// cannot be preempted while they spin: among ordinary ones it makes things worse. A value that is told by its caller
// what the time is and how to sleep. Never allocates, locks or throws; one thread; times in ns of CLOCK_MONOTONIC.
#pragma once

#include <algorithm>
#include <cstdint>

namespace ghostforce {

class HybridSleep {
 public:
  // Spinning never takes more than this share of the time, on average [1], …
  static constexpr double greatest_share = 0.035;
  // … nor more than that per deadline, on average, …
  static constexpr std::int64_t greatest_mean_spin_ns = 50'000;
  // … and once never more than this share of a period [1].
  static constexpr double greatest_margin = 0.25;

  explicit HybridSleep(std::int64_t period_ns) noexcept { set_period(period_ns); }

  // Between deadlines. Another period begins with as much spinning as it may have.
  void set_period(std::int64_t period_ns) noexcept {
    if (period_ns == period_ns_) return;
    period_ns_ = period_ns;
    const auto share_of_period = [period_ns](double share) {
      return static_cast<std::int64_t>(share * static_cast<double>(period_ns));
    };
    mean_spin_ns_ = std::min(greatest_mean_spin_ns, share_of_period(greatest_share));
    longest_ns_ = share_of_period(greatest_margin);
    mean_overslept_ns_ = 0.0;
    margin_ns_ = std::min(mean_spin_ns_, longest_ns_);
  }

  // How long before a deadline it wants to be woken.
  std::int64_t margin_ns() const noexcept { return margin_ns_; }

  // Returns the time when it is over: not before `deadline_ns`. `clock` has now_ns() and sleep_until(ns), which may
  // wake late, and too soon as well.
  template <typename Clock>
  std::int64_t until(std::int64_t deadline_ns, Clock&& clock) noexcept {
    const std::int64_t wanted_ns = deadline_ns - margin_ns_;
    std::int64_t now = clock.now_ns();
    while (now < wanted_ns) {
      clock.sleep_until(wanted_ns);
      now = clock.now_ns();
      if (now >= wanted_ns) learn(now - wanted_ns);
    }
    while (now < deadline_ns) now = clock.now_ns();
    return now;
  }

 private:
  // A missed deadline moves the margin up so much, and a kept one moves it down so little, that one in 2000 is missed.
  static constexpr std::int64_t step_up_ns = 4'000;
  static constexpr std::int64_t step_down_ns = 2;
  static constexpr double newest_weight = 1.0 / 256.0;

  // margin − overslept is what will be spun. If that is negative, nothing is: so the mean is one of what was overslept
  // within the margin, and the mean of what is spun is the margin less that mean.
  void learn(std::int64_t overslept_ns) noexcept {
    const std::int64_t within_ns = std::min(overslept_ns, margin_ns_);
    mean_overslept_ns_ += newest_weight * (static_cast<double>(within_ns) - mean_overslept_ns_);
    margin_ns_ += overslept_ns > margin_ns_ ? step_up_ns : -step_down_ns;
    const std::int64_t affordable_ns = static_cast<std::int64_t>(mean_overslept_ns_) + mean_spin_ns_;
    margin_ns_ = std::clamp<std::int64_t>(margin_ns_, 0, std::min(affordable_ns, longest_ns_));
  }

  std::int64_t period_ns_ = 0;
  std::int64_t mean_spin_ns_ = 0;  // at most
  std::int64_t longest_ns_ = 0;    // the margin at most
  double mean_overslept_ns_ = 0.0;
  std::int64_t margin_ns_ = 0;
};

}  // namespace ghostforce
