// History: where goal and devices have been, thinned out to what a trail needs, what the plots show, and the moments that
// a person can look back at. Bounded: a window that runs for days holds no more than one that runs for seconds. One
// thread.
#pragma once

#include <cstddef>
#include <deque>

#include "app/view/moment_history.h"
#include "app/view/plot_history.h"
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
  // A trail is a chain of this many points at most, each at least `spacing` from the one before. Only the newest
  // `dense_points` are all there: of the older ones those are left out that lie on a straight line between their
  // neighbours, to `straightness`, as long as pieces do not become longer than `longest_piece`: a trail is 0.15 m long
  // where the hand curves all the way, 0.24 m where it goes straight.
  static constexpr std::size_t most_points = 375;
  static constexpr std::size_t dense_points = 300;
  static constexpr double spacing = 0.0004;  // [m]
  // [m], an eighth of a pixel in the view that scenes open with; up to three times that as pieces are joined again.
  static constexpr double straightness = 0.00003;
  static constexpr double longest_piece = 4.0 * spacing;

  void add(const Snapshot& snapshot);
  // The same, and it can be looked back at; `settings`: those under which this tick ran.
  void add(const Snapshot& snapshot, const Settings& settings);
  void clear();
  const std::deque<HistoryPoint>& points() const noexcept { return points_; }
  const PlotHistory& plots() const noexcept { return plots_; }
  const MomentHistory& moments() const noexcept { return moments_; }

 private:
  void thin_out();

  std::deque<HistoryPoint> points_;
  PlotHistory plots_;
  MomentHistory moments_;
};

}  // namespace ghostforce
