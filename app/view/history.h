// History: where goal and devices have been, thinned out to what a trail needs, and what the plots show. Bounded: a
// window that runs for days holds no more than one that runs for seconds. One thread.
#pragma once

#include <cstddef>
#include <deque>

#include "app/plots/plot_history.h"
#include "core/snapshot.h"

namespace ghostforce {

struct HistoryPoint {
  Vector<2> goal;                        // [m]
  double goal_travelled;                 // length of the goal's path up to here [m]
  PerStrategy<Vector<2>> device;         // [m]
  PerStrategy<double> device_travelled;  // [m]
};

class History {
 public:
  // A trail is a chain of this many points at most, each at least `spacing` from the one before.
  static constexpr std::size_t most_points = 600;
  static constexpr double spacing = 0.0004;  // [m]

  void add(const Snapshot& snapshot);
  void clear();
  const std::deque<HistoryPoint>& points() const noexcept { return points_; }
  const PlotHistory& plots() const noexcept { return plots_; }

 private:
  std::deque<HistoryPoint> points_;
  PlotHistory plots_;
};

}  // namespace ghostforce
