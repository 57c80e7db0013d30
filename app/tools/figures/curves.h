// Curves: what closed forms say over a parameter, and what the simulated loop says at some of its values; for charts.
// Pure, any thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/files/csv_table.h"
#include "app/picture/chart.h"
#include "app/tools/figures/sheet.h"
#include "core/settings.h"
#include "core/snapshot.h"

namespace ghostforce {

struct CurvePoint {
  std::string panel;
  std::string series;  // a strategy's name, or what else the curve is of
  bool is_simulated;   // else by closed form
  double x;
  double y;
};

using Curves = std::vector<CurvePoint>;

// `x_name` and `y_name` with their units, as columns.
CsvTable table_of(const Curves& curves, const std::string& x_name, const std::string& y_name);

// The goal of a curve's points, which is none of the scene's: so deep behind the wall's point, along the normal. And
// what a table says of it.
inline constexpr double curve_goal_depth = 0.020;  // d [m]
Vector<2> goal_behind(const Wall<2>& wall);
std::string goal_comment();

// The curve and, as another series without a name, its points.
void add_series(const Curves& curves, std::string_view panel, std::string_view series, const Series& style,
                Chart& chart);

Settings with_ratio(Settings settings, double ratio);

// A strategy's line and shape, and its letter and title as a name.
Series style_of(StrategyId id);

// `count` values from `least` to `greatest`, both included.
std::vector<double> evenly(double least, double greatest, int count);
std::vector<double> evenly_in_ratio(double least, double greatest, int count);

// What the loop has come to, 3.5 s after the goal went straight into the wall and stopped. Throws Failure(bug) where
// the loop is unstable.
Snapshot simulated_equilibrium(const Settings& settings, const Vector<2>& goal);

// --- Force along the motor of the strategies at rest, by (11), (15), (20) and by the simulated loop ---

// The goal is goal_behind() the wall. Forces away from the wall are positive. Closed forms of all strategies at `x`.
void add_closed_forms(const Settings& settings, double x, Curves& curves);

// The simulated loop's force of one strategy at `x`.
void add_simulated(const Settings& settings, StrategyId id, double x, Curves& curves);

// All strategies' curves on the sheet, over `x`, with their legend.
void add_force_chart(const Curves& curves, const Axis& x, Sheet& sheet);

// The curves as a table that says where the goal is and which way a force is positive.
CsvTable force_table(const Curves& curves, const std::string& x_name);

}  // namespace ghostforce
