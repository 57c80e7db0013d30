#include "app/workbench/time_axis.h"

#include "app/workbench/plot_pieces.h"

namespace ghostforce {
namespace {

constexpr ImPlotAxisFlags quiet_axis =
    ImPlotAxisFlags_NoMenus | ImPlotAxisFlags_NoSideSwitch | ImPlotAxisFlags_NoHighlight;

// Whoever drags means the times in sight.
bool is_click() {
  const float threshold = ImGui::GetIO().MouseDragThreshold;
  return ImGui::IsMouseReleased(ImGuiMouseButton_Left) &&
         ImGui::GetIO().MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] < threshold * threshold;
}

void bring_into_sight(double time_s, PlotView& view) {
  const double span = view.span_s();
  const double margin = 0.1 * span;
  if (time_s < view.from_s) view.from_s = time_s - margin;
  if (time_s > view.to_s) view.from_s = time_s + margin - span;
  view.to_s = view.from_s + span;
}

}  // namespace

void bring_times_into_sight(const PanelContext& context, const PlotHistory& history) {
  PlotView& view = context.edited.plots;
  if (view.follows) {
    const double span = view.span_s();
    view.to_s = history.is_empty() ? span : history.newest_s();
    view.from_s = view.to_s - span;
  }
  if (const auto looks_back_to_s = context.session.stage.looks_back_to_s) bring_into_sight(*looks_back_to_s, view);
}

void set_up_time_axis(PlotView& view, bool has_words, float width) {
  ImPlot::SetupAxis(ImAxis_X1, nullptr, quiet_axis | (has_words ? 0 : ImPlotAxisFlags_NoTickLabels));
  ImPlot::SetupAxisLinks(ImAxis_X1, &view.from_s, &view.to_s);
  ImPlot::SetupAxisZoomConstraints(ImAxis_X1, PlotView::shortest_span_s, PlotView::longest_span_s);
  set_up_ticks(ImAxis_X1, {view.from_s, view.to_s}, width - 4.0F * ImGui::GetFontSize(), " s");
}

void set_up_value_axis(double least, double greatest, float height) {
  ImPlot::SetupAxis(ImAxis_Y1, nullptr, quiet_axis | ImPlotAxisFlags_Lock);
  ImPlot::SetupAxisLimits(ImAxis_Y1, least, greatest, ImPlotCond_Always);
  set_up_ticks(ImAxis_Y1, {least, greatest}, height, "");
}

std::optional<double> draw_time_cursor(const PanelContext& context) {
  const std::optional<double>& looks_back_to_s = context.session.stage.looks_back_to_s;
  if (const auto cursor_s = context.session.plots.cursor_s) draw_upright_line(context, *cursor_s, 1.0F);
  if (looks_back_to_s) draw_upright_line(context, *looks_back_to_s, 2.0F);
  if (!ImPlot::IsPlotHovered()) return std::nullopt;
  const double pointer_s = ImPlot::GetPlotMousePos().x;
  if (is_click()) context.apply(LookBackTo{pointer_s});
  return pointer_s;
}

void keep_times(PlotView& view, const PlotView& before, std::optional<double> cursor_s) {
  view.cursor_s = cursor_s;
  // The wheel chooses how long a time is in sight; whoever drags looks at a moment.
  const bool has_moved = view.from_s != before.from_s || view.to_s != before.to_s;
  if (has_moved && ImGui::IsMouseDragging(ImGuiMouseButton_Left)) view.follows = false;
}

}  // namespace ghostforce
