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

}  // namespace

void add_trails(const View& view, Marks& marks) {
  const auto& points = view.history.points();
  const LinePattern dots = scaled(dotted_line, view);
  for (std::size_t k = 1; k < points.size(); ++k) {
    marks.push_back(
        {Role::trail, std::nullopt,
         Line{points[k - 1].goal, points[k].goal, view.points(1.5),
              mix(view.theme.background, view.theme.faint_text, 0.55), dots, points[k - 1].goal_travelled}});
  }
  for_each_shown(view, [&](StrategyId id) {
    const std::size_t i = index_of(id);
    const bool front = view.in_front(id);
    const Colour colour = mix(view.theme.background, view.theme.strategy[i], front ? tint_in_front : tint_behind);
    const LinePattern pattern = scaled(strategy_style(id).pattern, view);
    for (std::size_t k = 1; k < points.size(); ++k) {
      marks.push_back({Role::trail, id,
                       Line{points[k - 1].device[i], points[k].device[i], view.points(front ? 2.4 : 1.8), colour,
                            pattern, points[k - 1].device_travelled[i]}});
    }
  });
}

}  // namespace ghostforce
