// History: where goal and devices have been, as far as a trail can show it, what the plots show, what was known of the
// hand, and the moments that a person can look back at. Bounded: a window that runs for days holds no more than one that
// runs for a minute. One thread.
#pragma once

#include <cstddef>
#include <deque>

#include "app/picture/moment_history.h"
#include "app/picture/plot_history.h"
#include "core/snapshot.h"

namespace ghostforce {

struct HistoryPoint {
  double time_s;                         // model time
  Vector<2> goal;                        // [m]
  double goal_travelled;                 // length of the goal's path up to here [m]
  PerStrategy<Vector<2>> device;         // [m]
  PerStrategy<double> device_travelled;  // [m]
};

// A trail shows so much of the model time before the moment of the picture.
inline constexpr double trail_lasts_s = 3.0;

class History {
 public:
  // Points are at least so far apart, in time and in place.
  static constexpr double least_interval_s = 0.008;
  static constexpr double spacing = 0.0004;  // [m]
  // Of a minute, so that whoever looks back finds the trail of that moment.
  static constexpr std::size_t most_points = 7500;

  void add(const Snapshot& snapshot);
  // The same, and it can be looked back at; `settings`: those under which this tick ran.
  void add(const Snapshot& snapshot, const Settings& settings);
  // What is known of the hand at that tick.
  void add(const HandPoint& point) { hand_.add(point); }
  void clear();
  const std::deque<HistoryPoint>& points() const noexcept { return points_; }
  // Whether a picture of that moment has a trail.
  bool has_trail_at(double time_s) const noexcept;
  const PlotHistory& plots() const noexcept { return plots_; }
  const MomentHistory& moments() const noexcept { return moments_; }
  const HandHistory& hand() const noexcept { return hand_; }

 private:
  std::deque<HistoryPoint> points_;
  PlotHistory plots_;
  MomentHistory moments_;
  HandHistory hand_;
};

}  // namespace ghostforce
