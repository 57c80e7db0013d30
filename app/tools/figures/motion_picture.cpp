#include "app/tools/figures/scene_pane.h"

#include <utility>

namespace ghostforce {
namespace {

FigurePoint proxy_point(StrategyId id, const Vector<2>& at) {
  return {.at = at,
          .shape = strategy_style(id).shape,
          .fill = paper().background,
          .rim = paper().strategy[index_of(id)],
          .radius = 4.2};
}

}  // namespace

ScenePicture picture_of(const SimulatedMotion& motion, const std::string& start, const std::string& goal) {
  ScenePicture picture{.title = motion.name, .settings = last_settings(motion)};
  Trail way{.points = {}, .colour = paper().faint_text, .pattern = dotted_line, .width = 1.6};
  for (const Snapshot& moment : motion.moments) way.points.push_back(moment.goal);
  picture.trails.push_back(std::move(way));
  const Snapshot& last = motion.moments.back();
  for (const Strategy& strategy : strategy_catalog()) {
    const std::size_t i = index_of(strategy.id);
    std::vector<Vector<2>> points;
    for (const Snapshot& moment : motion.moments) points.push_back(moment.strategies[i].device);
    picture.trails.push_back(device_trail(strategy.id, std::move(points)));
    const StrategySnapshot<2>& now = last.strategies[i];
    if (now.in_contact) picture.points.push_back(proxy_point(strategy.id, now.proxy));
  }
  for (const Strategy& strategy : strategy_catalog()) {
    picture.points.push_back(
        device_point(strategy.id, last.strategies[index_of(strategy.id)].device, std::string(1, strategy.letter)));
  }
  if (!start.empty()) {
    picture.points.push_back({.at = motion.moments.front().goal,
                              .fill = paper().background,
                              .rim = paper().text,
                              .radius = 3.5,
                              .name = start});
  }
  picture.points.push_back(goal_point(last.goal, goal));
  return picture;
}

std::vector<LegendEntry> motion_legend() {
  std::vector<LegendEntry> entries = strategy_legend();
  entries.push_back({.name = "hand's goal", .colour = paper().goal_rim, .has_line = true, .pattern = dotted_line});
  entries.push_back({.name = "proxies at rest", .colour = paper().faint_text, .shape = Shape::disc, .is_hollow = true});
  return entries;
}

void add_scenes(Sheet& sheet, double height, std::vector<ScenePicture> pictures, std::size_t per_row) {
  const Frame frame = frame_for(pictures, sheet.place_size(height, per_row));
  pictures.front().has_scale = true;
  for (std::size_t first = 0; first < pictures.size(); first += per_row) {
    std::vector<std::string> titles;
    for (std::size_t i = 0; i < per_row; ++i) titles.push_back(pictures[first + i].title);
    if (!titles.front().empty()) sheet.add_titles(titles);
    sheet.add_row(height, per_row, [&](const Place& place, std::size_t number) {
      return scene_pane(pictures[first + number], place, frame.centers[first + number], frame.points_per_metre);
    });
  }
}

}  // namespace ghostforce
