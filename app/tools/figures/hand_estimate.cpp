#include "app/tools/figures/figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include <glm/geometric.hpp>

#include "app/files/scene_file.h"
#include "app/tools/figures/sheet.h"
#include "core/belief.h"
#include "core/hand_measurement.h"
#include "core/simulate.h"
#include "core/tremor_and_drift.h"

namespace ghostforce {
namespace {

constexpr std::string_view estimate_scene = "wall45";
constexpr double first_belief = 250.0;                                     // [N/m]
constexpr double stay_s = 6.0;                                             // as long as the hand is as stiff as that
constexpr std::array true_stiffnesses{250.0, 100.0, 250.0, 625.0, 250.0};  // by 0.4 or 2.5 at once [N/m]
constexpr double whole_s = stay_s * true_stiffnesses.size();
constexpr double encoder_step = 60e-6;  // of a Falcon, about [m]
constexpr TremorAndDrift restless{.tremor_rms = 0.0002, .drift_speed = 0.008, .seed = figure_seed};

double true_stiffness(double time_s) {
  const auto stay = static_cast<std::size_t>(time_s / stay_s);
  return true_stiffnesses[std::min(stay, true_stiffnesses.size() - 1)];
}

// Along the motor at rest, with the ratio for that belief; infinite: naïve rendering.
double force_error(Settings settings, double k_u, double believed_k_u) {
  settings.stiffnesses.k_u = k_u;
  settings.stiffnesses.chosen_tracking_ratio = optimal_tracking_ratio(settings.stiffnesses.k_r, believed_k_u);
  const Vector<2> goal = goal_behind(wall_of(settings));
  const Vector<2> axis = direction_at(settings.actuated_angle);
  const double full = glm::dot(axis, equilibrium_of(StrategyId::full, settings, goal).force);
  const double rendered = glm::dot(axis, equilibrium_of(StrategyId::anisotropic, settings, goal).force);
  return std::abs(rendered / full - 1.0);
}

Settings measured_settings() {
  Settings settings = load_scene(std::string(estimate_scene)).settings;
  settings.active = StrategyId::anisotropic;
  settings.encoder_step = encoder_step;
  settings.stiffnesses.believed_k_u = first_belief;
  return settings;
}

}  // namespace

std::vector<MeasuredMoment> hand_measured_live() {
  Settings settings = measured_settings();
  settings.stiffnesses.k_u = true_stiffness(0.0);
  const Vector<2> goal = goal_behind(wall_of(settings));
  const TremorAndDriftMotion tremor_and_drift(restless);
  HandMeasurement measurement(settings.rate);
  BeliefFollower follower(first_belief);
  TickCoefficients<2> coefficients = coefficients_of(settings);
  TickState<2> state = equilibrium_state(settings, goal);
  std::vector<MeasuredMoment> moments;
  while (time_of(state.tick, settings.rate) < whole_s) {
    const double time_s = time_of(state.tick + 1, settings.rate);
    settings.stiffnesses.k_u = true_stiffness(time_s);
    set_user_stiffness(coefficients, settings.stiffnesses.k_u);
    if (!tick_and_measure(settings, coefficients, tremor_and_drift.shaken(goal, time_s), state, measurement)) continue;
    const HandEstimate& estimate = measurement.reading().estimate;
    const double believed = follower.update(estimate, settings.stiffnesses.k_r, least_regret_belief(settings));
    if (believed != settings.stiffnesses.believed_k_u) {
      settings.stiffnesses.believed_k_u = believed;
      coefficients = coefficients_of(settings);
    }
    const double k_u = settings.stiffnesses.k_u;
    moments.push_back({time_s, k_u, estimate, believed, force_error(settings, k_u, believed),
                       force_error(settings, k_u, first_belief),
                       force_error(settings, k_u, std::numeric_limits<double>::infinity())});
  }
  return moments;
}

namespace {

CsvTable table_of(const std::vector<MeasuredMoment>& moments) {
  CsvTable table;
  table.comments = {
      "One row per estimate, ten a second. nan: the hand is unknown.",
      "Errors: of the force along the actuated direction at rest, in closed form, over that of the fully actuated "
      "strategy; live with the belief that follows the estimate, fixed with that of 250 N/m.",
      fmt::format("tone_force_N={:g} encoder_mm={:g} tremor_mm_rms={:g} drift_mm_per_s={:g}: what is not the scene's.",
                  usual_tone_force, 1000.0 * encoder_step, 1000.0 * restless.tremor_rms, 1000.0 * restless.drift_speed),
      goal_comment()};
  table.columns = {"t_s",        "k_u_N_per_m", "estimate_N_per_m", "sigma_N_per_m", "believed_N_per_m",
                   "live_error", "fixed_error", "naive_error"};
  for (const MeasuredMoment& now : moments) {
    const bool is_known = now.estimate.is_known();
    table.rows.push_back({now.time_s, now.k_u, is_known ? now.estimate.k_u : std::nan(""),
                          is_known ? now.estimate.sigma : std::nan(""), now.believed_k_u, now.live_error,
                          now.fixed_error, now.naive_error});
  }
  return table;
}

constexpr Vector<2> shown_stiffnesses{0.0, 800.0};
constexpr Vector<2> shown_errors_percent{0.0, 100.0};
constexpr double per_cent = 100.0;

// The hand's own is a given: a line with steps, in the goal's dark rim.
Chart stiffness_chart(const std::vector<MeasuredMoment>& moments) {
  const Vector<2> gap(std::nan(""));
  const Colour live = paper().strategy[index_of(StrategyId::anisotropic)];
  Series given{.name = "the hand's", .colour = paper().text, .points = {}, .width = 1.6};
  // An upright line for each estimate: side by side they are a band.
  Series band{.name = "± σ", .colour = mix(paper().background, live, 0.35), .points = {}, .width = 3.4};
  Series estimated{.name = "measured live", .colour = live, .points = {}, .width = 2.4};
  Series believed{.name = "believed",
                  .colour = paper().strategy[index_of(StrategyId::naive)],
                  .points = {},
                  .pattern = dotted_line,
                  .width = 2.0};
  for (const MeasuredMoment& now : moments) {
    if (!given.points.empty() && given.points.back().y != now.k_u) {
      given.points.push_back({now.time_s, given.points.back().y});
    }
    given.points.push_back({now.time_s, now.k_u});
    believed.points.push_back({now.time_s, now.believed_k_u});
    const bool is_known = now.estimate.is_known();
    const double k_u = now.estimate.k_u;
    const double sigma = now.estimate.sigma;
    estimated.points.push_back(is_known ? Vector<2>(now.time_s, k_u) : gap);
    if (is_known) band.points.insert(band.points.end(), {{now.time_s, k_u - sigma}, {now.time_s, k_u + sigma}, gap});
  }
  Chart chart;
  chart.title = "Stiffness of the hand";
  chart.x = {.title = "time [s]", .range = Vector<2>(0.0, whole_s)};
  chart.y = {.title = "kᵤ [N/m]", .range = shown_stiffnesses};
  chart.series = {band, given, believed, estimated};
  return chart;
}

Chart error_chart(const std::vector<MeasuredMoment>& moments) {
  Series naive = style_of(StrategyId::naive);
  Series fixed{.name = "", .colour = paper().faint_text, .points = {}, .pattern = dotted_line};
  Series live = style_of(StrategyId::anisotropic);
  for (Series* const series : {&naive, &live}) series->shape.reset();
  for (const MeasuredMoment& now : moments) {
    naive.points.push_back({now.time_s, per_cent * now.naive_error});
    fixed.points.push_back({now.time_s, per_cent * now.fixed_error});
    live.points.push_back({now.time_s, per_cent * now.live_error});
  }
  Chart chart;
  chart.title = "What that does to the force";
  chart.x = {.title = "time [s]", .range = Vector<2>(0.0, whole_s)};
  chart.y = {.title = "error of the force at rest [%]", .range = shown_errors_percent};
  chart.series = {naive, fixed, live};
  return chart;
}

// Below the chart, so that its time stands below the other's.
std::vector<LegendEntry> error_legend() {
  std::vector<LegendEntry> all = strategy_legend();
  LegendEntry live = all[index_of(StrategyId::anisotropic)];
  LegendEntry naive = all[index_of(StrategyId::naive)];
  live.name += ", the belief follows";
  live.shape.reset();
  naive.shape.reset();
  return {naive,
          live,
          {.name = fmt::format("the same, a belief of {:g} N/m", first_belief),
           .colour = paper().faint_text,
           .has_line = true,
           .pattern = dotted_line}};
}

}  // namespace

Figure hand_estimate_figure(const FigureRequest&) {
  const std::vector<MeasuredMoment> moments = hand_measured_live();
  Sheet sheet("The hand, measured live", 760.0);
  sheet.add_row(300.0, 1, [&](const Place& place, std::size_t) { return chart_on(place, stiffness_chart(moments)); });
  sheet.add_row(220.0, 1, [&](const Place& place, std::size_t) { return chart_on(place, error_chart(moments)); });
  sheet.add_legend(error_legend());
  return sheet.finish(
      "Two small tones in the motor's force measure the hand, over the last 2 s at any time, while it holds the handle "
      "20 mm inside a wall at 45° and its stiffness jumps by a factor of 0.4 or 2.5. Where the line is broken the "
      "hand is unknown, and the belief stays. The hand is simulated, with tremor and drift.",
      provenance_of_scene(std::string(estimate_scene) + ", k_u jumps, believed k_u follows"), table_of(moments));
}

}  // namespace ghostforce
