#include "app/tools/figures/figures.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "app/files/scene_file.h"
#include "app/tools/figures/scene_pane.h"
#include "core/conventions.h"
#include "core/tremor_and_drift.h"

namespace ghostforce {
namespace {

constexpr std::string_view figure_6_scene = "wall45";

// Into the wall, along it, out, and to rest inside.
GoalPath simulated_aim() {
  return {.points = {{-0.045, 0.030}, {0.010, -0.020}, {0.045, 0.015}, {0.010, 0.050}, {0.030, -0.010}},
          .times = {0.0, 1.0, 2.0, 3.0, 4.0},
          .motion = Motion::minimum_jerk};
}

Scene simulated_scene() {
  Scene scene = load_scene(std::string(figure_6_scene));
  scene.duration = 5.0;
  scene.goal = simulated_hand(simulated_aim(), {.seed = figure_seed}, scene.duration, scene.settings.rate);
  return scene;
}

Chart force_chart(const SimulatedMotion& motion) {
  Chart chart;
  chart.title = "Force along the actuated direction";
  chart.x = {.title = "time [s]", .range = Vector<2>(0.0, motion.scene.duration)};
  chart.y = {.title = "force [N]"};
  for (const Strategy& strategy : strategy_catalog()) {
    const std::size_t i = index_of(strategy.id);
    Series series{
        .name = "", .colour = paper().strategy[i], .points = {}, .pattern = strategy_style(strategy.id).pattern};
    series.width = device_trail(strategy.id, {}).width * 0.8;
    for (const Snapshot& moment : motion.moments) {
      const Vector<2> axis = direction_at(settings_at(motion, moment.time_s).actuated_angle);
      series.points.push_back({moment.time_s, glm::dot(axis, moment.strategies[i].force)});
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

// What the hand feels at rest along the motor, over all goals that it comes by.
struct Feeling {
  bool presses = false;    // some goal is inside the wall
  double full_N = 0.0;     // greatest force of F
  double naive_N = 0.0;    // greatest that N has more
  double cure_N = 0.0;     // and A
  bool sees_move = false;  // wall or motor are not always in one place
};

Feeling feeling_of(const SimulatedMotion& motion) {
  Feeling feeling;
  const Settings& last = last_settings(motion);
  for (const Snapshot& moment : motion.moments) {
    const Settings& settings = settings_at(motion, moment.time_s);
    feeling.sees_move |= settings.wall_point != last.wall_point ||
                         settings.wall_normal_angle != last.wall_normal_angle ||
                         settings.actuated_angle != last.actuated_angle;
    if (!(depth(wall_of(settings), moment.goal) > 0.0)) continue;
    feeling.presses = true;
    const Vector<2> axis = direction_at(settings.actuated_angle);
    const auto force = [&](StrategyId id) { return glm::dot(axis, equilibrium_of(id, settings, moment.goal).force); };
    const double full = force(StrategyId::full);
    feeling.full_N = std::max(feeling.full_N, std::abs(full));
    feeling.naive_N = std::max(feeling.naive_N, std::abs(force(StrategyId::naive) - full));
    feeling.cure_N = std::max(feeling.cure_N, std::abs(force(StrategyId::anisotropic) - full));
  }
  return feeling;
}

std::string words_of(const Feeling& feeling) {
  if (!feeling.presses) return "The hand never goes into the wall, so the strategies do not differ.";
  constexpr double least_N = 0.005;  // 0.01 N is the last digit here
  const double nothing = std::max(least_N, 1e-6 * feeling.full_N);
  const bool has_ghost = feeling.naive_N > nothing;
  const std::string naive =
      has_ghost
          ? fmt::format("N is pulled away by a force that the wall should not have, up to {:.2f} N", feeling.naive_N)
          : "so does N";
  if (feeling.cure_N <= nothing) return fmt::format("Along the actuated direction, A feels like F at rest; {}.", naive);
  return fmt::format(
      "Along the actuated direction, A does not feel like F at rest: its tracking ratio is not the optimal one, and "
      "its force is wrong by up to {:.2f} N. {}.",
      feeling.cure_N, has_ghost ? naive : "N feels like F");
}

std::string caption_of(const FigureRequest& request, const SimulatedMotion& motion) {
  const Feeling feeling = feeling_of(motion);
  std::string caption = "A simulated hand (minimum jerk, tremor at 8 to 12 Hz)";
  if (request.hand) caption = request.hand->is_estimated ? "A recorded hand, its goal estimated," : "A recorded hand";
  caption += " and where it takes the device under each strategy. " + words_of(feeling);
  if (!motion.changes.empty()) {
    caption += fmt::format(" Settings were changed {} while it was recorded, and the same changes are made here{}.",
                           motion.changes.size() == 1 ? "once" : fmt::format("{} times", motion.changes.size()),
                           feeling.sees_move ? "; wall and motor are drawn as they were at the end" : "");
  }
  if (request.hand) {
    for (const std::string& sentence : request.hand->left_out) caption += " " + sentence;
  }
  return caption;
}

// The simulated hand's way, as a scene's keys; what it is made of besides, the scene tells.
std::string aim_comment() {
  const GoalPath aim = simulated_aim();
  std::string points;
  for (const Vector<2>& point : aim.points) {
    points += fmt::format("{}[{:g}, {:g}]", points.empty() ? "" : ", ", mm_per_m * point.x, mm_per_m * point.y);
  }
  return fmt::format("path_mm=[{}] times_s=[{:g}] motion=minimum-jerk duration_s=5; plus a tremor of {:g} mm rms.",
                     points, fmt::join(aim.times, ", "), mm_per_m * Tremor{}.rms);
}

}  // namespace

SimulatedMotion one_hand(const FigureRequest& request) {
  return request.hand ? simulate_hand(*request.hand) : simulate_motion("", simulated_scene());
}

Figure one_hand_figure(const FigureRequest& request) {
  const SimulatedMotion motion = one_hand(request);
  Sheet sheet("One hand, three strategies", 900.0);
  ScenePicture picture = picture_of(motion, "", "");
  picture.has_scale = true;
  constexpr double height = 400.0;
  const Frame frame = frame_for(std::span(&picture, 1), sheet.place_size(height, 2));
  sheet.add_row(height, 2, [&](const Place& place, std::size_t number) {
    return number == 0 ? scene_pane(picture, place, frame.centers.front(), frame.points_per_metre)
                       : chart_on(place, force_chart(motion));
  });
  sheet.add_legend(motion_legend());
  CsvTable table = table_of(std::span(&motion, 1));
  if (!request.hand) table.comments.push_back(aim_comment());
  return sheet.finish(
      caption_of(request, motion),
      request.hand ? provenance_of_hand(request.hand->name) : provenance_of_scene(std::string(figure_6_scene)),
      std::move(table));
}

}  // namespace ghostforce
