// Pacer: when the next tick is due, by absolute deadlines on a grid, and how well they are kept. A value that is told
// the time; it reads no clock and never sleeps, so tests step it by hand. Times in ns of CLOCK_MONOTONIC, periods in s.
// Never allocates, locks or throws; one thread.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace ghostforce {

class Pacer {
 public:
  // The rate is measured over at least this long [s].
  static constexpr double rate_window_s = 0.5;

  // The first deadline is one period from now.
  Pacer(std::int64_t now_ns, double period_s) noexcept : period_ns_(period_s * 1e9) { align(now_ns); }

  std::int64_t deadline_ns() const noexcept { return on_grid(next_); }
  std::int64_t period_ns() const noexcept { return std::llround(period_ns_); }

  // Whether a tick is due: true once per deadline that is kept. Coming late by more than a period skips the deadlines
  // that have passed meanwhile, counts them and stays on the grid: ticks never come in a burst.
  bool is_due(std::int64_t now_ns) noexcept {
    const auto late_ns = static_cast<double>(now_ns - deadline_ns());
    if (late_ns < 0.0) return false;
    const auto skipped = static_cast<std::int64_t>(late_ns / period_ns_);
    late_ticks_ += static_cast<std::uint64_t>(skipped);
    worst_late_s_ = std::max(worst_late_s_, late_ns * 1e-9);
    next_ += 1 + skipped;
    measure_rate(now_ns);
    return true;
  }

  // Another period: the next deadline is one of them after the last one, or now if that has passed.
  void set_period(double period_s, std::int64_t now_ns) noexcept {
    const double period_ns = period_s * 1e9;
    if (period_ns == period_ns_) return;
    const std::int64_t last_ns = on_grid(next_ - 1);
    period_ns_ = period_ns;
    origin_ns_ = std::max<std::int64_t>(last_ns, now_ns - std::llround(period_ns));
    next_ = 1;
  }

  // For a loop that keeps time with a device: one that came late by more than a tenth of a period sets the rhythm from
  // now on. Of a tick that was kept.
  void follow(std::int64_t now_ns) noexcept {
    if (static_cast<double>(now_ns - on_grid(next_ - 1)) <= 0.1 * period_ns_) return;
    origin_ns_ = now_ns;
    next_ = 1;
  }

  // While nothing is to be paced: the next deadline is one period from now, and the rate is 0.
  void align(std::int64_t now_ns) noexcept {
    origin_ns_ = now_ns;
    next_ = 1;
    rate_hz_ = 0.0;
    window_start_ns_ = now_ns;
    window_ticks_ = 0;
  }

  // That much time is left out, because nobody could have ticked in it: all deadlines come later by it, and none has been
  // skipped. A little of it is part of the rate; after more than the rate is measured over, that is measured anew.
  void leave_out(std::int64_t duration_ns) noexcept {
    origin_ns_ += duration_ns;
    if (static_cast<double>(duration_ns) * 1e-9 < rate_window_s) return;
    window_start_ns_ = on_grid(next_ - 1);
    window_ticks_ = 0;
  }

  std::uint64_t late_ticks() const noexcept { return late_ticks_; }  // deadlines skipped
  double worst_late_s() const noexcept { return worst_late_s_; }     // behind a deadline that was kept or skipped [s]
  double rate_hz() const noexcept { return rate_hz_; }               // measured; 0 until the first window is full

 private:
  // Rounded once, never accumulated.
  std::int64_t on_grid(std::int64_t index) const noexcept {
    return origin_ns_ + std::llround(static_cast<double>(index) * period_ns_);
  }

  void measure_rate(std::int64_t now_ns) noexcept {
    ++window_ticks_;
    const double window_s = static_cast<double>(now_ns - window_start_ns_) * 1e-9;
    if (window_s < rate_window_s) return;
    rate_hz_ = static_cast<double>(window_ticks_) / window_s;
    window_start_ns_ = now_ns;
    window_ticks_ = 0;
  }

  double period_ns_;
  std::int64_t origin_ns_ = 0;  // of the grid
  std::int64_t next_ = 1;       // the deadline to come, counted from the origin
  std::uint64_t late_ticks_ = 0;
  double worst_late_s_ = 0.0;
  double rate_hz_ = 0.0;
  std::int64_t window_start_ns_ = 0;
  std::int64_t window_ticks_ = 0;
};

}  // namespace ghostforce
