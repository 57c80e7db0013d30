// Force along the motor of the strategies at rest, by (11), (15), (20) and by the simulated loop, as points of curves.
// Pure, any thread.
#pragma once

#include "app/tools/figures/curves.h"
#include "app/tools/figures/sheet.h"

namespace ghostforce {

// The goal is goal_behind() the wall. Forces away from the wall are positive. Closed forms of all strategies at `x`.
void add_closed_forms(const Settings& settings, double x, Curves& curves);

// The simulated loop's force of one strategy at `x`.
void add_simulated(const Settings& settings, StrategyId id, double x, Curves& curves);

// All strategies' curves on the sheet, over `x`, with their legend.
void add_force_chart(const Curves& curves, const Axis& x, Sheet& sheet);

// The curves as a table that says where the goal is and which way a force is positive.
CsvTable force_table(const Curves& curves, const std::string& x_name);

}  // namespace ghostforce
