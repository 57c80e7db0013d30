#include "app/workbench/plot_export.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/files/csv_table.h"
#include "app/files/run.h"
#include "app/picture/chart.h"
#include "app/picture/text.h"
#include "app/state/scene_view.h"
#include "app/workbench/equilibrium_curves.h"
#include "app/workbench/ratio_dial.h"
#include "app/workbench/save_path.h"
#include "core/conventions.h"

namespace ghostforce {
namespace {

constexpr std::size_t every_tick = std::numeric_limits<std::size_t>::max();

// A picture: two charts in a row, as in the drawer [points].
constexpr Vector<2> chart_size{560.0, 340.0};
constexpr std::size_t charts_in_a_row = 2;
constexpr double picture_density = 2.0;
// Points of a curve over one setting.
constexpr std::size_t curve_points = 361;
constexpr auto picture_columns = static_cast<std::size_t>(chart_size.x * picture_density);

// One subject of the plots, both ways.
struct Export {
  CsvTable table;
  std::vector<Chart> charts;
};

Series series_of(StrategyId id, const Theme& theme) {
  const std::size_t i = index_of(id);
  Series series;
  series.name = strategy(id).title;
  series.colour = theme.strategy[i];
  series.pattern = strategy_style(id).pattern;
  return series;
}

// What is small shall look small, as on the screen.
const Reference zero{0.0, false, ""};

// Empty where nobody knows.
CsvCell cell_of(double value) {
  return std::isnan(value) ? CsvCell(std::string()) : CsvCell(value);
}

Export over_time(const PlotHistory& history, double from_s, double to_s, const Theme& theme) {
  Export result;
  result.table.columns = {"t_s", "strategy"};
  for (const Quantity& quantity : quantity_catalog()) result.table.columns.emplace_back(quantity.column);
  for (const PlotBucket& tick : history.between(from_s, to_s, every_tick)) {
    for (const Strategy& entry : strategy_catalog()) {
      std::vector<CsvCell> row{tick.from_s, std::string(entry.name)};
      for (std::size_t q = 0; q < quantity_count; ++q) {
        row.push_back(cell_of(tick.least[q][index_of(entry.id)]));
      }
      result.table.rows.push_back(std::move(row));
    }
  }
  const std::vector<PlotBucket> buckets = history.between(from_s, to_s, picture_columns);
  for (std::size_t q = 0; q < quantity_count; ++q) {
    const Quantity& quantity = quantity_catalog()[q];
    Chart chart;
    chart.title = glossary(quantity.term).title;
    chart.x.title = "time [s]";
    chart.x.range = Vector<2>(from_s, to_s);
    chart.y.title = fmt::format("{} [{}]", quantity.title, quantity.unit);
    chart.references.push_back(zero);
    for (const Strategy& entry : strategy_catalog()) {
      Series series = series_of(entry.id, theme);
      for (const PlotBucket& bucket : buckets) {
        const std::size_t i = index_of(entry.id);
        const double middle = 0.5 * (bucket.from_s + bucket.to_s);
        series.points.emplace_back(middle, bucket.least[q][i]);
        if (bucket.greatest[q][i] > bucket.least[q][i]) series.points.emplace_back(middle, bucket.greatest[q][i]);
      }
      chart.series.push_back(std::move(series));
    }
    result.charts.push_back(std::move(chart));
  }
  return result;
}

// A series over time of what each point has of it.
template <typename Value>
Series hand_series(std::string name, Colour colour, const std::vector<HandPoint>& points, const Value& value) {
  Series series;
  series.name = std::move(name);
  series.colour = colour;
  for (const HandPoint& point : points) {
    const std::optional<double> at = value(point);
    series.points.emplace_back(point.time_s, at.value_or(std::numeric_limits<double>::quiet_NaN()));
  }
  return series;
}

Export hand_over_time(const HandHistory& history, double from_s, double to_s, const Theme& theme) {
  Export result;
  result.table.columns = {"t_s",   "k_u_live_N_per_m", "sigma_N_per_m",        "mass_kg",          "damping_N_s_per_m",
                          "known", "reason",           "k_u_believed_N_per_m", "k_u_given_N_per_m"};
  const std::vector<HandPoint> points = history.between(from_s, to_s);
  for (const HandPoint& point : points) {
    if (point.time_s < from_s || point.time_s > to_s) continue;
    const HandEstimate& hand = point.estimate;
    const auto number = [&](double value) { return hand.has_number() ? CsvCell(value) : CsvCell(std::string()); };
    result.table.rows.push_back({point.time_s, number(hand.k_u), number(hand.sigma), number(hand.mass),
                                 number(hand.damping), hand.is_known() ? 1.0 : 0.0, std::string(sentence_of(hand.why)),
                                 point.believed_k_u,
                                 point.given_k_u ? CsvCell(*point.given_k_u) : CsvCell(std::string())});
  }
  // So many deviations from the estimate, where that is known.
  const auto live = [](double deviations) {
    return [deviations](const HandPoint& point) {
      const HandEstimate& hand = point.estimate;
      return hand.is_known() ? std::optional(hand.k_u + deviations * hand.sigma) : std::nullopt;
    };
  };
  Chart chart;
  chart.title = "Stiffness of the hand";
  chart.x.title = "time [s]";
  chart.x.range = Vector<2>(from_s, to_s);
  chart.y.title = "kᵤ [N/m]";
  chart.references.push_back(zero);
  for (const double deviations : {-1.0, 1.0}) {
    Series edge =
        hand_series(deviations < 0.0 ? "± one standard deviation" : "", theme.accent, points, live(deviations));
    edge.width = 0.8;
    chart.series.push_back(std::move(edge));
  }
  Series estimate = hand_series("measured live", theme.accent, points, live(0.0));
  estimate.width = 2.6;
  chart.series.push_back(std::move(estimate));
  Series given = hand_series("given", theme.text, points, [](const HandPoint& point) { return point.given_k_u; });
  given.pattern = dotted_line;
  chart.series.push_back(std::move(given));
  Series believed = hand_series("believed", theme.strategy_text[index_of(StrategyId::anisotropic)], points,
                                [](const HandPoint& point) { return std::optional(point.believed_k_u); });
  believed.pattern = {11.0, 6.0, 11.0, 6.0};
  chart.series.push_back(std::move(believed));
  result.charts.push_back(std::move(chart));
  return result;
}

// What is swept, as the table and the charts name it.
struct SweptSetting {
  std::string column;
  std::string title;
  bool is_logarithmic;
  double per_si;
  double now;             // in the column's unit
  std::string condition;  // what is held fixed; may be empty
};

Export over_setting(const EquilibriumCurves& curves, const SweptSetting& setting, bool goal_is_inferred,
                    const Theme& theme) {
  Export result;
  result.table.columns = {setting.column, "strategy", "force_along_motor_axis_N", "proxy_drift_along_wall_mm"};
  if (!setting.condition.empty()) result.table.comments.push_back(setting.condition);
  const auto chart_of = [&](std::string title, std::string quantity) {
    Chart chart;
    chart.title = std::move(title);
    chart.x.title = setting.title;
    chart.x.is_logarithmic = setting.is_logarithmic;
    chart.x.range = Vector<2>(curves.at.front(), curves.at.back()) * setting.per_si;
    chart.y.title = std::move(quantity);
    chart.references = {zero, {setting.now, true, "now"}};
    return chart;
  };
  const std::string condition = setting.condition.empty() ? "" : ", " + setting.condition;
  Chart force = chart_of((goal_is_inferred ? "Force at rest, for the estimated goal" : "Force at rest") + condition,
                         "force along the actuated direction [N]");
  Chart drift = chart_of("Proxy drift at rest" + condition, "drift along the wall [mm]");
  for (const Strategy& entry : strategy_catalog()) {
    Series forces = series_of(entry.id, theme);
    Series drifts = forces;
    for (std::size_t k = 0; k < curves.at.size(); ++k) {
      const EquilibriumValue& value = curves.values[index_of(entry.id)][k];
      const double at = curves.at[k] * setting.per_si;
      result.table.rows.push_back({at, std::string(entry.name), value.force, cell_of(mm_per_m * value.drift)});
      forces.points.emplace_back(at, value.force);
      drifts.points.emplace_back(at, mm_per_m * value.drift);
    }
    force.series.push_back(std::move(forces));
    drift.series.push_back(std::move(drifts));
  }
  result.charts = {std::move(force), std::move(drift)};
  return result;
}

Export export_of(const Session& session, const ShownMoment& moment, const History& history, bool whole_history) {
  const Theme& theme = shown_theme(session);
  const Settings& settings = moment.settings;
  const EquilibriumQuestion question = equilibrium_question(settings, moment.snapshot);
  const double from_s = whole_history ? history.plots().oldest_s() : session.plots.from_s;
  const double to_s = whole_history ? history.plots().newest_s() : session.plots.to_s;
  switch (session.plots.tab) {
    case PlotTab::time:
      return over_time(history.plots(), from_s, to_s, theme);
    case PlotTab::hand:
      return hand_over_time(history.hand(), from_s, to_s, theme);
    case PlotTab::wall_angle: {
      const double turn = std::floor(settings.wall_normal_angle / (360.0 * radians_per_degree));
      return over_setting(
          equilibria_over_wall_angle(question, curve_points),
          {.column = "wall_normal_deg",
           .title = "angle of the wall's normal [°]",
           .is_logarithmic = false,
           .per_si = degrees_per_radian,
           .now = settings.wall_normal_angle / radians_per_degree - 360.0 * turn,
           .condition = fmt::format("goal at a depth of {} mm",
                                    decimal_text(mm_per_m * depth(wall_of(settings), question.goal), 1))},
          question.goal_is_inferred, theme);
    }
    case PlotTab::ratio: {
      const RatioRange range = ratio_range(settings.stiffnesses);
      return over_setting(equilibria_over_ratio(question, range.least, range.greatest, curve_points),
                          {.column = "tracking_ratio",
                           .title = "tracking ratio ρ",
                           .is_logarithmic = true,
                           .per_si = 1.0,
                           .now = tracking_ratio(settings.stiffnesses),
                           .condition = {}},
                          question.goal_is_inferred, theme);
    }
  }
  return {};
}

std::string picture_of(const std::vector<Chart>& charts, const Session& session, const std::string& path,
                       const FilePainter& painter) {
  const Theme& theme = shown_theme(session);
  std::vector<Pane> panes;
  for (std::size_t i = 0; i < charts.size(); ++i) {
    const Vector<2> place(static_cast<double>(i % charts_in_a_row), static_cast<double>(i / charts_in_a_row));
    panes.push_back(chart_pane(charts[i], place * chart_size, chart_size, theme, 1.0, painter.measure));
  }
  const auto rows = static_cast<double>((charts.size() + charts_in_a_row - 1) / charts_in_a_row);
  const auto columns = static_cast<double>(std::min(charts.size(), charts_in_a_row));
  const Vector<2> size(columns * chart_size.x, rows * chart_size.y);
  return painter.paint({.panes = panes,
                        .theme = theme,
                        .size = size,
                        .text_scale = theme.thickness,
                        .title = session.scene->title,
                        .density = picture_density},
                       path);
}

}  // namespace

std::string plot_file(const Session& session, const ShownMoment& moment, const History& history,
                      const SavePlots& request, const FilePainter& painter) {
  const Export result = export_of(session, moment, history, request.whole_history);
  constexpr std::array numbers{"csv"};
  if (format_of(request.path, numbers) != nullptr) return provenance(scene_as_seen(session)) + csv_text(result.table);
  return picture_of(result.charts, session, request.path, painter);
}

}  // namespace ghostforce
