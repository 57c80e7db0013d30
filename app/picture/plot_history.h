// PlotHistory: the quantities of every tick of the last minute or so, kept at several degrees of coarseness, so that a
// plot costs the same whether it shows one second or all of them. Bounded: a window that runs for days holds no more.
// One thread.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "app/picture/quantities.h"
#include "core/snapshot.h"

namespace ghostforce {

// Some ticks in a row: the least and the greatest of each value among them. NaN for what nobody knew in any of them.
struct PlotBucket {
  double from_s = 0.0;
  double to_s = 0.0;
  std::array<PerStrategy<double>, quantity_count> least{};  // [unit of the quantity]
  std::array<PerStrategy<double>, quantity_count> greatest{};
};

class PlotHistory {
 public:
  static constexpr std::size_t capacity = 65536;  // ticks; over a minute at 1 kHz

  void add(const Snapshot& snapshot);
  void clear();

  bool is_empty() const noexcept { return newest_s_ < oldest_s_; }
  double oldest_s() const noexcept { return oldest_s_; }
  double newest_s() const noexcept { return newest_s_; }

  // What lies between two times, both included, oldest first: at most `most` buckets, and no fewer than a quarter of
  // that where there are as many ticks. Where `most` is large enough, a bucket is a tick.
  std::vector<PlotBucket> between(double from_s, double to_s, std::size_t most) const;

  // The tick that was the newest at that time; null before the first and after the last. Good until the next add() or
  // clear().
  const PlotBucket* at(double time_s) const;

 private:
  static constexpr std::size_t levels = 6;
  static constexpr std::size_t merged = 4;  // buckets of a level that make one of the next

  // A ring of buckets, each of so many ticks, and the one that is still being filled.
  struct Level {
    std::vector<PlotBucket> ring;
    std::size_t oldest = 0;
    PlotBucket filling;
    std::size_t filled = 0;  // ticks in it

    std::size_t size() const noexcept { return ring.size() + (filled > 0 ? 1 : 0); }
    const PlotBucket& at(std::size_t i) const noexcept {
      return i < ring.size() ? ring[(oldest + i) % ring.size()] : filling;
    }
  };

  std::array<Level, levels> levels_;
  double oldest_s_ = 0.0;
  double newest_s_ = -1.0;
};

}  // namespace ghostforce
