// Where goal and devices have been in the last seconds of model time: the longer ago, the paler.
#include <algorithm>
#include <deque>
#include <iterator>

#include "app/picture/layers.h"
#include "core/scene_shape.h"

namespace ghostforce {
namespace {

// Share of the strategy's colour in its trail, where it is newest; the rest is what lies below.
constexpr double tint_in_front = 0.75;
constexpr double tint_behind = 0.35;
constexpr double tint_of_goal = 0.55;

LinePattern scaled(const LinePattern& pattern, const View& view) {
  LinePattern result = pattern;
  for (double& length : result) length = view.points(length);
  return result;
}

// Each point of the trail with the one after it, and how much is left of its strength. (Counting through a deque divides
// at every step.)
template <typename Visit>
void for_each_step(const View& view, Visit&& visit) {
  const std::deque<HistoryPoint>& points = view.history.points();
  const double now_s = view.snapshot.time_s;
  const auto end = std::ranges::upper_bound(points, now_s, {}, &HistoryPoint::time_s);
  auto to = std::ranges::upper_bound(points.begin(), end, now_s - trail_lasts_s, {}, &HistoryPoint::time_s);
  if (to == points.begin() && to != end) ++to;
  for (; to != end; ++to) {
    const double age = (now_s - to->time_s) / trail_lasts_s;
    visit(*std::prev(to), *to, 1.0 - age * age);
  }
}

}  // namespace

void add_trails(const View& view, Marks& marks) {
  const LinePattern dots = scaled(dotted_line, view);
  // Mixed rather than let through, so that overlapping strokes do not darken.
  const auto on_ground = [&](const Vector<2>& at, Colour colour, double share) {
    return mix(depth_in_wall(view.settings, at) > 0.0 ? view.theme.wall : view.theme.background, colour, share);
  };
  for_each_step(view, [&](const HistoryPoint& from, const HistoryPoint& to, double strength) {
    const Colour colour = on_ground(to.goal, view.theme.faint_text, tint_of_goal * strength);
    marks.push_back(
        {Role::trail, std::nullopt, Line{from.goal, to.goal, view.points(1.5), colour, dots, from.goal_travelled}});
  });
  for_each_shown(view, [&](StrategyId id) {
    const std::size_t i = index_of(id);
    const bool front = view.in_front(id);
    const double tint = front ? tint_in_front : tint_behind;
    const LinePattern pattern = scaled(strategy_style(id).pattern, view);
    const double width = view.points(front ? 2.4 : 1.6);
    for_each_step(view, [&](const HistoryPoint& from, const HistoryPoint& to, double strength) {
      const Colour colour = on_ground(to.device[i], view.theme.strategy[i], tint * strength);
      marks.push_back(
          {Role::trail, id, Line{from.device[i], to.device[i], width, colour, pattern, from.device_travelled[i]}});
    });
  });
}

}  // namespace ghostforce
