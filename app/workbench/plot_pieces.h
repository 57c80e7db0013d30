// Pieces that several plots are made of: the house's look for ImPlot, a strategy's curve with its shape on it, and the
// time axis of plots over time. Within an ImGui frame.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <implot.h>

#include "app/picture/plot_history.h"
#include "app/widgets/panel_context.h"

namespace ghostforce {

// Sets ImPlot's style; together with apply_style() of app/widgets/controls.h.
void apply_plot_style(const Theme& theme, float scale);

inline constexpr ImPlotFlags quiet_plot = ImPlotFlags_CanvasOnly | ImPlotFlags_NoFrame;

// The least range that holds both and is no smaller than that, with some room at both ends.
struct PlotRange {
  double least;
  double greatest;
};
PlotRange roomy(double least, double greatest, double smallest);

// A curve through these points, with the strategy's colour and, here and there, its shape: lines of plots have no
// patterns. A NaN leaves a gap. Within a plot.
void draw_strategy_curve(const PanelContext& context, StrategyId id, std::span<const double> x,
                         std::span<const double> y);

// Marks of an axis, as many as have room on so many pixels, in the same words as those of charts. Before what is
// plotted.
void set_up_ticks(ImAxis axis, const PlotRange& range, float length, std::string_view unit);
// With marks and words that are given, as many of the one as of the other.
void set_up_ticks(ImAxis axis, std::span<const double> marks, std::span<const std::string> words);

// An upright line in the accent's colour, across a plot; none where that lies outside. `thickness` in points.
void draw_upright_line(const PanelContext& context, double x, float thickness);

// Where no curve can be.
inline constexpr const char* unknown = "— cannot be known";

// The strategy's shape at a point; hollow for what is predicted, with a bold rim. Within a plot.
void draw_strategy_point(const PanelContext& context, StrategyId id, double x, double y, bool is_hollow);

// Calls visit(id) for all strategies, the active one last, so that it ends up on top.
template <typename Visit>
void for_each_strategy(const PanelContext& context, Visit&& visit) {
  const StrategyId active = context.settings.active;
  for (const Strategy& entry : strategy_catalog()) {
    if (entry.id != active) visit(entry.id);
  }
  visit(active);
}

// --- The time axis: the times in sight, the time under the pointer, the moment that somebody looks back at ---

// Before the plots of a frame: the times in sight follow the newest tick, or hold the moment that is looked back at.
void bring_times_into_sight(const PanelContext& context, const PlotHistory& history);

// Within a plot, before what is plotted. `has_words`: its marks are named.
void set_up_time_axis(PlotView& view, bool has_words, float width);
// The upright axis, which nobody can move.
void set_up_value_axis(double least, double greatest, float height);

// Within a plot, over what is plotted: draws the cursor, and looks back where somebody clicks. Returns the time under
// the pointer, if the pointer is there.
std::optional<double> draw_time_cursor(const PanelContext& context);

// After the plots: the cursor of the next frame, and whether somebody has dragged the times away from the newest.
void keep_times(PlotView& view, const PlotView& before, std::optional<double> cursor_s);

}  // namespace ghostforce
