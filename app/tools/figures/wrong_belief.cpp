#include "app/tools/figures/figures.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "app/files/scene_file.h"
#include "app/tools/figures/sheet.h"
#include "core/belief.h"
#include "core/conventions.h"

namespace ghostforce {
namespace {

constexpr std::string_view belief_scene = "wall45";
constexpr double least_beta = 0.25;
constexpr double greatest_beta = 4.0;
constexpr Vector<2> shown_errors{-2.25, 1.1};

// Told apart by pattern and by what stands at the simulated points, too.
struct WallAngle {
  double degrees;  // from the motor to the normal
  LinePattern pattern;
  Shape shape;
  bool is_hollow;
};
constexpr std::array wall_angles{WallAngle{20.0, {1.5, 4.5, 1.5, 4.5}, Shape::disc, true},
                                 WallAngle{45.0, solid_line, Shape::disc, false},
                                 WallAngle{60.0, {12.0, 4.0, 12.0, 4.0}, Shape::diamond, false},
                                 WallAngle{75.0, {12.0, 3.0, 2.0, 3.0}, Shape::triangle, false}};

std::string name_of(const WallAngle& angle) {
  return fmt::format("{:g}°", angle.degrees);
}

Settings belief_settings(const WallAngle& angle, double beta) {
  Settings settings = load_scene(std::string(belief_scene)).settings;
  settings.wall_normal_angle = settings.actuated_angle + std::numbers::pi - angle.degrees * radians_per_degree;
  settings.stiffnesses.believed_k_u = beta * settings.stiffnesses.k_u;
  return settings;
}

double told_error(const WallAngle& angle, double beta) {
  const Stiffnesses k = belief_settings(angle, beta).stiffnesses;
  const double along_motor = std::cos(angle.degrees * radians_per_degree);
  return error_of_belief(beta, along_motor * along_motor, k.k_r / k.k_u, k.k_t / k.k_c);
}

// Of the ghost force, which has one direction.
double simulated_error(const WallAngle& angle, double beta) {
  const Settings settings = belief_settings(angle, beta);
  const Snapshot rest = simulated_equilibrium(settings, goal_behind(wall_of(settings)));
  const Vector<2> naive = rest.strategies[index_of(StrategyId::naive)].ghost_force;
  const Vector<2> believed = rest.strategies[index_of(StrategyId::anisotropic)].ghost_force;
  return glm::dot(believed, naive) / glm::dot(naive, naive);
}

// So many upright lines that they are an area.
Series near_the_truth() {
  Series band{.name = "belief within 20 % of the truth",
              .colour = mix(paper().background, paper().faint_text, 0.2),
              .points = {},
              .width = 3.0};
  for (const double beta : evenly_in_ratio(0.8, 1.2, 60)) {
    band.points.insert(band.points.end(), {{beta, shown_errors.x}, {beta, shown_errors.y}, Vector<2>(std::nan(""))});
  }
  return band;
}

}  // namespace

Curves errors_of_wrong_beliefs() {
  Curves curves;
  for (const WallAngle& angle : wall_angles) {
    for (const double beta : evenly_in_ratio(least_beta, greatest_beta, 121)) {
      curves.push_back({"", name_of(angle), false, beta, told_error(angle, beta)});
    }
    for (const double beta : evenly_in_ratio(least_beta, greatest_beta, 9)) {
      curves.push_back({"", name_of(angle), true, beta, simulated_error(angle, beta)});
    }
  }
  return curves;
}

Figure wrong_belief_figure(const FigureRequest&) {
  const Curves curves = errors_of_wrong_beliefs();
  Chart chart;
  chart.x = {.title = "believed over true stiffness of the hand",
             .is_logarithmic = true,
             .range = Vector<2>(least_beta, greatest_beta)};
  chart.y = {.title = "error of force and slide, over that of naïve rendering", .range = shown_errors};
  chart.series.push_back(near_the_truth());
  // Over the area, where a reference would lie below it.
  chart.series.push_back({.name = "",
                          .colour = paper().faint_text,
                          .points = {{1.0, shown_errors.x}, {1.0, shown_errors.y}},
                          .pattern = dotted_line,
                          .width = 1.4});
  for (const WallAngle& angle : wall_angles) {
    const Series style{.name = "wall at " + name_of(angle),
                       .colour = paper().strategy[index_of(StrategyId::anisotropic)],
                       .points = {},
                       .pattern = angle.pattern,
                       .shape = angle.shape,
                       .is_hollow = angle.is_hollow};
    add_series(curves, "", name_of(angle), style, chart);
  }
  chart.references = {{1.0, false, "as far off as naïve rendering"}, {-1.0, false, "as far off, the other way"}};
  Sheet sheet("What a wrong belief about the hand costs", 560.0);
  sheet.add_row(400.0, 1, [&](const Place& place, std::size_t) { return chart_on(place, chart); });
  CsvTable table = table_of(curves, "believed_over_true", "error_over_naive");
  table.comments = {
      "One row per wall angle (from the motor to the normal) and belief, in closed form, and at some values simulated.",
      "error_over_naive: ghost force of anisotropic rendering over that of naïve rendering; proxy drifts have the same "
      "ratio. Negative: the other way.",
      goal_comment()};
  return sheet.finish(
      "Angles are from the motor to the wall's normal. Lines: closed form, for any depth. Points: the simulated loop. "
      "A "
      "belief within 20 % leaves less than a quarter of what naïve rendering does wrong. A belief that is too high is "
      "always better than naïve rendering; one of half the truth, too.",
      provenance_of_scene(std::string(belief_scene) + ", wall angle and believed k_u varied"), table);
}

}  // namespace ghostforce
