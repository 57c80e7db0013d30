#include "app/figures/one_hand.h"

#include <span>
#include <string_view>
#include <utility>

#include "app/chart/chart.h"
#include "app/figures/motion_picture.h"
#include "app/paint/vector_painter.h"
#include "app/scene_file.h"
#include "core/simulated_hand.h"

namespace ghostforce {
namespace {

constexpr std::string_view scene_name = "wall45";

// Into the wall, along it, out, and to rest inside.
Scene simulated_scene() {
  Scene scene = load_scene(std::string(scene_name));
  scene.duration = 5.0;
  const GoalPath aim{.points = {{-0.045, 0.030}, {0.010, -0.020}, {0.045, 0.015}, {0.010, 0.050}, {0.030, -0.010}},
                     .times = {0.0, 1.0, 2.0, 3.0, 4.0},
                     .motion = Motion::minimum_jerk};
  scene.goal = simulated_hand(aim, {.seed = figure_seed}, scene.duration, scene.settings.rate);
  return scene;
}

Chart force_chart(const PlayedMotion& motion) {
  Chart chart;
  chart.title = "Force along the motor axis";
  chart.x = {.title = "time [s]", .range = Vector<2>(0.0, motion.scene.duration)};
  chart.y = {.title = "force [N]"};
  const Vector<2> axis = direction_at(motion.scene.settings.actuated_angle);
  for (const Strategy& strategy : strategy_catalog()) {
    const std::size_t i = index_of(strategy.id);
    Series series{
        .name = "", .colour = paper().strategy[i], .points = {}, .pattern = strategy_style(strategy.id).pattern};
    series.width = device_trail(strategy.id, {}).width * 0.8;
    for (const Snapshot& moment : motion.moments) {
      series.points.push_back({moment.time_s, glm::dot(axis, moment.strategies[i].force)});
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

}  // namespace

PlayedMotion one_hand(const FigureRequest& request) {
  if (!request.hand) return play_motion("", simulated_scene());
  Scene scene = request.hand->scene;
  scene.goal = request.hand->path;
  scene.duration = scene.goal.times.back();
  return play_motion("", scene);
}

Figure one_hand_figure(const FigureRequest& request) {
  const PlayedMotion motion = one_hand(request);
  Sheet sheet("One hand, three strategies", 900.0);
  ScenePicture picture = picture_of(motion, "", "");
  picture.has_scale = true;
  constexpr double height = 400.0;
  const Frame frame = frame_for(std::span(&picture, 1), sheet.place_size(height, 2));
  sheet.add_row(height, 2, [&](const Place& place, std::size_t number) {
    return number == 0 ? scene_pane(picture, place, frame.centers.front(), frame.points_per_metre)
                       : chart_pane(force_chart(motion), place.corner, place.size, paper(), 1.0, measure_vector_text);
  });
  sheet.add_legend(motion_legend());
  std::string hand = "A simulated hand (minimum jerk, tremor at 8 to 12 Hz)";
  if (request.hand) hand = request.hand->is_estimated ? "A recorded hand, its goal inferred," : "A recorded hand";
  return sheet.finish(hand +
                          " and where it takes the device under each strategy. Along the motor axis A feels as F "
                          "does at rest; N is pulled away by a force that the wall should not have.",
                      request.hand ? "of " + request.hand->name : std::string(scene_name),
                      table_of(std::span(&motion, 1)));
}

}  // namespace ghostforce
