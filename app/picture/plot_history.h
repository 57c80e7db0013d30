// What the plots draw of the last minute or so: the quantities of every tick (PlotHistory), and how stiff the hand has
// been found to be (HandHistory). Bounded: a window that runs for days holds no more. One thread.
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "app/picture/glossary.h"
#include "core/hand_estimator.h"
#include "core/snapshot.h"

namespace ghostforce {

// Some ticks in a row: the least and the greatest of each value among them. NaN for what nobody knew in any of them.
struct PlotBucket {
  double from_s = 0.0;
  double to_s = 0.0;
  std::array<PerStrategy<double>, quantity_count> least{};  // [unit of the quantity]
  std::array<PerStrategy<double>, quantity_count> greatest{};
};

// Keeps the ticks at several degrees of coarseness, so that a plot costs the same whether it shows one second or all.
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

// How stiff the hand has been found to be, beside what was believed of it and, where that is known, what it was given.
struct HandPoint {
  double time_s = 0.0;                // model time
  HandEstimate estimate{};            // the newest by then
  double believed_k_u = 0.0;          // [N/m]
  std::optional<double> given_k_u{};  // of a simulated hand [N/m]; empty: nobody knows

  friend bool operator==(const HandPoint&, const HandPoint&) = default;
};

class HandHistory {
 public:
  // As long as the plots go back.
  static constexpr double span_s = 66.0;
  // Where nothing changes.
  static constexpr double interval_s = HandEstimator::period_s;
  static constexpr std::size_t most_points = 8192;

  // Of a tick. Every estimate and every other belief is a point; so is every interval_s.
  void add(const HandPoint& point);
  void clear() { points_.clear(); }

  bool is_empty() const noexcept { return points_.empty(); }
  // What lies between two times, oldest first, and one more on either side where there is one, so that a line through
  // them goes to the edges.
  std::vector<HandPoint> between(double from_s, double to_s) const;
  // The newest that is not after that time; null: there is none. Good until the next add() or clear().
  const HandPoint* at(double time_s) const;

 private:
  std::deque<HandPoint> points_;
};

}  // namespace ghostforce
