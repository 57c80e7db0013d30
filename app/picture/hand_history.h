// HandHistory: how stiff the hand has been found to be over the last minute, beside what was believed of it and, where
// that is known, what it was given. Bounded: a window that runs for days holds no more. One thread.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "core/hand_reading.h"

namespace ghostforce {

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
