#include "app/picture/pane_views.h"

#include <algorithm>
#include <vector>

#include <glm/geometric.hpp>

#include "app/picture/camera.h"
#include "core/scene_shape.h"

namespace ghostforce {
namespace {

constexpr double share_of_longest = 0.4;  // of the longest arrow, of a pane's width
constexpr double usual_depth = 0.02;      // of a goal in the wall, where nothing pushes yet [m]
constexpr double least_shown = 0.012;     // across [m]
// Round what is shown: for markers and their words, above that for the title, below for dial and scale bars [points].
constexpr double room_beside = 30.0;
constexpr double room_above = 60.0;
constexpr double room_below = 110.0;
constexpr double ruler_reach = 40.0;  // of the drift's ruler from the wall

double longest_force(const Settings& settings, const Snapshot& snapshot) {
  double longest = 0.0;
  for (const StrategySnapshot<2>& now : snapshot.strategies) {
    if (now.in_contact) longest = std::max(longest, glm::length(now.force));
  }
  if (longest > 0.0) return longest;
  const Vector<2> normal = wall_near(settings, snapshot.goal).normal;
  const Vector<2> goal = foot_on_edge(settings, snapshot.goal) - normal * usual_depth;
  for (const Strategy& entry : strategy_catalog()) {
    if (const auto rest = rest_of(entry.id, settings, goal)) longest = std::max(longest, glm::length(rest->at.force));
  }
  constexpr double any = 1.0;  // where no force ever is [N]
  return longest > 0.0 ? longest : any;
}

}  // namespace

PaneViews fitted_pane_views(const Settings& settings, const Snapshot& snapshot, const Vector<2>& pane_size, double unit,
                            double arrow_scale) noexcept {
  PaneViews views{
      .width = 0.0, .centers = {}, .share_per_newton = share_of_longest / longest_force(settings, snapshot)};
  const Vector<2> out = to_screen_direction(wall_near(settings, snapshot.goal).normal) * (ruler_reach * unit);
  PerStrategy<std::vector<FitPoint>> points;
  for (std::size_t i = 0; i < strategy_count; ++i) {
    const StrategySnapshot<2>& now = snapshot.strategies[i];
    points[i] = {{snapshot.goal}, {now.device}, {foot_on_edge(settings, snapshot.goal), out}};
    if (!now.in_contact) continue;
    points[i].push_back({now.proxy});
    points[i].push_back({now.contact, out});
    const double per_newton = views.share_per_newton * pane_size.x * arrow_scale;
    points[i].push_back({now.device, to_screen_direction(now.force) * per_newton});
  }
  const Vector<2> wanted(2.0 * room_beside * unit, (room_above + room_below) * unit);
  const Vector<2> room = glm::max(pane_size - wanted, 0.35 * pane_size);
  double scale = room.x / least_shown;
  for (const auto& each : points) scale = fitting_scale(each, room, scale);
  // As camera_on() has it.
  views.width = std::min(pane_size.x, pane_size.y / 0.75) / scale;
  const double up = std::min(0.5 * (room_below - room_above) * unit, 0.1 * pane_size.y);
  for (std::size_t i = 0; i < strategy_count; ++i) {
    views.centers[i] = fitting_center(points[i], scale) - Vector<2>(0.0, up / scale);
  }
  return views;
}

}  // namespace ghostforce
