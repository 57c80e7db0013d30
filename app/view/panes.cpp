#include "app/view/panes.h"

#include <algorithm>
#include <utility>

namespace ghostforce {
namespace {

constexpr double gap = 2.0;  // between panes [points]

Pane compose_pane(const PictureContent& content, const Settings& settings, const Vector<2>& corner,
                  const Vector<2>& size, bool is_pane, bool has_scales, Marks earlier) {
  Pane pane{corner, camera_on(content.shown.center, content.shown.width, size), settings.active, {}};
  pane.marks = compose({.settings = settings,
                        .snapshot = content.snapshot,
                        .history = content.history,
                        .theme = content.theme,
                        .camera = pane.camera,
                        .options = content.options,
                        .scale = content.scale,
                        .measure = content.measure,
                        .has_handles = content.has_handles,
                        .hovered = content.hovered,
                        .is_goal_hot = content.is_goal_hot,
                        .is_pane = is_pane,
                        .has_scales = has_scales,
                        .turn_s = content.turn_s,
                        .target = content.target},
                       std::move(earlier));
  return pane;
}

}  // namespace

std::vector<Pane> compose_panes(const PictureContent& content, std::vector<Pane> earlier) {
  std::vector<Pane> panes;
  const auto marks_of_earlier = [&](std::size_t place) {
    return place < earlier.size() ? std::move(earlier[place].marks) : Marks();
  };
  if (content.options.compare != Compare::side_by_side) {
    panes.push_back(
        compose_pane(content, content.settings, Vector<2>(0.0), content.size, false, true, marks_of_earlier(0)));
    return panes;
  }
  const double between = gap * content.scale;
  const double count = static_cast<double>(strategy_count);
  const Vector<2> size{std::max(1.0, (content.size.x - (count - 1.0) * between) / count), content.size.y};
  for (const Strategy& entry : strategy_catalog()) {
    Settings settings = content.settings;
    settings.active = entry.id;
    const double place = static_cast<double>(index_of(entry.id));
    panes.push_back(compose_pane(content, settings, {place * (size.x + between), 0.0}, size, true, place == 0.0,
                                 marks_of_earlier(index_of(entry.id))));
  }
  return panes;
}

const Pane& pane_at(const std::vector<Pane>& panes, const Vector<2>& point) {
  const auto distance = [&](const Pane& pane) {
    return glm::distance(point, glm::clamp(point, pane.corner, pane.corner + pane.camera.size));
  };
  return *std::ranges::min_element(panes, {}, distance);
}

}  // namespace ghostforce
