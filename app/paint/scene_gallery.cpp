#include "app/paint/scene_gallery.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "app/files/shipped_scenes.h"
#include "core/simulate.h"

namespace ghostforce {
namespace {

// What stays of the marks is where everything is: no forces, which would reach out of so small a picture, and none of
// what lies beside the scene.
bool belongs_to_scene(const Mark& mark) {
  switch (mark.role) {
    case Role::force:
    case Role::ghost_force:
    case Role::proxy_drift:
    case Role::handle:
    case Role::legend:
    case Role::motor_axis:
    case Role::scale:
      return false;
    default:
      return true;
  }
}

bool is_ground(const Mark& mark) {
  return mark.role == Role::wall || mark.role == Role::hatching || mark.role == Role::grid;
}

// Which way the hand takes, on the ground and under everything else.
void add_path(const Scene& scene, const Theme& theme, double width, Marks& marks) {
  auto place = std::ranges::find_if_not(marks, is_ground);
  const std::vector<Vector<2>>& points = scene.goal.points;
  for (std::size_t i = 1; i < points.size(); ++i) {
    place = marks.insert(
        place, {Role::trail, std::nullopt, Line{points[i - 1], points[i], width, theme.faint_text, dotted_line}});
  }
}

Pane pane_at_rest(const Scene& scene, const Theme& theme, const Vector<2>& size, double scale) {
  const Vector<2> goal = scene.goal.points.back();
  const Snapshot rest = snapshot_of(loop_coefficients_of(scene.settings), equilibrium_state(scene.settings, goal));
  const History nothing;
  const MeasureText no_words = [](std::string_view, const TextStyle&) { return Vector<2>(0.0); };
  std::vector<Pane> panes = compose_panes({.settings = scene.settings,
                                           .snapshot = rest,
                                           .history = nothing,
                                           .theme = theme,
                                           .options = {.predictions = false, .trails = false},
                                           .shown = scene.view,
                                           .size = size,
                                           .scale = scale,
                                           .measure = no_words});
  std::erase_if(panes.front().marks, [](const Mark& mark) { return !belongs_to_scene(mark); });
  add_path(scene, theme, 2.0 * scale, panes.front().marks);
  return std::move(panes.front());
}

}  // namespace

unsigned int SceneGallery::picture(std::size_t number, const Theme& theme, int width, int height, double scale) {
  return pictures_.picture(number, shipped_scenes().size(), theme, width, height, [&](std::size_t each) {
    return pane_at_rest(shipped_scenes()[each].scene, theme, {width, height}, scale);
  });
}

unsigned int PictureGallery::picture(std::size_t number, std::size_t count, const Theme& theme, int width, int height,
                                     const std::function<Pane(std::size_t)>& pane_of) {
  if (theme_ != theme || width_ != width || height_ != height) {
    theme_ = theme;
    width_ = width;
    height_ = height;
    pictures_.clear();
    for (std::size_t i = 0; i < count; ++i) pictures_.push_back(painter_.texture_of(pane_of(i), theme));
  }
  return pictures_[number].name();
}

}  // namespace ghostforce
