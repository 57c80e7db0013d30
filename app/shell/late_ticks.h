// LateTicks: how often the loop came too late, of what it counts since its thread was started. What happens while a device
// is looked for or opened is left out. A value; it reads no clock.
#pragma once

#include <cstdint>
#include <deque>

namespace ghostforce {

class LateTicks {
 public:
  explicit LateTicks(double lately_s) noexcept : lately_s_(lately_s) {}

  // `counted`: the loop's own count by now; a smaller one than before is a new loop's. `interval_s`: since the last call.
  void note(std::uint64_t counted, bool is_opening, double interval_s);

  std::uint64_t all() const noexcept { return all_; }
  // In the last `lately_s`.
  std::uint64_t lately() const noexcept { return lately_; }

 private:
  struct Burst {
    double at_s;
    std::uint64_t ticks;
  };

  double lately_s_;
  double clock_s_ = 0.0;
  std::uint64_t counted_ = 0;
  bool is_opening_ = false;
  std::uint64_t all_ = 0;
  std::uint64_t lately_ = 0;
  std::deque<Burst> bursts_;  // that lately_ is the sum of
};

}  // namespace ghostforce
