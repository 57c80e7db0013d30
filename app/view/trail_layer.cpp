#include <deque>
#include <iterator>

#include "app/view/layers.h"

namespace ghostforce {
namespace {

// Share of the strategy's colour in its trail; the rest is background.
constexpr double tint_in_front = 0.75;
constexpr double tint_behind = 0.45;

LinePattern scaled(const LinePattern& pattern, const View& view) {
  LinePattern result = pattern;
  for (double& length : result) length = view.points(length);
  return result;
}

// Each point with the one after it. (Counting through a deque divides at every step.)
template <typename Visit>
void for_each_step(const std::deque<HistoryPoint>& points, Visit&& visit) {
  if (points.empty()) return;
  for (auto from = points.begin(), to = std::next(from); to != points.end(); from = to++) visit(*from, *to);
}

}  // namespace

void add_trails(const View& view, Marks& marks) {
  const auto& points = view.history.points();
  const LinePattern dots = scaled(dotted_line, view);
  const Colour goal_colour = mix(view.theme.background, view.theme.faint_text, 0.55);
  for_each_step(points, [&](const HistoryPoint& from, const HistoryPoint& to) {
    marks.push_back({Role::trail, std::nullopt,
                     Line{from.goal, to.goal, view.points(1.5), goal_colour, dots, from.goal_travelled}});
  });
  for_each_shown(view, [&](StrategyId id) {
    const std::size_t i = index_of(id);
    const bool front = view.in_front(id);
    const Colour colour = mix(view.theme.background, view.theme.strategy[i], front ? tint_in_front : tint_behind);
    const LinePattern pattern = scaled(strategy_style(id).pattern, view);
    const double width = view.points(front ? 2.4 : 1.8);
    for_each_step(points, [&](const HistoryPoint& from, const HistoryPoint& to) {
      marks.push_back(
          {Role::trail, id, Line{from.device[i], to.device[i], width, colour, pattern, from.device_travelled[i]}});
    });
  });
}

}  // namespace ghostforce
