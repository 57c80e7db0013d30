// ServoThread: the 1 kHz thread, with the wait for its deadlines (HybridSleep) and the record of how late it came to
// them (LatencyHistogram). On it our code never allocates, locks, logs, throws, opens files or frees. Times in ns.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <thread>

#include "device/servo/servo_driver.h"

namespace ghostforce {

// How far behind their deadlines the ticks of a loop came: any percentile can be read to 1/32 of itself. A value; never
// allocates, locks or throws; one thread.
class LatencyHistogram {
 public:
  // What comes too soon is not late. More than 17 s counts as 17 s, except in worst_ns().
  void add(std::int64_t late_ns, std::uint64_t ticks = 1) noexcept {
    const auto late = static_cast<std::uint64_t>(std::max<std::int64_t>(late_ns, 0));
    counts_[index_of(std::min(late, longest))] += ticks;
    ticks_ += ticks;
    worst_ns_ = std::max(worst_ns_, static_cast<std::int64_t>(late));
  }

  std::uint64_t ticks() const noexcept { return ticks_; }
  std::int64_t worst_ns() const noexcept { return worst_ns_; }

  // What a share of the ticks does not exceed; 0 without ticks.
  std::int64_t percentile_ns(double share) const noexcept {
    const auto rank = static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(ticks_)));
    std::uint64_t seen = 0;
    for (std::size_t i = 0; i < counts_.size(); ++i) {
      seen += counts_[i];
      if (seen > 0 && seen >= rank) return std::min(greatest_of(i), worst_ns_);
    }
    return 0;
  }

 private:
  // The first 64 buckets are 1 ns wide, the next 32 2 ns, the next 32 4 ns …
  static constexpr std::size_t per_octave = 32;
  static constexpr std::size_t octaves = 30;
  static constexpr std::uint64_t longest = (std::uint64_t{1} << (octaves + 4)) - 1;

  static constexpr std::size_t index_of(std::uint64_t late) noexcept {
    const auto octave = static_cast<std::size_t>(std::bit_width(late | 63U)) - 6;
    return octave * per_octave + static_cast<std::size_t>(late >> octave);
  }
  static constexpr std::int64_t greatest_of(std::size_t index) noexcept {
    if (index < 2 * per_octave) return static_cast<std::int64_t>(index);
    const std::size_t octave = index / per_octave - 1;
    return (static_cast<std::int64_t>(index - octave * per_octave + 1) << octave) - 1;
  }

  std::array<std::uint64_t, octaves * per_octave> counts_{};
  std::uint64_t ticks_ = 0;
  std::int64_t worst_ns_ = 0;
};

// Waits for a deadline by sleeping until shortly before it and spinning the rest, which is more punctual than a system
// that wakes threads late. How long before is learnt from how late it was woken. Only for threads that cannot be
// preempted while they spin: among ordinary ones it makes things worse. A value that is told by its caller what the
// time is, by CLOCK_MONOTONIC, and how to sleep. Never allocates, locks or throws; one thread.
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

// Asks for real-time conditions first (ServoReport::realtime). With real-time priority it spins through what is left
// before a deadline; a device paces it instead. UI thread, but for what runs on the thread itself.
class ServoThread final : public ServoDriver {
 public:
  ServoThread() = default;
  ~ServoThread() override { ServoThread::stop(); }

  // Changes nothing while it runs. Throws std::system_error.
  void start(Servo& servo) override;
  // Returns when the thread has ended: within Servo::command_period_s, and what its device takes to be let go.
  void stop() noexcept override;

  // How late the ticks came since start(). While the thread is stopped.
  const LatencyHistogram& latency_histogram() const noexcept { return latency_histogram_; }

 private:
  void run(Servo& servo) noexcept;

  std::thread thread_;
  std::atomic<bool> stopping_{false};
  LatencyHistogram latency_histogram_;  // the thread's
};

}  // namespace ghostforce
